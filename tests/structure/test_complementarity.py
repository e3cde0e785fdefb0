"""Complementarity problems against all sets of variables that could be the ones above zero."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from orishell.numerics.arrays import Array
from orishell.structure.complementarity import solve_complementarity

SEEDS = st.integers(0, 10**6)
SIZES = st.integers(1, 8)


def tried(matrix: Array, vector: Array) -> list[Array]:
    """Solutions z (n,) of all active sets whose equations have one."""
    found = []
    for active in map(np.array, product([False, True], repeat=len(vector))):
        z = np.zeros(len(vector))
        z[active] = np.linalg.solve(matrix[np.ix_(active, active)], -vector[active])
        if z.min() >= -1e-10 and (matrix @ z + vector).min() >= -1e-10:
            found.append(z)
    return found


def assert_solves(matrix: Array, vector: Array, z: Array) -> None:
    w, scale = matrix @ z + vector, np.abs(vector).max()
    assert z.min() >= -1e-9 * scale
    assert w.min() >= -1e-9 * scale
    assert abs(w @ z) <= 1e-9 * scale * max(np.abs(z).max(), 1.0)


@given(SEEDS, SIZES)
def test_a_positive_definite_problem_has_the_one_solution_of_all_sets(seed: int, size: int) -> None:
    random = np.random.default_rng(seed)
    root = random.standard_normal((size, size))
    matrix, vector = root @ root.T + 0.1 * np.eye(size), random.standard_normal(size)
    (expected, *_) = tried(matrix, vector)
    found = solve_complementarity(matrix, vector)
    assert found is not None
    np.testing.assert_allclose(found, expected, atol=1e-8)


@given(SEEDS, st.integers(1, 4))
def test_what_is_twice_alike_is_solved(seed: int, half: int) -> None:
    """Every row twice, as of a symmetric shell: all ratios tie, and the matrix is singular."""
    random = np.random.default_rng(seed)
    root = random.standard_normal((half, half))
    matrix = np.tile(root @ root.T + 0.1 * np.eye(half), (2, 2))
    vector = np.tile(random.standard_normal(half), 2)
    found = solve_complementarity(matrix, vector)
    assert found is not None
    assert_solves(matrix, vector, found)


@given(SEEDS, SIZES)
def test_more_pivots_than_a_table_is_kept_for(seed: int, size: int) -> None:
    random = np.random.default_rng(seed)
    root = random.standard_normal((8 * size, 8 * size))
    matrix, vector = root @ root.T + 0.1 * np.eye(8 * size), random.standard_normal(8 * size)
    found = solve_complementarity(matrix, vector)
    assert found is not None
    assert_solves(matrix, vector, found)


@pytest.mark.parametrize(
    ("matrix", "vector"),
    [
        # w = -1 whatever z is.
        ([[0.0]], [-1.0]),
        # A semi-definite one: w_1 = z_1 - z_2 - 1, w_2 = -w_1 - 2, never both above zero.
        ([[1.0, -1.0], [-1.0, 1.0]], [-1.0, -1.0]),
    ],
)
def test_no_solution_is_none(matrix: list[list[float]], vector: list[float]) -> None:
    assert solve_complementarity(np.array(matrix), np.array(vector)) is None


def test_nothing_to_do() -> None:
    np.testing.assert_array_equal(solve_complementarity(np.eye(2), np.array([0.0, 1.0])), [0, 0])
