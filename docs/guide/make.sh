#!/usr/bin/env bash
# docs/guide/make.sh [FELTLINE]: makes the pictures of the tour again, from the acts in the tools' folders.
# FELTLINE is the program, by default that of `./dev build --preset release`.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
feltline=$(readlink -f "${1:-$here/../../build/release/bin/feltline}")
readonly here feltline
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

"$feltline" demo -o "$scratch" --size 1200
for act in "$here"/../../src/felt/tools/*/[0-9]*-*.ndjson; do
  cp "$scratch/$(basename "$act" .ndjson).png" "$here/"
done

# The pictures of guides.md: a simulated hand plays the scripts.
for picture in guides symmetry; do
  "$feltline" replay "$here/$picture.ndjson" --overlay --dpi 110 -o "$here/$picture.png"
done

# The picture of solids.md.
"$feltline" fit --quiet "$here/../../share/samples/cat.ndjson" -o "$scratch/lines.felt"
"$feltline" inflate "$scratch/lines.felt" --gap 8 --fill-holes --png "$here/solids.png"
