"""The target surface, f swept rigidly, and the surface that finer and finer shells approach."""

from __future__ import annotations

import numpy as np

from orishell.curves import Trace
from orishell.design import Approached, Path, Surface, Turning
from orishell.polylines import Staircase

STRETCHED = 1e-9
"""A stretch that differs from 1 by less than this counts as none."""


def sweep(f: Trace, staircase: Staircase, g: Trace, plane: float) -> Surface:
    """f swept rigidly along g, in planes at the angle ``plane`` to it (radians).

    The staircase passes through g at its middle vertex.
    """
    return Surface(f, _origin(staircase), Turning(Path.of(g), plane))


def approach(f: Trace, staircase: Staircase, g: Trace, plane: float) -> Approached | None:
    """What finer shells approach where ``plane`` is no right angle: f stretched along its plane.

    None where that is f swept rigidly, or where g has corners that f's plane does not cross.
    """
    path = Path.of(g)
    if plane == np.pi / 2 or np.abs(path.corner_turns()).max(initial=0) / 2 >= min(
        plane, np.pi - plane
    ):
        return None
    rail = Turning(path, plane, affine=True)
    low, high = rail.scale_range()
    if max(abs(low - 1), abs(high - 1)) < STRETCHED:
        return None
    return Approached(
        f"f is not swept rigidly, for its plane is not square to g: it is stretched along its "
        f"plane to between {low:.4g} and {high:.4g} of its width",
        Surface(f, _origin(staircase), rail),
    )


def _origin(staircase: Staircase) -> np.ndarray:
    return np.asarray(staircase.vertices[len(staircase.vertices) // 2])
