"""fit(), Fitter and Stroke."""

import copy
import multiprocessing
import pickle
import tempfile
import threading
import unittest
import warnings
from pathlib import Path

import numpy as np

import feltline
from helpers import needs_program, random_points, run, seeds

try:
    import pandas
except ImportError:
    pandas = None

LINE = [[0, 0], [10, 0]]
# The options of `feltline fit`, and the same as arguments of fit().
OPTIONS = [
    ([], {}),
    (["--tolerance", "0.4"], {"tolerance": 0.4}),
    (["--no-refine"], {"refine": False}),
    (["--filter"], {"filter": True}),
    (["--mm-per-unit", "0.37"], {"mm_per_unit": 0.37}),
    (["--steady", "5.5,1.2,30"], {"steady": (5.5, 1.2, 30)}),
    (["--steady", "5.5,1.2,30"], {"steady": "5.5,1.2,30"}),
    (["--scheme", "paper2002", "--shared-samples", "2"],
     {"scheme": "paper2002", "shared_samples": 2}),
    (["--medium", "charcoal"], {"medium": "charcoal"}),
    (["--min-width", "0.5", "--max-width", "7"], {"min_width": 0.5, "max_width": 7}),
    (["--medium", "chalk", "--max-width", "9"], {"medium": "chalk", "max_width": 9}),
]


class Frame:
    """A data frame of another library than pandas: its columns have names, and one gets them by name."""

    def __init__(self, **columns):
        self.values, self.columns = columns, list(columns)

    def __getitem__(self, name):
        return self.values[name]


class Tables(unittest.TestCase):
    """Data frames of pandas, of other libraries, and structured arrays."""

    def setUp(self):
        self.points = random_points(np.random.default_rng(1))
        self.names = ["x", "y", "pressure", "t_ms", "tilt_deg"]
        self.stroke = feltline.fit(self.points)

    @unittest.skipUnless(pandas, "pandas is not here")
    @seeds(5)
    def test_a_data_frame_of_pandas_is_read_by_its_names(self, random):
        points = random_points(random)
        stroke = feltline.fit(points)
        frame = pandas.DataFrame(points, columns=self.names)
        self.assertEqual(feltline.fit(frame), stroke)
        self.assertEqual(feltline.fit(frame[list(random.permutation(self.names))]), stroke)
        self.assertEqual(feltline.fit(frame.convert_dtypes()), stroke)  # with pandas.NA
        self.assertEqual(feltline.fit(pandas.DataFrame(points)), stroke)  # columns 0 to 4
        unknown = points.copy()
        unknown[:, 2] = np.nan
        self.assertEqual(feltline.fit(frame.drop(columns="pressure")), feltline.fit(unknown))

    @unittest.skipUnless(pandas, "pandas is not here")
    def test_pandas_works_wherever_an_array_does(self):
        stroke = self.stroke
        places = np.array([[1.0, 2.0], [3.0, 4.0]])
        swapped = pandas.DataFrame(places, columns=["x", "y"])[["y", "x"]]
        self.assertEqual(repr(stroke.nearest(swapped)), repr(stroke.nearest(places)))
        widths = pandas.DataFrame(stroke.widths)
        tones = pandas.Series(np.full(len(stroke.widths), 0.5))
        self.assertEqual(feltline.Stroke(stroke.segments, widths, tones=tones),
                         feltline.Stroke(stroke.segments, stroke.widths, tones=tones.to_numpy()))
        drawn = pandas.DataFrame([[0, 1, 0.5, 0], [10, 1, 0.5, 100]], columns=self.names[:4])
        target = pandas.DataFrame([[0, 0], [20, 0]], columns=["x", "y"])
        self.assertEqual(feltline.trial.metrics(drawn[["t_ms", "y", "x", "pressure"]], target),
                         feltline.trial.metrics(drawn.to_numpy(), target.to_numpy()))
        fitter = feltline.Fitter()
        fitter.push(pandas.Series([1.0, 2.0, 0.5]))
        fitter.push(drawn[["y", "x"]])
        np.testing.assert_array_equal(fitter.samples[:, :2], [[1, 2], [0, 1], [10, 1]])

    def test_frames_of_other_libraries_and_structured_arrays(self):
        columns = dict(zip(self.names, self.points.T))
        self.assertEqual(feltline.fit(Frame(**columns)), self.stroke)
        self.assertEqual(feltline.fit(Frame(**{n: columns[n] for n in reversed(self.names)})), self.stroke)
        rows = np.array([tuple(row) for row in self.points[:, ::-1]],
                        dtype=[(name, "f8") for name in reversed(self.names)])
        self.assertEqual(feltline.fit(rows), self.stroke)

    def test_a_name_that_is_not_known_is_refused(self):
        for bad, reason in [
            ({"x": [0], "y": [1], "force": [2]}, "points: unknown column 'force'; the columns are x, y, "
             "pressure, t_ms, tilt_deg"),
            ({"x": [0], "t_ms": [1]}, "points: has no column 'y'"),
            ({"X": [0], "Y": [1]}, "unknown column 'X'"),
            ({"x": [], "y": []}, "points: is empty"),
        ]:
            with self.subTest(reason), self.assertRaisesRegex(ValueError, reason):
                feltline.fit(Frame(**bad))
        with self.assertRaisesRegex(TypeError, "real numbers"):
            feltline.fit(Frame(x=["a"], y=["b"]))

    def test_an_object_with_some_attribute_named_mask_is_no_masked_array(self):
        class Masked(np.ndarray):
            mask = "a method of another library"

        self.assertEqual(feltline.fit(self.points.view(Masked)), self.stroke)

    def test_other_processes_can_fit(self):
        self.assertIs(pickle.loads(pickle.dumps(feltline.fit)), feltline.fit)
        many = [random_points(np.random.default_rng(seed)) for seed in range(4)]
        with multiprocessing.get_context("spawn").Pool(2) as pool:
            self.assertEqual(pool.map(feltline.fit, many), [feltline.fit(points) for points in many])

    def test_a_wrong_keyword_is_named(self):
        with self.assertRaisesRegex(TypeError, r"^fit\(\) got an unexpected keyword argument 'tolerence'$"):
            feltline.fit(LINE, tolerence=1)


class Fit(unittest.TestCase):
    @needs_program
    @seeds(3)
    def test_equals_the_program_byte_for_byte(self, random):
        with tempfile.TemporaryDirectory() as folder:
            raw, theirs, ours = (Path(folder, n) for n in ("raw.ndjson", "t.ndjson", "o.ndjson"))
            strokes = [random_points(random) for _ in range(10)]
            feltline.write_raw(raw, strokes)
            for options, arguments in OPTIONS:
                with self.subTest(options=options):
                    run("fit", raw, *options, "-o", theirs)
                    fitted = [feltline.fit(points, **arguments) for points in strokes]
                    feltline.write(ours, fitted)
                    self.assertEqual(ours.read_bytes(), theirs.read_bytes())
                    with warnings.catch_warnings():
                        # The reader lengthens a dot that is shorter than allowed by rounding.
                        warnings.simplefilter("ignore", feltline.FormatWarning)
                        back = feltline.read(theirs)
                    if not back.notices:
                        self.assertEqual(fitted, back.strokes)

    @seeds()
    def test_every_sample_is_within_the_tolerance(self, random):
        points = random_points(random)
        tolerance = random.choice([0.05, 0.15, 1.0])
        stroke = feltline.fit(points, tolerance)
        distance = stroke.nearest(points[:, :2]).distance
        self.assertLessEqual(distance.max(), tolerance * (1 + 1e-9) + 0.05 * (len(points) < 2))

    @seeds()
    def test_does_not_depend_on_the_layout_of_the_array_or_on_earlier_strokes(self, random):
        points = random_points(random)
        expected = feltline.fit(points)
        feltline.fit(random_points(random), tolerance=0.3)
        feltline.fit(random_points(random))
        for same in (np.asfortranarray(points), np.repeat(points, 2, axis=0)[::2],
                     points[::-1].copy()[::-1], points.tolist(), points.astype(np.longdouble)):
            self.assertEqual(feltline.fit(same), expected)
        ints = np.round(points[:, :2]).astype(np.int16)
        self.assertEqual(feltline.fit(ints), feltline.fit(ints.astype(float)))

    @seeds()
    def test_streaming_gives_the_same_stroke(self, random):
        fitter = feltline.Fitter()
        fitter.push(random_points(random))
        fitter.begin()
        points = random_points(random)
        at = 0
        frozen = np.empty((0, 4, 2))
        while at < len(points):
            step = int(random.integers(1, 9))
            fitter.push(points[at] if step == 1 else points[at:at + step])
            at += step
            now = fitter.frozen
            np.testing.assert_array_equal(now[:len(frozen)], frozen)  # never changes
            np.testing.assert_array_equal(fitter.frozen_from(len(frozen)), now[len(frozen):])
            frozen = now
            if len(frozen) and len(fitter.tail):
                np.testing.assert_allclose(fitter.tail[0, 0], frozen[-1, 3])
        self.assertEqual(fitter.end(), feltline.fit(points))
        self.assertEqual(fitter.end(), feltline.fit(points))
        clamped = points.copy()
        clamped[:, 2] = np.clip(points[:, 2], 0, 1)
        np.testing.assert_array_equal(fitter.samples, clamped)
        with self.assertRaisesRegex(ValueError, "has ended"):
            fitter.push((0, 0))

    def test_bad_arrays_are_errors_with_a_reason(self):
        nan, inf = float("nan"), float("inf")
        many = np.zeros((5, 2))
        many[3, 1] = nan
        for bad, error, reason in [
            ([], ValueError, "points: is empty"),
            (np.empty((0, 2)), ValueError, "points: is empty"),
            ([1, 2], ValueError, r"shape \(n, 2 to 5\), not \(2,\)"),
            (np.zeros((2, 2, 2)), ValueError, r"not \(2, 2, 2\)"),
            (np.zeros((3, 1)), ValueError, "2 to 5 columns, not 1"),
            (np.zeros((3, 6)), ValueError, "2 to 5 columns, not 6"),
            (np.zeros((0, 6)), ValueError, "points: is empty"),
            (5, ValueError, r"not \(\)"),
            (None, TypeError, "real numbers, not object"),
            ("abc", TypeError, "real numbers, not <U3"),
            ([["a", "b"]], TypeError, "real numbers, not <U1"),
            ([[1, 2j]], TypeError, "real numbers, not complex"),
            ([[True, False]], TypeError, "real numbers, not bool"),
            (np.array([["2020-01-01"] * 2], dtype="M8[D]"), TypeError, "real numbers"),
            ([[1, 2], [3]], ValueError, "cannot be converted"),
            (np.ma.masked_array([[1, 2]], [[0, 1]]), TypeError, "masked"),
            (many, ValueError, r"points\[3\]: y is nan, not a finite number"),
            ([[inf, 0]], ValueError, r"points\[0\]: x is inf"),
            ([[2e9, 0]], ValueError, "beyond 1e9 mm"),
            ([[0, 0, inf]], ValueError, "pressure is inf"),
            ([[0, 0, 1, 1e13]], ValueError, "t_ms is 10000000000000.0, beyond 9e12 ms"),
            ([[0, 0, 1, 1, 91]], ValueError, "tilt_deg is 91.0, not an angle"),
            (np.broadcast_to(np.zeros(2), (10**14, 2)), MemoryError, ""),
        ]:
            with self.subTest(reason=reason, error=error), self.assertRaisesRegex(error, reason):
                feltline.fit(bad)
        for bad in (nan, -1.0, 1e10, "x", None):
            with self.subTest(tolerance=bad), self.assertRaises((ValueError, TypeError)):
                feltline.fit(LINE, tolerance=bad)
        for arguments in ({"scheme": "x"}, {"medium": "x"}, {"medium": "eraser"},
                          {"min_width": 0}, {"min_width": 3, "max_width": 2},
                          {"shared_samples": -1}, {"mm_per_unit": 0}, {"steady": (1, 2)},
                          {"steady": "1,2"}, {"mm_per_unit": nan}):
            with self.subTest(arguments), self.assertRaises(ValueError):
                feltline.fit(LINE, **arguments)
        with self.assertRaisesRegex(FileNotFoundError, "no-such-file"):
            feltline.fit(LINE, steady="no-such-file")

    def test_an_array_that_calls_fit_is_harmless(self):
        class Nested:
            def __array__(self, dtype=None):
                feltline.fit(LINE, tolerance=0.7)
                return np.array(LINE, float)

        self.assertEqual(feltline.fit(Nested(), tolerance=0.2), feltline.fit(LINE, tolerance=0.2))

    def test_threads_get_the_same_strokes(self):
        random = np.random.default_rng(1)
        strokes = [random_points(random) for _ in range(40)]
        expected = [feltline.fit(points) for points in strokes]
        shared = feltline.Fitter()
        results = {}

        def work(number):
            for points in strokes:
                shared.push(points)
                len(shared.tail)
            results[number] = [feltline.fit(points) for points in strokes]

        threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for number in range(4):
            self.assertEqual(results[number], expected)
        self.assertEqual(len(shared.samples), 4 * sum(map(len, strokes)))

    def test_other_threads_run_during_a_long_fit(self):
        ticks = 0
        done = threading.Event()
        points = np.cumsum(np.random.default_rng(2).normal(0, 0.5, (200_000, 2)), axis=0)
        thread = threading.Thread(target=lambda: (feltline.fit(points), done.set()))
        thread.start()
        while not done.wait(0.001):
            ticks += 1
        thread.join()
        self.assertGreater(ticks, 20)


class Stroke(unittest.TestCase):
    @seeds()
    def test_arrays_describe_the_stroke_and_rebuild_it(self, random):
        stroke = feltline.fit(random_points(random), medium=random.choice(["chalk", "pencil"]))
        stroke = stroke.replace(color="#0a141e80")
        n = len(stroke)
        self.assertEqual(stroke.segments.shape, (n, 4, 2))
        self.assertEqual(stroke.points.shape, (3 * n + 1, 2))
        np.testing.assert_array_equal(stroke.segments[:, 0], stroke.points[:-1:3])
        np.testing.assert_array_equal(stroke.segments[:, 3], stroke.points[3::3])
        self.assertEqual(len(stroke.joints), n - 1)
        self.assertEqual((stroke.widths[0, 0], stroke.widths[-1, 0]), (0, n))
        same = feltline.Stroke(stroke.segments, stroke.widths, stroke.joints, stroke.closed,
                               stroke.tones, stroke.medium, stroke.color)
        self.assertEqual(same, stroke)
        self.assertEqual(hash(same), hash(stroke))
        self.assertIsNot(same, stroke)
        for equal in (copy.copy(stroke), copy.deepcopy(stroke),
                      pickle.loads(pickle.dumps(stroke))):
            self.assertEqual(equal, stroke)
        self.assertNotEqual(stroke, stroke.replace(color="#123456"))
        self.assertFalse(stroke == 1)
        x0, y0, x1, y1 = stroke.bounds
        polygon = np.concatenate(stroke.outline(0.01))
        self.assertTrue((polygon >= [x0 - 0.02, y0 - 0.02]).all())
        self.assertTrue((polygon <= [x1 + 0.02, y1 + 0.02]).all())

    def test_arrays_cannot_be_written_and_outlive_the_stroke(self):
        stroke = feltline.fit(LINE)
        arrays = [stroke.segments, stroke.points, stroke.widths, stroke.tones]
        kept = [array.copy() for array in arrays]
        for array in arrays:
            with self.assertRaises(ValueError):
                array[...] = 0
            with self.assertRaises(ValueError):
                array.flags.writeable = True
        del stroke
        feltline.fit([[5, 5], [9, 9]])
        for array, copied in zip(arrays, kept):
            np.testing.assert_array_equal(array, copied)

    @seeds()
    def test_nearest_is_the_smallest_distance(self, random):
        stroke = feltline.fit(random_points(random))
        queries = random.uniform(-100, 300, (20, 2))
        many = stroke.nearest(queries)
        u = np.linspace(0, len(stroke), 200 * len(stroke))
        curve = stroke.position(u)
        for i, query in enumerate(queries):
            one = stroke.nearest(query)
            self.assertEqual((one.u, one.distance), (many.u[i], many.distance[i]))
            self.assertLessEqual(one.distance, np.hypot(*(curve - query).T).min() + 1e-9)
            np.testing.assert_allclose(stroke.position(one.u), one.point, atol=1e-9)
            np.testing.assert_allclose(np.hypot(*(query - one.point)), one.distance,
                                       rtol=1e-9, atol=1e-9)

    @seeds()
    def test_parts_have_the_same_curve_and_width(self, random):
        stroke = feltline.fit(random_points(random))
        u = random.uniform(0.2, 0.8) * len(stroke)
        try:
            first, second = stroke.split(u)
        except ValueError as error:
            self.assertIn("I5", str(error))  # a part would be too short
            return
        np.testing.assert_array_equal(first.points[-1], second.points[0])
        np.testing.assert_allclose(first.points[-1], stroke.position(u), atol=1e-9)
        self.assertAlmostEqual(first.length + second.length, stroke.length, places=6)
        self.assertAlmostEqual(first.width(len(first)), stroke.width(u))
        back = stroke.reversed().reversed()
        np.testing.assert_array_equal(back.segments, stroke.segments)
        np.testing.assert_allclose(back.widths, stroke.widths, atol=1e-9)

    def test_a_closed_stroke_has_a_seam_and_a_hole(self):
        ring = feltline.Stroke([[[0, 0], [20, -20], [40, -20], [60, 0]],
                                [[60, 0], [40, 30], [20, 30], [0, 0]]], [[0, 1], [2, 1]],
                               ["corner", "corner"], closed=True)
        self.assertEqual(len(ring.outline()), 2)
        self.assertEqual(len(ring.part(1.5, 0.5)), 2)
        with self.assertRaises(ValueError):
            ring.split(1)
        self.assertIn("closed", repr(ring))
        self.assertEqual(pickle.loads(pickle.dumps(ring)), ring)

    def test_bad_values_are_errors_with_a_reason(self):
        segment = [[[0, 0], [1, 0], [2, 0], [3, 0]]]
        for arguments, reason in [
            (([], [[0, 1], [1, 1]]), "segments"),
            (([[0, 0]], [[0, 1], [1, 1]]), r"shape \(n, 4, 2\)"),
            ((segment, [[0, 1], [2, 1]]), "I6"),
            ((segment, [[0, 0.01], [1, 1]]), "I4"),
            ((segment, [[0, float("nan")], [1, 1]]), "I"),
            ((segment + [[[9, 9]] * 4], [[0, 1], [2, 1]]), r"segments\[1\]: does not start"),
            ((segment, [[0, 1], [1, 1]], ["round"]), "neither 'smooth' nor 'corner'"),
            ((segment, [[0, 1], [1, 1]], ["corner"]), ""),
            ((segment, [[0, 1], [1, 1]], None, False, [0.5]), "tones"),
            ((segment, [[0, 1], [1, 1]], None, False, None, "pencil", "red"), "color"),
        ]:
            with self.subTest(reason=reason), self.assertRaisesRegex(ValueError, reason):
                feltline.Stroke(*arguments)
        no_mask = np.zeros_like(segment, bool)
        with self.assertRaisesRegex(TypeError, "segments: is a masked array"):
            feltline.Stroke(np.ma.masked_array(segment, no_mask), [[0, 1], [1, 1]])
        with self.assertRaisesRegex(TypeError, "tones: is a masked array"):
            feltline.Stroke(segment, [[0, 1], [1, 1]], tones=np.ma.masked_array([0.5, 1], [0, 1]))
        stroke = feltline.fit(LINE)
        for call in (lambda: stroke.split(float("nan")), lambda: stroke.part(1, 0),
                     lambda: stroke.nearest((1, float("inf"))), lambda: stroke.nearest((1, 2, 3)),
                     lambda: stroke.outline(0), lambda: stroke.outline(float("nan")),
                     lambda: stroke.nearest([]), lambda: stroke.position([[1]])):
            with self.assertRaises(ValueError):
                call()
        self.assertEqual(stroke.position(float("nan")), (0, 0))
        self.assertEqual(stroke.position(99), (10, 0))

    def test_raw_pressures_and_times_that_are_none_warn(self):
        steps = np.arange(40.0)
        rows = np.column_stack([2 * steps, steps % 3, 0.5 + 0.4 * np.sin(0.15 * steps), 8 * steps])
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            reference = feltline.fit(rows).widths[:, 1].max()
        for column, factor, text in ((2, 1023, "40 of 40 pressures"), (3, 0.001, "not milliseconds"),
                                     (3, 0, "not milliseconds"), (3, -1, "not milliseconds")):
            raw = rows.copy()
            raw[:, column] *= factor
            with self.subTest(text, factor=factor):
                with self.assertWarnsRegex(feltline.FormatWarning, text) as seen:
                    stroke = feltline.fit(raw)
                self.assertEqual(seen.filename, __file__)
                fitter = feltline.Fitter()
                fitter.push(raw)
                with self.assertWarnsRegex(feltline.FormatWarning, text) as seen:
                    self.assertEqual(fitter.end(), stroke)
                self.assertEqual(seen.filename, __file__)
                if column == 3:
                    self.assertAlmostEqual(stroke.widths[:, 1].max(), reference, delta=0.1 * reference)
                with warnings.catch_warnings():
                    warnings.simplefilter("error")
                    with self.assertRaises(feltline.FormatWarning):
                        feltline.fit(raw)

    def test_an_object_without_its_constructor_raises_type_error(self):
        needs = "without its constructor"
        for kind in (feltline.Stroke, feltline.Drawing, feltline.Fitter, feltline.Recording):
            one = kind.__new__(kind)
            for name, value in vars(kind).items():
                if isinstance(value, property):
                    with self.subTest(kind=kind, name=name), self.assertRaisesRegex(TypeError, needs):
                        getattr(one, name)
                elif callable(value) and name not in ("__init__", "__new__", "__eq__", "__copy__"):
                    # Some lack arguments, which is a TypeError, too; none may crash.
                    with self.subTest(kind=kind, name=name), self.assertRaises(TypeError):
                        getattr(one, name)()
        stroke, fitter = (kind.__new__(kind) for kind in (feltline.Stroke, feltline.Fitter))
        drawing = feltline.Drawing.__new__(feltline.Drawing)
        for call in (lambda: repr(stroke), lambda: feltline.Drawing([stroke]),
                     lambda: feltline.to_bytes(stroke, "svg"),
                     lambda: feltline.to_bytes([stroke], "svg"), lambda: pickle.dumps(stroke),
                     lambda: copy.deepcopy(drawing) == drawing, lambda: drawing == drawing,
                     lambda: feltline.to_bytes(drawing, "svg"), lambda: pickle.dumps(drawing),
                     lambda: feltline.fit(LINE) == stroke, lambda: stroke == feltline.fit(LINE),
                     lambda: feltline.trial.metrics([[0, 0, 1, 0], [9, 0, 1, 9]], stroke),
                     lambda: fitter.push(LINE),
                     lambda: feltline.Drawing([feltline.fit(LINE)]).map(lambda _: stroke)):
            with self.assertRaisesRegex(TypeError, needs):
                call()


if __name__ == "__main__":
    unittest.main()
