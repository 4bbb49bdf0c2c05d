#!/usr/bin/env bash
# make.sh DEBS OUT: writes Feltline-VERSION-x86_64.AppImage into OUT, from the packages feltline and feltline-desktop
# in DEBS and the libraries of this system, which should be the oldest Debian that is supported. The same packages
# and libraries give the same bytes.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
debs=$1 out=$2
[ "$(uname -m)" = x86_64 ] || { echo "AppImages are only made for x86_64" >&2; exit 1; }
SOURCE_DATE_EPOCH=$(dpkg-parsechangelog -l "$here/../../debian/changelog" -S Timestamp)
export SOURCE_DATE_EPOCH
version=$(dpkg-parsechangelog -l "$here/../../debian/changelog" -S Version)
version=${version%-*}
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
app=$dir/app
umask 022

for package in feltline feltline-desktop; do
  dpkg-deb -x "$debs/${package}_${version}"-*_amd64.deb "$app"
done
rm -rf "$app"/usr/share/{bash-completion,fish,zsh,man}

# Plugins, texts and settings of Qt.
qt=/usr/lib/x86_64-linux-gnu/qt6/plugins
for plugin in platforms/libq{xcb,wayland-egl,wayland-generic,offscreen,minimal} \
  platforminputcontexts/lib{compose,ibus}platforminputcontextplugin iconengines/libqsvgicon \
  xcbglintegrations/libqxcb-{egl,glx}-integration printsupport/libcupsprintersupport \
  imageformats/libq{gif,ico,jpeg,svg,tiff,webp} \
  wayland-shell-integration/libxdg-shell wayland-decoration-client/libbradient \
  wayland-graphics-integration-client/libqt-plugin-wayland-egl; do
  install -D -m 644 "$qt/$plugin.so" "$app/usr/plugins/$plugin.so"
done
install -D -m 644 -t "$app/usr/translations" /usr/share/qt6/translations/qtbase_{de,nl}.qm
printf '[Paths]\nPrefix = ..\nPlugins = plugins\nTranslations = translations\n' >"$app/usr/bin/qt.conf"

# Libraries whose version on the system must be used if it exists, because drivers of the system use them, too,
# or because they read files of the system: the C++ runtime, OpenGL, X11, Wayland, fonts.
fallback='^lib(stdc\+\+|gcc_s|GL|GLX|GLdispatch|EGL|OpenGL|gbm|drm|X11|X11-xcb|Xau|Xdmcp|xcb|xcb-(dri.*|glx|present|randr|shm|sync|xfixes)|xshmfence'
fallback+='|wayland-.*|ffi|expat|z|zstd|fontconfig|freetype|bsd|md)\.so'
# The C library itself always comes from the system.
system='^(ld-linux-x86-64|lib(c|m|dl|rt|pthread|resolv|util|anl|nss_.*|BrokenLocale|thread_db|mvec))\.so'
mapfile -t programs < <(find "$app/usr/bin" "$app/usr/plugins" -type f ! -name qt.conf)
mapfile -t libraries < <(ldd "${programs[@]}" | sed -n 's/^\t\(.*\) => \(\/.*\) (0x.*/\1 \2/p' | sort -u |
  grep -vE "$system")
! ldd "${programs[@]}" | grep 'not found'
for row in "${libraries[@]}"; do
  name=${row% *} target=$app/usr/lib
  [[ ! $name =~ $fallback ]] || target=$app/usr/lib/fallback/$name
  install -D -m 644 "${row#* }" "$target/$name"
done

# Every program and library finds the libraries relative to its own place.
find "$app/usr/bin" "$app/usr/plugins" "$app/usr/lib" -type f ! -name qt.conf -printf '%h\t%p\n' |
  while IFS=$'\t' read -r folder file; do
    up=$(realpath --relative-to="$folder" "$app/usr/lib")
    patchelf --set-rpath "\$ORIGIN/$up" "$file"
  done

# Fonts for systems that have none, and the licences of all that was copied.
install -D -m 644 -t "$app/usr/share/fonts" "$here/fonts.conf" /usr/share/fonts/truetype/dejavu/DejaVuSans{,-Bold}.ttf
{ printf '%s\n' "${libraries[@]#* }" | xargs realpath; printf '%s\n' "${libraries[@]#* }" "$qt"/platforms/*.so; } |
  sort -u | { xargs dpkg -S 2>/dev/null || true; } | sed 's/:.*//' | sort -u |
  { cat; echo fonts-dejavu-core; } | while read -r package; do
    [ ! -e "/usr/share/doc/$package/copyright" ] ||
      install -D -m 644 "/usr/share/doc/$package/copyright" "$app/usr/share/doc/$package/copyright"
  done

install -m 755 "$here/AppRun" "$app/AppRun"
id=org.feltline.Feltline
sed -i -f "$here/../appstream.sed" "$app/usr/share/metainfo/$id.metainfo.xml"
cp "$app/usr/share/applications/$id.desktop" "$app/usr/share/icons/hicolor/256x256/apps/$id.png" "$app/"
ln -s $id.png "$app/.DirIcon"

env -u SOURCE_DATE_EPOCH mksquashfs "$app" "$dir/image" -noappend -all-root \
  -all-time "$SOURCE_DATE_EPOCH" -mkfs-time "$SOURCE_DATE_EPOCH" -no-xattrs -comp zstd \
  -Xcompression-level 19 -quiet -no-progress
image_id=$version-$(sha256sum "$dir/image" | cut -c1-16)
g++ -std=c++20 -Wall -Wextra -Os -static -s -ffunction-sections -Wl,--gc-sections -Wl,--build-id=none \
  "-DFELT_APPIMAGE_ID=\"$image_id\"" "-DFELT_VERSION=\"$version\"" "$here/runtime.cc" -o "$dir/runtime" \
  -lsquashfuse -lzstd -llz4 -llzo2 -llzma -lz
# Bytes 8 to 10 mark the file as an AppImage of type 2.
printf 'AI\002' | dd of="$dir/runtime" bs=1 seek=8 conv=notrunc status=none
mkdir -p "$out"
cat "$dir/runtime" "$dir/image" >"$out/Feltline-$version-x86_64.AppImage"
chmod 755 "$out/Feltline-$version-x86_64.AppImage"
