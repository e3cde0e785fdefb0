"""Whether the fold angles, mountains and valleys that the file gives fit its coordinates."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from orishell.inspection.findings import Check, Names, Worst
from orishell.inspection.rigidity import facts_of
from orishell.inspection.sheet import Sheet, State, turn_between

Array = NDArray[np.float64]
Booleans = NDArray[np.bool_]

SENSE = {"V": 1.0, "M": -1.0, "F": 0.0, "J": 0.0}
"""Sign of the fold angle that a letter asks for; other letters ask for none."""


class FoldAngleTest:
    """Fold angles given by a frame are those of its coordinates.

    The fold angles given by the flat sheet are those of a folded state. They are compared with
    the frame with which most creases agree, if half of them do with any.
    """

    def __init__(self, sheet: Sheet, names: Names, letters: NDArray[np.str_] | None) -> None:
        self._sheet, self._names, self._letters = sheet, names, letters
        self._worst = Worst()
        self._pattern = self._given(sheet.frame.fold_angles) if sheet.flat else None
        self._agreeing = 0
        self._best: tuple[int, Array] | None = None
        self.frames_without: list[int] = []

    def see(self, state: State) -> None:
        """Compare one frame."""
        sheet, frame = self._sheet, state.frame
        if self._pattern is not None:
            turn = turn_between(state.folds, self._pattern)
            agreeing = int((turn <= sheet.edge_limits)[sheet.mesh.crease].sum())
            if agreeing >= self._agreeing:
                self._agreeing, self._best = agreeing, (frame.number, turn)
        if sheet.flat and frame is sheet.frame:
            return
        given = self._given(frame.fold_angles)
        if given is None:
            self.frames_without.append(frame.number)
        else:
            self._compare(turn_between(state.folds, given), frame.number)

    @property
    def pattern_untested(self) -> bool:
        """Whether the flat sheet's fold angles are those of no frame."""
        if self._pattern is None:
            return False
        creases = int((self._sheet.mesh.crease & ~np.isnan(self._pattern)).sum())
        return 2 * self._agreeing < creases

    def checks(self) -> list[Check]:
        """What was found, if fold angles are given."""
        if self._best is not None and not self.pattern_untested:
            self._compare(self._best[1], self._sheet.frame.number)
        if not self._worst.seen:
            return []
        worst, names = self._worst, self._names
        return [
            Check(
                "fold_angle",
                worst.passed,
                f"edges_foldAngle is off by {worst.figure:.1e} rad (limit {worst.limit:.1e}), "
                f"{names.edge(worst.number)} in frame {worst.frame}{worst.others('edges')}",
                {**facts_of(worst), **names.edge_place(worst.number)},
            )
        ]

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
    """Mountains are mountains, valleys valleys, and none becomes the other between frames."""

    def __init__(self, sheet: Sheet, names: Names, letters: NDArray[np.str_] | None) -> None:
        self._sheet, self._names, self._letters = sheet, names, letters
        self._sense = _senses(letters, len(sheet.mesh.edges))
        self._mountain = np.zeros(len(self._sense), dtype=np.bool_)
        self._valley = self._mountain.copy()
        self._misfits: dict[int, tuple[float, str]] = {}
        self._changes: dict[int, int] = {}
        self._against = 0

    def see(self, state: State) -> None:
        """Compare one frame: what it gives, and what its coordinates are."""
        sheet, frame = self._sheet, state.frame
        given = frame.fold_angles
        if given is not None:
            self._compare(np.nan_to_num(given), f"given in frame {frame.number}", ends=True)
        self._compare(state.folds, f"in frame {frame.number}", ends=False)
        sign = self._signs(state.folds, ends=False) * sheet.mesh.crease
        for edge in np.flatnonzero((sign > 0) & self._mountain | (sign < 0) & self._valley):
            self._changes.setdefault(int(edge), frame.number)
        self._mountain |= sign < 0
        self._valley |= sign > 0

    @property
    def never_folded(self) -> int:
        """Number of mountains and valleys that are unfolded or folded flat in every frame."""
        assigned = self._sheet.mesh.crease & (np.abs(self._sense) == 1)
        return int((assigned & ~self._mountain & ~self._valley).sum())

    @property
    def unassigned(self) -> int:
        """Number of creases of unknown assignment."""
        return int((self._sheet.mesh.crease & np.isnan(self._sense)).sum())

    def checks(self, *, folded: bool) -> list[Check]:
        """What was found; changes of sign only if there are folded frames."""
        found = []
        names, letters = self._names, self._letters
        if letters is not None:
            for edge in np.flatnonzero(self._wrong_border(letters)).tolist():
                beside = int((self._sheet.mesh.edge_faces[edge] >= 0).sum())
                what = "1 panel" if beside == 1 else f"{beside} panels"
                self._misfits[edge] = (np.inf, f"between {what}")
            text = "all creases fold as edges_assignment says"
            facts: dict[str, object] = {"beyond": len(self._misfits)}
            if self._misfits:
                edge, (_, says) = max(self._misfits.items(), key=lambda item: item[1][0])
                text = (
                    f"{len(self._misfits)} edges do not fit edges_assignment, first "
                    f"{names.edge(edge)}, {letters[edge]} but {says}"
                )
                if self._all_against():
                    text += "; all signs are opposite: the sheet is seen from the other side"
                facts |= names.edge_place(edge)
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
                facts |= {"frame": number, **names.edge_place(edge)}
            found.append(Check("constant_sign", not self._changes, text, facts))
        return found

    def three_to_one(self) -> tuple[list[Check], int]:
        """Maekawa's theorem at inner vertices with four creases, and at how many it is untested.

        A vertex with unfolded creases has two of one sign or none.
        """
        sheet, letters = self._sheet, self._letters
        if letters is None or not len(sheet.inner):
            return [], 0
        crease = sheet.mesh.crease
        ends = sheet.mesh.edges[crease].T.ravel()
        sense = np.tile(self._sense[crease], 2)
        count = sheet.mesh.vertex_count
        complete = np.bincount(ends[~np.isnan(sense)], minlength=count)[sheet.inner] == 4
        complete &= np.bincount(ends, minlength=count)[sheet.inner] == 4
        total = np.bincount(ends, np.nan_to_num(sense), minlength=count)[sheet.inner]
        folded = np.bincount(ends, np.abs(np.nan_to_num(sense)), minlength=count)[sheet.inner]
        wrong = sheet.inner[complete & (np.abs(total) != 2) & (folded > 0)]
        untested = int((~complete).sum())
        if not complete.any():
            return [], untested
        text = f"three creases of one kind and one of the other at {complete.sum()} vertices"
        facts: dict[str, object] = {"beyond": len(wrong)}
        if len(wrong):
            text = (
                f"{len(wrong)} vertices are not three to one, first "
                f"{self._names.vertex(int(wrong[0]))}"
            )
            facts |= self._names.vertex_place(int(wrong[0]))
        return [Check("three_to_one", not len(wrong), text, facts)], untested

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
