"""Ties proved slack by bounds of accelerations: what is proved is seen, and nearly the reverse."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from orishell.deployment import ColumnDistances, feet_ties, find_ties
from orishell.deployment.fixings import Fixings
from orishell.deployment.slack import find_slack
from orishell.design_file import read_design_file
from orishell.families.flat_foldable import FlatFoldablePattern, design_flat_foldable
from orishell.motion import Mechanism

EXAMPLES = Path(__file__).parents[2] / "examples"
SAMPLES = 2_001


def pairs_of(mechanism: Mechanism) -> tuple[np.ndarray, np.ndarray]:
    """All pairs of rows that are two or more apart, in the first, a middle and the last column."""
    rows = range(mechanism.grid.rows)
    columns = range(mechanism.grid.columns)[mechanism.inner_columns]
    chosen = sorted({columns[0], columns[len(columns) // 2], columns[-1]})
    found = [(a, b, c) for a in rows for b in rows for c in chosen if b > a + 1]
    return np.array(found)[:, :2], np.array(found)[:, 2]


def seen(mechanism: Mechanism, rows: np.ndarray, columns: np.ndarray, limit: float) -> np.ndarray:
    """Distances (S, P) at many drives from the target to the pack."""
    places = mechanism.positions(np.linspace(mechanism.target_drive, limit, SAMPLES))
    return np.asarray(
        np.linalg.norm(places[:, rows[:, 1], columns] - places[:, rows[:, 0], columns], axis=-1)
    )


def require_truth(mechanism: Mechanism, limit: float) -> float:
    """Check all pairs; the share of those that are slack for which it is proved."""
    rows, columns = pairs_of(mechanism)
    found = find_slack(Fixings(mechanism, rows, columns), limit)
    distances = seen(mechanism, rows, columns, limit)
    taut = distances[0] * (1 - 1e-9)
    assert (distances[:, found.proved] <= distances[0, found.proved]).all()
    slack = (distances[1:] < taut).all(axis=0)
    failing = ~found.proved
    assert np.isinf(found.fails_at[found.proved]).all()
    assert (found.fails_at[failing] >= mechanism.target_drive).all()
    assert (found.fails_at[failing] <= limit).all()
    return float(found.proved[slack].mean()) if slack.any() else 1.0


def arch(turn: float, fold: float, rows: int) -> Mechanism:
    return design_flat_foldable(
        FlatFoldablePattern(rows=rows, columns=4, sheet="arch", turn_deg=turn, fold_deg=fold)
    ).mechanism


@settings(max_examples=12)
@given(st.floats(10, 60), st.floats(70, 130), st.integers(3, 7))
def test_arches_of_the_flat_foldable_family(turn: float, fold: float, rows: int) -> None:
    """All that 2,001 states show to be slack with 1e-9 to spare is proved, up to 170 degrees."""
    assert require_truth(arch(turn, fold, rows), np.deg2rad(170)) > 0.9


def test_feet_of_an_arch_are_proved_up_to_its_flat_stack() -> None:
    mechanism = arch(90, 90, 7)
    ties = find_ties(mechanism, feet_ties(mechanism, (0, mechanism.grid.rows - 1)), np.pi)
    assert all(tie.slack and tie.fails_at is None and tie.grows is None for tie in ties)
    assert all(tie.packed < tie.length < tie.flat for tie in ties)


def test_where_flaps_stop_the_sheet_opening_it_stretches_ties() -> None:
    """Beyond the target there is nothing to prove, and there the rate by the drive may vanish."""
    design = design_flat_foldable(FlatFoldablePattern(rows=5, columns=4, sheet="arch", flap=0.2))
    locked = design.mechanism
    assert locked.target_drive == locked.end_drive
    ties = find_ties(locked, feet_ties(locked, (0, locked.grid.rows - 1)), np.pi)
    assert all(tie.slack for tie in ties)
    # The ends of an edge stay as far apart as they are: a tie there would hold nothing.
    rows = np.array([[0, 1]])
    found = find_slack(Fixings(locked, rows, np.array([2])), np.pi)
    assert not found.proved[0]
    assert found.fails_at[0] == locked.target_drive


def test_vertices_that_part_while_the_sheet_closes_are_not_said_to_be_slack() -> None:
    """Two vertices of one panel stay where they are to each other: never slack, never beyond."""
    mechanism = arch(90, 90, 5)
    found = find_slack(Fixings(mechanism, np.array([[0, 1]]), np.array([2])), np.deg2rad(170))
    assert not found.proved[0]
    assert found.fails_at[0] == pytest.approx(mechanism.target_drive, abs=1e-6)


@pytest.mark.parametrize("name", ["shelter", "figure1"])
def test_both_proofs_agree_where_a_family_encloses_distances(name: str) -> None:
    """What these bounds prove, enclosures of the family prove, too."""
    file = read_design_file(EXAMPLES / f"{name}.toml")
    mechanism = file.pattern.design(file.f, file.g).mechanism.without_flaps()
    assert isinstance(mechanism, ColumnDistances)
    limit = mechanism.target_drive + 0.2
    assert limit < mechanism.end_drive
    rows, columns = pairs_of(mechanism)
    rows, columns = rows[::7], columns[::7]
    found = find_slack(Fixings(mechanism, rows, columns), limit)
    pairs = [((a, c), (b, c)) for (a, b), c in zip(rows.tolist(), columns.tolist(), strict=True)]
    ties = find_ties(mechanism, pairs, limit)
    assert found.proved.any()
    assert all(tie.slack or not proved for tie, proved in zip(ties, found.proved, strict=True))
