"""A person on the shell, for maintenance or repair: EN 1991-1-1, 6.3.4, Q_k on roofs of category H.

The code has it on a square of 50 mm; here it is a force at a point, in the middle of a panel or of
one of its sides.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.errors import InputError
from orishell.numerics.arrays import Array, Integers
from orishell.structure.load_settings import Person, Side, WorstPlace
from orishell.structure.loads.cases import Effect, Scale, load
from orishell.structure.loads.exposure import UP, Exposure
from orishell.structure.mesh.sheet import triangle_corners

if TYPE_CHECKING:
    from orishell.motion.grid import Panel

FORCES = (200.0, 1e4)
"""A child; ten of Q_k of EN 1991-1-1, 6.3.4 (N)."""


def _doubt(asked: Person, _: Scale) -> str:
    if FORCES[0] <= asked.force <= FORCES[1]:
        return ""
    return f"a person of {asked.force:g} N: forces are in newtons, and a code's person is 1000"


@load("a person", _doubt)
def person(exposure: Exposure, asked: Person) -> Effect:
    """Down at the place that it has, or that was found for it.

    Raises InputError: If there is no such panel.
    """
    assert asked.at is not None, "a place was found before"
    (row, column), grid = asked.at, exposure.grid
    rows, columns, first = grid.rows - 1, grid.columns - 1, exposure.before
    if not (row < rows and first <= column < first + columns):
        raise InputError(
            "there is no such panel between the flaps",
            where="person at",
            got=f"[{row}, {column}]",
            expected=f"a row from 0 to {rows - 1}, a column from {first} to {first + columns - 1}",
        )
    nodes = place_nodes(exposure, row * columns + column - first, asked.side)
    forces = np.zeros_like(exposure.mesh.points)
    np.add.at(forces, nodes, -asked.force / len(nodes) * UP)
    rule = f"down {place_in_words(asked.at, asked.side)} (EN 1991-1-1, 6.3.4, category H)"
    if isinstance(asked, WorstPlace):
        rule += f": {asked.found}"
    return Effect(forces, None, rule)


def place_in_words(at: Panel, side: Side) -> str:
    """Where somebody stands."""
    on = "in the middle" if side == "middle" else f"in the middle of the {side} side"
    return f"{on} of panel {at[0]}, {at[1]}"


def place_nodes(exposure: Exposure, panel: int, side: Side) -> Integers:
    """The node in the middle of a panel or of a side, or the 2 or 4 nodes around it (n,).

    panel: As the grid counts it.
    """
    count = len(exposure.mesh.triangles) // exposure.grid.panel_count
    cells = round((count / 2) ** 0.5)
    nodes = np.empty((cells + 1) ** 2, np.int64)
    own = exposure.mesh.triangles[panel * count : (panel + 1) * count]
    nodes[triangle_corners(cells).ravel()] = own.ravel()
    middle = slice(cells // 2, (cells + 1) // 2 + 1)
    down, right = {
        "middle": (middle, middle),
        "left": (middle, slice(0, 1)),
        "right": (middle, slice(-1, None)),
        "top": (slice(0, 1), middle),
        "bottom": (slice(-1, None), middle),
    }[side]
    return np.asarray(nodes.reshape(cells + 1, cells + 1)[down, right].ravel())


def force_at(exposure: Exposure, panel: int, side: Side) -> Array:
    """A force of 1 N down at a place (N, 3)."""
    forces, nodes = np.zeros_like(exposure.mesh.points), place_nodes(exposure, panel, side)
    forces[nodes] = -UP / len(nodes)
    return forces
