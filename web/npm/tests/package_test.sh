#!/usr/bin/env bash
# package_test.sh TOPIC PACKAGE.tgz FELTLINE ROOT: installs the packed package into an empty project, without
# a network, and tests it there. Exit status 77: a program is missing.
set -euo pipefail
readonly topic=$1 tgz=$2 feltline=$3 root=$4
readonly here=$root/web/npm/tests

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
echo '{"name": "empty", "private": true}' >package.json
npm install --offline --no-audit --no-fund --silent "$tgz"
cp "$here"/*.{mjs,cjs,ts} .

skip_without() { command -v "$1" >/dev/null || { echo "skipped: $1 is not installed (./dev setup web)"; exit 77; }; }

case $topic in
  use) node use.mjs && node use.cjs && node worker.mjs ;;
  input) node input.mjs ;;
  memory) node memory.mjs ;;
  size)
    for name in feltline.mjs feltline.cjs; do
      bytes=$(gzip -9c "node_modules/feltline/dist/$name" | wc -c)
      echo "$name: $bytes bytes with gzip -9"
      [ "$bytes" -le 60000 ] || { echo "more than 60,000 bytes"; exit 1; }
    done ;;
  same_bytes)
    shared=${FELT_SHARED_DATA:-$root/../shared/data/pen-strokes-a.ndjson}
    for file in "$root"/share/samples/*.ndjson "$shared"; do
      [ -r "$file" ] || { echo "without $file, which is not there"; continue; }
      for refine in "" --no-refine; do
        # Samples with tilt and events are not raw strokes, so errors of single lines are allowed.
        "$feltline" fit "$file" $refine -o native.ndjson 2>errors.txt || [ -s native.ndjson ]
        node same_bytes.mjs "$file" native.ndjson "$refine"
      done
    done ;;
  types)
    skip_without tsc
    tsc --noEmit --strict --target es2022 --lib es2022,dom --module node16 --moduleResolution node16 types.ts ;;
  browser)
    skip_without chromium
    # One file without a server: the module is part of it.
    {
      echo '<!doctype html><title>waiting</title><pre id="out">waiting</pre><script type="module">'
      sed -E 's/export ?\{([^}]*)\};?$/const feltline={\1};/' node_modules/feltline/dist/feltline.mjs |
        sed -E '/const feltline=/{s/([A-Za-z0-9_$]+) as ([A-Za-z0-9_$]+)/\2:\1/g}'
      cat browser.mjs
      echo '</script>'
    } >page.html
    chromium --headless --no-sandbox --disable-gpu --user-data-dir="$folder/profile" \
      --virtual-time-budget=5000 --dump-dom "file://$folder/page.html" 2>chromium.log >dom.html ||
      { tail chromium.log; exit 1; }
    grep -o '<pre id="out">[^<]*' dom.html
    grep -q '<pre id="out">passed' dom.html ;;
  *) echo "no topic $topic"; exit 2 ;;
esac
