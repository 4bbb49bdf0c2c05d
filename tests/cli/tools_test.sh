# 'tools' prints every option with its default and range, as text and as JSON.
. "$(dirname "$0")/helpers.sh"

run 0 "$feltline" tools
has out "pencil  [p]"
has out "pencil.snap"
has out "off|force|snap|both"
has out "surface.material"
is_empty err
! grep -q $'\x1b' out || fail "colour in a pipe"
run 0 "$feltline" tools --json
lines out 1
cp out tools.json
if command -v python3 >/dev/null; then
  run 0 python3 - tools.json <<'END'
import json, sys
said = json.load(open(sys.argv[1]))
pencil = said["tools"][0]
assert pencil["id"] == "pencil" and pencil["help"]
for option in pencil["options"] + said["surface"]:
    assert option["label"] and option["help"], option
    if option["kind"] == "number": assert option["min"] <= option["default"] <= option["max"], option
    if option["kind"] == "choice": assert option["default"] in option["choices"], option
END
fi
run 2 "$feltline" tools nonsense
