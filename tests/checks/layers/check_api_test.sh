#!/usr/bin/env bash
# Plants a violation of each rule in a small tree and tests that check_api.sh reports it.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
cd "$tree"
mkdir -p src/felt/stroke samples docs
failures=0

clean_tree() {
  printf '* [stroke/ink.h](stroke/ink.h): ink\n* [stroke/pen.h](stroke/pen.h): a pen\n' >src/felt/API.md
  printf '#include "felt/stroke/pen.h"\n' >src/felt/stroke/ink.h
  printf '#include <vector>\n' >src/felt/stroke/pen.h
  printf '#include "felt/stroke/ink.h"\n' >samples/draw.cc
  printf '# How to\n#include "felt/stroke/ink.h"\n' | tee docs/use.md >README.md
}

# expect WHAT TEXT: fails unless the check fails and prints TEXT.
expect() {
  local printed
  if printed=$("$here/check_api.sh" "$tree" 2>&1) || ! grep -qF -- "$2" <<<"$printed"; then
    printf 'NOT CAUGHT: %s\n  wanted: %s\n  printed: %s\n' "$1" "$2" "$printed"
    failures=$((failures + 1))
  fi
  clean_tree
}

clean_tree
"$here/check_api.sh" "$tree" || { echo "the clean tree is not clean"; exit 1; }

printf '#include "felt/stroke/inside.h"\n' >>src/felt/stroke/pen.h
expect "a public header includes an internal one" "src/felt/stroke/pen.h:2: felt/stroke/inside.h is not public"
printf '#include <felt/stroke/inside.h>\n' >>samples/draw.cc
expect "a sample includes an internal header" "samples/draw.cc:2: felt/stroke/inside.h is not public"
printf '#include "felt/stroke/inside.h"\n' >>docs/use.md
expect "a document includes an internal header" "docs/use.md:3: felt/stroke/inside.h is not public"
printf '* [stroke/tip.h](stroke/tip.h): a tip\n' >>src/felt/API.md
expect "a header is missing" "there is no src/felt/stroke/tip.h"
printf '* [stroke/ink.h](stroke/ink.h): again\n' >>src/felt/API.md
expect "a header is listed twice" "stroke/ink.h is listed twice"
printf '* [stroke/ink.h](stroke/pen.h): ink\n' >src/felt/API.md
expect "a link leads to another header" "the link of stroke/ink.h leads elsewhere"
printf '* [stroke/pen.h](stroke/pen.h)\n' >src/felt/API.md
expect "a header has no description" "stroke/pen.h has no description"
exit $((failures > 0))
