"""Which values work: of one parameter while all others stay, and of points taken by hand."""

from __future__ import annotations

from collections.abc import Callable
from itertools import groupby
from typing import Any

import numpy as np
from pydantic import ValidationError

from orishell.conventions.errors import CurveError, OrishellError
from orishell.conventions.progress import Progress
from orishell.curves import curve_from_points, trace_curve
from orishell.curves.nearest import Nearest
from orishell.design_file import DesignFile
from orishell.motion import diagonal
from orishell.numerics.arrays import Array
from orishell.numerics.bisection import bisect
from orishell.shell.designed import design_of
from orishell.studio.api import Range
from orishell.studio.refusals import describe_error

MANY = 20
"""So many points are kept as they are."""
CLOSE = 2e-3
"""How far a measured point may be from the spline, relative to the size of the curve."""
FEWEST_POINTS, MOST_POINTS = 5, 40


def few_points(points: Array) -> tuple[Array, bool, float]:
    """Fewer points (N, 2) along a curve, whether it is a spline, and how far it is from them all.

    The spline is fitted by least squares, so that noise is smoothed out; it keeps the ends. Where
    few straight lines do what no spline of few points does, there are corners; where neither does,
    a spline goes through all points.
    """
    import shapely

    if len(points) <= MANY:
        return points, True, 0.0
    size = float(np.hypot(*np.ptp(points, axis=0)))
    for count in range(FEWEST_POINTS, min(MOST_POINTS, len(points) // 2) + 1):
        few = _fitted(points, count)
        try:
            trace = trace_curve(curve_from_points(few, smooth=True))
        except CurveError:
            continue
        farthest = float(Nearest.to(trace)(points)[1].max())
        if farthest <= CLOSE * size:
            return few, True, farthest
    corners = shapely.get_coordinates(shapely.simplify(shapely.linestrings(points), CLOSE * size))
    if len(corners) <= MANY:
        lines = Nearest.to(trace_curve(curve_from_points(corners, smooth=False)))
        return corners, False, float(lines(points)[1].max())
    return points, True, 0.0


def _fitted(points: Array, count: int) -> Array:
    """Points (count, 2) of the cubic spline with so many coefficients that fits best."""
    from scipy.interpolate import make_lsq_spline

    chords = np.hypot(*np.diff(points, axis=0).T)
    apart = np.concatenate([[True], chords > 0])
    along = np.concatenate([[0.0], np.cumsum(chords)])[apart]
    share = along / along[-1]
    inner = np.linspace(0, 1, count - 2)[1:-1]
    knots = np.concatenate([np.zeros(4), inner, np.ones(4)])
    try:
        spline = make_lsq_spline(share, points[apart], knots)
    except (ValueError, np.linalg.LinAlgError):  # no points between two knots
        kept = np.unique(np.rint(np.linspace(0, len(points) - 1, count)).astype(int))
        return np.asarray(points[kept])
    few: Array = spline(np.linspace(0, 1, count))
    few[[0, -1]] = points[[0, -1]]
    places = 5 - int(np.floor(np.log10(np.ptp(points, axis=0).max())))
    rounded: Array = np.round(few, places) + 0.0
    return rounded


SAMPLES, FEWEST = 13, 7
"""Number of values tried of each parameter before the ends; the smaller if a design takes long."""
QUICK = 0.03
"""Below this time for one design the larger number of values is tried (seconds)."""
ENDS = 0.005
"""Ends of intervals are found to this share of the step between the values tried."""


def find_ranges(file: DesignFile, advanced: Progress, seconds: float) -> dict[str, Range]:
    """Ranges of all numeric parameters of a design, which takes some seconds to make."""
    pattern = file.pattern
    knobs = {key: knob for key, knob in pattern.knobs().items() if knob.kind == "number"}
    count = SAMPLES if seconds < QUICK else FEWEST
    length = _size(file)
    found = {}
    for number, (key, knob) in enumerate(knobs.items()):
        advanced(number / len(knobs), "looking for admissible values")
        value = getattr(pattern, key)
        span = knob.slider or (0.0 if key == "flap" else 1e-3 * length, length / 2)

        def works(trial: float, key: str = key) -> str:
            """Why a value fails; empty if it works."""
            try:
                values = {**pattern.model_dump(exclude_unset=True), key: trial}
                design_of(file, type(pattern).model_validate(values))
            except ValidationError as error:
                return error.errors()[0]["msg"]
            except OrishellError as error:
                return describe_error(error)["error"]["what"]
            return ""

        found[key] = _find(works, span, value, count)
    return found


def _size(file: DesignFile) -> float:
    """Length of f, or without it the size of the flat sheet; 1 if there is none."""
    if file.target is not None:
        return trace_curve(file.f).length
    try:
        return diagonal(design_of(file, file.pattern).mechanism.positions(0.0))
    except OrishellError:
        return 1.0


def _find(
    works: Callable[[float], str], span: tuple[float, float], value: Any, count: int
) -> Range:
    inside = np.linspace(*span, count)
    if isinstance(value, int | float) and span[0] < value < span[1]:
        inside = np.unique(np.append(inside, value))
    whys = [works(float(trial)) for trial in inside]
    # Where the span's end works, values beyond it may be typed all the same.
    width = float(span[1] - span[0])
    trials = [span[0] - width, *map(float, inside), span[1] + width]
    beyond = [whys[0] or works(trials[0]), whys[-1] or works(trials[-1])]
    fails = list(map(bool, [beyond[0], *whys, beyond[1]]))
    tolerance = ENDS * width / (count - 1)

    def edge(good: int, bad: int) -> float:
        """The end of an interval: between two trials, the farthest that works."""
        if not 0 <= bad < len(trials):  # the end is not known: it works up to the last trial
            return trials[good]
        ends = trials[good], trials[bad]
        return bisect(lambda trial: not works(trial), *ends, relative=0.0, absolute=tolerance)

    intervals: list[tuple[float, float]] = []
    for failed, run in groupby(range(len(trials)), fails.__getitem__):
        if not failed:
            first, *others = run
            last = [first, *others][-1]
            intervals.append((edge(first, first - 1), edge(last, last + 1)))
    return {
        "span": (float(span[0]), float(span[1])),
        "intervals": intervals,
        "beyond": (not fails[0], not fails[-1]),
        "below": whys[0],
        "above": whys[-1],
    }
