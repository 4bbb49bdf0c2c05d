"""Recordings and the metrics of trials."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import feltline
from helpers import needs_program, random_points, run, seeds

SCRIPT = """{"t_ms":0,"event":"tool","id":"pencil"}
{"t_ms":0,"event":"pen","x":20,"y":30,"z":5,"pressure":0}
{"t_ms":10,"event":"pen","x":20,"y":30,"z":0,"pressure":0.5,"buttons":2,"tilt":32.5}
{"t_ms":20.5,"event":"pen","x":21,"y":30.25,"z":0,"pressure":0.75}
{"t_ms":20.5,"event":"option","id":"pencil.snap","value":"off"}
{"t_ms":30,"event":"pen","x":22,"y":31,"z":1,"pressure":0}
{"t_ms":40,"event":"pen","x":22,"y":31,"z":-1}
"""


class Recordings(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.path = self.folder / "script.ndjson"
        self.path.write_text(SCRIPT)

    def test_samples_and_events_are_those_of_the_script(self):
        [recording] = feltline.read_recordings(self.path)
        lines = [json.loads(line) for line in SCRIPT.splitlines()]
        pens = [line for line in lines if line["event"] == "pen"]
        self.assertEqual(recording.events, [line for line in lines if line["event"] != "pen"])
        samples = recording.samples
        for name in ("t_ms", "x", "y", "z"):
            self.assertEqual(samples[name].tolist(), [pen[name] for pen in pens])
        np.testing.assert_array_equal(samples["pressure"], [0, 0.5, 0.75, 0, np.nan])
        np.testing.assert_array_equal(samples["tilt"], [np.nan, 32.5, np.nan, np.nan, np.nan])
        self.assertEqual(samples["buttons"].tolist(), [0, 2, 0, 0, 0])
        self.assertEqual(samples["contact"].tolist(), [False, True, True, False, True])
        self.assertTrue(np.isnan(samples["sent_x"]).all())
        self.assertEqual([len(touch) for touch in recording.touches()], [2, 1])
        self.assertEqual(len(feltline.fit(recording.touches()[0])), 1)
        with self.assertRaises(ValueError):
            samples["x"] = 0
        self.assertEqual(recording, feltline.read_recordings(self.path)[0])
        del recording
        self.assertEqual(samples["x"][0], 20)

    def test_pandas_is_optional(self):
        [recording] = feltline.read_recordings(self.path)
        try:
            import pandas  # noqa: F401
        except ImportError:
            pass
        else:
            frame = recording.to_pandas()
            self.assertEqual(frame["y"].tolist(), [30, 30, 30.25, 31, 31])
            self.assertEqual(len(frame.columns), len(recording.samples.dtype))
        code = ("import sys; sys.modules['pandas'] = None; import feltline\n"
                "feltline.read_recordings(sys.argv[1])[0].to_pandas()")
        done = subprocess.run([sys.executable, "-c", code, self.path], capture_output=True,
                              text=True, check=False)
        self.assertRegex(done.stderr, "ImportError: to_pandas.. needs pandas; install it")

    def test_errors_name_file_line_and_key(self):
        bad = self.folder / "bad.ndjson"
        for text, reason in [('{"t_ms":0,"event":"pen","x":"a"}', "bad.ndjson:1: x: "),
                             ('{"t_ms":0,"event":"undo"}\n{"event":"?"}', "bad.ndjson:2: "),
                             ("\x00", "bad.ndjson")]:
            bad.write_text(text)
            with self.subTest(text=text), self.assertRaisesRegex(ValueError, reason):
                feltline.read_recordings(bad)
        with self.assertRaisesRegex(FileNotFoundError, "none.felt"):
            feltline.read_recordings(self.folder / "none.felt")
        plain = self.folder / "plain.felt"
        feltline.write(plain, feltline.fit([[0, 0], [9, 9]]))
        self.assertEqual(feltline.read_recordings(plain), [])

    @needs_program
    def test_trials_of_a_study_have_forces_and_the_metrics_of_the_export(self):
        study = self.folder / "study.toml"
        study.write_text('id = "s"\nlabel = "S"\n[[condition]]\nname = "plain"\n'
                         '[[shape]]\nname = "line"\nkind = "line"\nsize_mm = 40\n')
        results, export = self.folder / "results", self.folder / "export"
        run("trial", "simulate", study, "--people", "1", "-o", results)
        run("trial", "export", results, "-o", export)
        lines = (export / "trials.csv").read_text().splitlines()
        names = lines[0].split(",")
        row = dict(zip(names, lines[1].split(",")))
        [recording] = feltline.read_recordings(results / row["recording"].replace(
            "recordings/", "") if (results / row["recording"].replace("recordings/", "")).exists()
            else export / row["recording"])
        self.assertTrue(np.isfinite(recording.samples["sent_z"]).any())
        self.assertGreater(len(recording), 100)
        # The page is A4, landscape, and the shape is in its middle.
        target = [[148.5 - 20, 105], [148.5 + 20, 105]]
        measured = feltline.trial.metrics(recording, target)
        for column in feltline.trial.columns():
            expected = float(row[column.name]) if row[column.name] else None
            if expected is None:
                self.assertIsNone(measured[column.name], column.name)
            else:
                self.assertAlmostEqual(measured[column.name], expected, places=9,
                                       msg=column.name)


class Metrics(unittest.TestCase):
    TARGET = [[0, 0], [100, 0]]

    def test_of_a_known_line(self):
        t = np.linspace(0, 1, 101)
        drawn = np.column_stack([100 * t, 2 + 0 * t, 0.5 + 0 * t, 1000 * t])
        measured = feltline.trial.metrics(drawn, self.TARGET, tunnel_width=10)
        self.assertEqual(measured["samples"], 101)
        self.assertAlmostEqual(measured["ink_length_mm"], 100)
        self.assertAlmostEqual(measured["err_mean_mm"], 2)
        self.assertAlmostEqual(measured["movement_s"], 1)
        self.assertAlmostEqual(measured["steering_id"], 10)
        self.assertIsNone(measured["force_mean_n"])
        same = feltline.trial.metrics(drawn[:, :2], self.TARGET, tunnel_width=10, interval_ms=10)
        self.assertAlmostEqual(same["err_rms_mm"], measured["err_rms_mm"])
        stroke = feltline.fit(self.TARGET)
        self.assertAlmostEqual(feltline.trial.metrics(drawn, stroke)["err_mean_mm"], 2)
        self.assertEqual(list(measured), [c.name for c in feltline.trial.columns()])

    @seeds()
    def test_of_random_lines(self, random):
        drawn = random_points(random)
        target = random_points(random, 2)
        measured = feltline.trial.metrics(drawn, target, interval_ms=4)
        self.assertEqual(measured["samples"], len(drawn))
        self.assertEqual(measured, feltline.trial.metrics(drawn, target, interval_ms=4))
        for name, value in measured.items():
            self.assertTrue(value is None or np.isfinite(value), name)

    def test_bad_arguments(self):
        for samples, target, arguments in [
            ([[0, 0]], self.TARGET, {}),
            ([[0, 0, 1, np.nan]], self.TARGET, {}),
            ([[0, 0]], [], {"interval_ms": 1}),
            ([[0, 0]], [[0, 0, 0]], {"interval_ms": 1}),
            ([[0, 0]], [[0, np.inf]], {"interval_ms": 1}),
            ([], self.TARGET, {"interval_ms": 1}),
            ([[0, 0]], self.TARGET, {"interval_ms": 0}),
            ([[0, 0]], self.TARGET, {"interval_ms": 1, "tunnel_width": np.nan}),
        ]:
            with self.subTest(arguments=arguments), self.assertRaises(ValueError):
                feltline.trial.metrics(samples, target, **arguments)


if __name__ == "__main__":
    unittest.main()
