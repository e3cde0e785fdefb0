"""Changes of a design file, tried for what the shell bears then: with few cells, and as asked.

Work is predicted and not measured, so that a search ends after the same trials on any machine.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

from orishell.conventions.errors import DesignError, InputError, OrishellError, Remedy
from orishell.conventions.progress import Progress
from orishell.conventions.record import record
from orishell.design_file import DesignFile
from orishell.shell.facts import Facts
from orishell.shell.instead import REFUSALS, shell_of, trying
from orishell.shell.steps import MEASURES, Step
from orishell.structure.refine import seconds
from orishell.structure.results import Analysis

FEW_CELLS = 2
"""Cells with which is tried first what is offered, where panels can have so few."""
STANDING_CELLS = 4
"""Cells along a side of a panel with which gussets may end anywhere along edges."""
LOADED: tuple[Step, ...] = (*MEASURES, "stock", "verification", "remedies")
"""All that does not tell what a shell bears."""
TAUT = "ties that are not slack on the way"


@record
class Refused:
    """Why a changed shell cannot be made, and what may be worth trying in place of that."""

    why: str
    candidates: Iterable[Remedy] = ()


class LoadTrials:
    """Changed shells as they are made and analysed, and the work that this takes."""

    def __init__(self, file: DesignFile, analysis: Analysis, progress: Progress) -> None:
        self.file, self.model, self.progress = file, analysis.model, progress
        self.work = 0.0  # predicted seconds of the analyses so far, each with its own model

    def made(
        self,
        values: Mapping[str, Any],
        words: str,
        *,
        quick: bool,
        skip: tuple[Step, ...] = LOADED,
    ) -> Facts | Refused:
        """What is found of a changed shell, or why it is none.

        quick: Whether it has few cells, of which only that is found which tells if it carries, and
        it is left open if its boards reach their target.
        """
        work = trying(self.progress, f"trying {words}", skip)
        if quick:
            work = replace(work, clash="unexamined", briefly=True)
        try:
            file = self._tried(values, quick=quick)
            found = shell_of(file, work)
        except REFUSALS as error:
            return _refused(error)
        if found.analysis is None:
            return Refused(TAUT)
        model = found.analysis.model
        self.work += seconds(model, model.structure.cells)
        if any(tie.slack is False for tie in found.deployment.ties):
            return Refused(TAUT)
        return found

    def _tried(self, values: Mapping[str, Any], *, quick: bool) -> DesignFile:
        """The changed file, with few cells if it is to be quick."""
        file = self.file.tried(values)
        if not quick:
            return file
        assert file.structure is not None
        fewest = FEW_CELLS if file.stiffeners is None else STANDING_CELLS
        cells = min(max(fewest, self.model.least_cells), file.structure.cells)
        return self.file.tried({**values, "structure.cells": cells, "structure.refine": 0.0})


def _refused(error: OrishellError) -> Refused:
    """What is said of a refusal, and what it offers."""
    if isinstance(error, DesignError):
        return Refused(error.condition, error.candidates)
    if isinstance(error, InputError):
        got = f"{error.got}, expected {error.expected}" if error.got and error.expected else ""
        return Refused(f"{error.what}{f' ({error.where}: {got})' * bool(got)}")
    return Refused(str(error).removesuffix("."))
