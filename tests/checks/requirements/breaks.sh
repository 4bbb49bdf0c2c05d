# Shared by plant_breaks.sh and check_breaks.sh, which source this file.
# shellcheck shell=bash

# Prints the numbers of all requirements.
requirements() {
  sed -nE 's/^\| R([0-9]+) .*/\1/p' "$(dirname "${BASH_SOURCE[0]}")/../../../docs/requirements.md"
}

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
