#!/usr/bin/env bash
# shards_test.sh FELTLINE: the scripts that all recipes share: cutting, fitting one shard, checking. It needs
# no other program, so it always runs.
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")  # before the working folder changes
. "$here/../cli/helpers.sh"
. "$here/helpers.sh"

fit_all() { # RESULTS [OPTION...]
  local shard
  mkdir -p "$1"
  for shard in shards/*.ndjson; do "$recipes/fit_shard.sh" "$shard" "$@" || return; done
}

make_shards 600
run 0 fit_all results
is_whole results

# The names are kept, in the order of the input, so results can be joined to the input.
grep -o '^{"id":"[^"]*"' in.ndjson >ids_in
grep -oh '^{"id":"[^"]*"' results/*.ndjson >ids_out
same ids_in ids_out

# A finished shard is skipped. It is fitted again if the options or the sketch have changed.
first=$(stat -c %i results/000000.ndjson)
run 0 fit_all results
[ "$first" = "$(stat -c %i results/000000.ndjson)" ] || fail "a finished shard was fitted again"
cp results/000000.ndjson kept
truncate -s -10 results/000000.ndjson
run 1 "$recipes/check_results.sh" shards results
has out "000000: the sketch has changed"
run 0 "$recipes/fit_shard.sh" shards/000000.ndjson results
same results/000000.ndjson kept
run 0 "$recipes/fit_shard.sh" shards/000000.ndjson results --tolerance 0.5
run 1 "$recipes/check_results.sh" shards results
has out ", but others by "
run 0 fit_all results
is_whole results

# Two machines that fit the same shards at the same time do no harm (a task that is started again although
# the first one lives).
fit_all twice &
fit_all twice
wait
is_whole twice
[ -z "$(find twice -name '.*')" ] || fail "left behind: $(ls -A twice)"

# Lost, doubled and changed shards are found.
mv results/000001.done hidden
run 1 "$recipes/check_results.sh" shards results
has out "000001: not finished"
mv hidden results/000001.done
cp results/000001.ndjson results/copy.ndjson
run 1 "$recipes/check_results.sh" shards results
has out "copy.ndjson: belongs to no shard"
rm results/copy.ndjson
head -n 1 shards/000002.ndjson >>shards/000002.ndjson
run 1 "$recipes/check_results.sh" shards results
has out "000002: the shard has changed since it was fitted"

# Bad records, records without a name, drawings of Quick, Draw!, blank lines, a header, a last line without
# an end: the same bytes as one process, and the bad records are counted, the unshown ones too.
{
  echo '{"feltline":1,"unit":"mm"}'
  for number in $(seq 40); do
    echo '{"points":[[0,0],[1,1],[2,'"$number"']]}'
    echo
    echo '{"id":"torn","points":[[1,2],[3'
    echo '{"word":"cat","drawing":[[[1,50,90],[2,30,4]],[[3,20],[9,'"$number"']]]}'
    echo '{"word":"cat","key_id":"k'"$number"'","drawing":[[[1,50,90],[2,30,4]],[[3,20],[9,80]]]}'
  done
  echo 'rubbish'
  printf '{"points":[[0,0],[5,5]]}'
} >in.ndjson
run 1 "$feltline" fit in.ndjson -o one.ndjson
rm -rf shards results
run 0 "$recipes/cut_shards.sh" shards 1K in.ndjson
run 0 fit_all results
run 0 "$recipes/check_results.sh" shards results
has out "162 records, 201 strokes, 41 bad records"
cat results/*.ndjson >all.ndjson
same all.ndjson one.ndjson
run 1 "$recipes/cut_shards.sh" shards 1K in.ndjson
has err "shards exists already"

# A full disk, a crash and a missing program are failures; they leave nothing behind.
rm -rf results
mkdir results
printf '#!/bin/sh\n[ "$1" = --version ] || kill -SEGV $$\n' >crash
printf '#!/bin/sh\nif [ "$1" = --version ]; then echo 1; else exec "%s" "$@" >/dev/full; fi\n' "$feltline" >full
printf '#!/bin/sh\nif [ "$1" = --version ]; then echo 1; else "%s" "$@" | head -n 2; fi\n' "$feltline" >short
chmod +x crash full short
cp one.ndjson sketch.ndjson
for wrong in crash full short missing; do
  [ $wrong != full ] || [ -w /dev/full ] || continue
  FELTLINE=./$wrong "$recipes/fit_shard.sh" shards/000000.ndjson results 2>err && fail "$wrong is a success"
done
run 70 "$recipes/fit_shard.sh" sketch.ndjson results
has err "contains curves"
[ -z "$(find results -mindepth 1)" ] || fail "a failure left $(ls -A results)"
