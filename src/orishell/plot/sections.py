"""Sections: boards square to a crease; a shell, its surface and what crests and valleys follow."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.colours import LIGHT
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.design import PanelSpec
from orishell.design.piece import Piece
from orishell.motion import FoldingMotion
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.boards import Boards
from orishell.motion.mechanism import is_flat_at_first
from orishell.numerics.arrays import Array
from orishell.numerics.equals import first_largest
from orishell.plot.scene import BORDER, LEGEND, TITLE, WIDTH, add_part, set_title

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SAME = 1e-3
"""States whose fold angles differ by less than this are drawn once (radians)."""


@record
class Profile:
    """A board where it is cut square to the crease."""

    right: bool  # whether it lies on the right
    side: int  # as in :class:`~orishell.motion.boards.Boards`
    # its outline (P, 2): distance from the crease and height over the hinge plane; down the near
    # end comes last, P being twice the number of heights
    points: Array


@record
class HingeSection:
    """A crease, and the boards that are cut square to it through its middle."""

    # row and column of the panels on the left and on the right
    panels: tuple[tuple[int, int], tuple[int, int]]
    profiles: tuple[Profile, ...]  # the boards that are cut
    ends: tuple[float, float]  # how far the panels reach, on the left and on the right (length)
    setback: float  # the largest distance of a board from the crease (length)
    build: PanelSpec  # what panels are made of
    # names of states, and the fold angles of the crease there (radians)
    states: tuple[str, ...]
    folds: tuple[float, ...]

    @property
    def closing(self) -> int:
        """The face that closes: 1 the upper, -1 the lower one."""
        return 1 if max(self.folds, key=abs) >= 0 else -1


def find_hinge_section(
    motion: FoldingMotion, boards: Boards, build: PanelSpec
) -> HingeSection | None:
    """The section through the crease from which boards stand back farthest.

    Parameters
    ----------
    motion
        The motion of the sheet; of its states flat, target and pack are shown.

    Returns
    -------
    HingeSection or None
        None if no crease has boards on both sides.
    """
    if boards.hinges.beside:
        return None  # they do not stand back
    mechanism = motion.mechanism
    grid = mechanism.grid
    boards = boards.chosen(boards.panels < grid.panel_count)  # creases of the sheet only
    corners = panels_laid_flat(mechanism)[: grid.panel_count]
    edges = grid.faces_edges()
    along = np.roll(corners, -1, axis=1) - corners
    inward = np.stack([-along[..., 1], along[..., 0]], axis=-1)
    inward /= np.linalg.norm(inward, axis=-1, keepdims=True)

    own, ways = corners[boards.panels], inward[boards.panels]
    away = np.einsum("bhkx,bex->bhke", boards.outlines[..., :2], ways)
    back = (away - (own * ways).sum(axis=-1)[:, None, None]).min(axis=2).max(axis=1)
    most = np.full((2, edges.max() + 1), -np.inf)
    # An edge is the left or top one of one panel, the right or bottom one of the other.
    for which, places in enumerate(([0, 3], [1, 2])):
        np.maximum.at(most[which], edges[boards.panels][:, places], back[:, places])
    farthest = np.where(np.isfinite(most).all(axis=0), most.max(axis=0), -np.inf)
    edge = first_largest(farthest)
    if farthest[edge] == -np.inf:
        return None

    profiles, beside, ends = [], [], []
    for right, (panel, place) in enumerate(np.argwhere(edges == edge).tolist()):
        row, column = divmod(panel, grid.columns - 1)
        beside.append((row, column))
        start = corners[panel, place] + 0.5 * along[panel, place]
        lying = np.concatenate([corners[panel], np.zeros((4, 1))], axis=1)
        whole = _cut(lying[None], start, inward[panel, place])
        assert whole is not None  # from the middle of a side
        ends.append(float(whole[0, 0]))
        for board in np.flatnonzero(boards.panels == panel).tolist():
            points = _cut(boards.outlines[board], start, inward[panel, place])
            if points is not None:
                profiles.append(Profile(bool(right), int(boards.sides[board]), points))
    first = "flat" if is_flat_at_first(mechanism) else "open"
    drives = [0.0, mechanism.target_drive] + ([] if motion.pack is None else [motion.pack])
    folds = mechanism.fold_angles(np.array(drives)).on_edges()[:, edge].tolist()
    shown = [k for k, fold in enumerate(folds) if all(abs(fold - x) > SAME for x in folds[:k])]
    return HingeSection(
        panels=(beside[0], beside[1]),
        profiles=tuple(profiles),
        ends=(ends[0], ends[1]),
        setback=float(max(farthest[edge], 0.0)),
        build=build,
        states=tuple((first, "target", "pack")[k] for k in shown),
        folds=tuple(folds[k] for k in shown),
    )


def _cut(outlines: Array, start: Array, way: Array) -> Array | None:
    """Outline (2 H, 2) of the section of outlines (H, K, 3); None if they are missed.

    It is cut from a point (2,) of the flat sheet along a unit vector (2,).
    """
    flat = outlines[..., :2]
    along = np.roll(flat, -1, axis=1) - flat
    inward = np.stack([-along[..., 1], along[..., 0]], axis=-1)
    rate, level = inward @ way, (inward * (flat - start)).sum(axis=-1)
    at = level / np.where(rate == 0, 1.0, rate)
    near = np.where(rate > 0, at, -np.inf).max(axis=1)
    far = np.where(rate < 0, at, np.inf).min(axis=1)
    if (near >= far).any():
        return None
    height = outlines[:, 0, 2]
    ends = np.stack([far, height], axis=-1), np.stack([near, height], axis=-1)
    return np.concatenate([ends[0], ends[1][::-1]])


def folded(points: Array, fold: float, *, right: bool) -> Array:
    """Points (..., 2) of a panel folded by an angle (radians), as the section shows them.

    They are distances from the crease and heights over the hinge plane. In the section the crease
    is in the origin, the bisecting plane upright through it.
    """
    away, height = points[..., 0], points[..., 1]
    cosine, sine = np.cos(fold / 2), np.sin(fold / 2)
    x = away * cosine - height * sine
    return np.stack([x if right else -x, away * sine + height * cosine], axis=-1)


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
