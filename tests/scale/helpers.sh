# The tests of the recipes (samples/scale_out) source this file after tests/cli/helpers.sh.
# shellcheck shell=bash disable=SC2034,SC2154  # the tests use the variables, and helpers.sh sets them
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
recipes=$root/samples/scale_out
export FELTLINE=$feltline

# need PACKAGE COMMAND...: skips the test if COMMAND fails because PACKAGE is missing.
need() {
  "${@:2}" >/dev/null 2>&1 && return
  echo "skipped: $1 is not installed (./dev setup scale)"
  exit 77
}

# make_shards COUNT: writes in.ndjson with at most COUNT strokes, its shards (about 12), and one.ndjson, which
# one process makes of it. The strokes are recorded, or synthetic if the recordings are missing.
make_shards() {
  local recorded=${FELT_SHARED_DATA:-$root/../shared/data/pen-strokes-a.ndjson}
  if [ -r "$recorded" ]; then
    head -n "$1" "$recorded" >in.ndjson
  else
    echo "synthetic strokes: no recordings at $recorded (set FELT_SHARED_DATA to name them)"
    strokes "$1" >in.ndjson
  fi
  run 0 "$recipes/cut_shards.sh" shards $(($(wc -c <in.ndjson) / 12)) in.ndjson
  mv shards/000003.ndjson "shards/000003 with spaces.ndjson"
  run 0 "$feltline" fit in.ndjson -o one.ndjson
}

# From now on, every process of the recipes stops for half a second in the middle of its output.
slow_down() {
  cat >slow_feltline <<END
#!/usr/bin/env bash
[ "\$1" != --version ] || exec "$feltline" --version
set -o pipefail
"$feltline" "\$@" | { head -c 20000; sleep 0.5; cat; }
END
  chmod +x slow_feltline
  export FELTLINE=$work/slow_feltline
}

# count_done RESULTS: prints the number of finished shards.
count_done() { find "$1" -name '*.done' 2>/dev/null | wc -l; }

# processes_with SETTING...: prints the processes that have all these settings in their environment.
processes_with() {
  local files=(/proc/[0-9]*/environ) setting
  for setting in "$@"; do
    mapfile -t files < <(grep -lzxF -- "$setting" "${files[@]}" 2>/dev/null)
    [ ${#files[@]} != 0 ] || return 0
  done
  printf '%s\n' "${files[@]}" | cut -d / -f 3
}

# is_in_the_middle RESULTS PROCESS...: true if two shards are finished and a process is in a shard.
is_in_the_middle() {
  local IFS=,
  [ $# -gt 1 ] && [ "$(count_done "$1")" -ge 2 ] && ps -o comm= -p "${*:2}" | grep -qx sleep
}

# kill_in_the_middle RESULTS SETTING...: waits until it is in the middle of the work, calls kill_first, and
# kills all processes with the settings.
kill_in_the_middle() {
  local victims end=$((SECONDS + 60))
  while [ $SECONDS -lt $end ]; do
    mapfile -t victims < <(processes_with "${@:2}")
    if is_in_the_middle "$1" "${victims[@]}"; then
      kill_first
      kill -KILL "${victims[@]}" 2>/dev/null
      return
    fi
  done
  fail "nothing to kill"
}
kill_first() { :; }

# was_interrupted RESULTS: checks that the kill left a part of a sketch, which has no name yet.
was_interrupted() {
  [ -n "$(find "$1" -path '*/.*/sketch' -size +0)" ] || fail "the kill interrupted nothing"
}

# is_whole RESULTS: checks that the results are those of one process, nothing lost or doubled.
is_whole() {
  run 0 "$recipes/check_results.sh" shards "$1"
  has out "$(find shards -name '*.ndjson' | wc -l) shards: $(wc -l <in.ndjson) records, "
  cat "$1"/*.ndjson >all.ndjson
  same all.ndjson one.ndjson
}
