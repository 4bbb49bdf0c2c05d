#!/usr/bin/env bash
# docs/images/make.sh [FELTLINE]: makes the pictures of README.md again, from the project's own
# sample strokes. FELTLINE is the program, by default that of `./dev build --preset release`.
# detail.png needs python3 and rsvg-convert.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
feltline=$(readlink -f "${1:-$here/../../build/release/bin/feltline}")
readonly here feltline samples=$here/../../share/samples
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

"$feltline" fit "$samples/cat.ndjson" -o "$here/cat.png" --dpi 150
"$feltline" fit "$samples/page.ndjson" -o "$scratch/page.ndjson"
python3 "$here/detail.py" "$samples/page.ndjson" "$scratch/page.ndjson" 82.2 98.4 36.2 17.8 \
  >"$scratch/detail.svg"
rsvg-convert --width 1000 "$scratch/detail.svg" -o "$here/detail.png"
"$feltline" demo -o "$scratch/demo"
cp "$scratch/demo/sketch.png" "$here/demo.png"
cp "$scratch/demo/forces.png" "$here/forces.png"
