"""The target state: where column 1 turns as much as f does, and its lengths there."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain, pairwise

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import in_degrees
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.families.longitudinal_linear_repeating.equation.choice import AUTO_SECTORS
from orishell.families.longitudinal_linear_repeating.motion.mechanism import crease_end
from orishell.families.longitudinal_linear_repeating.section import Section, turnings
from orishell.families.longitudinal_linear_repeating.target import Profile
from orishell.families.longitudinal_linear_repeating.tessellation.columns import Columns, RowKind
from orishell.families.longitudinal_linear_repeating.tessellation.even_lengths import sheet_exists
from orishell.families.shared.candidates import angles
from orishell.numerics.arrays import Array
from orishell.numerics.equals import first_largest, first_smallest

FIRST = 1e-4
"""The smallest drive looked at, as a share of the sector angles' deviations from 90 degrees."""
STEPS = 400
"""Drives looked at for the first that turns enough."""
SHORTEST = 1e-6
"""Edges of column 1 are longer than this share of its length."""


@record
class TargetState:
    """Column 1 where it follows f."""

    drive: float  # The drive (radians)
    section: Section  # The sheet's section there
    polygon: Array  # Column 1 seen along the line (m+2, 2), in f's coordinates
    lengths: Array  # Lengths of column 1's creases (m+1,)
    side: int  # Sign of v_1 below row 1 that rolls the sheet to f's side

    @property
    def ends(self) -> tuple[float, float]:
        """Lengths of column 1's first and last crease."""
        return float(self.lengths[0]), float(self.lengths[-1])


def find_target_state(
    profile: Profile,
    columns: Columns,
    rows: int,
    first_row: RowKind,
    *,
    drive: float | None = None,
    lengths: Array | None = None,
) -> TargetState:
    """Choose the target state, and column 1's lengths; refuse rows that cannot follow f.

    drive: None for the one at which column 1 turns as f does.
    lengths: Ratios of column 1's lengths (m+1,), or None for those that follow f.
    """
    if drive is None:
        drive = _drive_for(profile, columns, rows, first_row)
    require_before_end(drive, crease_end(columns, rows, first_row))
    side = profile.side
    found = Section.of(columns, rows, first_row, drive, side)
    if found.turning * side > 0:
        side = -side
        found = Section.of(columns, rows, first_row, drive, side)
    turns = found.turns
    _require_one_way(turns, profile)
    ideal = profile.polygon(turns / found.turning)
    steps = np.diff(ideal, axis=0)
    along = np.hypot(steps[:, 0], steps[:, 1])
    directions = np.arctan2(steps[0, 1], steps[0, 0]) + np.concatenate(
        [[0.0], np.cumsum(turns[1:-1])]
    )
    if lengths is None:
        _require_edges(profile, ideal, turns[1:-1] / abs(found.turning) * profile.turning)
        lengths = along / found.across
    else:
        lengths = lengths * (along.sum() / (lengths * found.across).sum())
    edges = lengths * found.across * np.exp(1j * directions)
    polygon = np.concatenate([[0.0], np.cumsum(edges)])
    return TargetState(drive, found, _fitted(polygon, ideal @ np.array([1, 1j])), lengths, side)


def require_before_end(drive: float, end: float) -> None:
    """Refuse a target state beyond the end of the motion (radians)."""
    if drive > end:
        raise DesignError(
            f"stage_deg = {in_degrees(drive)} is beyond the end of the motion",
            keys=("pattern.stage_deg",),
            size=f"a row crease is folded flat at {in_degrees(end)} degrees",
            candidates=chain(
                angles("stage_deg", 0.0, end, drive), [Remedy({"pattern.stage_deg": "auto"})]
            ),
            excess=(drive - end) / np.pi,
        )


def _fitted(polygon: Array, ideal: Array) -> Array:
    """Turn and move a polygon (K,) onto another, least squares over the vertices; (K, 2)."""
    centred, goal = polygon - polygon.mean(), ideal - ideal.mean()
    turn = (centred.conj() * goal).sum()
    fitted = centred * (turn / abs(turn)) + ideal.mean()
    return np.stack([fitted.real, fitted.imag], axis=-1)


def _drive_for(profile: Profile, columns: Columns, rows: int, first_row: RowKind) -> float:
    from scipy.optimize import brentq

    end = crease_end(columns, rows, first_row)
    begin = FIRST * float(np.abs(columns.sectors[0]).max())

    def turning(at: float, count: int = rows) -> float:
        return float(turnings(columns, count, first_row, np.array([at]), profile.side)[0])

    def follows(count: int) -> bool:
        """Whether this many rows turn as much as f at some drive, all the same way."""
        last = crease_end(columns, count, first_row)
        if not turning(begin, count) < profile.turning < turning(last, count):
            return False
        at = brentq(lambda x: turning(x, count) - profile.turning, begin, last)
        found = Section.of(columns, count, first_row, float(at), profile.side)
        return bool((found.turns * found.turning > 0).all())

    def candidates(*, fewer: bool) -> Iterator[Remedy]:
        counts = range(rows - 1, 0, -1) if fewer else range(rows + 1, 4 * rows + 40)
        count = next((each for each in counts if follows(each)), None)
        if count is not None and sheet_exists(columns, count, first_row):
            yield Remedy({"pattern.rows": count})
        yield AUTO_SECTORS

    if turning(begin) > profile.turning:
        raise DesignError(
            f"{rows} rows of these sector angles turn more than f, however little they fold",
            size=f"they turn by {in_degrees(turning(begin))} degrees at least, because rows fan "
            f"out in the flat sheet; f turns by {in_degrees(profile.turning)}",
            candidates=candidates(fewer=True),
            excess=(turning(begin) - profile.turning) / np.pi,
        )
    at = np.geomspace(begin, end, STEPS)
    enough = turnings(columns, rows, first_row, at, profile.side) >= profile.turning
    found = int(enough.argmax()) if enough.any() else STEPS
    for low, high in pairwise(at[max(found - 2, 0) :]):  # rounding may have moved it by one
        if turning(high) >= profile.turning:
            return float(
                brentq(lambda x: turning(x) - profile.turning, low, high, xtol=1e-15, rtol=1e-14)
            )
    raise DesignError(
        f"{rows} rows cannot turn as much as f",
        size=f"they turn by {in_degrees(turning(end))} degrees at the end of the motion; f turns "
        f"by {in_degrees(profile.turning)}",
        candidates=candidates(fewer=False),
        excess=(profile.turning - turning(end)) / np.pi,
    )


def _require_one_way(turns: Array, profile: Profile) -> None:
    wrong = np.flatnonzero(turns * profile.side >= 0)
    if len(wrong):
        row = int(np.clip(wrong[0], 1, max(1, len(turns) - 2)))
        raise DesignError(
            "rows of these sector angles turn to both sides, so they follow no convex curve",
            place=f"at row {row}",
            size=f"F and S rows turn by {in_degrees(turns[0])} and {in_degrees(turns[1])} degrees",
            candidates=[AUTO_SECTORS],
            excess=(turns * profile.side).max() / np.pi,
        )


def _require_edges(profile: Profile, ideal: Array, turns: Array) -> None:
    """Refuse a polygon with an edge that runs backwards: f bends too sharply for it."""
    steps = np.diff(ideal, axis=0) @ np.array([1, 1j])
    first = np.angle(steps[first_largest(np.abs(steps))])
    turned = np.concatenate([[0.0], np.cumsum(turns)])
    directions = np.exp(1j * (turned - turned[first_largest(np.abs(steps))] + first))
    forward = (steps * directions.conj()).real
    worst = first_smallest(forward)
    if forward[worst] > SHORTEST * np.abs(steps).sum():
        return
    trace = profile.trace
    near = first_smallest(np.hypot(*(trace.points - ideal[worst]).T))
    raise DesignError(
        "f bends too sharply for rows that all turn by the same angle",
        place=f"at parameter {trace.curve.as_drawn(trace.t[near]):.6g} of f, row {max(worst, 1)}",
        size=f"the crease there would be {plain(forward[worst])} long",
        candidates=[Remedy({"pattern.column_lengths": [1.0] * (len(turns) + 1)})],
        excess=SHORTEST - forward[worst] / np.abs(steps).sum(),
    )
