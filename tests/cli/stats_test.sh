# The figures of 'fit --stats json' and 'bench'.
. "$(dirname "$0")/helpers.sh"

strokes 50 >in.ndjson
run 0 "$feltline" fit in.ndjson --stats json --tolerance 0.1
lines out 1
is_empty err
for key in '"strokes":50,' '"samples":2000,' '"segments":' '"corners":' '"max_error_mm":' \
  '"mean_error_mm":' '"ns_per_sample":{"mean":' '"p999":' '"max":' '"refine_ns_per_sample":' \
  '"allocations_per_sample":0}'; do
  has out "$key"
done
error=$(sed 's/.*"max_error_mm":\([^,]*\).*/\1/' out)
awk -v e="$error" 'BEGIN { exit !(e >= 0 && e <= 0.1 * (1 + 1e-9)) }' || fail "max error is $error"
[ "$(ls)" = "$(printf 'err\nin.ndjson\nout')" ] || fail "--stats alone made a file: $(ls)"

# --stats can be used with an output and does not change it.
run 0 "$feltline" fit in.ndjson -o a.ndjson --stats json --tolerance 0.1
run 0 "$feltline" fit in.ndjson -o b.ndjson --tolerance 0.1
same a.ndjson b.ndjson

# The counts do not depend on the number of threads.
counts() { sed 's/"ns_per_sample".*//' out; }
run 0 "$feltline" fit in.ndjson --stats json --jobs 1
one=$(counts)
run 0 "$feltline" fit in.ndjson --stats json --jobs 3
[ "${one%\"mean*}" = "$(counts | sed 's/"mean_error.*//')" ] || fail "threads change the counts"

run 0 "$feltline" bench in.ndjson --tolerance 0.1
has out "max error"
has out "refined"
