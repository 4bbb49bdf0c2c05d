# Shared by plant_breaks.sh and check_breaks.sh, which source this file.
# shellcheck shell=bash

# The last requirement: they are R1 to R57.
# shellcheck disable=SC2034  # used by the scripts that source this file
readonly requirements=57

command -v patch >/dev/null || { echo "the program 'patch' is missing (./dev setup test installs it)" >&2; exit 2; }

# header KEY FILE: prints the value of a header line of a patch.
header() {
  sed -n "/^--- /q; s/^$1: *//p" "$2" | head -n 1
}

# apply_break TREE PATCH [option...]: applies the patch without leaving backup or reject files.
apply_break() {
  local tree=$1 file=$2
  shift 2
  sed -n '/^--- /,$p' "$file" |
    patch --directory="$tree" --strip=1 --force --silent --no-backup-if-mismatch --reject-file=- "$@"
}
