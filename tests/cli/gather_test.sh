# feltline gather: bundles of rough strokes become one line each.
. "$(dirname "$0")/helpers.sh"

# bundle Y COUNT: prints COUNT raw strokes of 100 mm beside each other, half a millimetre apart.
bundle() {
  awk -v y="$1" -v count="$2" 'BEGIN {
    for (s = 0; s < count; s++) {
      printf "{\"points\":["
      for (i = 0; i <= 50; i++) printf "%s[%.2f,%.2f]", i ? "," : "", 2 * i, y + s * 0.5 + 4 * sin(i / 12)
      print "]}"
    }
  }'
}

{ bundle 20 4; bundle 60 3; bundle 100 1; } >rough.ndjson
run 0 "$feltline" gather --all rough.ndjson -o clean.ndjson --groups groups.csv
has err "8 strokes became 3 lines"
lines err 1
run 0 "$feltline" gather --strict --all rough.ndjson -o strict.ndjson
same strict.ndjson clean.ndjson
lines clean.ndjson 3
cat >wanted.csv <<'END'
stroke,group
s1,1
s2,1
s3,1
s4,1
s5,2
s6,2
s7,2
s8,3
END
same groups.csv wanted.csv

# Strokes keep the names of their file, through every format. A line has the name of its lowest stroke.
awk '{ print "{\"id\":\"cat-" NR (NR == 2 ? "" : "&<") "\"," substr($0, 2) }' rough.ndjson >named.ndjson
names_of() { grep -o '"id":"[^"]*"' "$1" | cut -d'"' -f4 | tr '\n' ' '; }
run 0 "$feltline" gather --all named.ndjson -o named_clean.ndjson --groups named.csv
[ "$(names_of named_clean.ndjson)" = 'cat-1&< cat-5&< cat-8&< ' ] || fail "names: $(names_of named_clean.ndjson)"
grep -q '^cat-2,1$' named.csv || fail "the groups have other names"
# Names that need quotes in .csv (RFC 4180), and one that a spreadsheet would compute.
printf '%s\n' '"a,b"' '"say \"hi\""' '"two\nlines"' '"=1+1"' '"-3"' '"plain"' '"\u00fc"' '"s8"' >ids
paste -d ' ' ids rough.ndjson | sed -E 's/^("([^"\\]|\\.)*") \{/{"id":\1,/' >quoted.ndjson
run 0 "$feltline" gather --all quoted.ndjson -o quoted.felt --groups quoted.csv
printf '%s\n' stroke,group '"a,b",1' '"say ""hi""",1' '"two' 'lines",1' "'=1+1,1" -3,2 plain,2 ü,2 s8,3 >quoted_wanted.csv
same quoted.csv quoted_wanted.csv
run 0 "$feltline" fit named.ndjson -o named_fit.ndjson
for format in felt svg svgz inkml ndjson; do
  run 0 "$feltline" convert named.ndjson -o "named.$format.$format"
  run 0 "$feltline" convert "named.$format.$format" -o named_back.ndjson
  same named_back.ndjson named_fit.ndjson
  run 0 "$feltline" convert "named.$format.$format" -o named_back.ndjson --layers visible
  same named_back.ndjson named_fit.ndjson
  run 0 "$feltline" gather --all "named.$format.$format" -o named_again.ndjson
  same named_again.ndjson named_clean.ndjson
done
# A drawing on which a script draws more keeps them, too, and its new strokes get other names.
printf '{"t_ms":%d,"event":"pen","x":%d,"y":9,"z":%d}\n' 0 5 5 100 5 -1 200 60 -1 300 60 5 >more.ndjson
run 0 "$feltline" replay more.ndjson --on named.felt.felt -o more.felt
run 0 "$feltline" convert more.felt -o more_lines.ndjson
[ "$(names_of more_lines.ndjson)" = "$(names_of named_fit.ndjson)s9 " ] || fail "names: $(names_of more_lines.ndjson)"
printf '{"t_ms":400,"event":"undo"}\n' | cat more.ndjson - >undone.ndjson
run 0 "$feltline" replay undone.ndjson --on named.felt.felt -o undone.felt
run 0 "$feltline" convert undone.felt -o more_lines.ndjson
same more_lines.ndjson named_fit.ndjson
# Paths of other programs, too.
echo '<svg xmlns="http://www.w3.org/2000/svg"><path id="tail" d="M5 5L90 5" stroke="#000" fill="none"/></svg>' >other.svg
run 0 "$feltline" gather --all other.svg -o other.ndjson
[ "$(names_of other.ndjson)" = 'tail ' ] || fail "the id of a path is lost"

# A sketch gives the same groups as the raw strokes that it was fitted to; every time the same bytes.
run 0 "$feltline" fit rough.ndjson -o sketch.svg
run 0 "$feltline" gather --all sketch.svg -o a.felt --groups a.csv
same a.csv wanted.csv
run 0 "$feltline" gather --all sketch.svg -o b.ndjson
run 0 "$feltline" gather --all sketch.svg -o c.ndjson
same b.ndjson c.ndjson
run 0 "$feltline" info a.felt
has out "strokes"

# The width of the strip.
run 0 "$feltline" gather --all rough.ndjson -o wide.ndjson --width strip
cmp -s wide.ndjson clean.ndjson && fail "--width strip changes nothing"
run 0 "$feltline" gather --all - -o - --to ndjson <rough.ndjson
same out clean.ndjson

# Strokes of locked and hidden layers stay as they are, with a message.
for how in lock hide; do
  awk -v how="$how" 'BEGIN {
    for (s = 0; s < 3; s++) {
      t = 1000 * s
      split("5 -1 -1 5", z); split("20 20 100 100", x)
      for (i = 1; i <= 4; i++)
        printf "{\"t_ms\":%d,\"event\":\"pen\",\"x\":%d,\"y\":%.1f,\"z\":%d}\n", t + 200 * i, x[i], 40 + s, z[i]
    }
    printf "{\"t_ms\":4000,\"event\":\"layer\",\"do\":\"%s\",\"id\":1}\n", how
  }' >events.ndjson
  run 0 "$feltline" replay events.ndjson -o layers.felt
  run 0 "$feltline" gather --all layers.felt -o left.felt --groups left.csv
  has err "left 3 strokes of locked or hidden layers as they are"
  [ "$(cat left.csv)" = "stroke,group" ] || fail "strokes of a layer to $how are in groups"
  run 0 "$feltline" info left.felt
  has out "3 strokes"
done

# Errors: nothing is written, and an existing file stays.
run 2 "$feltline" gather rough.ndjson -o x.svg
run 2 "$feltline" gather --all rough.ndjson
run 2 "$feltline" gather --all rough.ndjson -o rough.ndjson
run 2 "$feltline" gather --all rough.ndjson -o x.svg --groups rough.ndjson
run 2 "$feltline" gather --all rough.ndjson -o - --to svg --groups -
run 2 "$feltline" gather --all rough.ndjson -o x.unknown
run 2 "$feltline" gather --all rough.ndjson -o x.svg --width thick
run 1 "$feltline" gather --all missing.ndjson -o x.svg
has err "missing.ndjson"
: >empty.ndjson
run 1 "$feltline" gather --all empty.ndjson -o x.svg
[ ! -e x.svg ] || fail "an error made x.svg"
run 1 "$feltline" gather --all rough.ndjson -o x.svg --groups missing/groups.csv
has err "missing/groups.csv"
