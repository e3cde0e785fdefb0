"""A loaded shell in quadratic shell elements: quadrilaterals, and triangles at corners of gussets.

What stiffens the sheet, and panels where creases turn, have nodes of their own. Where they are
hinged to each other these are at one place, and are to have their displacements in common, but not
their rotations.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np

from orishell.conventions.record import record
from orishell.document.loaded import LoadedParts, LoadedShell
from orishell.numerics.arrays import Array, Booleans, Integers

STRAIGHT = 1e-6
"""A corner of a cell is a straight angle if the triangle there has less of its area."""


@record
class ShellSection:
    """What elements are made of: a plate as stiff in its plane and in bending."""

    name: str  # "SECTION1", "GUSSET_5_3", "BOX_4_UPPER_3": letters, digits and underscores
    thickness: float  # sqrt(12 bending/membrane) (length)
    modulus: float  # Young's, (1 - nu^2) membrane/thickness (force per area)
    poisson: float  # Poisson's ratio
    density: float  # mass per volume (kg per cube of the unit)
    elements: Integers  # which elements have it: quadrilaterals, then triangles


@record
class QuadraticMesh:
    """A shell in quadratic elements: those of panels first, then those of what stiffens it."""

    # nodes (N, 3): those of the shell, again those of panels at one place, then middles of sides
    points: Array
    own: int  # how many are the shell's
    quads: Integers  # nodes (C, 8): corners, then the middles of the sides after them
    triangles: Integers  # nodes (K, 6), likewise
    panels: int  # how many quadrilaterals are panels'
    together: Integers  # pairs (P, 2) of nodes at one place: the first there, and another
    sections: tuple[ShellSection, ...]  # those of panels, then of every part that stiffens it

    def of_panels(self, nodes: Integers) -> list[Integers]:
        """All nodes of panels at each of some nodes (m,) of the shell."""
        pairs = self.together[np.isin(self.together[:, 1], self.quads[: self.panels])]
        return [np.r_[node, pairs[pairs[:, 0] == node, 1]] for node in nodes.tolist()]


@record
class _Cells:
    """All cells of a shell as elements: those of panels, of parts, and halves of some of these."""

    quads: Integers  # corners (C, 4)
    triangles: Integers  # corners (K, 3): both halves of cells two of whose sides are in one line
    cells: Integers  # which cell of panels and then of parts each element is of (C + K,)
    panels: int  # how many cells are panels'

    @classmethod
    def of(cls, shell: LoadedShell) -> _Cells:
        """Those of a shell."""
        corners = _around(shell.triangles[::2], shell.triangles[1::2])
        count = len(corners)
        if shell.parts is None:
            return cls(corners, np.zeros((0, 3), np.int64), np.arange(count), count)
        pairs = shell.parts.triangles.reshape(-1, 2, 3)
        cells = _around(pairs[:, 0], pairs[:, 1])
        split = _with_straight_corner(shell.points[cells])
        whole, halved = count + np.flatnonzero(~split), count + np.flatnonzero(split)
        return cls(
            np.concatenate([corners, cells[~split]]),
            pairs[split].reshape(-1, 3),
            np.concatenate([np.arange(count), whole, np.repeat(halved, 2)]),
            count,
        )


def quadratic_mesh(shell: LoadedShell, *, hinged: bool) -> QuadraticMesh:
    """The shell in quadratic elements.

    hinged: Whether creases turn: panels have nodes of their own then.
    """
    cells, points = _Cells.of(shell), shell.points
    part = shell.all_panels[::2]
    if not hinged:
        part = np.where(np.arange(len(part)) < cells.panels, 0, part)
    four, part = cells.quads, part[cells.cells]
    nodes = np.concatenate([four.ravel(), cells.triangles.ravel()])
    owners = np.concatenate([np.repeat(part[: len(four)], 4), np.repeat(part[len(four) :], 3)])
    own, again = _numbered(nodes, owners, len(points))
    place = np.concatenate([np.arange(len(points)), again])
    together = [np.column_stack([again, len(points) + np.arange(len(again))])]

    corners, ends = own[: four.size].reshape(-1, 4), own[four.size :].reshape(-1, 3)
    sides = np.concatenate([_sides(corners).reshape(-1, 2), _sides(ends).reshape(-1, 2)])
    sides, middle = np.unique(sides, axis=0, return_inverse=True)
    middles = len(place) + middle.ravel()
    _, first, which = np.unique(
        np.sort(place[sides], axis=1), axis=0, return_index=True, return_inverse=True
    )
    pairs = np.column_stack([first[which.ravel()], np.arange(len(sides))])
    together.append(len(place) + pairs[pairs[:, 0] != pairs[:, 1]])
    return QuadraticMesh(
        points=np.concatenate([points[place], points[place[sides]].mean(axis=1)]),
        own=len(points),
        quads=np.column_stack([corners, middles[: corners.size].reshape(-1, 4)]),
        triangles=np.column_stack([ends, middles[corners.size :].reshape(-1, 3)]),
        panels=cells.panels,
        together=np.concatenate(together),
        sections=tuple(_sections(shell, cells)),
    )


def _with_straight_corner(corners: Array) -> Booleans:
    """Whether cells (C, 4, 3) have two sides in one line, as that at the outer side of a gusset."""
    sides = np.roll(corners, -1, axis=1) - corners
    there = np.linalg.norm(np.cross(np.roll(sides, 1, axis=1), sides), axis=2)
    return np.asarray(there.min(axis=1) < STRAIGHT * there.sum(axis=1))


def _numbered(nodes: Integers, parts: Integers, count: int) -> tuple[Integers, Integers]:
    """Numbers (m,) of nodes (m,), others for every part but the first there, and which these are.

    count: How many nodes there are; further ones have the numbers behind.
    """
    pairs, which = np.unique(np.column_stack([nodes, parts]), axis=0, return_inverse=True)
    more = np.append(False, pairs[1:, 0] == pairs[:-1, 0])
    number = np.where(more, count + np.cumsum(more) - 1, pairs[:, 0])
    return number[which.ravel()], pairs[more, 0]


def _sides(corners: Integers) -> Integers:
    """Ends (m, k, 2) of the sides of elements (m, k), the lower number first."""
    return np.sort(np.stack([corners, np.roll(corners, -1, axis=1)], axis=-1), axis=-1)


def _around(first: Integers, second: Integers) -> Integers:
    """Corners (C, 4) around pairs of triangles (C, 3) that share a side."""
    row = np.arange(len(first))
    alone, other = (
        np.argmin((mine[:, :, None] == theirs[:, None]).any(axis=2), axis=1)
        for mine, theirs in ((first, second), (second, first))
    )
    begin, then, last = (first[row, (alone + k) % 3] for k in range(3))
    return np.column_stack([begin, then, second[row, other], last])


def _sections(shell: LoadedShell, cells: _Cells) -> Iterator[ShellSection]:
    """Every section of panels once, and those of each part that stiffens them, called after it."""
    found, which = _plates(shell)
    for number, values in enumerate(found):
        there = cells.cells < cells.panels
        there[there] = (which == number)[cells.cells[there]]
        yield _section(f"SECTION{number + 1}", values, shell.poisson, there)
    parts = shell.parts
    if parts is None:
        return
    found, which = _plates(parts)
    of = cells.cells - cells.panels
    for name, own in parts.numbers.items():
        mine = parts.panels[::2] == own
        several = np.unique(which[mine])
        for k, number in enumerate(several.tolist()):
            called = re.sub(r"\W", "_", name).upper() + f"_{k + 1}" * (len(several) > 1)
            there = of >= 0
            there[there] = (mine & (which == number))[of[there]]
            yield _section(called, found[number], parts.poisson, there)


def _section(name: str, values: list[float], poisson: float, there: Booleans) -> ShellSection:
    thickness, modulus, density = values
    return ShellSection(name, thickness, modulus, poisson, density, np.flatnonzero(there))


def _plates(made: LoadedShell | LoadedParts) -> tuple[list[list[float]], Integers]:
    """Thickness, modulus and density of each kind of cell, and of which each is (C,).

    A cell has the mean of its two triangles.
    """
    membrane, bending, mass = (
        each.reshape(-1, 2).mean(axis=1) for each in (made.membrane, made.bending, made.areal_mass)
    )
    thickness = np.sqrt(12 * bending / membrane)
    modulus = (1 - made.poisson**2) * membrane / thickness
    values = np.column_stack([thickness, modulus, mass / thickness])
    found, which = np.unique(values, axis=0, return_inverse=True)
    return found.tolist(), which.ravel()
