"""The picture of the loaded shell: how it deflects under every load case."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from orishell.conventions.colours import AMOUNT_MAP, LIGHT
from orishell.conventions.record import record
from orishell.conventions.row import Sign
from orishell.document.loaded import LoadedCase, LoadedShell
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.plot.scene import (
    BORDER,
    HEADING,
    LEGEND,
    TITLE,
    WIDTH,
    Camera,
    add_part,
    brightness,
    choose_camera,
    colour_scale,
    draw_lines,
    frame,
    new_figure,
    row_height,
    save,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.cm import ScalarMappable
    from matplotlib.figure import Figure

DRAWN = 0.06
"""The largest displacement is drawn as about this share of the shell's size, at most."""
MOST_CASES = 12
"""Load cases that are drawn, at most."""
BAR = 0.62
"""Height of a bar of colours with its numbers (inches)."""
TICKS = 3
"""Intervals along that bar at most, so that its figures do not run into each other."""
CREASE = (0.15, 0.15, 0.18, 0.55)
UNLOADED = "#4a4d55"
SIZES = 12, 10
"""Of the name of a load case and of the note below it (points)."""
LETTER = 0.66
"""Width of a letter in bold, as a share of its size: few are wider on average."""
LINES = 3
"""Of a name, at most."""
GAP = 0.15
"""Between what is said below a part and the name of the next (inches)."""
WALL = "#e6e3dc"
TAUT, SLACK = LIGHT["target"], LIGHT["unfolded"]


@record
class DrawnCase:
    """A load case as it is drawn."""

    case: LoadedCase  # the load case
    taut: Booleans  # which ties (K,) pull
    note: str  # the line below its name


def plot_structure(
    path: Path,
    shell: LoadedShell,
    cases: Sequence[DrawnCase],
    *,
    title: str,
    sign: Sign,
    unit: str,
    walls: Sequence[Array] = (),
) -> None:
    """Write the picture of the loaded shell as PNG: a part for every load case.

    Parameters
    ----------
    shell
        The shell, as it is without loads.
    cases
        The load cases, in the order in which they are drawn; at most :data:`MOST_CASES` are.
    title
        Heading.
    sign
        What the heading says of the shell: red where it fails.
    unit
        Unit of length.
    walls
        Walls that close its ends and bear nothing: the corners (P, K, 3) of the panels of each.
    """
    drawn = cases[:MOST_CASES]
    camera = choose_camera(shell.points)
    scales = [exaggeration(shell.points, each.case.displacements) for each in drawn]
    places = [
        shell.points + scale * each.case.displacements
        for each, scale in zip(drawn, scales, strict=True)
    ]
    around = [np.asarray(wall).reshape(-1, 3) for wall in walls]
    pictures = [camera.project(points)[0] for points in (shell.points, *places, *around)]
    columns = 2 if len(drawn) == 4 else min(len(drawn), 3)
    rows = -(-len(drawn) // columns)
    width = WIDTH / columns
    height = row_height(0.96 * width, [np.concatenate(pictures)])
    names = [lines_above(each.case.name, width, SIZES[0], LINES) for each in drawn]
    more = max(name.count("\n") for name in names)  # lines beyond the first
    row = BAR + height + 1.4 * TITLE + more * 1.2 * SIZES[0] / 72 + GAP
    figure = new_figure(LEGEND + rows * row + HEADING, title, colour=LIGHT[sign])
    panels = _Panels.of(shell)
    for number, (each, scale, points) in enumerate(zip(drawn, scales, places, strict=True)):
        down, right = divmod(number, columns)
        bottom = LEGEND + (rows - 1 - down) * row
        axes = add_part(figure, right * width, bottom + BAR, width, height)
        colours = panels.draw(axes, points, each.case, camera)
        unloaded = camera.project(shell.points)[0][panels.border]
        draw_lines(axes, unloaded, UNLOADED, 0.7, (0, (3, 2)))
        ties = camera.project(points)[0][shell.ties]
        draw_lines(axes, ties[each.taut], TAUT, 1.6)
        draw_lines(axes, ties[~each.taut], SLACK, 1.6, (0, (2, 2)))
        _draw_supports(axes, shell, camera)
        frame(axes, np.concatenate(pictures))
        _draw_walls(axes, walls, shell, camera)
        _say(axes, each, names[number], width)
        beside = add_part(figure, (right + 0.2) * width, bottom + BAR - 0.2, 0.6 * width, 0.12)
        bar = figure.colorbar(colours, cax=beside, orientation="horizontal")
        beside.locator_params(axis="x", nbins=TICKS)
        bar.set_label(_how(each.case, scale, unit))
    _explain(figure, shell, drawn, len(cases) - len(drawn), walls=bool(walls))
    save(figure, path)


def exaggeration(points: Array, displacements: Array) -> float:
    """A round number by which displacements (N, 3) of nodes (N, 3) are drawn larger, to be seen.

    1, 2 or 5 times a power of ten: the largest displacement is drawn as at most :data:`DRAWN` of
    the diagonal of the shell's box. ``frontend/src/shared/loaded.ts`` has the same rule.
    """
    largest = float(np.linalg.norm(displacements, axis=-1).max(initial=0.0))
    if not largest:
        return 1.0
    wanted = DRAWN * float(np.linalg.norm(np.ptp(points, axis=0))) / largest
    power = 10.0 ** np.floor(np.log10(wanted))
    return float(max(step for step in (1, 2, 5) if step <= wanted / power * (1 + 1e-9)) * power)


@record
class _Panels:
    """Panels of a loaded shell, what stiffens them behind them: triangles and outlines."""

    count: int
    panel: Integers  # the panel (T,) of every triangle
    triangles: Integers  # nodes (T, 3)
    rims: Integers  # ends (R, 2) of the lines round every panel, panel after panel
    ends: Integers  # where those of each panel (P,) end
    border: Integers  # ends (B, 2) of the lines round the whole sheet

    @classmethod
    def of(cls, shell: LoadedShell) -> _Panels:
        _, panels = np.unique(shell.all_panels, return_inverse=True)
        triangles, sheet = shell.all_triangles, int(panels[: len(shell.panels)].max()) + 1
        sides = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
        owned = np.column_stack([np.repeat(panels, 3), sides])
        rims, times = np.unique(owned, axis=0, return_counts=True)
        rims = rims[times == 1]
        edges, times = np.unique(rims[rims[:, 0] < sheet, 1:], axis=0, return_counts=True)
        ends = np.cumsum(np.bincount(rims[:, 0]))
        return cls(len(ends), panels, triangles, rims[:, 1:], ends, edges[times == 1])

    def draw(self, axes: Axes, points: Array, case: LoadedCase, camera: Camera) -> ScalarMappable:
        """Panels at points (N, 3) from the farthest to the nearest, coloured by displacement."""
        from matplotlib.path import Path as Outline

        from orishell.plot.shading import draw_panels

        amounts = np.linalg.norm(case.displacements, axis=-1)
        scale = colour_scale(0.0, float(amounts.max()) or 1.0, AMOUNT_MAP)
        corners = points[self.triangles]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
        colours = np.asarray(scale.to_rgba(amounts))[self.triangles]
        colours[..., :3] *= brightness(normals, camera)[:, None, None]
        picture, depth = camera.project(points)
        times = np.bincount(self.panel, minlength=self.count)
        sums = np.bincount(self.panel, depth[self.triangles].mean(axis=1), self.count)
        order = np.argsort(sums / np.maximum(times, 1), kind="stable")
        lines = np.split(picture[self.rims], self.ends[:-1])
        outlines = [Outline(each.reshape(-1, 2), [1, 2] * len(each)) for each in lines]
        cells = picture[self.triangles], colours, self.panel
        draw_panels(axes, cells, order, outlines, edge=CREASE, width=0.5)
        return scale


def _draw_supports(axes: Axes, shell: LoadedShell, camera: Camera) -> None:
    nodes, held = _supports(shell)
    places = camera.project(shell.points[nodes])[0]
    for which, fill in ((held, "black"), (~held, "white")):
        x, y = places[which].T
        axes.scatter(x, y, s=30, marker="^", facecolor=fill, edgecolor="black", linewidth=0.8)


def _supports(shell: LoadedShell) -> tuple[Integers, Booleans]:
    """Supported nodes (S,), and which of them (S,) cannot be displaced at all."""
    nodes, times = np.unique(shell.restrained[shell.restrained[:, 1] < 3, 0], return_counts=True)
    return nodes, times == 3


def _draw_walls(axes: Axes, walls: Sequence[Array], shell: LoadedShell, camera: Camera) -> None:
    """Walls at the ends, behind all panels or before them: none stands among these."""
    from matplotlib.collections import PolyCollection

    middle = camera.project(shell.points)[1].mean()
    for wall in walls:
        picture, depth = camera.project(np.asarray(wall))
        look: dict[str, Any] = {"facecolors": WALL, "edgecolors": [CREASE], "linewidths": 0.5}
        axes.add_collection(
            PolyCollection(list(picture), zorder=-1 if depth.mean() < middle else 0.5, **look)
        )


def lines_above(text: str, width: float, size: float, most: int) -> str:
    """A text of a size (points) in lines that stay above a part of a width (inches)."""
    letters = int(72 * (width - 2 * BORDER) / (LETTER * size))
    return "\n".join(textwrap.wrap(text, letters, max_lines=most, placeholder=" ..."))


def _say(axes: Axes, drawn: DrawnCase, name: str, width: float) -> None:
    """Name of a load case, and what it does to the shell, above its part."""
    note = lines_above(drawn.note, width, SIZES[1], 1)
    colour = LIGHT[drawn.case.sign]
    axes.set_title(f"{name}\n", y=1.0, fontsize=SIZES[0], fontweight="bold", color=colour)
    place: dict[str, Any] = {"transform": axes.transAxes, "ha": "center", "va": "bottom"}
    axes.text(0.5, 1.012, note, fontsize=SIZES[1], **place)


def _how(case: LoadedCase, scale: float, unit: str) -> str:
    """What colours mean, and how displacements are drawn."""
    if not case.balanced:
        return "motion that nothing resists, by the largest"
    drawn = "as it is" if scale == 1 else f"{scale:g} times as large"
    return f"displacement ({unit}), drawn {drawn}"


def _explain(
    figure: Figure, shell: LoadedShell, drawn: Sequence[DrawnCase], missing: int, *, walls: bool
) -> None:
    """What lines and marks mean, below all parts."""
    from matplotlib.lines import Line2D

    held = _supports(shell)[1]
    known = [Line2D([], [], color=UNLOADED, linewidth=0.7, linestyle="--", label="without loads")]
    taut = np.stack([each.taut for each in drawn])
    for some, colour, style, words in ((taut, TAUT, "-", "taut"), (~taut, SLACK, ":", "slack")):
        if some.any():
            line: dict[str, Any] = {"color": colour, "linestyle": style, "linewidth": 1.6}
            known.append(Line2D([], [], label=f"tie, {words}", **line))
    for some, fill, words in ((held, "black", "held"), (~held, "white", "held in part")):
        if some.any():
            mark: dict[str, Any] = {"marker": "^", "markersize": 6, "markeredgecolor": "black"}
            known.append(Line2D([], [], linestyle="", markerfacecolor=fill, label=words, **mark))
    if walls:
        look: dict[str, Any] = {"marker": "s", "markersize": 9, "markeredgecolor": CREASE}
        words = "end wall, which bears nothing"
        known.append(Line2D([], [], linestyle="", markerfacecolor=WALL, label=words, **look))
    if missing:
        known.append(Line2D([], [], linestyle="", label=f"{missing} more load cases not drawn"))
    figure.legend(handles=known, loc="lower center", ncols=len(known), frameon=False)
