# The paper, reproduced: the figures are pictures, the numbers of the table are right, and nothing is
# overwritten.
here=$(cd "$(dirname "$0")" && pwd)
. "$(dirname "$0")/helpers.sh"

SECONDS=0
run 0 "$feltline" paper -o one
[ "$SECONDS" -lt 60 ] || [ -n "${FELT_SANITIZE:-}" ] || fail "took $SECONDS s"
has out "In one: equations.md, figure-1.svg"
is_empty err
run 0 "$feltline" paper -o two/below --law felt
run 0 "$feltline" paper -o printed --law paper
[ "$(find one -type f | wc -l)" = 9 ] || fail "other files than nine: $(ls one)"
for file in one/*; do
  same "$file" "two/below/${file#one/}"
done
for number in 1 2 3 4; do
  [ "$(head -c 4 "one/figure-$number.png" | tail -c 3)" = PNG ] || fail "figure-$number.png is not a PNG"
  if command -v xmllint >/dev/null; then
    run 0 xmllint --noout "one/figure-$number.svg"
  fi
  if command -v rsvg-convert >/dev/null; then
    run 0 rsvg-convert "one/figure-$number.svg" -o viewed.png
  fi
  has one/equations.md "![Figure $number](figure-$number.svg)"
done
has one/figure-3.svg "lines hold it"
# The forces of the figures follow --law, the table does not.
has printed/equations.md 'as printed (`--law paper`)'
cmp -s one/figure-4.svg printed/figure-4.svg && fail "the law changes nothing"
same <(sed -n '/^## Equation (2)/,$p' one/equations.md) <(sed -n '/^## Equation (2)/,$p' printed/equations.md)

# The numbers, computed again from the text of the paper and the errata.
for folder in one printed; do
  run 0 python3 "$here/paper_numbers.py" "$folder/equations.md"
done
sed 's/| 5 | 0.4667 | 0.4667 |/| 5 | 0.4667 | 0.4567 |/' one/equations.md >wrong.md
run 1 python3 "$here/paper_numbers.py" wrong.md

# Nothing is overwritten, and nothing is left half-written.
cp -r one before
run 1 "$feltline" paper -o one
has err "feltline: one: exists and is not empty; nothing was written"
diff -r one before >/dev/null || fail "a second run changed the folder"
run 1 "$feltline" paper -o /proc/nowhere
has err "feltline: /proc/nowhere"
echo >file
run 1 "$feltline" paper -o file
has err "feltline: file"
same file <(echo)
mkdir full
run 1 bash -c 'ulimit -f 20; trap "" XFSZ; "$1" paper -o full' - "$feltline"
has err "feltline: full/figure-"
[ -z "$(ls -A full)" ] || fail "left behind: $(ls -A full)"
run 2 "$feltline" paper
run 2 "$feltline" paper -o x --law nonsense
[ ! -e x ] || fail "a wrong command line made a folder"

# The forces as printed can be felt in any script: the jump of 0.2 N at the grab of a line.
strokes 1 >in.ndjson
run 0 "$feltline" fit in.ndjson -o line.ndjson
run 0 "$feltline" info line.ndjson
cat >pull.ndjson <<'END'
{"event":"tool","t_ms":0,"id":"pull"}
{"event":"hand","t_ms":0,"x":7,"y":4,"z":5}
{"event":"hand","t_ms":900,"x":7,"y":4,"z":-2}
{"event":"hand","t_ms":1500,"x":7,"y":4.5,"z":-2}
{"event":"hand","t_ms":2000,"x":7,"y":4.5,"z":-2}
END
for law in felt paper; do
  run 0 "$feltline" replay pull.ndjson --on line.ndjson --device worst --set "surface.law=$law" --forces "$law.csv"
done
largest() { awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "edit_y") k = i; next }
  { a = $k < 0 ? -$k : $k; if (a > m) m = a } END { print (m >= 0.2) ? "jumps" : "rises" }' "$1"; }
[ "$(largest felt.csv)" = rises ] || fail "the force of 'felt' jumps"
[ "$(largest paper.csv)" = jumps ] || fail "the force of 'paper' does not jump"
