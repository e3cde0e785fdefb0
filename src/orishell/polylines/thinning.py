"""Fewer samples of curves that are traced by very many."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.curves import Trace, remembered

MOST = 20_000
"""Traces of twice as many samples or more are thinned to this number, or little more; corners are
all kept."""


@remembered
def thinned(trace: Trace) -> Trace:
    """The trace, or every k-th of its samples and those at corners if it has very many."""
    stride = len(trace.t) // MOST
    if stride < 2:
        return trace
    last = len(trace.t) - 1
    kept = np.unique(np.concatenate([np.arange(0, last, stride), trace.corners, [last]]))
    return replace(
        trace,
        t=trace.t[kept],
        points=trace.points[kept],
        arc=trace.arc[kept],
        heading=trace.heading[kept],
        arriving=trace.arriving[kept],
    )
