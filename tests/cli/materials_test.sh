# Materials can be listed, shown, checked and created. User-defined materials are found and can be used
# by their ids.
. "$(dirname "$0")/helpers.sh"
export XDG_DATA_HOME=$work/data XDG_DATA_DIRS=$work/shared HOME=$work

run 0 "$feltline" materials
has out "rough-paper"
has out "charcoal"
is_empty err
run 0 "$feltline" materials --json
has out '{"id":"paper","kind":"surface","label":"Paper","path":null'
lines out 24

# Each shown material can be read again without an error.
ids=$(sed 's/^{"id":"\([^"]*\)".*/\1/' out)
texts=()
for id in $ids; do
  "$feltline" materials show "$id" >"$id.toml" || fail "show $id"
  texts+=("$id.toml")
done
run 0 "$feltline" materials check "${texts[@]}"
lines out 24
has out "paper.toml: surface paper (can be read, but not saved as a custom material"
run 1 "$feltline" materials show mud
has err 'there is no material "mud"; there are paper, rough-paper'

# Each error is printed with its line, and the other files are still checked.
sed 's/^height_um = [0-9.]*/height_um = 900/; s/^friction/fricton/' paper.toml >bad.toml
wrong=$(grep -n ^fricton bad.toml | cut -d: -f1) high=$(grep -n ^height_um bad.toml | cut -d: -f1)
run 1 "$feltline" materials check bad.toml glass.toml none.toml
has err "bad.toml:$wrong: feel.fricton is unknown"
has err "bad.toml:$high: grain.height_um is 900, it must be 0 to 200 um"
has err "none.toml"
has out "glass.toml: surface glass"
"$feltline" materials show wood | "$feltline" materials check - >out 2>err || fail "check - : $(cat err)"
has out "stdin: surface wood"
run 2 "$feltline" materials check
run 2 "$feltline" materials polish

# 'new' writes a material to stdout or into the folder and never overwrites an existing one.
run 0 "$feltline" materials new my-paper --from rough-paper
has out 'id = "my-paper"'
has out 'label = "My paper"'
run 2 "$feltline" materials new charcoal
has err "that is built in"
run 2 "$feltline" materials new My_Paper
run 2 "$feltline" materials new a --from mud
run 0 "$feltline" materials new my-paper --from rough-paper --save
has out "$XDG_DATA_HOME/feltline/materials/my-paper.toml"
run 1 "$feltline" materials new my-paper --save
has err "it was not changed"
run 0 "$feltline" materials new my-chalk --from chalk --save
run 0 "$feltline" materials
has out "data/feltline/materials/my-chalk.toml"
run 0 "$feltline" tools --json
has out '"my-chalk"'
has out '"my-paper"'

# An invalid file is named, and the other materials are still listed.
mkdir -p shared/feltline/materials
cp bad.toml shared/feltline/materials/
run 0 "$feltline" materials --json
lines out 26
has err "shared/feltline/materials/bad.toml:$wrong: "
rm -r shared

# User-defined materials are chosen like built-in ones, and pictures show them.
strokes 2 >in.ndjson
run 0 "$feltline" replay in.ndjson -o own.ndjson --set surface.material=my-paper --set pencil.medium=my-chalk
has own.ndjson '"my-chalk"'
run 0 "$feltline" replay in.ndjson -o same.ndjson --set surface.material=rough-paper --set pencil.medium=chalk
sed 's/my-chalk/chalk/' own.ndjson >renamed.ndjson
same renamed.ndjson same.ndjson
run 2 "$feltline" replay in.ndjson -o x.ndjson --set pencil.medium=mud
has err "it must be one of pencil, pencil-hard"
has err "my-chalk"
run 2 "$feltline" replay in.ndjson -o x.ndjson --set pencil.medium=eraser
run 0 "$feltline" fit in.ndjson -o a.png --dpi 50 --surface my-paper
run 0 "$feltline" fit in.ndjson -o b.png --dpi 50 --surface rough-paper
same a.png b.png
run 0 "$feltline" fit in.ndjson -o b.png --dpi 50 --surface "$XDG_DATA_HOME/feltline/materials/my-paper.toml"
same a.png b.png
run 2 "$feltline" fit in.ndjson -o b.png --surface my-chalk
run 1 "$feltline" fit in.ndjson -o b.png --surface bad.toml
has err "bad.toml:$wrong: "

# A medium that is stored in the drawing keeps its look, also with another surface.
run 0 "$feltline" replay in.ndjson -o own.felt --recording --medium my-chalk
run 0 "$feltline" replay in.ndjson -o built.felt --recording --medium chalk
for pen in own built; do
  run 0 env XDG_DATA_HOME="$work/nobody" "$feltline" render $pen.felt -o $pen.png --dpi 50 --surface canvas
done
same own.png built.png
run 0 "$feltline" replay in.ndjson -o thin.felt --recording --set pencil.medium=my-chalk
cmp -s thin.felt own.felt && fail "--medium takes no widths"

# A recording contains the materials that it names, so that it gives the same drawing on a machine
# without them.
run 0 "$feltline" replay in.ndjson -o run.felt --recording --set surface.material=my-paper --set pencil.medium=my-chalk
run 0 env XDG_DATA_HOME="$work/nobody" "$feltline" replay run.felt -o there.ndjson --as-recorded
has there.ndjson '"my-chalk"'

# A user-defined medium looks the same, whether its values come from the drawing or from the folder.
run 0 "$feltline" materials new faint --from chalk --save
sed -i 's/^opacity_light = [0-9.]*/opacity_light = 0.05/; s/^opacity_heavy = [0-9.]*/opacity_heavy = 0.2/
  s/^color = "[^"]*"/color = "#202020"/' "$XDG_DATA_HOME/feltline/materials/faint.toml"
sed -i 's/^height_um = [0-9.]*/height_um = 90/; s/^color = "[^"]*"/color = "#ffffff"/' \
  "$XDG_DATA_HOME/feltline/materials/my-paper.toml"
run 0 "$feltline" replay in.ndjson -o faint.ndjson --medium faint
sed 's/"faint"/"pencil"/' faint.ndjson >as_pencil.ndjson
for way in "--surface canvas" "--surface canvas --grain"; do
  # shellcheck disable=SC2086  # must be split into words
  for name in faint as_pencil; do
    run 0 "$feltline" render $name.ndjson -o $name.png --dpi 50 --page A4 $way
  done
  cmp -s faint.png as_pencil.png && fail "$way: a custom medium looks like the pencil"
done
run 0 "$feltline" replay in.ndjson -o faint.felt --medium faint
run 0 env XDG_DATA_HOME="$work/nobody" "$feltline" render faint.felt -o there.png --dpi 50 --page A4 --surface canvas
same there.png faint.png
# In replay, --surface is drawn on, and its grain and colour show in the picture.
run 0 "$feltline" replay in.ndjson -o played.png --dpi 50 --page A4 --medium faint --surface canvas
run 0 "$feltline" replay in.ndjson -o played.felt --medium faint --surface canvas
run 0 "$feltline" render played.felt -o again.png --dpi 50 --page A4 --grain
same played.png again.png
# If the values in the drawing and in the folder differ, those in the drawing are used.
run 0 "$feltline" replay in.ndjson -o own_text.felt --medium faint --surface my-paper
run 0 "$feltline" render own_text.felt -o before.png --dpi 50 --grain
sed -i 's/^opacity_heavy = [0-9.]*/opacity_heavy = 0.9/' "$XDG_DATA_HOME/feltline/materials/faint.toml"
sed -i 's/^height_um = [0-9.]*/height_um = 5/' "$XDG_DATA_HOME/feltline/materials/my-paper.toml"
run 0 "$feltline" render own_text.felt -o after.png --dpi 50 --grain
same before.png after.png
# A drawing that names a surface without storing its text.
run 0 "$feltline" convert faint.felt -o named.svg
sed -i 's/felt:surface="paper"/felt:surface="my-paper"/' named.svg
run 0 "$feltline" render named.svg -o named.png --dpi 50 --grain
run 1 env XDG_DATA_HOME="$work/nobody" "$feltline" render named.svg -o named.png --grain
has err "'my-paper' is unknown"

# The drawing stores its surface and its materials, with or without a recording.
for surface in wood my-paper; do
  run 0 "$feltline" replay in.ndjson -o kept.felt --surface $surface --medium faint --recording
  run 0 "$feltline" replay in.ndjson -o plain.felt --surface $surface --medium faint
  for name in kept plain; do
    run 0 "$feltline" convert $name.felt -o $name.svg
    has $name.svg "felt:surface=\"$surface\""
    run 0 env XDG_DATA_HOME="$work/nobody" "$feltline" render $name.felt -o $name.png --dpi 50 --grain
  done
  same plain.svg kept.svg
  same plain.png kept.png
  run 0 "$feltline" replay in.ndjson -o plain.svg --surface $surface --medium faint
  has plain.svg "felt:surface=\"$surface\""
  has plain.svg "id = &quot;faint&quot;"
done
run 0 "$feltline" convert plain.svg -o back.felt
run 0 "$feltline" convert back.felt -o back.svg
has back.svg 'felt:surface="my-paper"'
run 0 "$feltline" replay in.ndjson -o grain.png --dpi 50 --page A4 --medium faint --surface my-paper --grain
run 0 "$feltline" replay in.ndjson -o solid.png --dpi 50 --page A4 --medium faint --sheet my-paper
cmp -s grain.png solid.png && fail "replay --grain shows none"

# A drawing given with --on keeps its own surface and the materials that it contains.
run 0 env XDG_DATA_HOME="$work/nobody" "$feltline" replay in.ndjson --on plain.felt --medium faint \
  -o on.felt --forces on.csv
run 0 env XDG_DATA_HOME="$work/nobody" "$feltline" convert on.felt -o on.svg
has on.svg 'felt:surface="my-paper"'
has on.svg "id = &quot;faint&quot;"
run 0 "$feltline" replay in.ndjson --surface wood --forces wood.csv --set pencil.snap=off --set pencil.retrace_n=0
# A surface in a file is drawn on, too, and travels with the drawing.
sed 's/^id = "[^"]*"/id = "of-file"/; s/^friction = [0-9.]*/friction = 1.1/' \
  "$XDG_DATA_HOME/feltline/materials/my-paper.toml" >of-file.toml
run 0 "$feltline" replay in.ndjson --surface of-file.toml --forces file.csv -o file.felt --set pencil.snap=off --set pencil.retrace_n=0
run 0 "$feltline" replay in.ndjson --surface my-paper --forces library.csv --set pencil.snap=off --set pencil.retrace_n=0
cmp -s file.csv library.csv && fail "the friction of the file has no effect"
run 0 "$feltline" replay in.ndjson --on file.felt --forces on-file.csv --set pencil.snap=off --set pencil.retrace_n=0
same on-file.csv file.csv
# With the former flag, the surface in the file is only the picture's.
run 0 "$feltline" replay in.ndjson --sheet wood --surface of-file.toml --forces shown.csv --set pencil.snap=off --set pencil.retrace_n=0
same shown.csv wood.csv
run 1 "$feltline" replay in.ndjson --surface bad.toml --forces bad.csv
# The former names of the flag and of the options.
run 0 "$feltline" replay in.ndjson --sheet wood --forces former.csv --set pencil.snap=off --set pencil.retrace_n=0
same former.csv wood.csv
run 0 "$feltline" replay in.ndjson --set sheet.material=wood --forces former.csv --set pencil.snap=off --set pencil.retrace_n=0
same former.csv wood.csv
run 0 "$feltline" replay in.ndjson -o former.ndjson --set pencil.material=chalk
has former.ndjson '"material":"chalk"'
run 0 "$feltline" replay in.ndjson -o wood.felt --surface wood
run 0 "$feltline" replay in.ndjson --on wood.felt --forces on.csv --set pencil.snap=off --set pencil.retrace_n=0
same on.csv wood.csv
run 0 "$feltline" replay in.ndjson --on wood.felt --surface glass -o glass.felt
run 0 "$feltline" convert glass.felt -o glass.svg
has glass.svg 'felt:surface="glass"'
sed 's/my-paper/moon-dust/' named.svg >moon.svg
run 0 "$feltline" replay in.ndjson --on moon.svg -o moon_on.svg
has moon_on.svg 'felt:surface="moon-dust"'

# Surface and medium set their usual colours, unless other colours are requested.
run 0 "$feltline" replay in.ndjson -o board.felt --surface blackboard --medium chalk
run 0 "$feltline" info board.felt --json
has out '"paper":"#34463e"'
run 0 "$feltline" convert board.felt -o board.ndjson
has board.ndjson '"color":"#f4f1e6"'
run 0 "$feltline" replay in.ndjson -o board.felt --surface blackboard --medium chalk --paper white \
  --set ink.color=#102030
run 0 "$feltline" info board.felt --json
has out '"paper":"#ffffff"'
run 0 "$feltline" convert board.felt -o board.ndjson
has board.ndjson '"color":"#102030"'
run 0 "$feltline" replay in.ndjson -o board.png --dpi 50 --surface blackboard --medium chalk
run 0 "$feltline" replay in.ndjson -o board2.png --dpi 50 --surface blackboard --medium chalk --paper '#34463e'
same board.png board2.png

# A script can define a material itself.
{ printf '{"t_ms":0,"event":"material","text":"kind = \\"medium\\"\\nid = \\"told\\"\\n"}\n'
  printf '{"t_ms":0,"event":"option","id":"pencil.medium","value":"told"}\n'; cat in.ndjson; } >script.ndjson
run 0 "$feltline" replay script.ndjson -o told.ndjson
has told.ndjson '"told"'
sed 's/told\\"/told\\"\\nfriction = 1/' script.ndjson >wrong.ndjson
run 1 "$feltline" replay wrong.ndjson -o told.ndjson
has err "material:3: friction is unknown"
