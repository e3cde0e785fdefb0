"""Whether edges swing no faster than their bounds say.

A second difference over v - h, v, v + h is a mean of the second derivative between v - h and
v + h. So it is compared with the bound of just that range, and only rounding is allowed for: with
positions right to some eps times the sheet's size it is ROUNDING eps size / h^2.
"""

from __future__ import annotations

import numpy as np

from orishell.motion import Mechanism, diagonal

Array = np.ndarray
RANGES = 512
ROUNDING = 100


def shares_of_bounds(
    mechanism: Mechanism, count: int = 24, ranges: int = RANGES, end: float | None = None
) -> tuple[Array, Array]:
    """True accelerations by their bounds (count,), row edges and column edges summed up.

    Up to the target, or to another end of the path. Fails where one exceeds its bound.
    """
    end = mechanism.target_drive if end is None else end
    h = 0.5 * end / ranges
    drives = np.linspace(h, end - h, count)
    bounds = mechanism.edge_accelerations(drives - h, drives + h)
    before, now, after = (mechanism.positions(drives + step) for step in (-h, 0, h))
    swing = (before - now) + (after - now)
    size = diagonal(mechanism.positions(0.0)) + np.abs(now).max()
    rounding = ROUNDING * np.finfo(float).eps * size / h**2
    shares = []
    for bound, axis in zip(bounds, (-2, -3), strict=True):
        true = np.linalg.norm(np.diff(swing, axis=axis), axis=-1).max(axis=-3 - axis - 1) / h**2
        assert true.shape == bound.shape
        assert (true <= bound * (1 + 1e-9) + rounding).all()
        shares.append(true.sum(axis=-1) / bound.sum(axis=-1))
    return shares[0], shares[1]
