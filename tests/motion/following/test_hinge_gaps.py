"""Rigid panels that part least at hinges, against motions that close and a solver of its own."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

from orishell.motion.crease_pattern import CreasePattern
from orishell.motion.following import follow
from orishell.motion.following.hinge_gaps import Parted, RigidPanels
from orishell.motion.following.placing import Placing
from orishell.numerics.arrays import Array
from patterns import jittered, miura, shuffled


def half_folded(pattern: CreasePattern) -> tuple[Array, int]:
    """Fold angles at 90 degrees, nearly closed, and the number of the crease that has these."""
    folds = follow(pattern, largest=np.pi / 2, states=2, tolerance=1e-2).folds[1]
    return folds, int(np.abs(folds).argmax())


def placed(pattern: CreasePattern, folds: Array, held: int) -> Parted:
    state = RigidPanels(pattern).placed(folds, held)
    assert state is not None
    return state


def test_a_sheet_that_folds_has_no_gap() -> None:
    """Rounding: 1e-13 of edges about 1 long, 30 times what was seen."""
    pattern = shuffled(miura())
    folds, held = half_folded(pattern)
    state = placed(pattern, folds, held)
    assert state.gap < 1e-13
    positions, _ = Placing(pattern).placed(folds)
    apart, asked = (
        np.linalg.norm(each - each[::-1], axis=-1)
        for each in (
            state.places[state.joints].reshape(-1, 3),
            positions[pattern.faces].reshape(-1, 3),
        )
    )
    np.testing.assert_allclose(apart, asked, rtol=0, atol=1e-12)


def test_the_gap_is_in_proportion_to_how_far_vertices_are_off() -> None:
    """To first order: what a thousandfold jitter adds to it is of second order, a per cent."""
    folds, held = half_folded(miura())
    gaps = [placed(jittered(miura(), size), folds, held).gap for size in (1e-6, 1e-3)]
    assert gaps[0] > 1e-8
    assert gaps[1] / gaps[0] == pytest.approx(1e3, rel=0.02)


def test_no_other_poses_part_less() -> None:
    """Poses of all panels, by a dense solver that knows no joints and starts elsewhere."""
    pattern = jittered(miura(3, 3), 1e-2)
    folds, held = half_folded(miura(3, 3))
    state = placed(pattern, folds, held)
    flat = np.column_stack([pattern.vertices, np.zeros(len(pattern.vertices))])
    two, faces = pattern.edge_faces[held], pattern.faces
    others = np.setdiff1d(np.arange(len(faces)), two)
    placing = Placing(pattern)
    poses = placing.beside(placing.poses(folds), held, float(folds[held]))
    rng = np.random.default_rng(0)

    def corners(moves: Array) -> Array:
        found = poses.carried(np.arange(len(faces)), flat[faces])
        move = moves.reshape(-1, 6)
        turns = Rotation.from_rotvec(move[:, :3]).as_matrix()
        found[others] = np.einsum("kij,kcj->kci", turns, found[others]) + move[:, None, 3:]
        return found

    def off(moves: Array) -> Array:
        found = corners(moves)
        means = np.stack([found[faces == v].mean(axis=0) for v in range(len(flat))])
        for panel in two:  # joints of the panels that are held stay there
            means[faces[panel]] = found[panel]
        return np.asarray((found - means[faces]).ravel())

    best = least_squares(
        off, rng.normal(0, 0.01, 6 * len(others)), xtol=1e-15, ftol=1e-15, gtol=1e-15
    )
    np.testing.assert_allclose(state.corners, corners(best.x), atol=1e-5 * state.gap + 1e-7)
    left, right = pattern.edge_faces[pattern.crease].T
    found, gap = corners(best.x), 0.0
    for edge, a, b in zip(pattern.edges[pattern.crease], left, right, strict=True):
        for end in edge:
            apart = found[a][faces[a] == end] - found[b][faces[b] == end]
            gap = max(gap, float(np.linalg.norm(apart)))
    assert state.gap == pytest.approx(gap, rel=1e-3)
    assert state.gap > 1e-3
