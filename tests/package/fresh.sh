#!/usr/bin/env bash
# fresh.sh SUITE FOLDER: follows the README in a new Debian that has nothing but git: clones the last commit and runs
# `./dev run` and `./dev test`. So a package that is in no list of ./dev, but on the developer's machine, is found. Takes as long
# as a first build and all tests. Needs root. FOLDER keeps the root file system for the next time, and the log of a failure.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
# shellcheck source=roots.sh
. "$here/roots.sh"
suite=$1 folder=$2
mkdir -p "$folder"
folder=$(readlink -f "$folder")
clean=$(root_of "$folder" "$suite")
work=$(mktemp -d -p "$folder")
trap 'rm -rf "$work"' EXIT
cp -a "$clean" "$work/root"
git clone --quiet --no-hardlinks "$here/../.." "$work/root/root/feltline"

# run_in_root COMMAND: with the environment of a new login only.
run_in_root() {
  in_root "$work/root" env -i HOME=/root LANG=C.UTF-8 PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    sh -ec "$1"
}

run_in_root 'apt-get -q update && apt-get -qy install --no-install-recommends git' >"$folder/$suite.git.log" 2>&1 ||
  { tail -n 20 "$folder/$suite.git.log"; exit 1; }
for command in "./dev run" "./dev test"; do
  echo "=== $command, in a new $suite"
  run_in_root "cd /root/feltline && $command" 2>&1 | tee "$folder/$suite.log" | tail -n 60
done
