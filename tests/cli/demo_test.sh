# The demonstration writes all its files, the same in each run, and draws every stroke of the cat.
tools=$(cd "$(dirname "$0")/../../src/felt/tools" && pwd)
. "$(dirname "$0")/helpers.sh"

run 0 "$feltline" demo -o one
has out "pencil"
has out "In one: sketch.svg"
is_empty err
run 0 env PATH= "$feltline" demo -o two/below --size 400  # without ffmpeg, so without the film
[ ! -e two/below/solid.webm ] || fail "a film without ffmpeg"
for file in sketch.ndjson sketch.svg forces.csv; do
  same "one/$file" "two/below/$file"
done
# Each act has a picture (before, during and after it) and a row of the table.
mkdir -p three
run 0 env PATH= "$feltline" demo -o three
for act in "$tools"/*/[0-9]*-*.ndjson; do
  name=$(basename "$act" .ndjson)
  [ -s "one/$name.png" ] || fail "no picture of $name"
  same "one/$name.png" "three/$name.png"
  has out "${name#*-}"
done
for file in sketch.png forces.png solid.png solid.glb swim.svg; do
  [ -f "one/$file" ] || continue  # solids can be switched off
  [ "$file" = "${file%.png}" ] || [ "$(head -c 4 "one/$file" | tail -c 3)" = PNG ] || fail "$file is not a PNG"
  same "one/$file" "three/$file"
done
# It ends with the fish that swims, and with the cat as a solid that turns.
[ "$(grep -c '<animate' one/swim.svg)" -ge 22 ] || fail "the fish does not swim"
if [ -f one/solid.glb ] && command -v ffprobe >/dev/null; then
  [ "$(ffprobe -v error -count_frames -show_entries stream=nb_read_frames -of csv=p=0 one/solid.webm)" = 72 ] ||
    fail "the cat does not turn"
fi
if command -v rsvg-convert >/dev/null; then
  run 0 rsvg-convert one/sketch.svg -o viewed.png
fi

# Its scripts are ordinary scripts. 'replay' plays each one on the drawing of the first act, and each
# has its intended effect.
run 0 "$feltline" replay "$tools/pencil/1-pencil.ndjson" -o cat.ndjson
lines cat.ndjson "$(grep -c '"points"' "$tools/pencil/1-pencil.ndjson")"
run 0 "$feltline" info cat.ndjson
has out "closed          2"  # the ball of wool, and the cat's nose
changes() { # ACT WHAT: plays ACT and checks that the output of --stats contains WHAT
  local tool=${1#*-}
  run 0 "$feltline" replay "$tools/${tool%%-*}/$1.ndjson" --on "${3:-cat.ndjson}" --stats json
  has out "$2"
  has out '"hard_faults":0,'
}
changes 2-pull '"edits":3,'
changes 3-smooth '"edits":3,'
changes 4-width '"edits":1,'
changes 5-eraser '"edits":2,'
changes 6-lasso '"edits":0,'
changes 7-transform '"edits":1,'
changes 8-connect '"edits":4,'
changes 9-recolor '"edits":1,'
changes 10-shape '"edits":2,'
changes 11-gather '"edits":5,'
changes 12-fill '"edits":1,'
changes 13-pencil-gestures '"edits":2,'  # a circle, and a scribble: the moon is not on this drawing
changes 14-pencil-steady '"edits":2,'
changes 16-read '"edits":0,'
changes 17-pencil-ring '"edits":1,'
changes 18-pencil-guide '"edits":4,'  # a guide, a line, its exact circle, no guides
run 0 "$feltline" replay "$tools/pencil/14-pencil-steady.ndjson" -o lines.ndjson
changes 15-eraser-press '"edits":1,' lines.ndjson
has out '"strokes":1,'
run 0 "$feltline" info one/sketch.ndjson
has out "closed          6"

run 1 "$feltline" demo -o /proc/nowhere
has err "feltline: /proc/nowhere"
echo >file
run 1 "$feltline" demo -o file
run 2 "$feltline" demo
run 2 "$feltline" demo -o x --size 3
run 2 "$feltline" demo -o x --device nonsense
