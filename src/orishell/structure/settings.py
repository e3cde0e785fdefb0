"""What a structure is asked: its materials, what holds it, and what loads it.

Lengths are in the design's unit, forces in newtons, wind speeds in metres per second.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal

import numpy as np

from orishell.motion.grid import Vertex

SupportKind = Literal["pinned", "fixed", "sliding", "friction"]
"""Held in place; and all panels there clamped; held up only; on the ground, which pushes only."""
Place = Literal["feet", "ends"]
"""The rows that are the shell's feet, or its first and last columns between flaps."""
Terrain = Literal["0", "I", "II", "III", "IV"]
"""Categories of EN 1991-1-4: sea, open, low vegetation, suburb, town."""
NO_CODE: Final = ((0.0, 0.8), (float(np.pi / 2), -1.0), (float(np.pi), -0.4))
"""Pressure coefficients of wind where none are given, of no code: push on what faces the wind, pull
at the crown and in the lee, as about a long arch (angles in radians)."""


@dataclass(frozen=True, slots=True)
class Support:
    """What holds some vertices of the sheet.

    Parameters
    ----------
    at
        Feet, ends, or rows and columns of vertices of the folding sheet, as for ties.
    kind
        How they are held.
    friction
        Coefficient of friction of the ground, for ``"friction"``.
    """

    at: Place | tuple[Vertex, ...]
    kind: SupportKind
    friction: float = 0.0


@dataclass(frozen=True, slots=True)
class Snow:
    """Snow, down on the plan of panels whose outer face looks up.

    Parameters
    ----------
    ground
        Load of snow on level ground (force per area).
    shape
        "slope": by each panel's slope, mu_1 of EN 1991-1-3. "cylinder": mu_3, by rise and span of
        the whole.
    """

    ground: float
    shape: Literal["slope", "cylinder"] = "slope"


@dataclass(frozen=True, slots=True)
class Zone:
    """Rows of panels with one pressure coefficient.

    Parameters
    ----------
    rows
        The first and the last of them, from 0.
    coefficient
        Positive towards the outer face.
    """

    rows: tuple[int, int]
    coefficient: float


@dataclass(frozen=True, slots=True)
class Wind:
    """Wind, square on the panels.

    Parameters
    ----------
    speed
        Basic wind speed (m/s).
    terrain
        The category of the terrain.
    direction
        Where it blows to, from x to y (radians).
    coefficients
        Pairs of an angle between a panel's outer normal and where the wind comes from (radians,
        ascending) and the pressure coefficient there, straight lines between them. Or zones, which
        must name every row of panels once.
    height
        Over the ground, for its speed; None for the top of the shell (length).
    """

    speed: float
    terrain: Terrain
    direction: float
    coefficients: tuple[tuple[float, float], ...] | tuple[Zone, ...]
    height: float | None = None


@dataclass(frozen=True, slots=True)
class PointLoad:
    """A force at a vertex.

    Parameters
    ----------
    at
        Row and column of the folding sheet, as for ties.
    force
        Along x, y and z (N).
    """

    at: Vertex
    force: tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class LoadCase:
    """Loads that act together, or factors by which those of other cases do.

    Parameters
    ----------
    name
        What it is called.
    self_weight
        Whether the shell's own weight is one of them.
    pressure
        On the outer face, square on it (force per area).
    snow, wind, points
        Further loads.
    combine
        Names of other cases and the factors of their loads; then there are no others here. Cases
        that are combined are not analysed by themselves.
    """

    name: str
    self_weight: bool = False
    pressure: float = 0.0
    snow: Snow | None = None
    wind: Wind | None = None
    points: tuple[PointLoad, ...] = ()
    combine: tuple[tuple[str, float], ...] = ()


@dataclass(frozen=True, slots=True)
class Structure:
    """A structure as it is analysed.

    Parameters
    ----------
    modulus
        Young's modulus of panels or boards, of their section as a whole (force per area).
    poisson
        Their Poisson's ratio.
    supports
        What holds it.
    cases
        What loads it.
    thickness
        Of panels, where the design has none; else None (length).
    strength
        What panels bear; None if that is not known (force per area).
    membrane_modulus
        Young's modulus of the membrane between boards; 0 if it is not counted (force per area).
    crease_stiffness
        Least and largest moment per length and angle of creases: 0 for free hinges, infinite for
        rigid ones (force per radian).
    crease_strength
        What creases bear: moment per length; None if that is not known (force).
    tie_stiffness
        Force by strain of a tie; infinite if it does not stretch (N).
    tie_strength
        What a tie bears; None if that is not known (N).
    cells
        Cells along every side of a panel, of two triangles each.
    refine
        Cells are halved until the largest displacement changes by less than this share; 0 to leave
        them as they are.
    """

    modulus: float
    poisson: float
    supports: tuple[Support, ...]
    cases: tuple[LoadCase, ...]
    thickness: float | None = None
    strength: float | None = None
    membrane_modulus: float = 0.0
    crease_stiffness: tuple[float, float] = (0.0, float("inf"))
    crease_strength: float | None = None
    tie_stiffness: float = float("inf")
    tie_strength: float | None = None
    cells: int = 4
    refine: float = 0.0

    @property
    def analysed(self) -> tuple[LoadCase, ...]:
        """The cases that are analysed: those that no other combines."""
        parts = {name for case in self.cases for name, _ in case.combine}
        return tuple(case for case in self.cases if case.name not in parts)
