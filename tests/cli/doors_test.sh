# Import and export of other formats: they are recognized by content, layers are kept, unsupported
# content gives notices; --strict and --salvage.
. "$(dirname "$0")/helpers.sh"

strokes 30 >in.ndjson
run 0 "$feltline" fit in.ndjson -o a.ndjson

# A drawing with its own page size and three layers, the second hidden and the third locked.
{
  echo '<?xml version="1.0"?>'
  echo '<svg xmlns="http://www.w3.org/2000/svg" width="120mm" height="80mm" viewBox="0 0 120 80"'
  echo '  xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"'
  echo '  xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd">'
  echo '<g inkscape:groupmode="layer" inkscape:label="Below"><path d="M5 5L50 40C60 60 70 20 90 70"'
  echo '  style="fill:none;stroke:#c00;stroke-width:2"/></g>'
  echo '<g inkscape:groupmode="layer" inkscape:label="Ideas, old" style="display:none">'
  echo '  <line x1="10" y1="70" x2="100" y2="10" stroke="blue"/></g>'
  echo '<g inkscape:groupmode="layer" inkscape:label="Top" sodipodi:insensitive="true">'
  echo '  <circle cx="60" cy="40" r="20" stroke="#080" fill="none"/>'
  echo '  <text x="5" y="75">a title</text><text x="5" y="78">and more</text></g>'
  echo '</svg>'
} >layers.svg
run 0 "$feltline" convert layers.svg -o layers.felt
has err "feltline: layers.svg: line 11: text"
has err "(and 1 more like it)"
run 0 "$feltline" info layers.felt
has out "page            120 x 80 mm"
has out "layer 1         1 strokes, 'Below'"
has out "layer 2         1 strokes, 'Ideas, old', hidden"
has out "layer 3         1 strokes, 'Top', locked"
is_empty err

# Notices are printed on stderr, suppressed with --quiet, or with --strict make the command fail without
# an output. --json counts them.
run 0 "$feltline" convert layers.svg -o quiet.felt --quiet
is_empty err
same quiet.felt layers.felt
run 1 "$feltline" --strict convert layers.svg -o strict.felt
has err "feltline: layers.svg: line 11: text"
[ ! -e strict.felt ] || fail "a file was written despite --strict"
run 0 "$feltline" info layers.svg --json -q
has out '"count":2}]'

# Formats that can hold a whole drawing give it back: the .felt file is equal byte for byte. They are
# recognized by their content alone.
for format in svg inkml; do
  run 0 "$feltline" convert layers.felt -o "there.$format"
  run 0 "$feltline" convert "there.$format" -o back.felt
  is_empty err
  same back.felt layers.felt
  run 0 "$feltline" convert - -o - --to felt <"there.$format"
  same out layers.felt
  cp "there.$format" renamed.felt
  run 0 "$feltline" convert renamed.felt -o back.felt
  has err "feltline: renamed.felt: the name says Feltline drawing, but the content is a"
  same back.felt layers.felt
done

# .xopp keeps layers and lines; curves become short straight pieces.
run 0 "$feltline" convert layers.felt -o there.xopp
run 0 "$feltline" info there.xopp --json
has out '"strokes":1,"fills":0,"opacity":1,"picture":null,"blend":"normal","group":null}],"recordings":[],"notices"'
run 0 "$feltline" convert a.ndjson -o a.xopp
run 0 "$feltline" convert a.ndjson -o a2.xopp
same a.xopp a2.xopp
run 0 "$feltline" fit a.xopp -o fitted.svg

# By default only visible layers are converted; --layers selects others.
run 0 "$feltline" convert layers.felt -o seen.ndjson
lines seen.ndjson 2
run 0 "$feltline" convert layers.felt -o all.ndjson --layers all
lines all.ndjson 3
run 0 "$feltline" convert layers.felt -o some.ndjson --layers 2,3
lines some.ndjson 2
run 0 "$feltline" convert layers.felt -o one.ndjson --layers 'Ideas, old'
lines one.ndjson 1
run 1 "$feltline" convert layers.felt -o none.ndjson --layers 4
has err "layer '4' does not exist; the layers are 1 'Below', 2 'Ideas, old', 3 'Top'"
[ ! -e none.ndjson ] || fail "written without a layer"
run 0 "$feltline" convert layers.felt -o seen.svg --layers visible
run 0 "$feltline" render seen.svg -o seen.png --dpi 50
run 0 "$feltline" render layers.felt -o layers.png --dpi 50
same seen.png layers.png

# convert fits raw pen samples to ink.
run 0 "$feltline" convert in.ndjson -o raw.ndjson
same raw.ndjson a.ndjson

# A damaged drawing is refused, but --salvage reads its undamaged part.
strokes 400 >many.ndjson
run 0 "$feltline" fit many.ndjson -o whole.felt
head -c $(($(stat -c %s whole.felt) * 3 / 4)) whole.felt >cut.felt
run 1 "$feltline" convert cut.felt -o had.ndjson
has err '`feltline convert --salvage` recovers the readable parts'
run 0 "$feltline" convert cut.felt -o had.ndjson --salvage
[ -s err ] || fail "the damage was not reported"
[ "$(wc -l <had.ndjson)" -gt 0 ] || fail "no stroke was recovered"

# fit accepts raw samples only, not curves that are fitted already.
run 1 "$feltline" fit layers.felt -o x.ndjson
has err "feltline: layers.felt: contains curves, which are already fitted"

# 'formats' prints a table of the formats.
run 0 "$feltline" formats
for word in felt svg inkml xopp ndjson pdf png; do has out "$word "; done
rows=$(($(wc -l <out) - 1))
run 0 "$feltline" formats --json
lines out "$rows"
has out '{"name":"felt","title":"Feltline drawing","endings":[".felt"]'
