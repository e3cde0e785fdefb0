"""Ties that go taut on the way from the pack, short of the target, and ties that do not.

Whether a tie is slack all the way is proved (:mod:`~orishell.deployment.ties`). That it is not is
seen in a state, in closed form: there its ends are farther apart than it is long.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations, islice

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import in_degrees
from orishell.conventions.record import record
from orishell.deployment.fixings import Fixings
from orishell.deployment.ties import Tie, find_ties
from orishell.motion import Mechanism
from orishell.motion.grid import VertexPair
from orishell.motion.hinge_lines import IN_CREASES, HingeLines
from orishell.numerics.arrays import Array

STATES = 129
"""States between target and pack in which ties are looked at."""
SHORT = 1e-6
"""A tie is too short if it lacks more than this share of its length: any cable gives way so far."""
TRIED = 8
"""Pairs of rows for which slack is proved at most, in search of ties that work."""


@record
class ShortTies:
    """Ties that stop a shell on its way from the pack."""

    ties: tuple[Tie, ...]  # those that do
    lacks: Array  # how much each lacks at most, in a state that was looked at (length)
    drives: Array  # where it does (radians)


def find_short(
    mechanism: Mechanism, ties: Sequence[Tie], limit: float, hinges: HingeLines
) -> ShortTies:
    """The ties whose ends are seen farther apart than they are long, between target and pack.

    Parameters
    ----------
    limit
        The drive of the pack (radians).
    """
    doubtful = [tie for tie in ties if tie.slack is False]
    if not doubtful or limit <= mechanism.target_drive:
        return ShortTies((), np.zeros(0), np.zeros(0))
    drives = np.linspace(mechanism.target_drive, limit, STATES)
    over = _distances(mechanism, [tie.ends for tie in doubtful], drives, hinges)
    over -= over[0]
    at = over.argmax(axis=0)
    most = over.max(axis=0)
    short = most > SHORT * np.array([tie.length for tie in doubtful])
    chosen = tuple(tie for tie, is_short in zip(doubtful, short.tolist(), strict=True) if is_short)
    return ShortTies(chosen, most[short], drives[at[short]])


def require_slack(
    mechanism: Mechanism, ties: Sequence[Tie], limit: float, hinges: HingeLines = IN_CREASES
) -> None:
    """Refuse ties that stop a shell on its way from the pack, short of its target.

    Parameters
    ----------
    limit
        The drive of the pack (radians).

    Raises
    ------
    DesignError
        If there are such ties: which, by how much, and ties of other rows that are proved slack.
    """
    found = find_short(mechanism, ties, limit, hinges)
    if not found.ties:
        return
    # The first of those that lack as much but for rounding.
    worst = int(np.argmax(found.lacks >= found.lacks.max() * (1 - SHORT)))
    tie, lacks = found.ties[worst], float(found.lacks[worst])
    (row, column), (other, _) = tie.ends
    many = f"{len(found.ties)} of {len(ties)} ties are"
    raise DesignError(
        f"{many if len(ties) > 1 else 'the tie is'} too short to let the shell open from its pack",
        keys=("deployment.ties",),
        place=f"the one of rows {row} and {other} in column {column}, at drive "
        f"{in_degrees(float(found.drives[worst]))} degrees",
        size=f"its ends are {tie.length + lacks:.5g} apart there, and it is {tie.length:.5g} long: "
        f"it stops the shell short of its target at {in_degrees(mechanism.target_drive)} degrees",
        candidates=_others(mechanism, [tie.ends for tie in ties], limit, hinges),
        excess=lacks / tie.length,
    )


def _others(
    mechanism: Mechanism, asked: Sequence[VertexPair], limit: float, hinges: HingeLines
) -> Iterator[Remedy]:
    """Those across folds that are slack; ties of two other rows in the same columns; and none."""
    yield from _slack_folds(mechanism, asked, limit, hinges)
    columns = sorted({first[1] for first, _ in asked})
    low, high = sorted((asked[0][0][0], asked[0][1][0]))

    def far(rows: tuple[int, int]) -> tuple[bool, int, tuple[int, int]]:
        # Even ones first, then the nearest.
        return sum(rows) != low + high, abs(rows[0] - low) + abs(rows[1] - high), rows

    pairs = sorted(combinations(range(mechanism.grid.rows), 2), key=far)
    for rows in islice(pairs, TRIED):
        ties = find_ties(mechanism, [((rows[0], k), (rows[1], k)) for k in columns], limit, hinges)
        if all(tie.slack for tie in ties):
            yield Remedy({"deployment.ties": [[list(end) for end in tie.ends] for tie in ties]})
            break
    yield Remedy({"deployment.ties": "none"})


def _slack_folds(
    mechanism: Mechanism, asked: Sequence[VertexPair], limit: float, hinges: HingeLines
) -> Iterator[Remedy]:
    """Ties across the folds at those rows at which all of them are proved slack."""
    folds = [pair for pair in asked if pair[1][0] - pair[0][0] == 2]
    loose: dict[int, bool] = {}
    for tie in find_ties(mechanism, folds, limit, hinges):
        row = tie.ends[0][0] + 1
        loose[row] = loose.get(row, True) and tie.slack is True
    kept = sorted(row for row, slack in loose.items() if slack)
    if kept and len(folds) < len(asked):
        yield Remedy({"deployment.ties": {"folds": kept}})


def _distances(
    mechanism: Mechanism, pairs: Sequence[VertexPair], drives: Array, hinges: HingeLines
) -> Array:
    """How far the ends of pairs are apart at drives (S, P) (length)."""
    ends = np.array(pairs)
    places = Fixings(mechanism, ends[..., 0], ends[:, 0, 1], hinges).at(drives)
    return np.asarray(np.linalg.norm(places[..., 1, :] - places[..., 0, :], axis=-1))
