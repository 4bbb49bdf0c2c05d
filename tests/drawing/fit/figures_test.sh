#!/usr/bin/env bash
# Fits real pen strokes at three tolerances and runs the independent checker on the curves: every
# sample must be within the tolerance, breaks may occur only at declared corners, the overshoot must be
# bounded, and the curves may not have more segments than promised. Prints a message and skips the test
# if the recordings are absent.
#
# Usage: figures_test.sh FELTLINE FIT_CHECK PROJECT_FOLDER; FELT_SHARED_DATA=FILE names the recordings.
set -euo pipefail
feltline=$1 fit_check=$2 project=$3
strokes=${FELT_SHARED_DATA:-$project/../shared/data/pen-strokes-a.ndjson}
if [[ ! -r $strokes ]]; then
  echo "skipped: no recordings at $strokes (set FELT_SHARED_DATA to name them)"
  exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0

# judge TOLERANCE MOST_SEGMENTS [OPTION...]: fits the strokes and checks the curves.
judge() {
  local tolerance=$1 most=$2 report segments
  shift 2
  "$feltline" fit "$strokes" --mm-per-unit 1 --tolerance "$tolerance" "$@" -o "$work/sketch.ndjson"
  report=$("$fit_check" "$strokes" "$work/sketch.ndjson" --mm-per-unit 1 --tolerance "$tolerance") || {
    echo "$report"
    failed=1
  }
  segments=$(awk '/^segments/ {print $2; exit}' <<<"$report")
  echo "tolerance $tolerance $*: $segments segments, at most $most allowed"
  ((segments > 0 && segments <= most)) || failed=1
}

judge 0.5 36000 --no-refine
judge 1 20000 --no-refine
judge 2 7900 --no-refine
judge 0.5 33000
judge 1 16000
judge 2 7400
exit $failed
