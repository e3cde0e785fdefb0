"""A shell as a structure, as files and pages show it: meshed, supported, loaded and deflected."""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.conventions.row import Sign
from orishell.numerics.arrays import Array, Integers


@record
class LoadedCase:
    """One load case with one stiffness of creases."""

    name: str  # what it is called, the stiffness of creases said where there are two
    sign: Sign  # whether the shell fails under it, wants attention, or carries it
    # whether it is in balance; displacements are those of its free motion otherwise, the largest is
    # 1
    balanced: bool
    forces: Array  # loads on nodes (N, 3) (N)
    displacements: Array  # of nodes (N, 3) (length)
    # the larger of von Mises' stresses (T + S,) at both faces (force per area)
    stresses: Array
    # the lowest factors of all loads under which it buckles, and displacements (N, 3) of the mode,
    # the largest is 1
    buckling: tuple[tuple[float, Array], ...] = ()
    # stress that panels bear under loads that last as long; None if that is not known, or the shell
    # is not in balance (force per area)
    strength: float | None = None
    # the same of what stiffens the sheet, which may be of another material (force per area)
    parts_strength: float | None = None


@record
class LoadedParts:
    """What stiffens the sheet, meshed: gussets, panels of box girders and plates across these.

    Their triangles come behind those of panels wherever stresses are.
    """

    names: tuple[str, ...]  # what each is called: "gusset 5,3", "box 4 upper 3", "plate 4,3"
    # corners (S, 3): nodes of the shell; the two of every cell follow each other
    triangles: Integers
    # which of them (S,) each triangle is of, numbered behind the panels of the sheet, flaps counted
    panels: Integers
    # stiffness (S,) of sections: force per length by strain, moment per length by curvature
    membrane: Array
    bending: Array
    poisson: float  # Poisson's ratio
    # mass (S,) per area, that of each spread over it (kg per square of the unit)
    areal_mass: Array

    @property
    def numbers(self) -> dict[str, int]:
        """The number of each by its name."""
        first = int(self.panels.min())
        return {name: first + k for k, name in enumerate(self.names)}


@record
class LoadedCreases:
    """The largest force along every crease (C,) of a shell, of all load cases in balance."""

    panels: Integers  # the two panels (C, 2) beside each, flaps counted
    sizes: Array  # force by length (C,) (N)
    what: tuple[str, ...]  # which force it is (C,): "pull"; empty where there is none
    cases: tuple[str, ...]  # the load case (C,), as LoadedCase names it; empty where there is none


@record
class LoadedShell:
    """A meshed shell at its target, in the document's frame, with its load cases."""

    points: Array  # nodes (N, 3), those that only parts have behind those of panels
    # corners (T, 3), all one way round; the two of every cell follow each other
    triangles: Integers
    panels: Integers  # the panel (T,) of every triangle, flaps counted
    # stiffness (T,) of sections: force per length by strain, moment per length by curvature
    membrane: Array
    bending: Array
    poisson: float  # Poisson's ratio
    areal_mass: Array  # mass (T,) per area (kg per square of the unit)
    # supported dofs (H, 2): a node, and 0 to 2 for a displacement, 3 to 5 for a rotation along
    # x, y, z; feet on the ground as if they were pinned
    restrained: Integers
    ties: Integers  # ends (K, 2) of ties
    tie_stiffness: float  # their force by strain; infinite if they do not stretch (N)
    cases: tuple[LoadedCase, ...]  # the load cases
    # whether panels are whole boards on hinges beside the creases: they share no points then
    whole_boards: bool = False
    # what stiffens the sheet; None if nothing does. None of it is in the triangles of panels
    parts: LoadedParts | None = None
    creases_turn: bool = False  # whether creases may turn, in some case at least
    rails: bool = False  # whether base rails join its feet
    creases: LoadedCreases | None = None  # forces along creases; None if no case is in balance

    @property
    def all_triangles(self) -> Integers:
        """Corners (T + S, 3) of all triangles, those of panels first."""
        if self.parts is None:
            return self.triangles
        return np.concatenate([self.triangles, self.parts.triangles])

    @property
    def all_panels(self) -> Integers:
        """The panel (T + S,) of every triangle, or which part it is of."""
        if self.parts is None:
            return self.panels
        return np.concatenate([self.panels, self.parts.panels])
