"""Narrow phase for bodies: pairs of boards are apart in a part of the path, touch, or stay open.

As for panels (:mod:`~orishell.clash.narrow_phase`). A corner of a board at the height h over its
panel is a mean of the panel's vertices and h n, n being the panel's normal.
"""

from __future__ import annotations

import numpy as np

from orishell.clash.bodies import Apartness, BodyState, one_direction
from orishell.clash.broad_phase import CHUNK, Pairs, joined
from orishell.clash.narrow_phase import Findings, Group
from orishell.clash.separation import corners_of, normals
from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers


def examine_bodies(
    states: tuple[BodyState, BodyState],
    pairs: Pairs,
    tolerance: float,
    chord_error: Array,
) -> Findings:
    """Return the pairs of bodies that are not proved apart, and those that touch at an end.

    Parameters
    ----------
    states
        The bodies at both ends of the part.
    pairs
        Bodies (P,).
    tolerance
        Distance at which they count as touching.
    chord_error
        How far (P,) vectors between their corners can be from the straight line in between.
    """
    corners = [(s.corners[:, :, pairs[0]], s.corners[:, :, pairs[1]]) for s in states]
    touching = np.full(len(pairs[0]), tolerance)
    group = Group(pairs, corners, touching, touching + chord_error)

    def not_separated(group: Group, apart: Apartness) -> Group:
        start, stop = (one_direction(state, group.pairs, apart.number) for state in states)
        return group.not_separated_by(start, stop)

    # Of solid panels pairs of edges have ten times as many directions as faces, which part most.
    group = not_separated(group, Apartness.of(states, pairs, of_faces=True))
    apart = Apartness.of(states, group.pairs)
    left = not_separated(group, apart).pairs
    return Findings(left, *(apart.touching(end, group.pairs, tolerance) for end in (0, 1)))


@record
class Slabs:
    """Panels as thick as their boards in one state: they enclose these.

    Parameters
    ----------
    corners
        Corners (3, 8, F).
    normals
        Unit normals (3, F).
    """

    corners: Array
    normals: Array

    @classmethod
    def of(cls, points: Array, faces: Integers, height: float) -> Slabs:
        """The slabs of panels (F, 4) in a state (V, 3), with faces at a height on both sides."""
        corners = corners_of(points, faces)
        normal = normals(corners)
        over = height * normal[:, None]
        return cls(np.concatenate([corners + over, corners - over], axis=1), normal)


def near_slabs(states: tuple[Slabs, Slabs], pairs: Pairs, needed: Array) -> Pairs:
    """The pairs of panels whose normals do not keep them apart, thick as they are.

    Parameters
    ----------
    pairs
        Panels (P,).
    needed
        Gaps (P,) that prove them apart.
    """
    left = []
    for k in range(0, len(pairs[0]), CHUNK):
        part = slice(k, k + CHUNK)
        chunk = (pairs[0][part], pairs[1][part])
        corners = [(s.corners[:, :, chunk[0]], s.corners[:, :, chunk[1]]) for s in states]
        group = Group(chunk, corners, needed[part], needed[part])
        for panel in (0, 1):
            group = group.not_separated_by(*(s.normals[:, group.pairs[panel]] for s in states))
        left.append(group.pairs)
    return joined(left)
