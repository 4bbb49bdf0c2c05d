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
finish
