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

# The fish of motion.md: two key drawings, what lies between them, and the film (needs python3 and rsvg-convert).
for key in 1 2; do
  python3 "$here/motion-fish.py" "$key" | "$feltline" fit - -o "$here/motion-fish-$key.svg"
done
keys=("$here/motion-fish-1.svg" "$here/motion-fish-2.svg")
"$feltline" inbetween "${keys[@]}" -o "$scratch/fish-%d.png" --frames 4 --keys --dpi 96 --paper white
{
  echo '<svg xmlns="http://www.w3.org/2000/svg" width="1380" height="660" viewBox="0 0 1380 660">'
  echo '<rect width="1380" height="660" fill="white"/>'
  for n in 1 2 3 4 5 6; do
    x=$((460 * ((n - 1) % 3) + 5)) y=$((330 * ((n - 1) / 3) + 5))
    colour=#c8c8c8 && [[ $n == 1 || $n == 6 ]] && colour=#2060c0
    printf '<image href="fish-%d.png" x="%d" y="%d" width="450" height="320"/>' "$n" "$x" "$y"
    printf '<rect x="%d" y="%d" width="450" height="320" fill="none" stroke="%s" stroke-width="2"/>\n' "$x" "$y" "$colour"
  done
  echo '</svg>'
} >"$scratch/fish.svg"
rsvg-convert "$scratch/fish.svg" -o "$here/motion.png"
"$feltline" inbetween "${keys[@]}" "${keys[0]}" -o "$here/motion-swim.svg" --frames 9 --ease ease-in-out --paper white

# The styles of materials.md.
python3 "$here/styles.py" | "$feltline" render - -o "$here/styles.png" --dpi 120 --paper white

# The pictures of guides.md: a simulated hand plays the scripts.
for picture in guides symmetry; do
  "$feltline" replay "$here/$picture.ndjson" --overlay --dpi 110 -o "$here/$picture.png"
done

# The picture of solids.md.
"$feltline" fit --quiet "$here/../../share/samples/cat.ndjson" -o "$scratch/lines.felt"
"$feltline" inflate "$scratch/lines.felt" --fill-holes --png "$here/solids.png"
"$feltline" replay "$here/solids-edits.ndjson" --on "$scratch/lines.felt" -o "$scratch/edited.felt"
"$feltline" inflate "$scratch/edited.felt" --fill-holes --png "$here/solids-edited.png"

# The window of motion.md: the two fishes as layers of one drawing.
desktop=${FELTLINE_DESKTOP:-$(dirname "$feltline")/feltline-desktop}
mkdir "$scratch/drawings"
"$feltline" replay "$here/motion-window.ndjson" --on "$here/motion-fish-1.svg" --page 141x98 -o "$scratch/drawings/fish.felt"
QT_SCALE_FACTOR=1 "$desktop" --language en --screenshot "$here/motion-window.png" --panel motion --dialog onion \
  --size 1280x820 "$scratch/drawings/fish.felt"
