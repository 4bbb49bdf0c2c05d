#!/usr/bin/env bash
# update.sh: looks for new words in the sources and in the tables of the library, and adds them to the
# .ts files, unfinished; words that are no longer there go.
# update.sh --check: fails if a word lacks a translation, or a .ts file is behind.
# The texts of tools and materials come from the program make_texts: FELT_MAKE_TEXTS, or the newest one
# that was built (./dev build make_texts).
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")"
lupdate=$(command -v lupdate6 || ls /usr/lib/qt6/bin/lupdate 2>/dev/null || command -v lupdate || true)
[ -n "$lupdate" ] || { echo "lupdate is not installed (./dev setup desktop), so words are not looked at"; exit 0; }

make_texts=${FELT_MAKE_TEXTS:-$(ls -t ../../../build/*/bin/make_texts 2>/dev/null | head -n 1 || true)}
[ -x "$make_texts" ] || { echo "make_texts is not built: ./dev build make_texts"; exit 2; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$make_texts" "$work/texts.cc"

find_words() {
  "$lupdate" -silent -no-obsolete -locations none -source-language en -I ../.. .. "$work/texts.cc" -ts "$@"
}

if [ "${1:-}" != --check ]; then
  find_words feltline_de.ts feltline_nl.ts
  grep -c 'type="unfinished"' feltline_*.ts || true
  exit
fi
status=0
for language in de nl; do
  cp "feltline_$language.ts" "$work/"
  find_words "$work/feltline_$language.ts"
  # The words without a translation, each with its context.
  awk -v file="feltline_$language.ts" '
    /<name>/ { gsub(/ *<\/?name>/, ""); context = $0 }
    /<source>/ { gsub(/ *<\/?source>/, ""); source = $0 }
    /type="unfinished"/ { print file ": " context ": " source; missing = 1 }
    END { exit missing }' "$work/feltline_$language.ts" || status=1
  grep -q '<source>' "$work/feltline_$language.ts" || { echo "no words were found"; status=1; }
done
[ $status = 0 ] || echo "apps/desktop/translations/update.sh adds them to the .ts files"
exit $status
