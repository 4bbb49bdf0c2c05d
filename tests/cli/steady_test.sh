# feltline steady: measures a shaking, and fit --steady removes it.
. "$(dirname "$0")/helpers.sh"

# spiral MM SECONDS [STEP_MS]: prints a spiral of a hand that shakes by MM along x, 5.5 times a second.
spiral() {
  awk -v mm="$1" -v seconds="$2" -v step="${3:-7.5}" 'BEGIN {
    printf "{\"id\":\"spiral\",\"points\":["
    for (t = 0; t < 1000 * seconds; t += step) {
      s = t / 1000; a = 2 * 3.14159265 * 0.5 * s
      printf "%s[%.3f,%.3f,0.5,%.1f]", t ? "," : "", 60 + 4 * s * cos(a) + mm * sin(2 * 3.14159265 * 5.5 * s),
             60 + 4 * s * sin(a), t
    }
    print "]}"
  }'
}

# shaky MM: prints a straight line along y over 3 s, shaken by MM along x.
shaky() {
  awk -v mm="$1" 'BEGIN {
    printf "{\"id\":\"line\",\"points\":["
    for (t = 0; t < 3000; t += 7.5) {
      printf "%s[%.3f,%.3f,0.5,%.1f]", t ? "," : "", 50 + mm * sin(2 * 3.14159265 * 5.5 * t / 1000), t / 50, t
    }
    print "]}"
  }'
}

spiral 1.2 10 >spiral.ndjson
run 0 "$feltline" steady calibrate spiral.ndjson -o hand.steady
is_empty out
has err "shakes 5."
has err "times a second, by 1."
has hand.steady "hz = 5."
has hand.steady "amplitude_mm = 1."
# Without -o the same text goes to stdout; with --quiet nothing else is printed.
run 0 "$feltline" -q steady calibrate spiral.ndjson
same out hand.steady
is_empty err
run 0 "$feltline" -q steady calibrate - <spiral.ndjson
same out hand.steady

# A recording gives the same: its samples in contact.
awk -F'[][]' '{ n = 0
  for (i = 1; i <= NF; i++) if (split($i, p, ",") == 4) {
    printf "{\"event\":\"pen\",\"t_ms\":%s,\"x\":%s,\"y\":%s,\"z\":0,\"pressure\":%s}\n", p[4], p[1], p[2], p[3]
  } }' spiral.ndjson >recording.ndjson
run 0 "$feltline" -q steady calibrate recording.ndjson
same out hand.steady

# Clear refusals: a steady hand, too little, no times, no file, other content.
spiral 0 10 >calm.ndjson
run 1 "$feltline" steady calibrate calm.ndjson -o none.steady
has err "no shaking was found"
[ ! -e none.steady ] || fail "a file was written"
spiral 1.2 2 >short.ndjson
run 1 "$feltline" steady calibrate short.ndjson
has err "too short"
spiral 1.2 10 50 >rare.ndjson
run 1 "$feltline" steady calibrate rare.ndjson
has err "too few samples"
echo '{"points":[[1,2],[2,3],[3,4]]}' >timeless.ndjson
run 1 "$feltline" steady calibrate timeless.ndjson
has err "have no times"
run 1 "$feltline" steady calibrate missing.ndjson
has err "missing.ndjson"
echo 'no json' >text.ndjson
run 1 "$feltline" steady calibrate text.ndjson
run 2 "$feltline" steady

# The line is straight again, by the file and by numbers; without the option the bytes stay.
shaky 1.2 >line.ndjson
run 0 "$feltline" fit line.ndjson -o raw.ndjson
run 0 "$feltline" fit line.ndjson --steady hand.steady -o calm1.ndjson
run 0 "$feltline" fit line.ndjson --steady 5.5,1.2,0 -o calm2.ndjson
run 0 "$feltline" fit line.ndjson -j 2 --steady 5.5,1.2,0 -o calm3.ndjson
same calm2.ndjson calm3.ndjson
segments() { grep -o '\],\[' "$1" | wc -l; }
[ "$(segments calm1.ndjson)" -lt "$(segments raw.ndjson)" ] || fail "the calm line is not simpler"
[ "$(segments calm2.ndjson)" -lt "$(segments raw.ndjson)" ] || fail "the calm line is not simpler"
# A hand that does not shake draws the same line, byte for byte.
shaky 0 >still.ndjson
run 0 "$feltline" fit still.ndjson -o still1.ndjson
run 0 "$feltline" fit still.ndjson --steady hand.steady -o still2.ndjson
same still1.ndjson still2.ndjson

run 2 "$feltline" fit line.ndjson --steady 50,1,0 -o x.ndjson
has err "hz"
run 2 "$feltline" fit line.ndjson --steady missing.steady -o x.ndjson
has err "missing.steady"

# The pencil has it too, so replay and recordings do.
run 0 "$feltline" replay line.ndjson --set pencil.steady=true --set pencil.steady_hz=5.5 \
  --set pencil.steady_mm=1.2 --device tablet -o drawn.ndjson
run 0 "$feltline" replay line.ndjson --device tablet -o shaken.ndjson
[ "$(segments drawn.ndjson)" -lt "$(segments shaken.ndjson)" ] || fail "replay did not calm the line"
