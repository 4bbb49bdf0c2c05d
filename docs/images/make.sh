#!/usr/bin/env bash
# docs/images/make.sh [FELTLINE]: makes the pictures of README.md again, from the project's own
# sample strokes. FELTLINE is the program, by default that of `./dev build --preset release`.
# detail.png and media.png need rsvg-convert, detail.png and pull.svg python3.
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
python3 "$here/pull.py" "$feltline" "$here/../../src/felt/tools" >"$scratch/pull.svg"
cp "$scratch/pull.svg" "$here/pull.svg"
"$feltline" demo -o "$scratch/demo"
cp "$scratch/demo/sketch.png" "$here/demo.png"
cp "$scratch/demo/forces.png" "$here/forces.png"

# cat_with N SURFACE MEDIUM: the cat as the simulated hand draws it with this medium on this surface,
# with its grain, in their usual colours.
cat_with() {
  "$feltline" --quiet replay "$samples/cat.ndjson" --surface "$2" --medium "$3" -o "$scratch/cat$1.felt"
  "$feltline" render "$scratch/cat$1.felt" --grain --page fit --dpi 120 -o "$scratch/cat$1.png"
}
surfaces=(paper rough-paper blackboard)
cat_with 1 "${surfaces[0]}" pencil-soft
cat_with 2 "${surfaces[1]}" charcoal
cat_with 3 "${surfaces[2]}" chalk
{
  echo '<svg xmlns="http://www.w3.org/2000/svg" width="1290" height="500" viewBox="0 0 1290 500">'
  for n in 1 2 3; do
    paper=$("$feltline" materials show "${surfaces[n - 1]}" | sed -n 's/^color = "\(#[0-9a-f]*\)".*/\1/p')
    printf '<rect x="%d" width="420" height="500" fill="%s"/>' $((435 * n - 435)) "$paper"
    printf '<image href="cat%d.png" x="%d" y="10" width="400" height="480"/>\n' "$n" $((435 * n - 425))
  done
  echo '</svg>'
} >"$scratch/media.svg"
rsvg-convert "$scratch/media.svg" -o "$here/media.png"
