#!/usr/bin/env bash
# desktop.sh [FOLDER]: makes the pictures of the desktop program for README and metainfo, light and
# dark, by the program itself: no display, nobody's settings. Needs ./dev build --preset release.
set -euo pipefail
root=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../..
out=${1:-$root/docs/images}
program=${FELTLINE_DESKTOP:-$root/build/release/bin/feltline-desktop}
export QT_SCALE_FACTOR=${QT_SCALE_FACTOR:-1}
mkdir -p "$out"

shot() { echo "$1.png"; "$program" --language en --screenshot "$out/$1.png" "${@:2}" 2>/dev/null; }

# A whisker of the cat is being pulled.
pull=(--example cat --script "$root/docs/images/desktop-pull.ndjson" --until-ms 2600 --tool pull --size 1280x800)

shot desktop "${pull[@]}"
shot desktop-dark "${pull[@]}" --theme dark --panel feel --panel forces
shot desktop-keys --dialog shortcuts
shot desktop-tactile --script "$root/docs/images/desktop-tactile.ndjson" --panel tactile --size 1280x800
# Programs that were built without solids (FELT_SOLIDS=0) have no solid view.
if [ "${FELT_SOLIDS:-1}" != 0 ]; then
  shot desktop-solid --example cat --panel solid --size 1280x800
  shot desktop-touch --example cat --panel solid --dialog touch --size 1280x800
fi
shot desktop-ring --example cat --dialog ring --size 1280x800
shot desktop-tour --dialog tour/1
shot desktop-device --dialog preferences/device
shot desktop-materials --dialog materials/rough-paper
