# feltline check --tactile: the faults of a raised drawing.
. "$(dirname "$0")/helpers.sh"

# line Y LENGTH: prints a raw stroke.
line() {
  printf '{"points":[[20,%s],[%s,%s]]}\n' "$1" "$(($2 + 20))" "$1"
}

{ line 20 60; line 40 60; } >good.ndjson
run 0 "$feltline" check --tactile good.ndjson
has out "good.ndjson: no faults"
is_empty err

{ line 20 60; line 27 60; line 60 5; } >bad.ndjson
run 1 "$feltline" check --tactile bad.ndjson
has out ",23.5: gap: 5.8 mm between lines, for 60 mm"
has out "small-shape: a shape of "
lines out 2
is_empty err
run 1 "$feltline" check --tactile --embossed bad.ndjson
lines out 1

run 1 "$feltline" check --tactile --csv bad.ndjson
has out "rule,x_mm,y_mm,measured,limit,length_mm,stroke,other"
lines out 3
awk -F, 'NF != 8 { exit 1 }' out || fail "rows of different lengths"
run 1 "$feltline" check --tactile - <bad.ndjson
has out "small-shape"
run 0 "$feltline" check --tactile --csv good.ndjson
lines out 1

# Errors name the file.
run 1 "$feltline" check --tactile absent.svg
has err "absent.svg"
printf '{"points":[[20,20],[1e300,20]]}\n' >huge.ndjson
run 1 "$feltline" check --tactile huge.ndjson
has err "huge.ndjson"
line 20 900000 >long.ndjson
run 1 "$feltline" check --tactile long.ndjson
has err "long.ndjson: the lines are longer than 100 m"
: >empty.ndjson
run 0 "$feltline" check --tactile empty.ndjson
run 2 "$feltline" check good.ndjson
run 2 "$feltline" check --tactile

finish
