"""What was found of a crease pattern, said in rows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from orishell.clash import PathContact
from orishell.conventions.formatting import in_degrees, tidy_degrees
from orishell.conventions.quantities import quantity
from orishell.conventions.record import record
from orishell.conventions.row import Row
from orishell.families.drawn.nearest import MOST_MOVED
from orishell.families.drawn.signs import MOST_WAYS
from orishell.families.recognised import Recognised
from orishell.motion.crease_pattern import CreasePattern
from orishell.motion.following.dofs import Freedom, least_count
from orishell.numerics.equals import first_largest
from orishell.verification.pattern.loose import MOST_PANELS, WIDEST, LooseMotion
from orishell.verification.pattern.motion import FoldingMotion, Still
from orishell.verification.pattern.vertices import VertexConditions, shortest_creases


@record
class Judged:
    """What was found, to be said in rows."""

    pattern: CreasePattern
    unit: str
    conditions: VertexConditions
    known: Recognised | None
    motion: FoldingMotion | Still
    tolerance: float  # allowed error of lengths (length)
    rounding: float  # what the last digits of coordinates leave of it (length)
    choice: int = 1  # which choice of mountains and valleys is taken, where letters are missing

    def rows(self) -> Iterator[Row]:
        """All rows."""
        yield from of_vertices(self.pattern, self.conditions)
        if self.known is not None:
            yield self.known.row
        if isinstance(self.motion, Still):
            if self.motion.proved:
                yield Row("fails", "folds", f"no: {self.motion.reason}")
            else:
                yield Row("warns", "folds", f"not known: {self.motion.reason}")
            return
        motion = self.motion
        folds = self._folds(motion)
        yield replace(folds, finding=folds.finding + self._staying(motion))
        yield from of_letters(self.pattern, motion.choices, self.choice)
        if motion.loose is not None or self._closes(motion, self.tolerance):
            yield self._freedom(motion)
            yield self._reaches(motion)

    def _closes(self, motion: FoldingMotion, error: float) -> bool:
        """Whether all states close to an error of lengths."""
        at = np.searchsorted(self.pattern.inner, motion.vertices)
        return motion.closes(error / shortest_creases(self.pattern)[at], error)

    def _closed(self, motion: FoldingMotion) -> str:
        """How exactly its states close."""
        said = []
        if len(motion.vertices):
            said.append(f"vertices close to {motion.miss:.1g} rad")
        if motion.holes:
            what = "a hole or cut" if motion.holes == 1 else f"{motion.holes} holes or cuts"
            said.append(f"panels round {what} to {self._length(motion.play)}")
        states = f"in {len(motion.drives)} states"
        return f"{', '.join(said)} {states}" if said else f"nothing has to close {states}"

    def _staying(self, motion: FoldingMotion) -> str:
        """How many creases that might fold stay flat; empty if none does."""
        might = self.pattern.crease & (self.pattern.signs != 0)
        flat = int((might & ~motion.folding).sum())
        return f"; {flat} of {int(might.sum())} creases stay flat" if flat else ""

    def _folds(self, motion: FoldingMotion) -> Row:
        closed = self._closed(motion)
        if self._closes(motion, self.rounding):
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
        if motion.loose is not None:
            return self._folds_loosely(motion, motion.loose)
        if self._closes(motion, self.tolerance):
            said = f"{closed}; hinges need a play of {quantity(motion.play, self.unit)}"
            return Row("holds", "folds", f"rigidly, to the tolerance: {said}")
        said = f"not with these letters: {self._missed(motion)}"
        if len(self.pattern.faces) > MOST_PANELS:
            said += f"; how far hinges must give way is not looked at beyond {MOST_PANELS} panels"
        return Row("fails", "folds", said, self._nearby(motion))

    def _missed(self, motion: FoldingMotion) -> str:
        half = motion.half_way
        at = f"at {in_degrees(motion.drives[half])} degrees"
        misses = motion.misses[half]
        torn = motion.plays[half] > misses.max(initial=0.0) * self.pattern.diagonal
        if len(misses) and not (motion.holes and torn):
            worst = motion.vertices[first_largest(misses)]
            return f"vertices miss closing by {misses.max():.1g} rad {at}, most at vertex {worst}"
        return f"panels part by {self._length(motion.plays[half])} {at}, round a hole"

    def _folds_loosely(self, motion: FoldingMotion, loose: LooseMotion) -> Row:
        gap = (
            f"hinges give way by {self._length(loose.gap)} (at {in_degrees(loose.widest)} degrees)"
        )
        looked = f"{gap}, in {len(loose.drives)} states up to {in_degrees(loose.until)} degrees"
        if not loose.complete:
            share = f"{100 * WIDEST:g} % of the shortest crease"
            looked += f"; beyond, they would by more than {share}, or no state is found"
        if loose.complete and loose.gap <= self.tolerance:
            return Row("holds", "folds", f"rigidly, to the tolerance: {looked}")
        said = f"nearly: panels stay rigid if {looked}; else "
        return Row("fails", "folds", said + self._missed(motion), self._nearby(motion))

    def _freedom(self, motion: FoldingMotion) -> Row:
        loose = motion.loose
        return of_freedom(motion.freedom, "" if loose is None else self._gap(loose))

    def _length(self, value: float) -> str:
        return quantity(value, self.unit, 2)

    def _gap(self, loose: LooseMotion) -> str:
        return f"a hinge gap of {self._length(loose.gap)}"

    def _reaches_loosely(self, loose: LooseMotion) -> Row:
        """How far it folds with hinges that give way, and which panels come near."""
        gap = self._gap(loose)
        looked = f"looked at every {in_degrees(loose.apart)} degrees, between not proved"
        free = f"free of contact in {loose.clear} states to within {gap}"
        if loose.near is None:
            said = f"{in_degrees(loose.until)} degrees at least: {free}, {looked}"
            return Row("says", "reaches", said)
        first, second = loose.near
        said = (
            f"not known beyond {in_degrees(loose.clear_until)} degrees: at "
            f"{in_degrees(float(loose.drives[loose.clear]))} panels {first} and {second} meet, or "
            f"are nearer than {gap}; before, {free}, {looked}"
        )
        return Row("warns", "reaches", said)

    def _reaches(self, motion: FoldingMotion) -> Row:
        if motion.loose is not None:
            return self._reaches_loosely(motion.loose)
        reached, ends = f"{in_degrees(motion.reached)} degrees", motion.ends
        if motion.proof is not None:
            return reaches_as_proved(
                motion.reached, ends, motion.proved_clear, motion.proof.contact, self.unit
            )
        seen = motion.seen
        if seen is None:
            return Row("warns", "reaches", f"{reached}: {ends}; contact of panels is not known")
        looked = f"looked at every {in_degrees(seen.apart)} degrees, between not proved"
        if seen.met is None or seen.panels is None:
            none = f"no contact seen up to {in_degrees(seen.clear)} degrees"
            return Row("says", "reaches", f"{reached}: {ends}; {none}, {looked}")
        first, second = seen.panels
        said = f"panels {first} and {second} meet there; {looked}"
        return Row("warns", "reaches", f"{in_degrees(seen.met)} degrees: {said}")

    def _nearby(self, motion: FoldingMotion) -> str:
        """How far vertices are to be moved so that it folds; empty if that is not known."""
        if motion.nearby is None:
            large = len(self.pattern.vertices) > MOST_MOVED
            return f"a sheet nearby is looked for up to {MOST_MOVED} vertices" if large else ""
        moved = np.linalg.norm(motion.nearby.vertices - self.pattern.vertices, axis=1)
        nearest = "; of its kind none near it is nearer" if motion.nearby.nearest else ""
        return (
            f"a sheet nearby folds, its vertices moved by up to "
            f"{quantity(float(moved.max()), self.unit)}, most at vertex {first_largest(moved)} "
            f"(tried){nearest}"
        )


def reaches_as_proved(
    reached: float, ends: str, clear: float, contact: PathContact | None, unit: str
) -> Row:
    """How far it is proved to fold, and what meets there or is not proved not to.

    Parameters
    ----------
    reached, ends
        The largest fold angle at the end of the motion (radians), and why it ends there.
    clear
        The drive up to which it is proved that nothing meets (radians).
    contact
        What meets there, or may; None if nothing does.
    unit
        Unit of length.
    """
    upto = f"{in_degrees(clear)} degrees"
    proved = f"nothing meets up to {upto} (proved)"
    if contact is None:
        return Row("holds", "reaches", f"{in_degrees(reached)} degrees: {ends}; {proved}")
    first, second = contact.panels
    if contact.apart is None:
        said = f"panels {first} and {second} meet there"
        return Row("warns", "reaches", f"{in_degrees(contact.drive)} degrees: {said}; {proved}")
    apart = quantity(contact.apart, unit, 2)
    said = f"panels {first} and {second} are {apart} apart there and may meet"
    return Row("warns", "reaches", f"not proved beyond {upto}: {said}; {proved}")


def of_vertices(pattern: CreasePattern, conditions: VertexConditions) -> Iterator[Row]:
    """What is known before any motion is looked for."""
    count = len(pattern.inner)
    if not count:
        yield Row("holds", "sheet", "developable: no vertex is surrounded by panels")
        return
    yield Row("holds", "sheet", f"developable: sectors add up to 360 degrees at {_all(count)}")
    yield _flat_folded(conditions)


def _flat_folded(conditions: VertexConditions) -> Row:
    """Kawasaki's and Maekawa's conditions."""
    count, faults = len(conditions.vertices), []
    if not count:
        return Row("says", "vertices", "no crease at any of them is to fold")
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
            f"Maekawa's condition fails at {_of(len(worst), count)}, for one at vertex {worst[0]}"
        )
    unknown = int(np.isnan(conditions.maekawa).sum())
    if unknown:
        faults.append(f"Maekawa's condition is not known at {_of(unknown, count)}")
    if faults:
        return Row("says", "vertices", "; ".join(faults))
    return Row("holds", "vertices", f"Kawasaki and Maekawa hold at {_all(count)}, one by one")


def said_of_motion(motion: FoldingMotion | Still) -> dict[str, Any]:
    """The figures of a motion, as reports have them."""
    if isinstance(motion, Still):
        return {"found": False, "proved": motion.proved, "reason": motion.reason}
    proof, seen = motion.proof, motion.seen
    met = proof.contact if proof is not None else None
    unproved = None
    if met is not None and met.apart is not None:
        unproved = {"panels": list(met.panels), "apart": met.apart}
        met = None
    return {
        "found": True,
        "way": motion.way,
        "letters": motion.letters.tolist(),
        "miss": motion.miss if np.isfinite(motion.miss) else None,
        "worst_vertex": motion.worst_vertex,
        "play": motion.play if np.isfinite(motion.play) else None,
        "reached_deg": tidy_degrees(motion.reached),
        "ends": motion.ends,
        "proved_clear_to_deg": tidy_degrees(motion.proved_clear),
        "first_contact": list(met.panels) if met else list(seen.panels or ()) if seen else [],
        "contact_deg": tidy_degrees(met.drive)
        if met
        else tidy_degrees(seen.met)
        if seen and seen.met
        else None,
        "not_proved": unproved,
        "hinge_gap": None if motion.loose is None else said_of_gap(motion.loose),
        "nearby": None if motion.nearby is None else motion.nearby.vertices.tolist(),
        "nearby_leaves": None if motion.nearby is None else motion.nearby.leaves,
        "nearby_is_nearest": motion.nearby is not None and motion.nearby.nearest,
        "choices": list(motion.choices),
    }


def said_of_gap(loose: LooseMotion) -> dict[str, Any]:
    """The figures of a motion whose hinges give way."""
    return {
        "gap": loose.gap,
        "at_deg": tidy_degrees(loose.widest),
        "states": len(loose.drives),
        "until_deg": tidy_degrees(loose.until),
        "gaps": loose.gaps.tolist(),
        "clear_states": loose.clear,
        "clear_until_deg": tidy_degrees(loose.clear_until),
        "near": list(loose.near or ()),
    }


def of_letters(pattern: CreasePattern, choices: Sequence[str], taken: int = 1) -> Iterator[Row]:
    """How many creases have no letter, and how many choices fold the sheet.

    Choices have a letter for every edge; there are none if they are not known. Where some creases
    of one stay flat, others may fold in their place, and not all are found.
    """
    unknown = pattern.crease & np.isnan(pattern.signs)
    missing = int(unknown.sum())
    if not missing:
        return
    count = len(choices)
    creases = "1 crease has" if missing == 1 else f"{missing} creases have"
    if not count:
        said = "those found are one choice of several, perhaps"
    else:
        flat = any("F" in np.array(list(word))[unknown] for word in choices)
        number = f"{count} or more" if count == MOST_WAYS or flat else str(count)
        over = "" if np.isin(pattern.letters, ["M", "V"]).any() else ", up to turning it over"
        said = f"{number} choices fold it{over}, of which number {taken} is taken"
        if number == "1":
            said = f"one choice folds it{over}"
    yield Row("says", "letters", f"{creases} none: {said}")


def of_freedom(states: Sequence[Freedom], within: str = "") -> Row:
    """Degrees of freedom in states, and the gap that tells them, to within a gap of hinges."""
    if not states:
        return Row("warns", "freedom", "not known: what folds to a tolerance only has none")
    count = least_count(states)
    if count is None:
        return Row("warns", "freedom", "not known: no gap between numbers tells it")
    alike = [each for each in states if each.count == count]
    zero = max(each.largest_zero for each in alike)
    other = min(each.least_other for each in alike)
    ways = "1 degree of freedom" if count == 1 else f"{count} degrees of freedom"
    below = f"{zero:.1g} below" if zero > 0 else "none below,"
    ways += f" in {len(alike)} folded states" + (f", to within {within}" if within else "")
    told = "singular values" if any(each.by_rank for each in alike) else "rates at vertices"
    said = f"{ways} ({told}: {below} and {other:.1g} above)" if np.isfinite(other) else ways
    if count > 1:
        said += ": this is one of many motions"
    felt = [each.nearly for each in alike if each.nearly is not None]
    if felt and min(felt) > count:
        weak = "some creases that join its parts hardly fold"
        return Row("warns", "freedom", f"{said}, and nearly {min(felt)}: {weak}")
    return Row("says", "freedom", said)


def _all(count: int) -> str:
    return "its inner vertex" if count == 1 else f"all {count} inner vertices"


def _of(some: int, count: int) -> str:
    return f"{some} of {count} inner vertices"
