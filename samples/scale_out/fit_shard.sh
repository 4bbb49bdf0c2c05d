#!/usr/bin/env bash
# fit_shard.sh SHARD RESULTS [OPTION...]: fits one shard with `feltline fit`. Every recipe runs this script
# once per shard; FELTLINE names the program if it is not on the PATH.
#
# Writes RESULTS/NAME.ndjson (the sketch), RESULTS/NAME.bad (messages about bad records, if any), and last
# RESULTS/NAME.done, one line with tabs: the shard, records, strokes, bad records, SHA-256 of the shard,
# SHA-256 of the sketch, version and options. Each file gets its name only when it is complete. So the
# script may be killed at any moment, run again, or run twice at the same time: a finished shard is
# skipped, and the same shard always gives the same bytes. Exit code 0: the shard is finished.
set -euo pipefail
export LC_ALL=C  # grep is much slower in other locales
shard=$1 results=$2
shift 2
feltline=${FELTLINE:-feltline}
name=$(basename "$shard" .ndjson)
sum_of() { sha256sum <"$1" | cut -d ' ' -f 1; }
version=$("$feltline" --version)
input_sum=$(sum_of "$shard")

# Is it finished, with the same input, version and options?
if [ -e "$results/$name.done" ] && [ -e "$results/$name.ndjson" ]; then
  made=$(cut -f 5- "$results/$name.done")
  [ "$made" != "$input_sum"$'\t'"$(sum_of "$results/$name.ndjson")"$'\t'"$version $*" ] || exit 0
fi

work=$(mktemp -d "$results/.$name.XXXXXX")
trap 'rm -rf "$work"' EXIT
code=0
"$feltline" fit - -o - --to ndjson "$@" <"$shard" >"$work/sketch" 2>"$work/bad" || code=$?
# Exit code 1 is right if all messages are about records. Any other message, and a signal, is a failure.
# After three messages of one kind, a line counts the others.
bad=$(awk '/^feltline: stdin:[0-9]+: / { ++bad; next }
           /^feltline: stdin: \.\.\. and [0-9,]+ more like it/ { gsub(",", "", $5); bad += $5; next }
           { other = 1 }
           END { printf "%d", bad; exit other }' "$work/bad") || code=70
if [ $code -gt 1 ] || [ $((bad > 0)) != $code ]; then
  echo "fit_shard.sh: $shard failed: $(tail -n 1 "$work/bad")" >&2
  exit $((code > 1 ? code : 70))
fi

# Each good record gives one stroke, but a drawing of Quick, Draw! gives the strokes KEY.1, KEY.2, ...
strokes=$(wc -l <"$work/sketch")
records=$(grep -avc -e '^[[:space:]]*$' -e '^ *{ *"feltline"' "$shard" || true)
good=$strokes
! grep -aq '"drawing"' "$shard" || good=$(awk -F '"' '
  { key = $4; sub(/\.[0-9]+$/, "", key); number = substr($4, length(key) + 2) + 0 }
  number < 2 || key != last { ++good }
  { last = key }
  END { print good + 0 }' "$work/sketch")
if [ $((good + bad)) -lt "$records" ]; then
  echo "fit_shard.sh: $shard: $good of $records records, and $bad bad ones" >&2
  exit 70
fi

printf '%s\t%d\t%d\t%d\t%s\t%s\t%s\n' "$name" "$records" "$strokes" "$bad" "$input_sum" \
  "$(sum_of "$work/sketch")" "$version $*" >"$work/done"
sync "$work"/*
mv -f "$work/sketch" "$results/$name.ndjson"
if [ "$bad" != 0 ]; then mv -f "$work/bad" "$results/$name.bad"; else rm -f "$results/$name.bad"; fi
mv -f "$work/done" "$results/$name.done"
