"""A section through a shell, its surface, and the two beside it that crests and valleys follow."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.colours import LIGHT
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.design.piece import Piece
from orishell.numerics.arrays import Array
from orishell.plot.scene import BORDER, LEGEND, TITLE, WIDTH, add_part, set_title

if TYPE_CHECKING:
    from matplotlib.figure import Figure

STEPS = 12
"""Places on an edge of the shell at which the surface is drawn."""
MARGIN = 0.02
"""Free around the section, as a share of its width."""


@record
class OffsetSection:
    """Lines of a section, its x axis from end to end of a column."""

    shell: Array  # vertices (R, 2) of a column
    surface: Array  # the surface asked for (P, 2)
    above: Array  # what crests should follow (P, 2)
    below: Array  # what valleys should follow (P, 2)
    offset: float  # how far these are from the surface (length)


def find_offset_section(column: Array, piece: Piece, offset: float) -> OffsetSection:
    """Cut a surface along a column of a shell, and the two surfaces beside it.

    Parameters
    ----------
    column
        Vertices (R, 3) of the shell.
    piece
        The surface asked for.
    offset
        How far crests and valleys should be from it (length).
    """
    share = np.arange(STEPS)[:, None] / STEPS
    points = column[:-1, None] * (1 - share) + column[1:, None] * share
    points = np.concatenate([points.reshape(-1, 3), column[-1:]])
    height, normal = piece.nearest(points)
    feet = points - height[:, None] * normal
    along = feet[-1] - feet[0]
    along /= np.linalg.norm(along)
    up = normal.mean(axis=0)
    up -= (up @ along) * along
    axes = np.stack([along, up / np.linalg.norm(up)], axis=-1)
    away = abs(offset) * normal
    shell, surface, above, below = (
        (line - feet[0]) @ axes for line in (column, feet, feet + away, feet - away)
    )
    return OffsetSection(shell=shell, surface=surface, above=above, below=below, offset=abs(offset))


def offset_height(section: OffsetSection) -> float:
    """Height (inches) of the part that :func:`draw_offset_section` draws."""
    low, high = _window(section)
    wide, tall = high - low
    return float((WIDTH - 2 * BORDER) * tall / wide + TITLE + LEGEND)


def draw_offset_section(
    figure: Figure, section: OffsetSection, unit: str, bottom: float = 0.0
) -> None:
    """Draw the section to scale, from a height (inches) on; it reads without colours, too."""
    low, high = _window(section)
    height = offset_height(section) - TITLE - LEGEND
    axes = add_part(figure, 0, bottom + LEGEND, WIDTH, height)
    glass = np.concatenate([section.above, section.below[::-1]])
    axes.fill(*glass.T, color=LIGHT["target"], alpha=0.12, linewidth=0)
    looks = (
        (section.above, "crests should lie here", LIGHT["target"], (0, (6, 2)), 1.3),
        (section.surface, "surface asked for", LIGHT["target"], "-", 2.0),
        (section.below, "valleys should lie here", LIGHT["target"], (0, (1, 1.5)), 1.6),
        (section.shell, "the shell", "black", "-", 1.1),
    )
    for line, name, colour, style, width in looks:
        axes.plot(*line.T, color=colour, linestyle=style, linewidth=width, label=name)
    axes.plot(*section.shell.T, "o", color="black", markersize=2.5)
    axes.set_xlim(low[0], high[0])
    axes.set_ylim(low[1], high[1])
    axes.set_aspect("equal")
    axes.axis("off")
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, 0.0), ncols=len(looks), frameon=False)
    away = f"{plain(section.offset, 3)} {unit}"
    set_title(axes, f"Section along the middle column; dashed and dotted {away} from the surface")


def _window(section: OffsetSection) -> tuple[Array, Array]:
    """Lowest and highest corner (2,) of what is drawn."""
    points = np.concatenate([section.shell, section.surface, section.above, section.below])
    low, high = points.min(axis=0), points.max(axis=0)
    margin = MARGIN * (high[0] - low[0])
    return low - margin, high + margin
