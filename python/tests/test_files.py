"""Reading and writing files."""

import io
import json
import os
import pickle
import tempfile
import unittest
import warnings
from pathlib import Path

import numpy as np

import feltline
from helpers import needs_program, random_points, run, seeds


class FilesCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def file(self, name, data=None):
        path = self.folder / name
        if data is not None:
            path.write_bytes(data)
        return path


def random_drawing(random):
    layers = []
    for number in range(int(random.integers(1, 4))):
        strokes = [feltline.fit(random_points(random), medium=random.choice(["chalk", "pencil"]))
                   .replace(color=random.choice(["#000000", "#c03020", "#10203080"]))
                   for _ in range(int(random.integers(1, 6)))]
        layers.append(feltline.Layer(f"Layer é {number}", strokes, bool(random.integers(2)),
                                     bool(random.integers(2)), float(random.choice([1, 0.5]))))
    page = (210.0, 297.0) if random.integers(2) else None
    return feltline.Drawing(layers, page=page, paper="#fffff0")


class Files(FilesCase):
    @seeds()
    def test_what_is_written_is_read_back(self, random):
        drawing = random_drawing(random)
        for format in feltline.formats():
            if not (format.reads and format.writes):
                continue
            path = self.file("drawing" + format.endings[0])
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", feltline.FormatWarning)
                feltline.write(path, drawing)
                back = feltline.read(path)
            self.assertEqual(back.format, format.name)
            if format.lossless and format.layers:
                self.assertEqual(back.strokes, drawing.strokes, format.name)
                self.assertEqual(back.layers, drawing.layers, format.name)
                self.assertEqual(back.page, drawing.page or back.page)
            elif format.lossless:
                visible = [s for layer in drawing.layers if layer.visible
                           for s in layer.strokes]
                self.assertEqual(back.strokes, visible, format.name)
        if drawing.page:
            self.assertEqual(feltline.parse(feltline.to_bytes(drawing, "felt")), drawing)
        self.assertEqual(pickle.loads(pickle.dumps(drawing)), drawing)

    @seeds(3)
    def test_open_files_are_read_and_written(self, random):
        drawing = random_drawing(random)
        for format in ("felt", "svg", "xopp"):
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                stream = io.BytesIO()
                feltline.write(stream, drawing, format=format)
                texts = [str(warning.message) for warning in caught]
                path = self.file("drawing." + format)
                feltline.write(path, drawing)
            self.assertEqual(stream.getvalue(), path.read_bytes())
            self.assertEqual([text.partition(": ")[2] for text in texts],
                             [str(w.message).partition(": ")[2] for w in caught[len(texts):]])
            with warnings.catch_warnings(), open(path, "rb") as file:
                warnings.simplefilter("ignore", feltline.FormatWarning)
                self.assertEqual(feltline.read(file), feltline.read(path))
                stream.seek(0)
                self.assertEqual(feltline.read(stream).strokes, feltline.read(path).strokes)
        class Slow(io.RawIOBase):
            data = b""

            def writable(self):
                return True

            def write(self, part):
                self.data += bytes(part[:1000])
                return min(1000, len(part))

        slow = Slow()
        feltline.write(slow, drawing, format="felt")
        self.assertEqual(slow.data, feltline.to_bytes(drawing, "felt"))
        with self.assertRaisesRegex(ValueError, "format: is needed"):
            feltline.write(io.BytesIO(), drawing)
        with self.assertRaises(feltline.DataError):
            feltline.read(io.BytesIO(b"neither"))

    @needs_program
    @seeds(3)
    def test_files_are_those_of_feltline_convert(self, random):
        source = self.file("source.felt")
        feltline.write(source, random_drawing(random))
        for ending in (".felt", ".ndjson", ".svg", ".svgz", ".inkml", ".xopp", ".pdf", ".png"):
            theirs, ours = self.file("theirs" + ending), self.file("ours" + ending)
            dpi = {"dpi": 60.0} if ending == ".png" else {}
            notices = run("convert", source, "-o", theirs, *(["--dpi", "60"] if dpi else []))
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                feltline.write(ours, feltline.read(source), **dpi)
            self.assertTrue(theirs.read_bytes() == ours.read_bytes(), ending)
            self.assertEqual(len(caught), len(notices.splitlines()), notices)

    @needs_program
    def test_raw_ink_gives_the_files_of_feltline_convert(self):
        source = self.file("raw.ndjson", b'{"id":"cat-1","points":[[0,0,0.5],[10,5,0.6],[20,0]]}\n'
                           b'{"points":[[0,9],[20,9]]}\n{"id":"s1","points":[[0,19],[20,19]]}\n'
                           b'{"id":"cat-1","points":[[0,29],[20,29],[20,40]]}\n')
        header = self.file("head.ndjson", b'{"feltline":1}\n\n{"points":[[0,0],[10,5]]}\n')
        for name in (source, header):
            drawing = feltline.read(name)
            for ending in (".felt", ".ndjson", ".svg", ".svgz", ".inkml", ".pdf"):
                theirs, ours = self.file("theirs" + ending), self.file("ours" + ending)
                run("convert", name, "-o", theirs)
                feltline.write(ours, drawing)
                self.assertEqual(theirs.read_bytes(), ours.read_bytes(), ending)

    def test_strokes_keep_their_names(self):
        names = ["cat-1", "s7", "\u00fc <&>", "07"]
        source = self.file("named.ndjson", "".join(
            json.dumps({"id": name, "points": [[0, 9 * i], [20, 9 * i]]}) + "\n"
            for i, name in enumerate(names)).encode())
        drawing = feltline.read(source)
        self.assertEqual(drawing.names, names)
        red = drawing.map(lambda stroke: stroke.replace(color="#ff0000"))
        for changed in (drawing, red, pickle.loads(pickle.dumps(red)), drawing.add([])):
            for ending in (".felt", ".ndjson", ".svg", ".inkml"):
                path = self.file("named" + ending)
                feltline.write(path, changed)
                self.assertEqual(feltline.read(path).names, names, ending)
        without = drawing.map(lambda stroke: None if stroke.length < 1e9 else stroke)
        self.assertEqual(without.names, [])
        more = drawing.add([drawing.strokes[0]])
        self.assertEqual(more.names[:4], names)
        self.assertEqual(len(set(more.names)), 5)

    def test_unsupported_content_is_a_counted_warning(self):
        path = self.file("a.svg", b'<svg xmlns="http://www.w3.org/2000/svg" width="50mm" '
                         b'height="50mm">\n<text id="title">x</text>\n<text>y</text>\n'
                         b'<path d="M 5 5 L 20 20" stroke="black" fill="none"/></svg>')
        with self.assertWarnsRegex(feltline.FormatWarning, "a.svg: line 2: text 'title'") as seen:
            drawing = feltline.read(path)
        self.assertEqual(seen.filename, __file__)  # the warning names the caller
        notice = drawing.notices[0]
        self.assertEqual((notice.line, notice.element), (2, "text 'title'"))
        self.assertEqual(sum(n.count for n in drawing.notices if "text" in n.text), 2)
        self.assertFalse(drawing.is_exact)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with self.assertRaises(feltline.FormatWarning):
                feltline.read(path)

    def test_what_a_format_cannot_hold_is_a_counted_warning(self):
        hidden = feltline.Drawing([feltline.Layer("a", [feltline.fit([[0, 0], [9, 9]])], False),
                                   feltline.Layer("b", [feltline.fit([[5, 0], [9, 9]])])])
        with self.assertWarnsRegex(feltline.FormatWarning, "1 stroke of hidden layers was left"):
            feltline.write(self.file("a.ndjson"), hidden)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            feltline.write(self.file("a.felt"), hidden)
            old = self.file("old.ndjson", b"old")
            with self.assertRaises(feltline.FormatWarning):
                feltline.write(old, hidden)
            self.assertEqual(old.read_bytes(), b"old")

    def test_errors_name_file_place_and_reason(self):
        good = b'{"points":[[0,0],[9,9]]}\n'
        cases = [
            (self.file("missing.felt"), FileNotFoundError, "missing.felt: cannot read: No such"),
            (self.folder, ValueError, "is a folder"),
            (self.file("empty", b""), ValueError, "empty: is empty"),
            (self.file("junk.bin", b"\x00\xff junk"), ValueError, "junk.bin: is not a drawing"),
            (self.file("cut.felt", feltline.to_bytes(feltline.fit([[0, 0], [9, 9]]),
                                                     "felt")[:9000]), ValueError, "cut.felt: "),
            (self.file("bad.ndjson", b'\n{"points":[[0,null]]}\n'), ValueError,
             r"bad.ndjson: line 2: .*points\[0\]"),
            (self.file("bad.inkml", b"<ink><trace>1 2</ink>"), ValueError, "bad.inkml: "),
            (self.file("bad.svg", b"<svg><path></svg>"), ValueError, "bad.svg: "),
            (self.file("events.ndjson", b'{"t_ms":0,"event":"undo"}\n'), ValueError, "events"),
        ]
        for path, error, reason in cases:
            with self.subTest(reason=reason), self.assertRaisesRegex(error, reason) as caught:
                feltline.read(path)
            self.assertIsInstance(caught.exception, feltline.Error)
            self.assertTrue(caught.exception.code)
        with self.assertWarnsRegex(feltline.FormatWarning, r"line 2: was skipped: .*points\[0\]"):
            self.assertEqual(len(feltline.read(self.file("half.ndjson",
                                                         good + b'{"points":[[0,"x"]]}'))), 1)
        os.mkfifo(self.file("pipe.svg"))
        with self.assertRaisesRegex(ValueError, "not a regular file"):
            feltline.read(self.file("pipe.svg"))  # and does not wait
        for bad in ("a\0b", 5, None):
            with self.assertRaises((ValueError, TypeError)):
                feltline.read(bad)

    def test_a_failed_write_leaves_the_old_file(self):
        stroke = feltline.fit([[0, 0], [9, 9]])
        old = self.file("old.felt", b"old")
        far = feltline.Stroke([[[0, 0], [1e8, 0], [2e8, 0], [9e8, 0]]], [[0, 1], [1, 1]])
        for path, drawing, error in [
            (old, [stroke, 5], TypeError),
            (self.file("old.png"), far, ValueError),
            (self.file("old.xyz"), stroke, ValueError),
            (self.file("no/such/folder.svg"), stroke, OSError),
        ]:
            with self.subTest(path=path), self.assertRaises(error) as caught:
                feltline.write(path, drawing)
            self.assertTrue(error is TypeError or path.name in str(caught.exception))
        self.assertEqual(old.read_bytes(), b"old")
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["old.felt"])
        if os.geteuid() != 0:
            old.chmod(0o400)
            with self.assertRaises(OSError):
                feltline.write(old, stroke)
        for arguments in ({"format": "x"}, {"dpi": 0}, {"dpi": float("nan")}, {"compact": True}):
            with self.assertRaises(ValueError):
                feltline.write(old, stroke, **arguments)

    def test_names_that_a_file_cannot_hold_are_refused(self):
        stroke = feltline.fit([[0, 0], [9, 9]])
        for name in ("x" * 5000, b"\xff"):
            with self.assertRaisesRegex(ValueError, "medium: must be UTF-8 of at most 4096 bytes"):
                stroke.replace(medium=name)
            with self.assertRaisesRegex(ValueError, r"strokes\[0\].id: must be UTF-8"):
                feltline.write_raw(self.file("raw.ndjson"), [feltline.RawStroke(name, [[0, 0]])])

    @seeds(5)
    def test_damaged_bytes_never_crash(self, random):
        drawing = random_drawing(random)
        for format in feltline.formats():
            if not (format.reads and format.writes):
                continue
            data = bytearray(feltline.to_bytes(drawing, format.name))
            for _ in range(10):
                at = int(random.integers(len(data) + 1))
                data[at:at + int(random.integers(5))] = random.bytes(int(random.integers(5)))
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                try:
                    feltline.parse(data)
                except feltline.Error as error:
                    self.assertTrue(str(error))

    def test_names_are_any_path(self):
        stroke = feltline.fit([[0, 0], [9, 9]])
        for name in ("ü.felt", b"bytes.felt", os.fsdecode(b"\xff.felt")):
            path = os.path.join(os.fsencode(self.folder), os.fsencode(name))
            feltline.write(path, stroke)
            self.assertEqual(feltline.read(path).strokes, [stroke])
        before = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, before)
        feltline.write("-", stroke, format="felt")
        self.assertEqual(feltline.read("-").strokes, [stroke])


class Drawings(FilesCase):
    def test_a_drawing_is_a_value(self):
        random = np.random.default_rng(3)
        drawing = random_drawing(random)
        red = drawing.map(lambda stroke: stroke.replace(color="#ff0000"))
        self.assertEqual({s.color for s in red}, {"#ff0000"})
        self.assertNotEqual(red, drawing)
        self.assertEqual(drawing.map(lambda stroke: stroke), drawing)
        self.assertEqual(len(drawing.map(lambda stroke: None)), 0)
        more = drawing.add([drawing.strokes[0]], layer=drawing.layers[0].name)
        self.assertEqual(len(more), len(drawing) + 1)
        self.assertEqual(len(set(more.names)), len(more))
        self.assertIsNone(feltline.Drawing().bounds)
        for call in (lambda: drawing.add([], layer="none"), lambda: drawing.add([5]),
                     lambda: drawing.map(lambda stroke: 5), lambda: feltline.Drawing([5]),
                     lambda: feltline.Drawing(page=(1, 1)), lambda: feltline.Drawing(5),
                     lambda: feltline.Drawing(page=(float("nan"), 100)),
                     lambda: feltline.Drawing([feltline.Layer("a", [], opacity=2)])):
            with self.assertRaises((ValueError, TypeError)):
                call()
        with self.assertRaises(ZeroDivisionError):
            drawing.map(lambda stroke: 1 / 0)


class RawStrokes(FilesCase):
    @seeds()
    def test_are_read_as_they_were_written(self, random):
        strokes = [feltline.RawStroke(f"ink-{i}", random_points(random)) for i in range(3)]
        path = self.file("raw.ndjson")
        feltline.write_raw(path, strokes)
        back = feltline.read_raw(path)
        self.assertEqual([s.id for s in back], [s.id for s in strokes])
        for ours, theirs in zip(strokes, back):
            np.testing.assert_array_equal(theirs.points, ours.points)

    def test_quickdraw_and_bad_lines(self):
        path = self.file("q.ndjson", b'{"word":"cat","key_id":"7","drawing":[[[0,9],[1,9]]]}\n')
        self.assertEqual([s.id for s in feltline.read_raw(path)], ["7.1"])
        path = self.file("r.ndjson", b'{"points":[[1,2]]}\n{"points":[]}\n')
        with self.assertWarnsRegex(feltline.FormatWarning, "line 2: was skipped"):
            self.assertEqual([s.id for s in feltline.read_raw(path)], ["s1"])
        with self.assertRaisesRegex(ValueError, "none.ndjson: contains no strokes"):
            feltline.read_raw(self.file("none.ndjson", b""))


if __name__ == "__main__":
    unittest.main()
