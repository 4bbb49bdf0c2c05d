#!/usr/bin/env bash
# dask_test.sh FELTLINE: the recipe with Dask, on two workers, one of which is killed in the middle.
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")  # before the working folder changes
. "$here/../cli/helpers.sh"
. "$here/helpers.sh"
python=/usr/bin/python3  # Debian's, which has its packages
need python3-distributed $python -c "import distributed"

stop_dask() {
  mapfile -t left < <(for name in scheduler w1 w2; do processes_with "FELT_MACHINE=$work/$name"; done)
  [ ${#left[@]} = 0 ] || kill -KILL "${left[@]}" 2>/dev/null
  rm -rf "$work"
}

make_shards 4000
slow_down
trap stop_dask EXIT
FELT_MACHINE=$work/scheduler $python -m distributed.cli.dask_scheduler --host 127.0.0.1 --port 0 \
  --no-dashboard --scheduler-file "$work/scheduler.json" >scheduler.log 2>&1 &
for name in w1 w2; do
  FELT_MACHINE=$work/$name $python -m distributed.cli.dask_worker --scheduler-file "$work/scheduler.json" \
    --name $name --nthreads 1 --no-nanny --no-dashboard --local-directory "$work/$name" >$name.log 2>&1 &
done
for ((tries = 0; tries < 300; ++tries)); do
  [ ! -s scheduler.json ] || break
  sleep 0.1
done

$python "$recipes/with_dask.py" scheduler.json shards results >dask.out 2>dask.err &
recipe=$!
kill_in_the_middle results "FELT_MACHINE=$work/w1"
was_interrupted results
before=$(count_done results)
wait $recipe || fail "the recipe failed: $(cat dask.err)"
has dask.out "0 bad records"
is_whole results
echo "worker w1 killed after $before shards"
