"""Values of FOLD files as arrays and texts, or the first entry that does not fit."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.errors import InputError
from orishell.numerics.arrays import Array, Integers


def number_table(
    value: Any, where: str, row: str, *, widths: tuple[int, ...], whole: bool = False
) -> NDArray[Any]:
    """A list of lists of numbers, all of one length, as array (rows, width).

    ``row`` is what one row is ("vertex", "panel"), ``widths`` the lengths that it may have.

    Raises InputError: Naming the first row that does not fit.
    """
    if not isinstance(value, list):
        raise misfit(value, where, "a list")
    if not value:
        raise InputError("this list is empty", where=where)
    try:
        table = np.array(value)
    except (ValueError, OverflowError):
        table = np.array(None)
    kinds = "iu" if whole else "iuf"
    if table.ndim == 2 and table.shape[1] in widths and table.dtype.kind in kinds:
        return table
    raise _first_misfit(value, where, row, widths, whole)


def require_vertices(
    rows: Integers, vertex_count: int, where: str, *, count: Integers | None = None
) -> None:
    """Refuse numbers of vertices (N, K) that are not there; rows have so many (N,), or K each.

    Raises InputError: Naming the first row with one.
    """
    missing = (rows < 0) | (rows >= vertex_count)
    if count is not None:
        missing &= np.arange(rows.shape[1]) < count[:, None]
    if missing.any():
        row = int(missing.any(axis=1).argmax())
        here = rows[row, : None if count is None else count[row]]
        raise InputError(
            "there is no such vertex",
            where=f"{where}[{row}]",
            got=str(here.tolist()),
            expected=f"numbers from 0 to {vertex_count - 1}",
        )


def number_list(value: list[Any], where: str, entry: str) -> Array:
    """A list of numbers as array, NaN where it has null.

    Raises InputError: Naming the first entry that is no number.
    """
    for index, number in enumerate(value):
        if not _is_number(number, whole=False) and number is not None:
            raise misfit(number, f"{where}[{index}]", f"a number for each {entry}")
    return np.array([np.nan if number is None else float(number) for number in value])


def misfit(value: Any, where: str, expected: str) -> InputError:
    """The error for a value of the wrong kind."""
    return InputError("this value does not fit", where=where, got=shown(value), expected=expected)


def shown(value: Any) -> str:
    """A value as messages quote it."""
    text = repr(value)
    return text if len(text) <= 60 else text[:57] + "..."


def require_text(value: Any, where: str) -> str:
    """The value, refused if it is no text."""
    if not isinstance(value, str):
        raise misfit(value, where, "a text")
    return value


def _first_misfit(
    value: list[Any], where: str, row: str, widths: tuple[int, ...], whole: bool
) -> InputError:
    numbers = "whole numbers" if whole else "numbers"
    accepted = [entry for entry in value if _is_row(entry, widths, whole)]
    if accepted:
        widths = (len(accepted[0]),)
    expected = f"{' or '.join(map(str, widths))} {numbers} for each {row}"
    for index, entry in enumerate(value):
        if not _is_row(entry, widths, whole):
            return InputError(
                f"{row} {index} does not fit",
                where=f"{where}[{index}]",
                got=f"{len(entry)} {numbers}" if _is_row(entry, None, whole) else shown(entry),
                expected=expected,
            )
    return InputError("the numbers are too large", where=where, expected=expected)


def _is_row(entry: Any, widths: tuple[int, ...] | None, whole: bool) -> bool:
    return (
        isinstance(entry, list)
        and (widths is None or len(entry) in widths)
        and all(_is_number(number, whole) for number in entry)
    )


def _is_number(value: Any, whole: bool) -> bool:
    return isinstance(value, int if whole else (int, float)) and not isinstance(value, bool)
