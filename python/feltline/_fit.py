"""Fitting of whole strokes."""

from . import _feltline


# A function of Python, so that it can be sent to other processes (multiprocessing, joblib, Dask).
def fit(points, tolerance=0.15, *, mm_per_unit=1.0, refine=True, filter=False, steady=None,
        scheme="feltline", shared_samples=4, medium=None, min_width=None, max_width=None):
    """Returns the stroke that follows pen samples, as `feltline fit` does.

    `points` has a row for each sample: x, y, and if known pressure (0 to 1), t_ms and tilt_deg (0 to
    90). NaN in these three means unknown. A data frame or a structured array is read by these names,
    in any order. Every sample is within `tolerance` mm of the curve.

    mm_per_unit     size of one unit of x and y
    refine          fits again with fewer segments; False keeps the curve of the live fit
    filter          drops what the pen adds at touch-down and lift
    steady          removes the shaking of a hand: (hz, mm, degrees), 'HZ,MM,DEG', or the name of a
                    file of `feltline steady calibrate`
    scheme          'feltline', or 'paper2002' for study, with its shared_samples
    medium          id of a medium, which sets widths, tone and response to tilt; None is ink-pen
    min_width       width in mm without pressure (0.3, or the medium's)
    max_width       width in mm at full pressure (2, or the medium's)

    Warns (FormatWarning) of pressures outside 0 to 1, which count as 0 or 1, and of times that are
    not milliseconds, for example seconds or all equal; they are ignored.
    Raises ValueError or TypeError if the array is empty or has a wrong shape, type or number.

    >>> feltline.fit([[0, 0], [10, 5], [20, 0]], tolerance=0.1)
    <feltline.Stroke: 1 segment, 0 corners, ink-pen>
    """
    return _feltline.fit(points, tolerance=tolerance, mm_per_unit=mm_per_unit, refine=refine,
                         filter=filter, steady=steady, scheme=scheme,
                         shared_samples=shared_samples, medium=medium, min_width=min_width,
                         max_width=max_width)
