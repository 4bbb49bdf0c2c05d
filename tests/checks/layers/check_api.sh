#!/usr/bin/env bash
# check_api.sh [ROOT]: is src/felt/API.md a list of headers that can be installed on their own?
#
#   - every header in the list exists, is listed once, and has a description;
#   - a public header includes only public headers;
#   - samples, and the examples in documents, include only public headers.
# Prints each violation as FILE:LINE: reason, and fails if there is one.
set -euo pipefail
cd "${1:-.}"

mapfile -t public < <(sed -nE 's|^\* \[([^]]+\.h)\].*|src/felt/\1|p' src/felt/API.md)
[ ${#public[@]} -gt 0 ] || { echo "check_api.sh: no headers in src/felt/API.md" >&2; exit 2; }
mapfile -t users < <(find samples docs README.md -name '*.cc' -o -name '*.h' -o -name '*.md' | LC_ALL=C sort)
status=0
for header in "${public[@]}"; do
  [ -e "$header" ] || { echo "src/felt/API.md: there is no $header"; exit 1; }
done

LC_ALL=C awk '
  function complain(text) { print FILENAME ":" FNR ": " text; broken = 1 }
  FILENAME == "src/felt/API.md" {
    if (!/^\* \[[^]]*\.h\]/) next
    name = $0; sub(/^\* \[/, "", name); sub(/\].*/, "", name)
    if (index($0, "[" name "](" name ")") == 0) complain("the link of " name " leads elsewhere")
    if ($0 !~ /\): [a-zA-Z]/) complain(name " has no description")
    if (("felt/" name) in public) complain(name " is listed twice")
    public["felt/" name] = 1
    next
  }
  /^[ \t]*#[ \t]*include[ \t]*["<]felt\// {
    name = $0; sub(/^[^"<]*["<]/, "", name); sub(/[">].*/, "", name)
    if (!(name in public)) complain(name " is not public (src/felt/API.md)")
  }
  END { exit broken }' src/felt/API.md "${public[@]}" "${users[@]}" || status=1
exit $status
