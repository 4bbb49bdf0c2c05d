# feltline inflate: the outlines of a drawing as a solid.
samples=$(cd "$(dirname "$0")/../../share/samples" && pwd)
. "$(dirname "$0")/helpers.sh"

# A ring with a body inside, and a whisker.
cat >ring.svg <<'END'
<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="150mm" viewBox="0 0 200 150">
<g fill="none" stroke="#c05020" stroke-width="0.6" stroke-linecap="round" stroke-linejoin="round">
<circle cx="100" cy="75" r="50"/><circle cx="100" cy="75" r="20"/><path d="M140 75 H190"/>
</g>
</svg>
END

# watertight FILE.obj EULER: checks that each edge has two faces, in opposite directions.
watertight() {
  awk -v wanted="$2" '
    $1 == "v" { points++ }
    $1 == "f" { faces++; edge[$2 " " $3]++; edge[$3 " " $4]++; edge[$4 " " $2]++ }
    END {
      for (e in edge) {
        split(e, ends, " "); edges++
        if (edge[e] != 1 || !((ends[2] " " ends[1]) in edge)) { print "an open edge: " e; exit 1 }
      }
      if (faces < 100 || points - edges / 2 + faces != wanted) { print "Euler: " points - edges / 2 + faces; exit 1 }
    }' "$1" || fail "$1 is not closed"
}

for format in stl obj 3mf glb; do
  run 0 "$feltline" inflate ring.svg -o "ring.$format"
  is_empty out
  if [ "$format" = glb ]; then
    is_empty err
  else
    [ "$(wc -l <err)" = 1 ] || fail "not one sentence about the whisker"
    has err "ring.$format: the paint on the body was left out"
  fi
  run 0 "$feltline" inflate - -o - --to "$format" <ring.svg
  same out "ring.$format"
done
watertight ring.obj 0
[ "$(head -c 4 ring.glb)" = glTF ] || fail "no glb"
[ "$(head -c 2 ring.3mf)" = PK ] || fail "no 3mf"
faces=$(($(($(wc -c <ring.stl) - 84)) / 50))
# As many as its two outlines need at 1,200 pixels: 10,560.
{ [ $faces -gt 9500 ] && [ $faces -lt 11600 ]; } || fail "$faces triangles"

# Options.
run 0 "$feltline" inflate ring.svg -o disc.obj --fill-holes
watertight disc.obj 2
run 0 "$feltline" inflate ring.svg -o few.stl --triangles 1000
[ "$(wc -c <few.stl)" -lt 90000 ] || fail "more than 1,800 triangles"
run 0 "$feltline" inflate ring.svg --png ring.png
[ "$(head -c 4 ring.png | tail -c 3)" = PNG ] || fail "no picture"
run 0 "$feltline" inflate ring.svg -o both.stl --png both.png
same both.stl ring.stl
same both.png ring.png

# The whisker is painted on the front: a texture of the .glb, and a part of the picture.
grep -q image/png ring.glb || fail "no texture"
run 0 "$feltline" inflate ring.svg -o plain.glb --no-paint --png plain.png
! grep -q image/png plain.glb || fail "a texture"
! cmp -s plain.png ring.png || fail "no whisker on the body"

# A file without the paint says so, and not if there is none.
run 0 "$feltline" inflate ring.svg -o plain.stl --no-paint
is_empty err
same plain.stl ring.stl
run 1 "$feltline" --strict inflate ring.svg -o strict.stl
[ ! -e strict.stl ] || fail "a file without the whisker"

# A line beside the body or in its hole is not on it.
cat >beside.svg <<'END'
<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="70mm" viewBox="0 0 60 70">
<path d="M20 10 L50 60 L10 60 Z M40 12 L49 14" fill="none" stroke="#000" stroke-width="0.5"
stroke-linecap="round" stroke-linejoin="round"/>
</svg>
END
sed 's|M140 75 H190|M95 75 H105|' ring.svg >in_hole.svg
for name in beside in_hole; do
  run 0 "$feltline" --strict inflate $name.svg -o $name.stl
  is_empty err
done

# A surface that is unknown here matters only where the paint is written.
run 0 "$feltline" convert ring.svg -o known.svg
sed 's/felt:page="/felt:surface="moon dust" &/' known.svg >unknown.svg
has unknown.svg "moon dust"
run 0 "$feltline" inflate unknown.svg -o unknown.stl
has err "unknown.stl: the paint on the body was left out"
run 1 "$feltline" inflate unknown.svg -o unknown.glb
has err "the drawing's surface 'moon dust' is unknown"

# The edits of the body: a cut through the middle, which removes the left half; and one that does not fit.
cat >edits.ndjson <<'END'
{"t_ms":0,"event":"body","do":"add","kind":"cut","path":[[100,-140,0],[100,-10,0]]}
{"t_ms":0,"event":"body","do":"add","kind":"paint","path":[[110,-60,0],[140,-75,0]],"width_mm":3,"color":"#ff0000"}
{"t_ms":0,"event":"body","do":"add","kind":"cut","path":[[0,0,0],[5,0,0]]}
END
run 0 "$feltline" replay edits.ndjson --on ring.svg -o edited.felt
run 0 "$feltline" inflate edited.felt -o edited.obj --fill-holes
has err "edit 3 of the body, the cut that begins at (0.00, 0.00) mm: the stroke does not touch a body"
watertight edited.obj 2
# The stroke is moved off the points of the body, here by 0.0014 mm (docs/design/solids.md#edits-of-the-body).
awk '$1 == "v" && $2 < -0.002 { exit 1 }' edited.obj || fail "the left half is still there"
run 0 "$feltline" inflate edited.felt -o edited.glb --fill-holes
grep -q COLOR_0 edited.glb || fail "nothing is painted"
grep -q "painted line\|paint on the body" err && fail "the paint is in the .glb"
run 0 "$feltline" inflate edited.felt -o edited.stl --fill-holes --no-paint
has err "edited.stl: the paint on the body was left out"
run 0 "$feltline" inflate edited.felt -o whole.obj --fill-holes --no-edits --no-paint
is_empty err
same whole.obj disc.obj

# A film in which it turns: the first and the last picture differ by one step only.
if command -v ffmpeg >/dev/null; then
  run 0 "$feltline" inflate ring.svg --film ring.gif
  [ "$(ffprobe -v error -count_frames -show_entries stream=nb_read_frames,width -of csv=p=0 ring.gif)" = 640,72 ] ||
    fail "not 72 pictures"
fi
run 1 env PATH= "$feltline" inflate ring.svg --film none.webm
has err "ffmpeg"
[ ! -e none.webm ] || fail "a film was left"

# A loose sketch: the gap is found, or given.
run 0 "$feltline" fit --quiet "$samples/cat.ndjson" -o cat.felt
run 0 "$feltline" inflate cat.felt --fill-holes -o found.obj
run 0 "$feltline" inflate cat.felt --fill-holes --gap 8 -o given.obj
same found.obj given.obj
[ "$(grep -c '^o ' found.obj)" = 1 ] || fail "the cat is in pieces"

# Wrong usage.
run 2 "$feltline" inflate ring.svg
has err "-o, --png or --film is required"
run 2 "$feltline" inflate ring.svg --film ring.mp4
run 2 "$feltline" inflate ring.svg --film ring.svg
run 2 "$feltline" inflate ring.svg -o ring.step
has err ".stl, .obj, .3mf or .glb"
run 2 "$feltline" inflate ring.svg -o -
run 2 "$feltline" inflate ring.svg -o a.stl --triangles 5
run 2 "$feltline" inflate ring.svg -o a.stl --thickness nan
run 2 "$feltline" inflate ring.svg -o a.stl --gap -1
run 2 "$feltline" inflate ring.svg -o - --to stl --png -
run 2 "$feltline" inflate ring.svg -o ring.svg --to stl
run 2 "$feltline" inflate ring.svg -o a.stl --png a.stl
[ ! -e a.stl ] || fail "a file was left"

# What cannot be inflated: the message names the stroke and the place, and an older file stays.
echo old >kept.stl
printf '{"points":[[10,10,0.5],[60,10,0.5],[60,60,0.5],[10,60,0.5],[10,30,0.5]]}\n' >open.ndjson
run 1 "$feltline" inflate open.ndjson -o kept.stl
has err "open.ndjson: contains no closed outline: there is a gap of "
cat >eight.svg <<'END'
<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100">
<path d="M10 10 L90 90 V10 L10 90 Z" fill="none" stroke="#000" stroke-width="0.5" stroke-linejoin="round"/>
</svg>
END
run 1 "$feltline" inflate eight.svg -o kept.stl
has err "eight.svg: stroke s1 crosses itself at (50.00, 50.00) mm"
: >empty.ndjson
run 1 "$feltline" inflate empty.ndjson -o kept.stl
has err "contains no strokes"
run 1 "$feltline" inflate missing.svg -o kept.stl
echo old >expected
same kept.stl expected

# A small loop beside the outline is left out with a notice, which --strict makes an error.
sed 's|<path d="M140 75 H190"/>|<circle cx="180" cy="20" r="0.3"/>|' ring.svg >speck.svg
run 0 "$feltline" inflate speck.svg -o speck.stl
has err "speck.svg: left out 1 small closed line"
run 1 "$feltline" --strict inflate speck.svg -o strict.stl
[ ! -e strict.stl ] || fail "a file was left"

# A full disk, or a process that is killed, leaves no half of a file.
if [ -e /dev/full ]; then
  run 1 "$feltline" inflate ring.svg -o /dev/full --to stl
fi
run 1 bash -c "ulimit -f 16 && exec \"\$0\" inflate ring.svg -o limited.stl" "$feltline"
[ ! -e limited.stl ] || fail "half of a file"
