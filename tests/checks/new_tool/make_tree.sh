#!/usr/bin/env bash
# make_tree.sh SOURCE TREE: copies the folders that `./dev new tool` changes from SOURCE to TREE, and makes the tool "probe" there.
set -euo pipefail
source=$1 tree=$2
rm -rf "$tree"
mkdir -p "$tree"
(cd "$source" && tar -cf - dev cmake/new src/felt/tools tests/scenarios apps) | tar -xf - -C "$tree"
"$tree/dev" new tool probe 2>/dev/null
