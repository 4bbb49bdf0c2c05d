# feltline convert --swell: black SVG and PDF files at true size for swell paper.
. "$(dirname "$0")/helpers.sh"

# A line of 100 mm, a narrower one of another colour, and an area.
cat >map.svg <<'END'
<svg xmlns="http://www.w3.org/2000/svg" width="297mm" height="210mm" viewBox="0 0 297 210">
<path d="M50 30H150" fill="none" stroke="#1030c0" stroke-width="2" stroke-linecap="round"/>
<path d="M50 60H150" fill="none" stroke="#c03010" stroke-width="0.3" stroke-opacity="0.5" stroke-linecap="round"/>
<path d="M50 90H150V150H50Z" fill="#20a040"/>
</svg>
END
run 0 "$feltline" convert map.svg -o map.pdf --swell
has err "map.pdf: widened 1 line"
has err "map.pdf: lines are 1.0, 2.0 mm wide"
has err "map.pdf: made 2 lines black"
has err "map.pdf: 1 area has a texture"
run 0 "$feltline" convert map.svg -o map.svg.out --to svg --swell
has err "1 area has a texture"

# Only black: no other colour is named in the files.
grep -oE '(fill|stroke)="[^"]*"' map.svg.out | sort -u >colors
grep -vxE '(fill|stroke)="(#000000|#000|black|none)"' colors && fail "colours: $(cat colors)"

# True size: the page, and the line in a picture of 10 pixels per mm.
if command -v pdftoppm >/dev/null; then
  run 0 pdfinfo map.pdf
  awk '/^Page size:/ { exit !($3 > 841.6 && $3 < 842.2 && $5 > 595 && $5 < 595.6) }' out || fail "not A4"
  run 0 pdftoppm -r 254 -gray map.pdf page
  # extent ROW: prints the first and the last dark pixel of a row of the picture, and its width.
  extent() {
    od -An -v -tu1 -w"$1" -j$((17 + $1 * $2)) -N"$1" page-1.pgm | awk '{
      for (i = 1; i <= NF; i++) if ($i < 128) { if (!first) first = i; last = i }
      print first, last, last - first + 1 }'
  }
  read -r width height < <(sed -n 2p page-1.pgm)
  { [ $((width / 2)) = 1485 ] && [ $((height / 2)) = 1050 ]; } || fail "the picture has $width x $height pixels"
  # The ends are round, or cut: 100 mm and at most the width of the line.
  read -r first last length < <(extent "$width" 300)
  { [ "$length" -ge 998 ] && [ "$length" -le 1022 ]; } || fail "100 mm are $length pixels"
  { [ $((first + last)) -ge 1998 ] && [ $((first + last)) -le 2004 ]; } || fail "from $first to $last"
  # The widened line is 1 mm wide.
  column=$(od -An -v -tu1 -w1 -j$((17 + width * 560)) -N$((width * 80)) page-1.pgm |
    awk -v width="$width" 'NR % width == 1000 && $1 < 128 { n++ } END { print n + 0 }')
  { [ "$column" -ge 9 ] && [ "$column" -le 11 ]; } || fail "1 mm is $column pixels"
  # Only black: every pixel is grey, and most of the ink is full black.
  run 0 pdftoppm -r 60 map.pdf small
  read -r width height < <(sed -n 2p small-1.ppm)
  tail -c $((width * height * 3)) small-1.ppm | od -An -v -tu1 -w3 |
    awk '$1 != $2 || $2 != $3 { exit 1 } $1 < 10 { n++ } END { exit !(n > 100) }' || fail "not only black"
fi

# Other formats and looks are refused; a drawing without a page gets A4 if it fits.
run 2 "$feltline" convert map.svg -o map.png --swell
run 2 "$feltline" convert map.svg -o b.pdf --swell --grain
run 2 "$feltline" convert map.svg -o b.pdf --swell --paper '#ffeecc'
printf '{"points":[[20,20],[120,20]]}\n' >line.ndjson
run 0 "$feltline" convert line.ndjson -o line.svg --swell
has line.svg 'width="297mm"'
has line.svg 'height="210mm"'
printf '{"points":[[20,20],[900000,20]]}\n' >long.ndjson
run 1 "$feltline" convert long.ndjson -o long.pdf --swell
has err "longer than 100 m"
[ ! -e long.pdf ] || fail "a file was left"
: >empty.ndjson
run 1 "$feltline" convert empty.ndjson -o empty.pdf --swell
