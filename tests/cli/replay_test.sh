# Plays scripts and strokes with the simulated pen and checks outputs, columns, errors and determinism.
. "$(dirname "$0")/helpers.sh"

strokes 3 >in.ndjson
cat >events.ndjson <<'END'
{"feltline":1,"unit":"mm"}
{"event":"tool","id":"pencil","t_ms":0}
{"event":"option","id":"pencil.snap","value":"off","t_ms":0}
{"event":"hand","x":20,"y":30,"z":5,"t_ms":0}
{"event":"hand","x":20,"y":30,"z":5,"t_ms":700}
{"event":"hand","x":20,"y":30,"z":-3,"t_ms":800}
{"event":"hand","x":60,"y":40,"z":-3,"t_ms":1300}
{"event":"hand","x":60,"y":40,"z":5,"t_ms":1400}
END

# Each raw stroke gives one stroke, and two runs give the same bytes in all outputs.
for n in 1 2; do
  run 0 "$feltline" replay in.ndjson -o "s$n.ndjson" --forces "f$n.csv" --plot "p$n.png" --set pencil.snap=off
  is_empty out
  is_empty err
done
same s1.ndjson s2.ndjson
same f1.csv f2.csv
same p1.png p2.png
lines s1.ndjson 3
run 0 "$feltline" replay - -o - <in.ndjson  # recorded strokes do not snap unless asked
same out s1.ndjson
run 0 "$feltline" replay in.ndjson --forces - --set pencil.snap=off
same out f1.csv
run 0 "$feltline" replay in.ndjson -o s.svg
run 0 "$feltline" replay in.ndjson -o s.png --dpi 50

# The table of forces begins with fixed columns. A group of columns per force term follows. It has one
# row per millisecond.
header=t_ms,x,y,z,vx,vy,vz,pressure,ask_x,ask_y,ask_z,sent_x,sent_y,sent_z,
[[ $(head -n 1 f1.csv) == "$header"* ]] || fail "columns: $(head -n 1 f1.csv)"
for column in plane_x plane_y plane_z friction_x friction_y friction_z; do
  [[ ,$(head -n 1 f1.csv), == *",$column,"* ]] || fail "no column $column"
done
awk -F, 'NR == 1 { n = NF; next }
  NF != n { print "row " NR " has " NF " columns"; bad = 1; exit }
  NR > 2 && $1 - last < 0.999 { print "row " NR ": time " $1 " after " last; bad = 1; exit }
  { last = $1
    force = sqrt($12 * $12 + $13 * $13 + $14 * $14)
    if (force > largest) largest = force
    if (force > 2.5 + 1e-9) { print "row " NR ": " force " N"; bad = 1; exit } }
  END { if (largest < 0.2) { print "nothing was felt: " largest " N"; bad = 1 }
        exit bad }' f1.csv >columns || fail "$(cat columns)"

# Events, stdin, an initial sketch, options.
run 0 "$feltline" replay events.ndjson -o e.ndjson
lines e.ndjson 1
run 0 "$feltline" replay - -o - <events.ndjson
same out e.ndjson
run 0 "$feltline" replay events.ndjson --on s1.ndjson -o on.ndjson
lines on.ndjson 4
run 0 "$feltline" replay events.ndjson events.ndjson -o twice.ndjson
lines twice.ndjson 2
run 0 "$feltline" replay events.ndjson -o glass.ndjson --surface glass
cmp -s glass.ndjson e.ndjson && fail "the surface changes nothing"
run 0 "$feltline" replay events.ndjson -o chalk.ndjson --medium chalk
has chalk.ndjson '"material":"chalk"'
run 0 "$feltline" replay events.ndjson -o light.ndjson --hand light --device premium
cmp -s light.ndjson e.ndjson && fail "hand and pen change nothing"
run 0 "$feltline" replay events.ndjson -o fast.ndjson --rate 4000 --delay 2
run 0 "$feltline" replay in.ndjson -o shaken.ndjson --seed 7 --set pencil.snap=off
cmp -s shaken.ndjson s1.ndjson && fail "the tremor changes nothing"
run 0 "$feltline" replay in.ndjson -o small.ndjson --mm-per-unit 0.1 --set pencil.snap=off
# The limit is that of the forces and of full pressure.
run 0 "$feltline" replay in.ndjson -o limited.ndjson --device premium --limit 0.3 --forces limited.csv
awk -F, 'NR > 1 && $12 * $12 + $13 * $13 + $14 * $14 > 0.3 * 0.3 + 1e-6 { exit 1 }' limited.csv || fail "a force exceeded --limit"
run 0 "$feltline" replay in.ndjson -o free.ndjson --device premium --forces free.csv
awk -F, 'NR > 1 && $12 * $12 + $13 * $13 + $14 * $14 > 0.4 * 0.4 { n++ } END { exit n == 0 }' free.csv || fail "without --limit, the forces are as weak"
run 0 "$feltline" replay in.ndjson -o whole.ndjson --device premium --limit 3 --forces whole.csv
cmp -s whole.csv free.csv || fail "--limit 3 is not the default"
run 2 "$feltline" replay in.ndjson --limit 3.1
run 2 "$feltline" replay in.ndjson --limit 0
has err "'0' is not a number in 0.1..3"
# A push of the pencil of more than 0.9 N is cut to the limit on each device.
echo '{"points":[[40,40,1,0],[60,45,1,500],[80,40,1,1000]]}' >firm.ndjson
for device in omega delta hapticmaster; do
  run 0 "$feltline" replay firm.ndjson -o free.ndjson --device $device --forces free.csv
  run 0 "$feltline" replay firm.ndjson -o half.ndjson --device $device --limit 0.5 --forces half.csv
  awk -F, 'NR > 1 && $12 * $12 + $13 * $13 + $14 * $14 > 0.9 * 0.9 { n++ } END { exit n == 0 }' free.csv || fail "$device: no force of 0.9 N"
  awk -F, 'NR > 1 && $12 * $12 + $13 * $13 + $14 * $14 > 0.5 * 0.5 + 1e-6 { exit 1 }' half.csv || fail "$device: a force exceeded --limit"
done
# The other devices of the paper: no force out of the page, a force every 4 ms, cues instead of forces.
run 0 "$feltline" replay in.ndjson -o stick.ndjson --device joystick --forces stick.csv --set pencil.snap=off
lines stick.ndjson 3
run 2 "$feltline" replay in.ndjson -o fast.ndjson --device hapticmaster --rate 1000
has err "hapticmaster accepts at most 250 forces a second"
run 0 "$feltline" replay in.ndjson --device vibrating-mouse --stats json
has out '"max_force_n":0'
has out '"cues":'
run 0 "$feltline" replay in.ndjson --device mouse --stats json
grep -q '"cues"' out && fail "a mouse plays no cues"
run 0 "$feltline" replay in.ndjson --no-force --forces none.csv -o none.ndjson --set pencil.snap=off
lines none.ndjson 3
awk -F, 'NR > 1 && ($12 != 0 || $13 != 0 || $14 != 0) { exit 1 }' none.csv || fail "a force was sent despite --no-force"
mkdir folder
cp s1.ndjson folder/sketch.ndjson
echo '{"event":"import","path":"sketch.ndjson","t_ms":0}' >folder/import.ndjson
run 0 "$feltline" replay folder/import.ndjson -o imported.ndjson
lines imported.ndjson 3
cp folder/sketch.ndjson before.ndjson
run 1 "$feltline" replay folder/import.ndjson -o folder/sketch.ndjson
has err "would overwrite"
same folder/sketch.ndjson before.ndjson

# If a script is stopped in the middle, the output shows the gesture in progress, but no later event.
cat >pull.ndjson <<'END'
{"t_ms":0,"event":"tool","id":"pull"}
{"t_ms":0,"event":"hand","x":30,"y":50,"z":5}
{"t_ms":700,"event":"hand","x":30,"y":50,"z":5}
{"t_ms":800,"event":"hand","x":30,"y":50,"z":-2}
{"t_ms":1600,"event":"hand","x":30,"y":62,"z":-2}
{"t_ms":2000,"event":"hand","x":30,"y":50,"z":-2}
{"t_ms":2200,"event":"hand","x":30,"y":50,"z":5}
END
cat >line.ndjson <<'END'
{"id":"s1","closed":false,"segments":[[10,50,25,50,40,50,55,50]],"joints":[],"widths":[[0,1],[1,1]]}
END
run 0 "$feltline" replay pull.ndjson --on line.ndjson --until 500 -o before.ndjson
run 0 "$feltline" replay pull.ndjson --on line.ndjson --until 1600 -o during.ndjson
lines during.ndjson 1
cmp -s before.ndjson during.ndjson && fail "the preview is not visible"
run 0 "$feltline" replay pull.ndjson --on line.ndjson --until 9000 -o beyond.ndjson
run 0 "$feltline" replay pull.ndjson --on line.ndjson -o whole.ndjson
same beyond.ndjson whole.ndjson
run 0 "$feltline" replay pull.ndjson --on line.ndjson --until 1600 -o plain.png --dpi 60
run 0 "$feltline" replay pull.ndjson --on line.ndjson --until 1600 --overlay -o seen.png --dpi 60
cmp -s plain.png seen.png && fail "the overlay is not visible"
run 0 "$feltline" replay pull.ndjson --on line.ndjson --until 1600 --overlay -o seen2.png --dpi 60
same seen.png seen2.png
run 0 "$feltline" replay pull.ndjson --on line.ndjson --overlay -o end.png --dpi 60
run 2 "$feltline" replay pull.ndjson --overlay -o seen.svg
has err "overlay needs -o OUT.png"
run 2 "$feltline" replay pull.ndjson --overlay --stats json
run 2 "$feltline" replay pull.ndjson --until soon -o x.ndjson
run 2 "$feltline" replay pull.ndjson --until -1 -o x.ndjson

# The counts of --stats.
run 0 "$feltline" replay in.ndjson --stats json --set pencil.snap=off
lines out 1
for key in ticks simulated_s wall_s times_real_time soft_faults max_force_n; do
  has out "\"$key\":"
done
has out '"strokes_meant":3,"strokes":3,'
has out '"intended_to_ink_mm":{"mean":0.'

# Errors name the file, the line and the reason, and write nothing.
echo old >kept.ndjson
bad() { # TEXT REASON: checks that a script with the line TEXT fails with REASON
  printf '%s\n' "$1" >bad.ndjson
  run 1 "$feltline" replay events.ndjson bad.ndjson -o kept.ndjson
  has err "$2"
  [ "$(cat kept.ndjson)" = old ] || fail "an error wrote $(head -c 80 kept.ndjson)"
}
bad '{"event":"nonsense","t_ms":0}' "feltline: bad.ndjson:1: "
bad '{"event":"hand","x":1,"y":2,"z":"high","t_ms":0}' "feltline: bad.ndjson:1: z"
bad '{"event":"undo"}' 'bad.ndjson:1: key "t_ms" is missing'
bad '{"event":"tool","id":"pencill","t_ms":0}' "bad.ndjson:1: "
bad '{"event":"option","id":"pencil.snap","value":"maybe","t_ms":0}' "bad.ndjson:1: "
bad '{"event":"import","path":"nowhere.ndjson","t_ms":0}' "nowhere.ndjson"
bad 'no JSON' "bad.ndjson:1: "
bad '{"points":[[1,"a"]]}' "bad.ndjson:1: points[0]"
printf '{"t_ms":%s,"event":"hand","x":0,"y":0,"z":5}\n' 0 86400001 >days.ndjson
run 1 "$feltline" replay days.ndjson -o x.ndjson
lines err 1
has err "feltline: days.ndjson: event 2, at 86400001 ms: the script is longer than 86400000 ms"
run 1 "$feltline" replay nowhere.ndjson -o x.ndjson
has err "feltline: nowhere.ndjson: No such file"
run 1 "$feltline" replay events.ndjson --on nowhere.ndjson -o x.ndjson
run 1 "$feltline" replay events.ndjson -o nowhere/x.ndjson
has err "nowhere/x.ndjson"

# Wrong usage.
run 2 "$feltline" replay events.ndjson
has err "replay needs -o OUT, --forces, --plot, --sound or --stats"
run 2 "$feltline" replay -o x.ndjson
run 2 "$feltline" replay events.ndjson -o x.ndjson --device nonsense
run 2 "$feltline" replay events.ndjson -o x.ndjson --hand nonsense
run 2 "$feltline" replay events.ndjson -o x.ndjson --rate 10
run 2 "$feltline" replay events.ndjson -o x.ndjson --delay 9
run 2 "$feltline" replay events.ndjson -o x.ndjson --material cheese
run 2 "$feltline" replay events.ndjson -o x.ndjson --medium cheese
run 2 "$feltline" replay events.ndjson -o x.ndjson --set pencil.snap
run 2 "$feltline" replay events.ndjson -o x.ndjson --set pencil.nonsense=1
run 2 "$feltline" replay events.ndjson -o x.ndjson --set pencil.max_width_mm=wide
run 2 "$feltline" replay events.ndjson -o - --stats json
[ ! -e x.ndjson ] || fail "a wrong command line made a file"

# If replay is killed, older output files are unchanged.
strokes 600 >long.ndjson
echo old >k.csv
"$feltline" replay long.ndjson -o kept.ndjson --forces k.csv 2>/dev/null &
pid=$!
sleep 0.3
kill -KILL "$pid" 2>/dev/null && wait "$pid" 2>/dev/null
[ "$(cat kept.ndjson)" = old ] || fail "a killed replay left a sketch"
[ "$(cat k.csv)" = old ] || fail "a killed replay left forces"
# If a format cannot represent a stroke, the error names the stroke and no output is written.
cat >far.ndjson <<'END'
{"event":"hand","t_ms":0,"x":1e9,"y":1e9,"z":-1e9}
{"event":"hand","t_ms":1000,"x":-1e9,"y":1,"z":-3}
END
run 1 "$feltline" replay far.ndjson -o far.svg
has err "far.svg: layer 1: stroke 1"
[ ! -e far.svg ] || fail "a sketch that failed was written"

# --recording does not change the strokes, and playing the recording gives the same strokes, bit for
# bit.
run 0 "$feltline" replay events.ndjson -o plain.ndjson
run 0 "$feltline" replay events.ndjson --recording -o kept.felt
run 0 "$feltline" convert kept.felt -o kept.ndjson
run 0 "$feltline" replay kept.felt --as-recorded -o played.ndjson
run 0 "$feltline" replay kept.felt --as-recorded -o played.felt
run 0 "$feltline" convert played.felt -o played.felt.ndjson
cut -d, -f2- kept.ndjson >kept.shapes
cut -d, -f2- played.ndjson >played.shapes
same played.shapes kept.shapes
cut -d, -f2- plain.ndjson >plain.shapes
same plain.shapes kept.shapes
# The surface, page and colours are also the same, and so is the grain.
run 0 "$feltline" replay events.ndjson --recording -o surface.felt --surface rough-paper --medium charcoal --page A5
run 0 "$feltline" replay surface.felt --as-recorded -o again.felt
for name in surface again; do
  run 0 "$feltline" convert $name.felt -o $name.svg
  run 0 "$feltline" render $name.felt -o $name.png --dpi 50 --grain
done
has again.svg 'felt:surface="rough-paper"'
same again.svg surface.svg
same again.png surface.png
run 1 "$feltline" replay played.felt --as-recorded -o x.ndjson
has err "has no recording"
run 2 "$feltline" replay events.ndjson --recording -o x.svg
has err "--recording needs -o OUT.felt"
run 2 "$feltline" replay events.ndjson --recording --on s1.ndjson -o x.felt
has err "cannot be used with --on"

# With --as-recorded, the session gets the events directly: pen events draw without the haptic loop.
cat >recorded.ndjson <<'END'
{"t_ms":0,"event":"device","senses_pressure":true}
{"t_ms":0,"event":"option","id":"pencil.snap","value":"off"}
{"t_ms":1,"event":"pen","x":10,"y":10,"z":0,"pressure":0.5}
{"t_ms":2,"event":"pen","x":12,"y":11,"z":0,"pressure":0.5}
{"t_ms":3,"event":"pen","x":14,"y":13,"z":0,"pressure":0.6}
{"t_ms":4,"event":"pen","x":16,"y":16,"z":4,"pressure":0}
{"t_ms":90,"event":"import","path":"s1.ndjson"}
END
run 0 "$feltline" replay recorded.ndjson --as-recorded -o recorded.out.ndjson
lines recorded.out.ndjson 4
# Like recordings of Feltline 0.1.0, this one does not name the version of the default options.
has err "recorded.ndjson: recorded by an earlier version"
sed -i 's/"senses_pressure":true/&,"defaults":9/' recorded.ndjson
run 0 "$feltline" replay recorded.ndjson --as-recorded -o recorded.out.ndjson
is_empty err
mkdir -p elsewhere
cd elsewhere || exit 1
run 0 "$feltline" replay ../recorded.ndjson --as-recorded -o here.ndjson
same here.ndjson ../recorded.out.ndjson
cd ..
run 0 "$feltline" replay recorded.ndjson --as-recorded --on s1.ndjson -o recorded.on.ndjson
lines recorded.on.ndjson 7
for option in "--forces f.csv" "--plot p.png" "--device touch" "--until 5" "--set pencil.snap=off"; do
  # shellcheck disable=SC2086  # must be split into words
  run 2 "$feltline" replay recorded.ndjson --as-recorded -o x.ndjson $option
  has err "${option%% *} cannot be used with --as-recorded"
done
run 2 "$feltline" replay recorded.ndjson recorded.ndjson --as-recorded -o x.ndjson
has err "one recording at a time"
run 1 "$feltline" replay events.ndjson --as-recorded -o x.ndjson
has err "events.ndjson:4: hand events"
run 1 "$feltline" replay in.ndjson --as-recorded -o x.ndjson
has err "in.ndjson:1: found a stroke, but only events are allowed"
run 1 "$feltline" replay recorded.ndjson -o x.ndjson
has err "device events are only allowed in recordings"

# Sound is a .wav file with 16 bits, 48 kHz and one channel, as long as the session. Each run gives the
# same bytes.
run 0 "$feltline" replay events.ndjson --sound s.wav
is_empty out
is_empty err
run 0 "$feltline" replay events.ndjson --sound s2.wav -o with.ndjson
same s.wav s2.wav
same with.ndjson e.ndjson
run 0 "$feltline" replay events.ndjson --sound - <events.ndjson
same out s.wav
[ "$(head -c 4 s.wav)" = RIFF ] || fail "no RIFF: $(head -c 4 s.wav)"
# number OFFSET BYTES: prints a number of the header of s.wav.
number() { od -An -j "$1" -N "$2" -t "u$2" s.wav | tr -d ' '; }
[ "$(number 22 2) $(number 24 4) $(number 34 2)" = "1 48000 16" ] || fail "channels, rate, bits"
[ "$(number 40 4)" = $(($(wc -c <s.wav) - 44)) ] || fail "the header says another length"
# The sound is slightly longer than the session, which lasts about 1.45 s; 1 s has 96000 bytes.
bytes=$(wc -c <s.wav)
[ "$bytes" -gt 130000 ] && [ "$bytes" -lt 160000 ] || fail "$bytes bytes of sound"
# loudness FILE FROM TO: prints the sum of the absolute samples between the times FROM and TO, in s.
loudness() {
  od -An -v -w2 -t d2 -j $((44 + 2 * $(awk "BEGIN { print int(48000 * $2) }"))) \
    -N $((2 * $(awk "BEGIN { print int(48000 * ($3 - $2)) }"))) "$1" |
    awk '{ sum += $1 < 0 ? -$1 : $1 } END { print sum + 0 }'
}
[ "$(loudness s.wav 0.1 0.65)" = 0 ] || fail "a pen in the air makes a sound"
[ "$(loudness s.wav 0.9 1.25)" -gt 500000 ] || fail "a pen that draws makes no sound"
run 0 "$feltline" replay events.ndjson --sound glass.wav --material glass
[ "$(loudness glass.wav 0.9 1.25)" -lt "$(loudness s.wav 0.9 1.25)" ] || fail "glass is not quieter"
# --sound with --as-recorded uses the samples of the recording.
run 0 "$feltline" replay recorded.ndjson --as-recorded --sound r.wav
run 0 "$feltline" replay recorded.ndjson --as-recorded --sound r2.wav -o r.ndjson
same r.wav r2.wav
same r.ndjson recorded.out.ndjson
# If an error occurs, an older output is kept.
echo old >kept.wav
run 1 "$feltline" replay bad.ndjson --sound kept.wav
[ "$(cat kept.wav)" = old ] || fail "an error wrote a sound"
run 1 "$feltline" replay events.ndjson --sound nowhere/s.wav
has err "nowhere/s.wav"
run 2 "$feltline" replay events.ndjson --sound - -o -
has err "can use stdout"
run 2 "$feltline" replay recorded.ndjson --as-recorded --sound - -o -
run 2 "$feltline" replay recorded.ndjson --as-recorded
has err "needs -o OUT or --sound"

# Raw pressures and times of strokes are named, those of events refused; with --strict nothing is written.
echo '{"points":[[10,10,512,0],[20,10,700,0.01],[30,10,900,0.02],[40,10,900,0.03]]}' >raw.ndjson
run 0 "$feltline" replay raw.ndjson -o raw.out.ndjson
has err "raw.ndjson: stroke '1' (4 of 4 pressures, for example 900) has pressures outside 0 to 1"
has err "has times that are not milliseconds"
run 1 "$feltline" --strict replay raw.ndjson -o strict.ndjson
[ ! -e strict.ndjson ] || fail "--strict wrote a file"
run 0 "$feltline" timelapse raw.ndjson -o raw.svg
has err "has pressures outside 0 to 1"
run 1 "$feltline" --strict timelapse raw.ndjson -o strict.svg
[ ! -e strict.svg ] || fail "--strict wrote a film"
echo '{"event":"pen","x":1,"y":2,"z":0,"pressure":512,"t_ms":0}' >raw_event.ndjson
run 1 "$feltline" replay raw_event.ndjson -o strict.ndjson
has err "raw_event.ndjson:1: pressure: is not between 0 and 1"

# A line that needs a layer where there are too many draws nothing; replay counts such gestures.
awk 'BEGIN {
  print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" viewBox=\"0 0 100 100\" " \
    "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" " \
    "xmlns:sodipodi=\"http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd\">"
  for (i = 1; i <= 10000; i++) {
    printf "<g inkscape:groupmode=\"layer\" inkscape:label=\"%d\" sodipodi:insensitive=\"true\">", i
    if (i == 1) printf "<path d=\"M10 10L50 40\" stroke=\"red\" fill=\"none\"/>"
    print "</g>"
  }
  print "</svg>" }' >full.svg
for y in 20 40; do
  printf '{"t_ms":%d,"event":"pen","x":10,"y":%d,"z":%d}\n' $((y * 100)) $y 5 $((y * 100 + 50)) $y -1
  printf '{"t_ms":%d,"event":"pen","x":60,"y":%d,"z":%d}\n' $((y * 100 + 200)) $y -1 $((y * 100 + 250)) $y 5
done >two_lines.ndjson
for how in "" --as-recorded; do
  # shellcheck disable=SC2086  # no word if it is empty
  run 0 "$feltline" replay two_lines.ndjson --on full.svg $how -o refused.felt
  has err "two_lines.ndjson: 2 gestures of the pen changed nothing: all layers are hidden or locked"
  [ "$(grep -c "changed nothing" err)" = 1 ] || fail "the gestures are not named once"
done
run 0 "$feltline" replay two_lines.ndjson -o drawn.felt
! grep -q "changed nothing" err || fail "a gesture that draws is counted"
