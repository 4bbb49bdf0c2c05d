# What plant_breaks.sh and check_breaks.sh share. Source it.
# shellcheck shell=bash

# Requirements are R1 to this one.
# shellcheck disable=SC2034  # of who sources this
readonly requirements=56

# header KEY FILE: the value of a header line of a patch.
header() {
  sed -n "/^--- /q; s/^$1: *//p" "$2" | head -n 1
}

# apply_break TREE PATCH [option...]: with no file left behind but the patched ones.
apply_break() {
  local tree=$1 file=$2
  shift 2
  sed -n '/^--- /,$p' "$file" |
    patch --directory="$tree" --strip=1 --force --silent --no-backup-if-mismatch --reject-file=- "$@"
}
