"""A person on the shell, for maintenance or repair: EN 1991-1-1, 6.3.4, Q_k on roofs of category H.

The code has it on a square of 50 mm; here it is a force at a point, in the middle of a panel or of
one of its sides.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.errors import InputError
from orishell.numerics.arrays import Array
from orishell.structure.load_settings import Person, Side, WorstPlace
from orishell.structure.loads.cases import Effect, Scale, load
from orishell.structure.loads.exposure import UP, Exposure
from orishell.structure.mesh.lines import triangle_corners

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
    one = force_at(exposure, row * columns + column - first, asked.side)
    rule = f"down {place_in_words(asked.at, asked.side)} (EN 1991-1-1, 6.3.4, category H)"
    if isinstance(asked, WorstPlace):
        rule += f": {asked.found}"
    return Effect(asked.force * one, None, rule)


def place_in_words(at: Panel, side: Side) -> str:
    """Where somebody stands."""
    on = "in the middle" if side == "middle" else f"in the middle of the {side} side"
    return f"{on} of panel {at[0]}, {at[1]}"


def force_at(exposure: Exposure, panel: int, side: Side) -> Array:
    """A force of 1 N down at a place (N, 3): at the node there, or shared by the nodes around it.

    panel: As the grid counts it.
    """
    mesh = exposure.mesh
    count = len(mesh.triangles) // exposure.grid.panel_count
    cells = round((count / 2) ** 0.5)
    nodes = np.empty((cells + 1) ** 2, np.int64)
    own = mesh.triangles[panel * count : (panel + 1) * count]
    nodes[triangle_corners(cells).ravel()] = own.ravel()
    nodes = nodes.reshape(cells + 1, cells + 1)
    ends = np.eye(cells + 1)[[0, -1]]
    down, right = (_in_the_middle(mesh.points[each]) for each in (nodes[:, 0], nodes[0]))
    down, right = {
        "middle": (down, right),
        "left": (down, ends[0]),
        "right": (down, ends[1]),
        "top": (ends[0], right),
        "bottom": (ends[1], right),
    }[side]
    forces = np.zeros_like(mesh.points)
    forces[nodes] = -np.outer(down, right)[..., None] * UP
    return forces


def _in_the_middle(points: Array) -> Array:
    """Shares (k,) by which points (k, 3) of a straight line have a force in the middle of it."""
    along = np.linalg.norm(points - points[0], axis=1)
    places = along / along[-1]
    every = np.eye(len(places))
    return np.array([float(np.interp(0.5, places, each)) for each in every])
