# 'trial simulate': a study, its folder, errors, and an interruption.
. "$(dirname "$0")/helpers.sh"

cat >small.toml <<'END'
id = "small"
[[condition]]
name = "free"
forces = false
settings = { "pencil.snap" = "off" }
[[condition]]
name = "rough"
needs = "force"
settings = { "surface.material" = "rough-paper" }
[[shape]]
name = "circle"
kind = "circle"
size_mm = 30
END

run 0 "$feltline" trial simulate small.toml --people 2 -o results
has out "results: 2 people, 4 trials, 0 of them invalid"
is_empty err
same small.toml results/study.toml
session=results/participant-0002/train/session.json
has $session '"device":"simulated premium"'
has $session '"recording":"trial-0002.felt"'
[ "$(find results -name '*.felt' | wc -l)" = 4 ] || fail "not four recordings"

# A recording gives the drawing in the same file again.
trial=results/participant-0001/train/trial-0002.felt
run 0 "$feltline" convert $trial -o stored.ndjson
run 0 "$feltline" replay $trial --as-recorded -o played.ndjson
same stored.ndjson played.ndjson

# The same seed gives the same bytes; another one gives other people.
run 0 "$feltline" trial simulate small.toml --people 2 -o again
diff -r results again >/dev/null || fail "the same seed gives other bytes"
run 0 "$feltline" trial simulate small.toml --people 2 --seed 2 -o other
cmp -s $trial "other/${trial#*/}" && fail "another seed gives the same line"

# The same command again changes nothing; more people come after those who are there.
run 0 "$feltline" trial simulate small.toml --people 2 -o results
diff -r results again >/dev/null || fail "the folder changed"
run 0 "$feltline" trial simulate small.toml --people 1 -o one
run 0 "$feltline" trial simulate small.toml --people 2 -o one
diff -r one again >/dev/null || fail "a second person later is another person"

# A folder with other files, another study or other people is not overwritten.
mkdir full && touch full/notes
run 1 "$feltline" trial simulate small.toml -o full
has err "full: not a folder with the results of a study"
run 1 "$feltline" trial simulate small.toml --people 1 --seed 2 -o results
has err "results: participant 1 is someone else there"
echo >>small.toml
run 1 "$feltline" trial simulate small.toml --people 1 -o results
has err "results: has the results of another study"
diff -r results again >/dev/null || fail "the folder changed"

# Errors in a study name the line and the key, and no folder is made.
sed 's/forces = false/forces = "no"/' small.toml >bad.toml
run 1 "$feltline" trial simulate bad.toml -o bad
has err "bad.toml:4: condition.forces"
sed 's/pencil.snap/pencil.snip/' small.toml >bad.toml
run 1 "$feltline" trial simulate bad.toml -o bad
has err "bad.toml:5: condition.settings: pencil.snip"
run 1 "$feltline" trial simulate small.toml --device mouse -o bad
has err "condition.needs is \"force\""
run 1 "$feltline" trial simulate none.toml -o bad
has err "none.toml"
[ ! -e bad ] || fail "a folder was made"
run 1 "$feltline" trial simulate small.toml -o no/such/folder
has err "no/such/folder"

run 2 "$feltline" trial
run 2 "$feltline" trial simulate small.toml
run 2 "$feltline" trial simulate small.toml --people 0 -o bad
run 2 "$feltline" trial simulate small.toml --people 10000 -o bad
run 2 "$feltline" trial simulate small.toml --device nonsense -o bad
run 2 "$feltline" trial simulate small.toml --seed -1 -o bad

# wait_for FOLDER: waits until the first trial is saved.
wait_for() {
  for _ in $(seq 300); do
    [ -e "$1/participant-0001/train/trial-0001.felt" ] && return
    sleep 0.1
  done
  fail "no trial in $1"
}

# Ctrl-C keeps the finished trials, and so does a kill. A trial that is listed has its recording.
sed 's/^id.*/&\nrepetitions = 100/' small.toml >long.toml
for signal in INT KILL; do
  "$feltline" trial simulate long.toml --people 9999 -o "$signal" >stopped.out 2>stopped.err &
  wait_for "$signal"
  kill -s "$signal" $!
  code=0
  wait $! 2>/dev/null || code=$?
  if [ "$signal" = INT ]; then
    [ "$code" = 1 ] || fail "exit code $code after Ctrl-C"
    has stopped.err "interrupted; the folder has the finished trials"
    has stopped.out "INT: 1 people"
  fi
  sed -n 's/.*"recording":"\([^"]*\)".*/\1/p' "$signal/participant-0001/train/session.json" >listed
  [ -s listed ] || [ "$signal" = KILL ] || fail "no trial is listed"
  while read -r name; do
    run 0 "$feltline" info "$signal/participant-0001/train/$name"
  done <listed
done

# 'trial run' starts the desktop program, which is beside the program or in PATH.
mkdir bin
cp "$feltline" bin/alone
run 1 env PATH=/nowhere bin/alone trial run small.toml -o real --participant 3
has err "feltline-desktop is not installed"
printf '#!/bin/sh\nprintf "%%s\\n" "$@"\n' >bin/feltline-desktop
chmod +x bin/feltline-desktop
run 0 env PATH=/nowhere:/bin:/usr/bin bin/alone trial run small.toml -o real --participant 3 --session post
printf '%s\n' --trial small.toml --output real --participant 3 --session post >wanted
cmp -s out wanted || fail "other arguments: $(cat out)"
run 2 "$feltline" trial run small.toml -o real
run 2 "$feltline" trial run small.toml -o real --participant 0
run 2 "$feltline" trial run small.toml -o real --participant 3 --session later
run 2 "$feltline" trial run small.toml --participant 3

# 'trial preregister' writes the plan of a study with hypotheses. Its fingerprint is that of the export.
run 1 "$feltline" trial preregister small.toml --people 8
has err "small.toml: the study has no hypothesis"
sed 's/^id.*/&\npeople = 8/' small.toml >planned.toml
printf '[[hypothesis]]\ncondition = "rough"\nagainst = "free"\nmeasure = "err_mean_mm"\n' >>planned.toml
run 0 "$feltline" trial preregister planned.toml -o plan.md
is_empty out
has plan.md 'H1: err_mean_mm is smaller in "Rough" than in "Free"'
has plan.md "8 participants"
run 0 "$feltline" trial preregister planned.toml --people 12
has out "12 participants"
run 0 "$feltline" trial simulate planned.toml --people 1 -o planned
run 0 "$feltline" trial export planned -o plan-export
hash=$(grep -o 'fnv1a-[0-9a-f]*' plan.md)
has plan-export/trials.csv "$hash"
sed -i '/^people/d' planned.toml
run 1 "$feltline" trial preregister planned.toml
has err "planned.toml: the number of participants is missing"
sed -i 's/err_mean_mm/error/' planned.toml
run 1 "$feltline" trial preregister planned.toml --people 8
has err "planned.toml:18: hypothesis.measure is error"
run 2 "$feltline" trial preregister planned.toml --people 1
run 1 "$feltline" trial preregister none.toml --people 8
