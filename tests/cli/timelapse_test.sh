# Makes films of recordings. A script takes the place of ffmpeg where only the frames matter.
. "$(dirname "$0")/helpers.sh"

# A recording of three strokes, an undo and a pull; and the drawing with the recording in it.
strokes 3 >strokes.ndjson
run 0 "$feltline" replay strokes.ndjson --no-force -o rec.felt --recording

# An encoder that keeps the raw frames, and one that fails.
mkdir fake broken empty
printf '#!/bin/sh\ncat >&3\n' >fake/ffmpeg
printf '#!/bin/sh\nhead -c 100000 >/dev/null\necho "no such codec" >&2\nexit 1\n' >broken/ffmpeg
chmod +x fake/ffmpeg broken/ffmpeg

# 2 s at 12 frames a second, of the page of 297 x 210 mm at 2 pixels per mm. The last frame is the picture of
# `feltline render`, byte for byte, and the same recording gives the same frames.
run 0 env PATH="$PWD/fake:$PATH" "$feltline" timelapse rec.felt -o raw.webm --seconds 2 --fps 12 --size 594x420
frame=$((594 * 420 * 4))
[ "$(stat -c %s raw.webm)" = $((24 * frame)) ] || fail "$(stat -c %s raw.webm) bytes of frames"
run 0 "$feltline" render rec.felt -o last.png --dpi 50.8
tail -c $frame raw.webm >last.rgba
python3 - <<'END' || fail "the last frame is not the picture of render"
import struct, sys, zlib
data, at, rows, size = open("last.png", "rb").read(), 8, b"", None
while at < len(data):
    length, kind = struct.unpack(">I4s", data[at:at + 8])
    body = data[at + 8:at + 8 + length]
    if kind == b"IHDR": size = struct.unpack(">IIBB", body[:10])
    if kind == b"IDAT": rows += body
    at += 12 + length
width, height, depth, color = size
bytes_per = {2: 3, 6: 4}[color]
raw, before, rgba = zlib.decompress(rows), bytearray(width * bytes_per), bytearray()
for y in range(height):
    line = raw[y * (width * bytes_per + 1):(y + 1) * (width * bytes_per + 1)]
    kind, now = line[0], bytearray(line[1:])
    for i in range(len(now)):
        a = now[i - bytes_per] if i >= bytes_per else 0
        b, c = before[i], before[i - bytes_per] if i >= bytes_per else 0
        if kind == 3: a = (a + b) // 2
        elif kind == 2: a = b
        elif kind == 4:
            p = a + b - c
            a = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
        elif kind == 0: a = 0
        now[i] = (now[i] + a) & 255
    for x in range(width):
        rgba += now[x * bytes_per:x * bytes_per + 3] + b"\xff"
    before = now
frame = open("last.rgba", "rb").read()
sys.exit(0 if (width, height) == (594, 420) and bytes(rgba) == frame else 1)
END
run 0 env PATH="$PWD/fake:$PATH" "$feltline" timelapse rec.felt -o again.webm --seconds 2 --fps 12 --size 594x420
same raw.webm again.webm
run 0 env PATH="$PWD/fake:$PATH" taskset -c 0 "$feltline" timelapse rec.felt -o one.webm --seconds 2 --fps 12 --size 594x420
same raw.webm one.webm
head -c $frame raw.webm >first.rgba
cmp -s first.rgba last.rgba && fail "the film does not move"

# --hold is a number of frames, as in `feltline inbetween`.
still_frames() {  # FILE: how many frames at the end are the same
  python3 -c '
import sys
data, size = open(sys.argv[1], "rb").read(), int(sys.argv[2])
frames = [data[at:at + size] for at in range(0, len(data), size)]
print(next((n for n, frame in enumerate(reversed(frames)) if frame != frames[-1]), len(frames)))' "$1" $frame
}
for hold in 3 9; do
  run 0 env PATH="$PWD/fake:$PATH" "$feltline" timelapse rec.felt -o hold.webm --seconds 2 --fps 12 --size 594x420 --hold $hold
  still=$(still_frames hold.webm)
  [ "$still" -ge $hold ] && [ "$still" -le $((hold + 2)) ] || fail "$still frames with --hold $hold"
done
rm hold.webm
run 2 "$feltline" timelapse rec.felt -o hold.webm --hold 1.5

# A script that a hand draws, a recording as lines, and stdin.
run 0 env PATH="$PWD/fake:$PATH" "$feltline" timelapse strokes.ndjson -o script.webm --size 160
printf '%s\n' '{"t_ms":0,"event":"pen","x":5,"y":5,"z":0,"pressure":0.5}' \
  '{"t_ms":50,"event":"pen","x":25,"y":15,"z":0,"pressure":0.5}' \
  '{"t_ms":100,"event":"pen","x":25,"y":15,"z":5,"pressure":0}' >pen.ndjson
run 0 env PATH="$PWD/fake:$PATH" "$feltline" timelapse pen.ndjson -o pen.webm --size 160
run 0 env PATH="$PWD/fake:$PATH" "$feltline" timelapse - -o - --to webm --size 160 <pen.ndjson
same out pen.webm
head -n 1 pen.ndjson >one.ndjson
run 0 env PATH="$PWD/fake:$PATH" "$feltline" timelapse one.ndjson -o sample.webm --size 160
run 0 env PATH="$PWD/fake:$PATH" "$feltline" timelapse pen.ndjson --on strokes.ndjson -o on.webm --size 160 ||
  fail "a script on a drawing"

# Errors keep the film before and leave nothing behind.
echo before >old.webm
run 1 env PATH="$PWD/broken:$PATH" "$feltline" timelapse rec.felt -o old.webm --size 594x420
has err 'old.webm: ffmpeg: no such codec'
[ "$(cat old.webm)" = before ] || fail "the old film is gone"
run 1 env PATH="$PWD/empty" "$feltline" timelapse rec.felt -o new.webm
has err 'Install the package ffmpeg'
[ ! -e new.webm ] || fail "a film without an encoder"
run 1 "$feltline" timelapse rec.felt -o no/folder/x.svg
has err 'no/folder/x.svg'
run 1 env PATH="$PWD/fake:$PATH" "$feltline" timelapse rec.felt -o /dev/full --to webm --size 160
has err 'No space left'
run 1 env PATH="$PWD/fake:$PATH" bash -c "ulimit -f 100; exec '$feltline' timelapse rec.felt -o large.webm --size 594x420"
[ ! -e large.webm ] || fail "a film that is too large has a name"
: >nothing.ndjson
run 1 "$feltline" timelapse nothing.ndjson -o new.svg
has err 'nothing.ndjson: nothing is drawn in it'
printf '%s\n' '{"t_ms":0,"event":"pen","x":NaN,"y":5,"z":0}' >nan.ndjson
run 1 "$feltline" timelapse nan.ndjson -o new.svg
has err 'nan.ndjson:1: '
head -c 100 pen.ndjson >cut.ndjson
run 1 "$feltline" timelapse cut.ndjson -o new.svg
has err 'cut.ndjson:2: '
run 0 "$feltline" fit strokes.ndjson -o ink.felt
run 1 "$feltline" timelapse ink.felt -o new.svg
has err 'has no recording'
[ ! -e new.svg ] || fail "an .svg after an error"
run 2 "$feltline" timelapse rec.felt -o film.avi
has err '.webm, a .gif or an .svg'
run 2 "$feltline" timelapse rec.felt -o film.webm --size 9
run 2 "$feltline" timelapse rec.felt -o film.webm --size 99999x20
run 2 "$feltline" timelapse rec.felt -o film.webm --seconds nan
run 2 "$feltline" timelapse rec.felt -o film.webm --paper transparent
run 2 "$feltline" timelapse rec.felt -o rec.felt --to webm

# Ctrl-C, while the encoder reads nothing: the film is not written, and the encoder does not stay.
mkdir stuck
printf '#!/bin/sh\necho $$ >pid\nexec sleep 1000\n' >stuck/ffmpeg
chmod +x stuck/ffmpeg
PATH="$PWD/stuck:$PATH" "$feltline" timelapse rec.felt -o stop.webm --seconds 600 >out 2>err &
film=$!
for _ in $(seq 300); do
  [ -s pid ] && break
  sleep 0.1
done
sleep 0.5
kill -TERM $film # a job in the background ignores SIGINT
code=0
wait $film || code=$?
[ $code = 1 ] || fail "exit code $code of a cancelled film"
has err 'stop.webm: cancelled'
kill -0 "$(cat pid)" 2>/dev/null && fail "the encoder still runs"
[ ! -e stop.webm ] || fail "a film that was cancelled has a name"

# The animated .svg is valid, and has no animation beyond its length.
run 0 "$feltline" timelapse rec.felt -o film.svg --seconds 4
if command -v xmllint >/dev/null; then run 0 xmllint --noout film.svg; fi
[ "$(grep -c '^<path fill=' film.svg)" = 3 ] || fail "not three strokes in film.svg"
[ "$(grep -c '<mask' film.svg)" = 3 ] || fail "not three masks in film.svg"

# With the real ffmpeg.
if command -v ffmpeg >/dev/null && command -v ffprobe >/dev/null; then
  run 0 "$feltline" timelapse rec.felt -o film.webm --seconds 2 --size 320
  run 0 ffprobe -v error -count_packets -of csv=p=0 -show_entries stream=codec_name,width,height,nb_read_packets film.webm
  has out 'vp9,320,226,48'
  run 0 "$feltline" timelapse rec.felt -o film.gif --seconds 2 --fps 10 --size 321x227
  run 0 ffprobe -v error -count_packets -of csv=p=0 -show_entries stream=codec_name,width,height,nb_read_packets film.gif
  has out 'gif,321,227,'
else
  echo 'ffmpeg is not installed: its films were not tested' >&2
fi

# A file that the recording imports is not overwritten.
"$feltline" fit "$(dirname "$0")/../../share/samples/page.ndjson" -o imported.svg -q || fail "fit"
cp imported.svg kept.svg
echo '{"event":"import","t_ms":0,"path":"imported.svg"}' >imports.ndjson
run 0 "$feltline" timelapse imports.ndjson -o film.SVG --seconds 1
run 1 "$feltline" timelapse imports.ndjson -o imported.svg --seconds 1
has err "would overwrite"
same imported.svg kept.svg
