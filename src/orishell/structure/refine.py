"""Finer cells until figures settle, or until the work for finer ones is too much.

What an analysis takes is predicted from its degrees of freedom, so that where it ends depends on
the input only, never on how busy the machine is.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

from orishell.conventions.progress import Progress
from orishell.structure.case import CaseResult
from orishell.structure.changes import Changes, Figures, Stop, find_changes
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.mesh.sheet import count_freedoms
from orishell.structure.model import Model
from orishell.structure.soft_cases import Loaded

LADDER = 1, 2, 3, 4, 6, 8, 12, 16, 24, 32
"""Cells along a side, one after the other."""
COARSER = 0.75
"""Figures are compared with those of at most this share of the cells: if errors fall with the
square of their size, figures change from there by about what is still missing; those of few cells
do not yet (:data:`orishell.structure.changes.ENOUGH`)."""
SECONDS = 120.0
"""An analysis ends before it takes longer, on one ordinary core as of 2020."""
MEMORY = 4e9
"""And before it takes more (bytes)."""
FACTORS, CASE = 4.0, 6.0
"""Seconds for a stiffness of creases, and for each of its load cases, with 1e5 freedoms."""
GROWTH = 1.2
"""The power of the freedoms with which these grow."""
BYTES, BASE = 1e4, 1e8
"""Memory by freedom, and that of the program (bytes)."""
TOLD = 5.0
"""Progress says how long something takes if it takes more seconds."""


Cases = Sequence[tuple[CaseResult, Loaded | None]]
"""What was found of cases, and how, where they may be followed further."""
Run = tuple[Model, Cases, Sequence[Figures]]
"""A model, its cases, and what of each is compared with other meshes."""


class Runs(Protocol):
    """An analysis with so many cells."""

    def __call__(self, cells: int, told: Progress, *, last: bool) -> Run:
        """What it finds; only figures to compare if it is not the ``last``."""


def refined(
    model: Model, run: Runs, progress: Progress
) -> tuple[Model, Cases, Changes, Stop | None]:
    """The model and its cases with cells as fine as is asked for.

    Returns
    -------
    tuple
        The model, its cases, how figures changed from the next coarser mesh, and why cells are no
        finer although they should be.
    """
    asked, cells = model.structure, model.structure.cells
    known: dict[int, Sequence[Figures]] = {}
    spent, stopped = 0.0, None

    def analysed(cells: int, *, last: bool) -> tuple[Model, Cases]:
        nonlocal spent
        takes = seconds(model, cells)
        text = f"with {cells} x {cells} cells to a panel"
        text += f", about {takes:.0f} s" if takes >= TOLD else ""
        start = spent / (spent + takes)

        def told(share: float, _: str) -> None:
            progress(start + share * (1 - start), text)

        told(0.0, "")
        spent += takes
        found, cases, known[cells] = run(cells, told, last=last)
        return found, cases

    while True:
        coarse = coarser(cells, model.least_cells)
        if coarse not in known:
            analysed(coarse, last=False)
        found = analysed(cells, last=True)
        change = find_changes(known[coarse], known[cells])
        if not asked.refine or change.largest <= asked.refine:
            break
        finer = next((each for each in LADDER if each > cells), None)
        stopped = "cells" if finer is None else _limit(model, finer, spent)
        if finer is None or stopped is not None:
            break
        cells = finer
    return *found, change, stopped


def coarser(cells: int, least: int = 1) -> int:
    """Cells of the next coarser mesh, 3/4 of so many or less; one more for the ``least``."""
    fewer = (each for each in LADDER if least <= each <= COARSER * cells)
    return max(fewer, default=least + 1)


def figures(found: Equilibrium | None) -> Figures:
    """What is compared of a case, by linear theory."""
    if found is None:
        return Figures()
    return Figures(found.displacement.size, found.stress.size, found.buckling)


def seconds(model: Model, cells: int) -> float:
    """What an analysis with so many cells takes."""
    asked = model.structure
    stiffnesses, cases = len(set(asked.crease_stiffness)), len(asked.analysed)
    size = (_freedoms(model, cells) / 1e5) ** GROWTH
    return float(size * stiffnesses * (FACTORS + CASE * cases))


def memory(model: Model, cells: int) -> float:
    """The memory that an analysis with so many cells takes (bytes)."""
    return BASE + BYTES * _freedoms(model, cells)


def _freedoms(model: Model, cells: int) -> int:
    """About how many degrees of freedom there are with so many cells, no less."""
    grids = [model.grid, *(each.strips.grid for each in model.design.carried)]
    return sum(count_freedoms(grid, cells) for grid in grids)


def _limit(model: Model, cells: int, spent: float) -> Stop | None:
    """Why so many cells are too many; None if they are not."""
    if memory(model, cells) > MEMORY:
        return "memory"
    return "work" if spent + seconds(model, cells) > SECONDS else None
