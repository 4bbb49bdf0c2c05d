"""Columns of data frames (pandas, polars and others) as plain arrays of numbers."""

import numpy

# The columns of pen samples, in the order of the rows of fit().
_SAMPLE_NAMES = ("x", "y", "pressure", "t_ms", "tilt_deg")


def is_frame(data):
    """Returns whether `data` is a table with named columns: a data frame or a structured array."""
    if isinstance(data, numpy.ndarray):
        return data.dtype.names is not None
    return hasattr(data, "columns") and hasattr(data, "__getitem__")


def numbers_of(column):
    """Returns a column as an array. Missing values of a column of numbers become NaN."""
    kind = getattr(getattr(column, "dtype", None), "kind", None)
    if kind in ("f", "i", "u") and not isinstance(column, numpy.ndarray) and hasattr(column, "isna"):
        return column.to_numpy(dtype="float64", na_value=numpy.nan)
    return numpy.asarray(column)


def rows_of_frame(frame, name, most):
    """Returns the rows of a table in the order x, y, pressure, t_ms, tilt_deg; at most the first `most` of these.

    The names of the columns decide, not their order. A column that is missing before another one is NaN,
    which means unknown. A table whose columns have numbers as names is read by position.

    Raises ValueError if a name is unknown, twice, or x or y is missing.
    """
    names = list(frame.dtype.names if isinstance(frame, numpy.ndarray) else frame.columns)
    if not any(isinstance(column, str) for column in names):
        return numpy.column_stack([numbers_of(column) for _, column in frame.items()]) if names else frame
    known = _SAMPLE_NAMES[:most]
    for column in names:
        if column not in known:
            raise ValueError(f"{name}: unknown column {column!r}; the columns are {', '.join(known)}")
        if names.count(column) > 1:
            raise ValueError(f"{name}: has the column {column!r} {names.count(column)} times")
    for column in known[:2]:
        if column not in names:
            raise ValueError(f"{name}: has no column {column!r}")
    last = max(known.index(column) for column in names)
    columns = [numbers_of(frame[column]) if column in names else None for column in known[:last + 1]]
    unknown = numpy.full(len(columns[0]), numpy.nan)
    return numpy.column_stack([unknown if column is None else column for column in columns])
