"""What a crease pattern does, in rows that are independent, worst first."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from orishell.conventions.formatting import in_degrees
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.quantities import quantity
from orishell.conventions.record import as_table, record
from orishell.conventions.row import ORDER, Row
from orishell.families.recognised import Recognised, recognise
from orishell.motion.crease_pattern import CreasePattern
from orishell.motion.following.dofs import Freedom
from orishell.numerics.arrays import Array
from orishell.verification.pattern.motion import FoldingMotion, Still, find_motion
from orishell.verification.pattern.on_grid import OnGrid
from orishell.verification.pattern.vertices import VertexConditions, find_conditions

ROUNDING = 64 * np.finfo(float).eps
"""What the last digits of coordinates may leave, relative to the sheet's diagonal."""
LISTED = 100
"""Vertices that a report lists, at most."""


@record
class PatternVerdict:
    """What was found of a pattern, and what is not known."""

    panels: int
    vertices: int
    creases: int
    inner_vertices: int
    flat: bool  # whether there is a flat sheet: the pattern is developable
    tolerance: float  # allowed error of lengths relative to the sheet's diagonal
    # None of what follows is there without a flat sheet
    conditions: VertexConditions | None
    recognised: Recognised | None  # the family of ours that it belongs to, or None
    motion: FoldingMotion | Still | None
    rows: tuple[Row, ...]  # the verdict, worst first

    @property
    def passed(self) -> bool:
        """Whether nothing speaks against the pattern; what is not known does not."""
        return all(row.sign != "fails" for row in self.rows)

    @property
    def degrees_of_freedom(self) -> int | None:
        """That of all states looked at; None if they differ, or no gap tells, or there are none."""
        counts = {each.count for each in _freedom(self.motion)}
        return counts.pop() if len(counts) == 1 else None

    def as_dict(self) -> dict[str, Any]:
        """The report that ``orishell check --json`` prints."""
        found: dict[str, Any] = {
            "passed": self.passed,
            "panels": self.panels,
            "vertices": self.vertices,
            "creases": self.creases,
            "inner_vertices": self.inner_vertices,
            "developable": self.flat,
            "tolerance": self.tolerance,
            "degrees_of_freedom": self.degrees_of_freedom,
            "verdict": as_table(self.rows),
            "recognised": as_table(self.recognised),
        }
        if self.conditions is not None:
            found["not_kawasaki"] = self.conditions.not_kawasaki[:LISTED].tolist()
            found["not_maekawa"] = self.conditions.not_maekawa[:LISTED].tolist()
        if isinstance(self.motion, FoldingMotion):
            motion = self.motion
            found["motion"] = {
                "way": motion.way,
                "letters": motion.letters.tolist(),
                "miss": motion.miss if np.isfinite(motion.miss) else None,
                "worst_vertex": motion.worst_vertex,
                "play": motion.play if np.isfinite(motion.play) else None,
                "reached_deg": float(np.rad2deg(motion.reached)),
                "ends": motion.ends,
                "clear_until_deg": None
                if motion.clear_until is None
                else float(np.rad2deg(motion.clear_until)),
                "first_contact": None if motion.contact is None else list(motion.contact.panels),
            }
        return found


def judge_pattern(
    pattern: CreasePattern,
    *,
    unit: str = "unit",
    tolerance: float = 1e-6,
    progress: Progress = no_progress,
) -> PatternVerdict:
    """Say of a flat crease pattern whether and how it folds.

    Parameters
    ----------
    pattern
        The flat sheet.
    unit
        Its unit of length, for words.
    tolerance
        Allowed error of lengths relative to the sheet's diagonal; an angle may be wrong by as much
        as that over the shortest crease at its vertex.
    """
    shortest = shortest_creases(pattern)
    size = float(np.linalg.norm(np.ptp(pattern.vertices, axis=0)))
    limits = tolerance * size / shortest
    conditions = find_conditions(pattern, limits)
    grid = OnGrid.of(pattern)
    motion = find_motion(pattern, grid, float(limits.max(initial=0.0)), progress)
    known = None
    if grid is not None:
        known = recognise(grid.flat, grid.signs, float(limits.max()))
    judged = _Judged(pattern, unit, conditions, known, motion, tolerance * size, ROUNDING * size)
    rows = sorted(judged.rows(), key=lambda row: ORDER.index(row.sign))
    return PatternVerdict(
        panels=len(pattern.faces),
        vertices=len(pattern.vertices),
        creases=int(pattern.crease.sum()),
        inner_vertices=len(pattern.inner),
        flat=True,
        tolerance=tolerance,
        conditions=conditions,
        recognised=known,
        motion=motion,
        rows=tuple(rows),
    )


@record
class _Judged:
    """What was found, to be said in rows."""

    pattern: CreasePattern
    unit: str
    conditions: VertexConditions
    known: Recognised | None
    motion: FoldingMotion | Still
    tolerance: float  # allowed error of lengths (length)
    rounding: float  # what the last digits of coordinates leave of it (length)

    def rows(self) -> Iterator[Row]:
        """All rows."""
        count = len(self.pattern.inner)
        yield Row("holds", "sheet", f"developable: sectors add up to 360 degrees at {_all(count)}")
        yield self._flat_folded()
        yield from self._family()
        if isinstance(self.motion, Still):
            if self.motion.proved:
                yield Row("fails", "folds", f"no: {self.motion.reason}")
            else:
                yield Row("warns", "folds", f"not known: {self.motion.reason}")
            return
        motion = self.motion
        yield self._folds(motion)
        found = int((motion.letters != self.pattern.letters).sum())
        if found:
            letters = f"{found} creases fold that had no letter: one way of several, perhaps"
            yield Row("says", "letters", letters)
        if self._closed(motion, self.tolerance) > 1:
            yield _of_freedom(motion.freedom)
            yield self._reaches(motion)

    def _flat_folded(self) -> Row:
        """Kawasaki's and Maekawa's conditions."""
        conditions = self.conditions
        count, faults = len(conditions.vertices), []
        worst = conditions.not_kawasaki
        if len(worst):
            miss = float(conditions.kawasaki[conditions.vertices == worst[0]][0])
            by = f"by {in_degrees(miss)} degrees" if np.isfinite(miss) else "an odd vertex"
            faults.append(
                f"Kawasaki's condition fails at {_of(len(worst), count)}, most at vertex "
                f"{worst[0]} ({by})"
            )
        worst = conditions.not_maekawa
        if len(worst):
            faults.append(
                f"Maekawa's condition fails at {_of(len(worst), count)}, for one at vertex "
                f"{worst[0]}"
            )
        unknown = int(np.isnan(conditions.maekawa).sum())
        if unknown:
            faults.append(f"Maekawa's condition is not known at {_of(unknown, count)}")
        if faults:
            return Row("says", "vertices", "; ".join(faults))
        return Row("holds", "vertices", f"Kawasaki and Maekawa hold at {_all(count)}, one by one")

    def _family(self) -> Iterator[Row]:
        known = self.known
        if known is not None:
            also = f" (also {', '.join(known.also)})" if known.also else ""
            sides = [
                f"{number} {name}"
                for number, name in zip(
                    known.beside, ("above", "below", "left", "right"), strict=True
                )
                if number
            ]
            apart = (
                f"; but for lines of vertices at its border: {', '.join(sides)}" if sides else ""
            )
            finding = f"{known.family}{also}: sectors to {known.miss:.1g} rad{apart}"
            yield Row("says", "family", finding)

    def _closed(self, motion: FoldingMotion, error: float) -> int:
        """How many states close to an error of lengths."""
        at = np.searchsorted(self.pattern.inner, motion.vertices)
        return motion.closed_states(error / shortest_creases(self.pattern)[at], error)

    def _folds(self, motion: FoldingMotion) -> Row:
        states = len(motion.drives)
        closed = f"vertices close to {motion.miss:.1g} rad in {states} states"
        if self._closed(motion, self.rounding) == states:
            whole = self.known is not None and not any(self.known.beside)
            if motion.way == "followed":
                said = f"as far as numbers tell: {closed}, followed"
            elif (
                whole
                and self.known is not None
                and self.known.miss <= self.rounding / float(shortest_creases(self.pattern).min())
            ):
                said = f"exactly as {self.known.family} sheets do: {closed}"
            else:
                said = f"to rounding: {closed}, by a closed form"
            return Row("holds", "folds", f"rigidly, {said}")
        count = self._closed(motion, self.tolerance)
        if count == states:
            play = quantity(motion.play, self.unit)
            said = f"{closed}; hinges need a play of {play}"
            return Row("holds", "folds", f"rigidly, to the tolerance: {said}")
        beyond = (
            f"vertices miss closing by {motion.misses[count].max():.1g} rad at "
            f"{in_degrees(motion.drives[count])} degrees, most at vertex "
            f"{motion.vertices[motion.misses[count].argmax()]}"
        )
        if count > 1:
            upto = in_degrees(motion.drives[count - 1])
            return Row("warns", "folds", f"to the tolerance up to {upto} degrees; there {beyond}")
        half = int(np.abs(motion.drives - np.pi / 2).argmin())
        at_half = f"{motion.misses[half].max():.1g} at {in_degrees(motion.drives[half])}"
        return Row("fails", "folds", f"not with these letters: {beyond}, {at_half}")

    def _reaches(self, motion: FoldingMotion) -> Row:
        count = self._closed(motion, self.tolerance)
        reached = f"{in_degrees(motion.drives[count - 1])} degrees"
        ends = motion.ends if count == len(motion.drives) else "beyond it does not close"
        if motion.clear_until is None:
            return Row("warns", "reaches", f"{reached}: {ends}; contact of panels is not known")
        if motion.contact is None:
            return Row("holds", "reaches", f"{reached}: {ends}; nothing meets before (proved)")
        first, second = motion.contact.panels
        return Row(
            "warns",
            "reaches",
            f"{in_degrees(motion.contact.drive)} degrees: panels {first} and {second} meet there, "
            f"counted row by row; nothing meets before (proved)",
        )


def shortest_creases(pattern: CreasePattern) -> Array:
    """The shortest crease (I,) at every inner vertex."""
    creases, ends = pattern.fans
    if not creases.size:
        return np.zeros(len(creases))
    way = pattern.vertices[ends] - pattern.vertices[pattern.inner][:, None]
    lengths = np.where(creases >= 0, np.linalg.norm(way, axis=-1), np.inf)
    return np.asarray(lengths.min(axis=1))


def _freedom(motion: FoldingMotion | Still | None) -> tuple[Freedom, ...]:
    return motion.freedom if isinstance(motion, FoldingMotion) else ()


def _of_freedom(freedom: tuple[Freedom, ...]) -> Row:
    """Degrees of freedom, and the gap that tells them."""
    if not freedom:
        return Row("warns", "freedom", "not known: a sheet that folds to a tolerance has none")
    counts = {each.count for each in freedom}
    if len(counts) != 1 or None in counts:
        return Row(
            "warns", "freedom", "not known: no gap of singular values tells it in all states"
        )
    (count,) = counts
    zero = max(each.largest_zero for each in freedom)
    other = min(each.least_other for each in freedom)
    ways = "1 degree" if count == 1 else f"{count} degrees"
    below = f"{zero:.1g} below" if zero > 0 else "none below,"
    return Row(
        "says",
        "freedom",
        f"{ways} in {len(freedom)} folded states (singular values: {below} and {other:.1g} above)",
    )


def _all(count: int) -> str:
    return "its inner vertex" if count == 1 else f"all {count} inner vertices"


def _of(some: int, count: int) -> str:
    return f"{some} of {count} inner vertices"
