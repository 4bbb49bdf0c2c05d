#!/usr/bin/env bash
# check_sizes.sh [ROOT]: which files and functions are too long to read well?
#
# Prints the files over the target, and fails if a file or function exceeds the bound:
#   header 150 lines (bound 300), source 400 (bound 500), function 60 lines (bound 60, not in tests).
# Functions are measured with universal-ctags. Without it, the script measures only files and says so.
set -euo pipefail
cd "${1:-.}"

mapfile -t files < <(find src apps bench tests samples python -type f \( -name '*.h' -o -name '*.cc' \) \
  2>/dev/null | LC_ALL=C sort)
[ ${#files[@]} -gt 0 ] || exit 0
status=0

wc -l "${files[@]}" | LC_ALL=C sort -rn | awk '
  $2 == "total" || $2 ~ /_test\.cc$/ || $2 ~ /^tests\// { next }
  { header = $2 ~ /\.h$/; target = header ? 150 : 400; bound = header ? 300 : 500 }
  $1 > bound { printf "%s: %d lines, the bound is %d\n", $2, $1, bound; over = 1; next }
  $1 > target { printf "%s: %d lines, the target is %d\n", $2, $1, target }
  END { exit over }' || status=1

if ! ctags --version 2>/dev/null | grep -q 'Universal Ctags'; then
  echo "functions are not measured: universal-ctags is not installed"
  exit $status
fi
printf '%s\n' "${files[@]}" | grep -v -e '_test\.cc$' -e '^tests/' |
  ctags -L - --languages=C++ --langmap=C++:.cc.h --kinds-C++=f --fields=+ne -f - 2>/dev/null |
  awk -F'\t' '
  /^!/ { next }
  { from = to = 0
    for (i = 4; i <= NF; ++i) {
      if ($i ~ /^line:/) from = substr($i, 6)
      if ($i ~ /^end:/) to = substr($i, 5)
    }
    if (!to) next
    ++functions; lines = to - from + 1
    if (lines > 30) ++long_ones
    if (lines > 60) { printf "%s:%d: %s is %d lines long, the bound is 60\n", $2, from, $1, lines
                      over = 1 } }
  END {
    if (functions) printf "%d functions, %d of them over 30 lines\n", functions, long_ones
    exit over }' || status=1
exit $status
