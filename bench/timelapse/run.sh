#!/usr/bin/env bash
# run.sh [OPTIONS of feltline timelapse ...]: makes a film of 30 s of a recording with 1,000 strokes, and prints
# the time and the memory that it took.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
command -v ffmpeg >/dev/null || { echo "ffmpeg was not found: ./dev setup test" >&2; exit 1; }
cmake --build "$BUILD_DIR" --parallel "${JOBS:-2}" --target feltline >&2
feltline=$BUILD_DIR/bin/feltline
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 bench/timelapse/make_strokes.py share/samples >"$folder/strokes.ndjson"
"$feltline" replay -q "$folder/strokes.ndjson" --no-force --recording -o "$folder/recording.felt"
python3 - "$feltline" timelapse -q "$folder/recording.felt" -o "$folder/film.webm" "$@" <<'END'
import resource, subprocess, sys, time
start = time.monotonic()
subprocess.run(sys.argv[1:], check=True)
wall_s, used = time.monotonic() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
print(f"wall {wall_s:.1f} s (the bar is 20 s on two free cores), CPU {used.ru_utime + used.ru_stime:.1f} s, "
      f"largest process {used.ru_maxrss / 1024:.0f} MiB")
END
stat -c '%s bytes' "$folder/film.webm"
