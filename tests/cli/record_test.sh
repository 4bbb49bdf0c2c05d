# 'record' and 'device-test' with a driver of a real device, before the fake of its maker's library
# ($FELT_OPENHAPTICS_LIBRARY), which lives in real time.
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

# A hand behind the fake that draws circles: 3 s in the air, 3 s on the desk.
FAKE_LIBHD_HAND=circles run 0 "$feltline" record --device openhaptics -o circle.ndjson \
  --seconds 7 --forces-on --yes
# One stroke, or more where this machine was so busy that the pen fell silent in between.
[ "$(wc -l <circle.ndjson)" -ge 1 ] || fail "no ink of the hand's circles: $(cat err)"
has err " strokes in circle.ndjson"

# The drawing says what it was drawn on, and brings it along.
mkdir -p home/.local/share
unset XDG_DATA_HOME
run 0 "$feltline" materials new my-paper --from rough-paper --save
run 0 "$feltline" record --device openhaptics -o own.svg --set sheet.material=my-paper --seconds 0.5 --yes
has own.svg 'felt:surface="my-paper"'
has own.svg 'id = &quot;my-paper&quot;'
run 0 "$feltline" record --device openhaptics -o own.felt --set sheet.material=my-paper --seconds 0.5 --yes
run 0 "$feltline" convert own.felt -o back.svg
has back.svg 'felt:surface="my-paper"'

# Forces need a person who agrees.
run 1 "$feltline" record --device openhaptics -o no.ndjson --forces-on --seconds 1 </dev/null
has err "nobody agreed"
[ ! -e no.ndjson ] || fail "an output without a drawing"

# soon COMMAND...: waits until it holds, for as long as a busy machine may need.
soon() {
  for _ in $(seq 300); do
    ! "$@" || return 0
    sleep 0.1
  done
  fail "never: $*"
}

# Ctrl-C ends and saves, also when it is told twice at once, as timeout(1) does.
"$feltline" record --device openhaptics -o ended.ndjson 2>ended.err &
pid=$!
# It listens to signals before it says anything; the file is its own, or words of another run would
# be taken for its.
soon test -s ended.err
kill -INT $pid
kill -INT $pid 2>/dev/null || true
wait $pid || fail "ended with $? after Ctrl-C: $(cat ended.err)"
[ -e ended.ndjson ] || fail "nothing saved after Ctrl-C"

# Ctrl-Z stops it once no force is left, and it goes on; Ctrl-backslash ends and saves.
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

# A terminal that goes away (a window closed, ssh dropped) ends it in order; so do messages that
# cannot be written anywhere.
if command -v script >/dev/null; then
  export TERM=xterm  # one that shows the status line
  # shellcheck disable=SC2016  # the inner shell's variables
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

# A kill leaves the copy, which recover finds and convert reads.
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

# Opening, identity: what does not depend on how busy this machine is.
run 0 "$feltline" device-test openhaptics --level 2 --yes --report report.txt
has report.txt "opens and closes"
has report.txt "FAKE-0001"
finish
