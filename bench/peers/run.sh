#!/usr/bin/env bash
# ./dev bench fit [OPTIONS of bench_fit]: builds bench_fit, downloads the npm peers if npm is
# installed, chooses the data, and runs it. --csv without a name writes bench/results/<machine>.csv.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."

readonly build_dir=${BUILD_DIR:-$PWD/build/release}
readonly npm_dir=$build_dir/bench-npm
readonly shared_data=../shared/data/pen-strokes-a.ndjson

# Prints the processor's name as a file name.
machine() {
  sed -n 's/^model name[^:]*: //p' /proc/cpuinfo 2>/dev/null | head -n 1 | tr -cs '[:alnum:]\n' '-' |
    tr '[:upper:]' '[:lower:]' | sed 's/-*$//' | grep . || uname -m
}

install_npm_peers() {
  mkdir -p "$npm_dir"
  command -v npm >/dev/null || return 0
  cmp -s bench/peers/package.json "$npm_dir/package.json" && [ -d "$npm_dir/node_modules" ] && return 0
  cp bench/peers/package.json "$npm_dir/"
  if ! npm install --prefix "$npm_dir" --no-audit --no-fund >"$npm_dir/npm.log" 2>&1; then
    rm -f "$npm_dir/package.json"
    echo "The npm peers could not be installed ($npm_dir/npm.log); their rows are skipped." >&2
  fi
}

# Adds our own npm package, if `./dev npm` has built it.
install_own_package() {
  local tgz
  tgz=$(printf '%s\n' build/web/npm/feltline-*.tgz | tail -n 1)
  [ -e "$tgz" ] && command -v npm >/dev/null || return 0
  npm install --prefix "$npm_dir" --offline --no-save --no-audit --no-fund "$tgz" >>"$npm_dir/npm.log" 2>&1 ||
    echo "build/web/npm could not be installed ($npm_dir/npm.log); its row is skipped." >&2
}

# Prints options for the shared recordings, which are in px. Without them, prints options for the project's own
# samples, which are in mm; 5 px per mm make both comparable.
default_data() {
  if [ -r $shared_data ]; then echo "--data=$shared_data"; return; fi
  printf -- '--data=%s\n' share/samples/*.ndjson
  echo --mm-per-unit=5
}

[ -f "$build_dir/CMakeCache.txt" ] ||
  cmake --preset release -B "$build_dir" -DFELT_TESTS=OFF -DFELT_BENCHMARKS=ON >/dev/null
cmake --build "$build_dir" --parallel "${JOBS:-$(nproc)}" --target bench_fit >&2

arguments=() needs_data=true
while [ $# -gt 0 ]; do
  case $1 in
    --data | --data=* | --long | --long=*) needs_data=false ;;
    --csv)
      if [ $# -eq 1 ] || [ "${2#-}" != "$2" ]; then
        mkdir -p bench/results
        arguments+=("--csv=bench/results/$(machine).csv")
        shift
        continue
      fi ;;
  esac
  arguments+=("$1")
  shift
done
if $needs_data; then
  install_npm_peers
  install_own_package
  mapfile -t data < <(default_data)
  arguments=("${data[@]}" "${arguments[@]}")
fi
exec "$build_dir/bin/bench_fit" --npm-dir "$npm_dir" --scratch "$npm_dir/scratch" "${arguments[@]}"
