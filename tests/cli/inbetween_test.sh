# feltline inbetween: drawings between key drawings, as numbered files or one animated SVG.
. "$(dirname "$0")/helpers.sh"

# key SHIFT COUNT: prints COUNT raw strokes, moved to the right.
key() {
  awk -v shift="$1" -v count="$2" 'BEGIN {
    for (s = 0; s < count; s++) {
      printf "{\"points\":["
      for (i = 0; i <= 40; i++) printf "%s[%.2f,%.2f]", i ? "," : "", shift + i, 20 + 15 * s + 3 * sin(i / (4 + s))
      print "]}"
    }
  }'
}
key 10 3 | "$feltline" fit - -o a.svg 2>err || fail "fit"
key 50 3 | "$feltline" fit - -o b.svg 2>err || fail "fit"
key 50 2 | "$feltline" fit - -o two.svg 2>err || fail "fit"
printf '' | "$feltline" convert - -o none.felt 2>err || true

# Numbered files in several formats, with and without the keys.
run 0 "$feltline" inbetween a.svg b.svg -o walk-%03d.svg --frames 3 --matches matches.csv
is_empty err
[ "$(echo walk-*)" = "walk-001.svg walk-002.svg walk-003.svg" ] || fail "files: $(echo walk-*)"
lines matches.csv 4
has matches.csv "1,s1,s1,0.000,1.000,0.000,1.000,0,"
run 0 "$feltline" info walk-002.svg
has out "3 strokes"
run 0 "$feltline" inbetween a.svg b.svg -o all-%d.ndjson --frames 1 --keys
run 0 "$feltline" convert a.svg -o first.ndjson
run 0 "$feltline" convert all-1.ndjson -o again.ndjson
same again.ndjson first.ndjson
[ "$(grep -c segments all-2.ndjson)" = 3 ] || fail "strokes in all-2.ndjson"
mkdir folder
run 0 "$feltline" inbetween a.svg b.svg a.svg -o folder --frames 2 --to png --dpi 40
[ "$(find folder -name 'inbetween-00[1-4].png' | wc -l)" = 4 ] || fail "folder: $(ls folder)"

# Half of the way after half of the time; later with an ease.
x_of() { "$feltline" convert "$1" -o - --to ndjson | grep -m 1 segments | sed 's/.*"segments":\[\[\([0-9.]*\),.*/\1/'; }
near() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a - b < 0.6 && b - a < 0.6) }' || fail "$1 is not $2"; }
near "$(x_of walk-002.svg)" 30
run 0 "$feltline" inbetween a.svg b.svg -o ease-%d.svg --frames 1 --ease ease-in
near "$(x_of ease-1.svg)" 22.6
printf '{"points":[[0,100],[10,60],[20,20],[60,10],[100,0]]}' >curve.ndjson
run 0 "$feltline" inbetween a.svg b.svg -o curve-%d.svg --frames 1 --ease curve.ndjson
near "$(x_of curve-1.svg)" 45

# One animated file: every picture once, the same bytes every time.
run 0 "$feltline" inbetween a.svg b.svg -o film.svg --frames 6 --hold 3 --fps 12
run 0 "$feltline" inbetween a.svg b.svg -o film2.svg --frames 6 --hold 3 --fps 12
same film.svg film2.svg
[ "$(grep -c '<animate ' film.svg)" = 8 ] || fail "$(grep -c '<animate ' film.svg) pictures"
has film.svg 'dur="1s"'
run 0 "$feltline" inbetween a.svg b.svg -o - --to svg --frames 6 --hold 3 --fps 12
same out film.svg

# A stroke without partner, given pairs, and drawings without strokes.
run 0 "$feltline" inbetween a.svg two.svg -o lone-%d.svg --frames 1 --matches lone.csv
has lone.csv ",none,"
run 0 "$feltline" inbetween a.svg b.svg -o pair-%d.svg --pair 1:3 --pair 3:none --matches pair.csv
has pair.csv "1,s1,s3,"
has pair.csv "1,s3,none,"
run 0 "$feltline" inbetween a.svg b.svg a.svg -o pair-%d.svg --pair 2:s1:s2 --matches pair.csv
has pair.csv "2,s1,s2,"
if [ -e none.felt ]; then
  run 0 "$feltline" inbetween none.felt b.svg -o born-%d.svg --frames 2 --lone grow
  run 0 "$feltline" info born-2.svg
  has out "3 strokes"
fi

# The layers of one drawing are key drawings, with the timings and pairs that are in it.
timed() {
  cat <<'END'
{"t_ms":0,"event":"import","path":"a.svg"}
{"t_ms":0,"event":"layer","do":"add"}
{"t_ms":0,"event":"import","path":"b.svg"}
{"t_ms":0,"event":"layer","do":"add"}
{"t_ms":0,"event":"import","path":"a.svg"}
{"t_ms":0,"event":"timing","ids":[1],"between":2,"hold":5,"ease":[0.42,0,1,1],"pairs":[[1,6],[3,0]]}
{"t_ms":0,"event":"timing","ids":[2],"between":4}
END
}
timed >timed.ndjson
run 0 "$feltline" replay timed.ndjson -o timed.felt
run 0 "$feltline" inbetween timed.felt -o layers-%d.svg --keys --matches layers.csv
[ "$(find . -name 'layers-*.svg' | wc -l)" = 9 ] || fail "3 keys and 2 + 4 in-betweens: $(echo layers-*)"
has layers.csv "1,s1,s6,"
has layers.csv "1,s3,none,"
run 0 "$feltline" inbetween timed.felt -o layers.svg --fps 24
[ "$(grep -c '<animate ' layers.svg)" = 9 ] || fail "$(grep -c '<animate ' layers.svg) pictures"
has layers.svg 'dur="0.54'
run 0 "$feltline" inbetween timed.felt -o layers.svg --frames 1 --hold 2 --pair 1:5 --matches layers.csv
[ "$(grep -c '<animate ' layers.svg)" = 5 ] || fail "options come first: $(grep -c '<animate ' layers.svg) pictures"
has layers.csv "1,s1,s5,"
has layers.csv "1,s3,none,"
{ timed; printf '%s\n' '{"t_ms":0,"event":"timing","ids":[1,2],"between":0}'; } >still.ndjson
run 0 "$feltline" replay still.ndjson -o still.felt
run 1 "$feltline" inbetween still.felt -o still-%d.svg
has err "--keys writes the key drawings"
run 0 "$feltline" inbetween still.felt -o still-%d.svg --keys
[ "$(find . -name 'still-*.svg' | wc -l)" = 3 ] || fail "3 keys: $(echo still-*)"
run 2 "$feltline" inbetween timed.felt -o timed.felt --to svg
run 1 "$feltline" inbetween a.svg -o x-%d.svg
has err "a.svg: has fewer than two key drawings"

# Errors: nothing is written.
run 2 "$feltline" inbetween a.svg b.svg
run 2 "$feltline" inbetween a.svg b.svg -o x.png
has err "numbered files"
run 2 "$feltline" inbetween a.svg b.svg -o a.svg
run 2 "$feltline" inbetween a.svg b.svg -o x-%d.svg --frames 0
run 2 "$feltline" inbetween a.svg b.svg -o x-%d.svg --ease bouncy
has err "bouncy"
run 2 "$feltline" inbetween a.svg b.svg -o x-%d.svg --pair 3
run 1 "$feltline" inbetween a.svg b.svg -o x-%d.svg --pair 9:1
has err "no visible stroke '9'"
run 1 "$feltline" inbetween a.svg b.svg -o x-%d.svg --pair 2:1:1
run 1 "$feltline" inbetween a.svg b.svg -o x-%d.svg --pair 1:1 --pair 1:2
run 1 "$feltline" inbetween a.svg missing.svg -o x-%d.svg
has err "missing.svg"
[ ! -e x-1.svg ] || fail "an error made x-1.svg"

# Nothing that is read is overwritten, and nothing is written if a later argument is wrong.
mkdir kept && cp a.svg kept/k-001.svg && cp b.svg kept/k-002.svg && cp a.svg kept/ease.svg && cp -r kept before
run 2 "$feltline" inbetween kept/k-001.svg kept/k-002.svg -o kept/k-%03d.svg --frames 2
has err "would overwrite the input"
run 2 "$feltline" inbetween a.svg b.svg -o kept/ease.svg --ease kept/ease.svg
run 2 "$feltline" inbetween a.svg b.svg -o kept/f-%03d.svg --frames 1 --matches kept/f-001.svg
has err "are the same file"
run 1 "$feltline" inbetween a.svg b.svg a.svg -o kept/ --frames 1 --pair 2:99999:none
run 1 "$feltline" inbetween a.svg b.svg -o kept/x-%d.svg --frames 1 --pair 18446744073709551615:1:1
run 1 "$feltline" inbetween a.svg b.svg -o kept/x-%d.svg --frames 1 --matches none/m.csv
diff -r kept before || fail "files changed"
mkdir of%d
run 0 "$feltline" inbetween a.svg b.svg -o of%d/ --frames 1
[ -s of%d/inbetween-001.svg ] || fail "a folder with a % in its name"
