"""Degrees of freedom of the folded states of a file."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from orishell.io import FoldFile, FoldFrame
from orishell.motion.crease_pattern import CreasePattern
from orishell.motion.following.dofs import Freedom, find_freedom
from orishell.motion.following.followed import FREEDOM_AT
from orishell.motion.following.system import Closure
from orishell.motion.mesh import measure_mesh_folds
from orishell.motion.quads import area_vectors, units
from orishell.numerics.arrays import Array
from orishell.verification.sheet import Sheet


def freedom_of_frames(
    file: FoldFile, sheet: Sheet, folded: Iterable[tuple[float, FoldFrame]]
) -> tuple[Freedom, ...]:
    """Degrees of freedom in some frames; none where there is no flat sheet that lies in a plane.

    folded: The largest fold angle of every folded frame (radians), and the frame.
    """
    listed = sorted(folded, key=lambda each: each[0])
    flat = _in_plane(sheet)
    if flat is None or not listed:
        return ()
    mesh = sheet.mesh
    letters = np.array(file.assignment or ["U"] * len(mesh.edges))
    pattern = CreasePattern(flat, mesh.edges, letters, mesh.loops, mesh.edge_faces)
    closure = Closure.of(pattern)
    angles = np.array([angle for angle, _ in listed])
    # Those in the middle of the motion: at its ends creases may be folded flat.
    some = {int(np.abs(angles - share * angles[-1]).argmin()) for share in FREEDOM_AT}
    return tuple(
        find_freedom(closure, measure_mesh_folds(mesh, listed[each][1].positions)[closure.edges])
        for each in sorted(some)
    )


def _in_plane(sheet: Sheet) -> Array | None:
    """The flat sheet (V, 2) as seen from where its panels go counter-clockwise; None if bent."""
    if not sheet.flat:
        return None
    points = sheet.frame.positions
    areas = area_vectors(points[sheet.mesh.faces])
    normal = units(areas.sum(axis=0))
    if (areas @ normal <= 0).any():  # pieces that are turned over
        return None
    first = points[sheet.mesh.faces[0]]
    along = units(first[1] - first[0])
    across = np.cross(normal, along)
    flat = (points - first[0]) @ np.stack([along, across, normal], axis=1)
    used = np.unique(sheet.mesh.faces)
    return None if np.abs(flat[used, 2]).max() > sheet.tolerance else flat[:, :2]
