"""A load case of the shell as a structure, in the report: forces in newtons.

Vertices and panels are rows and columns of the folding sheet, from 0.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from orishell.conventions.record import record
from orishell.locking.report import Panel
from orishell.motion.grid import Vertex, VertexPair
from orishell.structure.loads import LoadKind

Vector = tuple[float, float, float]
Stiffness = float | Literal["free", "rigid"]
"""Of creases: moment per length and angle (N), 0 and infinite said in words."""
Part = Literal["panels", "creases", "ties", "buckling"]
"""What may be at the end of what it bears."""
GOVERNING: Mapping[Part, str] = {
    "panels": "the stress in panels",
    "creases": "the moment of creases",
    "ties": "the force in a tie",
    "buckling": "buckling",
}
"""What governs, in the words of terminal, page and studio."""


@record
class LoadReport:
    """A load of a case.

    Parameters
    ----------
    case
        The case that has it: another one where that is combined.
    factor
        By which it is combined.
    kind
        What it is.
    pressure
        What it comes from: the pressure, snow on the ground, wind's peak velocity pressure; None
        for own weight and forces at points.
    rule
        How it comes from that, in words.
    force
        Sum of its forces, times the factor.
    """

    case: str
    factor: float
    kind: LoadKind
    pressure: float | None
    rule: str
    force: Vector


@record
class DisplacementReport:
    """The largest displacement.

    Parameters
    ----------
    size
        How large it is.
    vector
        Along x, y and z.
    panel
        A panel that has the place.
    share
        Of the shell's height.
    """

    size: float
    vector: Vector
    panel: Panel
    share: float


@record
class ReactionReport:
    """The force of a support on the shell.

    Parameters
    ----------
    at
        The supported vertex.
    force
        Along x, y and z.
    """

    at: Vertex
    force: Vector


@record
class PairReport:
    """The force between two vertices: of a tie, or of two panels of a flap on each other.

    Parameters
    ----------
    ends
        The vertices.
    force
        How much a tie pulls, or flaps push.
    """

    ends: VertexPair
    force: float


@record
class CreaseReport:
    """The crease with the largest moment.

    Parameters
    ----------
    moment
        Per length.
    panels
        The two panels beside it.
    """

    moment: float
    panels: tuple[Panel, Panel]


@record
class StressReport:
    """The largest stress in panels.

    Parameters
    ----------
    size
        Von Mises' stress.
    panel
        Where.
    face
        On which face of the panel, upper as seen from +z on the flat sheet.
    largest, least
        The largest and the least principal stress of all panels: pull and pressure.
    """

    size: float
    panel: Panel
    face: Literal["lower", "upper"]
    largest: float
    least: float


@record
class UtilisationReport:
    """Shares of what is borne, by what can be borne.

    Parameters
    ----------
    panels, creases, ties
        Of their strength; None where that is not known.
    buckling
        Of the load at which the shell buckles; None if it does not.
    governs
        The largest of these; None if there is none.
    """

    panels: float | None
    creases: float | None
    ties: float | None
    buckling: float | None
    governs: Part | None


@record
class StandingReport:
    """A shell that stands under its loads.

    Parameters
    ----------
    reaction
        Sum of all reactions.
    residual
        What is missing between loads and reactions, of forces and moments the larger, relative to
        the loads.
    displacement
        The largest.
    reactions
        Of all supported vertices.
    friction
        The largest share of the friction of the ground that a foot uses; None where none is rough.
    ties
        Forces in ties, the largest first.
    flaps
        Forces of flaps that press on each other, the largest first.
    crease
        The largest moment about a crease; None where they are free.
    stress
        The largest.
    utilisation
        Of panels, creases and ties.
    buckling
        By what factor all loads may grow until the shell buckles, by linear theory; None if it does
        not.
    frequencies
        The lowest natural frequencies (Hz).
    """

    reaction: Vector
    residual: float
    displacement: DisplacementReport
    reactions: tuple[ReactionReport, ...]
    friction: float | None
    ties: tuple[PairReport, ...]
    flaps: tuple[PairReport, ...]
    crease: CreaseReport | None
    stress: StressReport
    utilisation: UtilisationReport
    buckling: float | None
    frequencies: tuple[float, ...]


@record
class CaseReport:
    """A load case with one stiffness of creases.

    Parameters
    ----------
    name
        The case.
    creases
        Their stiffness.
    loads
        What loads it, kind by kind.
    load
        Sum of all loads.
    moves
        How it moves, where nothing resists; None if it stands.
    stands
        How it stands; None if it does not.
    """

    name: str
    creases: Stiffness
    loads: tuple[LoadReport, ...]
    load: Vector
    moves: str | None
    stands: StandingReport | None
