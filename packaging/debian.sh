#!/usr/bin/env bash
# debian.sh OUT: writes the Debian source package and its binary packages into the empty folder OUT, from the
# files that git knows, with their changes. The modification times are those of debian/changelog, so the same
# files give the same bytes. DEB_BUILD_OPTIONS and DEB_CXXFLAGS_APPEND can be set.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
out=$1
version=$(dpkg-parsechangelog -S Version)
SOURCE_DATE_EPOCH=$(dpkg-parsechangelog -S Timestamp)
export SOURCE_DATE_EPOCH
tree=feltline-${version%-*}

mkdir -p "$out/$tree"
# pack FILE PATHSPEC...: packs the files of git that match.
pack() {
  local file=$1
  shift
  git ls-files -z --cached --others --exclude-standard -- "$@" | LC_ALL=C sort -z |
    while IFS= read -rd '' path; do [ ! -e "$path" ] || printf '%s\0' "$path"; done |
    tar --create --no-recursion --transform="s,^,$tree/,S" --mode=u=rwX,go=rX \
      --owner=0 --group=0 --numeric-owner --mtime="@$SOURCE_DATE_EPOCH" --format=gnu \
      --null --files-from=- |
    xz -9 --threads=1 >"$file"
}
pack "$out/feltline_${version%-*}.orig.tar.xz" . ':!debian'
tar -xf "$out/feltline_${version%-*}.orig.tar.xz" -C "$out"
cp -a debian "$out/$tree/"
cd "$out/$tree"
dpkg-buildpackage --no-sign --build=full
cd ..
rm -rf "$tree"
