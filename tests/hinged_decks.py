"""Decks for CalculiX with free hinges: every panel has nodes of its own, tied by equations.

They are written from the analysed model: its mesh, with that of box girders, places, loads,
supports and sections, and what ties and flaps act as the analysis found. Elements are those of
CalculiX.
"""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from calculix_tool import REQUIRED
from node_tools import lacking
from orishell.numerics.arrays import Array, Integers
from orishell.structure.case import CaseResult
from orishell.structure.model import Model

STIFF = 1e3
"""A tie or flap that does not give is so many times as stiff as a square of panel."""
APART = 1e-6
"""Panels that share nodes differ in thickness by this share: of those that are alike, and turned by
less than 20 degrees, CalculiX makes one body, and says no more what each bears."""
FACTORS = r" +B U C K L I N G[^\n]*\n\n MODE NO[^\n]*\n +FACTOR"
TABLE = r"^ %s[^\n]*\n\n((?: +\d[^\n]*\n)+)"


@dataclass(frozen=True)
class Deck:
    """A model with free hinges, for one of its load cases."""

    model: Model
    case: CaseResult
    element: str = "S8R"  # of CalculiX: S8R, S8
    springs_act: bool = False  # ties and flaps are springs; or equations, which do not give
    stressed: bool = False  # stresses of elements, and forces on nodes, are printed as well
    locked: bool = False  # panels share nodes, and turns with them

    @property
    def parts(self) -> list[Integers]:
        """Nodes (F, m+1, n+1) of the model in panels of the sheet, and in those of every strip."""
        strips = self.model.plates if self.model.design.carried else ()
        return [self.model.mesh.nodes, *(each.nodes[each.own.nodes] for each in strips)]

    @property
    def nodes(self) -> Integers:
        """The node (own,) of the model at every one of the panels' own nodes."""
        return np.concatenate([each.ravel() for each in self.parts])

    @property
    def own(self) -> int:
        """Nodes of all panels, without the middles of sides."""
        return len(self.nodes)

    def cells(self) -> tuple[Integers, Integers]:
        """Corners (C, 4) of cells as numbers of the panels' own nodes, and their panels (C,)."""
        corners, panels, first, before = [], [], 0, 0
        for nodes in self.parts:
            own = first + np.arange(nodes.size).reshape(nodes.shape)
            around = [own[:, :-1, :-1], own[:, 1:, :-1], own[:, 1:, 1:], own[:, :-1, 1:]]
            corners.append(np.stack([each.ravel() for each in around], axis=1))
            count = len(corners[-1]) // len(nodes)
            panels.append(before + np.repeat(np.arange(len(nodes)), count))
            first, before = first + nodes.size, before + len(nodes)
        return np.concatenate(corners), np.concatenate(panels)

    def middles(self) -> tuple[Integers, Integers]:
        """Sides (S, 2) of cells by own nodes, and which (C, 4) each cell has."""
        corners, _ = self.cells()
        sides = np.sort(np.stack([corners, np.roll(corners, -1, axis=1)], axis=-1), axis=-1)
        ends, which = np.unique(sides.reshape(-1, 2), axis=0, return_inverse=True)
        return ends, which.reshape(-1, 4)

    def masters(self) -> Integers:
        """The first own node (N,) at every node of the model."""
        _, first = np.unique(self.nodes, return_index=True)
        return first

    def together(self, ends: Integers) -> Iterator[tuple[int, int]]:
        """Pairs of nodes that have their displacements in common: the first, and another."""
        nodes, masters = self.nodes, self.masters()
        yield from (
            (int(masters[node]), own) for own, node in enumerate(nodes) if masters[node] != own
        )
        first: dict[tuple[int, int], int] = {}
        for number, (one, other) in enumerate(np.sort(nodes[ends], axis=1).tolist()):
            before = first.setdefault((one, other), number)
            if before != number:
                yield self.own + before, self.own + number

    def _held_apart(self) -> Iterator[str]:
        """Equations of ties and flaps that act: the length between their ends stays."""
        model, masters = self.model, self.masters()
        points, supported = model.mesh.facets.points, set(model.supports.dofs(model.mesh).tolist())
        for one, other, _ in self.springs():
            along = points[other] - points[one]
            along /= np.linalg.norm(along)
            terms = [
                (node, axis, sign * along[axis])
                for node, sign in ((other, 1.0), (one, -1.0))
                for axis in range(3)
                if 3 * node + axis not in supported and abs(along[axis]) > 1e-9
            ]
            terms.sort(key=lambda term: -abs(term[2]))
            if terms:
                yield f"{len(terms)}"
                yield from (f"{masters[node] + 1},{axis + 1},{by:.13g}" for node, axis, by in terms)

    def springs(self) -> list[tuple[int, int, float]]:
        """Nodes of the model between which ties and flaps act, and their stiffness."""
        model, found = self.model, self.case.equilibrium
        assert found is not None
        points, stiff = model.mesh.facets.points, STIFF * model.membrane_stiffness[1]
        springs = []
        for pairs, forces, own in (
            (model.nodes_of(model.site.ties), found.tie_forces, model.structure.tie_stiffness),
            (model.nodes_of(model.flaps), found.flap_forces, np.inf),
        ):
            for (one, other), force in zip(pairs.tolist(), forces, strict=True):
                if force > 0:
                    length = float(np.linalg.norm(points[other] - points[one]))
                    springs.append((one, other, min(own / length, stiff)))
        return springs

    def sections(self) -> tuple[Array, Array]:
        """Thickness (C,) of cells, and Young's modulus: as stiff in its plane and in bending."""
        section = self.model.section
        every = [section, *(self.model.stiffened.sections if len(self.parts) > 1 else ())]
        both = []
        for nodes, own in zip(self.parts, every, strict=True):
            count = 2 * nodes[:, 1:, 1:].size
            both.append([np.broadcast_to(each, count) for each in (own.membrane, own.bending)])
        membrane, bending = np.concatenate(both, axis=1).reshape(2, -1, 2).mean(axis=2)
        thickness = np.sqrt(12 * bending / membrane)
        if self.locked:
            row, column = np.divmod(self.cells()[1], self.model.grid.columns - 1)
            thickness = thickness * (1 + APART * (2 * (row % 2) + column % 2))
        return thickness, (1 - section.poisson**2) * membrane / thickness

    def write(self, path: Path, *steps: str, off: Array | None = None) -> None:
        """Write it with steps: "*STATIC", "*STATIC,NLGEOM" or "*BUCKLE".

        off: By how much its nodes (N, 3) are off the places of the model.
        """
        path.write_text("\n".join(self._lines(steps, off)) + "\n", encoding="ascii")

    def _lines(self, steps: tuple[str, ...], off: Array | None) -> Iterator[str]:
        model = self.model
        nodes, points = self.nodes, model.mesh.facets.points
        points = points if off is None else points + off
        (corners, _), (ends, which) = self.cells(), self.middles()
        places = np.concatenate([points[nodes], points[nodes[ends]].mean(axis=1)])
        yield "*NODE,NSET=ALL"
        yield from (f"{k},{x:.13g},{y:.13g},{z:.13g}" for k, (x, y, z) in enumerate(places, 1))
        yield f"*ELEMENT,TYPE={self.element},ELSET=PANELS"
        together = list(self.together(ends))
        every = np.concatenate([corners, self.own + which], axis=1) + 1
        if self.locked:
            shared = np.arange(len(places) + 1)
            first, other = np.array(together).T + 1
            shared[other] = first
            every = shared[every]
        yield from (",".join(map(str, (k, *each))) for k, each in enumerate(every.tolist(), 1))
        values = np.column_stack(self.sections())
        kinds, kind = np.unique(values.round(12), axis=0, return_inverse=True)
        for number, (thickness, modulus) in enumerate(kinds):
            yield f"*ELSET,ELSET=E{number}"
            yield from map(str, (np.flatnonzero(kind.ravel() == number) + 1).tolist())
            yield f"*MATERIAL,NAME=M{number}"
            yield f"*ELASTIC\n{modulus:.13g},{model.section.poisson:.13g}"
            yield f"*SHELL SECTION,ELSET=E{number},MATERIAL=M{number}\n{thickness:.13g}"
        equations = [
            f"2\n{other + 1},{axis},1.,{master + 1},{axis},-1."
            for master, other in together * (not self.locked)
            for axis in (1, 2, 3)
        ]
        if not self.springs_act:
            equations += self._held_apart()
        if equations:
            yield "*EQUATION"
            yield from equations
        masters = self.masters()
        for number, (one, other, stiffness) in enumerate(self.springs() * self.springs_act, 1):
            yield f"*ELEMENT,TYPE=SPRINGA,ELSET=T{number}"
            yield f"{len(every) + number},{masters[one] + 1},{masters[other] + 1}"
            yield f"*SPRING,ELSET=T{number}\n\n{stiffness:.12e}"
        yield "*BOUNDARY"
        for dof in model.supports.dofs(model.mesh).tolist():
            node, axis = divmod(dof, 3)
            assert node < model.mesh.node_count, "held against turning"
            yield f"{masters[node] + 1},{axis + 1},{axis + 1}"
        yield "*NSET,NSET=SHOWN"
        yield from (str(each + 1) for each in masters.tolist())
        yield from self._steps(steps)

    def _steps(self, steps: tuple[str, ...]) -> Iterator[str]:
        masters = self.masters()
        for step in steps:
            yield f"*STEP{',NLGEOM' if 'NLGEOM' in step else ''}"
            yield step.replace(",NLGEOM", "")
            if "BUCKLE" in step:
                yield "3,1e-4,40,1000"
            elif "NLGEOM" in step:
                yield "0.34,1.,1e-5,0.34"
            yield "*CLOAD,OP=NEW"
            for node, axis in np.argwhere(self.case.forces).tolist():
                yield f"{masters[node] + 1},{axis + 1},{self.case.forces[node, axis]:.13g}"
            yield "*NODE PRINT,NSET=SHOWN,FREQUENCY=1000\nU"
            if self.stressed:
                yield "*NODE PRINT,NSET=ALL,FREQUENCY=1000\nRF"
                yield "*NODE FILE,OUTPUT=3D,FREQUENCY=1000\nRF"
                yield "*EL PRINT,ELSET=PANELS,GLOBAL=YES,FREQUENCY=1000\nS"
            yield "*END STEP"


@dataclass(frozen=True)
class Found:
    """What CalculiX finds: by step displacements of the model's nodes (N, 3), and factors.

    Where asked, forces with which its elements hold nodes (own + S, 3), and stresses xx, yy, zz,
    xy, xz, yz (C, 8, 6) in points of cells, four below and then four above.
    """

    displacements: list[Array]
    factors: list[float]
    forces: list[Array]
    stresses: list[Array]


def run_deck(path: Path, deck: Deck) -> Found:
    """Run CalculiX on a written deck."""
    if shutil.which("ccx") is None:
        lacking("CalculiX is not installed: apt-get install calculix-ccx", REQUIRED)
    done = subprocess.run(
        ["ccx", "-i", path.stem], cwd=path.parent, capture_output=True, encoding="utf-8",
        timeout=600, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout[-2000:]
    assert "*ERROR" not in done.stdout, done.stdout[-3000:]
    text = path.with_suffix(".dat").read_text()
    every = _tables(text, r"displacements \(vx", 3)
    cells = len(deck.cells()[0])
    return Found(
        displacements=[_of_nodes(each, deck.masters() + 1) for each in every],
        factors=[float(row[1]) for each in _tables(text, FACTORS, 1) for row in each],
        forces=[_of_nodes(each, np.sort(each[:, 0])) for each in _tables(text, r"forces \(fx", 3)],
        stresses=[
            each[:, 2:].reshape(cells, -1, 6) for each in _tables(text, r"stresses \(elem", 7)
        ],
    )


def _tables(text: str, head: str, width: int) -> list[Array]:
    """Numbers (rows, 1 + width) of all tables with a head; words at the ends are left out."""
    found = re.findall(TABLE % head, text, flags=re.MULTILINE)
    return [
        np.array([row.split()[: 1 + width] for row in each.splitlines()], dtype=float)
        for each in found
    ]


def _of_nodes(table: Array, nodes: Array | Integers) -> Array:
    """Values (n, k) of nodes (n,) in a table (rows, 1 + k) that has them in any order."""
    order = np.argsort(table[:, 0])
    return table[order[np.searchsorted(table[order, 0], nodes)], 1:]
