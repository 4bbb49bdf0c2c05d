# The program as a filter: stdin, stdout, threads, a reader that ends early, a long stream.
. "$(dirname "$0")/helpers.sh"

strokes 300 >in.ndjson
run 0 "$feltline" fit in.ndjson -o a.ndjson
is_empty out
is_empty err
lines a.ndjson 300

# stdin and stdout give the same bytes as files, and so do a second run and any number of threads.
run 0 "$feltline" fit - -o - <in.ndjson
same out a.ndjson
for jobs in 1 2 3 8 0; do
  run 0 "$feltline" fit in.ndjson -o - --jobs "$jobs"
  same out a.ndjson
done
head -n 100 in.ndjson >part1.ndjson
tail -n +101 in.ndjson >part2.ndjson
run 0 "$feltline" fit part1.ndjson - -o - --jobs 2 <part2.ndjson
same out a.ndjson

# A pipeline of fit and render, which process the data while it arrives.
run 0 bash -c "'$feltline' fit - -o - <in.ndjson | '$feltline' render - -o - --to png --dpi 50 >p1.png"
run 0 "$feltline" render a.ndjson -o p2.png --dpi 50
same p1.png p2.png

# If the reader of the output ends early, the program ends without a message.
run 0 bash -c "('$feltline' fit in.ndjson -o - ; true) 2>broken | head -c 100"
is_empty broken
run 0 bash -c "trap '' PIPE; ('$feltline' fit in.ndjson -o - ; true) 2>broken | head -c 100"
is_empty broken

# Memory does not grow with the number of strokes: the limit is small for 20 MB of input.
for _ in $(seq 40); do cat in.ndjson; done >long.ndjson
limit_memory 200000 "$feltline" fit long.ndjson --no-refine -o long_out.ndjson || fail "long input"
lines long_out.ndjson 12000
limit_memory 400000 "$feltline" fit long.ndjson --no-refine -o long_2.ndjson --jobs 2 ||
  fail "long input, two jobs"
same long_out.ndjson long_2.ndjson

# If stderr is not a terminal, no progress line is printed. --quiet is accepted at any position.
run 0 "$feltline" --quiet fit in.ndjson -o b.ndjson
run 0 "$feltline" fit in.ndjson -o b.ndjson -q
is_empty err
