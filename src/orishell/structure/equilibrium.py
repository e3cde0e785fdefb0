"""A shell in equilibrium with its loads: all that was found of it, and what is largest in it.

Forces are in newtons; vertices and panels are rows and columns of the folding sheet, from 0.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array
from orishell.numerics.equals import SOLVED, first_largest, largest_of
from orishell.structure.crease_forces import (
    AtCrease,
    CreaseForces,
    arms,
    beside_creases,
    by_kind,
    film,
    lone_board,
)
from orishell.structure.crease_lines import hinge_line, most_used_line, unknown_line
from orishell.structure.feet import Foot
from orishell.structure.grain_shares import GrainShares, grain_shares
from orishell.structure.largest import (
    CreaseMoment,
    Displacement,
    PairForce,
    Reaction,
    Stress,
    largest_displacement,
    largest_stress,
)
from orishell.structure.load_path import LoadPath, Unfollowed
from orishell.structure.loads import Vector, vector
from orishell.structure.materials import Duration, materials
from orishell.structure.mesh.edge_forces import EdgeForces
from orishell.structure.mesh.plate_edges import PlateEdges
from orishell.structure.mesh.stresses import PanelStresses
from orishell.structure.model import Model
from orishell.structure.plate_edges import JudgedEdges, judged_edges
from orishell.structure.plates import (
    BoxStress,
    PlateStress,
    most_stressed,
    most_stressed_box,
)
from orishell.structure.rail import AtRail, worst_rail
from orishell.structure.sandwich_shares import InSandwich, in_sandwich
from orishell.structure.used_shares import loaded_unknown, utilisation_of
from orishell.structure.utilisation import Limiting, Utilisation

COLLAPSED = 0.25
"""A shell displaced by this share of its height is no longer the shell that was analysed."""


@record
class Equilibrium:
    """A shell in equilibrium with its loads."""

    REPORTED = (
        "reaction", "residual", "displacement", "crept", "reactions", "friction", "feet", "ties",
        "flaps", "crease", "creases", "lines", "used_line", "stress", "beside", "lone_board",
        "membrane", "arms", "gussets", "boxes", "box_lines", "plate_edges", "rail",
        "panel_residual", "utilisation", "buckling", "buckling_factors", "frequencies", "path",
        "unfollowed", "duration", "strength",
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
    # what holds what stiffens the sheet at its edges, as ``Model.plates`` has it
    held_plates: tuple[PlateEdges, ...]
    crease_moments: Array  # largest moment per length (E,) about every edge, 0 at the border (N)
    # von Mises' stress (T, 2) at the lower and the upper face, for every triangle that of the patch
    # over which it is averaged (force per area)
    stresses: Array
    # the larger and the smaller principal stress (T, 2) of both faces, likewise (force per area)
    principal: Array
    in_patches: PanelStresses  # stresses of panels by patches
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
    in_plates: tuple[PanelStresses, ...]  # in what stiffens the sheet, as ``Model.plates`` has it
    # the way there, where large displacements are followed: then all but frequencies is of the
    # shell as it is moved, at the end of the path
    path: LoadPath | None = None
    # why it was not followed though it buckles soon; None if it was, or does not
    unfollowed: Unfollowed | None = None
    duration: Duration = "permanent"  # how long its loads last

    @property
    def strength(self) -> float | None:
        """What panels bear under loads that last as long; None if that is not known."""
        return self.model.structure.bears(self.duration, self.model.site.unit)

    @property
    def plate_strength(self) -> float | None:
        """The same of what stiffens the sheet; None if that is not known, or nothing does."""
        model = self.model
        of = model.stiffened.of_plates
        return of.bears(self.duration, model.site.unit) if model.plates else None

    @property
    def buckling(self) -> float | None:
        """The lowest buckling factor; None if it does not buckle."""
        return self.buckling_factors[0] if self.buckling_factors else None

    @cached_property
    def displacement(self) -> Displacement:
        """The largest."""
        return largest_displacement(self.model, self.displacements)

    @property
    def crept(self) -> float:
        """The largest displacement once it has crept (length): EN 1995-1-1, 2.2.3.

        It grows only under loads all of which last, by the most that any of its parts creeps.
        """
        size = self.displacement.size
        if self.duration != "permanent":
            return size
        made = [
            each for each in (self.model.structure, self.model.stiffened.of_plates) if each.material
        ]
        factors = [materials()[each.material or ""].creeps(each.service_class) for each in made]
        return size * (1 + max(factors, default=0.0))

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
        return PairForce.ranked(self.model.site.ties, self.tie_forces)

    @cached_property
    def flaps(self) -> tuple[PairForce, ...]:
        """Forces of flaps that press on each other, the largest first."""
        return PairForce.ranked(self.model.flaps, self.flap_forces)

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
    def gussets(self) -> PlateStress | None:
        """The largest stress of gussets; None if there are none."""
        return most_stressed(self.model, self.in_plates)

    @cached_property
    def boxes(self) -> BoxStress | None:
        """The largest stress of box girders; None if there are none."""
        return most_stressed_box(self.model, self.in_plates)

    @cached_property
    def box_lines(self) -> JudgedEdges | None:
        """Forces along hinges of box girders; None without any."""
        return judged_edges(self.model, self.held_plates, hinged=True)

    @cached_property
    def plate_edges(self) -> JudgedEdges | None:
        """Forces along edges of gussets, and of plates across box girders; None without any."""
        return judged_edges(self.model, self.held_plates, hinged=False)

    @cached_property
    def rail(self) -> AtRail | None:
        """The largest stress of base rails; None without them."""
        return worst_rail(self.model.rails, self.displacements)

    @cached_property
    def stress(self) -> Stress:
        """The largest."""
        return largest_stress(self.model, self.stresses, self.principal)

    @cached_property
    def lines(self) -> AtCrease:
        """The largest force per length that a crease line has to bear."""
        return hinge_line(self.model, self.edges)

    @cached_property
    def used_line(self) -> AtCrease | None:
        """The crease line that uses most of what it bears; None if nothing is known of any."""
        return most_used_line(self.model, self.edges)

    @cached_property
    def unknown_line(self) -> AtCrease:
        """The largest force per length in directions in which no strength of lines is known."""
        return unknown_line(self.model, self.edges)

    @cached_property
    def beside(self) -> AtCrease | None:
        """The largest structural stress of solid panels at creases; None if they are not solid."""
        return beside_creases(self.model, self.edges)

    @cached_property
    def by_grain(self) -> GrainShares | None:
        """Shares of what boards with a grain bear; None where they have none."""
        return grain_shares(self.model, self.in_patches, self.edges, self.duration)

    @cached_property
    def sandwich(self) -> InSandwich | None:
        """What there is in the core and the faces of boards; None where they have none."""
        return in_sandwich(self.model, self.in_patches, self.edges)

    @property
    def in_panels(self) -> tuple[float, AtCrease | None]:
        """The largest stress that panels bear, and the crease where it is, if it is at one.

        At creases of bevelled boards it depends on how hinges hold what chamfers leave.
        """
        both = (self.lone_board, None if self.model.bevelled else self.beside)
        at_creases = [each for each in both if each is not None]
        most = largest_of(at_creases, lambda each: each.size, SOLVED) if at_creases else None
        if most is None or most.size <= self.stress.size:
            return self.stress.size, None
        return most.size, most

    @property
    def worst_crease(self) -> AtCrease | None:
        """The crease where panels are nearest to the end of what they bear, if it is at one."""
        return self.in_panels[1] if self.by_grain is None else self.by_grain.crease

    @cached_property
    def utilisation(self) -> Utilisation:
        """Of all that bears something."""
        return utilisation_of(self)

    @property
    def unknown(self) -> tuple[Limiting, ...]:
        """Loaded parts without a given strength."""
        return loaded_unknown(self)

    @property
    def used(self) -> float:
        """The largest share of what is borne, and of a displacement that makes it another shell."""
        known = (share or 0.0 for share in self.utilisation.shares.values())
        return max(self.displacement.share / COLLAPSED, *known)
