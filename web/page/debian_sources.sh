#!/usr/bin/env bash
# debian_sources.sh FOLDER PACKAGE...: unpacks the sources of Debian packages into FOLDER/PACKAGE, for libraries of
# which Debian's binary packages have only machine code. apt checks the signatures. Needs neither root nor changes of
# the system: apt's lists and files stay in FOLDER.
set -euo pipefail
folder=$(mkdir -p "$1" && cd "$1" && pwd)
shift
missing=()
for package in "$@"; do
  [ -e "$folder/$package/.complete" ] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0
command -v apt-get >/dev/null || {
  echo "unpack the sources of these Debian 12 packages into $folder/NAME and create $folder/NAME/.complete: ${missing[*]}" >&2
  exit 1
}

# The sources come from where the system's programs come from.
mkdir -p "$folder/apt/lists/partial" "$folder/apt/archives/partial" "$folder/apt/parts"
touch "$folder/apt/sources.list"
if [ -f /etc/apt/sources.list.d/debian.sources ]; then
  sed 's/^Types:.*/Types: deb-src/' /etc/apt/sources.list.d/debian.sources >"$folder/apt/parts/debian.sources"
else
  sed -n 's/^deb /deb-src /p' /etc/apt/sources.list >"$folder/apt/sources.list"
fi
options=(-q -o "Dir::Etc::sourcelist=$folder/apt/sources.list" -o "Dir::Etc::sourceparts=$folder/apt/parts"
  -o "Dir::State::lists=$folder/apt/lists" -o "Dir::Cache=$folder/apt" -o APT::Sandbox::User=)
apt-get "${options[@]}" update >&2
cd "$folder/apt"
apt-get "${options[@]}" source --download-only "${missing[@]}" >&2
for package in "${missing[@]}"; do
  rm -rf "${folder:?}/$package"
  mkdir -p "$folder/$package"
  for archive in "${package}"_*.orig.tar.*; do
    case $archive in *.asc) continue ;; esac
    tar xf "$archive" -C "$folder/$package" --strip-components=1
  done
  touch "$folder/$package/.complete"
done
rm -rf "$folder/apt"
