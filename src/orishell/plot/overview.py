"""The overview picture: crease pattern, the shell on its target curves, states on the way."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.colours import LIGHT, rgb
from orishell.conventions.quantities import box
from orishell.conventions.record import record
from orishell.motion import FoldingMotion, Mechanism, find_assignment
from orishell.motion.as_made import AsMade, as_cut
from orishell.motion.grid import CreaseValues
from orishell.motion.hinge_lines import IN_CREASES, HingeLines
from orishell.motion.hinges import Hinges
from orishell.motion.layout import Layout, edge_signs, points_of
from orishell.motion.quads import grid_corners, unit_normals
from orishell.numerics.arrays import Array, Integers
from orishell.plot.hinge_picture import draw_hinge_section, section_height
from orishell.plot.scene import (
    BORDER,
    HEADING,
    LEGEND,
    TITLE,
    WIDTH,
    Camera,
    add_part,
    choose_camera,
    draw_lines,
    draw_targets,
    frame,
    line_width,
    new_figure,
    row_height,
    save,
    set_title,
)
from orishell.plot.sections import HingeSection, OffsetSection, draw_offset_section, offset_height

if TYPE_CHECKING:
    from matplotlib.axes import Axes


MOUNTAIN, VALLEY, UNFOLDED = (LIGHT[name] for name in ("mountain", "valley", "unfolded"))
RIM, CONTACT = LIGHT["border-crease"], LIGHT["contact"]
PAPER, BACK = np.array(rgb("panel-front")), np.array(rgb("panel-back"))
LAMP = np.array([-0.45, -0.55, 0.70])
STATE_SHARES = (0.25, 0.5, 0.75)
"""States shown between flat and target, as shares of the drive at the target."""
OPENING = (1.0, 0.8, 0.4)
"""States shown of a shell that is opened from its pack, as shares of the way from the target."""
LONG = 70
"""Letters of a title over half the picture, from which on it has two lines."""
PATTERN_DRAWN, SHELL_DRAWN = 110, 70
"""Rows or columns drawn at most; a finer sheet is drawn with every k-th of them."""


@dataclass(frozen=True, slots=True)
class DrawnContact:
    """A state in which panels touch, and these panels by row and column."""

    drive: float  # drive of the state (radians)
    panels: tuple[tuple[int, int], ...]  # row and column of the panels that touch


def _no_others(_: float) -> Sequence[Array]:
    return ()


def plot_overview(
    path: Path,
    motion: FoldingMotion,
    targets: Mapping[str, Array],
    *,
    title: str,
    last: str,
    unit: str,
    contact: DrawnContact | None = None,
    hinge: HingeSection | None = None,
    beside: OffsetSection | None = None,
    hinges: HingeLines = IN_CREASES,
    others: Callable[[float], Sequence[Array]] = _no_others,
    sizes: tuple[str, str] | None = None,
) -> None:
    """Write the overview picture as PNG.

    Parameters
    ----------
    motion
        Some of its states are shown, its pack among them if it has one.
    targets
        Target curves "f" and "g" (N, 3), drawn with the shell; may be empty.
    title
        Heading.
    last
        What the target state is, for example "Locked".
    unit
        Unit of length, for the sizes under the heading.
    contact
        A contact to draw beside the other states, if there is one before the target.
    hinge
        A section through a hinge to draw below them, where panels have a thickness.
    beside
        A section with the surfaces that crests and valleys should follow, to draw below all.
    hinges
        Those of whole boards, which are drawn where they are: beside the panels of the sheet.
    others
        Corners (K, 4, 3) of panels of each part that goes with the sheet and is there at a drive
        (radians).
    sizes
        What is said of the sizes of the flat sheet and of the shell, as its report says them; None
        for those of the panels that are drawn.
    """
    target = motion.mechanism.target_drive
    mechanism, flaps = motion.mechanism, _FlapsBeside.of(motion.mechanism)
    locked = motion.target.positions
    camera = choose_camera(locked)

    def panels(drive: float) -> Array:
        """Corners (F, 4, 3) of all panels in a state, those of what goes with the sheet last."""
        positions = mechanism.positions(drive)
        if isinstance(hinges, Hinges):
            return hinges.drawn_boards(positions).reshape(-1, 4, 3)
        return np.concatenate([_drawn_panels(positions), flaps.at(drive), *others(drive)])

    drives = [share * target for share in STATE_SHARES]
    if motion.pack is not None:
        drives = [target + share * (motion.pack - target) for share in OPENING] + drives[-1:]
    if contact is not None:
        drives.append(contact.drive)

    states = [panels(drive) for drive in drives]
    shown_panels = panels(target)

    made = as_cut(mechanism)
    points = _landscape(made.flat)
    above = row_height(WIDTH / 2, [points, camera.project(shown_panels.reshape(-1, 3))[0]])
    count = len(states)
    spans = [np.ptp(camera.project(each.reshape(-1, 3))[0], axis=0) for each in states]
    below = row_height(WIDTH / count, [np.stack([np.zeros(2), np.max(spans, axis=0)])])
    base = 0.0 if hinge is None else section_height(hinge)
    low, base = base, base + (0.0 if beside is None else offset_height(beside))
    foot = base + BORDER + below + TITLE + LEGEND
    figure = new_figure(foot + above + TITLE + HEADING, title)

    pattern = add_part(figure, 0, foot, WIDTH / 2, above)
    drawn = (shown_panels if hinges.beside else locked).reshape(-1, 3)
    own = [box(np.ptp(each, axis=0).tolist(), unit) for each in (points, drawn)]
    flat, folded = (each.replace(" x ", " × ") for each in sizes or own)
    _draw_sheet(pattern, mechanism, flaps, (points, made), flat)
    shell = add_part(figure, WIDTH / 2, foot, WIDTH / 2, above)
    _draw_shell(shell, shown_panels, camera, WIDTH / 2)
    draw_targets(shell, targets, camera)
    shown = f"{last}{', with f and g' if targets else ''},"
    set_title(shell, f"{shown}{' ' if len(shown + folded) < LONG else chr(10)}{folded}")
    each = WIDTH / count
    frames = [add_part(figure, k * each, base + BORDER, each, below) for k in range(count)]
    for axes, drive, corners in zip(frames, drives, states, strict=True):
        _draw_shell(axes, corners, camera, each)
        packed = "Pack, drive" if drive == motion.pack else "Drive"
        set_title(axes, f"{packed} {np.rad2deg(drive):.3g}°")
    if contact is not None:
        _mark_panels(frames[-1], mechanism.positions(contact.drive), contact, camera)
    _same_scale(frames)
    if hinge is not None:
        draw_hinge_section(figure, hinge, unit)
    if beside is not None:
        draw_offset_section(figure, beside, unit, low)
    save(figure, path)


def _thinned(count: int, most: int) -> tuple[Integers, int]:
    """Every k-th of rows or columns too many to draw, k odd so that signs alternate, and k."""
    stride = max(1, -(-(count - 3) // most))
    stride += 1 - stride % 2
    kept = np.concatenate([[0], np.arange(1, count - 1, stride), [count - 2, count - 1]])
    return np.unique(kept), stride


def _landscape(sheet: Array) -> Array:
    """The sheet (V, 2), turned by a quarter if it is taller than wide."""
    wide, tall = np.ptp(sheet, axis=0)
    return sheet if wide >= tall else np.stack([-sheet[..., 1], sheet[..., 0]], axis=-1)


def _draw_pattern(axes: Axes, sheet: Array, signs: CreaseValues, inches: float) -> str:
    """Draw the sheet (rows, columns, 2), and say which rows and columns are left out."""
    (i, down), (j, right) = (_thinned(count, PATTERN_DRAWN) for count in sheet.shape[:2])
    sheet = sheet[np.ix_(i, j)]
    row = signs.row[np.ix_(i[1:-1] - 1, j[:-1])]
    column = signs.column[np.ix_(i[:-1], j[1:-1] - 1)]
    width = line_width(sheet, inches, 1.3, 0.35)
    rows = np.stack([sheet[1:-1, :-1], sheet[1:-1, 1:]], axis=-2)
    columns = np.stack([sheet[:-1, 1:-1], sheet[1:, 1:-1]], axis=-2)
    for sign, colour, style in ((-1, MOUNTAIN, "-"), (1, VALLEY, "-"), (0, UNFOLDED, (0, (3, 2)))):
        segments = np.concatenate([rows[row == sign], columns[column == sign]])
        if len(segments):
            draw_lines(axes, segments, colour, width, style)
    border = np.concatenate([sheet[0], sheet[1:, -1], sheet[-1, -2::-1], sheet[-2::-1, 0]])
    axes.plot(*border.T, color=RIM, linewidth=max(1.2, width), solid_joinstyle="miter")
    axes.fill(*border.T, color=PAPER, zorder=0)
    axes.set_aspect("equal")
    axes.axis("off")
    names = [(MOUNTAIN, "mountain"), (VALLEY, "valley"), (RIM, "border")]
    if (row == 0).any() or (column == 0).any():
        names.insert(2, (UNFOLDED, "unfolded"))
    for colour, name in names:
        axes.plot([], [], color=colour, label=name, linestyle="--" if colour == UNFOLDED else "-")
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.01), ncols=len(names), frameon=False)
    return f" (every {down}th row, every {right}th column drawn)" if down * right > 1 else ""


def _draw_sheet(
    axes: Axes, mechanism: Mechanism, flaps: _FlapsBeside, cut: tuple[Array, AsMade], sides: str
) -> None:
    """Draw the crease pattern of a sheet as it is cut, its vertices (V, 2) turned."""
    points, made = cut
    if made.is_one_sheet:
        grid = mechanism.grid
        sheet = points[: grid.vertex_count].reshape(grid.rows, grid.columns, 2)
        thinned = _draw_pattern(axes, sheet, find_assignment(mechanism), WIDTH / 2)
        flaps.draw_pattern(axes, points)
        set_title(axes, f"Crease pattern, {sides}{thinned}")
        return
    _draw_strips(axes, points, made, edge_signs(mechanism)[made.edges], WIDTH / 2)
    count = mechanism.grid.columns - 1
    set_title(axes, f"Crease patterns of its {count} strips, joined along their long sides")


def _draw_strips(axes: Axes, points: Array, made: AsMade, signs: Integers, inches: float) -> None:
    """Draw the strips of a sheet, vertices (V, 2), creases by their signs (E,)."""
    from matplotlib.collections import PolyCollection

    crease, edges = made.mesh.crease, made.mesh.edges
    width = line_width(points[edges], inches, 1.3, 0.35)
    faces = list(points[made.mesh.faces])
    axes.add_collection(PolyCollection(faces, facecolors=PAPER, zorder=0))
    kinds = [
        (RIM, "border", ~crease),
        (MOUNTAIN, "mountain", crease & (signs < 0)),
        (VALLEY, "valley", crease & (signs > 0)),
    ]
    kinds = [kind for kind in kinds if kind[-1].any()]
    for colour, name, which in kinds:
        draw_lines(axes, points[edges[which]], colour, width)
        axes.plot([], [], color=colour, label=name)
    axes.autoscale_view()
    axes.set_aspect("equal")
    axes.axis("off")
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.01), ncols=len(kinds), frameon=False)


@record
class _FlapsBeside:
    """Flaps that are no columns of the grid; none of them for most sheets."""

    mechanism: Mechanism
    faces: Integers  # corners (K, 4) of them
    edges: Integers  # vertices (E, 2) of their edges, hinges included
    signs: Integers  # (E,) of those that fold at the target

    @classmethod
    def of(cls, mechanism: Mechanism) -> _FlapsBeside:
        layout, own = Layout.of(mechanism), mechanism.grid.panel_count
        edges, kept = layout.edges
        first = int(kept.sum())
        signs = edge_signs(mechanism)[first:]
        return cls(mechanism, layout.faces[own:], edges[first:], signs)

    def at(self, drive: float) -> Array:
        """Corners (K, 4, 3) in a state."""
        return points_of(self.mechanism, drive)[self.faces]

    def draw_pattern(self, axes: Axes, points: Array) -> None:
        """Draw them in the flat sheet with vertices (V, 2)."""
        from matplotlib.collections import PolyCollection

        if not len(self.faces):
            return
        axes.add_collection(PolyCollection(list(points[self.faces]), facecolors=PAPER, zorder=0))
        for sign, colour in ((0, RIM), (-1, MOUNTAIN), (1, VALLEY)):
            draw_lines(axes, points[self.edges[self.signs == sign]], colour, 1.0)
        axes.autoscale_view()


def _drawn_panels(positions: Array) -> Array:
    """Corners (F, 4, 3) of the panels of a grid, of every few together if they are many."""
    some = positions[np.ix_(*(_thinned(n, SHELL_DRAWN)[0] for n in positions.shape[:2]))]
    return np.asarray(grid_corners(some).reshape(-1, 4, 3))


def _draw_shell(axes: Axes, corners: Array, camera: Camera, inches: float) -> None:
    """Draw panels (F, 4, 3), from the farthest to the nearest."""
    from matplotlib.collections import PolyCollection

    picture, depth = camera.project(corners)
    order = np.argsort(depth.mean(axis=-1), kind="stable")
    colours = _shade(unit_normals(corners), camera)
    width = line_width(picture[:, :2], inches, 0.6, 0.15)  # row by row, their left edges
    axes.add_collection(
        PolyCollection(
            list(picture[order]),
            facecolors=colours[order],
            edgecolors=(0.2, 0.2, 0.24, 0.9),
            linewidths=width,
        )
    )
    frame(axes, picture.reshape(-1, 2))


def _mark_panels(axes: Axes, positions: Array, contact: DrawnContact, camera: Camera) -> None:
    """Panels that touch, on top of the shell, and a ring around them."""
    from matplotlib.collections import PolyCollection

    marked = [
        camera.project(positions[[i, i + 1, i + 1, i], [j, j, j + 1, j + 1]])[0]
        for i, j in contact.panels
    ]
    axes.add_collection(
        PolyCollection(marked, facecolors=CONTACT, edgecolors=RIM, linewidths=0.6, alpha=0.85)
    )
    middle = np.concatenate(marked).mean(axis=0)
    axes.plot(*middle, "o", markersize=26, fillstyle="none", color=CONTACT, linewidth=1.5)
    names = " and ".join(f"[{i}, {j}]" for i, j in contact.panels)
    set_title(axes, f"First contact, drive {np.rad2deg(contact.drive):.4g}°:\npanels {names}")


def _shade(normals: Array, camera: Camera) -> Array:
    """Colours (F, 4): the paper's front and back, lit from the upper left."""
    right, up, towards = camera.axes()
    front = normals @ towards >= 0
    facing = np.where(front[:, None], normals, -normals)
    light = LAMP / np.linalg.norm(LAMP)
    lamp = light[0] * right + light[2] * up + 0.75 * towards
    brightness = 0.55 + 0.45 * np.clip(facing @ (lamp / np.linalg.norm(lamp)), 0, 1)
    colour = np.where(front[:, None], PAPER, BACK) * brightness[:, None]
    return np.concatenate([colour, np.ones((len(colour), 1))], axis=-1)


def _same_scale(frames: list[Axes]) -> None:
    """Give all states the window of the largest, each about its own middle."""
    spans = [(np.ptp(a.get_xlim()), np.ptp(a.get_ylim())) for a in frames]
    width, height = max(s[0] for s in spans), max(s[1] for s in spans)
    for axes in frames:
        x, y = np.mean(axes.get_xlim()), np.mean(axes.get_ylim())
        axes.set_xlim(x - width / 2, x + width / 2)
        axes.set_ylim(y - height / 2, y + height / 2)
