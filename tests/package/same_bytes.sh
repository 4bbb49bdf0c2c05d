#!/usr/bin/env bash
# same_bytes.sh PACKAGES: makes every package a second time and compares it with the first.
set -euo pipefail
packages=$(readlink -f "$1")
(cd "$packages" && sha256sum debian/*.{deb,dsc,xz} ./*.AppImage ./*.tar.gz) >"$packages/first.sha256"
"$(dirname "$0")/../../packaging/make.sh" "$packages"
cd "$packages"
sha256sum --check first.sha256
