"""A second skin and its walls, as parts that the sheet carries."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.design.carried import CarriedPart
from orishell.design.hung import HungLines
from orishell.motion import Mechanism
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.carried import Carried
from orishell.motion.grid import Panel
from orishell.motion.second_skin import OUTER, SecondSkin, Wall

TOP, BOTTOM = 1, -1
"""Faces that walls hang on: of the second skin, and of the sheet."""


def skin_parts(skin: SecondSkin, walls: Sequence[Wall]) -> tuple[CarriedPart, ...]:
    """The second skin, then its walls."""
    below, *between = skin.carried(walls)
    columns = range(skin.columns.start, skin.columns.stop)
    panels = [(row, k) for row in skin.parallel.tolist() for k in columns[:-1]]
    called = [(row, k) for row in skin.names.tolist() for k in columns[:-1]]
    rows = sorted({wall.row + step for wall in walls for step in (0, 1)})
    lines = [_lines(below, each, wall, part=1) for each, wall in zip(between, walls, strict=True)]
    return (
        CarriedPart(
            strips=below,
            title="Second skin",
            kind="skin",
            names=tuple(f"skin {row},{column}" for row, column in called),
            hung_on=tuple(panels),
            borne_at=np.array([(row, k) for row in rows for k in columns]),
            hung=None,
            bears=HungLines.joined(lines),
        ),
        *map(_wall, between, walls),
    )


def _wall(strips: Carried, wall: Wall) -> CarriedPart:
    columns = range(strips.columns.start, strips.columns.stop)
    panels: list[Panel] = [(wall.row, k) for k in columns[:-1]]
    return CarriedPart(
        strips=strips,
        title=f"Wall of row {wall.row}",
        kind="wall",
        names=tuple(f"wall {wall.row},{k}" for k in columns[:-1]),
        hung_on=tuple(panels),
        borne_at=np.array([(wall.row + step, k) for step in (0, 1) for k in columns]),
        hung=_lines(strips.sheet, strips, wall, part=OUTER),
    )


def _lines(on: Mechanism, strips: Carried, wall: Wall, part: int) -> HungLines:
    """Where a wall hangs on the sheet, or on the second skin, from the upper edge of panels."""
    (hanging,) = (each for each in strips.hung if each.part == part)
    columns = strips.columns if part == OUTER else slice(0, strips.grid.columns)
    across = np.arange(columns.start, columns.stop - 1)
    # Corners of panels as they are cut: upper left, lower left, lower right, upper right.
    panels = hanging.panels * (on.grid.columns - 1) + across
    corners = panels_laid_flat(on)[panels]
    begin, end = corners[:, [0, 3]], corners[:, [1, 2]]
    at = np.stack([hanging.at[:-1], hanging.at[1:]], axis=-1)
    return HungLines(
        names=(f"wall {wall.row}",) * len(across),
        panels=panels,
        sides=np.full(len(across), BOTTOM if part == OUTER else TOP),
        ends=begin + at[..., None] * (end - begin),
        away=at * np.linalg.norm(end - begin, axis=-1),
    )
