"""The surface that a shell follows, and the distances of its vertices, added to its document."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.design import Design
from orishell.deviation import measure_points
from orishell.document import Document

CELLS = 40
"""Cells of the lattice along the surface's longer side, about."""
FLAT = 200
"""Cells leave the surface by about their size divided by this."""
MOST_CELLS = 40_000
"""Cells of the lattice at most."""


def lay_surface(document: Document, design: Design, *, measured: bool = True) -> Document:
    """The document with the surface of its design added, unchanged if there is none."""
    if design.swept is None:
        return document
    surface = design.surface
    step = surface.size() / CELLS
    lattice = surface.lattice(step, step / FLAT, most=MOST_CELLS)
    document = replace(document, surface=lattice.points)
    if not measured:
        return document
    grid, inner = design.mechanism.grid, design.mechanism.inner_columns
    shell = document.shell.positions.reshape(grid.rows, grid.columns, 3)
    distances = np.full((grid.rows, grid.columns), np.nan)
    distances[:, inner] = measure_points(shell[:, inner], surface)
    return replace(document, distances=distances.ravel())
