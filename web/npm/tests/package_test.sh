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
  growing) node growing.mjs ;;
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
  bundlers)
    # The packed package, as programs for browsers bundle it. The bundlers are installed by ./dev test -L web.
    bundlers=$root/build/web/bundlers/node_modules
    cat >entry.mjs <<'END'
import { fitStroke as slimFit, init } from 'feltline/slim';
import { fitStroke } from 'feltline';
globalThis.run = async (wasm) => {
  await init(WebAssembly.compile(wasm));
  return JSON.stringify([slimFit([[0, 0], [10, 5], [20, 0]]), fitStroke([[0, 0], [10, 5], [20, 0]])]);
};
END
    cat >entry.cjs <<'END'
const { fitStroke: slimFit, init } = require('feltline/slim');
const { fitStroke } = require('feltline');
END
    sed '/^import/d' entry.mjs >>entry.cjs
    cat >check.mjs <<'END'
import { readFileSync } from 'node:fs';
// What webpack asks a browser for.
Object.assign(globalThis, { self: globalThis, document: { baseURI: 'http://localhost/' } });
await import(process.argv[2]);
const [slim, whole] = JSON.parse(await run(readFileSync('node_modules/feltline/dist/feltline.wasm')));
if (JSON.stringify(slim) !== JSON.stringify(whole) || !slim.d.startsWith('M0 0C')) throw new Error('differs');
END
    tried=0
    tried_with() { echo "$1"; node check.mjs "./out/$2"; tried=$((tried + 1)); }
    if command -v esbuild >/dev/null; then
      for entry in entry.mjs entry.cjs; do
        esbuild "$entry" --bundle --platform=browser --format=esm --log-level=warning --outfile="out/esbuild.$entry.mjs"
        if grep -q 'node:' "out/esbuild.$entry.mjs"; then echo "the bundle names a module of Node"; exit 1; fi
        tried_with "esbuild $entry" "esbuild.$entry.mjs"
      done
    fi
    if [ -d "$bundlers/webpack" ]; then
      cat >webpack.mjs <<END
import webpack from '$bundlers/webpack/lib/index.js';
webpack({ mode: 'production', target: 'web', entry: './' + process.argv[2], context: '$folder',
          output: { path: '$folder/out', filename: \`webpack.\${process.argv[2]}.js\`, publicPath: './' } },
        (error, stats) => { if (error || stats.hasErrors() || stats.hasWarnings()) {
          console.error(error ?? stats.toString()); process.exit(1); } });
END
      for entry in entry.mjs entry.cjs; do
        node webpack.mjs "$entry"
        tried_with "webpack $entry" "webpack.$entry.js"
      done
    fi
    if [ -d "$bundlers/vite" ]; then
      cat >vite.mjs <<END
import { build } from '$bundlers/vite/dist/node/index.js';
await build({ root: '$folder', logLevel: 'warn', configFile: false, build: { outDir: 'out', emptyOutDir: false,
  lib: { entry: 'entry.mjs', formats: ['es'], fileName: () => 'vite.mjs' } } });
END
      node vite.mjs
      tried_with vite vite.mjs
    fi
    if [ -d "$bundlers/rollup" ]; then
      cat >rollup.mjs <<END
import { rollup } from '$bundlers/rollup/dist/es/rollup.js';
import resolve from '$bundlers/@rollup/plugin-node-resolve/dist/es/index.js';
const bundle = await rollup({ input: 'entry.mjs', plugins: [resolve({ browser: true })],
                              onwarn(warning) { throw new Error(warning.message); } });
await bundle.write({ file: 'out/rollup.mjs', format: 'es' });
END
      node rollup.mjs
      tried_with rollup rollup.mjs
    fi
    [ "$tried" -gt 0 ] || { echo "skipped: no bundler is installed (./dev test -L web)"; exit 77; }
    echo "$tried bundles: passed" ;;
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
