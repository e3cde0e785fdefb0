"""Forces at single vertices."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import plain
from orishell.structure.load_settings import PointLoad
from orishell.structure.loads.cases import Effect, Scale, load
from orishell.structure.loads.exposure import Exposure

LEAST = 1e-2
"""Forces below this share of the own weight of panels do nothing beside it."""


def _doubt(asked: Sequence[PointLoad], scale: Scale) -> str:
    largest = max(abs(each) for point in asked for each in point.force)
    if not 0 < largest < LEAST * scale.weight:
        return ""
    return (
        f"forces of {plain(largest)} N at most beside an own weight of {plain(scale.weight, 3)} N: "
        "forces are in newtons, a person is 1000"
    )


@load("forces at points", _doubt)
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
