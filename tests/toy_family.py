"""A family of one file: what it takes to add one. ``tests/families/test_toy_family.py`` adds it.

A Miura-ori sheet whose drive is the inclination theta of its panels (Schenk and Guest, PNAS 110
(2013) 3276, eq. 1-4, with unit edges): a row's edges are level, at the angle phi to the rows'
direction with cot phi = cos theta tan gamma; a column's rise by arcsin(sin theta sin gamma).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np
from numpy.typing import ArrayLike
from pydantic import Field

from orishell import Design
from orishell.conventions.table import Knob, Number
from orishell.families.pattern import Auto, Pattern
from orishell.motion.grid import CreaseValues, Grid
from orishell.numerics.arrays import Array
from orishell.polylines import alternating

STARTER = """
[shell]
family = "miura"
unit = "m"

[pattern]
rows = 3
columns = 4
gamma_deg = 60
"""


@dataclass(frozen=True)
class Miura:
    """The sheet, its unit edges at the sector angle gamma, folded to the inclination at its end."""

    grid: Grid
    gamma: float
    target_drive: float

    def without_flaps(self) -> Miura:
        return self

    def with_stop(self, stop: float) -> Miura:
        return self

    @property
    def least_turning(self) -> Miura:
        return self

    @property
    def end_drive(self) -> float:
        return float(np.pi / 2)

    @property
    def flap_columns(self) -> tuple[int, ...]:
        return ()

    @property
    def inner_columns(self) -> slice:
        return slice(None)

    def positions(self, drive: ArrayLike) -> Array:
        theta = np.asarray(drive, dtype=np.float64)[..., None, None]
        i, j = np.indices((self.grid.rows, self.grid.columns))
        phi = np.arctan2(1.0, np.cos(theta) * np.tan(self.gamma))
        rise = np.sin(theta) * np.sin(self.gamma)
        x, y = j * np.cos(phi), (j % 2) * np.sin(phi) - i * np.sqrt(1 - rise**2)
        return np.stack(np.broadcast_arrays(x, y, (i % 2) * rise), axis=-1)

    def fold_angles(self, drive: ArrayLike) -> CreaseValues:
        theta = np.asarray(drive, dtype=np.float64)[..., None, None]
        row, along = -alternating(self.grid.rows - 2), np.ones(self.grid.columns - 1)
        down = alternating(self.grid.rows - 1)
        column = 2 * np.arctan(np.cos(self.gamma) * np.tan(theta))
        return CreaseValues(
            row=2 * theta * row[:, None] * along,
            column=-column * down[:, None] * alternating(self.grid.columns - 2),
        )

    def edge_accelerations(self, start: Array, stop: Array) -> tuple[Array, Array]:
        # With T = tan gamma: |phi'| <= T and |phi''| <= 1/2 + T^2; of the columns' angle to the
        # plane the first derivative is at most 1, the second at most T.
        t = np.tan(self.gamma)
        along = np.full((len(start), self.grid.columns - 1), np.hypot(t**2, 0.5 + t**2))
        return along, np.full((len(start), self.grid.rows - 1), np.hypot(1.0, t))


class MiuraPattern(Pattern):
    """Rows, columns, and two keys of its own."""

    gamma_deg: Annotated[
        Number, Field(gt=0, lt=90), Knob.angle("Sector angle", "Of all panels", (1, 89))
    ] = 60.0
    theta_deg: Annotated[Number, Field(gt=0, lt=90)] = 50.0
    flap: Auto = "auto"  # it has none, and so no control for them

    def design_without_target(self) -> Design:
        gamma = float(np.deg2rad(self.gamma_deg))
        grid = Grid(self.rows + 2, self.columns + 2)
        return Design(
            mechanism=Miura(grid, gamma, float(np.deg2rad(self.theta_deg))),
            parameters={"gamma_deg": self.gamma_deg},
            targets={},
            closeness={},
            swept=None,
            warnings=(),
        )
