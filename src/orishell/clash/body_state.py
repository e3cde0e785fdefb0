"""Which boards meet in one state."""

from __future__ import annotations

import numpy as np

from orishell.clash.bodies import Apartness, Bodies
from orishell.clash.body_phase import Slabs, near_slabs
from orishell.clash.broad_phase import Pairs, common_corners, selected
from orishell.clash.state import near_panels
from orishell.numerics.arrays import Array, Booleans, Integers


def deepest_contact(
    bodies: Bodies, points: Array, tolerance: float, *, only: Booleans, settled: Integers
) -> tuple[tuple[int, int], float] | None:
    """Return the two bodies that reach farthest into each other, and how far; None if none touch.

    Bodies of panels with a common crease are left out: they meet by design.

    Parameters
    ----------
    bodies
        The boards.
    points
        Vertices (V, 3) of the state.
    tolerance
        Distance at which boards count as touching (length).
    only
        Panels (F,): pairs with none of them are left out.
    settled
        Vertices about which boards of opposite panels are known to be apart.
    """
    slabs = Slabs.of(points, bodies.faces, bodies.height)
    near = near_panels(points, bodies.faces, tolerance, bodies.height * slabs.normals.T)
    near = selected(near, only[near[0]] | only[near[1]])
    near = selected(near, ~_apart_by_design(bodies.faces, near, settled))
    near = near_slabs((slabs, slabs), near, np.full(len(near[0]), tolerance))
    pairs, _ = bodies.pairs_of(near)
    state = bodies.carried(points)
    apart = Apartness.of((state, state), pairs)
    found = apart.touching(0, pairs, tolerance)
    return None if found is None else (found, max(0.0, -float(apart.gaps[0].min())))


def _apart_by_design(faces: Integers, pairs: Pairs, settled: Integers) -> Booleans:
    """Pairs (P,) of panels with a common crease, or opposite each other at a settled vertex."""
    corners = common_corners(faces, *pairs).any(axis=2)
    at_settled = (corners & np.isin(faces[pairs[0]], settled)).any(axis=1)
    return np.asarray((corners.sum(axis=1) > 1) | at_settled)
