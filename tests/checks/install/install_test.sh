#!/usr/bin/env bash
# install_test.sh SOURCE_DIR BUILD_DIR CXX: installs BUILD_DIR into an empty folder, moves that
# folder, and uses the installed files as a user of the library would: by find_package and by
# pkg-config. Also runs the installed program.
set -euo pipefail
source_dir=$1 build_dir=$2 export_cxx=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sample=$source_dir/samples/fit_a_stroke

# quietly COMMAND...: prints the output of the command only if it fails.
quietly() { "$@" >"$work/log" 2>&1 || { echo "FAILED: $*"; cat "$work/log"; exit 1; }; }

quietly cmake --install "$build_dir" --prefix "$work/first"
# The checks below fail if an installed file needs the path of the original folder.
mv "$work/first" "$work/prefix"
prefix=$work/prefix

echo "find_package:"
quietly cmake -S "$sample" -B "$work/sample" -G Ninja "-DCMAKE_PREFIX_PATH=$prefix" \
  "-DCMAKE_CXX_COMPILER=$export_cxx"
quietly cmake --build "$work/sample"
"$work/sample/fit_a_stroke" | tee "$work/by_cmake"
grep -qE '^[0-9]+ samples -> [1-9][0-9]* segments$' "$work/by_cmake"

echo "pkg-config:"
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name feltline.pc)")
export PKG_CONFIG_PATH
# shellcheck disable=SC2046  # flags are separated by blanks
quietly "$export_cxx" -std=c++20 "$sample/fit_a_stroke.cc" $(pkg-config --cflags --libs feltline) \
  -o "$work/by_pkg_config"
"$work/by_pkg_config" | diff - "$work/by_cmake"

# As a part of another project: only the fitter, with a find_package that hides all other libraries.
echo "only the fitter:"
mkdir "$work/part"
cat >"$work/part/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.25)
project(part LANGUAGES CXX)
foreach(hidden PkgConfig PNG pugixml simdjson SQLite3 Threads ZLIB CGAL Qt6 CLI11)
  set(CMAKE_DISABLE_FIND_PACKAGE_\${hidden} ON)
endforeach()
if(AS_PART)
  set(FELT_FITTER_ONLY ON)
  add_subdirectory($source_dir feltline EXCLUDE_FROM_ALL)
  if(TARGET felt_io OR TARGET feltline OR TARGET base_test OR DEFINED CACHE{CMAKE_BUILD_TYPE} AND CMAKE_BUILD_TYPE)
    message(FATAL_ERROR "more than the fitter, or the build type of the project was set")
  endif()
else()
  find_package(feltline 0.1 REQUIRED COMPONENTS stroke)
endif()
add_executable(part $sample/fit_a_stroke.cc)
target_link_libraries(part PRIVATE feltline::stroke)
END
quietly cmake -S "$work/part" -B "$work/installed" -G Ninja "-DCMAKE_PREFIX_PATH=$prefix" "-DCMAKE_CXX_COMPILER=$export_cxx"
quietly cmake --build "$work/installed"
"$work/installed/part" | diff - "$work/by_cmake"
quietly cmake -S "$work/part" -B "$work/subdirectory" -G Ninja -DAS_PART=ON "-DCMAKE_CXX_COMPILER=$export_cxx"
# Nothing but the fitter is configured; compiling it again would only repeat the build.
quietly ninja -C "$work/subdirectory" -t commands part
grep -q felt_stroke "$work/log" || { echo "does not build the fitter"; exit 1; }
if grep -E 'felt_(io|store|render)' "$work/log"; then echo "builds more than the fitter"; exit 1; fi

# compiles OPTION...: checks that the source on stdin compiles with only the installed files.
compiles() {
  cat >"$work/one.cc"
  # shellcheck disable=SC2046
  quietly "$export_cxx" -std=c++20 -Wall -Wextra -Werror -fsyntax-only "$@" \
    $(pkg-config --cflags feltline) "$work/one.cc"
}

echo "public headers:"
mapfile -t headers < <(cd "$prefix/include" && find felt -name '*.h' | LC_ALL=C sort)
sed -nE 's|^\* \[([^]]+\.h)\].*|felt/\1|p' "$source_dir/src/felt/API.md" | LC_ALL=C sort |
  diff - <(printf '%s\n' "${headers[@]}")
printf '#include "%s"\n' "${headers[@]}" "${headers[@]}" | compiles  # fails if one includes a missing header

# A header that a source includes first was already compiled without other headers before it.
first_included=$(find "$source_dir/src" "$source_dir/apps" -name '*.cc' -exec grep -hm 1 '^#include "' {} + |
  sed -E 's/^#include "([^"]*)".*/\1/' | LC_ALL=C sort -u)
built_alone() { grep -qxF "$1" <<<"$first_included"; }

echo "every header compiles alone:"
alone=0
for header in "${headers[@]}"; do
  ! built_alone "$header" || continue
  printf '#include "%s"\n' "$header" | compiles
  alone=$((alone + 1))
done
echo "  public: ${#headers[@]}, $alone of them without their own source"
mapfile -t internal < <(cd "$source_dir/src" && find felt -name '*.h' -not -path '*/testing/*' |
  LC_ALL=C sort | comm -23 - <(printf '%s\n' "${headers[@]}"))
alone=0
for header in "${internal[@]}"; do
  ! built_alone "$header" || continue
  printf '#include "%s"\n' "$header" | compiles -I"$source_dir/src"
  alone=$((alone + 1))
done
echo "  internal: ${#internal[@]}, $alone of them without their own source"

if [ -e "$build_dir/bin/feltline" ]; then
  echo "program:"
  "$prefix/bin/feltline" --version
fi
