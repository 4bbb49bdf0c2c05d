#!/usr/bin/env bash
# clean_chroot.sh PACKAGES: installs the packages in a copy of a new Debian 12 and runs debian/tests there.
set -euo pipefail
# shellcheck source=roots.sh
. "$(dirname "$0")/roots.sh"
packages=$(readlink -f "$1")
clean=$(root_of "$packages" bookworm)
work=$(mktemp -d)
trap 'umount "$work/root/proc" 2>/dev/null || true; rm -rf "$work"' EXIT
cp -a "$clean" "$work/root"
mount -t proc proc "$work/root/proc"
# A compiler cache of the developer is not in the copy.
unset CMAKE_C_COMPILER_LAUNCHER CMAKE_CXX_COMPILER_LAUNCHER
autopkgtest --no-built-binaries "$packages"/debian/*.deb "$packages"/debian/*.dsc --output-dir "$work/output" \
  -- chroot "$work/root"
