"""Exceptions, warnings and small tuples of the package."""

from typing import NamedTuple


class Error(Exception):
    """An error of the library. The message names the file, the place and the reason.

    `code` is 'invalid-argument', 'invalid-data', 'limit-exceeded', 'unsupported', 'not-found' or
    'io'.
    """

    code = "invalid-data"


class DataError(Error, ValueError):
    """Values or the content of a file are invalid, too large, or not supported."""


class NotFoundError(Error, FileNotFoundError):
    """There is no such file."""


class FileError(Error, OSError):
    """The system refused to read or write a file, or failed."""


class FormatWarning(UserWarning):
    """Content of a file or of samples was skipped or changed, or cannot be written in a format."""


class Nearest(NamedTuple):
    """The nearest point of a stroke: its parameter, its distance in mm, and the point."""

    u: object
    distance: object
    point: object


class Layer(NamedTuple):
    """A layer of a drawing: strokes, the lowest first."""

    name: str
    strokes: list
    visible: bool = True
    locked: bool = False
    opacity: float = 1.0


class Notice(NamedTuple):
    """A kind of content that a reader skipped or changed; `line` is 0 if the format has none."""

    text: str
    line: int
    element: str
    what: str
    count: int


class RawStroke(NamedTuple):
    """A recorded stroke: rows (x, y, pressure, t_ms, tilt_deg), NaN if unknown."""

    id: str
    points: object


class Format(NamedTuple):
    """A file format, and what it can hold."""

    name: str
    title: str
    endings: tuple
    reads: bool
    writes: bool
    layers: bool
    lossless: bool


class Column(NamedTuple):
    """A metric of a trial. `source` is a DOI, or '' if Feltline defines the metric."""

    name: str
    unit: str
    formula: str
    source: str
