#!/usr/bin/env bash
# install_test.sh SOURCE_DIR BUILD_DIR CXX: installs BUILD_DIR into an empty folder, moves that
# folder, and uses what is there as a stranger would: by find_package, by pkg-config, and the
# program itself.
set -euo pipefail
source_dir=$1 build_dir=$2 export_cxx=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sample=$source_dir/samples/fit_a_stroke

# Run CMAKE quietly; say everything when it fails.
quietly() { "$@" >"$work/log" 2>&1 || { echo "FAILED: $*"; cat "$work/log"; exit 1; }; }

quietly cmake --install "$build_dir" --prefix "$work/first"
# A tree that knows where it was made does not survive this.
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

echo "every installed header compiles by itself:"
count=0
while IFS= read -r header; do
  printf '#include "%s"\n#include "%s"\n' "$header" "$header" >"$work/one.cc"
  # shellcheck disable=SC2046
  quietly "$export_cxx" -std=c++20 -Wall -Wextra -Werror -fsyntax-only $(pkg-config --cflags feltline) \
    "$work/one.cc"
  count=$((count + 1))
done < <(cd "$prefix/include" && find felt -name '*.h' | LC_ALL=C sort)
[ "$count" -gt 5 ]
echo "  $count headers"

if [ -e "$build_dir/bin/feltline" ]; then
  echo "program:"
  "$prefix/bin/feltline" --version
fi
