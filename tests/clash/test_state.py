"""Contacts in one state, against libigl's exact predicates and against states known by hand."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from brute_force import exact_contacts
from orishell.clash import find_contacts
from orishell.design_file import read_design_file
from orishell.motion.grid import Grid
from planted import PLANTED

EXAMPLES = Path(__file__).parents[2] / "examples"


def apart(pairs: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """The pairs that have no vertex in common."""
    shared = (faces[pairs[:, 0]][:, :, None] == faces[pairs[:, 1]][:, None]).any(axis=(1, 2))
    return np.asarray(pairs[~shared])


@pytest.mark.parametrize("name", PLANTED)
def test_the_pairs_are_those_that_exact_predicates_find(name: str) -> None:
    # Beyond its first contact a planted shell runs through itself: dozens of pairs cross.
    mechanism = PLANTED[name]().mechanism
    faces = mechanism.grid.faces_vertices()
    for drive in np.linspace(0, 0.99 * np.pi, 12):
        points = mechanism.positions(drive).reshape(-1, 3)
        found = apart(find_contacts(points, faces, 1e-13), faces)
        np.testing.assert_array_equal(found, exact_contacts(points, faces))


@pytest.mark.parametrize("name", PLANTED)
def test_shuffled_panels_touch_all_the_same(name: str) -> None:
    mechanism = PLANTED[name]().mechanism
    faces = mechanism.grid.faces_vertices()
    order = np.random.default_rng(1).permutation(len(faces))
    points = mechanism.positions(0.99 * np.pi).reshape(-1, 3)
    found = find_contacts(points, faces[order], 1e-12)
    expected = find_contacts(points, faces, 1e-12)
    assert {frozenset(pair) for pair in order[found].tolist()} == {
        frozenset(pair) for pair in expected.tolist()
    }


def test_the_figures_touch_at_lock_at_their_flaps_only() -> None:
    for figure in ("figure1", "figure2"):
        file = read_design_file(EXAMPLES / f"{figure}.toml")
        mechanism = file.pattern.design(file.f, file.g).mechanism
        faces = mechanism.grid.faces_vertices()
        locked = mechanism.positions(np.pi).reshape(-1, 3)
        pairs = find_contacts(locked, faces, 1e-9)
        last = mechanism.grid.columns - 2
        flaps = np.isin(pairs % (last + 1), (0, last)).any(axis=1)
        assert len(pairs)
        assert flaps.all()
        rows = mechanism.grid.rows - 1
        folded = {
            (i * (last + 1) + j, (i + 1) * (last + 1) + j)
            for i in range(rows - 1)
            for j in (0, last)
        }
        assert folded <= set(map(tuple, pairs.tolist()))


def strip(angle: float) -> tuple[np.ndarray, np.ndarray]:
    """Two panels that share a crease along y, folded by an angle (radians)."""
    grid = Grid(2, 3)
    x = np.array([-1.0, 0.0, -np.cos(np.pi - angle)])
    z = np.array([0.0, 0.0, np.sin(np.pi - angle)])
    points = np.zeros((2, 3, 3))
    points[..., 0], points[..., 2] = x, z
    points[1, :, 1] = -1.0
    return points.reshape(-1, 3), grid.faces_vertices()


@pytest.mark.parametrize(("angle", "touching"), [(0, 0), (1, 0), (3.0, 0), (np.pi, 1)])
def test_neighbours_touch_when_their_crease_is_folded_flat(angle: float, touching: int) -> None:
    assert len(find_contacts(*strip(angle), 1e-9)) == touching


def test_opposite_panels_that_cross_at_their_vertex_are_found() -> None:
    # Two squares with one corner in common, upright and lying; the upright one stands on the
    # lying one's diagonal, then beyond its edge.
    lying = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)
    for turn, crossing in ((np.pi / 4, True), (-np.pi / 4, False)):
        out = np.array([np.cos(turn), np.sin(turn), 0])
        up = np.array([0, 0, 1.0])
        upright = np.stack([out + up, 2 * out, out - up])
        points = np.concatenate([lying, upright])
        faces = np.array([[0, 1, 2, 3], [0, 6, 5, 4]])
        assert (len(find_contacts(points, faces, 1e-9)) == 1) == crossing


def test_the_tolerance_decides_on_panels_that_are_near() -> None:
    square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)
    points = np.concatenate([square, square + np.array([0.3, 0.2, 1e-6])])
    faces = np.arange(8).reshape(2, 4)
    assert len(find_contacts(points, faces, 2e-6)) == 1
    assert len(find_contacts(points, faces, 0.5e-6)) == 0


def test_one_panel_alone_touches_nothing() -> None:
    points = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)
    assert find_contacts(points, np.array([[0, 1, 2, 3]]), 1e-9).shape == (0, 2)
