# Messages are never written into an output file, a failed message does not end the program, text from a
# file cannot control the terminal, and repeated messages of one kind are counted. An output never
# overwrites an input or another output.
. "$(dirname "$0")/helpers.sh"

strokes 3 >good.ndjson
{ cat good.ndjson; echo bad; } >bad.ndjson
cat >notices.svg <<'END'
<svg xmlns="http://www.w3.org/2000/svg" width="50mm" height="50mm" viewBox="0 0 50 50">
<text>not ink</text><path d="M0 0L20 20" stroke="red" fill="none"/></svg>
END

# If standard streams are closed at the start, an output file must not get their descriptor numbers.
for ending in felt svg ndjson png pdf inkml xopp; do
  "$feltline" fit bad.ndjson -o expected.$ending 2>words
  run 1 bash -c "'$feltline' fit bad.ndjson -o closed.$ending 2>&-"
  same closed.$ending expected.$ending
  run 1 bash -c "'$feltline' fit bad.ndjson -o closed.$ending >&- 2>&- <&-"
  same closed.$ending expected.$ending
done
has words "bad.ndjson:4: not a JSON object"
run 1 bash -c "'$feltline' info good.ndjson >&- 2>err2"
has err2 "feltline: stdout: cannot write"
run 1 bash -c "'$feltline' fit - -o x.felt <&- 2>err2"
[ ! -e x.felt ] || fail "a drawing of a closed stdin"

# If messages cannot be written, the program continues, and the exit code does not change.
"$feltline" convert notices.svg -o expected.felt 2>words
[ -s words ] || fail "no notice"
run 0 bash -c "'$feltline' convert notices.svg -o closed.felt 2>&-"
same closed.felt expected.felt
(trap - PIPE; "$feltline" convert notices.svg -o gone.felt) 2> >(exec true) || fail "died of a pipe"
same gone.felt expected.felt
if [ -w /dev/full ]; then
  run 0 bash -c "'$feltline' convert notices.svg -o full.felt 2>/dev/full"
  same full.felt expected.felt
  for wrong in "fit" "nonsense" "convert missing.svg -o x.felt" "info missing.felt"; do
    code=0
    # shellcheck disable=SC2086  # must be split into words
    "$feltline" $wrong >/dev/null 2>&1 || code=$?
    run "$code" bash -c "'$feltline' $wrong 2>/dev/full"
  done
  for long in "tools" "tools --json" "devices --json" "materials --json" "formats" "--help" "fit --help"; do
    run 1 bash -c "'$feltline' $long >/dev/full"
  done
  run 1 bash -c "'$feltline' tools --json >/dev/full"
  has err "feltline: stdout: cannot write"
fi

# If an output is also an input or another output, the command is refused before any file is written.
"$feltline" fit good.ndjson -o sketch.ndjson
cp good.ndjson before
cp sketch.ndjson sketch_before
ln -s good.ndjson link.ndjson
ln good.ndjson hard.ndjson
ln -s not_there.svg dangling.svg
refused() {
  run 2 "$feltline" "$@"
  lines err 2
  has err "nothing was written"
  same good.ndjson before
  same sketch.ndjson sketch_before
}
for name in good.ndjson ./good.ndjson link.ndjson hard.ndjson "$PWD/good.ndjson"; do
  refused fit good.ndjson -o "$name"
  refused fit sketch.ndjson good.ndjson -o "$name"
  refused replay good.ndjson -o a.svg --forces "$name"
done
refused convert sketch.ndjson -o sketch.ndjson
refused render sketch.ndjson -o ./sketch.ndjson --to svg
refused replay good.ndjson --on sketch.ndjson -o sketch.ndjson
refused replay good.ndjson -o a.svg --forces a.svg
refused replay good.ndjson -o a.svg --plot ./a.svg
refused replay good.ndjson --forces not_there.svg --sound dangling.svg
refused record --device none -o a.felt --events a.felt
refused record --device none -o a.felt --events b --forces ./b
run 2 bash -c "'$feltline' fit good.ndjson -o - >>good.ndjson"
same good.ndjson before
for output in a.svg a.felt b not_there.svg; do [ ! -e $output ] || fail "$output was written"; done
run 0 "$feltline" fit good.ndjson -o /dev/null
run 0 "$feltline" replay good.ndjson -o /dev/null --forces /dev/null

# fit, like convert, reads the new drawing back before it replaces the old one.
if command -v strace >/dev/null && strace -o trace true 2>/dev/null; then
  strace -f -e trace=openat -o trace "$feltline" fit good.ndjson -o read_back.felt
  [ "$(grep -c 'read_back.felt.*O_RDONLY' trace)" -ge 1 ] || fail "fit did not read its drawing back"
fi

# Of many messages of one kind, three are printed with their lines, and the others are counted.
awk 'BEGIN { for (i = 0; i < 66000; i++) print "{\"id\":\"s" i "\",\"points\":[[1,2],[" i ",\"x\"]]}" }' >many.ndjson
cat good.ndjson >>many.ndjson
for command in "fit many.ndjson -o many.felt" "fit many.ndjson -j 2 -o many.felt" "info many.ndjson" \
  "convert many.ndjson -o many.felt" "convert many.ndjson -o many.svgz"; do
  # shellcheck disable=SC2086  # must be split into words
  "$feltline" $command >out 2>err || true
  [ "$(wc -l <err)" -le 5 ] || fail "$(wc -l <err) lines of $command"
  has err "more like it"
done
run 1 "$feltline" fit many.ndjson -o many.felt
lines err 4
has err "feltline: many.ndjson:1: points[1]: y"
has err "feltline: many.ndjson:3: "
has err "feltline: many.ndjson: ... and 65,997 more like it (line 1)"
run 1 "$feltline" fit sketch.ndjson -o x.felt
lines err 1
has err "feltline: sketch.ndjson: contains curves, which are already fitted"

# An .svgz is compressed whoever writes it, and only an SVG is.
run 0 "$feltline" fit good.ndjson -o small.svgz
gzip -t small.svgz || fail "fit writes an .svgz that is not compressed"
run 0 "$feltline" render sketch.ndjson -o named.svgz --to png
[ "$(head -c 4 named.svgz | tail -c 3)" = PNG ] || fail "a picture was compressed because of its name"
# A whole drawing goes to stdout as it is made, without a temporary file.
run 0 "$feltline" convert sketch.ndjson -o whole.felt
run 0 env TMPDIR=/nonexistent "$feltline" convert whole.felt -o - --to svg

# Text from a file cannot control the terminal and cannot imitate a line of the output.
escape=$(printf '\033')
printf '<svg xmlns="http://www.w3.org/2000/svg" xmlns:i="http://www.inkscape.org/namespaces/inkscape"><g i:groupmode="layer" i:label="a&#10;layer 9  7 strokes&#x9b;2J"><path d="M0 0L9 9" stroke="red" fill="none"/></g></svg>' >forged.svg
run 0 "$feltline" convert forged.svg -o forged.felt
run 0 "$feltline" info forged.felt
has out "'a\\nlayer 9  7 strokes\\u009b2J'"
run 1 "$feltline" convert forged.felt -o x.svg --layers none
has err "1 'a\\nlayer 9  7 strokes\\u009b2J'"
lines err 1
run 1 "$feltline" info "no${escape}[2J"
has err 'no\x1b[2J: No such file'
! grep -q "$escape" err || fail "an escape in a message"
run 2 "$feltline" "non${escape}[2J"
! grep -q "$escape" err || fail "an escape in a usage error"
