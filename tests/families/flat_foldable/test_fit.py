"""Flat-foldable sheets fitted to pieces of surface."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from orishell.conventions.errors import DesignError
from orishell.deployment.feet import find_feet, stand
from orishell.design import MeshSurface, Piece
from orishell.families.flat_foldable.fit.conditions import Conditions
from orishell.families.flat_foldable.fit.initial_guesses import Task, fit_sheet
from orishell.families.flat_foldable.fit.residuals import Problem, Weights
from orishell.families.flat_foldable.fit.unknowns import Unknowns
from orishell.families.flat_foldable.pattern import FlatFoldablePattern
from orishell.locking import find_lock
from orishell.numerics.arrays import Array

PARTS = [0, 1, 2, 3, 4, 5, 6, 7, 9, 10]
"""Of the residuals: all but those of edge limits."""


def cap(cells: int = 64) -> Piece:
    """The unit sphere over the square of half side 0.5."""
    x, y = np.meshgrid(np.linspace(-0.5, 0.5, cells + 1), np.linspace(0.5, -0.5, cells + 1))
    normals = np.stack([x, y, np.sqrt(1 - x * x - y * y)], axis=-1)
    return Piece.of_lattice(normals - [0, 0, 1], normals)


def test_derivatives_are_those_of_differences() -> None:
    """Of what the surface does not enter, to 1e-7: differences of 1e-6 have that error."""
    of = Unknowns.covering(cap().flattened(0.5), 7, 6, 1.1, 1.6)
    rng = np.random.default_rng(0)
    unknowns = of.first + 3e-3 * rng.standard_normal(len(of.first))
    placed = of.placed(unknowns)
    step = 1e-6

    def vertices(by: Array) -> Array:
        return of.placed(unknowns + by).vertices

    differences = np.stack(
        [(vertices(step * e) - vertices(-step * e)) / (2 * step) for e in np.eye(len(unknowns))],
        axis=-1,
    )
    assert np.abs(of.slopes(unknowns, placed) - differences).max() < 1e-7


def test_derivatives_of_residuals_are_those_of_differences() -> None:
    """All but those of edge limits (below), some corners and folds beyond where they begin."""
    of = Unknowns.covering(cap(), 7, 6, 1.1, 1.6)
    rng = np.random.default_rng(0)
    unknowns = of.first + 3e-3 * rng.standard_normal(len(of.first))
    limits = Conditions(10.0, corner=np.deg2rad(45), fold=np.deg2rad(95))
    problem = Problem(cap(), of, Weights(), limits)
    step = 1e-6

    def residuals(by: Array) -> list[Array]:
        found = problem.at(unknowns + by)
        assert found is not None
        return [found.residuals[part] for part in PARTS]

    ways = [(residuals(step * e), residuals(-step * e)) for e in np.eye(len(unknowns))]
    here = problem.at(unknowns)
    assert here is not None
    exact = problem.derivatives(here)
    for number, part in enumerate(PARTS):
        differences = np.stack(
            [(more[number] - less[number]) / (2 * step) for more, less in ways], axis=-1
        )
        assert len(differences) > 0
        assert np.abs(exact[part] - differences).max() < 1e-7, part


def test_gradient_of_edges_is_that_of_differences() -> None:
    """Those that are too long or too short, about the middle that makes them least."""
    of = Unknowns.covering(cap(), 5, 4, 1.1, 1.6)
    rng = np.random.default_rng(0)
    unknowns = of.first + 0.03 * rng.standard_normal(len(of.first))
    flat = of.placed(unknowns).flat
    edges = [np.linalg.norm(np.diff(flat, axis=axis), axis=0) for axis in (1, 2)]
    ratio = 1.01 * max(each.max() for each in edges) / min(each.min() for each in edges)
    problem = Problem(cap(), of, Weights(), Conditions(ratio))
    step = 1e-6

    def error(by: Array) -> float:
        found = problem.at(unknowns + by)
        assert found is not None
        return float(found.residuals[8] @ found.residuals[8])

    differences = [(error(step * e) - error(-step * e)) / (2 * step) for e in np.eye(len(unknowns))]
    here = problem.at(unknowns)
    assert here is not None
    assert len(here.beyond) > 2
    gradient = 2 * here.residuals[8] @ problem.derivatives(here)[8]
    assert np.abs(gradient - differences).max() < 1e-6 * np.abs(gradient).max()


def test_cap_is_followed_under_the_conditions() -> None:
    """0.4 and 3.6 % of the diagonal were reached with 10 x 10 panels."""
    fit = fit_sheet(Task(cap(), 9, 9, Conditions(10.0)), direction=0, folded=1.6)
    assert fit is not None
    assert fit.reached.vertices < 0.007
    assert fit.reached.mesh < 0.045
    placed = fit.fitted.placed
    edges = [np.linalg.norm(np.diff(placed.flat, axis=axis), axis=0) for axis in (1, 2)]
    assert max(each.max() for each in edges) <= 10 * min(each.min() for each in edges)


def test_straight_borders_are_fitted_with_exact_derivatives() -> None:
    of = Unknowns.covering(cap(), 4, 5, 1.1, 1.6, straight=True)
    at = of.first + 0.01 * np.sin(np.arange(len(of.first)))
    placed, h = of.placed(at), 1e-6
    assert placed.vertices.shape == (*of.shape, 3) == (6, 7, 3)
    exact = of.slopes(at, placed)
    for number in range(len(at)):
        step = h * np.eye(len(at))[number]
        found = (of.placed(at + step).vertices - of.placed(at - step).vertices) / (2 * h)
        np.testing.assert_allclose(found, exact[..., number], rtol=0, atol=1e-8)
    # The border is straight in the flat sheet, wherever the unknowns are.
    edges = np.diff(placed.flat[:, :, -1], axis=1)
    turns = edges[0, 1:] * edges[1, :-1] - edges[1, 1:] * edges[0, :-1]
    assert np.abs(turns).max() < 1e-14


@pytest.mark.slow
def test_dome_with_a_straight_border_locks_by_flaps() -> None:
    """0.7 % of the diagonal was reached with 6 x 6 panels, 0.6 % with 10 x 10."""
    options: dict[str, Any] = {"rows": 5, "columns": 5, "direction_deg": 0, "fold_deg": 92}
    pattern = FlatFoldablePattern(**options, border="straight", flap="auto")
    design = pattern.design_on(MeshSurface(cap()))
    assert design.mechanism.flap_columns == (6,)
    assert max(each.max for each in design.closeness.values()) < 0.01 * cap().diagonal
    lock = find_lock(design)
    assert (lock.cause, lock.early) == ("flaps", False)


def test_shell_is_the_fitted_one_and_can_be_typed_in_again() -> None:
    """To rounding: 5e-16 and 4e-15 were seen on a shell of size 1."""
    pattern = FlatFoldablePattern(rows=5, columns=4, direction_deg=0, fold_deg=90)
    design = pattern.design_on(MeshSurface(cap()))
    fit = fit_sheet(Task(cap(), 5, 4, Conditions(10.0)), direction=0, folded=float(np.deg2rad(90)))
    assert fit is not None
    mechanism = design.mechanism
    shell = mechanism.positions(mechanism.target_drive)
    assert np.abs(shell - fit.fitted.placed.vertices).max() < 1e-13
    off = np.abs(fit.fitted.heights).max() * fit.of.size
    assert max(each.max for each in design.closeness.values()) == pytest.approx(off)

    given = {
        key: value
        for key, value in design.parameters.items()
        if key in FlatFoldablePattern.model_fields and key not in ("edge_ratio", "direction_deg")
    }
    table = {"rows": 5, "columns": 4, **given}
    again = FlatFoldablePattern.model_validate(table).design_without_target().mechanism
    copy = again.positions(again.target_drive)
    assert np.abs(distances(copy) - distances(shell)).max() < 1e-12


def distances(shell: Array) -> Array:
    """Of all vertices from each other."""
    points = shell.reshape(-1, 3)
    return np.asarray(np.linalg.norm(points[:, None] - points, axis=-1))


def test_surface_that_no_sheet_follows_is_refused_with_what_was_reached() -> None:
    """Edges nearly alike leave no freedom to bend both ways."""
    pattern = FlatFoldablePattern(rows=5, columns=5, edge_ratio=1.6, direction_deg=0, fold_deg=90)
    with pytest.raises(DesignError) as refused:
        pattern.design_on(MeshSurface(hemisphere()))
    assert "diagonal" in refused.value.size
    assert next(iter(refused.value.candidates)).changes == {"pattern.edge_ratio": 3.2}


def hemisphere(cells: int = 64) -> Piece:
    """The unit sphere over the square of half side 0.7."""
    x, y = np.meshgrid(np.linspace(-0.7, 0.7, cells + 1), np.linspace(0.7, -0.7, cells + 1))
    normals = np.stack([x, y, np.sqrt(1 - x * x - y * y)], axis=-1)
    return Piece.of_lattice(normals - [0, 0, 1], normals)


@pytest.mark.parametrize(("rows", "columns"), [(1, 2), (1, 5), (2, 3), (4, 2)])
def test_small_sheets_begin_on_the_plane(rows: int, columns: int) -> None:
    """A Miura-ori's vertices are on its two planes, to rounding."""
    of = Unknowns.covering(cap(), rows, columns, 1.1, 1.6)
    heights = of.placed(of.first).vertices @ cap().axes[2]
    crests = heights[of.sides[:, 0] > 0]
    valleys = heights[of.sides[:, 0] < 0]
    assert np.ptp(crests) < 1e-14
    assert np.ptp(valleys) < 1e-14
    assert crests.min() > valleys.max()


def test_few_panels_are_fitted() -> None:
    assert fit_sheet(Task(cap(), 1, 2, Conditions(10.0)), direction=0, folded=1.6) is not None


def test_a_dome_stands_on_its_lowest_rows() -> None:
    """The lowest towards each end; the lowest vertex, at a corner, is put on z = 0."""
    pattern = FlatFoldablePattern(rows=5, columns=5, direction_deg=0, fold_deg=90)
    design = pattern.design_on(MeshSurface(cap()))
    found, feet = stand(design, find_feet(design))
    assert feet is not None
    heights = found.mechanism.positions(found.mechanism.target_drive)[..., 2] + found.origin[2]
    assert heights.min() == pytest.approx(0.0, abs=1e-12)
    low = heights.min(axis=1)
    assert feet.rows == (low[:3].argmin(), 4 + low[4:].argmin())
    assert feet.uneven == pytest.approx(np.ptp(heights[list(feet.rows)]), abs=1e-12)
