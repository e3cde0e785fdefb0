"""Which values of a parameter work while all others stay as they are: found by trying them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from pydantic import ValidationError

from orishell.conventions.errors import OrishellError
from orishell.conventions.progress import Progress
from orishell.curves import trace_curve
from orishell.design_file import DesignFile
from orishell.numerics.bisection import bisect
from orishell.studio.api import Range
from orishell.studio.refusals import describe_error

SAMPLES, FEWEST = 13, 7
"""Number of values tried of each parameter before the ends; the smaller if a design takes long."""
QUICK = 0.03
"""Below this time for one design the larger number of values is tried (seconds)."""
ENDS = 0.005
"""Ends of intervals are found to this share of the step between the values tried."""


def find_ranges(file: DesignFile, advanced: Progress, seconds: float) -> dict[str, Range]:
    """Ranges of all numeric parameters of a design that has no tolerance.

    Parameters
    ----------
    file
        The design file.
    advanced
        Called with the share that is done.
    seconds
        What one design takes, about.
    """
    pattern = file.pattern
    knobs = {key: knob for key, knob in pattern.knobs().items() if knob.kind == "number"}
    count = SAMPLES if seconds < QUICK else FEWEST
    length = trace_curve(file.f).length
    found = {}
    for number, (key, knob) in enumerate(knobs.items()):
        advanced(number / len(knobs), "looking for admissible values")
        span = knob.slider or (0.0 if key == "flap" else 1e-3 * length, length / 2)
        value = getattr(pattern, key)

        def works(trial: float, key: str = key) -> str:
            """Why a value fails; empty if it works."""
            try:
                values = {**pattern.model_dump(exclude_unset=True), key: trial}
                type(pattern).model_validate(values).design(file.f, file.g)
            except ValidationError as error:
                return error.errors()[0]["msg"]
            except OrishellError as error:
                return describe_error(error)["error"]["what"]
            return ""

        found[key] = _find(works, span, value, count)
    return found


def _find(
    works: Callable[[float], str], span: tuple[float, float], value: Any, count: int
) -> Range:
    trials = np.linspace(*span, count)
    if isinstance(value, int | float) and span[0] < value < span[1]:
        trials = np.unique(np.append(trials, value))
    whys = [works(float(trial)) for trial in trials]
    intervals: list[tuple[float, float]] = []
    k = 0
    while k < len(trials):
        if whys[k]:
            k += 1
            continue
        first = k
        while k + 1 < len(trials) and not whys[k + 1]:
            k += 1
        low = trials[first] if first == 0 else _edge(works, trials[first], trials[first - 1])
        high = trials[k] if k + 1 == len(trials) else _edge(works, trials[k], trials[k + 1])
        intervals.append((float(low), float(high)))
        k += 1
    return {
        "span": (float(span[0]), float(span[1])),
        "intervals": intervals,
        "below": whys[0],
        "above": whys[-1],
    }


def _edge(works: Callable[[float], str], good: float, bad: float) -> float:
    """The end of an interval: of values from ``good`` to ``bad`` the farthest that works."""
    step = abs(bad - good)
    return bisect(lambda trial: not works(trial), good, bad, relative=0.0, absolute=ENDS * step)
