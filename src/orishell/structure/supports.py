"""What holds a shell: which of its vertices and nodes, and how."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array, Integers
from orishell.structure.footings import edge_nodes, patch_nodes
from orishell.structure.mesh.sheet import SheetMesh
from orishell.structure.settings import Support, SupportKind

RESTRAINED: dict[SupportKind, range] = {
    "pinned": range(3),
    "fixed": range(6),
    "sliding": range(2, 3),
    "friction": range(0),
}
"""Displacements 0 to 2 and rotations 3 to 5 that a support takes, whatever loads do."""


@record
class Supports:
    """What holds a shell."""

    restrained: Integers  # nodes (H, 2) that are restrained, and in which of 6 directions
    ground: Integers  # vertices (G,) that stand on the ground
    friction: Array  # its coefficient of friction (G,)
    at: Integers  # all supported vertices (S,), ascending
    points: Integers  # those that are held by themselves, without an edge or a patch
    lost: tuple[float, ...]  # patches in which no other node lies (length)
    share: float  # of the area of panels that is held in place as a whole
    ballast: Array  # mass at supported vertices (S,) that holds them; 0 where there is none (kg)
    rubs: Array  # coefficient of friction under it (S,); 0 where that is not known

    def vertices(self) -> Integers:
        """All supported vertices (S,), ascending."""
        return self.at

    def as_if_pinned(self) -> Integers:
        """Nodes (H, 2) and directions that are restrained, those on the ground in all three."""
        ground = np.stack([np.repeat(self.ground, 3), np.tile(range(3), len(self.ground))], axis=1)
        return np.unique(np.concatenate([self.restrained, ground]), axis=0)

    def dofs(self, mesh: SheetMesh) -> Integers:
        """Dofs (H,) of a mesh that are restrained: a rotation is, of all panels at a node."""
        node, axis = self.restrained.T
        straight = axis < 3
        dofs = [mesh.translations()[node[straight], axis[straight]]]
        for turn in range(3):
            there = np.isin(mesh.nodes, node[axis == 3 + turn])
            dofs.append(mesh.rotations()[there][:, turn])
        return np.unique(np.concatenate(dofs))


def find_supports(
    asked: Sequence[Support],
    mesh: SheetMesh,
    grid: Grid,
    inner: slice,
    feet: Integers | None,
    *,
    before: int,
) -> Supports:
    """What holds a shell.

    asked: What is to hold it.
    mesh: Its mesh.
    grid: The grid of the sheet between its flaps.
    inner: Its columns that meet the target.
    feet: Vertices (F,) that are its feet; None if it does not stand.
    before: Number of columns of folded flaps before the first column of the grid.
    Raises InputError: If vertices or edges that are to be held are not there, are held in two ways,
    or nothing is left to move.
    """
    restrained: list[Integers] = [np.zeros((0, 2), np.int64)]
    ground: list[Integers] = [np.zeros(0, np.int64)]
    friction: list[Array] = [np.zeros(0)]
    points: list[Integers] = [np.zeros(0, np.int64)]
    broad: list[Integers] = [np.zeros(0, np.int64)]
    lost: list[float] = []
    whole = np.zeros(len(mesh.facets.points), dtype=bool)
    ballast, rubs = np.zeros((2, grid.vertex_count))
    apart = _Ways(asked, before, grid.columns)
    for number, support in enumerate(asked):
        where = f"[structure] supports[{number}] at"
        if support.at == "feet":
            vertices = _feet(feet, where)
        elif support.at == "ends":
            vertices = grid.vertices()[:, [inner.start, inner.stop - 1]].ravel()
        else:
            vertices = np.array(
                [_vertex(grid, before, row, column, where) for row, column in support.at]
            )
        if support.kind == "friction":
            ground.append(vertices)
            friction.append(np.full(len(vertices), support.friction))
        elif support.ballast:
            ballast[vertices], rubs[vertices] = support.ballast, support.friction
        nodes = _nodes(support, mesh, grid, vertices, f"[structure] supports[{number}]")
        apart.add(number, vertices, nodes)
        if len(RESTRAINED[support.kind]) >= len("xyz"):
            whole[nodes] = True
        alone = len(nodes) == len(vertices)
        (points if alone else broad).append(vertices)
        if alone and support.patch:
            lost.append(support.patch)
        axes = np.array(RESTRAINED[support.kind], np.int64)
        restrained.append(np.stack(np.meshgrid(nodes, axes, indexing="ij"), axis=-1).reshape(-1, 2))
    areas = mesh.facets.areas()
    still = whole[mesh.facets.triangles].all(axis=1)
    if still.all():
        broad_ones = [support.patch for support in asked if support.patch]
        raise InputError(
            "nothing of the shell is left to move: all of it is held in place",
            where="[structure] supports",
            got=f"patch = {max(broad_ones):g}" if broad_ones else "all vertices",
            expected="supports that leave most of the shell free",
            remedy="lengths are in the design's unit: a base plate has some 0.1 m",
        )
    at = np.unique(np.concatenate([*points, *broad]))
    standing, first = np.unique(np.concatenate(ground), return_index=True)
    return Supports(
        restrained=np.unique(np.concatenate(restrained), axis=0),
        ground=standing,
        friction=np.concatenate(friction)[first],
        at=at,
        points=np.setdiff1d(np.concatenate(points), np.concatenate(broad)),
        lost=tuple(lost),
        share=float(areas[still].sum() / areas.sum()),
        ballast=ballast[at],
        rubs=rubs[at],
    )


class _Ways:
    """Which support holds what: nothing is held in two ways that contradict each other."""

    def __init__(self, asked: Sequence[Support], before: int, columns: int) -> None:
        self.asked, self.before, self.columns = asked, before, columns
        self.seen: list[tuple[int, Integers, Integers]] = []

    def add(self, number: int, vertices: Integers, nodes: Integers) -> None:
        """Note what a support holds.

        Raises InputError: If another support holds the same in another way. A vertex may be clamped
        by one that is pinned by another.
        """
        own = self.asked[number]
        for other, others, reached in self.seen:
            same = self.asked[other]
            holds = (same.friction, same.ballast) == (own.friction, own.ballast)
            if holds and (same.kind == own.kind or {same.kind, own.kind} == {"pinned", "fixed"}):
                continue
            both = np.intersect1d(vertices, others)
            if not len(both) and "friction" in {same.kind, own.kind}:
                both = np.intersect1d(nodes, reached)
            if len(both):
                raise InputError(
                    "one place is held in two ways that contradict each other",
                    where=f"[structure] supports[{number}]",
                    got=f"{_way(own)} at {self._place(int(both[0]))}, which supports[{other}] "
                    f"holds as {_way(same)}",
                    expected="each vertex in one way",
                    remedy="keep one of them there: name its vertices, [[row, column], ...], in at",
                )
        self.seen.append((number, vertices, nodes))

    def _place(self, node: int) -> str:
        row, column = divmod(node, self.columns)
        return f"vertex [{row}, {column + self.before}]"


def _way(support: Support) -> str:
    friction = f" {support.friction:g}" if support.friction else ""
    ballast = f" with ballast of {support.ballast:g} kg" if support.ballast else ""
    return f'"{support.kind}"{friction}{ballast}'


def _nodes(
    support: Support, mesh: SheetMesh, grid: Grid, vertices: Integers, where: str
) -> Integers:
    """What a support holds: the vertices, and along edges between them or near to them."""
    if support.edges:
        level = support.at == "feet"
        return edge_nodes(mesh, grid, vertices, f"{where} edges", level=level)
    if support.patch:
        return patch_nodes(mesh, vertices, support.patch)
    return vertices


def _feet(feet: Integers | None, where: str) -> Integers:
    if feet is None:
        raise InputError(
            "there are no feet to support",
            where=where,
            got='"feet"',
            expected="a shell that stands on the two ends of f",
            remedy='at = "ends", or name vertices, [[row, column], ...]',
        )
    return feet


def _vertex(grid: Grid, before: int, row: int, column: int, where: str) -> int:
    last = before + grid.columns - 1
    if not (row < grid.rows and before <= column <= last):
        raise InputError(
            "there is no such vertex to support",
            where=where,
            got=f"[{row}, {column}]",
            expected=f"a row from 0 to {grid.rows - 1}, a column from {before} to {last}",
        )
    return int(grid.vertices()[row, column - before])
