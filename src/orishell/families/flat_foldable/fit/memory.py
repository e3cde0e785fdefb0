"""Fits that were made, also by other processes: the studio asks the same again and again."""

from __future__ import annotations

from orishell.conventions.memory import MEMORY, key_of
from orishell.conventions.progress import Progress
from orishell.families.flat_foldable.fit.continuation import THOROUGH
from orishell.families.flat_foldable.fit.figures import measure
from orishell.families.flat_foldable.fit.initial_guesses import SECTOR, Fit, Start, Task, fit_sheet
from orishell.families.flat_foldable.fit.residuals import Problem
from orishell.families.flat_foldable.fit.unknowns import OFFSET, Unknowns
from orishell.numerics.arrays import Array


def recall_fit(
    task: Task, *, direction: int | None, folded: float | None, progress: Progress
) -> Fit | None:
    """What :func:`fit_sheet` finds; made of its unknowns again, to the last bit, once it was."""
    piece, conditions = task.piece, task.conditions
    key = key_of(
        "fit",
        task.rows,
        task.columns,
        conditions,
        task.straight,
        direction,
        folded,
        arrays=(piece.vertices, piece.normals, piece.triangles, *piece.sides),
    )
    fresh: list[Fit | None] = []

    def find() -> tuple[Start, Array] | None:
        fit = fit_sheet(task, direction=direction, folded=folded, progress=progress)
        fresh.append(fit)
        return None if fit is None else (fit.start, fit.fitted.unknowns)

    known = MEMORY.recall(key, find)
    if fresh or known is None:
        return fresh[0] if fresh else None
    start, unknowns = known
    seen = start.on(piece)
    of = Unknowns.covering(
        seen, task.rows, task.columns, SECTOR, start.folded, straight=task.straight
    )
    fitted = Problem(seen, of, THOROUGH.final, conditions).at(unknowns)
    assert fitted is not None
    return Fit(start, of, fitted, measure(seen, fitted, of.size, float(unknowns[OFFSET])))
