"""What is largest in a loaded shell, and where.

Forces are in newtons; vertices and panels are rows and columns of the folding sheet, from 0.
"""

from __future__ import annotations

from typing import Literal

from orishell.conventions.record import record
from orishell.motion.grid import Panel, Vertex, VertexPair
from orishell.numerics.arrays import Array
from orishell.numerics.equals import SOLVED, descending
from orishell.structure.loads import Vector


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

    @classmethod
    def ranked(cls, ends: tuple[VertexPair, ...], forces: Array) -> tuple[PairForce, ...]:
        """Forces (K,) between pairs of vertices, the largest first, none left out."""
        order = descending(forces, SOLVED).tolist()
        return tuple(cls(ends[number], float(forces[number])) for number in order)


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
