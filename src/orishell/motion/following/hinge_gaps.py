"""States of a sheet that does not close: rigid panels, placed so that they part least at hinges.

Derived in docs/theory/following.md.
"""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.record import record
from orishell.motion.crease_pattern import CreasePattern
from orishell.motion.following.correcting import REGULARISATION
from orishell.motion.following.placing import Placing
from orishell.motion.quads import lengths
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.numerics.components import find_components

if TYPE_CHECKING:
    from scipy.sparse import csc_array
    from scipy.sparse.linalg import SuperLU

STEPS = 30
"""Steps of Gauss and Newton until a state counts as one that is not found."""
STILL = 1e-8
"""A state is found when a step reduces the sum of squares by no more than this share of it."""
NEAR = 0.5
"""A step that reduces it by less, to more than this share, is followed by one with the same
factors."""
COORDINATE_ROUNDING = 64 * np.finfo(float).eps
"""What the last digits of coordinates may leave, relative to the size of the sheet."""


@record
class Parted:
    """Rigid panels in one state, and by how much they part at hinges."""

    corners: Array  # places (F, K, 3) of the corners of every panel, as it holds them
    places: Array  # of joints (J, 3): means of the corners that they join
    joints: Integers  # number (F, K) of the joint of every corner
    gaps: Array  # distances (E,) between ends of a crease as its two panels hold them, the larger

    @property
    def gap(self) -> float:
        """The largest of them (length)."""
        return float(self.gaps.max(initial=0.0))


@record
class RigidPanels:
    """Panels of a pattern as rigid bodies, joined at the ends of creases.

    Corners are of one joint if creases tie them together there: cuts stay open.
    """

    pattern: CreasePattern

    @cached_property
    def placing(self) -> Placing:
        """How panels hang on each other."""
        return Placing(self.pattern)

    @cached_property
    def _there(self) -> Booleans:
        """Which corners (F, K) there are."""
        return np.asarray(self.pattern.faces >= 0)

    @cached_property
    def _flat(self) -> Array:
        """Corners (F, K, 3) of the flat sheet about the mean of their panel; 0 behind the last."""
        flat = self.pattern.vertices[self.pattern.faces]
        flat = np.concatenate([flat, np.zeros((*flat.shape[:2], 1))], axis=-1)
        return self._centred(flat)[0]

    @cached_property
    def _ends(self) -> Integers:
        """Corners (2, 2, C), counted over all F K: of both panels at both ends of creases."""
        pattern = self.pattern
        edges, panels = pattern.edges[pattern.crease], pattern.edge_faces[pattern.crease]
        at = pattern.faces[panels][:, :, None] == edges[:, None, :, None]
        place = panels[..., None] * pattern.faces.shape[1] + at.argmax(axis=-1)
        return np.moveaxis(place, 0, -1)

    @cached_property
    def _joints(self) -> Integers:
        """Number (F, K) of the joint of every corner; alone behind the last."""
        size = self._there.size
        return find_components(self._ends.reshape(2, -1).T, size).reshape(self._there.shape)

    def _centred(self, points: Array) -> tuple[Array, Array]:
        """Corners (F, K, 3) about their means (F, 1, 3)."""
        there = self._there[..., None]
        points = np.where(there, points, 0.0)
        means = points.sum(axis=1, keepdims=True) / there.sum(axis=1, keepdims=True)
        return np.where(there, points - means, 0.0), means

    def _sums(self, values: Array) -> Array:
        """Sums (J, 3) over the corners of every joint of values (F, K, 3)."""
        joints = self._joints.ravel()
        return np.stack([np.bincount(joints, each) for each in values.reshape(-1, 3).T], axis=-1)

    def _means(self, values: Array) -> Array:
        """The means (J, 3) of the same."""
        return self._sums(values) / np.bincount(self._joints.ravel())[:, None]

    def fitted(self, points: Array) -> Array:
        """Corners (F, K, 3) of rigid panels nearest to points."""
        own, means = self._centred(points)
        u, _, v = np.linalg.svd(np.einsum("fki,fkj->fij", own, self._flat))
        u[..., 2] *= np.linalg.det(u @ v)[:, None]
        return np.asarray(np.where(self._there[..., None], self._flat @ (u @ v).mT + means, 0.0))

    def _stiffness(self, corners: Array) -> csc_array:
        """What moves of joints (3 J, 3 J) do to distances from rigid panels at these corners."""
        from scipy.sparse import coo_array, eye_array

        own, _ = self._centred(corners)
        panels, most = self._there.shape
        levers = np.moveaxis(np.cross(np.eye(3)[:, None, None], own), 0, 1)
        levers = levers.reshape(panels, 3, 3 * most)  # moves of corners by unit turns
        turned = levers.mT @ np.linalg.solve(levers @ levers.mT, levers)
        blocks = self._unshifted - turned
        size = 3 * (int(self._joints.max()) + 1)
        matrix = coo_array((blocks.ravel(), self._entries), shape=(size, size)).tocsc()
        return matrix + REGULARISATION * eye_array(size, format="csc")

    @cached_property
    def _unshifted(self) -> Array:
        """What is left (F, 3 K, 3 K) of moves of corners without those of all by the same."""
        there = self._there.astype(np.float64)
        alike = there[:, :, None] * there[:, None] / there.sum(axis=1)[:, None, None]
        left = np.eye(there.shape[1]) * there[:, None] - alike
        return np.kron(left, np.eye(3))

    @cached_property
    def _entries(self) -> tuple[Integers, Integers]:
        """Rows and columns of the entries of :meth:`_stiffness`, by panels."""
        numbers = (3 * self._joints[..., None] + np.arange(3)).reshape(len(self._joints), -1)
        shape = (*numbers.shape, numbers.shape[1])
        rows, columns = numbers[:, :, None], numbers[:, None]
        return np.broadcast_to(rows, shape).ravel(), np.broadcast_to(columns, shape).ravel()

    def placed(self, folds: Array, held: int) -> Parted | None:
        """The state near fold angles (E,) whose panels part least; None if none is found.

        The sum over all corners of squared distances from the mean of those joined there is least,
        while the two panels beside one crease stay where they are.

        Parameters
        ----------
        folds
            Fold angles of all edges, valley positive (radians).
        held
            Number of the crease that keeps its fold angle.
        """
        there = self._there[..., None]
        poses = self.placing.beside(self.placing.poses(folds), held, float(folds[held]))
        flat = self.placing.flat[self.pattern.faces]
        corners = np.where(there, poses.carried(np.arange(len(flat)), flat), 0.0)
        two = self.pattern.edge_faces[held]
        fixed = self._joints[two][self._there[two]]
        free = np.ones((int(self._joints.max()) + 1, 3), np.bool_)
        free[fixed] = free[self._joints[~self._there]] = False
        places = self._means(corners)
        places[fixed] = corners[two][self._there[two]]
        rounding = self._there.sum() * (COORDINATE_ROUNDING * float(np.abs(self._flat).max())) ** 2
        before, factors = np.inf, None
        for _ in range(STEPS):
            points = places[self._joints]
            corners = self.fitted(points)
            off = np.where(there, points - corners, 0.0)
            parted = float((off**2).sum())
            if before - parted <= STILL * parted or parted <= rounding:
                return self._parted(corners, places)
            if factors is None or parted < NEAR * before:
                factors = self._factors(corners, free.ravel())
            before = parted
            places[free] -= factors.solve(self._sums(off)[free])
        return None

    def _factors(self, corners: Array, free: Booleans) -> SuperLU:
        """Of the stiffness for some coordinates of joints (3 J,)."""
        from scipy.sparse.linalg import splu

        return splu(
            self._stiffness(corners)[free][:, free],
            permc_spec="MMD_AT_PLUS_A",
            diag_pivot_thresh=0.0,
            options={"SymmetricMode": True},
        )

    def _parted(self, corners: Array, places: Array) -> Parted:
        first, second = corners.reshape(-1, 3)[self._ends]
        gaps = np.zeros(len(self.pattern.edges))
        gaps[self.pattern.crease] = lengths(first - second).max(axis=0)
        return Parted(corners, places, self._joints, gaps)
