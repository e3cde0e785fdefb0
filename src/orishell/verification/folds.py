"""Whether the fold angles, mountains and valleys that the file gives fit its coordinates."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from orishell.motion.crease_pattern import SENSE
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.numerics.equals import largest_of
from orishell.verification.findings import Check, Names, Worst
from orishell.verification.residuals import SignsSeen, meets_maekawa, turn_between
from orishell.verification.sheet import Sheet, State


class FoldAngleTest:
    """Tests that the fold angles that a frame gives are those of its coordinates.

    The fold angles given by the flat sheet are those of a folded state, perhaps of none in the
    file. They are compared with the folded frame with which most creases agree, if half of those
    that are to fold do with any.
    """

    def __init__(self, sheet: Sheet, names: Names, letters: NDArray[np.str_] | None) -> None:
        self._sheet, self._letters = sheet, letters
        self._worst = Worst(names.edge)
        self._pattern = self._given(sheet.frame.fold_angles) if sheet.flat else None
        self._agreeing = 0
        self._best: tuple[int, Array] | None = None
        self.frames_without: list[int] = []

    def see(self, state: State) -> None:
        """Compare one frame."""
        sheet, frame = self._sheet, state.frame
        own = sheet.flat and frame is sheet.frame
        if self._pattern is not None and not own:
            turn = turn_between(state.folds, self._pattern)
            agreeing = int((turn <= sheet.edge_limits)[self._asked].sum())
            if agreeing >= self._agreeing:
                self._agreeing, self._best = agreeing, (frame.number, turn)
        if own:
            return
        given = self._given(frame.fold_angles)
        if given is None:
            self.frames_without.append(frame.number)
        else:
            self._compare(turn_between(state.folds, given), frame.number)

    @property
    def pattern_untested(self) -> bool:
        """Whether the flat sheet's fold angles are those of no frame."""
        return 2 * self._agreeing < int(self._asked.sum())

    @property
    def _asked(self) -> Booleans:
        """Which creases (E,) the flat sheet gives fold angles of, other than 0."""
        if self._pattern is None:
            return np.zeros(len(self._sheet.mesh.edges), np.bool_)
        return np.asarray(self._sheet.mesh.crease & (np.nan_to_num(self._pattern) != 0))

    def checks(self) -> list[Check]:
        """The outcome of the test, if fold angles are given."""
        if self._best is not None and self._asked.any() and not self.pattern_untested:
            self._compare(self._best[1], self._sheet.frame.number)
        return self._worst.checks("fold_angle", "edges_foldAngle is off by {} rad", "edges")

    def _given(self, angles: Array | None) -> Array | None:
        """The given angles (E,), NaN where they say nothing: 0 stands for unassigned too."""
        if angles is None:
            return None
        silent = (self._sheet.mesh.edge_faces < 0).all(axis=1)
        if self._letters is not None:
            silent = silent | ((self._letters == "U") & (angles == 0))
        return np.where(silent, np.nan, angles)

    def _compare(self, turn: Array, frame: int) -> None:
        numbers = np.flatnonzero(~np.isnan(turn))
        self._worst.see(turn[numbers], self._sheet.edge_limits[numbers], frame, numbers)


class AssignmentTest:
    """Tests that creases fold as they are assigned, and that no mountain becomes a valley."""

    def __init__(self, sheet: Sheet, names: Names, letters: NDArray[np.str_] | None) -> None:
        self._sheet, self._names, self._letters = sheet, names, letters
        self._sense = _senses(letters, len(sheet.mesh.edges))
        self._seen = SignsSeen(len(self._sense))
        self._misfits: dict[int, tuple[float, str]] = {}
        self._changes: dict[int, int] = {}

    def see(self, state: State) -> None:
        """Compare one frame: what it gives, and what its coordinates are."""
        sheet, frame = self._sheet, state.frame
        given = frame.fold_angles
        if given is not None:
            self._compare(np.nan_to_num(given), f"given in frame {frame.number}", ends=True)
        self._compare(state.folds, f"in frame {frame.number}", ends=False)
        sign = self._signs(state.folds, ends=False) * sheet.mesh.crease
        for edge in np.flatnonzero(self._seen.see(sign)):
            self._changes.setdefault(int(edge), frame.number)

    @property
    def never_folded(self) -> int:
        """Number of mountains and valleys that are unfolded or folded flat in every frame."""
        assigned = self._sheet.mesh.crease & (np.abs(self._sense) == 1)
        return int((assigned & ~self._seen.mountain & ~self._seen.valley).sum())

    @property
    def unassigned(self) -> int:
        """Number of creases of unknown assignment."""
        return int((self._sheet.mesh.crease & np.isnan(self._sense)).sum())

    def checks(self, *, folded: bool) -> list[Check]:
        """The outcome of the test; of changes of sign only if there are folded frames."""
        found = []
        names, letters = self._names, self._letters
        if letters is not None:
            for edge in np.flatnonzero(self._wrong_border(letters)).tolist():
                beside = int((self._sheet.mesh.edge_faces[edge] >= 0).sum())
                what = "1 panel" if beside == 1 else f"{beside} panels"
                self._misfits[edge] = (np.inf, f"between {what}")
            text = "no crease folds against edges_assignment"
            if self.unassigned == self._sheet.mesh.crease.sum():
                text = "edges_assignment says of no crease how it folds"
            facts: dict[str, object] = {"beyond": len(self._misfits)}
            if self._misfits:
                edge, (_, says) = largest_of(self._misfits.items(), lambda item: item[1][0])
                text = (
                    f"{len(self._misfits)} edges do not fit edges_assignment, first "
                    f"{names.edge(edge)}, {letters[edge]} but {says}"
                )
                if self._all_against():
                    text += "; all signs are opposite: the sheet is seen from the other side"
                facts |= names.edge(edge).facts
            found.append(Check("assignment", not self._misfits, text, facts))
        if folded:
            text = "no crease is a mountain in one frame and a valley in another"
            facts = {"beyond": len(self._changes)}
            if self._changes:
                edge, number = min(self._changes.items(), key=lambda item: item[1])
                text = (
                    f"{len(self._changes)} creases change between mountain and valley, first "
                    f"{names.edge(edge)} in frame {number}"
                )
                facts |= {"frame": number, **names.edge(edge).facts}
            found.append(Check("constant_sign", not self._changes, text, facts))
        return found

    def maekawa(self) -> tuple[list[Check], int]:
        """Maekawa's condition at inner vertices with four creases, and at how many it is untested.

        A vertex none of whose creases folds has nothing to meet.
        """
        sheet, letters = self._sheet, self._letters
        if letters is None or not len(sheet.inner):
            return [], 0
        edges, sense = sheet.mesh.edges[sheet.mesh.crease], self._sense[sheet.mesh.crease]
        count = sheet.mesh.vertex_count

        def ending(which: Booleans) -> Integers:
            """How many of these creases end at every inner vertex."""
            return np.bincount(edges[which].ravel(), minlength=count)[sheet.inner]

        known, signs = ~np.isnan(sense), np.nan_to_num(sense)
        complete = (ending(known) == 4) & (ending(~known) == 0)
        folding = ending(signs != 0)
        met = meets_maekawa(edges, signs, count)[sheet.inner] | (folding == 0)
        wrong = sheet.inner[complete & ~met]
        untested = int((~complete).sum())
        if not complete.any():
            return [], untested
        three, two = (int((complete & (folding == number)).sum()) for number in (4, 2))
        said = [f"three creases of one kind and one of the other at {three} vertices"] * (three > 0)
        said += [f"two of one kind, and two that stay flat, at {two} vertices"] * (two > 0)
        text = "; ".join(said) or "no crease is to fold at any vertex"
        facts: dict[str, object] = {"beyond": len(wrong)}
        if len(wrong):
            text = (
                f"{len(wrong)} vertices break Maekawa's condition, first "
                f"{self._names.vertex(int(wrong[0]))}"
            )
            facts |= self._names.vertex(int(wrong[0])).facts
        return [Check("maekawa", not len(wrong), text, facts)], untested

    def _signs(self, angles: Array, *, ends: bool) -> Array:
        """Signs (E,) of angles; measured ones have none within the limit of 180 degrees."""
        limits = self._sheet.edge_limits
        known = np.abs(angles) > limits
        if not ends:
            known &= np.abs(angles) < np.pi - limits
        return np.where(known, np.sign(angles), 0.0)

    def _compare(self, angles: Array, says: str, *, ends: bool) -> None:
        if self._letters is None:
            return
        crease = self._sheet.mesh.crease
        unfolded = (self._sense == 0) & (np.abs(angles) > self._sheet.edge_limits)
        wrong = crease & ((self._sense * self._signs(angles, ends=ends) < 0) | unfolded)
        for edge in np.flatnonzero(wrong).tolist():
            size = abs(float(angles[edge]))
            if size > self._misfits.get(edge, (0.0, ""))[0]:
                degrees = np.rad2deg(angles[edge])
                self._misfits[edge] = (size, f"folded by {degrees:.4g} deg {says}")

    def _wrong_border(self, letters: NDArray[np.str_]) -> Booleans:
        beside = (self._sheet.mesh.edge_faces >= 0).sum(axis=1)
        inside, border = (
            (beside == 2) & (letters == "B"),
            (beside == 1) & np.isin(letters, [*SENSE]),
        )
        return np.asarray(inside | border)

    def _all_against(self) -> bool:
        folded = self._sheet.mesh.crease & (np.abs(self._sense) == 1)
        return bool(folded.any()) and set(np.flatnonzero(folded).tolist()) <= set(self._misfits)


def _senses(letters: NDArray[np.str_] | None, count: int) -> Array:
    if letters is None:
        return np.full(count, np.nan)
    return np.array([SENSE.get(letter, np.nan) for letter in letters.tolist()])
