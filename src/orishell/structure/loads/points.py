"""Forces at single vertices."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.conventions.errors import InputError
from orishell.structure.load_settings import PointLoad
from orishell.structure.loads.cases import Effect, load
from orishell.structure.loads.exposure import Exposure


@load("forces at points")
def points(exposure: Exposure, asked: Sequence[PointLoad]) -> Effect:
    """At single vertices.

    Raises InputError: If one of them is not there.
    """
    forces = np.zeros_like(exposure.mesh.points)
    grid, first = exposure.grid, exposure.before
    for number, each in enumerate(asked):
        row, column = each.at
        if not (row < grid.rows and first <= column < first + grid.columns):
            raise InputError(
                "there is no such vertex between the flaps",
                where=f"points[{number}] at",
                got=f"[{row}, {column}]",
                expected=f"a row from 0 to {grid.rows - 1}, "
                f"a column from {first} to {first + grid.columns - 1}",
            )
        forces[row * grid.columns + column - first] += each.force
    return Effect(forces, None, f"at vertices {', '.join(str(list(each.at)) for each in asked)}")
