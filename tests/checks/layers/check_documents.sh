#!/usr/bin/env bash
# check_documents.sh [ROOT]: do the documents name things that exist?
#
#   docs/requirements.md   has every R1..R57 once; each requirement that is done has a test; every
#                          `Suite.Name`, CTest name and path in it exists in the sources
#   docs/paper-map.md      every header contains the function named beside it; every test exists
#   all .md files          relative links lead to an existing file and heading
#   sources and documents  every citation resolves: docs/FILE.md#heading exists, and no citation
#                          names a document outside the repository
set -euo pipefail
cd "${1:-.}"
status=0
complain() { echo "$*"; status=1; }

# Prints the names of all tests: GoogleTest and RapidCheck in the sources, add_test(NAME ...) in CMake.
test_names() {
  local sources
  mapfile -t sources < <(find src apps tests bench -type f -name '*.cc' | LC_ALL=C sort)
  # Joins each file into one line, because a macro may span two lines.
  awk 'FNR == 1 && NR > 1 { print "" } { printf "%s ", $0 } END { print "" }' "${sources[@]}" |
    grep -oE '\b(TEST|TEST_F|TEST_P|TYPED_TEST|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\( *[A-Za-z0-9_]+ *, *[A-Za-z0-9_]+' |
    sed -E 's/^[A-Z_]+\( *([A-Za-z0-9_]+) *, *([A-Za-z0-9_]+)/\1.\2/'
  find tests bench apps python -name CMakeLists.txt -exec cat {} + | tr '\n' ' ' |
    grep -oE 'add_test\( *NAME +[A-Za-z0-9_.]+' | sed -E 's/.* //'
}
declare -A names=()
while IFS= read -r name; do names[$name]=1; done < <(test_names)

# check_name PLACE NAME: complains unless NAME is a test or a file.
check_name() {
  [ -n "${names[$2]:-}" ] || [ -e "$2" ] || complain "$1: there is no test or file '$2'"
}

# Prints each text between backticks on stdin, one per line.
# shellcheck disable=SC2016  # the backticks are literal
in_backticks() { grep -oE '`[^`]+`' | tr -d '`' || true; }

requirements=docs/requirements.md
while IFS='|' read -r _ id _ state tests _; do
  id=$(xargs <<<"$id") state=$(xargs <<<"$state")
  while read -r name; do check_name "$requirements: $id" "$name"; done < <(in_backticks <<<"$tests")
  case $state in
    done | partly) [[ $tests == *'`'* ]] || complain "$requirements: $id is $state without a test" ;;
    later) ;;
    *) complain "$requirements: $id has the state '$state', not done, partly or later" ;;
  esac
done < <(grep -E '^\| R[0-9]+ ' $requirements)
for number in $(seq 57); do
  count=$(grep -cE "^\| R$number " $requirements || true)
  [ "$count" = 1 ] || complain "$requirements: R$number stands there $count times"
done

# Rows of the map: | equation | what it is | `header`: `function`, ... | `Suite.Name`, ... |
map=docs/paper-map.md
while IFS='|' read -r _ equation _ code tests _; do
  header=
  while read -r name; do
    case $name in
      *.h | *.cc) header=src/$name
                  [ -e "$header" ] || { complain "$map: $equation: no file $header"; header=; } ;;
      *) [ -z "$header" ] || grep -qwF -- "$name" "$header" ||
           complain "$map: $equation: $header has no '$name'" ;;
    esac
  done < <(in_backticks <<<"$code")
  while read -r name; do check_name "$map: $equation" "$name"; done < <(in_backticks <<<"$tests")
done < <(grep -E '^\| \(?[0-9E]' $map)

# finds FILE[#HEADING]: true if the file and the heading exist.
finds() {
  [ -e "${1%%#*}" ] && { [[ $1 != *.md#* ]] || sed -nE 's/^#+ +//p' "${1%%#*}" | tr '[:upper:]' '[:lower:]' |
    sed -E 's/[^a-z0-9 _-]//g; s/ /-/g' | grep -xF -- "${1#*#}" >/dev/null; }
}

# is_there FILE[#HEADING]: the same, but looks once for each, because most are named many times.
declare -A found=()
is_there() {
  if [ -z "${found[$1]:-}" ]; then
    if finds "$1"; then found[$1]=yes; else found[$1]=no; fi
  fi
  [ "${found[$1]}" = yes ]
}

while IFS= read -r document; do
  folder=.
  [[ $document != */* ]] || folder=${document%/*}
  while IFS= read -r link; do
    [[ $link =~ ^(https?:|mailto:|#) ]] || is_there "$folder/$link" ||
      complain "$document: the link to '$link' leads nowhere"
  done < <(grep -oE '\]\([^) ]+\)' "$document" | sed -E 's/^\]\(|\)$//g' || true)
done < <(find . -name '*.md' -not -path './build*' -not -path './out/*' -not -path '*/node_modules/*' \
  -not -path './.git/*' | sed 's|^\./||' | LC_ALL=C sort)

mapfile -t texts < <(find src apps tests bench share samples cmake docs python ./*.md -type f \( -name '*.h' -o -name '*.cc' \
  -o -name '*.md' -o -name '*.cmake' -o -name '*.toml' -o -name '*.patch' \) | sed 's|^\./||' | LC_ALL=C sort)
while IFS=: read -r file line cited; do
  is_there "$cited" || complain "$file:$line: '$cited' does not exist: cite a file and a heading of it that do"
done < <(grep -HnoE '\b(docs/[A-Za-z0-9_./-]+|ARCHITECTURE)\.md(#[a-z0-9-]+)?' "${texts[@]}" || true)

# Matches "specification 5b", "(architecture" at the end of a line, "peers.md" and "devices.md 3". "E5" is also an
# error in a file that does not name errata.md.
retired='\b(specification|architecture|reliability|fitting|performance|devices|peers|style)(\.md)?,?( (section|decision|target))* ([0-9]|section)'
retired+='|\((specification|architecture)( section)?$|\b(of|as) the specification\b'
retired+='|(^|[^/a-z-])((specification|fitting|performance|ecosystem|peers|frontier|style|measured-use)\.md|(reliability|devices)\.md($|[^])#`]))'
while IFS=: read -r file line text; do
  complain "$file:$line: cites a document that is not here: cite docs/design/FILE.md#heading instead: $text"
done < <(grep -HnEi "$retired" "${texts[@]}" || true
         grep -LF 'errata.md' "${texts[@]}" | xargs -d '\n' grep -HnE '(//|^[^"]*[[(|]).*\bE([1-9]|1[0-9]|2[0-4])\b' || true)

exit $status
