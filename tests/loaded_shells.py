"""Shells as structures, made up: displacements, stresses and ties that no analysis found."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np

from documents import demo_document
from orishell.document import Document
from orishell.document.loaded import LoadedCase, LoadedShell
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.sheet import mesh_sheet

LARGEST = 0.034
"""Displacement under snow, in the unit."""


@cache
def loaded_document(family: str = "orthodiagonal", cells: int = 2) -> Document:
    """A figure's shell, loaded in three cases: it sags, is pushed sideways, and moves freely."""
    document = demo_document(family)
    assert document.grid_shape is not None
    rows, columns = document.grid_shape
    shape = (rows, columns, 3)
    mesh = mesh_sheet(document.shell.positions.reshape(shape), Grid(rows, columns), cells)
    points, triangles = mesh.facets.points, mesh.facets.triangles
    panels = np.repeat(np.arange((rows - 1) * (columns - 1)), 2 * cells**2)
    height = np.ptp(points[:, 2]) or 1.0
    share = (points[:, 2] - points[:, 2].min()) / height
    feet = (1, columns // 2), (rows - 2, columns // 2)
    ends = np.array([[row * columns + column for row, column in feet]])
    restrained = np.array([[node, axis] for node in ends[0] for axis in range(3)][:-1])
    cases = (
        _case("snow", True, -LARGEST * np.outer(share**2, [0, 0, 1]), triangles),
        _case("wind, creases free", True, 0.4 * LARGEST * np.outer(share, [1, 0, 0]), triangles),
        _case("own weight", False, np.outer(share, [0, 0, -1]), triangles),
    )
    count = len(triangles)
    loaded = LoadedShell(
        points=points,
        triangles=triangles,
        panels=panels,
        membrane=np.full(count, 1e7),
        bending=np.full(count, 1e2),
        poisson=0.3,
        areal_mass=np.full(count, 2.0),
        restrained=restrained,
        ties=ends,
        tie_stiffness=1e6,
        cases=cases,
    )
    return replace(document, loaded=loaded)


def _case(name: str, stands: bool, displacements: Array, triangles: Integers) -> LoadedCase:
    amounts = np.linalg.norm(displacements, axis=-1)[triangles].mean(axis=1)
    stresses = 1e6 * amounts if stands else np.full(len(triangles), np.nan)
    return LoadedCase(
        name, "holds" if stands else "fails", stands, 2.0 * displacements, displacements, stresses
    )
