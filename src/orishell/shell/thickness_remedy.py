"""What has a shell that fails carry its loads: thicker panels, ties across its folds; all is tried.

Every change is typed into the file and analysed, with few cells first; what is offered was made and
analysed as a whole design, as the file asks. What is tried follows from what was found of the
trials before, and where it ends from the work that they are predicted to take: no clock decides, so
that the same file has the same answer on any machine.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from orishell.conventions.errors import Remedy
from orishell.conventions.progress import Progress
from orishell.conventions.quantities import Quantities
from orishell.design_file import DesignFile
from orishell.shell.carry_boards import stiffer, thicker, thickness_key
from orishell.shell.carry_steps import FOLDS
from orishell.shell.load_trials import LoadTrials, Refused
from orishell.structure.results import Analysis

TRIALS = 3
"""Thicknesses that are tried, with and without ties across the folds."""
WORK = 2.5
"""Beyond so many predicted seconds no further change is tried. With the trial as a whole this is a
minute or two at most, which the studio waits for."""
CONFIRMED = 2
"""So many of the changes with which no case fails are tried as a whole, the best first."""


def find_stronger(file: DesignFile, analysis: Analysis, progress: Progress) -> Remedy | None:
    """What has a shell that fails carry all its cases, or no change and what was tried in vain."""
    if analysis.model.structure.nonlinear:
        return Remedy(
            {},
            "what would carry its loads is not sought where large displacements are followed: "
            "where they are not, it is (nonlinear = false in [structure])",
        )
    if any(case.motion is not None and not case.motion.soft for case in analysis.cases):
        return None  # thickness holds nothing, and the case says what does
    if all(case.lifts_only for case in analysis.cases if case.sign == "fails"):
        return None  # the case says which ballast would hold
    trials = _Trials(file, analysis, progress)
    for changes in trials.proposed():
        if trials.trials.work > WORK:
            trials.ended = True
            break
        if trials.settles(changes):
            break
    return trials.confirmed()


class _Trials:
    """Changes that are tried one after the other, each by what the last one showed."""

    def __init__(self, file: DesignFile, analysis: Analysis, progress: Progress) -> None:
        self.file, self.progress = file, progress
        self.first = self.last = analysis
        self.key = thickness_key(file)
        self.said = Quantities(file.unit)
        self.trials, self.ended = LoadTrials(file, analysis, progress), False
        self.tried: list[str] = []
        self.promise: list[tuple[float, dict[str, Any]]] = []  # with which no case fails so far

    def proposed(self) -> Iterator[dict[str, Any]]:
        """Changes, those first that weigh least."""
        if self._may_be_tied():
            yield FOLDS
            if self.last is not self.first:  # else its ties do not hold
                yield from self._thicker(FOLDS)
            if self.promise:
                return
            self.last = self.first
        yield from self._thicker({})

    def _may_be_tied(self) -> bool:
        """Whether ties across the folds may help: with hinges that bear little, it is too soft."""
        soft = any(
            case.sign == "fails" and (case.equilibrium is None or stiffer(case) > 1)
            for case in self.first.cases
        )
        return soft and self.file.deployment.ties in ("none", "feet")

    def _thicker(self, others: dict[str, Any]) -> Iterator[dict[str, Any]]:
        for _ in range(TRIALS):
            change = next(thicker(self.file, self.last), None)
            if change is None:
                return
            if change.refused:
                words = self._in_words({**others, **change.values})
                self.tried.append(f"{words} (cannot be made: {change.refused})")
                return
            before = self.last
            yield {**others, **change.values}
            if self.last is before:  # boards so thick cannot be made
                return

    def settles(self, changes: dict[str, Any]) -> bool:
        """Try a change with few cells; whether nothing is sought beyond it."""
        found = self._analysed(changes, quick=True)
        if found is None:
            return False
        self.last = found
        if found.sign == "fails":
            self.tried.append(self._in_words(changes))
            return False
        self.promise.append((max(1.0, _open(found)), changes))
        return _open(found) <= 1

    def _analysed(self, changes: dict[str, Any], *, quick: bool) -> Analysis | None:
        """What is found of a changed shell; None if it cannot be made."""
        words = self._in_words(changes)
        made = self.trials.made(changes, words, quick=quick)
        if isinstance(made, Refused):
            self.tried.append(f"{words} (cannot be made: {made.why})")
            return None
        return made.analysis

    def confirmed(self) -> Remedy | None:
        """What works as a whole, the best of what was tried first; or what was tried."""
        for _, changes in sorted(self.promise, key=lambda each: each[0])[:CONFIRMED]:
            found, words = self._analysed(changes, quick=False), self._in_words(changes)
            if found is None:
                continue
            if found.carries:
                return Remedy(changes, f"{words} carry all cases (tried)")
            if found.sign == "warns":
                rest = f"whether they carry it is {found.in_words()}"
                return Remedy(changes, f"with {words} no case fails (tried); {rest}")
            self.tried.append(words)
        if not self.tried:
            return None
        end = ", and more would take too long" if self.ended else ""
        return Remedy({}, f"tried, and not enough: {', '.join(self.tried)}{end}")

    def _in_words(self, changes: Mapping[str, Any]) -> str:
        parts = []
        if "deployment.ties" in changes:
            parts.append('ties across the folds (ties = "folds")')
        if self.key in changes:
            parts.append(f"panels {self.said.displacement(changes[self.key])} thick")
        return " and ".join(parts)


def _open(found: Analysis) -> float:
    """How far figures are beyond what is known to be carried; up to 1 none is."""
    return max(case.used for case in found.cases)
