"""Compares feltline.fit with the library's fitter on the same strokes, in the same process.

run.py [FILE.ndjson ...] [--rounds N]: prints the CPU time per sample of both and their ratio, the
median of N rounds (25) that take turns. Fails if a ratio is above 1.3, or if the results differ.
"""

import argparse
import statistics
import sys
import time

import bench_python
import feltline

MAX_RATIO = 1.3


def python_fit(strokes, tolerance, refine):
    segments = 0
    start = time.thread_time_ns()
    for points in strokes:
        segments += len(feltline.fit(points, tolerance, refine=refine))
    return time.thread_time_ns() - start, segments


def compare(name, strokes, tolerance, refine, rounds):
    samples = sum(map(len, strokes))
    native, python = [], []
    for _ in range(rounds):
        native_ns, expected = bench_python.fit_all(strokes, tolerance, refine)
        python_ns, segments = python_fit(strokes, tolerance, refine)
        if segments != expected:
            sys.exit(f"{name}: {segments} segments in Python, {expected} in C++")
        native.append(native_ns / samples)
        python.append(python_ns / samples)
    ratio = statistics.median(p / n for p, n in zip(python, native))
    print(f"| {name} | {statistics.median(native):,.0f} | {statistics.median(python):,.0f} "
          f"| {ratio:.2f} |")
    return ratio


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("files", nargs="*")
    parser.add_argument("--rounds", type=int, default=25)
    arguments = parser.parse_args()
    strokes = [stroke.points for file in arguments.files for stroke in feltline.read_raw(file)]
    print(f"{len(strokes)} strokes, {sum(map(len, strokes))} samples\n")
    print("| | C++, ns per sample | Python | ratio |\n|---|---:|---:|---:|")
    ratios = [compare("while drawing", strokes, 0.15, False, arguments.rounds),
              compare("refined at pen-up (the default)", strokes, 0.15, True, arguments.rounds)]
    if max(ratios) > MAX_RATIO:
        sys.exit(f"\nPython takes more than {MAX_RATIO} times as long as C++")


if __name__ == "__main__":
    main()
