#!/usr/bin/env bash
# export_test.sh FELTLINE: a study is simulated and exported, and other programs can use the export: the
# rules of BIDS, and the scripts for R and Python. Checks that need a program that is not installed say so.
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")  # before the working folder changes
. "$here/../cli/helpers.sh"

run 0 "$feltline" trial simulate "$here/small-study.toml" --people 5 -o results
run 0 "$feltline" trial export results -o export
has out export
run 0 "$feltline" trial export results -o again
run 0 diff -r export again
lines export/trials.csv 51  # a heading, and 5 people with 2 practice trials and 2 blocks of 2 x 2
lines export/hypotheses.csv 3
has export/hypotheses.json "Holm"
has export/report.html "H2: movement_s in"
has export/report.html "These people are simulated"
[ "$(head -c 5 export/report.pdf)" = %PDF- ] || fail "report.pdf is not a PDF"
[ "$(find export/recordings -name '*.felt' | wc -l)" = 50 ] || fail "not one recording for each trial"
while IFS= read -r recording; do
  same "results/$recording" "export/recordings/$recording"
done < <(cd results && find . -name '*.felt' | LC_ALL=C sort)

# What is missing is said: a session with a listed trial less.
cp -r results partly
session=partly/participant-0002/train/session.json
sed -i -z 's/,\n{"trial":10,[^}]*}//' $session
run 0 "$feltline" trial export partly -o part
has err "partly: unfinished: participant 2, train: 9 of 10 trials"
has part/report.html "participant 2, train: 9 of 10 trials"
is_missing=$(grep -c "Unfinished" export/report.html)
[ "$is_missing" = 0 ] || fail "a finished study is said to be unfinished"

# An export is complete or does not exist, and replaces nothing.
run 1 "$feltline" trial export results -o export
has err "export: exists already"
run 1 "$feltline" trial export nothing -o new
run 2 "$feltline" trial export results
recording=$(find results -name '*.felt' | LC_ALL=C sort | tail -1)
cp -r results damaged
truncate -s 1000 "damaged/${recording#results/}"
run 1 "$feltline" trial export damaged -o new
has err "$(basename "$recording")"
[ ! -e new ] || fail "a failed export left a folder"
[ -z "$(find . -maxdepth 1 -name '.*' ! -name .)" ] || fail "a failed export left a hidden folder"

if command -v pdftotext >/dev/null; then
  run 0 pdftotext export/report.pdf -
  has out "Differences within participants"
  is_empty err
else
  echo "not checked: pdftotext (poppler-utils) is not installed"
fi

if python3 -c '' 2>/dev/null; then
  run 0 python3 "$here/bids_check.py" export/bids
  has out "50 runs of 5 participants"
  # The check finds faults.
  motion=$(find export/bids -name '*_motion.tsv' | LC_ALL=C sort | head -1)
  cp -r export/bids faulty
  sed -i '3s/\t[^\t]*$//' "faulty/${motion#export/bids/}"
  run 1 python3 "$here/bids_check.py" faulty
else
  echo "not checked: BIDS: python3 is not installed"
fi
if command -v bids-validator >/dev/null; then
  run 0 bids-validator export/bids
else
  echo "not checked: the official bids-validator is not installed"
fi

# check_ratio FILE NAME LOW HIGH: the line of NAME in a table of ratios begins with a number in a range.
check_ratio() {
  awk -v name="$2" -v low="$3" -v high="$4" '
    index($0, name " ") == 1 { found = $2 >= low && $2 <= high } END { exit !found }' "$1" ||
    fail "$2 is not within $3 and $4: $(cat "$1")"
}

# analyse SCRIPT PREFIX INFIX COMMAND...: runs a script on the export, and on trials with a known effect. PREFIX
# and INFIX are how the program names the level of a factor: conditionc1, condition[T.c1].
analyse() {
  local script=$1 open=$2 close=$3
  shift 3
  run 0 "$@" "export/$script"
  has out "valid trials of 5 participants"
  has out "condition${open}felt${close}"
  check_hypotheses
  mkdir -p made
  cp "export/$script" made
  for conditions in 2 3; do
    for sessions in 1 2; do
      python3 "$here/made_trials.py" $conditions $sessions >made/trials.csv
      run 0 "$@" "made/$script"
      has out "$((conditions * sessions * 144)) valid trials of 12 participants"
      check_ratio out "condition${open}c1${close}" 0.7 0.9
      [ $conditions = 2 ] || check_ratio out "condition${open}c2${close}" 0.56 0.72
      [ $sessions = 1 ] || check_ratio out "session${open}retention${close}" 0.8 1.0
    done
  done
  # A condition that one session does not have, and no valid trial.
  grep -v '^[0-9]*,retention,c2,' made/trials.csv >fewer && mv fewer made/trials.csv
  run 0 "$@" "made/$script"
  check_ratio out "condition${open}c2${close}" 0.56 0.72
  sed -i 's/,true,,/,false,max_lifts,/' made/trials.csv
  run 0 "$@" "made/$script"
  has out "0 valid trials"
}

# check_hypotheses: the script has printed the numbers of hypotheses.csv, to three digits.
check_hypotheses() {
  has out "Hypotheses (ratio with 95 % interval"
  python3 - export/hypotheses.csv out <<'END' || fail "the script and the program disagree: $(cat out)"
import csv, re, sys
printed = open(sys.argv[2]).read()
found = [float(number) for number in re.findall(r"(?<![\w.])[0-9]+(?:\.[0-9]+)?(?:e-?[0-9]+)?", printed)]
rows = list(csv.DictReader(open(sys.argv[1])))
assert len(rows) == 2, rows
for row in rows:
    for name in ("ratio", "ratio_low", "ratio_high", "p", "p_holm"):
        assert any(abs(float(row[name]) - number) < 1e-3 for number in found), (row, name)
    if float(row["margin"]) > 0:
        for name in ("p_not_worse", "p_not_better"):
            assert any(abs(float(row[name]) - number) < 1e-3 for number in found), (row, name)
END
}

if [ -n "${FELT_SANITIZE:-}" ]; then
  echo "not checked: the scripts, because the build without sanitizers checks them"
  exit
fi
if Rscript -e 'library(lme4)' >/dev/null 2>&1 && python3 -c '' 2>/dev/null; then
  analyse analysis.R "" "" Rscript
else
  echo "not checked: analysis.R: lme4 of R is not installed (./dev setup study)"
fi
# The packages of Debian belong to Debian's Python, which may not be the first one.
python=
for candidate in python3 /usr/bin/python3; do
  [ -n "$python" ] || ! $candidate -c 'import statsmodels' 2>/dev/null || python=$candidate
done
if [ -n "$python" ]; then
  analyse analysis.py "[T." "]" "$python"
else
  echo "not checked: analysis.py: statsmodels is not installed (./dev setup study)"
fi
