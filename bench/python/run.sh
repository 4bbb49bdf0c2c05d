#!/usr/bin/env bash
# run.sh [FILE.ndjson ...] [--rounds N]: builds the package and the benchmark, and runs run.py with these
# arguments; without a file, on the project's own samples.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
[ -d "$BUILD_DIR/python/feltline" ] || { echo "pybind11 was not found: ./dev setup python" >&2; exit 1; }
cmake --build "$BUILD_DIR" --parallel "${JOBS:-2}" --target bench_python >&2
case " $* " in *.ndjson*) ;; *) set -- share/samples/*.ndjson "$@" ;; esac
python=$(sed -n 's/^_\?Python3_EXECUTABLE:[A-Z]*=//p' "$BUILD_DIR/CMakeCache.txt" | head -n 1)
PYTHONPATH=$BUILD_DIR/python:$BUILD_DIR/bench/python PYTHONDONTWRITEBYTECODE=1 \
  "${python:-/usr/bin/python3}" bench/python/run.py "$@"
