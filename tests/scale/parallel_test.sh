#!/usr/bin/env bash
# parallel_test.sh FELTLINE: the recipe with GNU parallel, killed in the middle and run again.
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")  # before the working folder changes
. "$here/../cli/helpers.sh"
. "$here/helpers.sh"
need parallel parallel --version

make_shards 4000
slow_down
FELT_MACHINE=$work/one "$recipes/with_parallel.sh" shards results 2 >first 2>&1 &
kill_in_the_middle results "FELT_MACHINE=$work/one"
wait
is_empty first
was_interrupted results
before=$(count_done results)
[ "$before" -lt "$(find shards -name '*.ndjson' | wc -l)" ] || fail "it was killed too late"
run 1 "$recipes/check_results.sh" shards results
has out ": not finished"

run 0 "$recipes/with_parallel.sh" shards results 2
is_whole results
echo "killed after $before shards; $(sed 1d results/joblog | wc -l) jobs in the log"

# The one-liner of docs/formats/ndjson.md.
run 0 parallel --pipepart -a in.ndjson --block 1M --keep-order "$feltline" fit - -o -
same out one.ndjson

# A shard that cannot be fitted is reported, and tried again by the next run.
printf '#!/bin/sh\nkill -SEGV $$\n' >crash
chmod +x crash
FELTLINE=$work/crash run 1 "$recipes/with_parallel.sh" shards crashed 2
