# Malicious input must give an error or a valid stroke, in bounded time and memory.
. "$(dirname "$0")/helpers.sh"

good='{"id":"good","points":[[0,0],[5,5]]}'
# feed SECONDS KIB CODE OPTIONS...: fits stdin with limits of time and memory, and checks the exit code.
feed() {
  local seconds=$1 kib=$2
  shift 2
  run "$1" limit_memory "$kib" timeout "$seconds" "$feltline" fit - -o - "${@:2}"
}

# Empty input, NUL bytes and binary data.
feed 20 500000 1 </dev/null
head -c 1000000 /dev/zero >zeros
feed 20 500000 1 <zeros
has err "is NUL"
# The program file contains scripts as text. It is compressed here because fit would find their strokes.
gzip -c "$feltline" | head -c 3000000 >binary
feed 20 500000 1 <binary
is_empty out

# A number of 10^9 digits exceeds the maximum length of a line; one of 10^7 digits exceeds the maximum
# length of a number.
digits() { head -c "$1" /dev/zero | tr '\0' '7'; }
feed 120 2500000 1 --no-refine < <(printf '{"points":[[' && digits 1000000000 && printf ',1]]}\n%s\n' "$good")
has err "stdin:1: the line is longer than 512 MiB"
has out '"id":"good"'
feed 20 1000000 1 < <(printf '{"points":[[' && digits 10000000 && printf ',1]]}\n%s\n' "$good")
has err "stdin:1: points[0]: x: number of 10000000 characters, at most 64 allowed"
has out '"id":"good"'

# Endless devices, and pipes that no process writes to, given as files.
mkfifo pipe
for endless in /dev/zero /dev/urandom; do
  echo "{\"t_ms\":0,\"event\":\"import\",\"path\":\"$endless\"}" >import.ndjson
  for command in "convert $endless -o x.felt" "info $endless" "fit $endless -o x.felt" \
    "replay $endless -o x.felt" "replay good.ndjson --on $endless -o x.felt" \
    "materials check $endless" "replay import.ndjson -o x.felt"; do
    echo "$good" >good.ndjson
    # shellcheck disable=SC2086  # must be split into words
    run 1 timeout 20 "$feltline" $command
    lines err 1
    has err "$endless: not a regular file"
  done
done
echo '{"t_ms":0,"event":"import","path":"pipe"}' >import.ndjson
for command in "replay import.ndjson -o x.felt" "materials check pipe"; do
  # shellcheck disable=SC2086  # must be split into words
  run 1 timeout 20 "$feltline" $command
  has err "pipe: not a regular file"
done
# Pipes that a process writes to are valid inputs.
run 0 timeout 20 "$feltline" fit <(echo "$good") -o -
run 0 timeout 20 bash -c "cat good.ndjson | '$feltline' fit /dev/stdin -o -"
"$feltline" fit good.ndjson -o piped.felt
run 0 timeout 20 "$feltline" replay <(echo "$good") --on <(cat piped.felt) -o x.felt
rm -f x.felt

# 10,000 layers, the maximum of a drawing, each added by its own event. The limit is CPU time, so a busy
# machine does not matter.
awk 'BEGIN { for (i = 0; i < 9999; i++) print "{\"t_ms\":" i ",\"event\":\"layer\",\"do\":\"add\"}" }' >layers.ndjson
if [ -z "${FELT_SANITIZE:-}" ]; then
  run 0 bash -c "ulimit -t 60; '$feltline' replay layers.ndjson -o layers.felt"
fi

# A path with more segments than a stroke in a file may have.
{
  echo '<svg xmlns="http://www.w3.org/2000/svg"><path fill="none" stroke="red" d="M0 0'
  awk 'BEGIN { for (i = 1; i <= 1000100; i++) print "L" i % 1000 " " i % 7 * 5 }'
  echo '"/></svg>'
} >long.svg
run 0 "$feltline" convert long.svg -o long.felt
has err "more than 250000 segments and was split into several strokes"
run 0 "$feltline" info long.felt
rm -f long.*

# Style variables that refer to each other and expand to 30^7 empty texts.
{
  echo '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0L9 9" fill="none" stroke="var(--a)" style="'
  for pair in a:b b:c c:d d:e e:f f:g 'g:z,'; do
    printf -- '--%s:' "${pair%:*}"
    for _ in {1..30}; do printf 'var(--%s)' "${pair#*:}"; done
    printf ';'
  done
  echo '"/></svg>'
} >variables.svg
run 0 timeout 20 "$feltline" convert variables.svg -o variables.felt
has err "has a stroke that could not be read, and became black"
rm variables.*

# A file larger than the maximum of a drawing is refused because of its size, before it is read.
printf 'SQLite format 3\0' >large.felt
truncate -s 2200M large.felt
run 1 limit_memory 1000000 "$feltline" info large.felt
has err "large.felt: is larger than 2147483648 bytes"
truncate -s 1500M large.felt
run 1 limit_memory 1000000 "$feltline" info large.felt
has err "large.felt: is a database of another program, not a Feltline drawing"
echo '<svg xmlns="http://www.w3.org/2000/svg">' >large.svg
truncate -s 1000M large.svg
if [ -z "${FELT_SANITIZE:-}" ]; then
  for command in "info large.svg" "convert large.svg -o x.felt"; do
    # shellcheck disable=SC2086  # must be split into words
    run 1 limit_memory 800000 "$feltline" $command
    has err "feltline: large.svg: not enough memory to read it"
  done
fi
rm large.felt large.svg
run 1 bash -c "ulimit -f 1; '$feltline' fit - -o big.felt" < <(strokes 50)
has err "cannot write: File too large"

# Ten million nested arrays.
feed 20 1000000 1 < <(printf '{"x":' && head -c 10000000 /dev/zero | tr '\0' '[' && printf '\n%s\n' "$good")
lines err 1
has out '"id":"good"'

# A stroke of ten million samples, first back and forth, then all at one position. With a sanitizer it
# has one million, because ten million would take minutes.
quarter=2500000
[ -z "${FELT_SANITIZE:-}" ] || quarter=250000
feed 250 8000000 0 --no-refine < <(
  printf '{"points":[' && yes '[0,0],[9.5,1,0.5],[19,2],[9.5,3,0.25,8],' | head -n $quarter |
    tr -d '\n'; printf '[0,0]]}\n'
)
lines out 1
feed 250 8000000 0 --no-refine < <(
  printf '{"points":[' && yes '[7,7],[7,7],[7,7],[7,7],' | head -n $quarter | tr -d '\n'
  printf '[7,7]]}\n'
)
lines out 1

# Samples that no real movement can give.
while read -r points; do
  feed 20 500000 0 < <(printf '{"points":%s}\n' "$points")
  lines out 1
  mv out sketch
  run 0 "$feltline" convert - -o - <sketch
  same out sketch
done <<'END'
[[1,2]]
[[1e9,1e9]]
[[1,2],[1,2]]
[[1,2],[1,2],[1,2],[1,2],[1,2],[1,2],[1,2],[1,2]]
[[0,0],[1e-300,0],[0,1e-300]]
[[0,0],[1e9,1e9],[-1e9,1e9],[0,0]]
[[0,0,0.5,100],[1,1,0.5,50],[2,0,0.5,0],[3,1,0.5,-50]]
[[0,0,0.5,0],[1,1,0.5,0],[2,0,0.5,0]]
[[0,0,null,9e12],[1,1,null,-9e12],[2,2,null,9e12]]
[[0,0,0],[1,0,0],[2,0,0]]
[[0,0,1],[5,0,0],[5,0,1],[9,0,0]]
[[0,0],[10,0],[0,0],[10,0],[0,0]]
[[0,0,5,0],[1,1,-5,1]]
END
for word in NaN Infinity -Infinity nan 1e999 null true '"1"' 0x1 '1,2,3,,'; do
  feed 20 500000 1 < <(printf '{"points":[[0,0],[%s,0]]}\n%s\n' "$word" "$good")
  lines out 1
  lines err 1
done
