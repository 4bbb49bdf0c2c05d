#!/usr/bin/env bash
# build.sh VERSION FOLDER: builds the npm package into FOLDER/package and packs it as
# FOLDER/feltline-VERSION.tgz. Called by `./dev npm`, which installs what this needs.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")"

readonly version=$1 folder=$2 felt=../../src/felt
readonly objects=$folder/objects package=$folder/package

# What the package needs of the library, as units that are compiled as one file each. Names are unique within a
# layer, so the sources of a layer fit into one unit.
units=(
  "base/result.cc geometry/cubic.cc geometry/cubic_length.cc geometry/nearest.cc geometry/polyline.cc
   geometry/roots.cc"
  "stroke/arc_map.cc stroke/drawn_profile.cc stroke/profile_builder.cc stroke/stroke.cc
   stroke/stroke_invariants.cc stroke/width_profile.cc stroke/fit/corner_detector.cc
   stroke/fit/curve_fitter.cc stroke/fit/guide_curve.cc stroke/fit/ink_fitter.cc stroke/fit/kept_samples.cc
   stroke/fit/long_run.cc stroke/fit/normal_equations.cc stroke/fit/pen_filter.cc stroke/fit/refine.cc
   stroke/fit/run_moments.cc stroke/fit/run_search.cc stroke/fit/sample_faults.cc stroke/fit/sample_window.cc
   stroke/fit/segment_fit.cc stroke/fit/segment_fit_kernels.cc stroke/fit/width_fitter.cc stroke/fit/width_map.cc
   stroke/edit/mend_joints.cc stroke/edit/split.cc stroke/outline/envelope.cc stroke/outline/outline.cc
   stroke/outline/outline_path.cc stroke/outline/side_stretch.cc"
  "feltline.cc pen_look.cc small_library.cc"
)

# -Oz and -flto for size; emscripten adds -fno-inline-functions, which makes the module larger. The
# WebAssembly features are those of Safari 16.4 (2023) and all newer browsers. SIMD makes the fitter faster
# and the module smaller, and the results are the same.
flags=(-std=c++20 -Oz -finline-functions -flto -DNDEBUG -fno-exceptions -fno-rtti -ffp-contract=off
  -fvisibility=hidden -msimd128 -mbulk-memory -mnontrapping-fptoint -msign-ext)

# Compiles the units whose sources, or any header, changed since the last build.
compile() {
  local i source unit
  mkdir -p "$objects/include"
  # The header of libexpected-dev alone, because the other system headers are not for emscripten.
  cp -r /usr/include/tl "$objects/include/"
  for i in "${!units[@]}"; do
    unit=$objects/unit$i
    [ ! -e "$unit.o" ] || [ -n "$(find . "$felt"/{base,geometry,stroke} \( -name '*.h' -o -name '*.cc' -o \
      -name build.sh \) ! -name '*_test.cc' -newer "$unit.o" -print -quit)" ] || continue
    for source in ${units[i]}; do
      [[ $source == */* ]] && source=felt/$source
      echo "#include \"$source\""
    done >"$unit.cc"
    em++ "${flags[@]}" -I../../src -I. -isystem "$objects/include" -c "$unit.cc" -o "$unit.o"
  done
}

link() {
  # small_library.cc says which function is undefined here: JavaScript provides it.
  em++ "${flags[@]}" "$objects"/unit?.o -o "$folder/linked.wasm" --no-entry -sSTANDALONE_WASM \
    -sALLOW_MEMORY_GROWTH -sINITIAL_MEMORY=1MB -sTOTAL_STACK=128KB -sMAXIMUM_MEMORY=2GB -sMALLOC=emmalloc \
    -sERROR_ON_UNDEFINED_SYMBOLS=0 -sWARN_ON_UNDEFINED_SYMBOLS=0
  cp "$folder/linked.wasm" "$package/dist/feltline.wasm"
  chmod 644 "$package/dist/feltline.wasm"
}

# bundle NAME SOURCE: makes dist/NAME.mjs and dist/NAME.cjs with their types.
bundle() {
  # What import.meta.url is in CommonJS. The form for browsers names no module of Node, which bundlers cannot resolve.
  local location='const moduleUrl=globalThis.document?.baseURI??globalThis.location?.href??"file:///";'
  [ "$1" != slim_node ] || location='const moduleUrl=require("node:url").pathToFileURL(__filename).href;'
  local options=(--bundle --minify --target=es2022 --log-level=warning --external:node:*)
  esbuild "$folder/src/$2" "${options[@]}" --format=esm --outfile="$package/dist/$1.mjs"
  [[ $1 == slim* ]] || location=
  esbuild "$folder/src/$2" "${options[@]}" --format=cjs --define:import.meta.url=moduleUrl \
    --banner:js="$location" --outfile="$package/dist/$1.cjs"
  [ "$1" != slim_node ] || return 0
  cp index.d.ts "$package/dist/$1.d.mts"
  cp index.d.ts "$package/dist/$1.d.cts"
}

pack() {
  sed "s/@VERSION@/$version/" package.json.in >"$package/package.json"
  cp README.md ../../LICENSE examples.html "$package/"
  (cd "$package" && npm pack --silent --pack-destination ..) >/dev/null
}

mkdir -p "$objects" "$package/dist"
compile
link
rm -rf "$folder/src"
cp -r src "$folder/src"
node embed.mjs "$package/dist/feltline.wasm" "$folder/src/module_text.js"
bundle feltline inlined.js
bundle slim slim.js
bundle slim_node slim_node.js
pack
for file in feltline.mjs feltline.cjs slim.mjs feltline.wasm; do
  printf '%-14s %7d bytes, %6d with gzip -9\n' "$file" "$(wc -c <"$package/dist/$file")" \
    "$(gzip -9c "$package/dist/$file" | wc -c)"
done
