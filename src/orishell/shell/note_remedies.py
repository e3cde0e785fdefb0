"""What does what a note of the report says: changes that were tried, and with which it is gone.

A note says what it is about (``Note.about``), whoever writes it, and knows nothing of files. Which
notes a change may mend is known at once; the changes themselves are tried one by one when somebody
asks, so that no proof waits for them. Each is typed into the file, and the shell made from it: it
is offered where that works, and nothing says the same any more.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from orishell.conventions.errors import InputError, Remedy
from orishell.conventions.progress import Progress
from orishell.conventions.record import record
from orishell.conventions.row import ORDER, About, Note
from orishell.design_file import DesignFile
from orishell.shell.facts import Facts
from orishell.shell.instead import first_that_does, trying
from orishell.shell.note_candidates import CANDIDATES, FINER
from orishell.shell.noted import Noted
from orishell.shell.notes import all_notes
from orishell.shell.report import Report
from orishell.shell.steps import Step
from orishell.structure.refine import LADDER, seconds
from orishell.structure.results import Analysis

PANELS = 1000
"""Panels of all shells together that are tried for one note unless somebody waits for it."""
SILENT: tuple[Step, ...] = (
    "remedies", "verification", "deviation", "pack", "cutting", "structure",
)  # fmt: skip
"""What is not found of a shell that is tried, unless its note is of it."""
OF_LOADS: tuple[About, ...] = ("points", "patch", "pulled", "weight", "cells", "linear")
"""What notes on the structure are about: it is analysed for them."""
SECONDS = 1.0
"""To try what takes longer, as is predicted, is slow (s)."""


@record
class Mendable:
    """A note that a change of the design may mend, which nobody has tried yet."""

    note: str  # which
    about: About  # what it is about
    slow: bool  # whether to try takes long


def find_mendable(
    file: DesignFile, notes: Sequence[str], analysis: Analysis | None = None
) -> tuple[Mendable, ...]:
    """The notes that a change may mend; nothing is tried.

    analysis: The shell as a structure, if it was analysed.
    """
    about = [(each, each.about) for each in notes if isinstance(each, Note)]
    return tuple(
        Mendable(str(note), each, _is_slow(file, each, analysis))
        for note, each in about
        if each is not None
    )


def find_mend(
    file: DesignFile,
    about: str,
    progress: Progress,
    report: Report | None = None,
    *,
    patient: bool = False,
) -> Remedy | None:
    """The first change with which nothing is said of a matter any more; None if there is none.

    about: What its notes are about.
    report: What was found of the shell, if that is known.
    patient: Whether changes are tried until all were.
    Raises InputError if there is no such matter.
    """
    matter: About | None = next((each for each in CANDIDATES if each == about), None)
    if matter is None:
        raise InputError("no note is about that", where="about", got=repr(about)[:40])
    loaded = matter in OF_LOADS
    needed = {"structure": loaded, "cutting": matter == "play"}
    silent = tuple(each for each in SILENT if not needed.get(each))
    work = trying(progress, "trying what mends a note", silent)
    noted = Noted(file, progress, report)

    def is_gone(made: Facts) -> bool:
        said = all_notes(made, work)
        reaches = made.found.lock.reaches_target is not False
        gone = all(getattr(note, "about", None) != matter for note in said)
        return reaches and gone and not (loaded and _is_worse(made.analysis, noted))

    panels = math.inf if patient else PANELS
    return first_that_does(file, CANDIDATES[matter](noted), is_gone, work, panels=panels)


def _is_worse(found: Analysis | None, noted: Noted) -> bool:
    """Whether a shell that carried its loads before is not known to any more."""
    before = noted.report.structure
    return before is not None and (
        found is None or ORDER.index(found.sign) < ORDER.index(before.sign)
    )


def _is_slow(file: DesignFile, about: About, analysis: Analysis | None) -> bool:
    """Whether to try what mends a note takes long: a search, many panels, a long analysis."""
    searched = file.tolerance is not None or file.surface is not None or file.fit is not None
    if searched or file.panel_count > PANELS:
        return True
    if about not in OF_LOADS or analysis is None:
        return False
    cells = analysis.model.structure.cells
    if about == "cells":
        finer = [each for each in LADDER if each > cells]
        cells = finer[min(FINER, len(finer)) - 1] if finer else cells
    return about == "linear" or seconds(analysis.model, cells) > SECONDS
