"""What a crease pattern does, in rows that are independent, worst first."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.record import as_table, record
from orishell.conventions.row import ORDER, Row
from orishell.families.drawn.nearest import Nearby
from orishell.families.recognised import Recognised, recognise
from orishell.io import ReadPattern
from orishell.motion.crease_pattern import CreasePattern
from orishell.motion.following.hinge_gaps import COORDINATE_ROUNDING
from orishell.verification.pattern.in_strips import FoldingStrips, find_folding_strips
from orishell.verification.pattern.motion import ALL, Asked, FoldingMotion, Still, find_motion
from orishell.verification.pattern.on_grid import OnGrid
from orishell.verification.pattern.rows import Judged, of_vertices, said_of_motion
from orishell.verification.pattern.states import examine_states
from orishell.verification.pattern.vertices import (
    VertexConditions,
    find_conditions,
    shortest_creases,
)
from orishell.verification.run import LENGTH_TOLERANCE

LISTED = 100
"""Vertices that a report lists, at most."""


@record
class Findings:
    """What was found of a flat sheet."""

    pattern: CreasePattern
    conditions: VertexConditions
    recognised: Recognised | None  # the family of ours that it belongs to, or None
    motion: FoldingMotion | Still


@record
class PatternVerdict:
    """What was found of a pattern, and what is not known."""

    read: ReadPattern  # the file
    tolerance: float  # allowed error of lengths relative to the sheet's diagonal
    findings: Findings | None  # None if there is no flat sheet
    rows: tuple[Row, ...]  # the verdict, worst first
    # how it folds where it is no flat sheet, but made in strips of a family of ours; else None
    strips: FoldingStrips | None = None

    @property
    def passed(self) -> bool:
        """Whether nothing speaks against the pattern; what is not known does not."""
        return all(row.sign != "fails" for row in self.rows)

    @property
    def degrees_of_freedom(self) -> int | None:
        """That of all states looked at; None if they differ, or no gap tells, or there are none."""
        if self.strips is not None:
            return self.strips.degrees_of_freedom
        motion = None if self.findings is None else self.findings.motion
        return motion.degrees_of_freedom if isinstance(motion, FoldingMotion) else None

    @property
    def nearby(self) -> Nearby | None:
        """A sheet nearby that folds; None if there is no need, or none was found."""
        motion = None if self.findings is None else self.findings.motion
        return motion.nearby if isinstance(motion, FoldingMotion) else None

    def as_dict(self) -> dict[str, Any]:
        """The report that ``orishell check --json`` prints."""
        read, found = self.read, self.findings
        report: dict[str, Any] = {
            "file": str(read.path),
            "unit": read.unit,
            "passed": self.passed,
            "panels": len(read.faces),
            "edges": len(read.edges),
            "tolerance": self.tolerance,
            "developable": found is not None,
            "verdict": as_table(self.rows),
            "notes": list(read.notes),
        }
        if self.strips is not None:
            freedom = {"degrees_of_freedom": self.degrees_of_freedom}
            return {**report, "strips": self.strips.as_dict(), **freedom}
        if found is None:
            return report
        return {
            **report,
            "vertices": len(found.pattern.vertices),
            "inner_vertices": len(found.pattern.inner),
            "not_kawasaki": found.conditions.not_kawasaki[:LISTED].tolist(),
            "not_maekawa": found.conditions.not_maekawa[:LISTED].tolist(),
            "recognised": as_table(found.recognised),
            "degrees_of_freedom": self.degrees_of_freedom,
            "motion": said_of_motion(found.motion),
        }


def judge_pattern(
    read: ReadPattern,
    *,
    tolerance: float = LENGTH_TOLERANCE,
    inspected: bool = False,
    progress: Progress = no_progress,
    so_far: Callable[[tuple[Row, ...]], object] = tuple,
) -> PatternVerdict:
    """Say of a crease pattern whether and how it folds.

    Parameters
    ----------
    read
        What :func:`~orishell.io.read_pattern` found in a file.
    tolerance
        Allowed error of lengths relative to the sheet's diagonal; an angle may be wrong by as much
        as that over the shortest crease at its vertex.
    inspected
        Whether its folded states are examined elsewhere.
    progress
        Is told the share that is done.
    so_far
        Is told the rows that are known before a motion is looked for, which takes the longest.
    """
    rows: list[Row] = []
    findings, strips = None, None
    if read.flat is None:
        strips = find_folding_strips(read, tolerance, progress)
    if strips is not None:
        rows += strips.rows()
    elif read.flat is None:
        rows.append(Row("fails", "sheet", f"none that is flat: {read.not_flat.rstrip('.')}"))
    else:
        findings, found = judge_sheet(
            read.flat, read.unit, tolerance=tolerance, progress=progress, so_far=so_far
        )
        rows += found
    unseen = read.states and not inspected and strips is None
    if unseen and read.flat is not None:
        rows += examine_states(read, read.flat, tolerance * read.flat.diagonal)
    elif unseen:
        said = f"{len(read.states)} folded states are not examined: there is no flat sheet"
        rows.append(Row("warns", "states", said))
    rows.sort(key=lambda row: ORDER.index(row.sign))
    return PatternVerdict(read, tolerance, findings, tuple(rows), strips)


def judge_sheet(
    pattern: CreasePattern,
    unit: str,
    *,
    tolerance: float = LENGTH_TOLERANCE,
    asked: Asked = ALL,
    progress: Progress = no_progress,
    so_far: Callable[[tuple[Row, ...]], object] = tuple,
) -> tuple[Findings, list[Row]]:
    """Find how a flat sheet folds, and say so.

    Parameters
    ----------
    unit
        Unit of length.
    tolerance
        As of :func:`judge_pattern`.
    asked
        Which motion.
    progress, so_far
        As of :func:`judge_pattern`.

    Raises
    ------
    InputError
        If there is no such choice of mountains and valleys.
    """
    error, rounding = tolerance * pattern.diagonal, COORDINATE_ROUNDING * pattern.diagonal
    limits = error / shortest_creases(pattern)
    most = float(limits.max(initial=0.0))
    grid = OnGrid.of(pattern)
    known = None if grid is None else recognise(grid.flat, grid.signs, most)
    conditions = find_conditions(pattern, limits)
    so_far(tuple(of_vertices(pattern, conditions)))
    motion = find_motion(pattern, grid, most, asked, progress)
    judged = Judged(pattern, unit, conditions, known, motion, error, rounding, asked.choice)
    rows = sorted(judged.rows(), key=lambda row: ORDER.index(row.sign))
    return Findings(pattern, conditions, known, motion), rows
