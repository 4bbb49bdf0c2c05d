#!/usr/bin/env bash
# metrics_test.sh RANDOM_TRIALS COUNT SEED: are the metrics of random trials those that
# trial_metrics.py computes? Prints the seed and the largest difference.
set -euo pipefail

readonly program=$1 count=$2 seed=$3
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
readonly here
if ! python3 -c '' 2>/dev/null; then
  echo "skipped: python3 is not installed"
  exit 77
fi
"$program" "$count" "$seed" | python3 "$here/trial_metrics.py"
