"""A shell in equilibrium with its loads: all that was found of it, and what is largest in it.

Forces are in newtons; vertices and panels are rows and columns of the folding sheet, from 0.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import Literal

import numpy as np

from orishell.conventions.record import record
from orishell.motion.grid import Panel, Vertex, VertexPair
from orishell.numerics.arrays import Array
from orishell.numerics.equals import SOLVED, descending, first_largest
from orishell.structure.crease_forces import (
    AtCrease,
    CreaseForces,
    arms,
    by_kind,
    film,
    lone_board,
)
from orishell.structure.feet import Foot
from orishell.structure.load_path import LoadPath
from orishell.structure.loads import Vector, vector
from orishell.structure.mesh.edge_forces import EdgeForces
from orishell.structure.model import Model
from orishell.structure.verdict import COLLAPSED

Limiting = Literal["panels", "membrane", "creases", "arms", "ties", "buckling"]
"""What may be at the end of what it bears."""
GOVERNING: Mapping[Limiting, str] = {
    "panels": "the stress in panels",
    "membrane": "the stress in the membrane between boards",
    "creases": "the moment of creases",
    "arms": "the stress in the arms of hinges",
    "ties": "the force in a tie",
    "buckling": "buckling",
}
"""What governs, in the words of terminal, page and studio."""


@record
class Displacement:
    """The largest displacement."""

    size: float  # how large it is
    vector: Vector  # along x, y and z
    panel: Panel  # a panel that has the place
    share: float  # of the shell's height


@record
class Reaction:
    """The force of a support on the shell."""

    at: Vertex  # the supported vertex
    force: Vector  # along x, y and z


@record
class PairForce:
    """The force between two vertices: of a tie, or of two panels of a flap on each other."""

    ends: VertexPair  # the vertices
    force: float  # how much a tie pulls, or flaps push


@record
class CreaseMoment:
    """The crease with the largest moment."""

    moment: float  # per length
    panels: tuple[Panel, Panel]  # the two panels beside it


@record
class Stress:
    """The largest stress in panels, averaged over patches of a fixed share of a panel."""

    size: float  # von Mises' stress
    panel: Panel  # where
    # on which face of the panel, upper as seen from +z on the flat sheet
    face: Literal["lower", "upper"]
    # the largest and the least principal stress of all panels: pull and pressure
    largest: float
    least: float


@record
class Utilisation:
    """Shares of what is borne, by what can be borne."""

    WRITTEN = ("panels", "membrane", "creases", "arms", "ties", "buckling", "governs")

    # of their strength; None where that is not known
    panels: float | None
    membrane: float | None  # None, too, where panels have none
    creases: float | None
    arms: float | None  # None, too, where hinges have none
    ties: float | None
    buckling: float | None  # of the load at which the shell buckles; None if it does not

    @property
    def shares(self) -> dict[Limiting, float | None]:
        """All of them by name."""
        return {part: getattr(self, part) for part in GOVERNING}

    @property
    def governs(self) -> Limiting | None:
        """The largest of these; None if there is none."""
        known = [(share, part) for part, share in self.shares.items() if share]
        return max(known)[1] if known else None


@record
class Equilibrium:
    """A shell in equilibrium with its loads."""

    WRITTEN = (
        "reaction", "residual", "displacement", "reactions", "friction", "feet", "ties", "flaps",
        "crease", "creases", "stress", "lone_board", "membrane", "arms", "panel_residual",
        "utilisation",
        "buckling", "buckling_factors", "frequencies", "path",
    )  # fmt: skip

    model: Model  # what is loaded
    stiffness: float  # of creases (force per radian); 0 free, infinite rigid
    displacements: Array  # of points of the mesh (N, 3) (length)
    support_forces: Array  # on supported vertices (S, 3), as ``Model.supported`` has them (N)
    reaction: Vector  # sum of all reactions
    # what is missing between loads and reactions, of forces and moments the larger, relative to the
    # loads
    residual: float
    # what is missing for the balance of a panel with its loads and the forces at its edges,
    # relative to all loads
    panel_residual: float
    feet: tuple[Foot, ...]  # on the ground: which stick, slip or lift
    tie_forces: Array  # of ties (K,), 0 where they are slack (N)
    # with which two neighbouring flaps keep the vertices at their outer corners apart (C,), in the
    # order of ``Model.flaps``; 0 where they part (N)
    flap_forces: Array
    edges: EdgeForces  # what holds every panel at its edges
    crease_moments: Array  # largest moment per length (E,) about every edge, 0 at the border (N)
    # von Mises' stress (T, 2) at the lower and the upper face, for every triangle that of the patch
    # over which it is averaged (force per area)
    stresses: Array
    # the larger and the smaller principal stress (T, 2) of both faces, likewise (force per area)
    principal: Array
    # the lowest factors by which all loads grow until the shell buckles, by linear theory; none if
    # it does not
    buckling_factors: tuple[float, ...]
    buckling_modes: Array  # their modes (B, N, 3), the largest displacement is 1
    # share of the strain energy of each mode in panels that are held at points
    buckling_at_points: tuple[float, ...]
    # the lowest natural frequencies (Hz), loaded as it is: ties that are slack are left out, and
    # free motions, which have none
    frequencies: tuple[float, ...]
    modes: Array  # their modes (M, N, 3), the largest displacement is 1
    # the way there, where large displacements are followed: then all but frequencies is of the
    # shell as it is moved, at the end of the path
    path: LoadPath | None = None

    @property
    def buckling(self) -> float | None:
        """The lowest buckling factor; None if it does not buckle."""
        return self.buckling_factors[0] if self.buckling_factors else None

    @cached_property
    def displacement(self) -> Displacement:
        """The largest."""
        sizes = np.linalg.norm(self.displacements, axis=1)
        node = first_largest(sizes, SOLVED)
        mesh = self.model.mesh
        panel = int(np.argmax(((mesh.seats == node) | (mesh.nodes == node)).any(axis=(1, 2))))
        return Displacement(
            size=float(sizes[node]),
            vector=vector(self.displacements[node]),
            panel=self.model.panel_at(panel),
            share=float(sizes[node] / self.model.height),
        )

    @property
    def friction(self) -> float | None:
        """The largest share of its friction that a foot uses; None where none is rough."""
        return max((each.used for each in self.feet if each.used is not None), default=None)

    @property
    def reactions(self) -> tuple[Reaction, ...]:
        """Of all supported vertices."""
        both = zip(self.model.supported, self.support_forces, strict=True)
        return tuple(Reaction(at, vector(force)) for at, force in both)

    @cached_property
    def ties(self) -> tuple[PairForce, ...]:
        """Forces in ties, the largest first."""
        return _pairs(self.model.site.ties, self.tie_forces)

    @cached_property
    def flaps(self) -> tuple[PairForce, ...]:
        """Forces of flaps that press on each other, the largest first."""
        return _pairs(self.model.flaps, self.flap_forces)

    @cached_property
    def crease(self) -> CreaseMoment | None:
        """The largest moment about a crease; None where they are free."""
        moments = np.abs(self.crease_moments)
        beside = (self.model.grid.faces_edges() == first_largest(moments, SOLVED)).any(axis=1)
        panels = np.flatnonzero(beside).tolist()
        if len(panels) < 2 or not self.stiffness:
            return None
        first, second = map(self.model.panel_at, panels)
        return CreaseMoment(float(moments.max()), (first, second))

    @cached_property
    def creases(self) -> tuple[CreaseForces, ...]:
        """The largest forces per length along row creases and along column creases."""
        return by_kind(self.model, self.edges)

    @cached_property
    def membrane(self) -> AtCrease | None:
        """The largest stress of the membrane in a crease; None if there is none between boards."""
        return film(self.model, self.edges)

    @cached_property
    def lone_board(self) -> AtCrease | None:
        """The largest stress where one of two boards is left beside a crease; None if nowhere."""
        return lone_board(self.model, self.edges)

    @cached_property
    def arms(self) -> AtCrease | None:
        """The largest stress of the arms of hinges beside creases; None if there are none."""
        return arms(self.model, self.edges)

    @cached_property
    def stress(self) -> Stress:
        """The largest."""
        triangle, face = np.unravel_index(first_largest(self.stresses, SOLVED), self.stresses.shape)
        return Stress(
            size=float(self.stresses[triangle, face]),
            panel=self.model.panel_at(int(self.model.mesh.panels[triangle])),
            face="upper" if face else "lower",
            largest=float(self.principal[:, 0].max()),
            least=float(self.principal[:, 1].min()),
        )

    @cached_property
    def utilisation(self) -> Utilisation:
        """Of panels, membrane, creases and ties."""
        asked, crease, alone, film = (
            self.model.structure,
            self.crease,
            self.lone_board,
            self.membrane,
        )
        boards = 0.0 if alone is None else alone.size
        return Utilisation(
            panels=_share(max(self.stress.size, boards), asked.strength),
            membrane=None if film is None else _share(film.size, asked.membrane_strength),
            creases=_share(0.0 if crease is None else crease.moment, asked.crease_strength),
            arms=None if self.arms is None else _share(self.arms.size, asked.arm_strength),
            ties=_share(self.ties[0].force if self.ties else 0.0, asked.tie_strength),
            buckling=None if self.buckling is None else 1 / self.buckling,
        )

    @property
    def used(self) -> float:
        """The largest share of what is borne, and of a displacement that makes it another shell."""
        known = (share or 0.0 for share in self.utilisation.shares.values())
        return max(self.displacement.share / COLLAPSED, *known)

    @property
    def unknown(self) -> tuple[Limiting, ...]:
        """What bears something, and nobody said how much it can."""
        bears: dict[Limiting, bool] = {
            "panels": True,
            "membrane": self.membrane is not None and self.membrane.size > 0,
            "creases": self.crease is not None,
            "arms": self.arms is not None and self.arms.size > 0,
            "ties": bool(self.tie_forces.any()),
        }
        return tuple(
            part for part, any_ in bears.items() if any_ and self.utilisation.shares[part] is None
        )


def _pairs(ends: tuple[VertexPair, ...], forces: Array) -> tuple[PairForce, ...]:
    """Forces between pairs of vertices, the largest first, none left out."""
    order = descending(forces, SOLVED).tolist()
    return tuple(PairForce(ends[number], float(forces[number])) for number in order)


def _share(found: float, strength: float | None) -> float | None:
    return None if strength is None else found / strength
