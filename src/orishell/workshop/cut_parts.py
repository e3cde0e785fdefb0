"""What is cut in one piece, its rim, and how parts of a split sheet are joined.

A tab is glued to the back of the neighbouring panel, the side away from +z. The crease at its root
is scored as ever, and the other part is cut there. A strip is two such tabs with the crease between
them, glued to the backs of both panels.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from orishell.conventions.record import record
from orishell.document import Document
from orishell.motion.quads import signed_areas
from orishell.numerics.arrays import Array, Integers
from orishell.workshop.palettes import Line, Text
from orishell.workshop.seams import letters, seam_names, strip_numbers
from orishell.workshop.settings import Joint as JointKind
from orishell.workshop.tabs import find_owners, tab_shapes


@record
class CutPart:
    """A piece of the flat sheet, in the sheet's own coordinates."""

    number: int  # its number, from 1; 0 if the sheet is not split
    panels: Integers  # numbers (P,) of its panels
    creases: Integers  # numbers (C,) of the edges that fold in it, those at the root of tabs too
    # Closed polylines (k, 2) that are cut: the outer one first, counter-clockwise; holes clockwise.
    # Tabs are part of the outline.
    outlines: tuple[Array, ...]
    # what else is drawn on it, for instance the names of its joints
    marks: tuple[Line | Text, ...] = ()


STRAIGHT = 1e-9
"""Directions that differ by less (radians) are the same."""


def whole_sheet(document: Document) -> CutPart:
    """The whole sheet as one part, number 0, of all panels and all edges that join two of them.

    Edges that are cut inside its outlines (C) are drawn once, as lines.
    """
    flat = document.require_flat()
    mesh = document.mesh
    return CutPart(
        number=0,
        panels=np.arange(len(mesh.faces)),
        creases=np.flatnonzero(mesh.crease),
        outlines=tuple(flat[loop] for loop in find_outlines(mesh.loops, flat)),
    )


def named_sheet(document: Document) -> CutPart:
    """The whole sheet, with names along the seams of strips if it is made of any."""
    names = seam_names(document, strip_numbers(document))
    return replace(whole_sheet(document), marks=names)


def find_outlines(loops: Integers, flat: Array) -> tuple[Integers, ...]:
    """Vertices (k,) of every closed outline of panels (P, K), either way round, of a sheet (V, 2).

    Panels of fewer vertices have -1 behind the last.
    Counter-clockwise around panels, clockwise around holes; the largest area first, each from its
    lowest vertex on. Where outlines only touch at a vertex they do not cross: each keeps to the
    panels that hang together there.
    """
    there = loops >= 0
    corners = flat[np.where(there, loops, loops[:, :1])]
    clockwise = (signed_areas(corners) < 0)[:, None]
    loops = np.where(clockwise, loops[:, ::-1], loops)
    there = loops >= 0
    start, count = loops[there], there.sum(axis=1)
    last = np.cumsum(count) - 1
    following = np.arange(1, len(start) + 1)
    following[last] -= count
    twin = _twins(start, start[following], len(flat))
    rim = np.flatnonzero(twin < 0)
    successor = following[rim]
    while (inside := twin[successor] >= 0).any():
        successor = np.where(inside, following[twin[successor]], successor)
    cycles = _cycles(dict(zip(rim.tolist(), successor.tolist(), strict=True)))
    found = [start[np.array(cycle, dtype=np.int64)] for cycle in cycles]
    found = [np.roll(loop, -int(np.argmin(loop))) for loop in found]
    return tuple(sorted(found, key=lambda loop: (-float(signed_areas(flat[loop])), int(loop[0]))))


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
    cycles = []
    while successor:
        cycle = [next(iter(successor))]
        while (after := successor.pop(cycle[-1])) != cycle[0]:
            cycle.append(after)
        cycles.append(cycle)
    return cycles


NAME_AT, NAME_SHARE = 0.42, 0.46
"""Where a joint's name stands between the crease and the far side of its tab; its height."""
LETTER_WIDTH = 0.85
"""Width of a letter on average, relative to its height."""


@record
class Joint:
    """A crease that is cut and glued."""

    name: str  # for instance "2-5c": the third joint between parts 2 and 5
    edge: int
    parts: tuple[int, int]  # their numbers; the first one has the tab
    # corners (4, 2) of what is glued under panels: the tab under a panel of the second part and, if
    # the joint is a strip, its other half under the first part
    tabs: tuple[Array, ...]

    def marks(self) -> tuple[Text, ...]:
        """The joint's name on every tab; on the panel above it stands in the same place."""
        return tuple(_fit_text(self.name, tab) for tab in self.tabs)


def make_parts(
    document: Document, split: Sequence[Integers], kind: JointKind, width: float
) -> tuple[tuple[CutPart, ...], tuple[CutPart, ...], tuple[Joint, ...]]:
    """Parts, numbered from 1, strips (number 0), one for each joint, and joints.

    Tabs have this ``width``, strips twice as much, where panels leave room for it. Of two panels
    beside a crease the one with the lower number is on the part with the tab.
    """
    mesh = document.mesh
    number = np.zeros(len(mesh.faces), dtype=np.int64)
    for k, panels in enumerate(split, 1):
        number[panels] = k
    shapes = tab_shapes(document, width)
    beside = number[mesh.edge_faces]
    joints = _name_joints(document, number, shapes, kind)
    parts = []
    for k, panels in enumerate(split, 1):
        mine = [joint for joint in joints if k in joint.parts]
        rooted = [joint.edge for joint in mine if kind == "tabs" and joint.parts[0] == k]
        inside = np.flatnonzero(mesh.crease & (beside == k).all(axis=1))
        # On tabs, and on panels where others' tabs come; a strip has a half on either part.
        marks = tuple(mark for joint in mine for mark in joint.marks())
        if kind == "strips":
            marks = tuple(joint.marks()[0 if joint.parts[1] == k else 1] for joint in mine)
        marks += seam_names(document, number, panels)
        parts.append(
            CutPart(
                number=k,
                panels=np.sort(panels),
                creases=np.sort(np.concatenate([inside, np.array(rooted, dtype=np.int64)])),
                outlines=_outlines(document, panels, [j for j in mine if j.edge in set(rooted)]),
                marks=marks,
            )
        )
    strips = tuple(_strip(joint) for joint in joints) if kind == "strips" else ()
    return tuple(parts), strips, joints


def _name_joints(
    document: Document, number: Integers, shapes: Array, kind: JointKind
) -> tuple[Joint, ...]:
    mesh = document.mesh
    owner, other = find_owners(document)
    cut = np.flatnonzero(mesh.crease & (number[owner] != number[other]))
    pairs = np.sort(np.stack([number[owner[cut]], number[other[cut]]], axis=1), axis=1)
    order = np.lexsort((cut, pairs[:, 1], pairs[:, 0]))
    joints: list[Joint] = []
    counts: dict[tuple[int, int], int] = {}
    for k in order.tolist():
        edge = int(cut[k])
        pair = (int(pairs[k, 0]), int(pairs[k, 1]))
        counts[pair] = counts.get(pair, 0) + 1
        sides = mesh.edge_faces[edge].tolist()
        far, near = sides.index(other[edge]), sides.index(owner[edge])
        tabs = (shapes[edge, far],) + ((shapes[edge, near],) if kind == "strips" else ())
        parts = (int(number[owner[edge]]), int(number[other[edge]]))
        joints.append(Joint(f"{pair[0]}-{pair[1]}{letters(counts[pair])}", edge, parts, tabs))
    return tuple(joints)


def _strip(joint: Joint) -> CutPart:
    far, near = joint.tabs
    return CutPart(
        number=0,
        panels=np.empty(0, dtype=np.int64),
        creases=np.array([joint.edge]),
        outlines=(np.concatenate([far[1:], far[:1], near[2:]]),),
        marks=joint.marks(),
    )


def _outlines(document: Document, panels: Integers, rooted: Sequence[Joint]) -> tuple[Array, ...]:
    """The outlines of a part with its tabs; the part lies to the left of them.

    A tab's corners are a, b, far b, far a around the panel that it is glued to; the rim comes
    from b, goes around the tab, and on to a.
    """
    flat = document.require_flat()
    ends = {frozenset(document.mesh.edges[j.edge].tolist()): j.tabs[0][2:] for j in rooted}
    outlines = []
    for loop in find_outlines(document.mesh.loops[panels], flat):
        pieces = []
        for first, second in zip(loop.tolist(), np.roll(loop, -1).tolist(), strict=True):
            pieces.append(flat[first][None])
            far = ends.get(frozenset((first, second)))
            if far is not None:
                pieces.append(far)
        outlines.append(np.concatenate(pieces))
    return tuple(outlines)


def _fit_text(words: str, tab: Array) -> Text:
    """Words on a tab along its crease, never upside down, as large as they fit.

    They stand nearer to the crease than to the tab's far side, clear of the panel's label.
    """
    run, top = tab[1] - tab[0], tab[2] - tab[3]
    width = 0.5 * float(np.hypot(*run) + np.hypot(*top))
    depth = float((run[0] * (tab[3] - tab[0])[1] - run[1] * (tab[3] - tab[0])[0]) / np.hypot(*run))
    angle = float(np.arctan2(run[1], run[0]))
    if not -0.5 * np.pi < angle <= 0.5 * np.pi:
        angle -= np.copysign(np.pi, angle)
    middle = (1 - NAME_AT) * tab[:2].mean(axis=0) + NAME_AT * tab[2:].mean(axis=0)
    height = min(NAME_SHARE * depth, 0.85 * width / (LETTER_WIDTH * len(words)))
    return Text("ENGRAVE", float(middle[0]), float(middle[1]), height, words, angle)
