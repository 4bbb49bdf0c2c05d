#!/usr/bin/env bash
# check_names.sh ROOT
#
# Fails if two headers of the library define a type or a constant of the same name in the same namespace.
# No compiler or linker reports that: a program has only one of the two constants, so that a tool may read
# the choices of another one. Prints "FILE: NAME is also defined in FILE".
set -euo pipefail
cd "$1"

find src/felt -name '*.h' -print0 | LC_ALL=C sort -z | xargs -0 awk '
  FNR == 1 { depth = 0; scope = "" }
  /^namespace [a-zA-Z0-9_:]* *\{/ { names[++depth] = $2; scope = scope "::" $2; next }
  /^namespace \{/ { names[++depth] = FILENAME; scope = scope "::" FILENAME; next }
  /^\}  \/\/ namespace/ && depth > 0 {
    scope = substr(scope, 1, length(scope) - length(names[depth--]) - 2)
    next
  }
  { name = "" }
  /^(class|struct|enum class|enum) [A-Za-z0-9_]+( final)?( : [^;]*)? \{/ {
    name = $2 == "class" ? $3 : $2
  }
  /^inline constexpr [^(]* k[A-Z][A-Za-z0-9]*( =|\{|;)/ {
    match($0, / k[A-Z][A-Za-z0-9]*( =|\{|;)/)
    name = substr($0, RSTART + 1, RLENGTH - 1)
    sub(/[ ={;]+$/, "", name)
  }
  name != "" {
    key = scope "::" name
    if (key in seen && seen[key] != FILENAME) {
      print FILENAME ": " name " is also defined in " seen[key]
      found = 1
    }
    seen[key] = FILENAME
  }
  END { exit found }'
