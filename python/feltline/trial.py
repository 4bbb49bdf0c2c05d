"""The metrics of one trial: how well, how fast and how smoothly a user drew a given path.

>>> drawn = [[0, 1, 0.5, 0], [10, 1, 0.5, 100], [20, 1, 0.5, 200]]  # x, y, pressure, t_ms
>>> measured = feltline.trial.metrics(drawn, [[0, 0], [20, 0]])
>>> round(measured["err_mean_mm"], 6), measured["movement_s"]
(1.0, 0.2)
"""

from . import _feltline

__all__ = ["metrics", "columns"]


def metrics(samples, target, *, closed=False, tunnel_width=None, target_width=None,
            interval_ms=None):
    """Returns the metrics of a trial as a dictionary, in the order of columns().

    A metric is None if the trial does not define it, for example forces without a device.

    samples       a Recording, or rows as for fit(); t_ms must be known, unless `interval_ms` gives
                  the time between two samples. A pressure of 0 means that the pen is in the air
    target        the given path: rows (x, y) in mm, or a Stroke, of which the centre line counts
    closed        True if the last point of the target is joined to the first
    tunnel_width  width of the tunnel around the path, mm
    target_width  diameter of the target at the end of a straight path, mm
    """
    return _feltline.trial_metrics(samples, target, closed, tunnel_width, target_width,
                                   interval_ms)


def columns():
    """Returns name, unit, formula and source (a DOI) of each metric.

    >>> feltline.trial.columns()[2].formula
    'Time from the first sample to the first contact.'
    """
    return _feltline.trial_columns()
