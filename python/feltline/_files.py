"""Reading and writing drawings, raw strokes and recordings."""

import io
import os
import warnings

from . import _feltline
from ._types import FormatWarning


def _name(path):
    """Returns a path for the library, in which "-" is an ordinary name."""
    path = os.fsencode(os.fspath(path))
    if b"\0" in path:
        raise ValueError("path: contains a NUL byte")
    return b"./-" if path == b"-" else path


def _stream_name(stream):
    """Returns the name of an open file, or "" if it has none."""
    name = getattr(stream, "name", "")
    return os.fsdecode(name) if isinstance(name, (str, bytes, os.PathLike)) else ""


def _write_all(stream, data):
    """Writes all bytes, also to an unbuffered file, which may accept only some of them at a time."""
    if not isinstance(stream, io.RawIOBase):
        stream.write(data)
        return
    rest = memoryview(data)
    while rest:
        written = stream.write(rest)
        if written is None:
            raise BlockingIOError("the file accepts no bytes now")
        rest = rest[written:]


def _warn(texts, name):
    for text in texts:
        warnings.warn(f"{os.fsdecode(name)}: {text}", FormatWarning, stacklevel=3)


def _fit(tolerance, filter, scheme, shared_samples, medium, min_width, max_width):
    return (tolerance, filter, scheme, shared_samples, medium, min_width, max_width)


def _drawing(content):
    if isinstance(content, _feltline.Drawing):
        return content
    if isinstance(content, _feltline.Stroke):
        content = [content]
    return _feltline.Drawing(content)


def read(path, *, salvage=False, tolerance=0.15, filter=False, scheme="feltline",
         shared_samples=4, medium=None, min_width=None, max_width=None):
    """Returns the drawing of a file of any readable format (see formats()).

    `path` is a name or an open binary file, which is read to its end.
    The content of the file decides the format, not its name. For each kind of content that was
    skipped or changed, there is one FormatWarning with its number; `Drawing.notices` has the same.
    Raw pen samples are fitted with the other arguments, as by fit(). With `salvage`, the intact
    parts of a damaged .felt file are recovered.

    Raises NotFoundError (a FileNotFoundError), FileError (an OSError) or DataError (a ValueError);
    the message names the file, the place and the reason.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = folder + "/line.felt"
    ...     feltline.write(path, feltline.fit([[0, 0], [10, 0]]))
    ...     feltline.read(path)
    <feltline.Drawing: 1 stroke in 1 layer>
    """
    if hasattr(path, "read"):
        return parse(path.read(), _stream_name(path), salvage=salvage, tolerance=tolerance,
                     filter=filter, scheme=scheme, shared_samples=shared_samples, medium=medium,
                     min_width=min_width, max_width=max_width)
    name = _name(path)
    drawing = _feltline.read(name, _fit(tolerance, filter, scheme, shared_samples, medium,
                                        min_width, max_width), salvage)
    _warn((notice.text for notice in drawing.notices), name)
    return drawing


def parse(data, name="", *, salvage=False, tolerance=0.15, filter=False, scheme="feltline",
          shared_samples=4, medium=None, min_width=None, max_width=None):
    """Returns the drawing of the bytes of a file, like read().

    `name` is the name of the file for messages; its ending is used only if the bytes do not show
    the format.

    >>> feltline.parse(b'{"points":[[0,0],[10,0]]}')
    <feltline.Drawing: 1 stroke in 1 layer>
    """
    drawing = _feltline.parse(bytes(data), os.fsencode(name),
                              _fit(tolerance, filter, scheme, shared_samples, medium, min_width,
                                   max_width), salvage)
    _warn((notice.text for notice in drawing.notices), name or "data")
    return drawing


def write(path, drawing, *, format=None, dpi=300.0, compact=False, pictures=False):
    """Writes a drawing, a stroke, or an iterable of strokes, completely or not at all.

    The ending of `path` decides the format, unless `format` names one. If writing fails, an
    existing file is unchanged. `path` may be an open binary file if `format` is given; it may be left incomplete if
    writing fails. For each kind of content that the format cannot hold, there is one
    FormatWarning with its number. `dpi` is for .png; `compact` makes a small .svg for web pages;
    `pictures` includes all pictures of layers.

    The file is the same, byte for byte, as that of `feltline convert` with these options.
    """
    is_stream = hasattr(path, "write")
    if is_stream and format is None:
        raise ValueError("format: is needed to write to an open file")
    name = os.fsencode(_stream_name(path)) if is_stream else _name(path)
    drawing = _drawing(drawing)
    arguments = _feltline.WriteArguments(format or "", dpi, compact, pictures)
    losses = _feltline.losses(drawing, name, arguments)
    _warn(losses, name or "data")  # first: if warnings are errors, the old file stays
    if is_stream:
        _write_all(path, _feltline.to_bytes(drawing, arguments))
    else:
        _feltline.write(name, drawing, arguments)


def to_bytes(drawing, format, *, dpi=300.0, compact=False, pictures=False):
    """Returns the bytes of a file, as write() would write them.

    >>> feltline.to_bytes(feltline.fit([[0, 0], [10, 0]]), "felt")[:15]
    b'SQLite format 3'
    """
    return _feltline.to_bytes(_drawing(drawing),
                              _feltline.WriteArguments(format, dpi, compact, pictures))


def formats():
    """Returns all formats, the one that can hold the most first.

    >>> [format.name for format in feltline.formats() if format.reads]
    ['felt', 'svg', 'inkml', 'xopp', 'ndjson']
    """
    return _feltline.formats()


def read_raw(path):
    """Returns the raw strokes of an .ndjson file (of Quick, Draw!, too), in the unit of the file.

    Each is a RawStroke (id, points); `points` has the rows that fit() reads. A line that is not a
    raw stroke is skipped with a FormatWarning. Raises an error if the file has no raw stroke.
    """
    name = _name(path)
    strokes, notices = _feltline.read_raw(name)
    _warn(notices, name)
    return strokes


def write_raw(path, strokes):
    """Writes raw strokes as .ndjson, completely or not at all.

    `strokes` is an iterable of RawStroke, or of arrays as for fit(), which are named s1, s2, ...
    """
    _feltline.write_raw(_name(path), strokes)


def read_recordings(path):
    """Returns the recordings of a .felt file, or of an event script or recording in .ndjson.

    A .felt file may have none or several: that of each session, the earliest first. The trials of
    a study are such files. An .ndjson file is one recording, without forces; `hand` events of a
    script are in `events`, because no device has played them yet.
    """
    return _feltline.read_recordings(_name(path))


def _unpickle(data, has_page):
    return _feltline.unpickle(data, has_page)


def _reduce_drawing(drawing):
    return _unpickle, (to_bytes(drawing, "felt"), drawing.page is not None)


_feltline.Drawing.__reduce__ = _reduce_drawing
_feltline.Drawing._repr_svg_ = lambda drawing: to_bytes(drawing, "svg").decode()
