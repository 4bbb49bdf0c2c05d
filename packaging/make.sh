#!/usr/bin/env bash
# make.sh OUT: makes every package into the folder OUT and prints their paths: OUT/debian (the source package and its
# binary packages), the AppImage, and a .tar.gz of the same files, with the library.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
mkdir -p "$1"
out=$(readlink -f "$1")
# No debug packages, so no debug information either.
export DEB_BUILD_OPTIONS=${DEB_BUILD_OPTIONS:-noautodbgsym parallel=${JOBS:-$(nproc)}}
export DEB_CXXFLAGS_APPEND=${DEB_CXXFLAGS_APPEND--g0}
rm -rf "$out"/debian "$out"/*.AppImage "$out"/*.tar.gz
"$here/debian.sh" "$out/debian" >"$out/debian.log" 2>&1 || { tail -n 40 "$out/debian.log" >&2; exit 1; }
printf '%s\n' "$out"/debian/*.{dsc,deb}

"$here/appimage/make.sh" "$out/debian" "$out"
printf '%s\n' "$out"/*.AppImage

version=$(dpkg-parsechangelog -l "$here/../debian/changelog" -S Version) version=${version%-*}
name=feltline-$version-$(uname -m)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
for deb in "$out"/debian/*.deb; do dpkg-deb -x "$deb" "$tree"; done
tar --create --sort=name --owner=0 --group=0 --numeric-owner --directory="$tree" \
  --mtime="@$(dpkg-parsechangelog -l "$here/../debian/changelog" -S Timestamp)" --transform="s,^usr,$name,S" usr |
  gzip -9n >"$out/$name.tar.gz"
printf '%s\n' "$out/$name.tar.gz"
