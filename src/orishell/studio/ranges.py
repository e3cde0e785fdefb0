"""Which values of one parameter work while all others stay."""

from __future__ import annotations

from collections.abc import Callable
from itertools import groupby
from typing import Any

import numpy as np
from pydantic import ValidationError

from orishell.conventions.errors import OrishellError
from orishell.conventions.progress import Progress
from orishell.curves import trace_curve
from orishell.design_file import DesignFile
from orishell.motion import diagonal
from orishell.numerics.bisection import bisect
from orishell.shell.designed import design_of
from orishell.studio.api import Range
from orishell.studio.refusals import describe_error

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
