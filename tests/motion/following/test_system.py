"""Closure of vertices against the closed forms of all families."""

from __future__ import annotations

import numpy as np
import pytest

from creased import of_mechanism, star
from mechanisms import CLOSED, SAMPLES
from orishell.motion.following.system import Closure
from orishell.motion.layout import edge_folds


@pytest.mark.parametrize("name", CLOSED)
def test_closed_forms_close(name: str) -> None:
    """Every state of every family, to rounding: 1e-13, of which at most 0.6 were seen."""
    mechanism = SAMPLES[name].make()
    closure = Closure.of(of_mechanism(mechanism))
    for share in (0.3, 0.7, 1.0):
        folds = edge_folds(mechanism, share * mechanism.target_drive)[closure.edges]
        assert np.abs(closure.residuals(folds)[0]).max() < 1e-13


@pytest.mark.parametrize("name", ["parallel", "longitudinal, 4 x 3 from S", "flat-foldable"])
def test_derivatives(name: str) -> None:
    """Unit vectors along creases are the derivatives in closed states: central differences."""
    mechanism = SAMPLES[name].make()
    closure = Closure.of(of_mechanism(mechanism))
    folds = edge_folds(mechanism, 0.6 * mechanism.target_drive)[closure.edges]
    change = np.random.default_rng(0).normal(size=len(folds))
    ahead, behind = (closure.residuals(folds + h * change)[0] for h in (1e-6, -1e-6))
    exact = closure.matrix(closure.residuals(folds)[1]) @ change
    assert np.abs((ahead - behind).ravel() / 2e-6 - exact).max() < 4e-9  # ten times what was seen


def test_residual_is_the_turn_that_is_left() -> None:
    """One crease folded by 0.1 alone leaves a turn by 0.1 about it: sin(0.1) along it."""
    closure = Closure.of(star([0, 80, 190, 260]))
    left, _ = closure.residuals(np.array([0.1, 0.0, 0.0, 0.0]))
    np.testing.assert_allclose(np.linalg.norm(left), np.sin(0.1), rtol=1e-14)


def test_what_is_flat_is_no_unknown() -> None:
    """Letters F and J fold nothing: the other two creases, collinear, close at any angle."""
    closure = Closure.of(star([0, 80, 180, 260], "VFVJ"))
    assert len(closure.edges) == 2
    left, _ = closure.residuals(np.array([1.2, 1.2]))
    assert np.abs(left).max() < 1e-15
    assert np.count_nonzero(closure.on_edges(np.array([1.2, 1.2]))) == 2
