#!/usr/bin/env bash
# lintian.sh PACKAGES: lintian finds no error and no warning in the source package and the binary packages.
set -euo pipefail
lintian --allow-root --display-info --tag-display-limit 0 --fail-on error,warning "$1"/debian/*.changes
