"""The best sheet for a piece of surface: both ways of laying its rows, from the plane on."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.record import record
from orishell.design.piece import Piece
from orishell.families.flat_foldable.fit.levenberg_marquardt import fitted
from orishell.families.flat_foldable.fit.residuals import Problem, State, Weights
from orishell.families.flat_foldable.fit.unknowns import Unknowns
from orishell.numerics.arrays import Array

DIAGONAL = 2.8
"""Pieces are fitted in a unit of which their diagonal is so many: weights are for that size."""
SECTOR, FOLDED = 1.1, 1.6
"""Sector angle and fold angle of the Miura sheet that a fit starts with (radians): of seven pairs
tried on four surfaces all led to the same sheets within a tenth of their distances."""
STAGES = 6
"""Steps in which the curvature is turned on."""
STEPS, GAIN = 25, 1e-3
"""Of a stage on the way: at most so many, while each gains so much."""
LAST_STEPS, LAST_GAIN = 120, 1e-4
"""Of the last stage, and of the polish."""
POLISH_STEPS, POLISH_GAIN = 60, 3e-3
POLISH = Weights(near=0.015, even=2e-3, smooth=1e-3, centre=0.1)
"""Distance first."""
STRICTER, TIMES = 5.0, 3
"""Edges that are still too unequal weigh so many times more, so many times at most."""
COARSE = 21
"""Of sheets with more rows or columns a coarse one says how rows are laid."""
DENSE = 5
"""Points along each side of a panel at which the distance of sheets is compared."""


@record
class Fit:
    """A sheet fitted to a piece."""

    of: Unknowns
    state: State
    scale: float  # length of the unit in which it was fitted
    turned: bool  # whether its rows run along the piece from bottom to top
    reached: Reached


@record
class Reached:
    """How near a fitted sheet is to its piece (length)."""

    vertices: float  # largest distance of a vertex from the surface beside the target that it follows
    rms: float  # root mean square of these
    mesh: float  # largest distance of panels from the target, at points of them
    place: tuple[int, int]  # the vertex that is farthest


def fit_sheet(
    piece: Piece,
    rows: int,
    columns: int,
    *,
    ratio: float,
    turned: bool | None = None,
    progress: Progress = no_progress,
) -> Fit | None:
    """The sheet of rows x columns inner vertices that follows a piece best; None if there is none.

    Parameters
    ----------
    ratio
        The longest edge is at most so many times as long as the shortest.
    turned
        Whether rows run from the bottom of the piece to its top; None for what is better.
    """
    ways = (False, True) if turned is None else (turned,)
    if len(ways) > 1 and max(rows, columns) > COARSE:
        share = COARSE / max(rows, columns)
        small = [max(round(share * each), 3) for each in (rows, columns)]
        coarse = [_fit_one_way(piece, *small, ratio, way, _part(progress, k, 4)) for k, way in enumerate(ways)]
        ways = (_best(coarse).turned,) if any(coarse) else ways
    done = [_fit_one_way(piece, rows, columns, ratio, way, _part(progress, k, len(ways))) for k, way in enumerate(ways)]
    return _best(done) if any(done) else None


def _best(fits: list[Fit | None]) -> Fit:
    """The nearest; of those that are nearly as near the first."""
    return min((each for each in fits if each is not None), key=lambda each: each.reached.mesh)


def _part(progress: Progress, number: int, count: int) -> Callable[[float], None]:
    return lambda share: progress((number + share) / count, "fitting")


def _fit_one_way(
    piece: Piece, rows: int, columns: int, ratio: float, turned: bool, told: Callable[[float], None]
) -> Fit | None:
    if turned:
        piece = piece.turned()
    scale = piece.diagonal / DIAGONAL
    unit = replace(piece, vertices=piece.vertices / scale)
    of = Unknowns.covering(unit, rows, columns, SECTOR, FOLDED)
    problem = Problem(unit.flattened(1 / STAGES), of, Weights(), ratio)
    state = problem.state(of.first)
    count = 0

    def step() -> None:
        nonlocal count
        count += 1
        told(1 - float(np.exp(-count / 40)))

    for stage in range(1, STAGES + 1):
        if state is None:
            return None
        last = stage == STAGES
        problem = replace(problem, piece=unit if last else unit.flattened(stage / STAGES))
        effort = (LAST_STEPS, LAST_GAIN) if last else (STEPS, GAIN)
        state = problem.state(state.unknowns)
        if state is not None:
            state = fitted(problem, state, *effort, step)
    weights = POLISH
    for _ in range(TIMES):
        if state is None:
            return None
        problem = replace(problem, weights=weights)
        start = problem.state(state.unknowns)
        assert start is not None
        state = fitted(problem, start, POLISH_STEPS, POLISH_GAIN, step)
        if state.edges[1] <= ratio * state.edges[0]:
            return Fit(of, state, scale, turned, _reached(unit, of, state, scale))
        weights = replace(weights, ratio=STRICTER * weights.ratio)
    return None


def _reached(piece: Piece, of: Unknowns, state: State, scale: float) -> Reached:
    places = state.places
    found = piece.nearest(places.reshape(-1, 3))[0].reshape(places.shape[:2])
    apart = np.abs(found - state.unknowns[-1] * of.sides)
    p, q = (each.ravel()[:, None, None, None] for each in np.meshgrid(*2 * [np.linspace(0, 1, DENSE)]))
    above = (1 - q) * places[:-1, :-1] + q * places[:-1, 1:]
    below = (1 - q) * places[1:, :-1] + q * places[1:, 1:]
    panels = ((1 - p) * above + p * below).reshape(-1, 3)
    row, column = divmod(int(apart.argmax()), apart.shape[1])
    return Reached(
        scale * float(apart.max()),
        scale * float(np.sqrt((apart**2).mean())),
        scale * float(np.abs(piece.nearest(panels)[0]).max()),
        (row, column),
    )
