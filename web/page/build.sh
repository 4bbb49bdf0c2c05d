#!/usr/bin/env bash
# build.sh OBJECTS DIST: compiles the core of the page to WebAssembly in OBJECTS, and bundles the page into DIST.
# Called by `./dev web`, which installs what this needs. Unchanged sources are not compiled again.
set -euo pipefail
shopt -s nullglob
mkdir -p "$1" "$2"
objects=$(cd "$1" && pwd) dist=$(cd "$2" && pwd)
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")"
root=$(cd ../.. && pwd)

./debian_sources.sh "$objects/debian" simdjson pugixml sqlite3
sqlite=$objects/debian/sqlite3
if [ ! -e "$sqlite/sqlite3.c" ]; then  # Debian has the sources from which this file is made
  (cd "$sqlite" && ./configure --quiet --disable-tcl --disable-readline && make sqlite3.c) >"$objects/sqlite.log" 2>&1 || {
    cat "$objects/sqlite.log" >&2
    exit 1
  }
fi

# The system's headers of libraries that are templates only; the other system headers are not for emscripten.
include=$objects/include
mkdir -p "$include"
cp -ru /usr/include/tl /usr/include/agg2 /usr/include/toml++ "$include/"
cp -u "$objects/debian/simdjson/singleheader/simdjson.h" "$objects/debian/pugixml/src/"*.hpp "$sqlite/sqlite3.h" "$include/"

# Units of at most 16 sources of a layer, because a compiler that starts seldom is faster. Names are unique within a
# layer. -Oz and -flto for size; emscripten adds -fno-inline-functions, which makes the module a quarter larger. The fitter
# takes half the time with -O2. Sources for files, threads and real devices are left out.
layers="base geometry material sound stroke gather recognise document fill haptics rt tools session render io
  devices/simulated store formats replay"
left_out='_(test|bench)\.cc$|/testing/|/make_[a-z_]*\.cc$|/samples/|/base/(check|atomic_file|file_steps|same_file|standard_streams|read_file)\.cc
/material/material_library\.cc|/rt/(realtime_thread|abandon)\.cc|/render/(plot|plot_axis|plot_canvas|plot_trace)\.cc
/store/(database|felt_salvage|page_scan)\.cc|/io/(unpack|gpl_palette)\.cc|/io/(picture|quickdraw)/|/io/svg/svg_picture_files\.cc
/replay/(forces_csv|live_loop|real_device|record_copy|record_run|replay_drawing|apply_recording|script_run)\.cc'
left_out=$(tr '\n' '|' <<<"$left_out" | sed 's/|*$//')

# Sources that only the full module links. In the first module, a call of one of their functions ends the core.
only_full='/tools/all_tools\.cc|/fill/|/store/|/render/picture_pixels\.cc|/io/svg/svg_pictures\.cc|/material/(toml_entries|custom_relief|relief|material_writer)\.cc
/session/(selection_edit|group_edit|guide_edit|symmetry_edit|timing_edit)\.cc|/document/body_edit\.cc
/io/events/(body_fields|timing_fields)\.cc|/render/(style_layout|style_pen|style_spine|styled_outline)\.cc'
only_full=$(tr '\n' '|' <<<"$only_full" | sed 's/|*$//')

# units LAYER NAME: writes units with the sources of the input, and the lines that compile them.
units() {
  local number=0 unit='' source
  while read -r source; do
    if [ $((number % 16)) = 0 ]; then
      unit=$objects/units/$2_$((number / 16))
      echo "build $unit.o: compile $unit.cc"
      [ "$1" != stroke ] || echo "  speed = -O2"
      : >"$unit.new"
    fi
    echo "#include \"${source#"$root/src/"}\"" >>"$unit.new"
    number=$((number + 1))
  done
}

write_ninja() {
  local layer unit source
  cat <<END
paths = -I$root/src -I$root/apps -I$root -I$root/web/page/core/libcxx -I$root/web/page/core/pictures -isystem $include
flags = -std=c++20 -fno-exceptions -fno-rtti -DNDEBUG -DPUGIXML_NO_EXCEPTIONS -ffp-contract=off -fvisibility=hidden $
  -flto -finline-functions -msimd128 -mbulk-memory -mnontrapping-fptoint -msign-ext ${FELT_PAGE_FLAGS:-}
speed = -Oz
# SECURE_DELETE as in Debian's SQLite, so that the same drawing gives the same bytes.
sqlite = -DSQLITE_OS_OTHER=1 -DSQLITE_THREADSAFE=0 -DSQLITE_SECURE_DELETE -DSQLITE_TEMP_STORE=3 -DSQLITE_DEFAULT_MEMSTATUS=0 $
  -DSQLITE_OMIT_LOAD_EXTENSION -DSQLITE_OMIT_LOCALTIME -DSQLITE_OMIT_DEPRECATED -DNDEBUG
rule compile_c
  command = emcc \$sqlite -flto -mbulk-memory -mnontrapping-fptoint -msign-ext \$speed -c \$in -o \$out
  description = \$out
rule compile
  command = em++ \$flags \$speed \$paths -MMD -MF \$out.d -c \$in -o \$out
  depfile = \$out.d
  deps = gcc
  description = \$out
END
  for layer in $layers; do
    find "$root/src/felt/$layer" -name '*.cc' | grep -vE "$left_out" | LC_ALL=C sort >"$objects/sources"
    units "$layer" "${layer//\//_}" < <(grep -vE "$only_full" "$objects/sources")
    units "$layer" "full_${layer//\//_}" < <(grep -E "$only_full" "$objects/sources")
  done
  echo "build $objects/units/own_sqlite.o: compile_c $sqlite/sqlite3.c"
  echo "build $objects/units/own_sqlite_database.o: compile $root/src/felt/store/database.cc"
  for source in "$root"/web/page/core/{,database/,libcxx/,pictures/}*.cc "$objects"/units/built_in_texts.cc \
    "$root/src/felt/driver/device_models.cc" \
    "$objects/debian/simdjson/singleheader/simdjson.cpp" "$objects/debian/pugixml/src/pugixml.cpp"; do
    unit=$(basename "$source")
    echo "build $objects/units/own_${unit%.*}.o: compile $source"
  done
}

# The materials, as CMake makes them.
built_in_texts() {
  local file
  echo '#include <array>'
  echo '#include "felt/material/material_library.h"'
  echo 'namespace felt { namespace {'
  echo 'constexpr BuiltInText kTexts[] = {'
  for file in $(sed -n '/^foreach(material_file/,/)$/p' "$root/src/felt/CMakeLists.txt" |
    grep -oE '(surfaces|media)/[a-z-]+'); do
    printf '{"%s", R"felt(%s\n)felt"},\n' "${file#*/}" "$(sed '/^#/d; s/  # [^"]*$//' "$root/share/materials/$file.toml")"
  done
  echo '};'
  echo '}  std::span<const BuiltInText> built_in_texts() noexcept { return kTexts; } }'
}

update() { cmp -s "$1" "$2" || mv "$1" "$2"; }

mkdir -p "$objects/units"
built_in_texts >"$objects/units/built_in_texts.new"
update "$objects/units/built_in_texts.new" "$objects/units/built_in_texts.cc"
write_ninja >"$objects/build.new"
for new in "$objects"/units/*.new; do
  [ ! -e "$new" ] || update "$new" "${new%.new}.cc"
done
update "$objects/build.new" "$objects/build.ninja"
# The compiler cache of CMake, if one is set.
export EM_COMPILER_WRAPPER=${EM_COMPILER_WRAPPER:-${CMAKE_CXX_COMPILER_LAUNCHER:-}}
ninja -C "$objects" -j "${JOBS:-2}" ${FELT_PAGE_NINJA:-}

# link OUT LEFT_OUT [ONLY]: links the units that match ONLY, but not LEFT_OUT. Units of removed sources may still be in the
# folder.
link() {
  local objects_of_module=() unit name new=${1%.wasm}_new.wasm
  while read -r unit; do
    name=$(basename "$unit" .o)
    [[ "$name" =~ $2 || ! "$name" =~ ${3:-.} ]] || objects_of_module+=("$unit")
  done < <(sed -n 's/^build \(.*\.o\): compile.*/\1/p' "$objects/build.ninja")
  em++ -Oz -flto "${objects_of_module[@]}" -o "$new" --no-entry -sSTANDALONE_WASM -sALLOW_MEMORY_GROWTH \
    -sINITIAL_MEMORY=16MB -sTOTAL_STACK=1MB -sMAXIMUM_MEMORY=2GB -sMALLOC=emmalloc -sFILESYSTEM=0 \
    -sERROR_ON_UNDEFINED_SYMBOLS=0 -sWARN_ON_UNDEFINED_SYMBOLS=0 ${FELT_PAGE_LINK:-}
  mv "$new" "$1"
}

# build.ninja is newer if a source was added or removed.
is_older() {
  [ ! -e "$1" ] || [ -n "$(find "$objects/build.ninja" "$objects/units" -name '*.o' -newer "$1" -print -quit -o \
    -name build.ninja -newer "$1" -print -quit)" ]
}

mkdir -p "$objects/generated"
felt='own_(sqlite|sqlite_database|database_module|no_files)$'
! is_older "$objects/first.wasm" || link "$objects/first.wasm" "^full_|^own_(api_full|full|simdjson|pugixml|database|png)$|^$felt"
! is_older "$objects/full.wasm" || link "$objects/full.wasm" "^own_first|^$felt"
! is_older "$objects/felt.wasm" || link "$objects/felt.wasm" '^$' "^(base|full_store)_|^own_(charconv|numbers_text)|^$felt"
em++ -std=c++20 -O2 -fno-exceptions -fno-rtti core/unpack/unpack.cc -o "$objects/unpack.wasm" --no-entry -sSTANDALONE_WASM \
  -sALLOW_MEMORY_GROWTH -sINITIAL_MEMORY=1MB -sTOTAL_STACK=16KB -sMAXIMUM_MEMORY=64MB -sMALLOC=none -sFILESYSTEM=0
echo "export const text = '$(base64 -w0 "$objects/unpack.wasm")';" >"$objects/generated/unpack_text.js"
node core/pack.mjs "$objects/first.wasm" "$objects/generated/module_text.js"
node core/pack.mjs "$objects/full.wasm" "$objects/generated/full_text.js"
node core/pack.mjs "$objects/felt.wasm" "$objects/generated/felt_text.js"
node make_words.mjs "$root/apps/desktop/translations" "$objects/generated/sentences.js" \
  ImportWords AddedStrokes felt::desktop::NoticeBar felt::desktop::Studio
node core/make_extras.mjs "$root" "$objects/full.wasm" "$objects/generated"
options=(--bundle --minify "--target=es2022,safari16.4" --log-level=warning --format=iife)
NODE_PATH=$objects esbuild core/core.js "${options[@]}" --global-name=feltlineCore --outfile="$dist/core.js"
esbuild "$objects/generated/full_and_cat.js" "${options[@]}" --global-name=feltlineFull --outfile="$dist/core_full.js"
esbuild "$objects/generated/felt_text.js" "${options[@]}" --global-name=feltlineFelt --outfile="$dist/core_felt.js"
for file in "$objects"/{first,full,felt}.wasm "$dist"/core{,_full,_felt}.js; do
  printf '%-12s %8d bytes, %7d with gzip -9\n' "$(basename "$file")" "$(wc -c <"$file")" "$(gzip -9c "$file" | wc -c)"
done
