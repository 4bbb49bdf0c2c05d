#!/usr/bin/env bash
# search.sh PACKAGES: the search of the site finds pages when a browser opens it from file://.
set -euo pipefail
command -v chromium >/dev/null || { echo "chromium is not installed"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
page=$(readlink -f "$(dirname "$0")/../../build/docs/site/docs/guide/window.html")
HOME=$work timeout 120 chromium --headless --no-sandbox --disable-gpu --virtual-time-budget=10000 \
  --dump-dom "file://$page?q=tolerance" >"$work/page.html" 2>"$work/log"
grep -oE '[0-9]+ matching documents' "$work/page.html"
! grep -rlE '<(script|link|img|iframe)[^>]*(src|href)="(https?:)?//' --include=*.html "$(dirname "$page")/../.."
