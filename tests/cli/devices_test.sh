# The output of 'devices' and 'doctor', as text and as JSON. Output about real devices is tested in
# apps/cli/*_test.cc, because any device, or none, may be connected to this machine.
. "$(dirname "$0")/helpers.sh"

run 0 "$feltline" devices
has out "touch"
has out "typical"
has out "simulated"
head -n 1 out | grep -q 'connected' || fail "the first line is: $(head -n 1 out)"
! grep -q $'\x1b' out || fail "colour in a pipe"
cp out first
run 0 "$feltline" devices
same out first

run 0 "$feltline" devices --json
lines out 1
cp out devices.json
if command -v python3 >/dev/null; then
  run 0 python3 - devices.json <<'END'
import json, sys
said = json.load(open(sys.argv[1]))
assert isinstance(said["troubles"], list)
touch = [d for d in said["devices"] if d["name"] == "touch"][0]
assert touch["simulated"] is True and touch["max_force_n"] == 3.3, touch
assert len(said["hands"]) == 4 and all(h["simulated"] for h in said["hands"])
assert all(d["source"] for d in said["devices"])
END
fi
run 2 "$feltline" devices nonsense

# 'doctor' on a machine without installed devices, with a home folder that can be written.
export HOME=$work/home
unset XDG_CONFIG_HOME XDG_STATE_HOME DISPLAY WAYLAND_DISPLAY
mkdir home
"$feltline" doctor >out 2>err
code=$?
[ $code -le 1 ] || fail "doctor ended with $code"
head -n 1 out | grep -Eq 'No haptic device is connected|Ready to draw|fixing|Perhaps' ||
  fail "the first line is: $(head -n 1 out)"
has out "Settings are kept in"
is_empty err
! grep -q $'\x1b' out || fail "colour in a pipe"
run $code "$feltline" doctor --json
lines out 1
has out '"problems":'
run 2 "$feltline" doctor nonsense
run 2 "$feltline" doctor --yes
run 2 "$feltline" doctor --fix --json

# An unusable home folder is a problem: the exit code is 1, and the suggested repair is a command.
HOME='' run 1 "$feltline" doctor
has out "MEND"
has out "export HOME="

# --fix writes only after the user agrees, makes no further change in a second run, and never overwrites
# a file that Feltline did not write.
run 0 "$feltline" doctor --fix --dry-run --prefix "$work/root"
[ ! -e root ] || fail "--dry-run wrote"
if grep -q rtprio out; then
  run 1 "$feltline" doctor --fix --prefix "$work/root" </dev/null
  has err "--yes"
  [ ! -e root ] || fail "it wrote without consent"
  limits=root/etc/security/limits.d/70-feltline.conf
  run 0 "$feltline" doctor --fix --yes --prefix "$work/root"
  has out "Written: $work/$limits"
  has "$limits" "rtprio 80"
  cp "$limits" first
  run 0 "$feltline" doctor --fix --yes --prefix "$work/root"
  has out "already exists with the right content"
  same "$limits" first
  echo "somebody's" >"$limits"
  run 1 "$feltline" doctor --fix --yes --prefix "$work/root"
  has err "not changed"
  [ "$(cat "$limits")" = "somebody's" ] || fail "it overwrote a file of another program"
fi
# The device test on simulated pens. It runs in virtual time, so each run gives the same report.
run 0 "$feltline" device-test premium --report report.txt
has out "Device test: Phantom Premium 1.5, simulated"
has out "15 passed."
same out report.txt
run 0 "$feltline" device-test premium --report report.json
run 0 "$feltline" device-test premium --json
same out report.json
has out '"passed":true'
run 0 "$feltline" device-test mouse --level 2
lines out 11
run 1 "$feltline" device-test nonsense
has err "there is no device 'nonsense'"
run 2 "$feltline" device-test
run 2 "$feltline" device-test touch --level 11
run 1 "$feltline" device-test touch --level 1 --report /no/such/folder/report.txt
