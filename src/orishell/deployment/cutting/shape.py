"""Where vertices of a shell lie whose panels share out what they are cut wrong by."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.record import record
from orishell.deployment.cutting.gaps import Fit
from orishell.motion.quads import lengths
from orishell.numerics.arrays import Array, Integers

if TYPE_CHECKING:
    from scipy.sparse import csr_array


@record
class Shape:
    """Vertices of a shell, placed and opened so that they are nearest to their places as designed.

    A vertex lies at the mean of the corners that panels have there.
    """

    vertices: Integers  # (N,)
    by_errors: csr_array  # how errors of corners (2 F K) move them (3 N)
    by_motions: csr_array  # how motions of panels do
    # orthonormal (3 N, 7): moves of the whole, and by folding it as designed
    placing: Array
    folding: Array  # the motion of panels that folds the drive's hinge by 1 more (n,)
    folded: Array  # moves (3 N,) by that, without those of the whole
    reach: float  # its root mean square over vertices (length per radian)

    @classmethod
    def of(cls, fit: Fit) -> Shape:
        """That of a sheet."""
        from scipy.sparse import csr_array, kron

        sheet = fit.sheet
        panels, place = np.nonzero((sheet.loops >= 0) & ~sheet.flaps[:, None])
        vertices, number, count = np.unique(
            sheet.loops[panels, place], return_inverse=True, return_counts=True
        )
        entries = (1 / count[number], (number, np.arange(len(number))))
        mean = kron(csr_array(entries, shape=(len(vertices), len(number))), np.eye(3))
        at = vertices[number]
        by_motions = csr_array(mean @ sheet.by_motions(panels, at))
        points = sheet.placed[vertices] - sheet.placed[vertices].mean(axis=0)
        turns = np.cross(np.eye(3)[:, None], points).reshape(3, -1).T
        whole = np.linalg.qr(np.hstack([np.tile(np.eye(3), (len(points), 1)), turns]))[0]
        folding = fit.folding
        folded = by_motions @ folding
        folded -= whole @ (whole.T @ folded)
        length = float(np.linalg.norm(folded))
        return cls(
            vertices,
            csr_array(mean @ sheet.by_errors(panels, at)),
            by_motions,
            np.hstack([whole, folded[:, None] / length]),
            folding,
            folded,
            length / np.sqrt(len(points)),
        )

    def moved(self, motions: Array, errors: Array) -> tuple[Array, Array]:
        """How far vertices (N, S) are from their places, by motions (n, S) and errors (2 F K, S).

        Returns
        -------
        tuple
            Distances (length), and by how much the drive's hinge is folded more than as designed
            where they are least, measured from where it keeps its angle (S,) (radians).
        """
        moved = self.by_motions @ motions + self.by_errors @ errors
        parts = self.placing.T @ moved
        moved -= self.placing @ parts
        more = -parts[-1] / np.linalg.norm(self.folded)
        return lengths(np.moveaxis(moved.reshape(len(self.vertices), 3, -1), 1, -1)), more
