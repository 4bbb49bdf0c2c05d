# 'record' and 'device-test' with the driver of a real device and a fake of the manufacturer's library
# ($FELT_OPENHAPTICS_LIBRARY), which runs in real time.
. "$(dirname "$0")/helpers.sh"
[ -e "$FELT_OPENHAPTICS_LIBRARY" ] || { echo "not built: $FELT_OPENHAPTICS_LIBRARY (./dev build)" >&2; exit 1; }
export HOME=$work/home
unset XDG_CONFIG_HOME
mkdir home

run 0 "$feltline" devices --json
has out '"name":"openhaptics:'
"$feltline" doctor openhaptics --json >out || true
has out '"drivers":'

run 0 "$feltline" record --device openhaptics -o sketch.ndjson --events events.ndjson \
  --forces forces.csv --seconds 1 --yes
[ "$(wc -l <events.ndjson)" -gt 50 ] || fail "hardly any event"
has events.ndjson '"event":"device"'
head -n 1 forces.csv | grep -q '^t_ms,x,y,z,' || fail "no forces"
run 0 "$feltline" replay events.ndjson --as-recorded -o again.ndjson
same sketch.ndjson again.ndjson

# The fake simulates a hand that draws circles: 3 s in the air, then 3 s on the desk.
FAKE_LIBHD_HAND=circles run 0 "$feltline" record --device openhaptics -o circle.ndjson \
  --seconds 7 --forces-on --yes
# This gives one stroke, or more if the machine is so busy that samples are missing.
[ "$(wc -l <circle.ndjson)" -ge 1 ] || fail "no ink of the hand's circles: $(cat err)"
has err " strokes in circle.ndjson"

# The drawing names its surface and contains the text of this material.
mkdir -p home/.local/share
unset XDG_DATA_HOME
run 0 "$feltline" materials new my-paper --from rough-paper --save
run 0 "$feltline" record --device openhaptics -o own.svg --set surface.material=my-paper --seconds 0.5 --yes
has own.svg 'felt:surface="my-paper"'
has own.svg 'id = &quot;my-paper&quot;'
run 0 "$feltline" record --device openhaptics -o own.felt --set surface.material=my-paper --seconds 0.5 --yes
run 0 "$feltline" convert own.felt -o back.svg
has back.svg 'felt:surface="my-paper"'

# Forces need the consent of the user.
run 1 "$feltline" record --device openhaptics -o no.ndjson --forces-on --seconds 1 </dev/null
has err "did not agree"
[ ! -e no.ndjson ] || fail "an output without a drawing"

# soon COMMAND...: waits until COMMAND succeeds. Fails after about 30 s, because the machine may be
# busy.
soon() {
  for _ in $(seq 300); do
    ! "$@" || return 0
    sleep 0.1
  done
  fail "never: $*"
}

# Ctrl-C ends the recording and saves it, also if the signal arrives twice, as from timeout(1).
"$feltline" record --device openhaptics -o ended.ndjson 2>ended.err &
pid=$!
# The program installs its signal handlers before its first message. Each run has its own file for
# messages, because old messages of another run would look like the first one.
soon test -s ended.err
kill -INT $pid
kill -INT $pid 2>/dev/null || true
wait $pid || fail "ended with $? after Ctrl-C: $(cat ended.err)"
[ -e ended.ndjson ] || fail "nothing saved after Ctrl-C"

# Ctrl-Z stops the program after all forces are off, and it can continue. Ctrl-backslash ends and saves.
"$feltline" record --device openhaptics -o quit.ndjson 2>quit.err &
pid=$!
soon test -s quit.err
kill -TSTP $pid
soon grep -q '^State:.T' /proc/$pid/status
kill -CONT $pid
soon grep -q "Forces are off" quit.err
kill -QUIT $pid
wait $pid || fail "ended with $? after Ctrl-backslash: $(cat quit.err)"
[ -e quit.ndjson ] || fail "nothing saved after Ctrl-backslash"
for copy in *.unsaved-*; do [ ! -e "$copy" ] || fail "$copy was left"; done

# If the terminal disappears (its window is closed, the ssh connection ends), the program saves and
# ends. It also ends normally if its messages cannot be written.
if command -v script >/dev/null; then
  export TERM=xterm  # a terminal that can show the status line
  # shellcheck disable=SC2016  # the inner shell expands the variables
  SHELL=/bin/sh script -qc "echo \$\$ >pid; exec '$feltline' record --device openhaptics -o hung_up.felt" \
    /dev/null </dev/zero >screen 2>&1 &
  terminal=$!
  soon grep -q "Hz" screen
  kill -KILL $terminal
  soon test -e hung_up.felt
  soon eval '! kill -0 "$(cat pid)" 2>/dev/null'
fi
if [ -w /dev/full ]; then
  code=0
  "$feltline" record --device openhaptics -o full.felt --seconds 1 --yes 2>/dev/full || code=$?
  [ "$code" = 0 ] || fail "exit code $code with a full log"
  run 0 "$feltline" info full.felt
fi

# If the program is killed, its copy of the drawing remains. recover finds the copy and convert reads
# it.
FAKE_LIBHD_HAND=circles "$feltline" record --device openhaptics -o killed.felt --yes 2>killed.err &
pid=$!
soon eval 'compgen -G "killed.felt.unsaved-*" >/dev/null'
kill -KILL $pid
wait $pid 2>/dev/null
run 0 "$feltline" recover --list --from .
has out "killed.felt.unsaved-$pid.ndjson"
run 0 "$feltline" convert "killed.felt.unsaved-$pid.ndjson" -o killed.felt
rm "killed.felt.unsaved-$pid.ndjson"

run 1 "$feltline" record --device nonsense -o x.ndjson
has err "there is no device 'nonsense'"
run 2 "$feltline" record -o x.ndjson
run 2 "$feltline" record --device openhaptics -o x.docx
run 2 "$feltline" record --device openhaptics -o x.ndjson --set pencil.nonsense=1
run 1 "$feltline" record --device openhaptics -o /no/such/folder/x.ndjson
[ ! -e x.ndjson ] || fail "a wrong command line made a file"

# Only the tests of opening and identity run here, because they do not depend on the machine's load.
run 0 "$feltline" device-test openhaptics --level 2 --yes --report report.txt
has report.txt "opens and closes"
has report.txt "FAKE-0001"
