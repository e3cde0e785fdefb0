"""Rows of folds that something is put into: those that look down, those that look up, or named."""

from __future__ import annotations

from typing import Literal

import numpy as np

from orishell.conventions.errors import InputError
from orishell.design import Design
from orishell.motion import Mechanism, find_assignment
from orishell.motion.layout import has_flaps


def between_flaps(design: Design, free: slice, least: int, what: str) -> range:
    """Columns of vertices for what flaps that are shut leave no place to beside them.

    free: The columns where there are no flaps.
    what: What is put there, in the plural.
    Raises InputError if there are fewer than the least.
    """
    inner = design.mechanism.inner_columns
    flaps = has_flaps(design.mechanism) or design.clipped is not None
    columns = range(inner.start + 1, inner.stop - 1) if flaps else range(free.start, free.stop)
    if len(columns) < least:
        raise InputError(
            f"flaps take the place of {what} at their sides, and there are no columns between",
            keys=("stiffeners", "pattern.flap"),
            remedy="flap = 0, or more columns",
        )
    return columns


def fold_rows(
    mechanism: Mechanism,
    asked: Literal["valleys", "crests", "all"] | tuple[int, ...],
    columns: slice,
    what: str,
) -> list[int]:
    """The inner rows of vertices that are asked for, by the creases between columns of vertices.

    what: What is put into them, in one word.
    Raises InputError if there are no such rows.
    """
    inner = range(1, mechanism.grid.rows - 1)
    if asked == "all":
        return list(inner)
    if isinstance(asked, str):
        sign = 1 if asked == "valleys" else -1
        signs = find_assignment(mechanism).row[:, columns.start : columns.stop - 1]
        rows = [1 + row for row in np.flatnonzero((signs == sign).all(axis=1)).tolist()]
        if not rows:
            raise InputError(
                f"there are no rows of {asked}",
                keys=("stiffeners.rows",),
                got=f'"{asked}"',
                remedy='rows = "all", or name rows of vertices, as in rows = [1, 3]',
            )
        return rows
    return _named("row", asked, inner, what)


def fold_columns(
    asked: Literal["all", "none"] | int | tuple[int, ...], there: range, what: str
) -> list[int]:
    """The columns of vertices that are asked for: all, every so many with the last, or a list.

    Raises InputError if there is none, or one is not there.
    """
    if asked == "all":
        return list(there)
    if isinstance(asked, int):
        return sorted({*there[::asked], *there[-1:]})
    return _named("column", () if isinstance(asked, str) else asked, there, what)


def _named(line: str, numbers: tuple[int, ...], there: range, what: str) -> list[int]:
    """Rows or columns by their numbers, each once.

    Raises InputError if there is none, or one is not there.
    """
    wrong = [each for each in numbers if each not in there]
    if wrong or not numbers:
        raise InputError(
            f"no {what} can stand in this {line}" if numbers else f"no {line} is named",
            keys=(f"stiffeners.{line}s",),
            got=str(wrong[0]) if wrong else "[]",
            expected=f"numbers from {there.start} to {there.stop - 1}",
        )
    return sorted(set(numbers))
