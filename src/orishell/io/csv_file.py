"""Tables of comma-separated values, as a spreadsheet may open them."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Sequence
from itertools import chain
from pathlib import Path

FORMULA = ("=", "+", "-", "@", "\t", "\n")
"""A spreadsheet takes a cell that begins with one of these for a formula, and computes it."""


def write_csv(path: Path, heads: Sequence[str], rows: Iterable[Sequence[object]]) -> None:
    """Write a table: a line of names, and a line for each row.

    A text that a spreadsheet would compute has a quote (``'``) in front; texts that are numbers
    have none. A carriage return becomes a blank.

    Parameters
    ----------
    heads
        Names of the columns.
    """
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerows([_safe(cell) for cell in row] for row in chain([heads], rows))


def _safe(cell: object) -> object:
    if not isinstance(cell, str):
        return cell
    cell = cell.replace("\r", " ")  # which the csv module may leave without quotes
    if not cell.startswith(FORMULA):
        return cell
    try:
        float(cell)
    except ValueError:
        return f"'{cell}"
    return cell
