"""The sheet with what hangs on it as it moves, in FOLD: edges at which more than two panels meet.

Strips of box girders, and walls below a second skin, hang on lines across panels. There a panel is
two in FOLD, joined to one (assignment J), and the panel of the strip is the third at that edge.
Ends of these lines are vertices on the sides of all panels there. Where lines of two girders cross
on a panel there is one more vertex, and the panel is parted along both.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from orishell.conventions.record import record
from orishell.design.hung import HungLines
from orishell.document import Document, Part
from orishell.io.line_crossings import Crossings, Lines, Side, parted, side_of, sides_of
from orishell.numerics.arrays import Array, Integers

TOGETHER = 1e-9
"""Ends of lines that are nearer to each other than this share of an edge are one."""
NOWHERE = -1


@record
class HungSheet:
    """A sheet and the parts that hang on it, as one mesh."""

    document: Document
    parts: tuple[Part, ...]  # those that hang on it, or on one another
    crossings: Crossings  # where lines on its panels cross: vertices behind all of its parts
    kept: Integers  # which of all vertices (N,), the sheet's and then every part's, are its own
    faces: tuple[list[int], ...]  # vertices around its panels, those of the sheet first
    # letter of every edge, and the number of its fold angle among those of sheet and parts
    edges: Mapping[Side, tuple[str, int]]

    @property
    def called(self) -> str:
        """What hangs on it, in words."""
        kinds = [part.kind for part in self.parts]
        each = (kind + "s" * (kinds.count(kind) > 1) for kind in dict.fromkeys(kinds))
        return " and ".join(each)

    def mesh(self) -> dict[str, Any]:
        """Keys of a frame that are the same in all of them."""
        return {
            "edges_vertices": list(self.edges),
            "edges_assignment": [letter for letter, _ in self.edges.values()],
            "faces_vertices": self.faces,
        }

    def state(self, number: int) -> dict[str, Any]:
        """Keys of a frame that are those of a state of the sheet."""
        states = [each.states[number] for each in (self.document, *self.parts)]
        points = np.concatenate([each.positions for each in states])
        points = np.concatenate([points, self.crossings.places(points)])[self.kept]
        found: dict[str, Any] = {"vertices_coords": self.document.in_world(points)}
        angles = [each.fold_angles_deg for each in states if each.fold_angles_deg is not None]
        if len(angles) < len(states):
            return found
        every = np.append(np.concatenate(angles), np.nan)
        return {**found, "edges_foldAngle": every[[place for _, place in self.edges.values()]]}

    def is_there(self, number: int) -> bool:
        """Whether all parts hang on the sheet in a state."""
        state = self.document.states[number]
        return all(part.is_joined_in(state) for part in self.parts)


def hung_sheet(document: Document) -> HungSheet | None:
    """The sheet of a document with what hangs on it as it moves; None if nothing does."""
    parts = tuple(part for part in document.moving[1:] if hangs(part))
    if not parts:
        return None
    every: tuple[Part, ...] = (document.sheet, *parts)
    firsts = np.cumsum([0, *(each.mesh.vertex_count for each in every)]).tolist()
    flats = [each.flat for each in every if each.flat is not None]
    if len(flats) < len(every):  # panels are as large in any state
        flats = [each.shell.positions for each in every]
    flat = np.concatenate(flats)
    panels = np.concatenate([f + each.mesh.faces for f, each in zip(firsts, every, strict=False)])
    lines = [*_lines(every, firsts, flat)]
    number, points = _ends_on_edges(panels, lines, flat)
    crossings = Crossings.of(lines, flat)
    cuts: dict[int, list[list[int]]] = defaultdict(list)
    for k, (panel, ends) in enumerate(lines):
        one, other = number[list(ends)].tolist()
        cuts[panel] += crossings.chains(k, (one, other))
        if along := crossings.along(k):
            points[side_of(one, other)] = along if one < other else along[::-1]
    loops = [
        number[np.add(loop, first)].tolist()
        for each, first in zip(every, firsts, strict=False)
        for loop in each.mesh.around()
    ]
    faces = [
        piece
        for panel, loop in enumerate(loops)
        for piece in parted(_with_points(loop, points), cuts[panel])
    ]
    times = Counter(side for piece in faces for side in sides_of(piece))
    lengths = (side_of(*pair) for mine in cuts.values() for cut in mine for pair in pairwise(cut))
    joined = {each for each in lengths if times[each] > 1}
    edges: dict[Side, tuple[str, int]] = dict.fromkeys(sorted(joined), ("J", NOWHERE))
    before = 0
    for each, first in zip(every, firsts, strict=False):
        for k, (one, other) in enumerate(number[each.mesh.edges + first].tolist()):
            for side in pairwise([one, *_between(one, other, points), other]):
                edges.setdefault(side_of(*side), (each.assignment[k], before + k))
        before += len(each.mesh.edges)
    kept, places = np.unique(np.concatenate([*map(np.array, faces)]), return_inverse=True)
    new = dict(zip(np.concatenate(faces).tolist(), places.tolist(), strict=True))
    return HungSheet(
        document,
        parts,
        crossings,
        kept,
        tuple([new[vertex] for vertex in face] for face in faces),
        {(new[one], new[other]): told for (one, other), told in edges.items()},
    )


def hangs(part: Part) -> bool:
    """Whether a part hangs on others as the sheet moves, or bears some that do."""
    return part.hung is not None or part.bears is not None


def _lines(
    parts: Sequence[Part], firsts: Sequence[int], places: Array
) -> Iterator[tuple[int, Side]]:
    """Every panel that a panel of a part hangs on, and the vertices of that line.

    Panels and vertices are numbered through all parts, the sheet first.
    firsts: The number of the first vertex of each part.
    places: All vertices, flat (N, 2) or in a state (N, 3).
    """
    panels = np.cumsum([0, *(len(each.mesh.faces) for each in parts)]).tolist()
    for part, first in zip(parts, firsts, strict=False):
        if part.hung is None:
            continue
        hung = [(0, part.hung)]
        hung += [
            (k, on.bears.of(part.hung.names[0]))
            for k, on in enumerate(parts)
            if on.bears is not None
        ]
        for k, lines in hung:
            spots = _spots(parts[k], lines, places[firsts[k] :])
            for panel, ends, corners in zip(lines.panels, spots, part.mesh.faces, strict=True):
                away = np.linalg.norm(places[first + corners][:, None] - ends, axis=-1)
                one, other = corners[away.argmin(axis=0)].tolist()
                yield panels[k] + int(panel), (first + one, first + other)


def _spots(part: Part, lines: HungLines, places: Array) -> Array:
    """Ends (L, 2, d) of lines on panels of a part, by places (N, d) of its vertices.

    They lie on edges of columns, at the same share of these as on the panels that are cut.
    """
    cut = part.as_cut()
    lying = cut.require_flat()[cut.mesh.faces[lines.panels]]
    upper, lower = lying[:, [0, 3]], lying[:, [1, 2]]
    share = np.linalg.norm(lines.ends - upper, axis=-1) / np.linalg.norm(lower - upper, axis=-1)
    corners = places[part.mesh.faces[lines.panels]]
    upper, lower = corners[:, [0, 3]], corners[:, [1, 2]]
    return np.asarray(upper + share[..., None] * (lower - upper))


def _ends_on_edges(
    panels: Integers, lines: Lines, flat: Array
) -> tuple[Integers, dict[Side, list[int]]]:
    """Numbers (N,) of vertices, those of ends at one place alike, and those on edges of panels.

    On an edge they are in their order, from the vertex of the lower number on.
    panels: Corners (F, 4) of all panels.
    flat: All vertices, flat (N, 2) or in a state (N, 3).
    """
    found: dict[Side, dict[int, float]] = defaultdict(dict)
    for panel, ends in lines:
        sides = [side_of(*each) for each in sides_of(panels[panel].tolist())]
        begin, run = flat[[low for low, _ in sides]], flat[[high for _, high in sides]]
        run = run - begin
        for vertex in ends:
            share = ((flat[vertex] - begin) * run).sum(axis=1) / (run**2).sum(axis=1)
            away = np.linalg.norm(begin + share[:, None] * run - flat[vertex], axis=1)
            nearest = int(np.where((share > 0) & (share < 1), away, np.inf).argmin())
            found[sides[nearest]][vertex] = float(share[nearest])
    number, points = np.arange(len(flat)), {}
    for side, shares in found.items():
        order = sorted(shares, key=lambda vertex: (shares[vertex], vertex))
        for one, other in pairwise(order):
            if shares[other] - shares[one] < TOGETHER:
                number[other] = number[one]
        points[side] = list(dict.fromkeys(number[order].tolist()))
    return number, points


def _between(one: int, other: int, points: Mapping[Side, list[int]]) -> list[int]:
    """The vertices on an edge from a vertex to another."""
    found = points.get(side_of(one, other), [])
    return found if one < other else found[::-1]


def _with_points(loop: list[int], points: Mapping[Side, list[int]]) -> list[int]:
    """The vertices around a panel, those on its sides too."""
    return [
        vertex
        for one, other in pairwise([*loop, loop[0]])
        for vertex in (one, *_between(one, other, points))
    ]
