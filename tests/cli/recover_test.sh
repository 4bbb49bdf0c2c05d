# Recovers the drawings of a killed program without a window.
kill_loop=$2
. "$(dirname "$0")/helpers.sh"
[ -x "$kill_loop" ] || { echo "not built: $kill_loop (./dev build kill_loop)" >&2; exit 1; }

export XDG_STATE_HOME=$PWD/state XDG_CACHE_HOME=$PWD/cache XDG_RUNTIME_DIR=$PWD/run TMPDIR=$PWD
run 0 "$feltline" recover --list
has out "Nothing to recover"
run 0 "$kill_loop" --leave "$PWD/state/feltline/working"
for _ in 1 2; do
  run 0 "$feltline" recover --list
  has out "Killed: "
  has out "saved as"
done
run 0 "$feltline" recover
has out "feltline recover -o FOLDER"
run 0 "$feltline" recover -o "rescued here"
has out "rescued here/Killed (recovered).felt"
is_empty err
run 0 "$feltline" info "rescued here/Killed (recovered).felt"
run 0 "$feltline" recover -o "rescued here"
same "rescued here/Killed (recovered).felt" "rescued here/Killed (recovered 2).felt"
run 1 "$feltline" recover --list --from nowhere
has err "--from nowhere: the folder does not exist"
is_empty out
echo >file
run 1 "$feltline" recover -o file/below
has err "file/below"
# If the autosave database is damaged, the error names it.
store=$(dirname "$(find state -name store.db)")
printf "xxxxxxxxxxxxxxxx" | dd of="$store/store.db" bs=1 conv=notrunc status=none
rm "$store/store.db-wal"
run 1 "$feltline" recover --list
has err "$store"
rm -f "$store/store.db"
run 0 "$feltline" recover --list
has out "Nothing to recover"
[ ! -e "$store" ] || fail "a folder without a drawing was not removed: $store"
run 2 "$feltline" recover nonsense
run 0 "$feltline" recover --help
has out "feltline recover --list"
