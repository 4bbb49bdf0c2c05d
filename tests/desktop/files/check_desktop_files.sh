#!/usr/bin/env bash
# check_desktop_files.sh ROOT
#
# Checks that the desktop's own tools accept the files in share/, and that these files agree with each
# other and with the sources. If a tool is not installed, prints its name and skips its check.
set -euo pipefail
cd "${1:-.}"
id=org.feltline.Feltline
status=0
complain() { echo "$*"; status=1; }

# check TOOL ARGUMENTS...: runs TOOL if it is installed.
check() {
  command -v "$1" >/dev/null || { echo "$1 is not installed, so its check was skipped"; return; }
  "$@" || complain "$*: see above"
}

# want FILE TEXT: checks that FILE contains TEXT.
want() { grep -qF -- "$2" "$1" || complain "$1: there is no '$2'"; }

entry=share/applications/$id.desktop
mime=share/mime/$id.xml
metainfo=share/metainfo/$id.metainfo.xml
check desktop-file-validate $entry
check appstreamcli validate --strict --no-net --explain $metainfo
manifest=$PWD/packaging/flatpak/$id.yml state=$(mktemp -d)
cd "$state"  # where flatpak-builder makes a folder
check flatpak-builder --show-manifest "$manifest" >manifest.json
cd - >/dev/null
rm -rf "$state"
for file in $mime $metainfo share/icons/*.svg; do check xmllint --noout "$file"; done

# texts_of_readable Types|Endings: prints the MIME types or file name endings of every format that the
# program reads, each on its own line.
texts_of_readable() {
  awk -v kind="$1" -F '[{}]' '
    /^constexpr Texts k/ { name = $1; sub(/^constexpr Texts /, "", name); sub(/\[.*/, "", name); texts[name] = $2 }
    /FormatTraits\{/ { wanted = "" }
    $0 ~ "\\.(endings|media_types) = k[A-Za-z]*" kind { wanted = $0; gsub(/.* = |,.*/, "", wanted) }
    /\.reads = true/ { print texts[wanted] }' src/felt/formats/format_traits.cc |
    grep -oE '"[^"]+"' | tr -d '"'
}

# The shells complete every ending of a format that the program reads.
while read -r ending; do
  for file in bash/feltline bash/feltline-desktop zsh/_feltline zsh/_feltline-desktop; do
    grep -qE "[(|]${ending#.}[|)]" share/completions/$file || complain "share/completions/$file: no ending $ending"
  done
done < <(texts_of_readable Endings)

# The desktop entry names every format that the program reads. The types below must be defined in the
# MIME file, because not every system knows them.
while read -r type; do
  grep -qE "^MimeType=(.*;)?${type//+/\\+};" $entry || complain "$entry: no MimeType $type"
done < <(texts_of_readable Types)
for type in application/inkml+xml application/x-xopp application/x-ndjson; do
  want $mime "<mime-type type=\"$type\">"
done
want $entry "Icon=$id"
want $metainfo "<launchable type=\"desktop-id\">$id.desktop</launchable>"
want $mime '<glob pattern="*.felt"/>'
want CMakeLists.txt "$(sed -n 's/.*<release version="\([^"]*\)".*/VERSION \1/p' $metainfo | head -n 1) "

want debian/changelog "feltline ($(sed -n 's/^project(.* VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)-"

# The MIME file recognizes drawings by the same magic number that the store writes.
number=$(sed -n 's/.*kFeltApplicationId = \(0x[0-9a-f]*\).*/\1/p' src/felt/store/felt_file.h)
want $mime "value=\"$number\" offset=\"68\""

# The man page and the completions contain every option of --help.
while read -r option; do
  want share/man/feltline-desktop.1 "${option//-/\\-}"
  want share/completions/bash/feltline-desktop "--$option"
  want share/completions/zsh/_feltline-desktop "--$option"
  want share/completions/fish/feltline-desktop.fish "-l $option"
done < <(sed -n '/kRows\[\]/,/^};/p' apps/desktop/window/start_options.cc |
  tr '\n' ' ' | grep -oE '\{"[a-z-]+", "[A-Za-z]*", +QT_TRANSLATE_NOOP' | sed 's/{"\([^"]*\)".*/\1/'
  echo help; echo version)

# The icon can be drawn, also in a small size.
if command -v rsvg-convert >/dev/null; then
  rsvg-convert -w 16 -h 16 share/icons/$id.svg >/dev/null || complain "the icon cannot be drawn"
else
  echo "rsvg-convert is not installed, so the icon is not drawn"
fi
exit $status
