"""All forces on all panels in a file: ``forces.csv``."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain
from pathlib import Path

import numpy as np

from orishell.document import Document
from orishell.io.formats.tables import write_csv
from orishell.numerics.arrays import Array, Integers
from orishell.structure.case import CaseResult
from orishell.structure.model import Model
from orishell.structure.panel_forces import panel_forces
from orishell.structure.results import Analysis

HEAD = (
    "case", "creases", "share of loads", "row", "column", "acts", "other row", "other column",
    "vertex row", "vertex column",
)  # fmt: skip
POINT, FORCE = "%.15g", "%.10g"
"""Digits of points, which may be far from the world's origin, and of forces: panels are in balance
with what is written to 1e-6 of their loads."""
ROUNDING = 1e-14
"""Coordinates below this share of the largest are 0."""


def write_forces(path: Path, report: Analysis, document: Document) -> None:
    """Write ``forces.csv``: a line for every force on a panel, of all cases in equilibrium.

    document: The shell; points are written in its world.
    """
    unit = document.require_unit()
    heads = (
        *HEAD,
        *(f"{axis} ({unit})" for axis in "xyz"),
        *(f"F{axis} (N)" for axis in "xyz"),
        *(f"M{axis} (N {unit})" for axis in "xyz"),
    )
    rows = (_rows(report.model, case, document) for _, case in report.balanced)
    write_csv(path, heads, chain.from_iterable(rows))


def _rows(model: Model, case: CaseResult, document: Document) -> Iterator[tuple[object, ...]]:
    """The lines of a case."""
    assert case.equilibrium is not None
    found, across = panel_forces(model, case), model.grid.columns
    points = document.in_world(found.points)
    points = np.where(np.abs(points) > ROUNDING * np.abs(points).max(initial=0.0), points, 0.0)
    under = (case.name, case.creases, f"{case.equilibrium.edges.factor:.6g}")
    parts = zip(
        _places(model, found.panels, across - 1),
        found.acts.tolist(),
        _places(model, found.beside, across - 1),
        _places(model, found.vertices, across),
        _written(np.concatenate([points, found.forces], axis=1) + 0.0),
        strict=True,
    )
    for panel, acts, other, vertex, values in parts:
        yield (*under, *panel, acts, *other, *vertex, *values)


def _places(model: Model, numbers: Integers, columns: int) -> list[tuple[int | str, int | str]]:
    """Rows and columns in the folding sheet of panels or vertices (R,), empty where there is none.

    columns: How many of them a row of the sheet without its flaps has.
    """
    row, column = np.divmod(numbers, columns)
    both = zip(numbers.tolist(), row.tolist(), (column + model.before).tolist(), strict=True)
    return [(each, other) if number >= 0 else ("", "") for number, each, other in both]


def _written(figures: Array) -> list[list[str]]:
    """Points, forces and moments (R, 9) as text."""
    form = ",".join([POINT] * 3 + [FORCE] * 6)
    return [(form % tuple(row)).split(",") for row in figures.tolist()]
