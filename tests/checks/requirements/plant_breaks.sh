#!/usr/bin/env bash
# plant_breaks.sh [--tree DIR] [--jobs N] [Rn|PATCH ...]: does the test of a requirement fail when the
# feature is broken? For each patch of this folder (or of the given requirements): builds its target
# in a scratch copy of the tree and requires its test to pass; plants the break, builds, and requires
# the test to fail; removes the break. Prints a table. Exits with 1 if a break was not caught or could
# not be tried.
#
# The scratch copy is build/breaks, with a build folder of its own; it is kept for the next run. The
# working tree is only read. --tree uses another scratch copy without copying anything into it; its
# source files are patched.
set -euo pipefail

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
source=$(readlink -f "$here/../../..")
readonly here source
# shellcheck source=breaks.sh
. "$here/breaks.sh"
readonly test_s=900
tree=
jobs=$(nproc)
wanted=()

fail() {
  echo "plant_breaks.sh: $*" >&2
  exit 2
}

while (($# > 0)); do
  case $1 in
    --tree)
      tree=$(readlink -f "${2:?}")
      shift
      ;;
    --jobs)
      jobs=${2:?}
      shift
      ;;
    --help | -h)
      sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"
      exit 0
      ;;
    -*) fail "unknown option $1" ;;
    *) wanted+=("$1") ;;
  esac
  shift
done

# Copies only the files that differ, so that only those are built again.
copy_tree() {
  tree=$source/build/breaks
  mkdir -p "$tree"
  local file
  while IFS= read -r -d '' file; do
    [[ -f $source/$file ]] || continue
    cmp -s "$source/$file" "$tree/$file" && continue
    mkdir -p "$tree/$(dirname "$file")"
    cp "$source/$file" "$tree/$file"
  done < <(git -C "$source" ls-files -z --cached --others --exclude-standard)
}

is_wanted() {
  ((${#wanted[@]} == 0)) && return 0
  local name one
  name=$(basename "$1")
  for one in "${wanted[@]}"; do
    [[ $name == "$one"_* || $name == "$(basename "$one")" ]] && return 0
  done
  return 1
}

build() { # TARGET LOG
  if [[ $1 == all ]]; then
    cmake --build "$tree/build/dev" --parallel "$jobs" >"$2" 2>&1
  else
    cmake --build "$tree/build/dev" --parallel "$jobs" --target "$1" >"$2" 2>&1
  fi
}

# run_test TARGET TEST LOG: prints green, red, died, or none (if no test has this name).
run_test() {
  local target=$1 test=$2 log=$3 status=0
  if [[ $test == ctest:* ]]; then
    local name=${test#ctest:}
    name=${name# }
    ctest --test-dir "$tree/build/dev" -R "^${name//./[.]}\$" --timeout "$test_s" \
      --output-on-failure >"$log" 2>&1 || status=$?
    if grep -q 'No tests were found' "$log"; then
      echo none
    elif ((status == 0)); then
      echo green
    else
      echo red
    fi
    return
  fi
  local program=$tree/build/dev/bin/$target
  # Not grep -q, because it exits at the first match, and then the closed pipe kills the program.
  if ! "$program" --gtest_list_tests "--gtest_filter=$test" 2>/dev/null | grep '^  ' >/dev/null; then
    echo none
    return
  fi
  (cd "$tree" && QT_QPA_PLATFORM=${QT_QPA_PLATFORM:-offscreen} timeout "$test_s" "$program" \
    "--gtest_filter=$test" --gtest_color=no) >"$log" 2>&1 || status=$?
  if ((status == 0)); then
    echo green
  elif grep -q '^\[  FAILED  \]' "$log"; then
    echo red
  else
    echo died
  fi
}

# try_break PATCH: prints the result, which is "caught" if the test works.
try_break() {
  local file=$1 target test log verdict
  target=$(header Target "$file")
  test=$(header Test "$file")
  log=$logs/$(basename "$file" .patch)
  if [[ -z $target || -z $test ]]; then
    echo "its header has no Target or Test"
    return
  fi
  if ! build "$target" "$log.build"; then
    echo "does not build without the break ($log.build)"
    return
  fi
  verdict=$(run_test "$target" "$test" "$log.before")
  if [[ $verdict != green ]]; then
    echo "the test is $verdict without the break ($log.before)"
    return
  fi
  if ! apply_break "$tree" "$file" >"$log.patch" 2>&1; then
    echo "does not apply ($log.patch)"
    return
  fi
  planted=$file
  if build "$target" "$log.build"; then
    verdict=$(run_test "$target" "$test" "$log.after")
    case $verdict in
      red | died) echo caught ;;
      *) echo "NOT CAUGHT ($log.after)" ;;
    esac
  else
    echo "does not build with the break ($log.build)"
  fi
  take_out
}

planted=
take_out() {
  if [[ -n $planted ]]; then
    apply_break "$tree" "$planted" --reverse >/dev/null
    # Ninja would not build a file again if its time stamp did not change.
    sed -n 's,^+++ b/\([^[:space:]]*\).*,\1,p' "$planted" | (cd "$tree" && xargs touch)
  fi
  planted=
}

[[ -n $tree ]] || copy_tree
[[ $tree != "$source" ]] || fail "--tree needs a scratch copy, not the tree itself"
logs=$tree/build/break-logs
mkdir -p "$logs"
trap take_out EXIT
if [[ ! -f $tree/build/dev/CMakeCache.txt ]]; then
  (cd "$tree" && cmake --preset dev -DFELT_QUICK_BUILD=ON -DFELT_WEB_TESTS=ON >"$logs/configure" 2>&1) ||
    fail "the copy cannot be configured: $logs/configure"
fi

tried=0
caught=0
missed=0
while IFS= read -r file; do
  is_wanted "$file" || continue
  result_file=$logs/result
  try_break "$file" >"$result_file"
  result=$(cat "$result_file")
  tried=$((tried + 1))
  if [[ $result == caught ]]; then
    caught=$((caught + 1))
  else
    missed=$((missed + 1))
  fi
  printf '%-60s %s\n' "$(basename "$file" .patch)" "$result"
done < <(printf '%s\n' "$here"/R*.patch | sort -V)
if ((${#wanted[@]} == 0)); then
  "$here/check_breaks.sh" --missing || missed=$((missed + 1))
fi
((tried > 0)) || fail "no patch has this name"
echo "$tried breaks, $caught caught"
((missed == 0))
