"""Sheets cut with errors by another way: true motions of rigid panels, without linearising.

Panels are placed by turns of any size, and the sum of squares of all gaps at ends of hinges is
made least by SciPy.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

from orishell.motion import Mechanism
from orishell.motion.layout import Layout, edge_folds, points_of
from orishell.motion.quads import units
from orishell.numerics.arrays import Array, Integers

STEP = 1e-6
"""Of differences, in sizes of panels: what they are wrong by is as small."""
LOOSE = 1e-9
"""Added to normal equations of variables, so that they can be inverted."""


@dataclass(eq=False)
class RigidPanels:
    """Panels (P) of a sheet without flaps at its target."""

    mechanism: Mechanism
    beside: Integers = field(init=False)  # panels (2, E) beside all ends of hinges
    at: Integers = field(init=False)  # their corners there

    def __post_init__(self) -> None:
        mesh, target = Layout.of(self.mechanism).mesh, self.mechanism.target_drive
        hinges, beside = mesh.edges[mesh.crease], mesh.edge_faces[mesh.crease]
        self.beside, ends = np.tile(beside.T, 2), hinges.T.ravel()
        self.at = np.stack([(mesh.faces[p] == ends[:, None]).argmax(axis=1) for p in self.beside])
        self.flat = points_of(self.mechanism, 0.0)[mesh.faces]
        placed = points_of(self.mechanism, target)[mesh.faces]
        self.centres, self.middles = placed.mean(axis=1), self.flat.mean(axis=1)
        self.start = np.stack(
            [
                Rotation.align_vectors(there, here)[0].as_matrix()
                for here, there in zip(
                    self.flat - self.middles[:, None], placed - self.centres[:, None], strict=True
                )
            ]
        )
        self.size = float(np.abs(placed - self.centres[:, None]).max())
        folds = [edge_folds(self.mechanism, drive)[mesh.crease] for drive in (0.9 * target, target)]
        drive = int(np.abs(folds[1] - folds[0]).argmax())
        axis = units(np.diff(points_of(self.mechanism, target)[hinges[drive]], axis=0))[0]
        # What is held: the first panel, and the fold angle of a hinge.
        self.held = np.zeros((7, 6 * len(placed)))
        self.held[:6, :6] = np.eye(6)
        for panel, sign in zip(beside[drive], (-1.0, 1.0), strict=True):
            self.held[6, 6 * panel + 3 : 6 * panel + 6] = sign * axis
        # Variables by which gaps change at nearly the same rate.
        rates = self._rates(np.zeros(6 * len(placed)), np.zeros((len(placed), 4, 2)))
        root = np.linalg.cholesky(rates.T @ rates + LOOSE * np.eye(rates.shape[1]))
        self.variables = np.linalg.inv(root).T

    def corners(self, moves: Array, errors: Array) -> Array:
        """Places (P, 4, 3) of corners cut with errors (P, 4, 2), panels moved by moves (6 P,)."""
        shifts, turns = moves.reshape(-1, 2, 3).swapaxes(0, 1)
        turned = Rotation.from_rotvec(turns / self.size).as_matrix() @ self.start
        own = self.flat - self.middles[:, None] + np.pad(errors, ((0, 0), (0, 0), (0, 1)))
        return np.asarray(own @ turned.mT + (self.centres + shifts)[:, None])

    def gaps(self, corners: Array) -> Array:
        """Gaps (E, 3) at all ends of hinges."""
        left, right = (corners[p, k] for p, k in zip(self.beside, self.at, strict=True))
        return np.asarray(left - right)

    def _left(self, moves: Array, errors: Array) -> Array:
        return np.concatenate([self.gaps(self.corners(moves, errors)).ravel(), self.held @ moves])

    def _rates(self, moves: Array, errors: Array) -> Array:
        """Differences of what is made least: all panels are moved at once, each in one way."""
        rates = np.zeros((3 * self.at.shape[1], len(moves)))
        before, row = self.corners(moves, errors), np.arange(self.at.shape[1])
        step = STEP * self.size
        for way in range(6):
            moved = moves.copy()
            moved[way::6] += step
            slope = (self.corners(moved, errors) - before) / step
            for panels, corner, sign in zip(self.beside, self.at, (1.0, -1.0), strict=True):
                for axis in range(3):
                    rates[3 * row + axis, 6 * panels + way] = sign * slope[panels, corner, axis]
        return np.vstack([rates, self.held])

    def least(self, errors: Array) -> Array:
        """Places (P, 4, 3) of corners with errors (P, 4, 2) whose gaps are least."""

        def left(x: Array) -> Array:
            return self._left(self.variables @ x, errors)

        def rates(x: Array) -> Array:
            return np.asarray(self._rates(self.variables @ x, errors) @ self.variables)

        found = least_squares(
            left,
            np.zeros(len(self.variables)),
            rates,
            tr_solver="lsmr",
            x_scale=1.0,
            ftol=1e-10,
            xtol=1e-12,
            gtol=1e-14,
        )
        assert found.success
        return self.corners(self.variables @ found.x, errors)
