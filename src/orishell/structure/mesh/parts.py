"""What stiffens a meshed sheet: meshes of their own whose nodes are the sheet's where they meet it.

A part shares the translations of nodes; its rotations are its own, so that it is hinged there, as
panels are at creases. Nodes that only it has come behind those of the sheet, and its rotations
behind all others.
"""

from __future__ import annotations

from dataclasses import field, replace

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.structure.mesh.elements import Elements
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.sheet import SheetMesh
from orishell.structure.mesh.triangle import Facets


def _none() -> Integers:
    return np.zeros(0, np.int64)


@record
class MeshedPart:
    """Plates that are made alike, or a strip of a sleeve, meshed beside the sheet."""

    own: SheetMesh  # a mesh of its own, all of its plates or panels
    nodes: Integers  # nodes (M',) of the whole where its own are
    beside: Integers  # the triangle (T',) of a panel of the sheet that each of its own is beside
    # middles of its triangles (F, t, 2), as shares of the way down and across; None of plates
    middles: Array | None = None
    # nodes of its own mesh where a corner of a plate is a straight angle
    straight: Integers = field(default_factory=_none)


@record
class Plates:
    """A meshed part, and where it is joined to the sheet."""

    own: SheetMesh  # a mesh of its own, every plate a panel of it
    nodes: Integers  # nodes (M',) of the whole where its own are
    dofs: Integers  # dofs (D',) in the whole, of those of its own mesh
    beside: Integers  # the triangle (T',) of a panel that each of its triangles is beside
    first: int = 0  # how many rotations of others are before its own, behind those of panels
    # which nodes of its own mesh (M',) others have as well
    shared: Booleans = field(default_factory=lambda: np.zeros(0, np.bool_))
    # nodes of its own mesh where a corner of a plate is a straight angle
    straight: Integers = field(default_factory=_none)

    @property
    def triangles(self) -> Integers:
        """Nodes (T', 3) of the whole at the corners of its triangles."""
        return np.asarray(self.nodes[self.own.facets.triangles])

    @property
    def turns(self) -> Integers:
        """Dofs (R, 3) of its rotations in the whole."""
        return np.asarray(self.dofs[3 * self.own.node_count :].reshape(-1, 3))

    def elements(self, section: Section, count: int) -> Elements:
        """Its triangles as elements; ``count`` is the number of all dofs."""
        found = self.own.elements(section)
        return replace(found, dofs=self.dofs[found.dofs], count=count, beside=self.beside)

    def places(self, moved: Array) -> Array:
        """Where nodes of its own mesh (M', 3) are, by displacements of all dofs (D,)."""
        straight = self.dofs[: 3 * self.own.node_count].reshape(-1, 3)
        return np.asarray(self.own.facets.points + moved[straight])

    def corners_moved(self, moved: Array) -> Array:
        """Displacements and rotations (T', 18) of triangles' corners, by those of all dofs (D,)."""
        return self.own.corners_moved(moved[self.dofs])


def number_nodes(nodes: Integers, first: int) -> int:
    """Number nodes (M',) that have no number yet; returns the next one."""
    new = np.flatnonzero(nodes < 0)
    nodes[new] = first + np.arange(len(new))
    return first + len(new)


def join_parts(
    sheet: SheetMesh, parts: tuple[MeshedPart, ...]
) -> tuple[SheetMesh, tuple[Plates, ...]]:
    """The mesh of a sheet with the nodes of other parts behind its own, and these in it."""
    every = [sheet.facets.points]
    numbers = [np.arange(sheet.node_count)]
    every += [each.own.facets.points for each in parts]
    numbers += [each.nodes for each in parts]
    number, place = np.concatenate(numbers), np.concatenate(every)
    _, first, many = np.unique(number, return_index=True, return_counts=True)
    turns = np.array([each.own.nodes.size for each in parts])
    whole = replace(
        sheet,
        facets=Facets(place[first], sheet.facets.triangles),
        turns=int(turns.sum()),
    )
    begin = whole.count - 3 * int(turns.sum())
    plates = []
    for each, behind in zip(parts, np.cumsum(turns) - turns, strict=True):
        straight = 3 * each.nodes[:, None] + np.arange(3)
        own = begin + 3 * behind + np.arange(3 * each.own.nodes.size)
        plates.append(
            Plates(
                own=each.own,
                nodes=each.nodes,
                dofs=np.concatenate([straight.ravel(), own]),
                beside=each.beside,
                first=int(behind),
                straight=each.straight,
                shared=many[each.nodes] > 1,
            )
        )
    return whole, tuple(plates)
