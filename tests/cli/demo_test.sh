# The demonstration: all its files, the same each time, and a cat with every stroke.
acts=$(cd "$(dirname "$0")/../../share/demo" && pwd)
. "$(dirname "$0")/helpers.sh"

run 0 "$feltline" demo -o one
has out "pencil"
has out "In one: sketch.svg"
is_empty err
run 0 "$feltline" demo -o two/below --size 400
for file in sketch.ndjson sketch.svg forces.csv; do
  same "one/$file" "two/below/$file"
done
mkdir -p three
run 0 "$feltline" demo -o three
for file in sketch.png forces.png; do
  same "one/$file" "three/$file"
  [ "$(head -c 4 "one/$file" | tail -c 3)" = PNG ] || fail "$file is no PNG"
done
drawn=$(grep -c '"points"' "$acts/1-pencil.ndjson")
lines one/sketch.ndjson "$drawn"
run 0 "$feltline" info one/sketch.ndjson
has out "closed          1"
if command -v rsvg-convert >/dev/null; then
  run 0 rsvg-convert one/sketch.svg -o viewed.png
fi

# The script of the demonstration is an ordinary one: played by hand, the same drawing.
run 0 "$feltline" replay "$acts/1-pencil.ndjson" -o again.ndjson
same again.ndjson one/sketch.ndjson

run 1 "$feltline" demo -o /proc/nowhere
has err "feltline: /proc/nowhere"
echo >file
run 1 "$feltline" demo -o file
run 2 "$feltline" demo
run 2 "$feltline" demo -o x --size 3
run 2 "$feltline" demo -o x --device nonsense
finish
