# The tests of the program source this file. $feltline is the program. The current folder is empty at
# the start and removed at the end. If a check fails, it prints its line and the reason, and the test
# continues. A test fails if a check failed, or if its last command did (`exit 77` skips it).
set -uo pipefail
# shellcheck disable=SC2034  # the scripts that read this file use it
feltline=$1
work=$(mktemp -d)
unset NO_COLOR
failures=0

end_test() {
  local status=$?
  rm -rf "$work"
  [ "$failures" = 0 ] || { printf '%s checks failed\n' "$failures" >&2; exit 1; }
  exit "$status"
}

trap end_test EXIT
cd "$work" || exit 1

fail() {
  local line=${BASH_LINENO[1]:-0}
  [ "$line" != 0 ] || line=${BASH_LINENO[0]}  # the test itself called fail
  printf 'FAILED at line %s: %s\n' "$line" "$*" >&2
  failures=$((failures + 1))
}

# run CODE COMMAND...: runs COMMAND, writes its output to ./out and ./err, and checks its exit code.
run() {
  local wanted=$1 code=0
  shift
  "$@" >out 2>err || code=$?
  [ "$code" = "$wanted" ] || fail "exit code $code instead of $wanted: $* : $(head -c 300 err)"
}

# same FILE FILE: checks that the files are equal.
same() { cmp -s "$1" "$2" || fail "$1 and $2 differ"; }

# has FILE TEXT: checks that a line of FILE contains TEXT.
has() { grep -qF -- "$2" "$1" || fail "no '$2' in $1: $(head -c 300 "$1")"; }

# lines FILE COUNT: checks that FILE has COUNT lines.
lines() { [ "$(wc -l <"$1")" = "$2" ] || fail "$(wc -l <"$1") lines instead of $2 in $1"; }

# is_empty FILE: checks that FILE is empty.
is_empty() { [ ! -s "$1" ] || fail "$1 is not empty: $(head -c 300 "$1")"; }

# limit_memory KIB COMMAND...: runs COMMAND with at most KIB of address space. With a sanitizer it runs
# COMMAND without the limit, because sanitizers need much more.
limit_memory() {
  local kib=$1
  shift
  if [ -z "${FELT_SANITIZE:-}" ]; then
    (ulimit -v "$kib" && exec "$@")
  else
    "$@"
  fi
}

# strokes COUNT: prints COUNT different raw strokes of 40 samples each.
strokes() {
  awk -v count="$1" 'BEGIN {
    for (s = 1; s <= count; s++) {
      printf "{\"id\":\"s%d\",\"points\":[", s
      for (i = 0; i < 40; i++) {
        a = i * (0.1 + s % 7 * 0.02)
        printf "%s[%.2f,%.2f,%.2f,%d]", i ? "," : "", s % 50 * 4 + 3 * a + cos(3 * a),
               s % 60 * 4 + 4 * sin(2 * a), 0.3 + 0.2 * sin(a), i * 8
      }
      print "]}"
    }
  }'
}
