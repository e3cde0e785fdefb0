"""Panels with gussets, all creases free, as this program has them and as CalculiX does.

In CalculiX all panels and gussets are plates of their own (S8R), whose nodes have translations in
common where they are at one place.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.sparse.linalg import eigsh, splu

from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.geometric import geometric_stiffness
from orishell.structure.mesh.parts import Plates, join_parts
from orishell.structure.mesh.plates import mesh_plates
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.sheet import SheetMesh, mesh_sheet
from orishell.structure.mesh.stops import Stops, plate_line
from orishell.structure.mesh.stresses import facet_stresses
from orishell.structure.plates import turned_plates

MODULUS, THICKNESS, THIN, POISSON = 8e9, 0.01, 0.004, 0.3


@dataclass(frozen=True)
class Case:
    """A folded sheet with gussets, how it is held and what loads it."""

    positions: Array  # vertices (rows, columns, 3)
    at: Integers  # rows and columns (G, 2) of the vertices that gussets go from
    share: float  # of edges
    held: Mapping[int, tuple[int, ...]]  # of vertices so many displacements
    loads: Mapping[int, tuple[float, float, float]]  # forces at vertices (N)

    def holds(self, points: Array) -> dict[int, tuple[int, ...]]:
        """Of points (N, 3) so many displacements."""
        found: dict[int, tuple[int, ...]] = {}
        for vertex, axes in self.held.items():
            apart = np.linalg.norm(points - self.positions.reshape(-1, 3)[vertex], axis=1)
            found[int(np.argmin(apart))] = axes
        return found

    @property
    def grid(self) -> Grid:
        rows, columns, _ = self.positions.shape
        return Grid(rows, columns)


def four_panels() -> Case:
    """Held as a rigid body is, at three corners; loaded at a fourth, and in the middle."""
    up, down, left, right = np.array(
        [[0.1, 0.8, 0.5], [0.15, -0.7, 0.6], [-1.0, 0.0, 0.1], [0.9, 0.15, 0.2]]
    )
    none = np.zeros(3)
    rows = [[up + left, up, up + right], [left, none, right], [down + left, down, down + right]]
    held: dict[int, tuple[int, ...]] = {6: (0, 1, 2), 8: (1, 2), 0: (2,)}
    loads = {2: (0.0, 0.0, -100.0), 4: (0.0, 30.0, -200.0)}
    return Case(np.array(rows), np.array([[1, 1]]), 0.8, held, loads)


@dataclass(frozen=True)
class Cell:
    """Panels and their gussets, meshed."""

    case: Case
    sheet: SheetMesh
    plates: Plates
    section: Section
    plate: Section

    @classmethod
    def of(cls, cells: int, case: Case) -> Cell:
        stops = Stops.of_plates(case.grid, case.at[:, 0].tolist(), case.share)
        sheet = mesh_sheet(case.positions, case.grid, cells, stops=stops)
        part = mesh_plates(sheet, case.grid, case.at, plate_line(case.share, cells))
        whole, (plates,) = join_parts(sheet, (part,))
        sections = (Section.solid(MODULUS, each, POISSON) for each in (THICKNESS, THIN))
        return cls(case, whole, plates, *sections)

    def held(self) -> list[int]:
        """Dofs of vertices that are held."""
        found = self.case.holds(self.sheet.facets.points)
        return [3 * node + axis for node, axes in found.items() for axis in axes]

    @property
    def seen(self) -> Array:
        """Loaded vertices, where displacements are compared."""
        return self.case.positions.reshape(-1, 3)[list(self.case.loads)]

    def solved(self) -> tuple[Array, float]:
        """Displacements and rotations (D,) and the lowest factor by which it buckles."""
        count = self.sheet.count
        stiffness = self.sheet.elements(self.section).assembled()
        stiffness = stiffness + self.plates.elements(self.plate, count).assembled()
        free = np.setdiff1d(np.arange(count), self.held())
        loads, moved = np.zeros((2, count))
        for node, force in self.case.loads.items():
            loads[3 * node : 3 * node + 3] = force
        inner = stiffness[free][:, free].tocsc()
        moved[free] = splu(inner).solve(loads[free])
        panels = facet_stresses(self.sheet.facets, self.section, self.sheet.corners_moved(moved))
        gusset = facet_stresses(
            self.plates.own.facets, self.plate, self.plates.corners_moved(moved)
        )
        at_points = np.array([*self.case.held, *self.case.loads], np.int64)
        turned = geometric_stiffness(
            self.sheet, panels.forces, at_points, free, turned_plates(self.plates, gusset, count)
        )
        matrix = turned.times(np.eye(len(free)))
        shares = eigsh(-matrix, k=1, M=inner, which="LA", return_eigenvectors=False)
        return moved, float(1 / shares[0])

    def displaced(self, moved: Array) -> Array:
        """Displacements (L, 3) of the places that are looked at."""
        points = self.sheet.facets.points
        nodes = [int(np.argmin(np.linalg.norm(points - each, axis=1))) for each in self.seen]
        return np.asarray(moved[: 3 * self.sheet.node_count].reshape(-1, 3)[nodes])

    def deck(self, path: Path) -> None:
        """Plates for CalculiX: nodes at one place have one that the others follow."""
        parts = [(self.sheet.facets.points, each) for each in self.sheet.nodes]
        parts += [(self.plates.own.facets.points, each) for each in self.plates.own.nodes]
        places: list[Array] = []
        cells: list[Integers] = []
        begin = 0
        for points, nodes in parts:
            at, own = _quadratic(points[nodes])
            places.append(at)
            cells.append(own + begin)
            begin += len(at)
        others, gussets = cells[: len(self.sheet.nodes)], cells[len(self.sheet.nodes) :]
        # At the middle of its outer side the last cell of a gusset has one line for two sides.
        triangles: list[list[int]] = []
        for gusset in gussets:
            a, b, c, d, ab, bc, cd, da = gusset[-1].tolist()
            ends = np.concatenate(places)[[a, c]]
            places.append(ends.mean(axis=0)[None])
            triangles += [[a, b, c, ab, bc, begin], [a, c, d, begin, cd, da]]
            begin += 1
        every = np.concatenate(places)
        first, which = _alike(every)
        lines = ["*NODE,NSET=ALL"]
        lines += [f"{k},{x:.13g},{y:.13g},{z:.13g}" for k, (x, y, z) in enumerate(every, 1)]
        lines += _elements("S8R", "PANELS", np.concatenate(others), 0)
        count = sum(map(len, others))
        whole = np.concatenate([gusset[:-1] for gusset in gussets])
        lines += _elements("S8R", "GUSSET", whole, count)
        lines += _elements("S6", "GUSSET", np.array(triangles), count + len(whole))
        lines += ["*MATERIAL,NAME=BOARD", "*ELASTIC", f"{MODULUS},{POISSON}"]
        for name, thickness in (("PANELS", THICKNESS), ("GUSSET", THIN)):
            lines += [f"*SHELL SECTION,ELSET={name},MATERIAL=BOARD", f"{thickness}"]
        for node in np.flatnonzero(first[which] != np.arange(len(every))):
            for axis in (1, 2, 3):
                lines += [
                    "*EQUATION",
                    "2",
                    f"{node + 1},{axis},1.,{first[which[node]] + 1},{axis},-1.",
                ]
        nodes = first + 1
        places_of = every[first]

        def nearest(place: Array) -> int:
            return int(nodes[np.argmin(np.linalg.norm(places_of - place, axis=1))])

        corner = self.case.positions.reshape(-1, 3)
        lines += ["*NSET,NSET=SHELL", *(str(nearest(each)) for each in self.seen)]
        lines += ["*BOUNDARY"]
        for held, axes in self.case.holds(places_of).items():
            lines += [f"{nodes[held]},{axis + 1},{axis + 1}" for axis in axes]
        forces = [
            f"{nearest(corner[n])},{axis + 1},{each}"
            for n, force in self.case.loads.items()
            for axis, each in enumerate(force)
            if each
        ]
        printed = ["*NODE PRINT,NSET=SHELL", "U", "*END STEP"]
        lines += ["*STEP", "*STATIC", "*CLOAD", *forces, *printed]
        lines += ["*STEP", "*BUCKLE", "3,1e-4,40,1000", "*CLOAD", *forces, *printed]
        path.write_text("\n".join(lines) + "\n")


def _quadratic(points: Array) -> tuple[Array, Integers]:
    """Nodes (N, 3) and cells (C, 8) of a plate with nodes (n, n, 3): middles of sides added."""
    size = len(points)
    number = np.arange(size * size).reshape(size, size)
    around = (number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:])
    corners = np.stack([each.ravel() for each in around], axis=1)
    sides = np.sort(np.stack([corners, np.roll(corners, -1, axis=1)], axis=-1), axis=-1)
    ends, middle = np.unique(sides.reshape(-1, 2), axis=0, return_inverse=True)
    flat = points.reshape(-1, 3)
    every = np.concatenate([flat, flat[ends].mean(axis=1)])
    return every, np.column_stack([corners, len(flat) + middle.reshape(-1, 4)])


def _elements(kind: str, name: str, nodes: Integers, after: int) -> list[str]:
    """Lines of elements of a kind, numbered after so many others."""
    numbered = enumerate((nodes + 1).tolist(), after + 1)
    return [
        f"*ELEMENT,TYPE={kind},ELSET={name}",
        *(",".join(map(str, (number, *each))) for number, each in numbered),
    ]


def _alike(points: Array) -> tuple[Integers, Integers]:
    """The first node at every place, and the place of every node."""
    _, first, which = np.unique(
        np.round(points, 9) + 0.0, axis=0, return_index=True, return_inverse=True
    )
    return first, which.ravel()
