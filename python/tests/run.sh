#!/usr/bin/env bash
# run.sh PYTHON PACKAGE PROGRAM TEST: runs test_TEST.py with the package in the folder PACKAGE (its parent
# is searched first) and the program feltline, which may be "". FELT_SEED=N repeats random inputs.
# run.sh missing: says why nothing is tested, and skips.
set -euo pipefail
if [ "$1" = missing ]; then
  echo "pybind11 was not found, so the Python package is not tested: ./dev setup python"
  exit 77
fi
if ! "$1" -c 'import numpy'; then
  echo "numpy was not found, so the Python package is not tested: ./dev setup python"
  exit 77
fi
export PYTHONPATH=$2 FELTLINE=$3 PYTHONDONTWRITEBYTECODE=1
cd "$(dirname "${BASH_SOURCE[0]}")"
exec "$1" -X dev -W error::ResourceWarning -m unittest "test_$4"
