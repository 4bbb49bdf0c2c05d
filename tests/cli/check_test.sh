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
lines err 1
has err "bad.ndjson: enlarge "
has err " times: then all 2 faults go"
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

# Ink that is not seen is not checked, thin lines are.
cat >faint.svg <<'END'
<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="200mm" viewBox="0 0 200 200">
<rect width="500" height="500" fill="#fff"/>
<path d="M20 20H80" stroke="#fff" stroke-width="1"/>
<path d="M20 23H80" stroke="#000" stroke-opacity="0.02" stroke-width="1"/>
<path d="M20 26H80" stroke="#000" stroke-width="1"/>
</svg>
END
run 0 "$feltline" check --tactile faint.svg
has out "faint.svg: no faults"
has err "2 lines are too faint to see on this paper and will not be raised"
has err "1 area is too faint to see on this paper and will not be raised"
sed 's/#000" stroke-width="1"/#000" stroke-width="0.05"/' faint.svg >thin.svg
run 1 "$feltline" check --tactile thin.svg
has out "thin-line: a line or dot 0.05 mm wide; at least 0.5 mm"
has err "enlarge 10.0 times: then the fault goes; the drawing is then 600 x 0 mm, more than A4"

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

# The trips that draw flat ends and pointed corners are no lines, in a check or in a conversion.
cat >flat.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="200mm" viewBox="0 0 200 200">
<g fill="none" stroke="#000" stroke-width="6"><path d="M20 20H80"/><path d="M20 60L50 45L80 60"/>
<path d="M20 90H80V140H20Z"/></g></svg>
SVG
run 0 "$feltline" check --tactile flat.svg
has out "flat.svg: no faults"
run 0 "$feltline" convert flat.svg -o flat.inkml
is_empty err
sed -i 's/felt:points/felt:else/' flat.inkml  # as another program sees it
for to in ndjson xopp inkml; do
  [ $to = inkml ] || run 0 "$feltline" convert flat.svg -o "flat.$to"
  [ $to = inkml ] || has err "flat.$to: 3 strokes with flat ends or pointed corners became round"
  run 0 "$feltline" convert "flat.$to" -o - --to ndjson
  [ "$(python3 -c 'import json
sizes = [len(json.loads(line)["segments"]) for line in open("out")]
print(sizes[0], len(sizes), sizes[-1])')" = "1 3 4" ] || fail "$to: $(head -c 300 out)"
done
run 0 "$feltline" convert flat.ndjson -o again.xopp
is_empty err
