# Checks the help, the version and the exit codes.
completions=$(cd "$(dirname "$0")/../../share/completions" && pwd)
. "$(dirname "$0")/helpers.sh"

run 0 "$feltline" --help
has out "feltline fit strokes.ndjson -o sketch.svg"
is_empty err
run 0 "$feltline" --version
has out "feltline 0."
for command in fit render convert info replay timelapse demo paper tools devices doctor device-test trial bench; do
  run 0 "$feltline" "$command" --help
  has out "Examples:"
  is_empty err
done

run 2 "$feltline"
run 2 "$feltline" nonsense
has err "feltline: there is no command 'nonsense'"
run 2 "$feltline" fit
has err "Try 'feltline fit --help'."
strokes 3 >in.ndjson
run 2 "$feltline" fit in.ndjson
run 2 "$feltline" fit in.ndjson -o x.ndjson --nonsense
for tolerance in -1 nan inf abc 1e10 ''; do
  run 2 "$feltline" fit in.ndjson -o x.ndjson --tolerance "$tolerance"
done
run 2 "$feltline" fit in.ndjson -o x.ndjson --mm-per-unit 0
run 2 "$feltline" fit in.ndjson -o x.ndjson --jobs -1
run 2 "$feltline" fit in.ndjson -o x.ndjson --scheme nonsense
for material in velvet eraser paper; do
  run 2 "$feltline" fit in.ndjson -o x.ndjson --material "$material"
done
run 2 "$feltline" fit in.ndjson -o x.ndjson --material velvet
has err "unknown medium 'velvet'; the media are pencil,"
run 2 "$feltline" fit in.ndjson -o x.ndjson --min-width 3
has err "--max-width (2) is less than --min-width (3)"
run 2 "$feltline" fit in.ndjson -o x.ndjson --stats xml
run 2 "$feltline" fit in.ndjson -o - --stats json
has err "cannot both use stdout"
run 2 "$feltline" fit in.ndjson -o x.docx
has err "x.docx: the extension '.docx' is unknown; the formats are felt, svg,"
run 2 "$feltline" fit in.ndjson -o x
run 2 "$feltline" fit in.ndjson -o x.ndjson --to docx
run 2 "$feltline" render in.ndjson -o x.ndjson
for page in A9 10 10x x10 0x5 -1x5 nanxnan 1e9x1 A4-portrait; do
  run 2 "$feltline" render in.ndjson -o x.png --page "$page"
done
run 2 "$feltline" render in.ndjson -o x.png --paper reddish
run 2 "$feltline" render in.ndjson -o x.png --surface velvet
run 2 "$feltline" render in.ndjson -o x.png --dpi 0
for seed in -1 99999999999999999999999 18446744073709551616 1.5 ''; do
  for command in "replay in.ndjson -o x.ndjson" "device-test"; do
    # shellcheck disable=SC2086  # must be split into words
    run 2 "$feltline" $command --seed "$seed"
    has err "--seed: '$seed' is not a whole number"
  done
done
for command in render convert fit; do
  run 2 "$feltline" $command in.ndjson -o x.png --surface ""
  has err "--surface: must not be empty"
done
for command in render convert; do
  run 2 "$feltline" $command in.ndjson -o x.png --layers ""
  has err "--layers: must not be empty"
done
is_empty out
[ ! -e x.png ] || fail "a wrong command line made a picture"
[ ! -e x.ndjson ] || fail "a wrong command line made a file"

# The completions of all shells have every option of every command.
for command in fit render convert gather check info formats replay recover demo paper tools materials devices \
  doctor device-test record trial bench; do
  run 0 "$feltline" "$command" --help
  while read -r option; do
    for shell in bash/feltline zsh/_feltline; do
      grep -q -- "$option\b" "$completions/$shell" || fail "$shell lacks $command $option"
    done
    grep -q -- "-l ${option#--}\b" "$completions/fish/feltline.fish" || fail "fish lacks $command $option"
  done < <(grep -oE '^ +(-[a-zA-Z],)?--[a-z-]+' out | grep -oE -e '--[a-z-]+' | sort -u)
done
