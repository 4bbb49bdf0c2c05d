#!/usr/bin/env bash
# bundle.sh WORK DIST: makes the page from its sources: DIST/index.html (with styles and icons) and DIST/page.js. WORK
# is a folder for generated sources. The icons and translations are those of the desktop program. Called by
# `./dev web`.
set -euo pipefail
mkdir -p "$1" "$2"
work=$(cd "$1" && pwd) dist=$(cd "$2" && pwd)
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")"
root=$(cd ../.. && pwd)

mkdir -p "$work/generated"
node make_words.mjs "$root/apps/desktop/translations" "$work/generated/desktop_words.js"

icons=()
for name in menu undo redo hand sound fit force-plot options layers close new open import save save-as export keyboard \
  info delete duplicate raise lower select-none layer-add layer-remove rename eye eye-off lock unlock \
  group ungroup cut copy paste; do
  icons+=("$root/apps/desktop/panels/icons/$name.svg")
done
node make_icons.mjs "$work/icons.svg" "${icons[@]}" "$root"/src/felt/tools/*/*.svg

options=(--minify "--target=es2022,safari16.4" --log-level=warning)
NODE_PATH=$work esbuild page.js --bundle "${options[@]}" --format=iife --outfile="$dist/page.js"
esbuild early.js "${options[@]}" --format=iife --outfile="$work/early.js"
esbuild style.css --minify --log-level=warning --outfile="$work/style.css"
node make_page.mjs index.html "$work" "$root/share/icons/org.feltline.Feltline.svg" >"$work/index.html"
mv "$work/index.html" "$dist/index.html"
