"""The shell that a note of a report is of, made where somebody asks what was found of it."""

from __future__ import annotations

from functools import cached_property
from typing import Any

from orishell.conventions.progress import Progress
from orishell.design_file import DesignFile
from orishell.design_file.tables import value_at
from orishell.shell.make import make_shell
from orishell.shell.report import Report
from orishell.shell.steps import Step

UNSOUGHT: tuple[Step, ...] = ("remedies", "verification", "deviation", "pack", "stock")
"""What need not be found of the shell that a note is of."""


class Noted:
    """The shell that a note is of.

    Parameters
    ----------
    file
        Its design file.
    progress
        Is told of the work where it is made anew.
    report
        What was found of it; the shell is made when that is first asked for, if it is not given.
    """

    def __init__(self, file: DesignFile, progress: Progress, report: Report | None = None) -> None:
        self.file, self._progress, self._report = file, progress, report

    @cached_property
    def report(self) -> Report:
        """What was found of it.

        Raises InputError, DesignError or VerificationError as ``make_shell`` does.
        """
        if self._report is not None:
            return self._report
        return make_shell(self.file, self._progress, clash="allowed", skip=UNSOUGHT).report

    @property
    def supports(self) -> list[dict[str, Any]]:
        """How the file says that it is supported."""
        return list(value_at(self.file.tables, "structure.supports"))
