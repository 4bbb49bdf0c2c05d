import numpy.typing as npt

from . import Column, Recording, Stroke

def metrics(
    samples: Recording | npt.ArrayLike,
    target: Stroke | npt.ArrayLike,
    *,
    closed: bool = False,
    tunnel_width: float | None = None,
    target_width: float | None = None,
    interval_ms: float | None = None,
) -> dict[str, float | None]: ...
def columns() -> list[Column]: ...
