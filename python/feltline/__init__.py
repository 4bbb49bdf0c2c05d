"""Feltline: pen samples to strokes of variable width, and files with drawings.

Lengths are in mm, x points right, y points down. Times in arrays are in ms. The functions release
the global interpreter lock while they fit, read, write and measure, and may be called from any
thread.

>>> import feltline
>>> stroke = feltline.fit([[0, 0], [10, 2], [20, 0]])
>>> stroke.segments.shape
(1, 4, 2)
"""

from . import trial
from ._feltline import Drawing, Fitter, Recording, Stroke, __version__
from ._files import (formats, parse, read, read_raw, read_recordings, to_bytes, write, write_raw)
from ._fit import fit
from ._types import (Column, DataError, Error, FileError, Format, FormatWarning, Layer, Nearest,
                     Notice, NotFoundError, RawStroke)

__all__ = [
    "Column", "DataError", "Drawing", "Error", "FileError", "Fitter", "Format", "FormatWarning",
    "Layer", "Nearest", "Notice", "NotFoundError", "RawStroke", "Recording", "Stroke", "fit",
    "formats", "parse", "read", "read_raw", "read_recordings", "to_bytes", "trial", "write",
    "write_raw",
]

for _name in __all__:
    if isinstance(globals()[_name], type):
        globals()[_name].__module__ = "feltline"
