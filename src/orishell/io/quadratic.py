"""A loaded shell in quadratic shell elements: quadrilaterals, and triangles at corners of gussets.

Gussets, and panels where creases turn, have nodes of their own. Where they are hinged to each other
these are at one place, and are to have their displacements in common, but not their rotations.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.document.loaded import LoadedGussets, LoadedShell
from orishell.numerics.arrays import Array, Booleans, Integers


@record
class ShellSection:
    """What elements are made of: a plate as stiff in its plane and in bending."""

    name: str  # "SECTION1", "GUSSET_5_3": letters, digits and underscores
    thickness: float  # sqrt(12 bending/membrane) (length)
    modulus: float  # Young's, (1 - nu^2) membrane/thickness (force per area)
    poisson: float  # Poisson's ratio
    density: float  # mass per volume (kg per cube of the unit)
    elements: Integers  # which elements have it: quadrilaterals, then triangles


@record
class QuadraticMesh:
    """A shell in quadratic elements: those of panels first, then those of gussets."""

    # nodes (N, 3): those of the shell, of gussets, of panels at one place, then middles of sides
    points: Array
    own: int  # how many are the shell's
    quads: Integers  # nodes (C, 8): corners, then the middles of the sides after them
    triangles: Integers  # nodes (K, 6), likewise
    panels: int  # how many quadrilaterals are panels'
    together: Integers  # pairs (P, 2) of nodes at one place: the first there, and another
    sections: tuple[ShellSection, ...]  # those of panels, then one for every gusset

    def of_panels(self, nodes: Integers) -> list[Integers]:
        """All nodes of panels at each of some nodes (m,) of the shell."""
        pairs = self.together[np.isin(self.together[:, 1], self.quads[: self.panels])]
        return [np.r_[node, pairs[pairs[:, 0] == node, 1]] for node in nodes.tolist()]


def quadratic_mesh(shell: LoadedShell, *, hinged: bool) -> QuadraticMesh:
    """The shell in quadratic elements.

    hinged: Whether creases turn: panels have nodes of their own then.
    """
    corners = _around(shell.triangles[::2], shell.triangles[1::2])
    part = shell.panels[::2] if hinged else np.zeros(len(corners), np.int64)
    points, quads, triangles = shell.points, [corners], np.zeros((0, 3), np.int64)
    parts, outer = [part], np.zeros(0, np.int64)
    gussets = shell.gussets
    if gussets is not None:
        whole, triangles = _cells(gussets)
        number = int(part.max()) + 1 + np.arange(len(gussets.at))
        quads.append(whole.reshape(-1, 4))
        parts.append(np.repeat(number, whole.shape[1]))
        outer = np.repeat(number, triangles.shape[1])
        triangles = triangles.reshape(-1, 3)
    four, part = np.concatenate(quads), np.concatenate(parts)
    nodes = np.concatenate([four.ravel(), triangles.ravel()])
    owners = np.concatenate([np.repeat(part, 4), np.repeat(outer, 3)])
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
        own=len(shell.points),
        quads=np.column_stack([corners, middles[: corners.size].reshape(-1, 4)]),
        triangles=np.column_stack([ends, middles[corners.size :].reshape(-1, 3)]),
        panels=len(quads[0]),
        together=np.concatenate(together),
        sections=(*_of_panels(shell), *_of_gussets(shell, part, outer)),
    )


def _cells(gussets: LoadedGussets) -> tuple[Integers, Integers]:
    """Corners of gussets' cells (G, n^2 - 1, 4), and of two triangles (G, 2, 3) for the last.

    That is at the middle of the outer side, where two of its sides are in one line.
    """
    node = gussets.nodes
    around = (node[:, :-1, :-1], node[:, 1:, :-1], node[:, 1:, 1:], node[:, :-1, 1:])
    cells = np.stack([each.reshape(len(node), -1) for each in around], axis=-1)
    return cells[:, :-1], cells[:, -1][:, [[0, 1, 2], [0, 2, 3]]]


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


def _of_panels(shell: LoadedShell) -> list[ShellSection]:
    """Every section of panels once; a cell has the mean of its two triangles."""
    values = np.column_stack(
        [
            each.reshape(-1, 2).mean(axis=1)
            for each in (shell.membrane, shell.bending, shell.areal_mass)
        ]
    )
    found, which = np.unique(_plates(values, shell.poisson), axis=0, return_inverse=True)
    return [
        _section(f"SECTION{number + 1}", each, shell.poisson, which.ravel() == number)
        for number, each in enumerate(found.tolist())
    ]


def _of_gussets(shell: LoadedShell, part: Integers, outer: Integers) -> list[ShellSection]:
    """One for every gusset: they are as stiff as each other, and their boards not as heavy.

    part, outer: Which part of the shell each quadrilateral is of (C,), and each triangle (K,).
    """
    gussets = shell.gussets
    if gussets is None:
        return []
    stiffness = np.tile([gussets.membrane, gussets.bending], (len(gussets.at), 1))
    values = _plates(np.column_stack([stiffness, gussets.areal_mass]), gussets.poisson)
    every = np.concatenate([part, outer])
    first = int(outer.min())
    return [
        _section(f"GUSSET_{row}_{column}", each, gussets.poisson, every == first + number)
        for number, ((row, column), each) in enumerate(
            zip(gussets.at.tolist(), values.tolist(), strict=True)
        )
    ]


def _section(name: str, values: list[float], poisson: float, there: Booleans) -> ShellSection:
    thickness, modulus, density = values
    return ShellSection(name, thickness, modulus, poisson, density, np.flatnonzero(there))


def _plates(values: Array, poisson: float) -> Array:
    """Thickness, modulus and density (S, 3) by membrane and bending stiffness and areal mass."""
    membrane, bending, mass = values.T
    thickness = np.sqrt(12 * bending / membrane)
    modulus = (1 - poisson**2) * membrane / thickness
    return np.column_stack([thickness, modulus, mass / thickness])
