from os import PathLike
from typing import Any, BinaryIO, Callable, Iterable, Iterator, NamedTuple, Sequence

import numpy as np
import numpy.typing as npt

from . import trial as trial

__version__: str

class Error(Exception):
    code: str

class DataError(Error, ValueError): ...
class NotFoundError(Error, FileNotFoundError): ...
class FileError(Error, OSError): ...
class FormatWarning(UserWarning): ...

class Nearest(NamedTuple):
    u: Any
    distance: Any
    point: Any

class Layer(NamedTuple):
    name: str
    strokes: list[Stroke]
    visible: bool = True
    locked: bool = False
    opacity: float = 1.0

class Notice(NamedTuple):
    text: str
    line: int
    element: str
    what: str
    count: int

class RawStroke(NamedTuple):
    id: str
    points: Any

class Format(NamedTuple):
    name: str
    title: str
    endings: tuple[str, ...]
    reads: bool
    writes: bool
    layers: bool
    lossless: bool

class Column(NamedTuple):
    name: str
    unit: str
    formula: str
    source: str

class Stroke:
    def __init__(
        self,
        segments: npt.ArrayLike,
        widths: npt.ArrayLike,
        joints: Sequence[str] | None = None,
        closed: bool = False,
        tones: npt.ArrayLike | None = None,
        medium: str = "pencil",
        color: str = "#000000",
    ) -> None: ...
    @property
    def segments(self) -> npt.NDArray[np.float64]: ...
    @property
    def points(self) -> npt.NDArray[np.float64]: ...
    @property
    def widths(self) -> npt.NDArray[np.float64]: ...
    @property
    def tones(self) -> npt.NDArray[np.float64]: ...
    @property
    def joints(self) -> list[str]: ...
    @property
    def closed(self) -> bool: ...
    @property
    def medium(self) -> str: ...
    @property
    def color(self) -> str: ...
    @property
    def bounds(self) -> tuple[float, float, float, float]: ...
    @property
    def length(self) -> float: ...
    def position(self, u: npt.ArrayLike) -> Any: ...
    def width(self, u: npt.ArrayLike) -> Any: ...
    def tone(self, u: npt.ArrayLike) -> Any: ...
    def nearest(self, point: npt.ArrayLike) -> Nearest: ...
    def outline(self, tolerance: float = 0.005) -> list[npt.NDArray[np.float64]]: ...
    def path_data(self, tolerance: float = 0.005) -> str: ...
    def svg(self) -> str: ...
    def split(self, u: float) -> tuple[Stroke, Stroke]: ...
    def part(self, u0: float, u1: float) -> Stroke: ...
    def reversed(self) -> Stroke: ...
    def replace(
        self,
        *,
        color: str | None = None,
        medium: str | None = None,
        widths: npt.ArrayLike | None = None,
        tones: npt.ArrayLike | None = None,
    ) -> Stroke: ...
    def __len__(self) -> int: ...
    def __eq__(self, other: object) -> bool: ...
    def __hash__(self) -> int: ...

class Fitter:
    def __init__(
        self,
        tolerance: float = 0.15,
        *,
        refine: bool = True,
        filter: bool = False,
        scheme: str = "feltline",
        shared_samples: int = 4,
        medium: str | None = None,
        min_width: float | None = None,
        max_width: float | None = None,
    ) -> None: ...
    def begin(self) -> None: ...
    def push(self, points: npt.ArrayLike) -> None: ...
    def end(self) -> Stroke: ...
    def frozen_from(self, first: int) -> npt.NDArray[np.float64]: ...
    @property
    def frozen(self) -> npt.NDArray[np.float64]: ...
    @property
    def tail(self) -> npt.NDArray[np.float64]: ...
    @property
    def samples(self) -> npt.NDArray[np.float64]: ...

class Drawing:
    def __init__(
        self,
        content: Iterable[Stroke | Layer] = (),
        *,
        page: tuple[float, float] | None = None,
        paper: str = "#ffffff",
    ) -> None: ...
    @property
    def strokes(self) -> list[Stroke]: ...
    @property
    def names(self) -> list[str]: ...
    @property
    def layers(self) -> list[Layer]: ...
    @property
    def page(self) -> tuple[float, float] | None: ...
    @property
    def paper(self) -> str: ...
    @property
    def surface(self) -> str: ...
    @property
    def bounds(self) -> tuple[float, float, float, float] | None: ...
    @property
    def fill_count(self) -> int: ...
    @property
    def format(self) -> str: ...
    @property
    def is_exact(self) -> bool: ...
    @property
    def notices(self) -> list[Notice]: ...
    def map(self, function: Callable[[Stroke], Stroke | None]) -> Drawing: ...
    def add(self, strokes: Iterable[Stroke], layer: str | None = None) -> Drawing: ...
    def __len__(self) -> int: ...
    def __iter__(self) -> Iterator[Stroke]: ...
    def __eq__(self, other: object) -> bool: ...

class Recording:
    @property
    def samples(self) -> npt.NDArray[np.void]: ...
    @property
    def events(self) -> list[dict[str, Any]]: ...
    @property
    def device(self) -> str: ...
    @property
    def period_ms(self) -> float: ...
    def touches(self) -> list[npt.NDArray[np.float64]]: ...
    def to_pandas(self) -> Any: ...
    def __len__(self) -> int: ...
    def __eq__(self, other: object) -> bool: ...

def fit(
    points: npt.ArrayLike,
    tolerance: float = 0.15,
    *,
    mm_per_unit: float = 1.0,
    refine: bool = True,
    filter: bool = False,
    steady: str | PathLike[str] | Sequence[float] | None = None,
    scheme: str = "feltline",
    shared_samples: int = 4,
    medium: str | None = None,
    min_width: float | None = None,
    max_width: float | None = None,
) -> Stroke: ...
def read(
    path: str | bytes | PathLike[str] | BinaryIO,
    *,
    salvage: bool = False,
    tolerance: float = 0.15,
    filter: bool = False,
    scheme: str = "feltline",
    shared_samples: int = 4,
    medium: str | None = None,
    min_width: float | None = None,
    max_width: float | None = None,
) -> Drawing: ...
def parse(
    data: bytes,
    name: str = "",
    *,
    salvage: bool = False,
    tolerance: float = 0.15,
    filter: bool = False,
    scheme: str = "feltline",
    shared_samples: int = 4,
    medium: str | None = None,
    min_width: float | None = None,
    max_width: float | None = None,
) -> Drawing: ...
def write(
    path: str | bytes | PathLike[str] | BinaryIO,
    drawing: Drawing | Stroke | Iterable[Stroke | Layer],
    *,
    format: str | None = None,
    dpi: float = 300.0,
    compact: bool = False,
    pictures: bool = False,
) -> None: ...
def to_bytes(
    drawing: Drawing | Stroke | Iterable[Stroke | Layer],
    format: str,
    *,
    dpi: float = 300.0,
    compact: bool = False,
    pictures: bool = False,
) -> bytes: ...
def formats() -> list[Format]: ...
def read_raw(path: str | bytes | PathLike[str]) -> list[RawStroke]: ...
def write_raw(
    path: str | bytes | PathLike[str], strokes: Iterable[RawStroke | npt.ArrayLike]
) -> None: ...
def read_recordings(path: str | bytes | PathLike[str]) -> list[Recording]: ...
