#!/usr/bin/env bash
# check_tick_symbols.sh ROOTS OBJECT...: finds all functions that could run at a tick, and checks
# that none of them calls anything that may block, allocate or throw.
#
# The objects are built with -ffunction-sections. Therefore the relocations show which function
# refers to which. The search starts from the functions with a C++ name that matches the extended
# regular expression ROOTS. Every function that they reach must be in the objects or in the list
# below. The search cannot see calls through pointers. Therefore the force functors are roots too,
# and rt_proof runs them.
set -euo pipefail

# Allowed functions of libc and libm: they are pure, take bounded time and use no lock.
allowed='sqrt|fabs|floor|ceil|trunc|round|rint|nearbyint|fmod|remainder|hypot|exp|exp2|expm1|log'
allowed+='|log1p|log2|pow|sin|cos|sincos|tan|atan|atan2|acos|asin|tanh|fmin|fmax'
allowed+='|memcpy|memmove|memset|memcmp|strlen|_GLOBAL_OFFSET_TABLE_'

[ $# -ge 2 ] || { echo "usage: $0 ROOTS OBJECT..." >&2; exit 2; }
roots=$1
shift

# Prints one fact per line: BROKEN object, DEFINED name C++-name, UNDEFINED name, or CALL section
# symbol.
facts() {
  local object names
  for object in "$@"; do
    [ -r "$object" ] || { echo "BROKEN $object"; continue; }
    names=$(nm "$object" | awk 'NF == 3 && $2 ~ /[TtWwVu]/ { print $3 }')
    paste -d ' ' <(sed 's/^/DEFINED /' <<<"$names") <(sed 's/\.cold$//' <<<"$names" | c++filt)
    nm -u "$object" | awk '{ print "UNDEFINED", $2 }'
    objdump -r "$object" | awk '
      /^RELOCATION RECORDS FOR .\.text/ { from = substr($4, 2, length($4) - 3); next }
      /^RELOCATION RECORDS/ { from = ""; next }
      from != "" && $2 ~ /^R_/ { print "CALL", from, $3 }'
  done
}

facts "$@" | awk -v roots="$roots" -v allowed="^($allowed)\$" '
  # Returns NAME for .text.unlikely.NAME, .text.NAME and NAME.cold.
  function plain(name) {
    sub(/[+-]0x[0-9a-f]+$/, "", name)
    sub(/^\.text(\.unlikely|\.startup|\.hot|\.exit)?\./, "", name)
    sub(/\.cold$/, "", name)
    return name
  }
  $1 == "DEFINED" { name = plain($2); $1 = $2 = ""; pretty[name] = $0; next }
  $1 == "BROKEN" { print "cannot read " $2; broken = 1; next }
  $1 == "UNDEFINED" { undefined[$2] = 1; next }
  { from = plain($2); to = plain($3); if (from != to) calls[from] = calls[from] " " to }
  END {
    for (name in pretty) if (pretty[name] ~ roots) { reached[++last] = name; by[name] = "" }
    root_count = last + 0
    if (!root_count) { print "no function matches " roots; exit 1 }
    for (at = 1; at <= last; ++at) {
      count = split(calls[reached[at]], targets, " ")
      for (k = 1; k <= count; ++k) {
        to = targets[k]
        if (to in by) continue
        by[to] = reached[at]
        if (to in pretty) { reached[++last] = to; continue }
        if (!(to in undefined) || to ~ allowed) continue
        printf "reached at a tick, and not allowed there: %s\n", to
        for (up = reached[at]; up != ""; up = by[up]) printf "    from%s\n", pretty[up]
        bad = 1
      }
    }
    printf "%d functions, reached from %d roots\n", last, root_count
    exit bad || broken
  }'
