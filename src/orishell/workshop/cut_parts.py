"""What is cut in one piece, and its rim: the whole sheet, or one of the parts it is split into."""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.document import Document
from orishell.motion.quads import signed_areas
from orishell.numerics.arrays import Array, Integers
from orishell.workshop.drawing import Line, Text


@record
class CutPart:
    """A piece of the flat sheet, in the sheet's own coordinates.

    Parameters
    ----------
    number
        Its number, from 1; 0 if the sheet is not split.
    panels
        Numbers (P,) of its panels.
    creases
        Numbers (C,) of the edges that fold in it, those at the root of tabs too.
    outlines
        Closed polylines (k, 2) that are cut: the outer one first, counter-clockwise; holes
        clockwise. Tabs are part of the outline.
    marks
        What else is drawn on it, for instance the names of its joints.
    """

    number: int
    panels: Integers
    creases: Integers
    outlines: tuple[Array, ...]
    marks: tuple[Line | Text, ...] = ()


STRAIGHT = 1e-9
"""Directions that differ by less (radians) are the same."""


def whole_sheet(document: Document) -> CutPart:
    """The whole sheet as one part, number 0.

    Its creases are all edges that join two panels, unfolded ones too. Edges that the document
    cuts (C) are none of them: the outlines are those of all panels together, and what is cut
    inside them is drawn once, as lines.

    Raises
    ------
    InputError
        If there is no flat sheet.
    """
    flat = document.require_flat()
    mesh = document.mesh
    return CutPart(
        number=0,
        panels=np.arange(len(mesh.faces)),
        creases=np.flatnonzero(mesh.crease),
        outlines=tuple(flat[loop] for loop in find_outlines(mesh.faces, flat)),
    )


def find_outlines(faces: Integers, flat: Array) -> tuple[Integers, ...]:
    """Vertices of every closed outline of some panels of the flat sheet.

    Parameters
    ----------
    faces
        Vertices (P, 4) of the panels, either way round.
    flat
        Vertices (V, 2) of the sheet.

    Returns
    -------
    loops
        Numbers (k,) of vertices: counter-clockwise around panels, clockwise around holes; the
        largest area first, each from its lowest vertex on. Where outlines only touch at a
        vertex they do not cross: each keeps to the panels that hang together there.
    """
    corners = flat[faces]
    faces = np.where((signed_areas(corners) < 0)[:, None], faces[:, ::-1], faces)
    start = faces.ravel()
    sides = np.arange(len(start))
    following = sides - sides % 4 + (sides + 1) % 4
    twin = _twins(start, start[following], len(flat))
    rim = np.flatnonzero(twin < 0)
    successor = following[rim]
    while (inside := twin[successor] >= 0).any():
        successor = np.where(inside, following[twin[successor]], successor)
    cycles = _cycles(dict(zip(rim.tolist(), successor.tolist(), strict=True)))
    loops = [start[np.array(cycle, dtype=np.int64)] for cycle in cycles]
    loops = [np.roll(loop, -int(np.argmin(loop))) for loop in loops]
    return tuple(sorted(loops, key=lambda loop: (-float(signed_areas(flat[loop])), int(loop[0]))))


def without_straight(points: Array) -> Array:
    """The corners (c, 2) of a closed polyline (k, 2): points on straight runs are left out."""
    before = points - np.roll(points, 1, axis=0)
    after = np.roll(points, -1, axis=0) - points
    cross = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    dot = (before * after).sum(axis=1)
    return np.asarray(points[np.abs(np.arctan2(cross, dot)) > STRAIGHT])


def _twins(start: Integers, end: Integers, count: int) -> Integers:
    """The side (S,) of another panel along every side of a panel, -1 if there is none."""
    keys = np.minimum(start, end) * np.int64(count) + np.maximum(start, end)
    order = np.argsort(keys, kind="stable")
    first = np.flatnonzero(keys[order][1:] == keys[order][:-1])
    twin = np.full(len(keys), -1)
    twin[order[first]] = order[first + 1]
    twin[order[first + 1]] = order[first]
    return twin


def _cycles(successor: dict[int, int]) -> list[list[int]]:
    """The cycles of a permutation."""
    cycles = []
    while successor:
        cycle = [next(iter(successor))]
        while (after := successor.pop(cycle[-1])) != cycle[0]:
            cycle.append(after)
        cycles.append(cycle)
    return cycles
