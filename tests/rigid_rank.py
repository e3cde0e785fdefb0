"""Degrees of freedom by the tests' own count: rigid bodies joined along hinges, moved a little.

Every panel may move as a rigid body. Two panels beside a hinge move both of its ends alike. What is
left, less the six motions of the whole, is what the sheet can do: the unknowns less the rank of
these equations. It is found from coordinates of one state alone, and knows nothing of vertices.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from mechanisms import sleeves_of
from orishell.motion import Mechanism, diagonal
from orishell.motion.complex import Complex
from orishell.motion.grid import Vertex
from orishell.motion.hinges import Hinges
from orishell.motion.layout import Layout, mesh_of, points_of
from orishell.motion.mechanism import panel_normals
from orishell.numerics.arrays import Array, Integers

GAP = 1e4
"""Singular values that are zero are less than all others by this factor at least."""


def freedoms(ends: Array, bodies: Integers, count: int) -> int:
    """How many motions bodies have that are joined along hinges.

    Parameters
    ----------
    ends
        Both ends (H, 2, 3) of every hinge.
    bodies
        The two bodies (H, 2) that it joins.
    count
        How many bodies there are.
    """
    places = ends - ends.mean(axis=(0, 1))
    places = places / np.abs(places).max()
    matrix = np.zeros((len(ends), 2, 3, count, 6))
    for k in range(2):
        for body, sign in zip(bodies.T, (1.0, -1.0), strict=True):
            hinge = np.arange(len(ends))
            for axis in range(3):
                matrix[hinge, k, axis, body, axis] = sign
                # The velocity of a point x of a body that turns at w is w x x.
                for turn in range(3):
                    rate = np.cross(np.eye(3)[turn], places[:, k])[:, axis]
                    matrix[hinge, k, axis, body, 3 + turn] = sign * rate
    found = np.linalg.svd(matrix.reshape(-1, 6 * count), compute_uv=False)
    values = np.append(found, np.zeros(max(6 * count - len(found), 0)))
    values = np.sort(values / values.max())
    zero = int((values < 1e-10).sum())
    if zero < len(values):
        assert values[zero] > GAP * max(float(values[zero - 1]), np.finfo(float).eps)
    return zero - 6


def freedoms_of_panels(mechanism: Mechanism, drive: float) -> int:
    """Those of a sheet without a thickness in one state."""
    mesh, points = mesh_of(mechanism), points_of(mechanism, drive)
    ends = points[mesh.edges[mesh.crease]]
    return freedoms(ends, mesh.edge_faces[mesh.crease], len(mesh.faces))


def freedoms_with_plates(mechanism: Mechanism, corners: Sequence[Vertex]) -> int:
    """Those of panels between flaps at the target, plates hinged along edges of their columns.

    corners: Vertices from which each of the plates goes up and down.
    """
    mesh, points = mesh_of(mechanism), points_of(mechanism, mechanism.target_drive)
    kept = ~Layout.of(mechanism).flaps
    number = np.append(np.where(kept, np.cumsum(kept) - 1, -1), -1)
    beside = number[mesh.edge_faces]
    inside = mesh.crease & (beside >= 0).all(axis=1)
    ends, bodies = [points[mesh.edges[inside]]], [beside[inside]]
    for plate, (row, column) in enumerate(corners):
        vertices = mechanism.grid.vertices()[row - 1 : row + 2, column]
        for pair in (vertices[:2], vertices[1:]):
            about = kept & (np.isin(mesh.faces, pair).sum(axis=1) == 2)
            panel = number[int(np.argmax(about))]
            ends.append(points[pair][None])
            bodies.append(np.array([[panel, kept.sum() + plate]]))
    return freedoms(np.concatenate(ends), np.concatenate(bodies), int(kept.sum()) + len(corners))


def freedoms_of_complex(
    whole: Complex, drive: float, plates: Sequence[tuple[int, int]] = ()
) -> int:
    """Those of a sheet with strips that it carries in one state.

    plates: Sleeves and their columns of vertices in which a plate holds the four panels about it
        that meet there on one side, each along its edge.
    """
    points, (panels, vertices) = points_of(whole, drive), whole.firsts
    ends, bodies = [], []
    for first, begin, mechanism in zip(panels, vertices, (whole.sheet, *whole.strips), strict=True):
        mesh = mesh_of(mechanism)
        ends.append(points[begin + mesh.edges[mesh.crease]])
        bodies.append(first + mesh.edge_faces[mesh.crease])
    count = len(whole.layout.faces)
    for part, hanging in whole.hangings:
        strips = whole.strips[part - 1]
        line = (vertices[part] + strips.grid.vertices())[hanging.line]
        on = whole.panels(hanging.part, hanging.panels, strips.columns)
        for row in (hanging.line - 1, hanging.line):
            if 0 <= row < len(strips.parallel):
                hung = whole.panels(part, row, strips.columns)
                ends.append(points[np.stack([line[:-1], line[1:]], axis=-1)])
                bodies.append(np.stack([hung, on], axis=-1))
    for which, column in plates:
        sleeve, first, begin = sleeves_of(whole)[which], panels[1 + which], vertices[1 + which]
        q, w, r = (begin + sleeve.grid.vertices())[:, column]
        at = sleeve.columns.start + column
        x = whole.grid.vertices()[sleeve.row, at]
        side = min(column, len(sleeve.above) - 2)
        across, count_own = whole.grid.columns - 1, len(sleeve.above) - 1
        on = sleeve.columns.start + side
        beside = (
            ((x, q), (sleeve.row - 1) * across + on),
            ((x, r), sleeve.row * across + on),
            ((q, w), first + side),
            ((w, r), first + count_own + side),
        )
        for pair, panel in beside:
            ends.append(points[list(pair)][None])
            bodies.append(np.array([[panel, count]]))
        count += 1
    return freedoms(np.concatenate(ends), np.concatenate(bodies), count)


def freedoms_of_boards(mechanism: Mechanism, hinges: Hinges, drive: float) -> int:
    """Those of whole boards on hinges beside their creases in one state."""
    positions = mechanism.positions(drive)
    normals = panel_normals(positions).reshape(-1, 3)
    shifts = hinges.shifts(normals)
    mesh = mesh_of(mechanism)
    first = mesh.edge_faces[mesh.crease, 0]
    heights = hinges.heights.on_edges()[mesh.crease]
    ends = positions.reshape(-1, 3)[mesh.edges[mesh.crease]]
    over = shifts[first] + heights[:, None] * normals[first]
    return freedoms(ends + over[:, None], mesh.edge_faces[mesh.crease], len(mesh.faces))


def strained(whole: Complex, states: int = 40) -> tuple[float, float]:
    """By how much panels of a sheet and what it carries change, and are not plane, by the diagonal.

    Of all distances in every panel with all that lies on its sides, from the flat sheet to the end.
    """
    loops, size = whole.layout.loops, diagonal(whole.positions(0.0))
    loops = np.where(loops < 0, loops[:, :1], loops)

    def distances(points: Array) -> Array:
        corners = points[loops]
        return np.asarray(np.linalg.norm(corners[:, :, None] - corners[:, None], axis=-1))

    wanted, stretched, off = distances(points_of(whole, 0.0)), 0.0, 0.0
    for drive in np.linspace(0.0, whole.end_drive, states):
        points = points_of(whole, float(drive))
        stretched = max(stretched, float(np.abs(distances(points) - wanted).max()))
        corners = points[loops] - points[loops].mean(axis=1, keepdims=True)
        off = max(off, float(np.linalg.svd(corners, compute_uv=False)[:, 2].max()))
    return stretched / size, off / size
