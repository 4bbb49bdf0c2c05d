"""Helpers of the tests: random pen strokes, seeds, and the program `feltline`."""

import functools
import os
import subprocess
import unittest

import numpy as np

PROGRAM = os.environ.get("FELTLINE", "")
FIRST_SEED = int(os.environ.get("FELT_SEED", "0")) or int.from_bytes(os.urandom(3), "little")

needs_program = unittest.skipUnless(PROGRAM, "the program feltline is not here")


def seeds(count=20):
    """Runs a test with `count` random generators. A failure prints its seed: FELT_SEED=N repeats it."""
    def decorate(test):
        @functools.wraps(test)
        def run_all(self):
            for seed in range(FIRST_SEED, FIRST_SEED + count):
                with self.subTest(FELT_SEED=seed):
                    test(self, np.random.default_rng(seed))
        return run_all
    return decorate


def random_points(random, columns=5):
    """Returns a random stroke: a wandering pen with pressure, time and tilt, some of it unknown."""
    count = int(random.integers(1, 200))
    steps = random.normal(0, random.choice([0.02, 0.5, 4]), (count, 2))
    points = np.empty((count, 5))
    points[:, :2] = np.cumsum(steps, axis=0) + random.uniform(-50, 250, 2)
    points[:, 2] = np.clip(random.normal(0.5, 0.3, count), -0.04, 1.04)
    points[:, 3] = np.cumsum(random.integers(0, 20, count)) + random.choice([0, 0.125])
    points[:, 4] = np.round(random.uniform(0, 90, count), 1)
    for column in (2, 3, 4):
        points[random.random(count) < random.choice([0, 0, 0.3, 1]), column] = np.nan
    return points[:, :columns]


def run(*arguments):
    """Runs the program and returns its messages. Fails with them if the program fails."""
    done = subprocess.run([PROGRAM, *map(os.fspath, arguments)], capture_output=True, text=True,
                          check=False)
    if done.returncode != 0:
        raise AssertionError(f"feltline {arguments}: {done.stderr}")
    return done.stderr
