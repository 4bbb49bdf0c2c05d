#!/usr/bin/env bash
# check_results.sh SHARDS RESULTS: is every shard fitted once, completely, and unchanged since then?
#
# Compares the .done files (fit_shard.sh) with the shards and the sketches. Prints each fault, or the total
# of shards, records, strokes and bad records. Exit code 1 if there is a fault.
set -euo pipefail
shards=$1 results=$2
status=0
fault() { echo "$*"; status=1; }
sum_of() { sha256sum <"$1" | cut -d ' ' -f 1; }

settings='' records=0 strokes=0 bad=0 count=0
for shard in "$shards"/*.ndjson; do
  name=$(basename "$shard" .ndjson) sketch=$results/$(basename "$shard")
  if [ ! -e "$results/$name.done" ] || [ ! -e "$sketch" ]; then
    fault "$name: not finished"
    continue
  fi
  IFS=$'\t' read -r _ n_records n_strokes n_bad input_sum sketch_sum made <"$results/$name.done"
  [ "$input_sum" = "$(sum_of "$shard")" ] || fault "$name: the shard has changed since it was fitted"
  [ "$sketch_sum" = "$(sum_of "$sketch")" ] || fault "$name: the sketch has changed"
  [ "$n_strokes" = "$(wc -l <"$sketch")" ] || fault "$name: the sketch has not $n_strokes strokes"
  settings=${settings:-$made}
  [ "$settings" = "$made" ] || fault "$name: made by '$made', but others by '$settings'"
  records=$((records + n_records)) strokes=$((strokes + n_strokes)) bad=$((bad + n_bad)) count=$((count + 1))
done
for sketch in "$results"/*.ndjson; do
  [ -e "$shards/$(basename "$sketch")" ] || fault "$(basename "$sketch"): belongs to no shard"
done
[ $status != 0 ] || echo "$count shards: $records records, $strokes strokes, $bad bad records"
exit $status
