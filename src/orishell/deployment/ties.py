"""Ties: cables between two vertices of one column, which go taut at the target.

Flaps stop the motion from the flat sheet, ties stop it from the pack: a tie as long as its two
vertices are apart at the target is slack before it and taut there, if their distance grows strictly
from the pack over the target to the flat sheet. That is proved by enclosing it
(:mod:`~orishell.deployment.growth`).

Where it does not grow all the way, a tie may still be slack: the same is then asked beyond the
target only, where a square that is proved to be less than at the target will do as well. Families
that do not enclose distances, and ties of whole boards, are asked that alone
(:mod:`~orishell.deployment.slack`).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.record import Angle, record
from orishell.deployment.fixings import Fixings
from orishell.deployment.growth import ColumnDistances, examine_growth
from orishell.deployment.slack import find_slack
from orishell.motion import Mechanism
from orishell.motion.grid import Vertex, VertexPair
from orishell.motion.hinge_lines import IN_CREASES, HingeLines
from orishell.numerics.arrays import Array


@record
class Tie:
    """A cable between two vertices of one column, taut at the target."""

    REPORTED = ("ends", "length", "flat", "packed", "grows", "slack", "fails_at")

    ends: VertexPair  # its vertices by row and column of the whole grid
    # their distance at the target, in the flat sheet, and at the end of the motion (length)
    length: float
    flat: float
    packed: float
    # whether it is proved that its vertices move apart all the way from the end of the motion to
    # the flat sheet; None if the family does not say, or they are on whole boards
    grows: bool | None = None
    # whether it is proved to be slack from the end of the motion to the target; None where it is
    # fixed there, to pieces that are joined
    slack: bool | None = None
    # where its vertices do not move apart, or are not proved to be nearer than at the target,
    # nearest to the target
    fails_at: Angle | None = None
    # if it is disproved, the range of the drive (radians), of several the nearest to the target,
    # over which the distance does not grow towards the flat sheet; None if it is left undecided
    shrinks: tuple[float, float] | None = None


def feet_ties(
    mechanism: Mechanism, rows: tuple[int, int], columns: Iterable[int] | None = None
) -> list[VertexPair]:
    """One pair of vertices for each column, in two rows of the grid.

    Parameters
    ----------
    rows
        The two rows, such as those of the feet.
    columns
        The columns; all inner ones if None.
    """
    if columns is None:
        columns = range(mechanism.grid.columns)[mechanism.inner_columns]
    return [((rows[0], column), (rows[1], column)) for column in columns]


def fold_ties(mechanism: Mechanism, rows: Iterable[int] | None = None) -> list[VertexPair]:
    """Pairs of vertices above and below inner ones, across the folds of each inner column.

    Parameters
    ----------
    rows
        The rows of the inner vertices, as the grid counts them; all if None.

    Raises
    ------
    InputError
        If a row is none of inner vertices.
    """
    grid = mechanism.grid
    columns = range(grid.columns)[mechanism.inner_columns]
    inner = range(1, grid.rows - 1)
    chosen = inner if rows is None else sorted(set(rows))
    for row in chosen:
        if row not in inner:
            raise InputError(
                "no fold lies at the border of the sheet, or beyond it",
                keys=("deployment.ties.folds",),
                got=f"row {row}",
                expected=f"rows of inner vertices, {inner[0]} to {inner[-1]}",
                remedy="rows count from 0, the border; 'ties = \"folds\"' takes all of them",
            )
    return [((row - 1, column), (row + 1, column)) for row in chosen for column in columns]


def find_ties(
    mechanism: Mechanism,
    pairs: Iterable[VertexPair],
    limit: float,
    hinges: HingeLines = IN_CREASES,
) -> tuple[Tie, ...]:
    """Ties between pairs of vertices, and whether each is proved to be taut at the target only.

    Parameters
    ----------
    pairs
        Row and column of both vertices of every tie, in the whole grid.
    limit
        The drive of the pack, at least that of the target (radians).
    hinges
        Those of whole boards, on which ties then end beside the vertices; None without such boards.

    Raises
    ------
    InputError
        If a pair is not of two vertices of one inner column.
    """
    chosen = [_require_pair(mechanism, *pair) for pair in pairs]
    if not chosen:
        return ()
    ends = np.array(chosen)
    rows, columns = ends[..., 0], ends[:, 0, 1]
    fixings = Fixings(mechanism, rows, columns, hinges)
    states = fixings.at(np.array([mechanism.target_drive, 0.0, limit]))
    distances = np.linalg.norm(states[..., 1, :] - states[..., 0, :], axis=-1).T.tolist()
    ties = tuple(Tie(pair, *each) for pair, each in zip(chosen, distances, strict=True))
    if hinges.joint_rows:
        return ties  # they are fixed when the pieces are joined
    if hinges.beside or not isinstance(mechanism, ColumnDistances):
        found = find_slack(fixings, limit)
        return tuple(
            replace(tie, slack=bool(proved), fails_at=None if proved else float(drive))
            for tie, proved, drive in zip(ties, found.proved, found.fails_at, strict=True)
        )
    target = mechanism.target_drive
    shrinking, undecided = examine_growth(mechanism, rows, columns, (0.0, limit))
    verdicts = [
        _verdict(shrinking.of(pair), undecided.of(pair), target) for pair in range(len(ties))
    ]
    slack = np.array([verdict["grows"] for verdict in verdicts])
    doubtful = np.flatnonzero(~slack)
    if len(doubtful):
        ceiling = np.array([ties[pair].length for pair in doubtful]) ** 2
        failing = examine_growth(
            mechanism, rows[doubtful], columns[doubtful], (target, limit), ceiling
        )
        slack[doubtful] = ~np.any([part.pairs.any(axis=0) for part in failing], axis=0)
    return tuple(
        replace(tie, slack=bool(loose), **verdict)
        for tie, loose, verdict in zip(ties, slack, verdicts, strict=True)
    )


def _require_pair(mechanism: Mechanism, first: Vertex, second: Vertex) -> VertexPair:
    """The two vertices, if a tie can join them."""
    grid = mechanism.grid
    inner = range(grid.columns)[mechanism.inner_columns]
    (row, column), (other_row, other) = first, second
    fault = None
    if not all(0 <= each < grid.rows for each in (row, other_row)):
        fault = "a tie ends beyond the rows of the grid"
    elif column != other:
        fault = "a tie joins vertices of two columns"
    elif column not in inner:
        fault = "a tie is not at an inner column"
    elif row == other_row:
        fault = "a tie joins a vertex to itself"
    if fault:
        raise InputError(
            fault,
            keys=("deployment.ties",),
            got=f"rows and columns {list(first)}, {list(second)}",
            expected=f"two rows of 0 to {grid.rows - 1} in one column of {inner[0]} to {inner[-1]}",
            remedy="take two vertices of one column between the flaps, such as its feet",
        )
    return first, second


def _verdict(shrinking: Array, undecided: Array, target: float) -> dict[str, Any]:
    """What ranges (2, K) say of one tie."""
    doubtful = np.concatenate([shrinking, undecided], axis=1)
    if not doubtful.size:
        return {"grows": True}
    verdict: dict[str, Any] = {"grows": False, "fails_at": _nearest(doubtful, target)[1]}
    if shrinking.size:
        # Ranges one after the other are one range.
        start, stop = np.sort(shrinking, axis=1)
        between = start[1:] > stop[:-1]
        runs = np.stack([start[np.append(True, between)], stop[np.append(between, True)]])
        verdict["shrinks"] = tuple(runs[:, _nearest(runs, target)[0]].tolist())
    return verdict


def _nearest(ranges: Array, target: float) -> tuple[int, float]:
    """Which of ranges (2, K) is the nearest to the target, and which drive in it."""
    drives = np.clip(target, *ranges)
    number = int(np.abs(drives - target).argmin())
    return number, float(drives[number])
