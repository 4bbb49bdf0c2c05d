# What 'devices' says: for people, for programs.
. "$(dirname "$0")/helpers.sh"

run 0 "$feltline" devices
has out "touch"
has out "typical"
has out "simulated"
has out "Drivers for real devices are still to come."
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
touch = [d for d in said["devices"] if d["name"] == "touch"][0]
assert touch["simulated"] is True and touch["max_force_n"] == 3.3, touch
assert len(said["hands"]) == 4 and all(h["simulated"] for h in said["hands"])
assert all(d["source"] for d in said["devices"])
END
fi
run 2 "$feltline" devices nonsense
finish
