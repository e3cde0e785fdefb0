"""Ties across the folds of random shells: proved slack on the way, or refused with what fits."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from functools import cache

import numpy as np
import pytest

from flat_foldables import random_sheet
from mechanisms import longitudinal, orthodiagonal_of
from orishell.conventions.errors import DesignError, OrishellError, Remedy
from orishell.deployment import Tie, find_ties
from orishell.deployment.short_ties import SHORT, require_slack
from orishell.deployment.ties import feet_ties, fold_ties
from orishell.families.orthodiagonal import OrthodiagonalPattern, design_orthodiagonal
from orishell.motion import Mechanism
from orishell.motion.grid import VertexPair
from samples import thorough
from strategies import graph, pair

SEEDS = [13, *range(13), *range(14, 60)]
"""13 first, whose ties are refused: `make test` has those before the rest."""
QUICK = 6
DRIVES = 1001
"""States in which distances are looked at, eight times as many as refusals are found with."""
ROUNDING = 1e-9
"""Of a length, where a tie is as long as in the state that stands."""


def folded_sheet(seed: int) -> Mechanism:
    """Every fifth of the longitudinal family, every fifth a horseshoe, the others of any other."""
    make = {3: _horseshoe, 4: _longitudinal}.get(seed % 5, random_sheet)
    return make(seed)


def _horseshoe(seed: int) -> Mechanism:
    """An arch that turns by more than half a turn: its feet come nearer before they part."""
    rng = np.random.default_rng(seed)
    while True:
        more, rise, wave = rng.uniform((0.2, 0.8, 0.0), (1.45, 1.4, 0.1))
        f = pair("cos(t)", f"{rise:.3f}*sin(t)", -more, np.pi + more)
        rows, columns = 2 * int(rng.integers(2, 6)) + 1, int(rng.integers(3, 7))
        pattern = OrthodiagonalPattern(rows=rows, columns=columns, depth=0.1, flap=0.0)
        try:
            g = graph(f"{wave:.3f}*sin(pi*x)", 0, 2)
            return orthodiagonal_of(design_orthodiagonal(f, g, pattern))
        except OrishellError:
            continue


def _longitudinal(seed: int) -> Mechanism:
    rng = np.random.default_rng(seed)
    while True:
        degrees = tuple(np.round(rng.uniform(75, 105, 4), 3).tolist())
        rows, columns = (int(n) for n in rng.integers(2, 6, 2))
        try:
            return longitudinal(degrees, rows, columns + 1, "S" if seed % 2 else "F")
        except (OrishellError, AssertionError, StopIteration):
            continue


def longest(sheet: Mechanism, pairs: Sequence[VertexPair], limit: float) -> np.ndarray:
    """How much farther apart ends are on the way than at the target, at most, by its length."""
    drives = np.linspace(sheet.target_drive, limit, DRIVES)
    points = np.asarray(sheet.positions(drives))
    first, second = np.array(pairs).transpose(1, 2, 0)
    apart = np.linalg.norm(points[:, second[0], second[1]] - points[:, first[0], first[1]], axis=-1)
    return np.asarray((apart.max(axis=0) - apart[0]) / apart[0])


def ties_of(changed: object, sheet: Mechanism, feet: list[VertexPair]) -> list[VertexPair]:
    """The pairs that a value of ``ties`` in [deployment] stands for."""
    if isinstance(changed, dict):
        return [*feet, *fold_ties(sheet, changed["folds"])]
    if isinstance(changed, list):
        return [((one[0], one[1]), (other[0], other[1])) for one, other in changed]
    assert changed == "none"
    return []


def refusal(sheet: Mechanism, ties: Sequence[Tie], limit: float) -> DesignError | None:
    """Why ties are refused; None if they are not."""
    try:
        require_slack(sheet, ties, limit)
    except DesignError as error:
        return error
    return None


def fits(offered: Remedy, sheet: Mechanism, limit: float, feet: list[VertexPair]) -> bool:
    """Whether ties that a refusal offers are slack on the way; messages offer only such."""
    chosen = ties_of(offered.changes["deployment.ties"], sheet, feet)
    if not chosen:
        return False  # none always are
    ties = find_ties(sheet, chosen, limit)
    if refusal(sheet, ties, limit) is not None:
        return False
    assert longest(sheet, chosen, limit).max() <= SHORT
    return all(tie.slack for tie in ties)


@cache
def judged(seed: int) -> str:
    """How the ties of one shell end; what is said of them is held against states on the way."""
    sheet = folded_sheet(seed)
    limit = max(sheet.end_drive, sheet.target_drive)
    feet = feet_ties(sheet, (0, sheet.grid.rows - 1))
    pairs = [*feet, *fold_ties(sheet)]
    ties: tuple[Tie, ...] = find_ties(sheet, pairs, limit)
    seen = longest(sheet, pairs, limit)
    slack = np.array([tie.slack is True for tie in ties])
    assert (seen[slack] <= ROUNDING).all()
    refused = refusal(sheet, ties, limit)
    if refused is not None:
        assert seen.max() > SHORT
        assert any(fits(each, sheet, limit, feet) for each in refused.candidates)
        return "refused"
    # What is neither proved nor seen to be short is said not to be proved.
    assert seen.max() <= SHORT
    return "slack" if slack.all() else "not proved"


@pytest.mark.parametrize(
    "seeds",
    [
        SEEDS[:QUICK],
        *(pytest.param(SEEDS[k : k + 9], marks=thorough) for k in range(QUICK, len(SEEDS), 9)),
    ],
    ids=lambda seeds: f"{seeds[0]}-",
)
def test_ties_are_proved_slack_or_refused_with_what_fits(seeds: Sequence[int]) -> None:
    ended = Counter(judged(seed) for seed in seeds)
    assert ended["slack"] + ended["refused"] == len(seeds)


@thorough
def test_both_ends_are_met() -> None:
    ended = Counter(map(judged, SEEDS))
    assert min(ended["slack"], ended["refused"]) >= 3, ended
