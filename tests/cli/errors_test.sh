# Each invalid record or file gives one line on stderr. The others are processed, and the exit code is
# 1.
. "$(dirname "$0")/helpers.sh"

strokes 2 >good.ndjson
{
  head -n 1 good.ndjson
  echo 'hello'
  echo '{"id":"n","points":[[1,2],[NaN,3]]}'
  echo
  echo '{"id":"m"}'
  printf '{"points":[[1,2]\0]}\n'
  tail -n 1 good.ndjson
  printf '{"id":"torn","points":[[1,2],[3'
} >bad.ndjson
run 1 "$feltline" fit bad.ndjson -o out.ndjson
lines err 5
has err "feltline: bad.ndjson:2: not a JSON object"
has err "feltline: bad.ndjson:3: points[1]: x: NaN is not a number"
has err "feltline: bad.ndjson:5: key \"points\" is missing"
has err "feltline: bad.ndjson:6: byte 17 is NUL"
has err "feltline: bad.ndjson:8: the record is cut off"
cp err errors
run 0 "$feltline" fit good.ndjson -o expected.ndjson
same out.ndjson expected.ndjson
run 1 "$feltline" fit bad.ndjson -o out.ndjson --jobs 4
same err errors
same out.ndjson expected.ndjson
run 1 "$feltline" fit - -o - <bad.ndjson
has err "feltline: stdin:2: "
same out expected.ndjson

# A file in an unsupported format is refused with a single error instead of one per line. The format is
# recognized by the content, not by the name.
printf '\211PNG\r\n\032\n0000' >picture.png
cp picture.png picture.ndjson
for name in picture.png picture.ndjson; do
  for command in "fit $name -o x.ndjson" "info $name" "render $name -o x.png" "convert $name -o -"; do
    # shellcheck disable=SC2086  # must be split into words
    run 1 "$feltline" $command
    lines err 1
    has err "feltline: $name: is a PNG picture, which Feltline can write but not read"
  done
done
echo 'Dear all,' >letter.doc
run 1 "$feltline" convert letter.doc -o x.svg
has err "feltline: letter.doc: is not a drawing that Feltline can read; it reads felt, svg,"
echo '{"t_ms":0,"event":"undo"}' >script.ndjson
for command in "fit script.ndjson -o x.ndjson" "info script.ndjson" "convert script.ndjson -o x.svg"; do
  # shellcheck disable=SC2086  # must be split into words
  run 1 "$feltline" $command
  lines err 1
  has err "feltline: script.ndjson: contains events, not strokes"
done
[ ! -e x.svg ] || fail "an empty drawing was written"

# Errors name the format of a Quick, Draw! drawing even if the start of its line does not show it.
{
  printf '{"word":"'
  head -c 1000000 /dev/zero | tr '\0' a
  echo '","drawing":[[[1,2],[3,4]]]}'
} >word.ndjson
for command in "info word.ndjson" "convert word.ndjson -o x.svg"; do
  # shellcheck disable=SC2086  # must be split into words
  run 1 "$feltline" $command
  lines err 1
  has err "feltline: word.ndjson:1: is a drawing of Quick, Draw!"
done
run 1 "$feltline" fit word.ndjson -o x.svg
lines err 1
has err "feltline: word.ndjson:1: word: longer than 4096 bytes"
[ ! -e x.svg ] || fail "an empty drawing was written"

# A record without an id gets its number as the id.
printf '{"points":[[0,0],[5,5]]}\n{"id":"b","points":[[0,0],[5,5]]}\n{"points":[[0,0],[5,5]]}\n' >n.ndjson
run 0 "$feltline" fit n.ndjson -o -
has out '{"id":"s1",'
has out '{"id":"s3",'

# If an input does not exist, the others are still processed. If all fail, an older output is kept.
run 1 "$feltline" fit missing.ndjson good.ndjson . -o out.ndjson
has err "feltline: missing.ndjson: No such file or directory"
has err "feltline: .: Is a directory"
same out.ndjson expected.ndjson
run 1 "$feltline" fit missing.ndjson -o out.ndjson
same out.ndjson expected.ndjson
: >empty.ndjson
printf '\n \n' >blank.ndjson
for nothing in empty blank; do
  run 1 "$feltline" fit $nothing.ndjson -o out.ndjson
  has err "feltline: $nothing.ndjson: contains no strokes"
  same out.ndjson expected.ndjson
  for command in "render $nothing.ndjson -o x.png" "convert $nothing.ndjson -o -" \
    "info $nothing.ndjson"; do
    # shellcheck disable=SC2086  # must be split into words
    run 1 "$feltline" $command
    has err "feltline: $nothing.ndjson: contains no strokes"
  done
done
[ ! -e x.png ] || fail "an empty picture was written"
if [ "$(id -u)" != 0 ]; then
  cp good.ndjson locked.ndjson
  chmod 000 locked.ndjson
  run 1 "$feltline" fit locked.ndjson -o -
  has err "feltline: locked.ndjson: Permission denied"
fi

# The error for an output that cannot be written names the output.
run 1 "$feltline" fit good.ndjson -o no/such/folder.ndjson
has err "no/such/folder.ndjson"
mkdir folder.ndjson
run 1 "$feltline" fit good.ndjson -o folder.ndjson
has err "folder.ndjson"
if [ -w /dev/full ]; then
  run 1 "$feltline" fit good.ndjson -o /dev/full
  has err "feltline: /dev/full: No space left on device"
  run 1 bash -c "'$feltline' fit good.ndjson -o - >/dev/full"
  has err "feltline: stdout: No space left on device"
  run 1 bash -c "'$feltline' info good.ndjson >/dev/full"
  has err "feltline: stdout: "
fi
run 0 "$feltline" fit good.ndjson -o /dev/null
[ -c /dev/null ] || fail "/dev/null was replaced"

# Sketches are checked as strictly as raw samples.
echo '{"id":"k","closed":false,"segments":[[0,0,1,1,2,1,3,0],[3,1,4,4,5,5,6,6]],"joints":["smooth"],"widths":[[0,1],[2,1]]}' >k.ndjson
run 1 "$feltline" convert k.ndjson -o -
has err "feltline: k.ndjson:1: segments[1]: does not start at the end of the previous one"
echo '{"id":"k","closed":false,"segments":[[0,0,1,1,2,1,3,0]],"joints":[],"widths":[[0,1],[2,1]]}' >k.ndjson
run 1 "$feltline" convert k.ndjson -o -
has err "feltline: k.ndjson:1: "

# Raw pressures, and times that are none, are named once with their number, and keep what they can.
points() {
  awk -v p="$1" -v t="$2" 'BEGIN { for (i = 0; i < 40; ++i) printf "%s[%d,%g,%g,%d]", i ? "," : "",
    2 * i, 30 + 8 * sin(0.3 * i), p * (0.5 + 0.4 * sin(0.15 * i)), t * i }'
}
for kind in "1 8" "1 0" "1 -8" "1023 8"; do
  for i in 1 2 3; do
    # shellcheck disable=SC2086  # must be split into words
    echo "{\"id\":\"k$i\",\"points\":[$(points $kind)]}"
  done >"${kind// /_}.ndjson"
done
widest() {
  sed 's/.*"widths"://' "$1" | tr ',[]{}' '\n' | awk '/^[0-9.]+$/ && ++n % 2 == 0 && $1 > w { w = $1 } END { print w }'
}
run 0 "$feltline" fit 1_8.ndjson -o good.ndjson
is_empty err
for kind in 1_0 1_-8; do
  run 0 "$feltline" fit "$kind.ndjson" -o timed.ndjson
  lines err 1
  has err "feltline: $kind.ndjson: line 1: stroke 'k1' has times that are not milliseconds"
  has err "and 2 more like it"
  awk -v a="$(widest timed.ndjson)" -v b="$(widest good.ndjson)" 'BEGIN { exit !(a > 0.9 * b && a < 1.1 * b) }' ||
    fail "$kind: the widest is $(widest timed.ndjson) and not $(widest good.ndjson)"
done
for command in "fit 1023_8.ndjson -o x.svg" "convert 1023_8.ndjson -o x.svg" "convert 1023_8.ndjson -o x.felt"; do
  # shellcheck disable=SC2086  # must be split into words
  run 0 "$feltline" $command
  lines err 1
  has err "feltline: 1023_8.ndjson: line 1: stroke 'k1' (40 of 40 pressures, for example 9"
  has err "divide them by the largest pressure of the pen (and 2 more like it)"
done
