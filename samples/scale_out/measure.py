#!/usr/bin/env python3
"""measure.py SIZE ROUNDS INPUT.ndjson...: what does it cost to fit these strokes, with 1, 2 and 4 workers?

Cuts the input into shards of SIZE (1M), and fits them with each number of workers, and once in one process
without shards. The rounds are interleaved, so that a slow minute of the machine meets all of them. Prints
medians: CPU time depends little on other programs, but the time on the clock does.
"""
import concurrent.futures
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
FELTLINE = os.environ.get("FELTLINE", "feltline")


def timed(command):
    """Returns the user and system time in s, and the largest memory of one process in MiB."""
    process = subprocess.Popen(command)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        sys.exit(f"measure.py: {command} failed")
    return usage.ru_utime, usage.ru_stime, usage.ru_maxrss / 1024


def fit(shards, workers):
    """Returns the time on the clock and what timed() says of each shard."""
    with tempfile.TemporaryDirectory() as results:
        start = time.monotonic()
        with concurrent.futures.ThreadPoolExecutor(workers) as pool:
            costs = list(pool.map(lambda s: timed([HERE / "fit_shard.sh", s, results]), shards))
        return time.monotonic() - start, costs


def main():
    size, rounds, inputs = sys.argv[1], int(sys.argv[2]), sys.argv[3:]
    work = tempfile.TemporaryDirectory()
    subprocess.run([HERE / "cut_shards.sh", f"{work.name}/shards", size, *inputs], check=True)
    shards = sorted(str(path) for path in pathlib.Path(f"{work.name}/shards").iterdir())
    stats = subprocess.run([FELTLINE, "fit", *shards, "--stats", "json"], check=True,
                           capture_output=True, text=True).stdout
    strokes, samples = (int(stats.split(f'"{key}":')[1].split(",")[0]) for key in ("strokes", "samples"))
    print(f"{strokes} strokes, {samples} samples, {len(shards)} shards, load {os.getloadavg()[0]:.1f}")

    runs = {0: [], 1: [], 2: [], 4: []}  # by workers; 0 is one process without shards
    for _ in range(rounds):
        for workers, list_of_runs in runs.items():
            if workers:
                list_of_runs.append(fit(shards, workers))
            else:
                start = time.monotonic()
                cost = timed([FELTLINE, "fit", *shards, "-o", f"{work.name}/one.ndjson"])
                list_of_runs.append((time.monotonic() - start, [cost]))
    out = os.path.getsize(f"{work.name}/one.ndjson")
    print(f"output {out / strokes:.0f} bytes per stroke, {out / sum(map(os.path.getsize, shards)):.2f} x input")
    print("workers  strokes/s samples/s  ratio  user s  sys s  strokes per user s  MiB  skew")
    base = statistics.median(run[0] for run in runs[1])
    for workers, list_of_runs in runs.items():
        wall = statistics.median(run[0] for run in list_of_runs)
        user, system = (statistics.median(sum(c[i] for c in run[1]) for run in list_of_runs) for i in (0, 1))
        memory = max(cost[2] for run in list_of_runs for cost in run[1])
        by_shard = [statistics.median(costs)
                    for costs in zip(*([cost[0] for cost in run[1]] for run in list_of_runs))]
        skew = max(by_shard) / statistics.median(by_shard)
        print(f"{workers or 'none':>7}  {strokes / wall:9.0f} {samples / wall:9.0f} {base / wall:6.2f}"
              f" {user:7.2f} {system:6.2f} {strokes / user:18.0f} {memory:4.0f} {skew:5.2f}")


if __name__ == "__main__":
    main()
