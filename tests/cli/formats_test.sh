# Formats and pictures: by extension and by name, and what convert and info say.
. "$(dirname "$0")/helpers.sh"

strokes 20 >in.ndjson
run 0 "$feltline" fit in.ndjson -o a.ndjson

# convert gives a sketch back byte for byte, with or without a header line before it.
run 0 "$feltline" convert a.ndjson -o b.ndjson
same a.ndjson b.ndjson
{ echo '{"feltline":1,"unit":"mm"}'; cat a.ndjson; } >headed.ndjson
run 0 "$feltline" convert headed.ndjson -o -
same out a.ndjson
run 0 "$feltline" convert a.ndjson -o b.JSONL
same a.ndjson b.JSONL

# A size in mm becomes a size in pixels.
png_size() { od -An -tu1 -j16 -N8 "$1" | awk '{ print $3 * 256 + $4 "x" $7 * 256 + $8 }'; }
run 0 "$feltline" render a.ndjson -o p.png --page A4 --dpi 25.4
[ "$(png_size p.png)" = 210x297 ] || fail "A4 is $(png_size p.png)"
run 0 "$feltline" render a.ndjson -o p.png --page A5-landscape --dpi 50.8
[ "$(png_size p.png)" = 420x296 ] || fail "A5-landscape is $(png_size p.png)"
run 0 "$feltline" render a.ndjson -o p.png --page 30.5x20 --dpi 254
[ "$(png_size p.png)" = 305x200 ] || fail "30.5x20 is $(png_size p.png)"
run 0 "$feltline" render a.ndjson -o p.png --dpi 50 --paper transparent
run 0 "$feltline" fit in.ndjson -o q.png --dpi 50 --paper transparent
same p.png q.png
run 0 "$feltline" render a.ndjson -o - --to png --dpi 50 --paper transparent
same out p.png
run 1 "$feltline" render a.ndjson -o r.png --dpi 4800 --page 100000x100000
[ ! -e r.png ] || fail "a picture larger than memory"
run 0 "$feltline" render headed.ndjson -o headed.png --dpi 50 --paper transparent
same headed.png p.png

# info
run 0 "$feltline" info in.ndjson --json
has out '{"kind":"raw","strokes":20,"samples":800,"longest_stroke":40,"with_pressure":20,"with_time":20,'
run 0 "$feltline" info headed.ndjson --json
has out '{"kind":"sketch","strokes":20,'
run 0 "$feltline" info - <a.ndjson
has out 'kind            sketch'
lines out 9
finish
