#!/usr/bin/env bash
# read_test.sh FELTLINE: other programs read the results, and join them to the input.
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")  # before the working folder changes
. "$here/../cli/helpers.sh"
. "$here/helpers.sh"
python=/usr/bin/python3
need python3-pandas $python -c "import pandas"

make_shards 4000
mkdir results
for shard in shards/*.ndjson; do run 0 "$recipes/fit_shard.sh" "$shard" results; done
run 0 $python - <<'END'
import glob
import pandas
def read(pattern):
    paths = sorted(glob.glob(pattern))
    return pandas.concat(pandas.read_json(path, lines=True, dtype={"id": str}) for path in paths)
raw, fitted = read("shards/*.ndjson"), read("results/*.ndjson")
both = raw.merge(fitted, on="id", validate="one_to_one")
assert len(both) == len(raw) == len(fitted), (len(both), len(raw), len(fitted))
for row in both.itertuples():  # a stroke starts at its first sample and ends at its last, or near
    for sample, point in ((row.points[0], row.segments[0][:2]), (row.points[-1], row.segments[-1][6:])):
        assert all(abs(a - b) <= 0.15 for a, b in zip(sample, point)), row.id
print(len(both), "strokes")
END
has out "$(wc -l <in.ndjson) strokes"

# What it costs: the script for that works.
run 0 $python "$recipes/measure.py" 1M 1 in.ndjson
has out "strokes per user s"

# DuckDB reads them, and joins them to the drawings of Quick, Draw!, as docs/scale-out.md says.
duckdb() { NODE_PATH=$root/build/scale/duckdb/node_modules node "$here/duckdb.cjs" "$@"; }
if NODE_PATH=$root/build/scale/duckdb/node_modules node -e 'require("@duckdb/node-api")' 2>/dev/null; then
  run 0 duckdb "SELECT count(*) FROM read_ndjson_auto('results/*.ndjson') JOIN
    read_ndjson_auto('shards/*.ndjson') USING (id)"
  has out "$(wc -l <in.ndjson)"

  rm -r shards/* results/*
  for key in 1 2; do
    printf '{"word":"cat","key_id":"%s","drawing":[[[0,90,200],[0,40,10],[0,60,140]],[[5,5],[9,80],[0,90]]]}\n' "$key"
  done >shards/000000.ndjson
  run 0 "$recipes/fit_shard.sh" shards/000000.ndjson results
  run 0 duckdb "$(sed -n '/^```sql$/,/^```$/{/^```/d;p}' "$root/docs/scale-out.md")" \
    "SELECT id, word, segments > 0 FROM 'strokes.parquet' ORDER BY id"
  printf '%s\n' 1.1,cat,true 1.2,cat,true 2.1,cat,true 2.2,cat,true >wanted
  same out wanted
else
  echo "not checked: DuckDB is not installed (./dev test -L scale installs it from npm)"
fi
