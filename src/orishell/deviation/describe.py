"""A deviation as the report says it."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from orishell.design import Design
from orishell.deviation.measure import Deviation

NAMES = ("max", "rms", "mean", "p95", "sample_spacing")


def describe_deviation(
    design: Design, deviation: Deviation | None, approach: Deviation | None
) -> dict[str, Any]:
    """How close the polylines are to f and g, and the shell to the surface asked for.

    Parameters
    ----------
    design
        The design.
    deviation
        Of its shell from the surface asked for, if it was measured.
    approach
        Of its shell from what the family approaches instead, if that is known.
    """
    approached = design.approached
    return {
        **{name: asdict(closeness) for name, closeness in design.closeness.items()},
        "surface": deviation
        and {**{name: getattr(deviation, name) for name in NAMES}, **asdict(deviation)},
        "approached": approached
        and {
            "what": approached.what,
            "max": approach and approach.max,
            "rms": approach and approach.rms,
        },
    }
