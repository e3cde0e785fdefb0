"""Ties: what is proved of them holds wherever one looks."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from orishell.deployment import Tie, find_ties
from orishell.design import Design
from orishell.design_file import read_design_file
from orishell.families.orthodiagonal import Orthodiagonal
from orishell.families.parallel_repeating import ParallelRepeating
from orishell.motion import diagonal
from strategies import Request, orthodiagonal_requests, requests

EXAMPLES = Path(__file__).parents[2] / "examples"
ROUNDING = 1e-12
Sheet = ParallelRepeating | Orthodiagonal
Array = np.ndarray


def bare(design: Design) -> Sheet:
    """The sheet without flaps, so that there is motion beyond the target."""
    mechanism = design.mechanism
    assert isinstance(mechanism, ParallelRepeating | Orthodiagonal)
    return replace(mechanism, flaps=(0.0, 0.0))


def shelter() -> Sheet:
    file = read_design_file(EXAMPLES / "shelter.toml")
    return bare(file.pattern.design(file.f, file.g))


def squares(mechanism: Sheet, pairs: Array, drives: Array) -> Array:
    """Squared distances (S, P) from positions; pairs (P, 3) of two rows and a column."""
    first, second, column = pairs.T
    positions = mechanism.positions(drives)
    vector = positions[:, second, column] - positions[:, first, column]
    return np.asarray((vector**2).sum(axis=-1))


def some_pairs(mechanism: Sheet, shares: list[float]) -> Array:
    """The feet of the first and the last column, and others that the shares choose."""
    rows, columns = mechanism.grid.rows, mechanism.grid.columns
    feet = [(0, rows - 1, 0), (0, rows - 1, columns - 1)]
    chosen = [
        (int(a * (rows - 1)), 1 + int(a * (rows - 1)) + int(b * (rows - 1 - int(a * (rows - 1)))),
         int(c * columns))
        for a, b, c in np.reshape(shares, (-1, 3))
    ]  # fmt: skip
    return np.array(feet + chosen)


def ties_of(mechanism: Sheet, pairs: Array) -> tuple[Tie, ...]:
    return find_ties(
        mechanism, [((a, column), (b, column)) for a, b, column in pairs.tolist()], np.pi
    )


def require_truth(mechanism: Sheet, shares: list[float]) -> None:
    """What ties say is what 2000 drives show."""
    pairs = some_pairs(mechanism, shares)
    drives = np.linspace(0.0, np.pi, 2000)
    square = squares(mechanism, pairs, drives)
    rounding = ROUNDING * diagonal(mechanism.positions(0.0)) ** 2
    for number, tie in enumerate(ties_of(mechanism, pairs)):
        steps = np.diff(square[:, number])
        if tie.grows:
            assert (steps < rounding).all()
            continue
        assert tie.shrinks is not None, f"undecided: {tie}"
        assert tie.fails_at is not None
        more, less = squares(mechanism, pairs[number : number + 1], np.array(tie.shrinks))[:, 0]
        assert less >= more - rounding
        between = np.sort([mechanism.target_drive, tie.fails_at])
        clear = (drives[:-1] >= between[0]) & (drives[1:] <= between[1])
        assert (steps[clear] < rounding).all()


SHARES = st.lists(st.floats(0, 0.999), min_size=12, max_size=12)


@settings(max_examples=100)
@given(requests(), SHARES)
def test_any_parallel_repeating_design(request: Request, shares: list[float]) -> None:
    mechanism = bare(request.feasible())
    require_truth(mechanism, shares)
    # Only edges of panels do not grow: all else has an edge that rises and one that falls.
    pairs = some_pairs(mechanism, shares)
    for (first, second, _), tie in zip(pairs.tolist(), ties_of(mechanism, pairs), strict=True):
        assert tie.grows == (second - first > 1)


@settings(max_examples=100)
@given(orthodiagonal_requests(), SHARES)
def test_any_orthodiagonal_design(request: Request, shares: list[float]) -> None:
    require_truth(bare(request.feasible()), shares)
