"""Factorisation by levels, against dense inverses of NumPy."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.sparse import csr_array, kron

from orishell.numerics.levels import Blocks, Levels
from samples import examples

ROUNDING = 1e-11
"""A thousand times what was seen of matrices with a condition of up to 100."""


@settings(max_examples=examples(60), deadline=None)
@given(st.integers(2, 14), st.integers(0, 20), st.integers(1, 3), st.integers(0, 2**32 - 1))
def test_it_solves_and_knows_the_inverse(count: int, edges: int, each: int, seed: int) -> None:
    """Of any graph, also in several pieces; the trace for couplings over one edge and over two."""
    rng = np.random.default_rng(seed)
    pairs = rng.integers(0, count, (edges, 2))
    graph = np.eye(count)
    graph[pairs[:, 0], pairs[:, 1]] = 1
    graph = np.maximum(graph, graph.T)
    pattern = kron(csr_array(graph), np.ones((each, each))).toarray()
    half = rng.uniform(-1, 1, pattern.shape) * pattern
    matrix = half + half.T
    matrix += np.diag(1 + np.abs(matrix).sum(axis=1))
    blocks = Blocks.of(csr_array(matrix), Levels.of(pairs, count))
    loads = rng.standard_normal((len(matrix), 3))
    inverse = np.linalg.inv(matrix)
    assert np.abs(blocks.solve(loads) - inverse @ loads).max() < ROUNDING
    for reach, other in ((1, half + half.T), (2, (half + half.T) @ half @ pattern)):
        symmetric = other + other.T
        exact = float(np.trace(inverse @ symmetric))
        found = blocks.trace(csr_array(symmetric), reach)
        if reach == 1 or _within_two(graph, symmetric, each):
            assert abs(found - exact) < ROUNDING * max(1.0, np.abs(symmetric).sum())


def _within_two(graph: np.ndarray, other: np.ndarray, each: int) -> bool:
    """Whether only things at most two edges apart are coupled."""
    near = np.kron((graph @ graph) > 0, np.ones((each, each)))
    return not (np.abs(other) > 0)[near == 0].any()
