#!/usr/bin/env bash
# looks_test.sh FELTLINE COMPARE ROOT PROGRAM [FOLDER]
#
# Checks that other programs draw our files as we do. PROGRAM is rsvg, inkscape, chromium, pdf,
# shapes or widths. Draws the sketches below with our PNG writer and, from our SVG or PDF, with that program at
# the same size, and compares the pictures: the mean difference of a channel must be below 1 of 255. With
# a tolerance of one pixel, no pixel may differ by more than the limit of the program (below).
# "shapes": Inkscape draws lines with a shape from the effect alone, after their paths were removed.
# "widths": Inkscape loads and saves our SVG, and we must read our exact strokes from its file.
# Exits with 77 if the program is not installed. If FOLDER is given, keeps the pictures there.
set -uo pipefail
feltline=$1 compare=$2 root=$3 program=$4 keep=${5:-}
readonly page=254x203.2 width=960 height=768 dpi=96 mean_limit=1.0
# Two programs sample only 4 x 4 points of a pixel, which shifts the tone of thin lines: pdftoppm draws
# with Splash, and Chromium fills intricate paths with Skia's supersampler (SkScan_AntiPath.cpp, SHIFT 2).
case $program in pdf | chromium) worst_limit=64 ;; rsvg) worst_limit=24 ;; *) worst_limit=40 ;; esac

declare -A commands=([rsvg]=rsvg-convert [inkscape]=inkscape [chromium]=chromium [pdf]=pdftoppm
                     [shapes]=inkscape [widths]=inkscape)
declare -A debian=([rsvg]=librsvg2-bin [inkscape]=inkscape [chromium]=chromium [pdf]=poppler-utils
                   [shapes]=inkscape [widths]=inkscape)
if ! command -v "${commands[$program]}" >/dev/null; then
  echo "skipped: ${commands[$program]} is not installed (Debian: ${debian[$program]}; ./dev setup looks)"
  exit 77
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export HOME=$work XDG_CONFIG_HOME=$work XDG_CACHE_HOME=$work
cd "$work" || exit 1
failures=0
fail() {
  echo "FAILED: $*" >&2
  failures=$((failures + 1))
}

# random_strokes: writes lines of many widths that cross themselves and each other, closed lines and
# dots. Some of their colours are translucent. The numbers are the same on every machine.
random_strokes() {
  awk 'function roll() { seed = (seed * 16807) % 2147483647; return seed / 2147483647 }
  BEGIN {
    seed = 20260
    for (s = 1; s <= 60; s++) {
      n = s % 10 == 0 ? 1 : 20 + int(60 * roll())
      x = 15 + 220 * roll(); y = 15 + 170 * roll(); a = 6.28 * roll(); p = roll()
      printf "{\"id\":\"s%d\",\"points\":[", s
      for (i = 0; i < n; i++) {
        printf "%s[%.3f,%.3f,%.3f]", i ? "," : "", x, y, p
        a += (roll() - 0.5) * (i % 17 == 16 ? 5 : 0.9); x += 1.2 * cos(a); y += 1.2 * sin(a)
        p += (roll() - 0.5) * 0.3; p = p < 0 ? 0 : p > 1 ? 1 : p
      }
      print "]}"
    }
  }' >random_raw.ndjson
  "$feltline" fit random_raw.ndjson --max-width 6 -o - | awk '{
    split("#1b3a6b #b5522fcc #2e7d3280 #000000 #8e24aa", colors, " ")
    sub(/}$/, ",\"color\":\"" colors[NR % 5 + 1] "\"}"); print }' >random.ndjson
}

# shape_lines: writes lines with a shape: some shorter than one repeat, a curve and a ring.
shape_lines() {
  local medium length middle y
  stroke() { # MEDIUM SEGMENTS CLOSED
    echo "{\"closed\":$3,\"segments\":[$2],\"joints\":$4,\"widths\":[[0,3],[$5,3]],\"material\":\"$1\"}"
  }
  for medium in rope leaf; do
    y=$([ $medium = rope ] && echo 10 || echo 100)
    for length in 2 4 7 20 33 60 200; do
      middle=$((10 + length / 2))
      stroke $medium "[10,$y,$middle,$y,$middle,$y,$((10 + length)),$y]" false '[]' 1
      y=$((y + 7))
    done
    stroke $medium "[10,$((y + 8)),40,$((y - 12)),70,$((y + 28)),100,$((y + 8))]" false '[]' 1
    stroke $medium "[220,$y,220,$((y + 14)),180,$((y + 14)),180,$y],[180,$y,180,$((y - 14)),220,$((y - 14)),220,$y]" \
      true '["smooth","smooth"]' 2
  done >shapes.ndjson
}

draw_ours() { # NAME
  "$feltline" convert "$1.ndjson" -o "$1.svg" --page $page --paper white &&
    "$feltline" convert "$1.ndjson" -o "$1.pdf" --page $page --paper white &&
    "$feltline" convert "$1.ndjson" -o "$1.ours.png" --page $page --paper white --dpi $dpi
}

draw_theirs() { # NAME
  case $program in
    rsvg) rsvg-convert -w $width -h $height "$1.svg" -o "$1.theirs.png" ;;
    inkscape)
      inkscape "$1.svg" --export-type=png --export-area-page --export-width=$width \
        --export-filename="$1.theirs.png" >/dev/null 2>inkscape.log || cat inkscape.log >&2 ;;
    shapes)
      sed -i -E 's/(<path id="s[0-9]+" )d="[^"]*"/\1d="M0 0L1 1"/' "$1.svg"
      inkscape "$1.svg" --actions="select-all:all;transform-translate:0.0001,0;export-type:png;export-area-page;\
export-width:$width;export-filename:$1.theirs.png;export-do" >/dev/null 2>inkscape.log || cat inkscape.log >&2 ;;
    chromium)
      timeout 120 chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --user-data-dir=profile \
        --window-size=$width,$height --screenshot="$work/$1.theirs.png" "file://$work/$1.svg" \
        >/dev/null 2>chromium.log || tail -n 5 chromium.log >&2 ;;
    pdf) pdftoppm -r $dpi -png -singlefile "$1.pdf" "$1.theirs" ;;
  esac
}

compare_pictures() { # NAME
  local line mean worst
  draw_ours "$1" && draw_theirs "$1"
  line=$("$compare" "$1.ours.png" "$1.theirs.png") || { fail "$1: no comparison"; return; }
  echo "$program $1: $line"
  read -r _ mean _ worst _ <<<"$line"
  awk -v m="$mean" -v w="$worst" "BEGIN { exit !(m <= $mean_limit && w <= $worst_limit) }" ||
    fail "$1 looks different: $line"
}

keep_widths() { # NAME
  "$feltline" convert "$1.ndjson" -o "$1.svg" --page $page &&
    inkscape "$1.svg" --export-type=svg --export-filename="$1.saved.svg" 2>inkscape.log ||
    { fail "$1: Inkscape did not save it: $(tail -n 3 inkscape.log)"; return; }
  "$feltline" convert "$1.svg" -o "$1.before.ndjson"
  "$feltline" convert "$1.saved.svg" -o "$1.after.ndjson"
  cmp "$1.before.ndjson" "$1.after.ndjson" || fail "$1: widths or curves changed on the way"
  echo "widths $1: $(wc -l <"$1.after.ndjson") strokes came back exactly"
}

random_strokes
"$feltline" fit "$root/share/samples/cat.ndjson" -o cat.ndjson
"$feltline" fit "$root/share/samples/handwriting.ndjson" -o handwriting.ndjson
shape_lines
names="cat handwriting random"
[ "$program" != shapes ] || names=shapes
for name in $names; do
  if [ "$program" = widths ]; then keep_widths $name; else compare_pictures $name; fi
done
[ -z "$keep" ] || { mkdir -p "$keep" && find . -maxdepth 1 \( -name "*.png" -o -name "*.svg" \) -exec cp {} "$keep" \; ; }
exit $((failures > 0))
