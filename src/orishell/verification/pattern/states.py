"""Folded states of a file whose panels have any number of corners: whether they are what they say.

Quadrilaterals are examined by :mod:`orishell.verification.run`, with more tests.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from orishell.clash import find_contacts, overlap_depths
from orishell.conventions.formatting import in_degrees
from orishell.conventions.quantities import quantity
from orishell.conventions.record import record
from orishell.conventions.row import Row
from orishell.io import PatternState, ReadPattern
from orishell.motion.crease_pattern import CreasePattern, signed_areas
from orishell.motion.following.hinge_gaps import RigidPanels
from orishell.motion.mesh import folds_between
from orishell.motion.parts import Parts, find_parts
from orishell.motion.quads import dots, lengths, units
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.equals import descending, first_largest
from orishell.verification.residuals import turn_between


@record
class StateFigures:
    """What was found of one folded state; panels and edges by their numbers."""

    shape: Array  # by how much corners of panels (F,) are off their flat shape, in its plane
    bend: Array  # by how much out of it (F,)
    given: Array  # what given fold angles (E,) are off; NaN where there are none (radians)
    against: Integers  # creases that fold against their letters
    sure: int  # how many with a letter fold one way or the other
    touching: Integers  # pairs (P, 2) of panels that touch; none are looked for if panels are bent
    overlap: float  # by how much any of these reach into each other at most (length)


def examine_states(read: ReadPattern, flat: CreasePattern, error: float) -> Iterator[Row]:
    """Say of the folded states of a file whether panels keep their shape, and which meet.

    Parameters
    ----------
    read
        The file.
    flat
        Its flat sheet.
    error
        Allowed error of lengths (length).
    """
    limits = error / _sizes(flat)
    on_edges = np.append(limits, 0.0)[flat.edge_faces].max(axis=1)
    panels, parts = RigidPanels(flat), find_parts(flat)
    found = [_examined(panels, parts, state, error, on_edges) for state in read.states]
    many = "1 folded state" if len(found) == 1 else f"{len(found)} folded states"
    for subject, keep, fail, figures in (
        ("shape", "panels keep theirs", "panels change theirs", [each.shape for each in found]),
        ("planes", "panels stay plane", "panels are bent", [each.bend for each in found]),
    ):
        state, panel = np.unravel_index(first_largest(figures), np.shape(figures))
        worst = float(figures[state][panel])
        if worst <= error:
            yield Row("holds", subject, f"{keep} in {many}, to {quantity(worst, read.unit, 2)}")
        else:
            by = quantity(worst, read.unit, 2)
            said = f"{fail}: panel {panel} in folded state {state + 1} by {by}"
            yield Row("fails", subject, said)
    yield from _angles([each.given for each in found], on_edges, many)
    against = [(k, each.against) for k, each in enumerate(found, 1) if len(each.against)]
    if against:
        number, edges = against[0]
        first, second = flat.edges[edges[0]].tolist()
        said = f"{len(edges)} creases fold against theirs in folded state {number}: edge"
        mend = "exchange M and V: the letters are those of the other side"
        whole = all(len(each.against) == each.sure for each in found)
        yield Row("fails", "letters", f"{said} {first}-{second} for one", mend if whole else "")
    if all(max(each.shape.max(), each.bend.max()) <= error for each in found):
        yield _contact(found, error, many, read.unit)
    else:
        yield Row("warns", "contact", "not known: panels are not what they are in the flat sheet")


def _angles(given: list[Array], limits: Array, many: str) -> Iterator[Row]:
    """Whether given fold angles fit coordinates."""
    off = np.array(given)
    if np.isnan(off).all():
        yield Row("says", "angles", f"no fold angles are given of {many}")
        return
    beyond = np.nan_to_num(off - limits, nan=-np.inf)
    state, edge = np.unravel_index(first_largest(beyond), beyond.shape)
    if beyond.max() <= 0:
        most = in_degrees(float(np.nanmax(off)))
        yield Row("holds", "angles", f"those given fit coordinates, to {most} degrees")
    else:
        said = f"that given of edge {edge} in folded state {state + 1} is off by"
        yield Row("fails", "angles", f"{said} {in_degrees(float(off[state, edge]))} degrees")


def _contact(found: list[StateFigures], error: float, many: str, unit: str) -> Row:
    """Which panels meet: in the last state they may touch, but not pass through each other."""
    only = "; between states nothing is examined"
    for number, each in enumerate(found, 1):
        last = number == len(found)
        if len(each.touching) and (not last or each.overlap > error):
            first, second = each.touching[0].tolist()
            how = f"reach into each other by {quantity(each.overlap, unit, 2)}" if last else "meet"
            said = f"panels {first} and {second} {how} in folded state {number} of {len(found)}"
            return Row("fails", "contact", said + only)
    touch = " but the last, where some touch" if len(found[-1].touching) else ""
    return Row("holds", "contact", f"no panels meet in {many}{touch}{only}")


def _examined(
    panels: RigidPanels, parts: Parts, state: PatternState, error: float, limits: Array
) -> StateFigures:
    flat, points, given = panels.pattern, state.positions, state.fold_angles
    there = flat.faces >= 0
    corners = points[np.where(there, flat.faces, flat.faces[:, :1])]
    rigid = panels.fitted(corners)
    off = np.where(there[..., None], corners - rigid, 0.0)
    around = np.where(there[..., None], rigid, rigid[:, :1]) - rigid[:, :1]
    normals = units(np.cross(around, np.roll(around, -1, axis=1)).sum(axis=1))
    heights = dots(off, normals[:, None])
    shape = lengths(off - heights[..., None] * normals[:, None]).max(axis=1)
    bend = np.abs(heights).max(axis=1)
    folds = folds_between(normals, flat.edges, flat.edge_faces, flat.crease, points)
    sure = (np.abs(folds) > limits) & (np.abs(folds) < np.pi - limits)
    lettered = sure & flat.crease & (np.nan_to_num(flat.signs) != 0)
    against = np.flatnonzero(lettered & (flat.signs * folds < 0))
    missing = np.full(len(folds), np.nan)
    turns = missing if given is None else turn_between(folds, given)
    touching, overlap = np.zeros((0, 2), np.int64), 0.0
    if max(shape.max(), bend.max()) <= error:
        places = parts.extended(points)
        pairs = find_contacts(places, parts.faces, error)
        pairs = pairs[parts.panels[pairs[:, 0]] != parts.panels[pairs[:, 1]]]
        depths = overlap_depths(places, parts.faces, pairs)
        overlap = float(depths.max(initial=0.0))
        touching = parts.panels[pairs[descending(depths)]]
    return StateFigures(shape, bend, turns, against, int(lettered.sum()), touching, overlap)


def _sizes(flat: CreasePattern) -> Array:
    """The size (F,) of every panel: its area by its longest reach, which is no more than a side."""
    corners = flat.vertices[np.where(flat.faces < 0, flat.faces[:, :1], flat.faces)]
    reach = np.linalg.norm(np.ptp(corners, axis=1), axis=-1)
    return np.asarray(signed_areas(flat.vertices, flat.faces) / reach)
