# Drawings: reading and writing .felt, reading .svg, writing .pdf.
. "$(dirname "$0")/helpers.sh"

strokes 20 >in.ndjson
run 0 "$feltline" fit in.ndjson -o a.ndjson
sed 's/"id":"[^"]*"/"id":"x"/' a.ndjson >plain.ndjson
nameless() { sed 's/"id":"[^"]*"/"id":"x"/' "$1" >"$1.plain"; same "$1.plain" plain.ndjson; }

# Converting to .felt and back changes only the ids of the strokes, because they are numbers in .felt.
run 0 "$feltline" convert a.ndjson -o a.felt --page A5-landscape
run 0 "$feltline" convert a.felt -o b.ndjson
nameless b.ndjson
[ "$(head -c 15 a.felt)" = "SQLite format 3" ] || fail "not a database"
[ "$(find . -maxdepth 1 -name "*felt*" | wc -l)" = 1 ] || fail "files beside a.felt: $(ls -A)"
run 0 "$feltline" fit in.ndjson -o fitted.felt --page A5-landscape --jobs 2
same fitted.felt a.felt
run 0 "$feltline" convert a.felt -o copy.felt
same copy.felt a.felt
run 0 "$feltline" convert a.ndjson -o - --to felt --page A5-landscape
same out a.felt

# Our own .svg files are read back exactly. From other .svg files, only content that ink can represent
# is read, and a message names the rest.
run 0 "$feltline" convert a.ndjson -o a.svg
run 0 "$feltline" convert a.svg -o c.ndjson
same c.ndjson a.ndjson
echo '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1 1"><text>a</text></svg>' >other.svg
run 1 "$feltline" convert other.svg -o d.ndjson
has err "feltline: other.svg: line 1: text"
has err "feltline: other.svg: contains no strokes"
[ ! -e d.ndjson ] || fail "an empty sketch was written"

# The three files give the same picture.
for file in a.ndjson a.felt a.svg; do
  run 0 "$feltline" render "$file" -o "$file.png" --dpi 50 --page fit --paper white
  same "$file.png" a.ndjson.png
done

# info prints the same figures for each file, and for a drawing also its page and layers.
run 0 "$feltline" info a.felt --json
has out ',"format":"felt","page":{"width_mm":210,"height_mm":148,"paper":"#ffffff"},"layers":[{"name":"Ink","visible":true,"locked":false,"strokes":20,"fills":0,"opacity":1,"picture":null,"blend":"normal","group":null}],"recordings":[],"notices":[]}'
sed 's/,"format".*//' out >felt.info
run 0 "$feltline" info a.ndjson --json
sed 's/,"format".*//' out >ndjson.info
same ndjson.info felt.info
run 0 "$feltline" info - <a.felt
has out "page            210 x 148 mm, #ffffff"
has out "layer 1         20 strokes, 'Ink'"

# .pdf: each run writes the same bytes, the file is a valid PDF, and PDF files are not read.
run 0 "$feltline" render a.felt -o a.pdf --page A4
run 0 "$feltline" convert a.ndjson -o b.pdf --page A4 --paper white
same a.pdf b.pdf
has a.pdf "%PDF-1.4"
has a.pdf "/MediaBox [0 0 595.2756 841.8898 ]"
run 1 "$feltline" convert a.pdf -o e.ndjson
run 1 "$feltline" convert a.ndjson -o huge.pdf --page 9000x10
has err "5080 mm"
[ ! -e huge.pdf ] || fail "a page too large for a PDF was written"

# A drawing given with --on keeps its layers and ids; new strokes are added on top.
printf '%s\n' '{"t_ms":0,"event":"layer","do":"add","name":"Ideas"}' \
  '{"t_ms":0,"event":"pen","x":10,"y":10,"z":1}' '{"t_ms":1,"event":"pen","x":10,"y":10,"z":-0.5}' \
  '{"t_ms":50,"event":"pen","x":40,"y":20,"z":-0.5}' '{"t_ms":51,"event":"pen","x":40,"y":20,"z":1}' \
  >script.ndjson
run 0 "$feltline" replay script.ndjson --on a.felt -o on.ndjson
run 0 "$feltline" replay script.ndjson --on a.ndjson -o on2.ndjson
same on.ndjson on2.ndjson
lines on.ndjson 21

# If a format has no hidden layers, a message says what happened to the strokes of hidden layers.
printf '%s\n' '{"t_ms":0,"event":"layer","do":"add"}' '{"t_ms":0,"event":"layer","do":"hide","id":1}' \
  '{"t_ms":0,"event":"pen","x":10,"y":10,"z":1}' '{"t_ms":1,"event":"pen","x":10,"y":10,"z":-0.5}' \
  '{"t_ms":50,"event":"pen","x":40,"y":20,"z":-0.5}' '{"t_ms":51,"event":"pen","x":40,"y":20,"z":1}' \
  >hide.ndjson
run 0 "$feltline" replay hide.ndjson --on a.felt -o hidden.felt
run 0 "$feltline" convert hidden.felt -o seen.ndjson
has err "seen.ndjson: 20 strokes of hidden layers were left out; --layers all includes them"
has err "seen.ndjson: the name of 1 layer was left out, because the format has none"
lines err 2
lines seen.ndjson 1
run 0 "$feltline" convert hidden.felt -o seen.xopp
has err "seen.xopp: 20 strokes of hidden layers are visible in the output, because .xopp does not support hidden layers"
has err "seen.xopp: the medium of 1 stroke became a plain pen, because the format has none"
lines err 2
run 0 "$feltline" convert hidden.felt -o all.ndjson --layers all
has err "all.ndjson: 2 layers became one list of strokes, because the format has none"
lines err 1
for command in "hidden.felt -o hidden.svg" "a.felt -o a.xopp"; do
  # shellcheck disable=SC2086  # must be split into words
  run 0 "$feltline" convert $command
  is_empty err
done
lines all.ndjson 21

# Ink beyond the largest coordinate of .ndjson is refused; otherwise the written file could not be read.
echo '{"id":"far","closed":false,"segments":[[9999999990,0,9999999993,0,9999999996,0,9999999999,0]],"joints":[],"widths":[[0,1],[1,1]]}' >edge.ndjson
run 0 "$feltline" convert edge.ndjson -o edge.felt
run 0 "$feltline" convert edge.felt -o edge2.ndjson
run 0 "$feltline" info edge2.ndjson
printf '%s\n' '{"t_ms":0,"event":"select","what":"all"}' '{"t_ms":1,"event":"duplicate"}' >beyond.ndjson
run 0 "$feltline" replay beyond.ndjson --on edge.felt -o beyond.felt
run 1 "$feltline" convert beyond.felt -o far.ndjson
has err "far.ndjson: stroke s2: extends beyond 1e10 mm, the limit of .ndjson"
run 1 "$feltline" replay beyond.ndjson --on edge.felt -o far.ndjson
has err "extends beyond 1e10 mm"
[ ! -e far.ndjson ] || fail "written, but it cannot be read"

# If a file is damaged, the error names the file and no output is written.
head -c 3000 a.felt >cut.felt
run 1 "$feltline" convert cut.felt -o f.ndjson
has err "feltline: cut.felt: is damaged or incomplete"
echo nonsense >no.felt
run 1 "$feltline" info no.felt
has err "feltline: no.felt: is not a Feltline drawing"
run 1 "$feltline" render none.felt -o f.png
has err "feltline: none.felt: "
[ ! -e f.ndjson ] && [ ! -e f.png ] || fail "a file was written without input"

# Fills and opacities of layers are listed and kept; formats without fills leave them out and say how many.
cat >fills.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"
 width="60mm" height="60mm" viewBox="0 0 60 60">
<g inkscape:groupmode="layer" inkscape:label="Areas" style="opacity:0.5">
<path d="M5 5h10v10z" fill="red"/><path d="M25 5h10v10z" fill="teal"/></g></svg>
SVG
run 0 "$feltline" convert fills.svg -o fills.felt
run 0 "$feltline" info fills.felt
has out "layer 1         0 strokes, 2 fills, 'Areas', opacity 0.5"
run 0 "$feltline" info fills.svg --json
has out '"strokes":0,"fills":2,"opacity":0.5,"picture":null,"blend":"normal","group":null}]'
run 0 "$feltline" convert fills.felt -o chosen.felt --layers 1
run 0 "$feltline" info chosen.felt --json
has out '"strokes":0,"fills":2,"opacity":0.5,"picture":null,"blend":"normal","group":null}]'
for ending in ndjson xopp inkml; do
  run 0 "$feltline" convert fills.felt -o "lines.$ending"
  has err "lines.$ending: 2 fills were left out, because the format has only lines"
done
# What is in no layer is kept when layers are chosen; other formats than .felt say what they leave out.
printf '%s\n' '{"t_ms":0,"event":"guides","do":"add","kind":"line","x":50,"y":50}' \
  '{"t_ms":0,"event":"timing","ids":[1],"between":3,"hold":2}' \
  '{"t_ms":0,"event":"body","do":"add","kind":"cut","path":[[1,-2,0],[3,-4,0]]}' >body.ndjson
run 0 "$feltline" replay body.ndjson --on a.felt -o body.felt
run 0 "$feltline" convert body.felt -o chosen.felt --layers 1
[ ! -s err ] || fail "a notice about nothing: $(cat err)"
run 0 "$feltline" info chosen.felt
has out "guides          1"
has out "body edits      1"
has out "'Ink', 3 in-betweens, hold 2"
for ending in ndjson xopp inkml svg; do
  run 0 "$feltline" convert body.felt -o "body.$ending"
  has err "body.$ending: the timing of 1 key drawing was left out, because the format has none"
  has err "body.$ending: 1 edit of the body was left out, because the format has none"
  has err "body.$ending: 1 guide was left out, because the format has none"
done
run 0 "$feltline" convert fills.felt -o fills.pdf
[ ! -s err ] || fail "a notice about fills that a PDF has: $(cat err)"

# A conversion of lines one by one names what is lost once with its number, as one of a whole drawing
# does. Lines that stay lines keep everything.
run 0 "$feltline" fit in.ndjson -o charcoal.ndjson --medium charcoal
run 0 "$feltline" convert charcoal.ndjson -o same.ndjson
is_empty err
same same.ndjson charcoal.ndjson
run 0 "$feltline" convert charcoal.ndjson -o charcoal.felt
run 0 "$feltline" convert charcoal.felt -o whole.xopp
grep -v "names of" err | sed 's/.*whole.xopp: //' >whole.err
has whole.err "the media of 20 strokes became a plain pen, because the format has none"
run 0 "$feltline" convert charcoal.ndjson -o lines.xopp
grep -v "names of" err | sed 's/.*lines.xopp: //' >lines.err
same lines.err whole.err
run 0 "$feltline" fit in.ndjson -o fitted.xopp --medium charcoal
has err "fitted.xopp: the media of 20 strokes became a plain pen, because the format has none"
sed 's/"id":"[^"]*"/"id":"cat"/' charcoal.ndjson >named.ndjson
run 0 "$feltline" convert named.ndjson -o named.xopp
has err "named.xopp: the names of 20 strokes became numbers, because the format cannot hold them"
[ "$(grep -c "names of" err)" = 1 ] || fail "a loss is named more than once"
# Flat ends and pointed corners (trips into the corner) of a file of before they were removed.
echo '{"id":"flat","closed":false,"segments":[[4.0,0.0,2.675,1.325,1.35,2.65,0.025,3.975],[0.025,3.975,1.35,2.65,2.675,1.325,4.0,0.0],[4.0,0.0,17.333333333,0.0,30.666666667,0.0,44.0,0.0]],"joints":["corner","corner"],"widths":[[0,8],[1,0.05],[1.0001,0.06],[2,0.06],[2.0001,8],[3,8]]}' >trips.ndjson
run 0 "$feltline" convert trips.ndjson -o kept.ndjson
is_empty err
lines kept.ndjson 1
run 0 "$feltline" convert trips.ndjson -o round.xopp
has err "round.xopp: 1 stroke with flat ends or pointed corners became round"
run 0 "$feltline" convert trips.ndjson -o kept.inkml
run 0 "$feltline" convert kept.inkml -o from_ink.felt
run 0 "$feltline" convert from_ink.felt -o round.ndjson
has err "round.ndjson: 1 stroke with flat ends or pointed corners became round"

# The first bytes decide: the rest of a huge file of zeros is not read.
truncate -s 2000M zeros.felt
run 1 limit_memory 400000 "$feltline" info zeros.felt
has err "zeros.felt: is not a Feltline drawing"
run 1 limit_memory 400000 "$feltline" convert zeros.felt -o zeros.svg --salvage
has err "zeros.felt: is larger than 536870912 bytes"
cp a.felt longer.felt
truncate -s 2000M longer.felt
run 1 limit_memory 400000 "$feltline" info longer.felt
has err "is 2097152000 bytes long"
rm zeros.felt longer.felt
