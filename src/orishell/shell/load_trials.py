"""Changes of a design file, tried for what the shell bears then: with few cells, and as asked.

Work is predicted and not measured, so that a search ends after the same trials on any machine.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from orishell.conventions.progress import Progress
from orishell.design_file import DesignFile
from orishell.shell.facts import Facts
from orishell.shell.instead import REFUSALS, shell_of, trying
from orishell.shell.steps import MEASURES, Step
from orishell.structure.refine import seconds
from orishell.structure.results import Analysis

FEW_CELLS = 2
"""Cells with which is tried first what is offered, where panels can have so few."""
LOADED: tuple[Step, ...] = (*MEASURES, "stock", "verification")
"""All that does not tell what a shell bears."""
TAUT = "ties that are not slack on the way"


class LoadTrials:
    """Changed shells as they are made and analysed, and the work that this takes."""

    def __init__(self, file: DesignFile, analysis: Analysis, progress: Progress) -> None:
        model = analysis.model
        few = min(max(FEW_CELLS, model.least_cells), model.cells)
        self.file, self.progress = file, progress
        self.few = {"structure.cells": few, "structure.refine": 0.0}
        self.takes = {True: seconds(model, few), False: seconds(model, model.cells)}
        self.work = 0.0  # predicted seconds of the analyses so far

    def made(
        self,
        values: Mapping[str, Any],
        words: str,
        *,
        quick: bool,
        skip: tuple[Step, ...] = LOADED,
    ) -> Facts | str:
        """What is found of a changed shell, or in a word or two why it is none.

        quick: Whether it has few cells, and it is left open if its boards reach their target.
        """
        work = trying(self.progress, f"trying {words}", skip)
        if quick:
            work = replace(work, clash="unexamined")
        self.work += self.takes[quick]
        try:
            found = shell_of(self.file.tried({**values, **self.few} if quick else values), work)
        except REFUSALS:
            return "cannot be made"
        if found.analysis is None or any(tie.slack is False for tie in found.deployment.ties):
            return TAUT
        return found
