"""How small a shell packs, and how many panels then lie on top of each other."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from orishell.conventions.formatting import in_one_line
from orishell.deployment.box import Box, smallest_box
from orishell.motion import Mechanism, diagonal, panel_normals
from orishell.numerics.arrays import Array, Integers
from orishell.sheet.quads import area_vectors, grid_corners, lengths

THIN = 1e-3
"""A bundle counts as at least this thick, relative to the diagonal of the flat sheet."""
SHRUNK = 1e-6
"""Panels are made smaller by this share, so that those beside each other do not overlap."""


@dataclass(frozen=True, slots=True, eq=False)
class Pack:
    """The state of a motion that fits into the smallest box.

    Parameters
    ----------
    drive
        Its drive angle (radians).
    box
        Its smallest box, of panels with their thickness.
    layers
        How many panels lie on top of each other there, see :func:`count_layers`.
    """

    drive: float
    box: Box
    layers: int

    __repr__ = in_one_line


def find_pack(mechanism: Mechanism, limit: float, states: int = 25, thickness: float = 0.0) -> Pack:
    """Return the state from the target to a limit that packs smallest.

    That is where length times width times height of the smallest box is least, a height below
    :data:`THIN` of the flat sheet's diagonal counting as that: otherwise a plane bundle of any size
    would be nothing. Of equals it is the last.

    Parameters
    ----------
    limit
        Drive angle up to which the motion is known to be free (radians), at least the target's.
    states
        Number of states that are compared, at equal steps of the drive.
    thickness
        Thickness of the panels (length): the box holds them as if they stood back from nothing.
    """
    floor = THIN * diagonal(mechanism.positions(0.0))
    best: tuple[float, float, Box] | None = None
    for drive in np.linspace(limit, mechanism.target_drive, states).tolist():
        box = smallest_box(_surfaces(mechanism.positions(drive), thickness))
        size = box.length * box.width * max(box.height, floor)
        if best is None or size < best[0]:
            best = size, drive, box
    assert best is not None
    _, drive, box = best
    points = mechanism.positions(drive).reshape(-1, 3)
    return Pack(drive, box, count_layers(points, mechanism.grid.faces_vertices(), box.axes))


def _surfaces(positions: Array, thickness: float) -> Array:
    """Vertices (V, 3) of panels, or of their upper and lower faces if they have a thickness."""
    if not thickness:
        return positions.reshape(-1, 3)
    corners, normals = grid_corners(positions), panel_normals(positions)
    over = 0.5 * thickness * normals[..., None, :]
    return np.concatenate([corners + over, corners - over]).reshape(-1, 3)


def count_layers(points: Array, faces: Integers, axes: Array | None = None) -> int:
    """Return how many panels lie on top of each other at most, seen along the box's shortest side.

    Panels of a thickness t make a bundle at least that many times t thick. Those seen edge-on do
    not count.

    Parameters
    ----------
    points
        Vertices (V, 3).
    faces
        Corners (F, 4) of the panels, in order around each.
    axes
        Directions (3, 3) of the box's sides, the shortest last; None for the smallest box.

    Notes
    -----
    Exact for convex panels: sets of them that overlap have a leftmost common point, and two of them
    have the same one (Helly). So it is enough to count the panels at the leftmost points of all
    overlaps of two, and of the panels themselves.
    """
    import shapely

    axes = smallest_box(points).axes if axes is None else axes
    corners = points[faces]
    centre = corners.mean(axis=1, keepdims=True)
    corners = (centre + (1 - SHRUNK) * (corners - centre)) @ axes.T
    normal = area_vectors(corners)
    seen = np.abs(normal[:, 2]) > SHRUNK * lengths(normal)
    if not seen.any():
        return 1
    panels = shapely.polygons(corners[seen][..., :2])
    tree = shapely.STRtree(panels)
    first, second = tree.query(panels, predicate="intersects")
    once = first <= second
    common = shapely.intersection(panels[first[once]], panels[second[once]])
    places, which = shapely.get_coordinates(common, return_index=True)
    order = np.lexsort([places[:, 1], places[:, 0], which])
    leftmost = order[np.unique(which[order], return_index=True)[1]]
    spots = shapely.points(places[leftmost])
    near = SHRUNK * 1e-3 * float(np.ptp(places, axis=0).max())
    found, _ = tree.query(spots, predicate="dwithin", distance=near)
    return int(np.bincount(found).max())
