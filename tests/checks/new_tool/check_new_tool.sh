#!/usr/bin/env bash
# check_new_tool.sh BUILD TREE: builds the programs with the new tool in TREE, and runs the test suites.
set -euo pipefail
build=$1 bin=$1/bin tree=$2
cmake --build "$build" --target probe --parallel 2 >"$tree.log" 2>&1 || { tail -n 40 "$tree.log"; exit 1; }
cd "$tree"

"$bin/probe_test" --gtest_brief=1
# Not in a pipe, because feltline would fail if grep ended first.
"$bin/probe_feltline" tools >"$tree.tools"
grep -q '^  probe.radius_mm' "$tree.tools"
"$bin/probe_gesture_fuzz" --gestures 200 --seed 1 --tool probe
"$bin/probe_scenarios_test" --gtest_brief=1
[ -x "$bin/probe_desktop_panels_test" ] || exit 0
QT_QPA_PLATFORM=offscreen "$bin/probe_desktop_panels_test" --gtest_brief=1 \
  --gtest_filter='Icons.*:Tool*:OptionsPanel.*'
FELT_MAKE_TEXTS=$bin/probe_make_texts apps/desktop/translations/update.sh --check
