#!/usr/bin/env bash
# Plants one violation of each rule in a small tree and tests that check_layers.sh reports it.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failures=0

# file PATH: writes stdin to PATH below the tree.
file() { mkdir -p "$tree/$(dirname "$1")"; cat >"$tree/$1"; }

clean_tree() {
  rm -rf "${tree:?}"/*
  local layer
  for layer in base geometry stroke tools tools/pencil tools/pull devices devices/simulated; do
    echo "# $layer: a layer of the tree that this test plants its violations in" |
      file src/felt/$layer/README.md
  done
  printf '/// A point.\nstruct Point {};\n' | file src/felt/geometry/point.h
  printf '/// Ink.\n#include "felt/geometry/point.h"\n#include <vector>\n' | file src/felt/stroke/ink.h
  printf '/// A tool.\n' | file src/felt/tools/tool.h
  printf '/// The pencil.\n#include "felt/tools/tool.h"\n' | file src/felt/tools/pencil/pencil.h
  printf '/// The pull.\n#include "felt/tools/tool.h"\n' | file src/felt/tools/pull/pull.h
  printf '#include "felt/tools/pencil/pencil.h"\n' | file src/felt/tools/all_tools.cc
  printf '#include <nlohmann/json.hpp>\n#include "tests/support/near.h"\n' | file src/felt/stroke/ink_test.cc
  printf '/// Cuts.\n#include "felt/stroke/fit/fitter.h"\n' | file src/felt/stroke/edit/cut.h
  printf '/// Fits.\n#include "felt/stroke/ink.h"\n' | file src/felt/stroke/fit/fitter.h
  printf '/// A tool that fits.\n#include "felt/stroke/fit/fitter.h"\n' | file src/felt/tools/fits.h
  printf '#include "desktop/engine/studio.h"\n' | file apps/desktop/canvas/canvas.cc
  printf '#include "print.h"\n#include "felt/tools/tool.h"\n' | file apps/cli/print.cc
  printf '#include "apps/cli/print.h"\n#include "tests/support/near.h"\n' | file apps/cli/print_test.cc
  printf '#include "tests/support/near.h"\n' | file apps/desktop/canvas/canvas_test.cc
}

# expect WHAT TEXT: fails unless the check fails and prints TEXT.
expect() {
  local said
  if said=$("$here/check_layers.sh" "$tree" 2>&1); then
    echo "NOT CAUGHT: $1"
    failures=$((failures + 1))
  elif ! grep -qF -- "$2" <<<"$said"; then
    printf 'WRONG REASON: %s\n  wanted: %s\n  said: %s\n' "$1" "$2" "$said"
    failures=$((failures + 1))
  else
    echo "caught: $1"
  fi
  clean_tree
}

clean_tree
"$here/check_layers.sh" "$tree" || { echo "the clean tree is not clean"; exit 1; }

printf '/// x\n#include "felt/stroke/ink.h"\n' | file src/felt/geometry/bad.h
expect "a layer includes one above it" "src/felt/geometry/bad.h:2: geometry must not include stroke"
printf '#include "felt/stroke/ink.h"\n' | file src/felt/geometry/bad_test.cc
expect "a test includes a layer above its own" "geometry must not include stroke"
printf '/// x\nconstexpr int kMostPoints = 3;\n' | file src/felt/geometry/bad.h
expect "a retired prefix" 'src/felt/geometry/bad.h:2: "kMost" is retired: kMax'
printf '/// x\nint on_sheet(double x);  // "sheet"\n' | file src/felt/geometry/bad.h
expect "a retired word" 'src/felt/geometry/bad.h:2: "sheet" is retired: surface or page'
printf '/// x\nstruct OldSheet {};\n' | file src/felt/geometry/bad.h
expect "a retired word in a type" '"sheet" is retired'
printf 'namespace felt {\n}\n' | file src/felt/geometry/bad_test.cc
expect "a test in the common namespace" "put the test into a namespace felt::bad_test"
printf '/// x\n#include "felt/stroke/ink.h"\n' | file src/felt/devices/simulated/bad.h
expect "a layer includes one beside it" "devices must not include stroke"
printf '/// x\n#include "felt/tools/pull/pull.h"\n' | file src/felt/tools/pencil/bad.h
expect "a private folder includes another" "tools/pencil must not include the folder tools/pull"
printf '/// x\n#include <felt/tools/pull/pull.h>\n' | file src/felt/tools/bad.h
expect "a layer includes its private folder, in angle brackets" \
  "tools must not include the folder tools/pull"
printf '/// x\n#include <QWidget>\n' | file apps/cli/bad.h
expect "Qt outside the desktop program" "<QWidget> belongs in apps/desktop only"
printf '/// x\n#  include <sqlite3.h>\n' | file src/felt/stroke/bad.h
expect "SQLite outside store" "<sqlite3.h> belongs in src/felt/store src/felt/autosave only"
printf '#include <agg_path_storage.h>\n' | file apps/cli/bad.cc
expect "AGG outside render" "<agg_path_storage.h> belongs in src/felt/render only"
printf '#include <pugixml.hpp>\n' | file src/felt/tools/bad.cc
expect "XML outside io" "<pugixml.hpp> belongs in src/felt/io only"
printf '#include <nlohmann/json.hpp>\n' | file apps/cli/bad.cc
expect "JSON outside io" "<nlohmann/json.hpp> belongs in src/felt/io only"
printf '#include <simdjson.h>\n' | file src/felt/stroke/bad.cc
expect "fast JSON outside io" "<simdjson.h> belongs in src/felt/io src/felt/studies only"
printf '/// x\n#include "felt/stroke/b.h"\n' | file src/felt/stroke/a.h
printf '/// x\n#include "felt/stroke/c.h"\n' | file src/felt/stroke/b.h
printf '/// x\n#include "felt/stroke/a.h"\n' | file src/felt/stroke/c.h
expect "a ring of includes" "includes this file in turn"
printf '/// x\n#include "point.h"\n' | file src/felt/geometry/bad.h
expect "a short include" "write project includes from src/"
printf '#include "tests/support/near.h"\n' | file src/felt/stroke/bad.cc
expect "product code includes test code" "write project includes from src/"
printf '/// x\n' | file src/felt/attic/x.h
expect "an unknown layer" "layer attic is not in rules.txt"
printf 'int f();\n' | file src/felt/stroke/bad.h
expect "a header without a comment" "src/felt/stroke/bad.h:1: add a /// comment"
printf '# stroke\n' | file src/felt/stroke/README.md
expect "a README that says nothing" "src/felt/stroke/README.md:1: describe the purpose"
printf '/// x\n#include "felt/stroke/edit/cut.h"\n' | file src/felt/stroke/fit/bad.h
expect "a folder includes one above it" "stroke/fit must not include stroke/edit"
printf '/// x\n#include "felt/stroke/fit/fitter.h"\n' | file src/felt/stroke/bad.h
expect "a layer includes a folder of its own" "stroke must not include stroke/fit"
printf '#include "desktop/canvas/canvas.h"\n' | file apps/desktop/engine/bad.cc
expect "a folder of the desktop includes one above it" \
  "desktop/engine must not include desktop/canvas"

for include in desktop/engine/studio.h apps/desktop/engine/studio.h ../desktop/engine/studio.h; do
  printf '#include "%s"\n' $include | file apps/cli/bad.cc
  expect "the command line includes the desktop as $include" \
    "apps/cli/bad.cc:1: apps/cli must not include \"$include\""
done
for include in print.h cli/print.h apps/cli/print.h ../cli/print.h tests/support/near.h; do
  printf '#include "%s"\n' $include | file apps/desktop/canvas/bad.cc
  expect "the desktop includes $include" \
    "apps/desktop/canvas/bad.cc:1: apps/desktop must not include \"$include\""
done
printf '#include "script_feed.h"\n' | file apps/desktop/canvas/bad_test.cc
expect "a test of the desktop includes script_feed.h" "apps/desktop must not include \"script_feed.h\""
printf '#include "felt/devices/simulated/hand.h"\n' | file src/felt/devices/bad.cc
expect "devices include the simulated one" "devices must not include devices/simulated"

exit $((failures > 0))
