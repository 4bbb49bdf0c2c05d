#!/usr/bin/env bash
# appimage.sh PACKAGES: the AppImage starts on new root file systems of Debian 12, Debian 13 and Ubuntu 24.04,
# which have neither X11, OpenGL, fonts nor FUSE. Both programs run there; the window opens on an Xvfb of this system.
set -euo pipefail
# shellcheck source=roots.sh
. "$(dirname "$0")/roots.sh"
packages=$(readlink -f "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"; [ -z "${display_pid:-}" ] || kill "$display_pid"' EXIT
cp "$packages"/Feltline-*.AppImage "$work/Feltline.AppImage"
shared=$work

# The number of a display that Xvfb chose.
exec 3>"$work/display"
Xvfb -displayfd 3 -screen 0 1280x1024x24 -nolisten tcp >/dev/null 2>&1 &
display_pid=$!
for _ in $(seq 100); do [ -s "$work/display" ] && break; sleep 0.1; done
display=:$(cat "$work/display")

cat >"$work/start.sh" <<'INNER'
set -eu
. /etc/os-release
cd "$(mktemp -d)"
export HOME="$PWD"
app=/mnt/Feltline.AppImage
begin=$(date +%s%N)
$app cli --version >/dev/null
echo "$PRETTY_NAME: first start, which unpacks: $((($(date +%s%N) - begin) / 1000000)) ms"
begin=$(date +%s%N)
$app cli --version
echo "  next start: $((($(date +%s%N) - begin) / 1000000)) ms"
$app cli demo -o demo >/dev/null 2>&1
[ -s demo/sketch.svg ]
echo "  window: $(timeout 60 $app --measure-start 2>messages)" || { cat messages; exit 1; }
QT_QPA_PLATFORM=offscreen timeout 60 $app --language de --example cat --screenshot cat.png 2>messages || { cat messages; exit 1; }
[ -s cat.png ]
env -u HOME -u XDG_CACHE_HOME $app cli --version >/dev/null  # from a temporary folder
$app --appimage-extract >/dev/null
squashfs-root/AppRun cli --version >/dev/null
find squashfs-root -type f | wc -l >files
echo "  files: $(cat files), unpacked: $(du -sm squashfs-root | cut -f1) MB"
rm -rf "$HOME"
INNER
for system in bookworm trixie noble; do
  in_root "$(root_of "$packages" $system)" env DISPLAY="$display" sh /mnt/start.sh
done
