"""What is largest in a loaded shell, and where.

Forces are in newtons; vertices and panels are rows and columns of the folding sheet, from 0.
"""

from __future__ import annotations

from typing import Literal

import numpy as np

from orishell.conventions.record import record
from orishell.motion.grid import Panel, Vertex, VertexPair
from orishell.numerics.arrays import Array
from orishell.numerics.equals import SOLVED, descending, first_largest
from orishell.structure.loads import Vector, vector
from orishell.structure.mesh.sheet import SheetMesh
from orishell.structure.model import Model


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


def largest_displacement(model: Model, displacements: Array) -> Displacement:
    """The largest of displacements (N, 3) of points of the mesh (length)."""
    sizes = np.linalg.norm(displacements, axis=1)
    node = first_largest(sizes, SOLVED)
    return Displacement(
        size=float(sizes[node]),
        vector=vector(displacements[node]),
        panel=model.panel_at(_panel_of(model.mesh, node)),
        share=float(sizes[node] / model.height),
    )


def largest_stress(model: Model, stresses: Array, principal: Array) -> Stress:
    """The largest of von Mises' stresses (T, 2) of triangles at both faces (force per area).

    principal: The larger and the smaller principal stress (T, 2) of both faces.
    """
    triangle, face = np.unravel_index(first_largest(stresses, SOLVED), stresses.shape)
    return Stress(
        size=float(stresses[triangle, face]),
        panel=model.panel_at(int(model.mesh.panels[triangle])),
        face="upper" if face else "lower",
        largest=float(principal[:, 0].max()),
        least=float(principal[:, 1].min()),
    )


def _panel_of(mesh: SheetMesh, node: int) -> int:
    """The panel that has a point of the mesh; the nearest one where what stiffens them has it."""
    own = ((mesh.seats == node) | (mesh.nodes == node)).any(axis=(1, 2))
    if own.any():
        return int(np.argmax(own))
    away = np.linalg.norm(mesh.facets.points[mesh.seats] - mesh.facets.points[node], axis=-1)
    return int(np.argmin(away.min(axis=(1, 2))))
