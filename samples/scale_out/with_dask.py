#!/usr/bin/env python3
"""with_dask.py SCHEDULER SHARDS RESULTS [OPTION...]: fits all shards on the workers of a Dask cluster.

SCHEDULER is an address (tcp://host:8786) or the --scheduler-file of dask-scheduler. The workers must share
both folders. If a worker dies, Dask runs its shards on others; a shard that fails is tried three times.
After this script was killed, run the same command again: finished shards are skipped.
"""
import os
import pathlib
import subprocess
import sys

from distributed import Client, as_completed

HERE = pathlib.Path(__file__).resolve().parent


def fit(shard, script, results, options):
    subprocess.run([script, shard, results, *options], check=True)
    return shard


def main():
    scheduler, shards, results, *options = sys.argv[1:]
    shards, results = os.path.realpath(shards), os.path.realpath(results)
    os.makedirs(results, exist_ok=True)
    where = {"scheduler_file": scheduler} if os.path.exists(scheduler) else {"address": scheduler}
    failed = 0
    with Client(**where) as client:
        tasks = client.map(fit, sorted(str(path) for path in pathlib.Path(shards).glob("*.ndjson")),
                           script=str(HERE / "fit_shard.sh"), results=results, options=options,
                           pure=False, retries=2)
        for task in as_completed(tasks):
            if task.status != "finished":
                failed += 1
                print(f"with_dask.py: {task.exception()}", file=sys.stderr)
    return failed or subprocess.run([HERE / "check_results.sh", shards, results]).returncode


if __name__ == "__main__":
    sys.exit(min(main(), 1))
