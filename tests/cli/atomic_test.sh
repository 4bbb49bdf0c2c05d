# An output file is written completely or not at all.
. "$(dirname "$0")/helpers.sh"

strokes 50 >in.ndjson
echo "an older file" >old
# If the file system supports unnamed files, even a killed program leaves no temporary file.
leaves_none=$(stat -f -c %T . | grep -xE 'ext2/ext3|xfs|btrfs|tmpfs' || true)
for extension in ndjson svg png; do
  output=sketch.$extension
  for signal in KILL TERM HUP; do
    cp old "$output"
    mkfifo pipe
    "$feltline" fit pipe -o "$output" 2>/dev/null &
    pid=$!
    exec 3>pipe
    cat in.ndjson in.ndjson >&3
    sleep 0.2
    same old "$output"
    kill -"$signal" "$pid"
    wait "$pid" 2>/dev/null && fail "survived $signal"
    exec 3>&-
    rm pipe
    [ -z "$leaves_none" ] || [ -z "$(find . -name '.*.tmp')" ] || fail "$signal left $(find . -name '.*.tmp')"
    same old "$output"
  done
  cp old "$output"
  run 0 "$feltline" fit in.ndjson -o "$output" --dpi 50
  cmp -s old "$output" && fail "$output is still the older file"
done

# The same file as input and output is refused.
cp sketch.ndjson twice.ndjson
run 2 "$feltline" convert twice.ndjson -o twice.ndjson
same twice.ndjson sketch.ndjson

# So is every other file that a command reads: the options' files, and pictures that a drawing shows.
cp sketch.png picture.png
cp sketch.png relief.png
cat >shows.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="50mm" height="50mm" viewBox="0 0 50 50">
<image href="picture.png" width="20" height="10"/><path d="M5 5L40 30" stroke="black" fill="none"/></svg>
SVG
mkdir inside
ln -s ../picture.png inside/link.png
ln picture.png hard.png
for output in picture.png inside/link.png hard.png inside/../picture.png; do
  run 2 "$feltline" convert shows.svg -o "$output"
  has err "would overwrite the input"
  same picture.png sketch.png
done
run 2 "$feltline" fit in.ndjson --medium charcoal --surface relief.png -o relief.png
has err "would overwrite the input"
same relief.png sketch.png
printf '{"t_ms":0,"event":"pen","x":10,"y":10,"z":-1}\n{"t_ms":9,"event":"pen","x":20,"y":10,"z":5}\n' >pen.ndjson
run 1 "$feltline" replay pen.ndjson --surface relief.png --plot relief.png -o replayed.ndjson
has err "would overwrite the input"
same relief.png sketch.png
run 0 "$feltline" convert shows.svg -o shown.png
run 0 "$feltline" convert shows.svg -o shown.png
rm hard.png

# Writing to a symbolic link changes the file that it points to and keeps the permissions of that file.
mkdir kept
cp old kept/real.ndjson
chmod 640 kept/real.ndjson
ln -s kept/real.ndjson link.ndjson
run 0 "$feltline" fit in.ndjson -o link.ndjson
[ -L link.ndjson ] || fail "the link was replaced"
same kept/real.ndjson sketch.ndjson
[ "$(stat -c %a kept/real.ndjson)" = 640 ] || fail "permissions changed"

# Other names of the file (hard links) keep the old content, and a message says so.
cp old linked.ndjson
run 0 "$feltline" fit in.ndjson -o linked.ndjson
is_empty err
cp old linked.ndjson
ln linked.ndjson second.ndjson
run 0 "$feltline" fit in.ndjson -o linked.ndjson
has err "feltline: linked.ndjson: has 1 more name (hard links), which keeps the old content"
same linked.ndjson sketch.ndjson
same second.ndjson old
ln second.ndjson third.ndjson
ln second.ndjson fourth.ndjson
run 0 "$feltline" convert sketch.ndjson -o third.ndjson
has err "feltline: third.ndjson: has 2 more names (hard links), which keep the old content"
