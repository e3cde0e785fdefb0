"""What a shell weighs beside its panels, and where its centre of mass is.

Hinges of whole boards have their mass in ``[panel.hinge]``; others, which lie in the creases, and
ties are weighed by the densities of ``[workshop]``.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.quantities import conversion
from orishell.document import Document, Part
from orishell.motion.hinges import Hinges
from orishell.motion.quads import unit_normals
from orishell.numerics.arrays import Array
from orishell.workshop.assembly import laid_flat
from orishell.workshop.hinge_parts import fittings_of
from orishell.workshop.order import hinge_density, tie_lengths
from orishell.workshop.schedule import WEIGHED, find_schedule
from orishell.workshop.settings import Workshop


def mass_of_hinges(document: Document, workshop: Workshop) -> float | None:
    """Mass of all hinges, tape left out (kg); None if it is not known, 0 if there are none."""
    found = find_schedule(document, workshop)
    length = float(found.hinge_lengths[np.isin(found.kinds, WEIGHED)].sum())
    mass = conversion(document.unit, "m") * length * hinge_density(document, workshop)
    return (mass or None) if length else 0.0


def mass_of_ties(document: Document, workshop: Workshop) -> float | None:
    """Mass of all ties (kg); None if it is not known, 0 if there are none."""
    if not document.ties:
        return 0.0
    length = float(tie_lengths(document, workshop).sum())
    return conversion(document.unit, "m") * length * workshop.tie_linear_density or None


def mass_by_area(document: Document, workshop: Workshop) -> float | None:
    """Mass by the areal density, and of hinges in creases and ties where known (kg).

    Parts that are not made as the sheet is weigh what their boards do. None if the areal density is
    not known.
    """
    if not workshop.areal_density:
        return None
    metres = conversion(document.unit, "m")
    by_area = workshop.areal_density * metres**2
    panels = sum(
        part.mass(by_area, metres) if part.panel != document.panel else by_area * part.areas().sum()
        for part in document.parts
    )
    whole = fittings_of(laid_flat(document)) is not None
    hinges = 0.0 if whole else mass_of_hinges(document, workshop)
    return float(panels) + (hinges or 0.0) + (mass_of_ties(document, workshop) or 0.0)


def centre_of_mass(document: Document, workshop: Workshop) -> tuple[float, float, float]:
    """Centre of mass at the target, in the world, of all parts, ties left out."""
    middle = document.shell.positions.mean(axis=0)
    mass, moment = 0.0, np.zeros(3)
    for piece in document.parts:
        weighed = (
            *(_weighed_boards(piece), _weighed_membrane(piece), _weighed_hinges(piece)),
            _weighed_by_length(piece, workshop),
        )
        for weight, centres in weighed:
            mass += float(weight.sum())
            moment += weight @ (centres - middle)
    x, y, z = document.in_world(middle + moment / mass).tolist()
    return x, y, z


def _weighed_boards(piece: Part) -> tuple[Array, Array]:
    """Weight (B,), in the document's unit cubed by density, and centre (B, 3) of every board."""
    assert piece.panel is not None
    if piece.boards is None or not len(piece.boards):
        return np.zeros(0), np.zeros((0, 3))
    corners = piece.boards_in(piece.shell)[~piece.boards.arms]
    places = corners.reshape(len(corners), -1, 3)
    start = places.mean(axis=1, keepdims=True)
    triangles, present = piece.boards.chosen(~piece.boards.arms).triangles()
    board = np.arange(len(corners))[:, None, None]
    sides = (places - start)[board, triangles]
    # A board is the sum of the tetrahedra from a point to the triangles of its surface.
    volume = np.linalg.det(sides) / 6 * present
    centre = (volume[..., None] * sides.sum(axis=2) / 4).sum(axis=1)
    centre /= volume.sum(axis=1, keepdims=True)
    return volume.sum(axis=1) * piece.panel.density, centre + start[:, 0]


def _weighed_membrane(piece: Part) -> tuple[Array, Array]:
    """Weight (F,) and centre (F, 3) of the membrane in every panel."""
    assert piece.panel is not None
    corners = piece.shell.positions[piece.mesh.faces]
    halves = corners[:, [[0, 1, 2], [0, 2, 3]]]
    run, rise = halves[:, :, 1] - halves[:, :, 0], halves[:, :, 2] - halves[:, :, 0]
    area = 0.5 * np.linalg.norm(np.cross(run, rise), axis=-1)
    centre = (area[..., None] * halves.mean(axis=2)).sum(axis=1) / area.sum(axis=1, keepdims=True)
    weight = area.sum(axis=1) * piece.panel.membrane * piece.panel.membrane_density
    return weight, centre


def _weighed_hinges(piece: Part) -> tuple[Array, Array]:
    """Weight (3 H,) and centre (3 H, 3) of hinges and of arms on either side.

    In units of a metre for both; arms are taken half way up their fins.
    """
    fittings, build, hinges = fittings_of(piece), piece.panel, piece.hinges
    if fittings is None or build is None or not isinstance(hinges, Hinges):
        return np.zeros(0), np.zeros((0, 3))
    corners = piece.panel_corners(piece.shell)
    normals = unit_normals(corners)
    heights = hinges.heights.on_edges()[fittings.edges]

    def over_crease(side: int, height: Array) -> Array:
        """Points (H, 3) so high over the middle of the crease, as the panel on a side has it."""
        panel, edge = fittings.panels[:, side], fittings.at[:, side]
        middle = 0.5 * (corners[panel, edge] + corners[panel, (edge + 1) % 4])
        return np.asarray(middle + height[:, None] * normals[panel])

    square = conversion(piece.unit, "m") ** 2
    weights = [fittings.lengths * build.hinge.linear_density / square]
    places = [over_crease(0, heights)]
    for side in (0, 1):
        fin = fittings.fins[:, side]
        area = np.where(fin > 0, fittings.lengths * (fin + fittings.feet), 0.0)
        weights.append(area * build.fin * build.arm_density)
        places.append(over_crease(side, heights - fittings.sides * (hinges.knuckle + 0.5 * fin)))
    return np.concatenate(weights), np.concatenate(places)


def _weighed_by_length(piece: Part, workshop: Workshop) -> tuple[Array, Array]:
    """Weight (H,) and centre (H, 3) of hinges in the creases, which are weighed by their length."""
    if not workshop.hinge_linear_density or fittings_of(piece) is not None:
        return np.zeros(0), np.zeros((0, 3))
    found = find_schedule(piece, workshop)
    there = np.isin(found.kinds, WEIGHED)
    ends = piece.shell.positions[piece.mesh.edges[found.edges[there]]]
    square = conversion(piece.unit, "m") ** 2
    weights = found.hinge_lengths[there] * workshop.hinge_linear_density / square
    return weights, ends.mean(axis=1)
