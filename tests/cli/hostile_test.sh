# Input that was made to hurt: an error or a sane stroke, in bounded time and memory.
. "$(dirname "$0")/helpers.sh"

good='{"id":"good","points":[[0,0],[5,5]]}'
# feed SECONDS KIB CODE OPTIONS...: fits stdin; checks time, memory and exit code.
feed() {
  local seconds=$1 kib=$2
  shift 2
  run "$1" limit_memory "$kib" timeout "$seconds" "$feltline" fit - -o - "${@:2}"
}

# Nothing, NUL bytes, noise.
feed 20 500000 1 </dev/null
head -c 1000000 /dev/zero >zeros
feed 20 500000 1 <zeros
has err "is NUL"
# Compressed, since the program holds scripts as text, whose strokes it would find.
gzip -c "$feltline" | head -c 3000000 >binary
feed 20 500000 1 <binary
is_empty out

# A number of 10^9 digits, longer than any line may be; then of 10^7, longer than any number may be.
digits() { head -c "$1" /dev/zero | tr '\0' '7'; }
feed 120 2500000 1 --no-refine < <(printf '{"points":[[' && digits 1000000000 && printf ',1]]}\n%s\n' "$good")
has err "stdin:1: the line is longer than 512 MiB"
has out '"id":"good"'
feed 20 1000000 1 < <(printf '{"points":[[' && digits 10000000 && printf ',1]]}\n%s\n' "$good")
has err "stdin:1: points[0]: x: number of 10000000 characters, at most 64 allowed"
has out '"id":"good"'

# A nesting bomb.
feed 20 1000000 1 < <(printf '{"x":' && head -c 10000000 /dev/zero | tr '\0' '[' && printf '\n%s\n' "$good")
lines err 1
has out '"id":"good"'

# A stroke of ten million samples, to and fro and all at one place; under a sanitizer, which takes
# minutes for that, of one million.
quarter=2500000
[ -z "${FELT_SANITIZE:-}" ] || quarter=250000
feed 250 8000000 0 --no-refine < <(
  printf '{"points":[' && yes '[0,0],[9.5,1,0.5],[19,2],[9.5,3,0.25,8],' | head -n $quarter |
    tr -d '\n'; printf '[0,0]]}\n'
)
lines out 1
feed 250 8000000 0 --no-refine < <(
  printf '{"points":[' && yes '[7,7],[7,7],[7,7],[7,7],' | head -n $quarter | tr -d '\n'
  printf '[7,7]]}\n'
)
lines out 1

# Samples that make no sense as a movement.
while read -r points; do
  feed 20 500000 0 < <(printf '{"points":%s}\n' "$points")
  lines out 1
  mv out sketch
  run 0 "$feltline" convert - -o - <sketch
  same out sketch
done <<'END'
[[1,2]]
[[1e9,1e9]]
[[1,2],[1,2]]
[[1,2],[1,2],[1,2],[1,2],[1,2],[1,2],[1,2],[1,2]]
[[0,0],[1e-300,0],[0,1e-300]]
[[0,0],[1e9,1e9],[-1e9,1e9],[0,0]]
[[0,0,0.5,100],[1,1,0.5,50],[2,0,0.5,0],[3,1,0.5,-50]]
[[0,0,0.5,0],[1,1,0.5,0],[2,0,0.5,0]]
[[0,0,null,9e12],[1,1,null,-9e12],[2,2,null,9e12]]
[[0,0,0],[1,0,0],[2,0,0]]
[[0,0,1],[5,0,0],[5,0,1],[9,0,0]]
[[0,0],[10,0],[0,0],[10,0],[0,0]]
[[0,0,5,0],[1,1,-5,1]]
END
for word in NaN Infinity -Infinity nan 1e999 null true '"1"' 0x1 '1,2,3,,'; do
  feed 20 500000 1 < <(printf '{"points":[[0,0],[%s,0]]}\n%s\n' "$word" "$good")
  lines out 1
  lines err 1
done
finish
