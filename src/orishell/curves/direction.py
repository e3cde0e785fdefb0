"""Which way a curve is run through."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.curves.memo import remembered
from orishell.curves.trace import Trace


@remembered
def run_along_axis(trace: Trace, theta: float = 0.0) -> Trace:
    """The curve run through in the direction of its x axis, whichever way it was drawn.

    Parameters
    ----------
    theta
        Rotation that is going to be made (radians): it is the rotated x axis that counts.

    Returns
    -------
    Trace
        The curve, or its reverse, with tangents that after the rotation are nearer to the x axis
        than to its opposite, and directions on the branch about 0.
    """
    low, high = trace.heading_range()
    turns = np.round((0.5 * (low + high) + theta) / np.pi)
    if int(turns) % 2:
        return run_along_axis(trace.reversed(), theta)
    return replace(
        trace, heading=trace.heading - turns * np.pi, arriving=trace.arriving - turns * np.pi
    )
