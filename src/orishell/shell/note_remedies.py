"""What does what a note of the report says: changes that were tried, and with which it is gone.

A note says what it is about (``Note.about``), whoever writes it, and knows nothing of files. Here
are the changes that may do it. Each is typed into the file, and the shell made from it: it is
offered where that works, and nothing says the same any more.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

from orishell.conventions.errors import Remedy
from orishell.conventions.formatting import rounded
from orishell.conventions.progress import Progress
from orishell.conventions.quantities import conversion, plain
from orishell.conventions.record import record
from orishell.conventions.row import About, Note
from orishell.design_file import DesignFile
from orishell.design_file.tables import value_at
from orishell.shell.facts import Facts
from orishell.shell.instead import first_that_does, trying
from orishell.shell.notes import all_notes
from orishell.shell.steps import Step
from orishell.structure.refine import seconds
from orishell.structure.results import Analysis

PANELS = 1000
"""Panels of all shells together that are tried for one note."""
BOARDS = ((2.5, 1.25), (3.05, 1.525))
"""Sizes in which plywood is commonly sold (metres), the usual one first."""
SILENT: tuple[Step, ...] = (
    "remedies", "verification", "deviation", "pack", "cutting", "structure",
)  # fmt: skip
"""What is not found of a shell that is tried, unless its note is of loads."""
OF_LOADS: tuple[About, ...] = ("points", "weight")
"""What notes on the structure are about: it is analysed for them."""
SECONDS = 1.0
"""Of an analysis that is predicted to take longer, no note is mended (s)."""


@record
class Mend:
    """A change of the design that does what a note says."""

    note: str  # which
    text: str  # what is done
    changes: Mapping[str, Any]  # values of keys of the design file; None removes a key


def find_mends(
    file: DesignFile, notes: Sequence[str], progress: Progress, analysis: Analysis | None = None
) -> tuple[Mend, ...]:
    """What does what notes say, as far as it was tried and works.

    analysis: The shell as a structure, if it was analysed.
    """
    quick = analysis is not None and seconds(analysis.model, analysis.model.structure.cells)
    if file.tolerance is not None or file.surface is not None or file.fit is not None:
        return ()  # every trial would be a search
    found = []
    for note in notes:
        about = note.about if isinstance(note, Note) else None
        if about is None or (about in OF_LOADS and not 0 < quick <= SECONDS):
            continue
        remedy = _first_without(file, about, progress)
        if remedy is not None:
            found.append(Mend(note, str(remedy), remedy.changes))
    return tuple(found)


def _first_without(file: DesignFile, about: About, progress: Progress) -> Remedy | None:
    """The first change with which nothing is said of a matter any more."""
    silent = tuple(each for each in SILENT if each != "structure" or about not in OF_LOADS)
    work = trying(progress, "looking for what mends a note", silent)

    def is_gone(made: Facts) -> bool:
        said = all_notes(made, work)
        reaches = made.found.lock.reaches_target is not False
        return reaches and all(getattr(note, "about", None) != about for note in said)

    return first_that_does(file, CANDIDATES[about](file), is_gone, work, panels=PANELS)


def _two_columns(_: DesignFile) -> Iterator[Remedy]:
    yield Remedy({"pattern.columns": 2}, "2 columns")


def _boards(file: DesignFile) -> Iterator[Remedy]:
    metres = conversion(file.unit, "m")
    for board in BOARDS:
        sides = [rounded(side / metres, 6) for side in board]
        words = " x ".join(plain(side) for side in sides)
        yield Remedy({"workshop.stock": sides}, f"boards of {words} {file.unit}")


def _other_side(_: DesignFile) -> Iterator[Remedy]:
    for end in ("start", "end"):
        yield Remedy({"pattern.flap_side": end}, f"flaps at the {end} of f")


def _flaps(_: DesignFile) -> Iterator[Remedy]:
    yield Remedy({"pattern.flap": "auto"}, "flaps as wide as they may be")


def _tied_feet(_: DesignFile) -> Iterator[Remedy]:
    yield Remedy({"deployment.ties": "feet"}, "tie its feet together")


def _held_edges(file: DesignFile) -> Iterator[Remedy]:
    supports = value_at(file.tables, "structure.supports")
    held: Any = [
        each if each["kind"] == "friction" or each.get("patch") else {**each, "edges": True}
        for each in supports
    ]
    yield Remedy({"structure.supports": held}, "hold supports along their edges")


def _own_weight(file: DesignFile) -> Iterator[Remedy]:
    cases = value_at(file.tables, "load_case")
    without = [number for number, case in enumerate(cases) if not case.get("self_weight")]
    yield Remedy(
        {f"load_case.{number}.self_weight": True for number in without},
        "own weight in every load case",
    )


CANDIDATES: Mapping[About, Callable[[DesignFile], Iterator[Remedy]]] = {
    "columns": _two_columns,
    "board": _boards,
    "reach": _other_side,
    "no flaps": _flaps,
    "opens": _tied_feet,
    "points": _held_edges,
    "weight": _own_weight,
}
"""What may do what a note says, by what it is about, the nearest first."""
