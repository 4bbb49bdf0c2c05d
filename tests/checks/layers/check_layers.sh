#!/usr/bin/env bash
# check_layers.sh [ROOT]: do the sources keep to the layers of rules.txt?
#
# Prints each violation as FILE:LINE: reason, and fails if there is one. Checks that:
#   - a layer includes only the layers that its line allows;
#   - the private folders of a layer never include one another;
#   - headers of foreign libraries are included only in the folders that rules.txt lists for them;
#   - project headers are included by their full name ("felt/...");
#   - no header includes itself through other headers;
#   - folders of the desktop program include only the folders that their line allows;
#   - the programs include the library and themselves, never each other;
#   - a test is in a namespace with the name of its file, because several files compile as one;
#   - no identifier contains a retired word (the last part of rules.txt);
#   - every layer and every folder in it has a README.md, and every header has a /// comment.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "${1:-.}"

mapfile -t files < <(find src apps bench tests python -type f \( -name '*.h' -o -name '*.cc' \
  -o -name '*.cpp' \) 2>/dev/null | LC_ALL=C sort)
[ ${#files[@]} -gt 0 ] || { echo "check_layers.sh: no sources in $PWD" >&2; exit 2; }

LC_ALL=C awk '
  function complain(text) { print FILENAME ":" FNR ": " text; broken = 1 }

  # Sets the layer of a path below src/felt, and the folder inside that layer ("room" in this
  # script). In the desktop program, every folder counts as a layer.
  function split_place(path,    part, n) {
    layer_of = room_of = ""
    n = split(path, part, "/")
    if (part[1] == "felt" && n > 2) {
      layer_of = part[2]
      if (n > 3 && part[3] != "testing") room_of = part[2] "/" part[3]
    } else if (part[1] == "desktop" && n > 2 && part[2] != "testing") {
      layer_of = "desktop/" part[2]
    }
  }

  function enter_file() {
    place = FILENAME
    in_source = sub(/^src\//, "", place)
    in_desktop = sub(/^apps\/desktop\//, "desktop/", place)
    split_place(in_source || in_desktop ? place : "")
    layer = layer_of; room = room_of
    is_test = FILENAME ~ /^(tests|bench)\/|\/testing\// || FILENAME ~ /_(test|bench)\.cc$/
    is_header = FILENAME ~ /\.h$/
    if (layer != "" && !(layer in known) && !(layer in reported)) {
      complain("layer " layer " is not in rules.txt"); reported[layer] = 1
    }
    if (in_source && layer != "") seen["src/felt/" (room == "" || room in open ? layer : room)] = 1
    if (in_source && is_header) headers[++header_count] = FILENAME
  }

  function check_project_include(name) {
    if (in_desktop && name ~ /^desktop\//) {
      split_place(name)
      if (layer != "" && layer_of != "" && layer_of != layer && !((layer, layer_of) in allowed))
        complain(layer " must not include " layer_of " (" name ")")
    }
    if (!in_source) return
    if (name !~ /^felt\//) {
      if (!(is_test && name ~ /^tests\//))
        complain("\"" name "\": write project includes from src/ (\"felt/...\")")
      return
    }
    included[FILENAME] = included[FILENAME] " src/" name
    split_place(name)
    if (layer == "" || layer_of == "") return
    if (layer_of != layer && !((layer, layer_of) in allowed))
      complain(layer " must not include " layer_of " (" name ")")
    else if (room_of == "" || room_of == room || (is_test && room_of in open)) return
    else if (room_of in open) {
      if (layer_of == layer && !((room, room_of) in allowed))
        complain((room == "" ? layer : room) " must not include " room_of " (" name ")")
    }
    # all_*.cc, which lists the folders of its layer, may include all of them.
    else if (FILENAME !~ /\/all_[a-z]+(_test)?\.cc$/)
      complain((room == "" ? layer : room) " must not include the folder " room_of " (" name \
        "); it is private as long as rules.txt has no line \"folder " room_of ":\"")
  }

  # Checks an include between quotes in a program.
  function check_app_include(name,    app, n, start, i) {
    for (app in app_allowed) if (index(FILENAME, app "/") == 1) break
    if (index(FILENAME, app "/") != 1 || (is_test && name ~ /^tests\//)) return
    n = split(app_allowed[app], start, " ")
    for (i = 1; i <= n; ++i) {
      if (start[i] == "." ? name !~ /\// : index(name, start[i] "/") == 1) return
    }
    complain(app " must not include \"" name "\"")
  }

  function check_foreign_include(name,    i, j, n, folder, ok, names) {
    if (is_test) return
    for (i = 1; i <= only_count; ++i) {
      if (name !~ only_pattern[i]) continue
      n = split(only_folders[i], folder, " "); ok = 0
      for (j = 1; j <= n; ++j) if (index(FILENAME, folder[j] "/") == 1) ok = 1
      if (!ok) complain("<" name "> belongs in " only_folders[i] " only")
    }
  }

  # Adds a word, which identifiers contain as "word", "a_word" or "aWord", to the retired ones.
  function retire(word,    line) {
    sub(/:$/, "", word); line = $0; sub(/^[^:]*: */, "", line)
    capital = toupper(substr(word, 1, 1)) substr(word, 2)
    ++word_count; instead[word_count] = line; retired[word_count] = word
    pattern[word_count] = word ~ /^k/ ? "(^|[^A-Za-z0-9_])" word "[A-Z]" \
        : "(^|[^A-Za-z])" word "([^a-z]|$)|[a-z0-9_]" capital "([^a-z]|$)"
    any_word = any_word (word_count > 1 ? "|" : "") pattern[word_count]
  }

  function check_words(    code, i) {
    if ($0 !~ any_word) return
    code = $0
    gsub(/"([^"\\]|\\.)*"/, "", code); sub(/\/\/.*/, "", code)
    gsub(/([Ss]tyle_?|Shortcut|shortcut_)[Ss]heet/, "", code)
    for (i = 1; i <= word_count; ++i) {
      if (code ~ pattern[i]) complain("\"" retired[i] "\" is retired: " instead[i])
    }
  }

  FNR == NR {  # rules.txt
    if ($1 == "layer") {
      name = $2; sub(/:$/, "", name); known[name] = 1
      for (i = 3; i <= NF; ++i) {
        if (!($i in known)) { complain($i " stands above " name "; list layers bottom up") }
        allowed[name, $i] = 1
      }
    } else if ($1 == "folder") {
      name = $2; sub(/:$/, "", name); open[name] = 1; split(name, part, "/")
      for (i = 3; i <= NF; ++i) {
        if (!((part[1] "/" $i) in open)) complain($i " stands above " name "; list folders bottom up")
        allowed[name, part[1] "/" $i] = 1
      }
    } else if ($1 == "desktop") {
      name = "desktop/" $2; sub(/:$/, "", name); known[name] = 1
      for (i = 3; i <= NF; ++i) {
        if (!(("desktop/" $i) in known)) complain($i " stands above " name "; list folders bottom up")
        allowed[name, "desktop/" $i] = 1
      }
    } else if ($1 == "app") {
      name = $2; sub(/:$/, "", name); line = $0; sub(/^[^:]*: */, "", line)
      app_allowed[name] = line
    } else if ($1 == "only") {
      line = $0; sub(/^only +/, "", line); at = index(line, ": ")
      only_pattern[++only_count] = substr(line, 1, at - 1)
      rest = substr(line, at + 1); gsub(/^ +| +$/, "", rest); only_folders[only_count] = rest
    } else if ($1 == "retired") {
      retire($2)
    }
    next
  }
  FNR == 1 { enter_file() }

  is_header && /\/\/\// { commented[FILENAME] = 1 }
  !/^ *\/\// && !/^(TYPED_)?TEST(_[FP])?\(/ { check_words() }
  /^namespace felt/ && FILENAME ~ /_test\.cc$/ {
    name = FILENAME; gsub(/.*\/|\.cc$/, "", name)
    if (!index($0, "::" name " {")) complain("put the test into a namespace felt::" name)
  }
  /^[ \t]*#[ \t]*include[ \t]*"/ { split($0, quoted, "\""); line_of[FILENAME, "src/" quoted[2]] = FNR
    check_project_include(quoted[2]); check_app_include(quoted[2])
    check_foreign_include(quoted[2]) }
  /^[ \t]*#[ \t]*include[ \t]*</ { name = $0; sub(/^[^<]*</, "", name); sub(/>.*/, "", name)
    if (name ~ /^felt\//) check_project_include(name)
    check_foreign_include(name) }

  # Walks the includes depth first. A header that is reached while its own walk is in progress
  # (state 1) includes itself through others.
  function walk(file,    n, next_file, i) {
    state[file] = 1
    n = split(included[file], next_file, " ")
    for (i = 1; i <= n; ++i) {
      if (!(next_file[i] in state)) walk(next_file[i])
      else if (state[next_file[i]] == 1) {
        print file ":" line_of[file, next_file[i]] ": " next_file[i] " includes this file in turn"
        broken = 1
      }
    }
    state[file] = 2
  }
  END {
    for (i = 1; i <= header_count; ++i) {
      if (!(headers[i] in state)) walk(headers[i])
      if (!(headers[i] in commented)) {
        print headers[i] ":1: add a /// comment that describes this header"; broken = 1
      }
    }
    for (folder in seen) {
      readme = folder "/README.md"; text = ""
      while ((getline line < readme) > 0) text = text line
      if (length(text) < 40) { print readme ":1: describe the purpose of the folder here"; broken = 1 }
      close(readme)
    }
    exit broken
  }' "$here/rules.txt" "${files[@]}"
