"""Rigid panels of a sheet in one state, and the errors with which their corners are cut."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.record import record
from orishell.motion.layout import Layout, edge_folds, points_of
from orishell.motion.mechanism import Mechanism
from orishell.motion.mesh import QuadMesh
from orishell.motion.quads import dots, unit_normals, units
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.workshop.settings import Cutting

if TYPE_CHECKING:
    from scipy.sparse import csr_array

ON = 1e-6
"""Corners on a side of a panel may be off it by this share of its length."""
BEFORE = 0.9
"""The hinge whose fold angle changes most from this share of the drive on tells the drive."""


@record
class CutSheet:
    """Panels of a sheet in one state, cut with errors.

    Flaps are no panels of the shell: folded flat they are at a dead point, where to first order
    their hinges leave them loose.
    """

    mesh: QuadMesh
    flaps: Booleans  # which panels (F,) are flaps
    flat: Array  # vertices (V, 2) of the flat sheet
    placed: Array  # vertices (V, 3) in the state
    drive_edge: int  # the hinge, by its edge, of the shell whose fold angle tells the drive

    @classmethod
    def of(cls, mechanism: Mechanism, drive: float) -> CutSheet:
        """That of a mechanism at a drive (radians)."""
        layout = Layout.of(mechanism)
        mesh, flaps = layout.mesh, layout.flaps
        moved = np.abs(edge_folds(mechanism, drive) - edge_folds(mechanism, BEFORE * drive))
        joined = _joining(mesh, ~flaps)
        placed, flat = points_of(mechanism, drive), points_of(mechanism, 0.0)[:, :2]
        return cls(mesh, flaps, flat, placed, int(joined[moved[joined].argmax()]))

    @cached_property
    def panels(self) -> Integers:
        """Numbers (P,) of the panels of the shell."""
        return np.flatnonzero(~self.flaps)

    @cached_property
    def hinges(self) -> Integers:
        """Numbers (H,) of the edges that are hinges of the shell."""
        return _joining(self.mesh, ~self.flaps)

    @cached_property
    def beside(self) -> Integers:
        """Places in ``panels`` (2 H, 2) of those to the left and to the right of ends of hinges.

        All first ends come first, then all second ones.
        """
        return np.tile(self._places[self.mesh.edge_faces[self.hinges]], (2, 1))

    @cached_property
    def _places(self) -> Integers:
        """Places (F,) of panels of the shell in ``panels``."""
        return np.cumsum(~self.flaps) - 1

    @cached_property
    def ends(self) -> Integers:
        """Vertices (2 H,) at which hinges end, in the same order."""
        return self.mesh.edges[self.hinges].T.ravel()

    @cached_property
    def axes(self) -> Array:
        """Unit vectors (2 H, 3) along the hinges, in the same order."""
        first, second = self.placed[self.ends].reshape(2, -1, 3)
        return np.tile(units(second - first), (2, 1))

    @cached_property
    def frames(self) -> Array:
        """What turns vectors of the flat sheet into space with every panel (F, 3, 2)."""
        across, flat = (
            each[self.mesh.faces[:, 2:]] - each[self.mesh.faces[:, :2]]
            for each in (self.placed, self.flat)
        )
        return np.asarray(np.linalg.solve(flat, across).mT)

    @cached_property
    def centres(self) -> Array:
        """Means (F, 3) of the corners of panels."""
        return np.asarray(self.placed[self.mesh.faces].mean(axis=1))

    @cached_property
    def size(self) -> float:
        """How far corners are from the centre of their panel, on the mean of squares (length)."""
        arms = self.placed[self.mesh.faces] - self.centres[:, None]
        return float(np.sqrt(dots(arms, arms).mean()))

    @property
    def loops(self) -> Integers:
        """Vertices (F, K) around every panel, -1 behind the last: its corners, as errors have."""
        return self.mesh.loops

    def corner(self, panels: Integers, vertices: Integers) -> Integers:
        """Numbers (...) of the corners of panels (...) at vertices (...), counted over F K."""
        at = (self.loops[panels] == vertices[..., None]).argmax(axis=-1)
        return np.asarray(panels * self.loops.shape[1] + at)

    def spread(self, kind: Cutting) -> csr_array:
        """Errors (2 F K) of all corners from independent ones: of corners, or of vertices (2 V)."""
        from scipy.sparse import csr_array, eye_array, kron

        if kind == "boards":
            return csr_array(eye_array(2 * self.loops.size))
        there = np.flatnonzero(self.loops.ravel() >= 0)
        entries = (np.ones(len(there)), (there, self.loops.ravel()[there]))
        shape = (self.loops.size, self.mesh.vertex_count)
        return csr_array(kron(csr_array(entries, shape=shape), np.eye(2)))

    def by_errors(self, panels: Integers, vertices: Integers) -> csr_array:
        """How errors (2 F K) move what panels (N,) hold at vertices (N,): rows (3 N)."""
        corners = 2 * self.corner(panels, vertices)[:, None] + np.arange(2)
        return _in_rows(self.frames[panels], corners, 2 * self.loops.size)

    def by_motions(self, panels: Integers, vertices: Integers, each: int = 6) -> csr_array:
        """How motions of the shell's panels move the same: shift, turn, and twist if there is one.

        Turns are by ``size``, so that all are lengths; ``each`` is the number of motions of a
        panel, 6, or 7 with the twist.
        """
        count = len(panels)
        arms = (self.placed[vertices] - self.centres[panels]) / self.size
        shifts = np.broadcast_to(np.eye(3), (count, 3, 3))
        parts = [shifts, np.cross(np.eye(3), arms[:, None]).mT]
        if each > 6:
            normals = unit_normals(self.placed[self.mesh.faces[panels]])
            heights = self._heights[self.corner(panels, vertices)]
            parts.append((heights[:, None] * normals)[..., None])
        columns = each * self._places[panels][:, None] + np.arange(each)
        return _in_rows(np.concatenate(parts, axis=-1), columns, each * len(self.panels))

    @cached_property
    def opened(self) -> csr_array:
        """How errors of corners (2 F K) open ends of hinges (6 H): g_0 by e."""
        from scipy.sparse import csr_array

        left, right = self.panels[self.beside].T
        return csr_array(self.by_errors(left, self.ends) - self.by_errors(right, self.ends))

    @cached_property
    def offset(self) -> Array:
        """Moves (2 F K,) of corners if all sides of panels are moved inwards by 1."""
        around = self.flat[self.loops]
        there = self.loops >= 0
        last = there.sum(axis=1) - 1
        place = np.arange(self.loops.shape[1])[None]
        after = np.where(place < last[:, None], place + 1, 0)
        before = np.where(place > 0, place - 1, last[:, None])
        along, came = (
            units(np.pad(vectors, ((0, 0), (0, 0), (0, 1))))[..., :2]
            for vectors in (
                np.take_along_axis(around, after[..., None], axis=1) - around,
                around - np.take_along_axis(around, before[..., None], axis=1),
            )
        )
        # Where two sides meet, moved inwards: (n + m)/(1 + n.m) with their normals n and m.
        inward = np.stack([-(along + came)[..., 1], (along + came)[..., 0]], axis=-1)
        moved = inward / (1 + (along * came).sum(axis=-1))[..., None]
        return np.where(there[..., None], moved, 0.0).ravel()

    @cached_property
    def _heights(self) -> Array:
        """How high every corner (F K,) of a board twisted by 1 stands; straight along its sides."""
        faces, at = self.mesh.faces, self.flat[self.loops]
        found = np.zeros(self.loops.shape)
        for k, up in enumerate((1.0, -1.0, 1.0, -1.0)):
            start, end = self.flat[faces[:, k]], self.flat[faces[:, (k + 1) % 4]]
            along, beyond = (end - start)[:, None], at - start[:, None]
            squared = (along**2).sum(axis=-1)
            share = (beyond * along).sum(axis=-1) / squared
            off = ((beyond - share[..., None] * along) ** 2).sum(axis=-1)
            on = (off <= ON**2 * squared) & (np.abs(share - 0.5) <= 0.5 + ON)
            found = np.where(on, up * (1 - 2 * share), found)
        return found.ravel()


def _in_rows(blocks: Array, columns: Integers, size: int) -> csr_array:
    """Blocks (N, 3, k) in these columns (N, k), row under row."""
    from scipy.sparse import csr_array

    count, _, each = blocks.shape
    wide = np.broadcast_to(columns[:, None], blocks.shape).ravel()
    starts = each * np.arange(3 * count + 1)
    return csr_array((blocks.ravel(), wide, starts), shape=(3 * count, size))


def _joining(mesh: QuadMesh, shell: Booleans) -> Integers:
    """Numbers (H,) of the edges that join two panels of the shell, by which panels (F,) are."""
    both = shell[mesh.edge_faces].all(axis=1)
    return np.flatnonzero(mesh.crease & both)
