#!/usr/bin/env bash
# check_breaks.sh [BUILD_DIR]: can the breaks of this folder still be planted? Checks that each patch
# applies to the tree, and that its target and its test exist. Does not build; plant_breaks.sh does.
# check_breaks.sh --missing: does each requirement have a break, or a reason in README.md?
set -euo pipefail

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
source=$(readlink -f "$here/../../..")
readonly here source
# shellcheck source=breaks.sh
. "$here/breaks.sh"
errors=0

complain() {
  echo "$*"
  errors=$((errors + 1))
}

find_missing() {
  local n
  for n in $(requirements); do
    compgen -G "$here/R${n}_*.patch" >/dev/null && continue
    grep -qE "^\| R$n \|" "$here/README.md" ||
      complain "R$n: no break is planted, and README.md gives no reason"
  done
}

if [[ ${1:-} == --missing ]]; then
  find_missing
  exit $((errors > 0))
fi
build=${1:-}

# Prints all tests of the sources as Suite.Name, one per line.
list_tests() {
  find "$source/src" "$source/apps" "$source/tests" -name '*.cc' -exec cat {} + | tr '\n' ' ' |
    grep -oE '\b(TEST|TEST_F|TEST_P|TYPED_TEST|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\( *[A-Za-z0-9_]+, *[A-Za-z0-9_]+' |
    sed -E 's/^[A-Z_]+\( *//; s/, */./'
}
tests=$(list_tests)

# The names are read once, because the files are large.
ctests=''
targets=''
if [[ -n $build ]]; then
  ctests=$(find "$build" -name CTestTestfile.cmake -exec grep -hE '^add_test' {} +)
fi
if [[ -f $build/build.ninja ]]; then
  targets=$(grep -oE '^build (bin/)?[A-Za-z0-9_.]+:|LINKER__[A-Za-z0-9_]+' "$build/build.ninja" | sort -u)
fi

# has_test PATTERN: true if a test matches one pattern of a gtest filter. An instance (A/Suite.Name/3)
# counts as its test.
has_test() {
  local pattern=$1
  pattern=${pattern#\*/}
  [[ $pattern == [A-Z]*/*.* ]] && pattern=${pattern#*/}
  pattern=${pattern%/*}
  grep -qE "^${pattern//\*/.*}\$" <<<"${tests//./.}"
}

check_test() { # FILE TEST BUILD_DIR
  local file=$1 test=$2 build=$3 one
  if [[ $test == ctest:* ]]; then
    test=${test#ctest:}
    test=${test# }
    [[ -z $build ]] || grep -qF "$test" <<<"$ctests" ||
      complain "$file: there is no ctest \"$test\""
    return
  fi
  local -a patterns
  IFS=: read -ra patterns <<<"${test%%-*}"
  for one in "${patterns[@]}"; do
    has_test "$one" || complain "$file: no test is called \"$one\""
  done
}

# has_needed PATCH: true unless the build was configured without the option that the patch needs.
has_needed() {
  local option
  option=$(header Needs "$1")
  [[ -z $option ]] || grep -qsx "$option:BOOL=ON" "$build/CMakeCache.txt"
}

for path in "$here"/R*.patch; do
  file=$(basename "$path")
  [[ -f $path ]] || continue
  [[ $file =~ ^R([0-9]+)_[A-Za-z0-9_]+\.patch$ ]] || complain "$file: not named Rn_what_breaks.patch"
  [[ -n $(header Breaks "$path") ]] || complain "$file: no \"Breaks:\" in its header"
  target=$(header Target "$path")
  [[ -n $target ]] || complain "$file: no \"Target:\" in its header"
  of_build=
  ! has_needed "$path" || of_build=$build
  if [[ -n $target && $target != all && -n $of_build && -n $targets ]]; then
    grep -qE "^build (bin/)?$target:|^LINKER__${target}_" <<<"$targets" ||
      complain "$file: there is no target \"$target\""
  fi
  test=$(header Test "$path")
  if [[ -n $test ]]; then
    check_test "$file" "$test" "$of_build"
  else
    complain "$file: no \"Test:\" in its header"
  fi
  apply_break "$source" "$path" --dry-run >/dev/null 2>&1 ||
    complain "$file: does not apply to the tree; make it again"
done

((errors == 0))
