"""The reference frame that the others are compared with, and what a length error means there."""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.io import FoldFile, FoldFrame
from orishell.motion.mesh import QuadMesh, measure_mesh_folds
from orishell.motion.quads import area_vectors, corner_distances, reflex_corners
from orishell.numerics.arrays import Array, Booleans, Integers

NOTHING = 1e-12
"""A panel is a line if its size is below this share of the sheet's diagonal."""

SMALLEST_SHEET = 1e-50
"""Sheets smaller than this are refused: products of their lengths would underflow (length)."""


@record
class Sheet:
    """The panels as they are in the reference frame: the flat sheet if there is one.

    An angle may be wrong by as much as a corner that is moved by ``tolerance`` turns the panel
    there: ``tolerance`` over the panel's size, which is its shortest edge or, if that is
    less, its area over its longer diagonal. A panel that lies level in the flat sheet may go
    counter-clockwise seen from +z or clockwise: mountains and valleys are those seen from +z.
    """

    mesh: QuadMesh
    frame: FoldFrame
    flat: bool  # whether the frame is the flat sheet
    diagonal: float  # of the frame's bounding box
    tolerance: float  # of a length (length)
    distances: Array  # (F, 6) of corners
    reflex: Booleans  # (F, 4), corners whose sector is above pi
    panel_limits: Array  # (F,), allowed errors of angles (radians)
    edge_limits: Array  # (E,), by the smallest panel there (radians)
    vertex_limits: Array  # (V,), by the smallest panel there (radians)
    up: Array  # (F,), +1 counter-clockwise or -1
    inner: Integers  # (I,), vertices that panels surround

    @classmethod
    def of(cls, file: FoldFile, tolerance: float) -> Sheet:
        """Find the reference frame and measure it, with a tolerance relative to its diagonal.

        It is the first frame that calls itself a crease pattern, or else the first one without
        folds, or else the first one. A panel of it without an area is an InputError.
        """
        mesh = file.mesh
        patterns = [frame for frame in file.frames if "creasePattern" in frame.classes]
        patterns += [frame for frame in file.frames if _is_unfolded(mesh, frame, tolerance)][:1]
        frame = patterns[0] if patterns else file.frames[0]
        diagonal, sizes = _sizes(mesh, frame.positions)
        if diagonal < SMALLEST_SHEET:
            raise InputError(
                "the sheet has no size",
                where=f"{file.path}: frame {frame.number} vertices_coords",
                got=f"a bounding box of diagonal {plain(diagonal, 3)}",
                expected=f"at least {SMALLEST_SHEET:g}",
            )
        small = sizes <= NOTHING * diagonal
        if small.any():
            raise InputError(
                "a panel has no area, or crosses itself",
                where=f"{file.path}: frame {frame.number} panel {np.argmax(small)}",
            )
        corners = frame.positions[mesh.faces]
        limits = tolerance * diagonal / sizes
        vertex_limits = np.zeros(mesh.vertex_count)
        np.maximum.at(vertex_limits, mesh.faces.ravel(), np.repeat(limits, 4))
        return cls(
            mesh=mesh,
            frame=frame,
            flat=bool(patterns),
            diagonal=diagonal,
            tolerance=tolerance * diagonal,
            distances=corner_distances(corners),
            reflex=reflex_corners(corners),
            panel_limits=limits,
            edge_limits=_on_edges(mesh, limits),
            vertex_limits=vertex_limits,
            up=_upward(mesh, frame.positions) if patterns else np.ones(len(sizes)),
            inner=mesh.inner_vertices(),
        )

    def state(self, frame: FoldFrame) -> State:
        """Measure the fold angles of a frame."""
        side = np.append(self.up, 1.0)[self.mesh.edge_faces.max(axis=1)]
        folds = side * measure_mesh_folds(self.mesh, frame.positions)
        return State(frame, folds, bool((np.abs(folds) > self.edge_limits).any()))


@record
class State:
    """One frame of the file."""

    frame: FoldFrame
    folds: Array  # (E,), measured, valley positive (radians)
    folded: bool  # whether any crease is


def _is_unfolded(mesh: QuadMesh, frame: FoldFrame, tolerance: float) -> bool:
    diagonal, sizes = _sizes(mesh, frame.positions)
    if (sizes <= NOTHING * diagonal).any():
        return False
    limits = _on_edges(mesh, tolerance * diagonal / sizes)
    return bool((np.abs(measure_mesh_folds(mesh, frame.positions)) <= limits).all())


def _sizes(mesh: QuadMesh, positions: Array) -> tuple[float, Array]:
    """Diagonal of the panels' bounding box, and the size (F,) of every panel."""
    corners = positions[mesh.faces]
    diagonal = float(np.linalg.norm(np.ptp(corners.reshape(-1, 3), axis=0)))
    distances = corner_distances(corners)
    longest = np.maximum(distances.max(axis=1), np.finfo(float).tiny)
    area = np.linalg.norm(area_vectors(corners), axis=-1)
    return diagonal, np.minimum(distances.min(axis=1), area / longest)


def _on_edges(mesh: QuadMesh, limits: Array) -> Array:
    """The larger limit (E,) of the panels beside every edge."""
    return np.asarray(np.append(limits, 0.0)[mesh.edge_faces].max(axis=1))


def _upward(mesh: QuadMesh, positions: Array) -> Array:
    """For every panel (F,) -1 if its piece of the sheet, lying level, goes clockwise, or 1."""
    vectors = area_vectors(positions[mesh.faces])
    total = np.stack([np.bincount(mesh.pieces, vectors[:, k]) for k in range(3)], axis=-1)
    seen_from_below = total[:, 2] < -0.5 * np.linalg.norm(total, axis=1)
    return np.asarray(np.where(seen_from_below, -1.0, 1.0)[mesh.pieces])
