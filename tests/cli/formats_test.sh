# Formats and pictures: formats chosen by file extension and by name, and the output of convert and
# info.
. "$(dirname "$0")/helpers.sh"

strokes 20 >in.ndjson
run 0 "$feltline" fit in.ndjson -o a.ndjson

# convert returns a sketch unchanged, byte for byte, with or without a header line before it.
run 0 "$feltline" convert a.ndjson -o b.ndjson
same a.ndjson b.ndjson
{ echo '{"feltline":1,"unit":"mm"}'; cat a.ndjson; } >headed.ndjson
run 0 "$feltline" convert headed.ndjson -o -
same out a.ndjson
run 0 "$feltline" convert a.ndjson -o b.JSONL
same a.ndjson b.JSONL

# The size of a picture in pixels follows from the page size in mm.
png_size() { od -An -tu1 -j16 -N8 "$1" | awk '{ print $3 * 256 + $4 "x" $7 * 256 + $8 }'; }
run 0 "$feltline" render a.ndjson -o p.png --page A4 --dpi 25.4
[ "$(png_size p.png)" = 210x297 ] || fail "A4 is $(png_size p.png)"
run 0 "$feltline" render a.ndjson -o p.png --page A5-landscape --dpi 50.8
[ "$(png_size p.png)" = 420x296 ] || fail "A5-landscape is $(png_size p.png)"
run 0 "$feltline" render a.ndjson -o p.png --page 30.5x20 --dpi 254
[ "$(png_size p.png)" = 305x200 ] || fail "30.5x20 is $(png_size p.png)"
run 0 "$feltline" convert a.ndjson -o p.png --page 25.4x50.8 --scale 2
[ "$(png_size p.png)" = 192x384 ] || fail "two by four inches at twice 96 dots are $(png_size p.png)"
run 2 "$feltline" convert a.ndjson -o p.png --scale 2 --dpi 50
run 0 "$feltline" render a.ndjson -o p.png --dpi 50 --paper transparent
run 0 "$feltline" fit in.ndjson -o q.png --dpi 50 --paper transparent
same p.png q.png
run 0 "$feltline" render a.ndjson -o - --to png --dpi 50 --paper transparent
same out p.png
run 1 "$feltline" render a.ndjson -o r.png --dpi 4800 --page 100000x100000
[ ! -e r.png ] || fail "a picture larger than memory"
run 0 "$feltline" render headed.ndjson -o headed.png --dpi 50 --paper transparent
same headed.png p.png

# A picture shows the grain of the surface, and each run gives the same picture (R47). Without a surface
# the ink is solid. On a smooth surface it looks as the medium does there.
run 0 "$feltline" fit in.ndjson -o dry.ndjson --medium pencil
run 0 "$feltline" render dry.ndjson -o solid.png --dpi 50 --paper transparent
run 0 "$feltline" render dry.ndjson -o g1.png --dpi 50 --paper transparent --surface paper
run 0 "$feltline" fit in.ndjson -o g2.png --medium pencil --dpi 50 --paper transparent --surface paper
same g1.png g2.png
! cmp -s g1.png solid.png || fail "no grain"
run 0 "$feltline" render dry.ndjson -o glass.png --dpi 50 --paper transparent --surface glass
! cmp -s glass.png solid.png || fail "no medium on glass"
! cmp -s glass.png g1.png || fail "glass with grain"

# With --grain an .svg and a .pdf show the grain too. Masks make the grain; the outlines are the same as
# without it, and the .svg is read back as the same drawing. A .png uses the surface that the drawing
# names.
run 0 "$feltline" convert dry.ndjson -o page.felt --page A4
run 0 "$feltline" convert page.felt -o solid.svg
run 0 "$feltline" convert dry.ndjson -o grain.svg --page A4 --grain --surface rough-paper --grain-dpi 60
has grain.svg '<mask id="grain1" maskUnits="userSpaceOnUse"'
sed -e '/^<defs><mask /d' -e 's/mask="url(#grain[0-9]*)" //' grain.svg >unmasked.svg
[ "$(grep -c '<path id=' unmasked.svg)" = 20 ] || fail "paths are missing"
diff <(grep -o ' d="[^"]*"' solid.svg) <(grep -o ' d="[^"]*"' unmasked.svg) >/dev/null || fail "an outline changed"
run 0 "$feltline" convert grain.svg -o grain_back.ndjson
is_empty err
run 0 "$feltline" convert solid.svg -o solid_back.ndjson
same grain_back.ndjson solid_back.ndjson
run 0 "$feltline" convert dry.ndjson -o solid.pdf --page A4
run 0 "$feltline" convert dry.ndjson -o grain.pdf --page A4 --grain-mask --surface rough-paper --grain-dpi 60
grep -qa '/S /Luminosity' grain.pdf || fail "no grain in the .pdf"
! grep -qa 'Luminosity' solid.pdf || fail "grain that nobody asked for"
run 2 "$feltline" convert a.ndjson -o r.svg --grain --grain-dpi 5
sed 's/felt:page="/felt:surface="rough-paper" &/' solid.svg >on_rough.svg
run 0 "$feltline" render on_rough.svg -o rough1.png --dpi 50 --grain
run 0 "$feltline" render solid.svg -o rough2.png --dpi 50 --surface rough-paper
same rough1.png rough2.png
run 0 "$feltline" convert on_rough.svg -o rough.felt
run 0 "$feltline" convert rough.felt -o rough_back.svg
has rough_back.svg 'felt:surface="rough-paper"'
run 0 "$feltline" render rough.felt -o rough3.png --dpi 50 --grain
same rough3.png rough1.png
sed 's/felt:page="/felt:surface="moon dust" &/' solid.svg >on_moon.svg
run 1 "$feltline" render on_moon.svg -o r.png --grain
has err "the drawing's surface 'moon dust' is unknown; choose another with --surface"
run 0 "$feltline" convert on_moon.svg -o moon_back.svg
has moon_back.svg 'felt:surface="moon dust"'

# A script adds a picture to draw over and a translucent layer. Exported files leave the picture out unless asked.
cat > traced.events <<'EOF'
{"event":"picture","t_ms":0,"name":"Photo","matrix":[50,0,0,50,20,20],"png":"iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAYAAAD0In+KAAAADklEQVR42mP4z8AAQv8BD/kD/Zh51wAAAAAASUVORK5CYII="}
{"event":"layer","t_ms":0,"do":"opacity","id":2,"opacity":0.5}
{"event":"layer","t_ms":0,"do":"use","id":1}
{"event":"pen","t_ms":10,"x":30,"y":30,"z":-1}
{"event":"pen","t_ms":60,"x":90,"y":60,"z":-1}
{"event":"pen","t_ms":70,"x":90,"y":60,"z":5}
EOF
run 0 "$feltline" replay traced.events -o traced.felt
run 0 "$feltline" convert traced.felt -o traced.svg
grep -q 'opacity:0.5' traced.svg || fail "the opacity of a layer is lost"
! grep -q '<image' traced.svg || fail "a picture is exported without being asked for"
run 0 "$feltline" convert traced.felt -o with.svg --pictures
grep -q '<image' with.svg || fail "a picture is not exported"
if command -v rsvg-convert >/dev/null; then run 0 rsvg-convert with.svg -o with-svg.png; fi
run 0 "$feltline" convert with.svg -o back.felt
run 0 "$feltline" convert back.felt -o back.svg
grep -q '<image' back.svg || fail "a picture is not read from an .svg"
run 0 "$feltline" convert traced.felt -o without.png --dpi 20
run 0 "$feltline" convert traced.felt -o with.png --dpi 20 --pictures
! cmp -s without.png with.png || fail "--pictures does not change a .png"
run 0 "$feltline" convert traced.felt -o without.pdf
! grep -aq '/Subtype /Image' without.pdf || fail "a picture is in a .pdf without being asked for"
run 0 "$feltline" convert traced.felt -o with.pdf --pictures
grep -aq '/Subtype /Image' with.pdf || fail "--pictures does not change a .pdf"
run 2 "$feltline" convert traced.felt -o r.ndjson --pictures
run 2 "$feltline" convert traced.felt -o r.svg --pictures --compact

# A layer that multiplies, in a group that is faded as a whole: poppler and librsvg show the same as our .png.
cat > blended.events <<'EOF'
{"event":"option","t_ms":0,"id":"pencil.medium","value":"ink-pen"}
{"event":"option","t_ms":0,"id":"ink.color","value":"#e0a040"}
{"event":"pen","t_ms":10,"x":20,"y":30,"z":0,"pressure":1}
{"event":"pen","t_ms":60,"x":90,"y":60,"z":0,"pressure":1}
{"event":"pen","t_ms":70,"x":90,"y":60,"z":5}
{"event":"layer","t_ms":100,"do":"add"}
{"event":"layer","t_ms":100,"do":"blend","id":2,"mode":"multiply"}
{"event":"option","t_ms":100,"id":"ink.color","value":"#60c0e0"}
{"event":"pen","t_ms":110,"x":20,"y":60,"z":0,"pressure":1}
{"event":"pen","t_ms":160,"x":90,"y":30,"z":0,"pressure":1}
{"event":"pen","t_ms":170,"x":90,"y":30,"z":5}
{"event":"layer","t_ms":200,"do":"add"}
{"event":"pen","t_ms":210,"x":55,"y":20,"z":0,"pressure":1}
{"event":"pen","t_ms":260,"x":55,"y":70,"z":0,"pressure":1}
{"event":"pen","t_ms":270,"x":55,"y":70,"z":5}
{"event":"layer","t_ms":300,"do":"group","ids":[2,3],"name":"Shade"}
{"event":"layer","t_ms":300,"do":"opacity","group":1,"opacity":0.75}
{"event":"layer","t_ms":300,"do":"blend","group":1,"mode":"multiply"}
EOF
run 0 "$feltline" replay blended.events -o blended.felt
run 0 "$feltline" info blended.felt
has out "group 1         'Shade', opacity 0.75, multiply"
has out "layer 2         1 strokes, 'Layer 2', multiply, in group 1"
run 0 "$feltline" convert blended.felt -o blended.svg
has blended.svg 'style="display:inline;mix-blend-mode:multiply"'
run 0 "$feltline" convert blended.svg -o blended_back.felt
run 0 "$feltline" info blended_back.felt
has out "layer 2         1 strokes, 'Layer 2', multiply, in group 1"
run 0 "$feltline" convert blended.felt -o blended.xopp
has err "the blend modes of 2 layers or groups became normal, because the format has none"
has err "1 group of layers was dissolved, because the format has none"
run 0 "$feltline" convert blended.felt -o blended.png --dpi 24 --paper '#f0e0c0'
run 0 "$feltline" convert blended.felt -o blended.pdf --paper '#f0e0c0'
run 0 "$feltline" convert blended.felt -o paper.svg --paper '#f0e0c0'
run 0 "$feltline" convert blended.felt -o compact.svg --compact --paper '#f0e0c0'
# Prints the largest difference, in levels, away from edges, which programs draw differently.
cat > differ.py <<'EOF'
import struct, sys, zlib

def pixels(path):
    data, at, parts, head = open(path, 'rb').read(), 8, b'', None
    while at < len(data):
        size, kind = struct.unpack('>I4s', data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        head = struct.unpack('>IIBBBBB', body) if kind == b'IHDR' else head
        parts += body if kind == b'IDAT' else b''
        at += size + 12
    width, height, depth, color = head[:4]
    assert depth == 8 and color in (2, 6)
    n = 3 if color == 2 else 4
    raw, stride, rows, last = zlib.decompress(parts), n * width, [], bytes(n * width)
    for y in range(height):
        at = y * (stride + 1)
        kind, line = raw[at], bytearray(raw[at + 1:at + 1 + stride])
        for x in range(stride if kind else 0):
            a, b, c = line[x - n] if x >= n else 0, last[x], last[x - n] if x >= n else 0
            p = a + b - c
            paeth = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
            line[x] = (line[x] + (0, a, b, (a + b) // 2, paeth)[kind]) & 255
        last = bytes(line)
        rows.append([last[x:x + 3] for x in range(0, stride, n)])
    return rows

one, two = pixels(sys.argv[1]), pixels(sys.argv[2])
height, width = min(len(one), len(two)), min(len(one[0]), len(two[0]))
assert abs(len(one) - len(two)) <= 1 and abs(len(one[0]) - len(two[0])) <= 1
def is_flat(rows, x, y):
    return all(max(abs(p - q) for p, q in zip(rows[y + j][x + i], rows[y][x])) <= 2
               for i in (-1, 0, 1) for j in (-1, 0, 1))

worst = max(max(abs(p - q) for p, q in zip(one[y][x], two[y][x])) for y in range(1, height - 1)
            for x in range(1, width - 1) if is_flat(one, x, y) and is_flat(two, x, y))
print(worst)
sys.exit(worst > 3)
EOF
if command -v pdftoppm >/dev/null && command -v rsvg-convert >/dev/null && command -v python3 >/dev/null; then
  run 0 pdftoppm -r 24 -png -singlefile blended.pdf blended-pdf
  run 0 rsvg-convert -z 0.25 paper.svg -o blended-svg.png
  run 0 rsvg-convert -z 0.25 compact.svg -o blended-compact.png
  for other in pdf svg compact; do run 0 python3 differ.py blended.png "blended-$other.png"; done
fi

# A compact .svg is a small picture of the visible ink.
run 0 "$feltline" convert page.felt -o small.svg --compact
[ "$(grep -c '<path' small.svg)" = 21 ] || fail "20 strokes and the paper make 21 paths"
! grep -q 'felt:\|inkscape' small.svg || fail "a compact .svg has data of ours"
[ $((2 * $(stat -c %s small.svg))) -lt "$(stat -c %s solid.svg)" ] || fail "a compact .svg is not small"
run 0 "$feltline" convert dry.ndjson -o small2.svg --compact --page A4 --paper white
same small2.svg small.svg
run 2 "$feltline" convert page.felt -o r.pdf --compact
run 2 "$feltline" convert page.felt -o r.svg --compact --grain

# Each of our formats stores the name of the medium and the tones of the lines. If ink has no medium,
# its tones follow from its widths and are not stored.
run 0 "$feltline" fit in.ndjson --material charcoal --max-width 2.5 -o toned.ndjson
has toned.ndjson '"material":"charcoal"'
has toned.ndjson '"tones":['
! grep -q tones a.ndjson || fail "tones that the widths say"
for format in svg inkml felt; do
  run 0 "$feltline" convert toned.ndjson -o "toned.$format"
  run 0 "$feltline" convert "toned.$format" -o again.ndjson
  same toned.ndjson again.ndjson
done

# An .svg also contains the paper colour, unless it is transparent or not requested.
run 0 "$feltline" convert a.ndjson -o plain.svg
run 0 "$feltline" convert a.ndjson -o clear.svg --paper transparent
same plain.svg clear.svg
run 0 "$feltline" fit in.ndjson -o fitted.svg --jobs 2
same plain.svg fitted.svg
! grep -q '<rect' plain.svg || fail "paper that nobody asked for"
run 0 "$feltline" render a.ndjson -o paper.svg --paper '#ffeecc80' --page 30x20
has paper.svg '<rect id="paper" x="0" y="0" width="30" height="20" fill="#ffeecc" fill-opacity="0.502"'
has paper.svg '</svg>'

# A stroke that a format cannot represent is skipped; the others are written.
printf '{"id":"a\\u0001","points":[[0,0],[5,5]]}\n{"id":"b","points":[[0,0],[5,5]]}\n' >ids.ndjson
run 1 "$feltline" fit ids.ndjson -o ids.svg
lines err 1
has err "feltline: ids.ndjson:1: XML cannot contain the character U+1"
has ids.svg 'felt:id="b"'
run 0 "$feltline" fit ids.ndjson -o fitted_ids.ndjson
run 1 "$feltline" convert fitted_ids.ndjson -o converted_ids.svg
has err "feltline: fitted_ids.ndjson:1: XML cannot contain the character U+1"
same converted_ids.svg ids.svg

# A drawing of a picture alone is a drawing, also if the name of the file has a query.
run 0 "$feltline" render a.ndjson -o alone.png --page 30x20 --dpi 50.8
for name in alone.png 'alone.png?x=1' 'alone.png#x'; do
  echo '<svg xmlns="http://www.w3.org/2000/svg" width="30mm" height="20mm" viewBox="0 0 30 20">' \
    "<image href='$name' width='30' height='20'/></svg>" >alone.svg
  run 0 "$feltline" convert alone.svg -o alone.felt --strict
  run 0 "$feltline" info alone.svg --strict
  run 0 "$feltline" convert alone.felt -o again.svg
  has again.svg '<image '
done
echo '<svg xmlns="http://www.w3.org/2000/svg"><path d="M1 1h9" fill="none"/></svg>' >blank.svg
run 1 "$feltline" convert blank.svg -o blank.felt
has err "path has neither a line nor a fill that shows and was skipped"
has err "blank.svg: contains no strokes"

# The output of info.
run 0 "$feltline" info in.ndjson --json
has out '{"kind":"raw","strokes":20,"samples":800,"longest_stroke":40,"with_pressure":20,"with_time":20,'
run 0 "$feltline" info headed.ndjson --json
has out '{"kind":"sketch","strokes":20,'
run 0 "$feltline" info - <a.ndjson
has out 'kind            sketch'
has out 'format          Strokes as lines of JSON'
lines out 10
# Drawings of Quick, Draw!: each line is a drawing, and each of its strokes becomes a stroke. The id of
# a stroke is the id of the drawing with a number.
printf '%s\n' '{"word":"house","key_id":"47","drawing":[[[30,30,225],[255,110,112]],[[0,9],[5,5]]]}' \
  '{"drawing":[[[1,9],[1,9],[0,16]]]}' >quick.ndjson
run 0 "$feltline" fit quick.ndjson -o quick_fitted.ndjson --mm-per-unit 0.2
[[ $(grep -o '"id":"[^"]*"' quick_fitted.ndjson | tr -d '\n') == '"id":"47.1""id":"47.2""id":"s2.1"' ]] ||
  fail "other names: $(cat quick_fitted.ndjson)"
run 0 "$feltline" fit quick.ndjson -o quick.svg
[[ -z $(grep -o ' id="[^"]*"' quick.svg | sort | uniq -d) ]] || fail "ids occur twice in quick.svg"
run 1 "$feltline" fit - -o - <<<'{"drawing":[[[1,2],[3]]]}'
has err "drawing[0]: a stroke needs equal numbers of x, y and t"

# A pen line in pieces becomes one stroke.
cat >pieces.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100"><g fill="none" stroke="#000">
<path d="M20 20L25 22" stroke-width="0.4"/><path d="M25 22L30 20" stroke-width="0.6"/><path d="M30 20L35 17" stroke-width="0.8"/>
</g></svg>
SVG
run 0 "$feltline" convert pieces.svg --join -o joined.ndjson
has err "joined.ndjson: 3 lines became 1 stroke"
lines joined.ndjson 1
