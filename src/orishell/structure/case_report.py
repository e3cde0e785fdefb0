"""A load case of the shell as a structure, in the report: forces in newtons.

Vertices and panels are rows and columns of the folding sheet, from 0.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from orishell.conventions.record import record
from orishell.locking.result import Panel
from orishell.motion.grid import Vertex, VertexPair
from orishell.structure.loads import LoadKind

Vector = tuple[float, float, float]
Stiffness = float | Literal["free", "rigid"]
"""Of creases: moment per length and angle (N), 0 and infinite said in words."""
Limiting = Literal["panels", "creases", "ties", "buckling"]
"""What may be at the end of what it bears."""
GOVERNING: Mapping[Limiting, str] = {
    "panels": "the stress in panels",
    "creases": "the moment of creases",
    "ties": "the force in a tie",
    "buckling": "buckling",
}
"""What governs, in the words of terminal, page and studio."""


@record
class LoadReport:
    """A load of a case."""

    case: str  # the case that has it: another one where that is combined
    factor: float  # by which it is combined
    kind: LoadKind  # what it is
    # what it comes from: the pressure, snow on the ground, wind's peak velocity pressure; None for
    # own weight and forces at points
    pressure: float | None
    rule: str  # how it comes from that, in words
    force: Vector  # sum of its forces, times the factor


@record
class DisplacementReport:
    """The largest displacement."""

    size: float  # how large it is
    vector: Vector  # along x, y and z
    panel: Panel  # A panel that has the place
    share: float  # of the shell's height


@record
class ReactionReport:
    """The force of a support on the shell."""

    at: Vertex  # the supported vertex
    force: Vector  # along x, y and z


@record
class PairReport:
    """The force between two vertices: of a tie, or of two panels of a flap on each other."""

    ends: VertexPair  # the vertices
    force: float  # how much a tie pulls, or flaps push


@record
class CreaseReport:
    """The crease with the largest moment."""

    moment: float  # per length
    panels: tuple[Panel, Panel]  # the two panels beside it


@record
class StressReport:
    """The largest stress in panels."""

    size: float  # von Mises' stress
    panel: Panel  # where
    # on which face of the panel, upper as seen from +z on the flat sheet
    face: Literal["lower", "upper"]
    # the largest and the least principal stress of all panels: pull and pressure
    largest: float
    least: float


@record
class UtilisationReport:
    """Shares of what is borne, by what can be borne."""

    # of their strength; None where that is not known
    panels: float | None
    creases: float | None
    ties: float | None
    buckling: float | None  # of the load at which the shell buckles; None if it does not
    governs: Limiting | None  # the largest of these; None if there is none


@record
class StandingReport:
    """A shell that stands under its loads."""

    reaction: Vector  # sum of all reactions
    # what is missing between loads and reactions, of forces and moments the larger, relative to the
    # loads
    residual: float
    displacement: DisplacementReport  # the largest
    reactions: tuple[ReactionReport, ...]  # of all supported vertices
    # the largest share of the friction of the ground that a foot uses; None where none is rough
    friction: float | None
    ties: tuple[PairReport, ...]  # forces in ties, the largest first
    flaps: tuple[PairReport, ...]  # forces of flaps that press on each other, the largest first
    crease: CreaseReport | None  # the largest moment about a crease; None where they are free
    stress: StressReport  # the largest
    utilisation: UtilisationReport  # of panels, creases and ties
    # by what factor all loads may grow until the shell buckles, by linear theory; None if it does
    # not
    buckling: float | None
    frequencies: tuple[float, ...]  # the lowest natural frequencies (Hz)


@record
class CaseReport:
    """A load case with one stiffness of creases."""

    name: str  # the case
    creases: Stiffness  # their stiffness
    loads: tuple[LoadReport, ...]  # what loads it, kind by kind
    load: Vector  # sum of all loads
    moves: str | None  # how it moves, where nothing resists; None if it stands
    stands: StandingReport | None  # how it stands; None if it does not
