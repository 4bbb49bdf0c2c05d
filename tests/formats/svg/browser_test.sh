#!/usr/bin/env bash
# browser_test.sh SVG_SUITE SUITE LIST
#
# Checks the files of the suite on which browsers and the suite do not agree (LIST): our drawings must
# agree with Chromium's pictures. SVG_SUITE is the program svg_suite. The files are shown as images of
# their natural size, 200 px, on a screen with 1.5 pixels per px. Exit code 77: Chromium or the suite
# is missing.
set -euo pipefail
svg_suite=$1
suite=${FELT_SVG_SUITE:-$2}
list=$3
if ! command -v chromium >/dev/null || [ ! -d "$suite" ]; then
  echo "skipped: Chromium (package chromium) or the suite ($suite) is missing"
  exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
while read -r name; do
  copy=${name//\//_}
  cp "$suite/$name.svg" "$work/$copy.svg"
  printf '<body style="margin:0"><img src="%s.svg" width="200" height="200" style="display:block">' \
    "$copy" >"$work/$copy.html"
  timeout 120 chromium --headless --no-sandbox --disable-gpu --hide-scrollbars \
    --user-data-dir="$work/profile" --default-background-color=00000000 --window-size=200,200 \
    --force-device-scale-factor=1.5 --screenshot="$work/$copy.png" "file://$work/$copy.html" \
    >/dev/null 2>"$work/log" || tail -n 5 "$work/log" >&2
  [ -s "$work/$copy.png" ] || { echo "Chromium made no picture of $name" >&2; exit 1; }
done <"$list"
"$svg_suite" "$work" --drawings --all
