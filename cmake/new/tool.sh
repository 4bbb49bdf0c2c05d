#!/usr/bin/env bash
# cmake/new/tool.sh NAME: writes a small working tool from the templates in cmake/new/tool, and adds it to
# the lists of tools (`./dev new tool NAME`).
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
die() { printf './dev new tool: %s\n' "$*" >&2; exit 2; }

name=${1:-}
[[ $name =~ ^[a-z][a-z0-9]*(_[a-z0-9]+)*$ ]] || die "a name is lower-case letters, digits and _: '$name'"
folder=src/felt/tools/$name
[ ${#name} -le 40 ] || die "a name has at most 40 characters"
[ ! -e "$folder" ] || die "$folder is there already"
words=${name//_/ }
label=${words^}  # "my_tool" becomes "My tool" and MyTool
camel=$(sed -E 's/(^|_)([a-z0-9])/\U\2/g' <<<"$name")

# Fills a temporary folder and moves it in one step, so that the new folder is complete before the lists
# contain the tool.
making=build/new_tool.$$
trap 'rm -rf "$making"' EXIT

fill() { sed "s/NAME/$name/g; s/Name/$camel/g; s/LABEL/$label/g" "$1"; }

(cd cmake/new/tool && find . -name '*.in' ! -name words.in) | while read -r template; do
  file=$making/${template#./}
  file=${file//NAME/$name}
  mkdir -p "$(dirname "$file")"
  fill "cmake/new/tool/$template" >"${file%.in}"
done
! command -v clang-format-14 >/dev/null || clang-format-14 -i "$making"/*.h "$making"/*.cc
mv "$making" "$folder"

# insert_include LINE FILE: inserts LINE into FILE, in the order of its #includes.
insert_include() {
  awk -v line="$1" '
    !done && ((/^#include/ && $0 > line) || (seen && !/^#include/)) { print line; done = 1 }
    /^#include/ { seen = 1 }
    { print }' "$2" >"$2.new" && mv "$2.new" "$2"
}
tools=src/felt/tools/all_tools.cc
insert_include "#include \"felt/tools/$name/${name}_tool.h\"" "$tools"
sed -i "s/^  return tools;/  tools.push_back(make_$name());\n&/" "$tools"

# Adds the texts of the tool in German and Dutch, unless they already exist.
fill cmake/new/tool/words.in | while IFS=$'\t' read -r language source translation; do
  file=apps/desktop/translations/feltline_$language.ts
  awk -v source="$source" -v translation="$translation" '
    /<name>/ { ours = /<name>tools</ }
    ours && index($0, "<source>" source "</source>") { known = 1 }
    ours && !known && /<\/context>/ {
      printf "    <message>\n        <source>%s</source>\n", source
      printf "        <translation>%s</translation>\n    </message>\n", translation
    }
    { print }' "$file" >"$file.new" && mv "$file.new" "$file"
done

cat >&2 <<END
$folder is a tool that moves the line under the pen. Try it:
  ./dev build tools_test && build/dev/bin/tools_test --gtest_filter='$camel*'    its own tests, the quickest
  ./dev test -R '$camel|Scenarios|gestures'    builds everything; its scenario, random gestures, too
  ./dev run                                    the tool bar has it
Then make it yours: what it does (${name}_tool.cc), what the hand feels (${name}_force.h), its options, its
picture ($name.svg, 24 x 24, in the two colours that are there), its page ($name.md), and its words
(apps/desktop/translations/update.sh).
END
