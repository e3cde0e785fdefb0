"""Which values of a parameter work while all others stay as they are: found by trying them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from pydantic import ValidationError

from orishell.curves import trace_curve
from orishell.errors import OrishellError
from orishell.spec import DesignFile
from orishell.studio.knobs import KNOBS

SAMPLES, FEWEST = 13, 7
"""Values tried of each parameter, before the ends are looked for; fewer if a design takes long."""
QUICK = 0.03
"""A design that takes less than this allows all samples (seconds)."""
HALVINGS = 8
"""Ends of intervals are found to the sample step over two to this power."""


@dataclass(frozen=True, slots=True)
class Range:
    """Values of a parameter.

    Parameters
    ----------
    span
        Those that were tried.
    intervals
        Those that work.
    below, above
        Why not below the lowest interval and above the highest; empty if the span ends there.
    """

    span: tuple[float, float]
    intervals: tuple[tuple[float, float], ...]
    below: str
    above: str


def find_ranges(
    file: DesignFile, advanced: Callable[[float, str], None], seconds: float
) -> dict[str, Range]:
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
    keys = [
        key for key in type(pattern).model_fields if key in KNOBS and KNOBS[key].kind == "number"
    ]
    count = SAMPLES if seconds < QUICK else FEWEST
    length = trace_curve(file.f).length
    found = {}
    for number, key in enumerate(keys):
        advanced(number / len(keys), "looking for admissible values")
        span = KNOBS[key].slider or (0.0 if key == "flap" else 1e-3 * length, length / 2)
        value = getattr(pattern, key)

        def works(trial: float, key: str = key) -> str:
            """Empty if a value works, otherwise why not."""
            try:
                values = {**pattern.model_dump(exclude_unset=True), key: trial}
                type(pattern).model_validate(values).design(file.f, file.g)
            except ValidationError as error:
                return error.errors()[0]["msg"]
            except OrishellError as error:
                return getattr(error, "condition", "") or str(error)
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
    return Range(
        span=(float(span[0]), float(span[1])),
        intervals=tuple(intervals),
        below=whys[0],
        above=whys[-1],
    )


def _edge(works: Callable[[float], str], good: float, bad: float) -> float:
    """The value nearest to ``bad`` that works."""
    for _ in range(HALVINGS):
        middle = 0.5 * (good + bad)
        good, bad = (good, middle) if works(middle) else (middle, bad)
    return good
