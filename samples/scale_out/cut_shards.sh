#!/usr/bin/env bash
# cut_shards.sh SHARDS SIZE INPUT.ndjson...: cuts pen strokes into files of about SIZE bytes (64M, 500K).
#
# The shards are SHARDS/000000.ndjson, 000001.ndjson, ... in the order of the input. They have about the
# same size, because the time that a shard takes is proportional to its samples. A record without a name
# gets the name that one process would give it, which depends on the number of the record in the whole
# input. SHARDS exists only when it is complete.
set -euo pipefail
shards=$1 size=$(numfmt --from=iec "$2")
shift 2
[ ! -e "$shards" ] || { echo "cut_shards.sh: $shards exists already" >&2; exit 1; }
rm -rf "$shards.part"
mkdir -p "$shards.part"
LC_ALL=C awk -v folder="$shards.part" -v limit="$size" '
  /^[ \t\r]*$/ { next }
  { ++record }
  !/"(id|key_id|feltline)"[ \t]*:/ {
    sub(/^[ \t]*\{/, (/"drawing"/ ? "{\"key_id\"" : "{\"id\"") ":\"s" record "\",")
  }
  file == "" || bytes >= limit {
    if (file != "") close(file)
    file = sprintf("%s/%06d.ndjson", folder, count++); bytes = 0
  }
  { print > file; bytes += length($0) + 1 }' "$@"
mv "$shards.part" "$shards"
