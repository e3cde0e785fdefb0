"""What the gallery's pages share: a folded shell with its shadow, and a crease pattern, on axes.

:func:`orishell.plot.plot_overview` writes whole pictures; these draw one thing into given axes.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

import matplotlib.pyplot as plt
import numpy as np
from numpy.typing import NDArray

from orishell import Shell
from orishell.conventions.colours import LIGHT, rgb
from orishell.deployment import Tie
from orishell.motion import panel_normals
from orishell.motion.grid import CreaseValues
from orishell.plot.scene import Camera, frame
from orishell.structure.pages.files import draw_structure

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Array = NDArray[np.float64]
Integers = NDArray[np.int64]

EXAMPLES = Path(__file__).parents[1]
"""Where the design files are."""

MOUNTAIN, VALLEY, UNFOLDED = (LIGHT[name] for name in ("mountain", "valley", "unfolded"))
BORDER, F_COLOUR, G_COLOUR = (LIGHT[name] for name in ("border-crease", "curve-f", "curve-g"))
FRONT, BACK, INK = np.array(rgb("panel-front")), np.array(rgb("panel-back")), "#33343a"
SHADOW = (0.35, 0.38, 0.45, 0.22)
LOCKED = 0.995
"""Share of the drive at which locked shells are drawn: at 1 flaps touch, and panels in one place
have no order."""
WAVES, TAUT, TIE = 6, 1e-6, LIGHT["target"]
"""Waves of a slack tie, how much of its squared length a taut one may be slack, and the colour."""
CELLS = 6
"""Cells along a panel's side: small ones sort well from the farthest to the nearest."""


def camera(azimuth_deg: float, elevation_deg: float = 30) -> Camera:
    """A camera by its angles in degrees."""
    return Camera(float(np.deg2rad(azimuth_deg)), float(np.deg2rad(elevation_deg)))


def draw_shell(
    axes: Axes,
    positions: Array,
    view: Camera,
    *,
    signs: CreaseValues | None = None,
    ground: float | None = None,
    line: float = 0.6,
    cells: int = CELLS,
) -> None:
    """Draw a folded state, from the farthest piece to the nearest.

    Parameters
    ----------
    axes
        Where to.
    positions
        Vertices (rows, columns, 3).
    view
        The camera.
    signs
        Signs of the creases: mountains are drawn red and valleys blue. None: all in one ink.
    ground
        Height of the ground that the shadow falls on; None: the lowest vertex. NaN: no shadow.
    line
        Width of creases (points).
    cells
        Along a panel's side: many where panels lie close to each other.
    """
    from matplotlib.collections import PolyCollection

    lamp = _lamp(view)
    height = float(positions[..., 2].min()) if ground is None else ground
    shown = []
    if np.isfinite(height):
        shown.append(_draw_shadow(axes, positions, view, lamp, height))
    pieces = _cells_of(*_corners(positions), cells=cells)
    colours = np.repeat(_shade(panel_normals(positions), view, lamp), cells**2, axis=0)
    sides, inks, owners = _sides(pieces, _inks(signs, positions.shape), cells)
    picture, depth = view.project(np.concatenate([pieces, sides]))
    # Creases come after the cells that they bound.
    key = depth.mean(axis=1)
    key[len(pieces) :] = key[owners]
    late = np.repeat([0, 1], [len(pieces), len(sides)])
    order = np.lexsort((late, key))
    faces = np.concatenate([colours, np.zeros((len(sides), 4))])
    axes.add_collection(
        PolyCollection(
            list(picture[order]),
            facecolors=faces[order],
            edgecolors=np.concatenate([colours, inks])[order],
            linewidths=np.array([0.7 * np.sqrt(CELLS / cells), line])[late][order],
            capstyle="round",
        )
    )
    frame(axes, np.concatenate([*shown, picture.reshape(-1, 2)]))


def draw_boards(axes: Axes, corners: Array, view: Camera, colours: Array) -> None:
    """Draw boards with four corners, and arms, from the farthest piece of a face to the nearest.

    Parameters
    ----------
    axes
        Where to.
    corners
        Corners (B, H, 4, 3) of their outlines, the lowest first.
    view
        The camera.
    colours
        Of the boards (B, 3).
    """
    from matplotlib.collections import PolyCollection

    low, high = corners[:, 0], corners[:, -1]
    walls = [
        np.stack([low[:, k], low[:, k - 3], high[:, k - 3], high[:, k]], axis=1) for k in range(4)
    ]
    faces = np.concatenate([high, low[:, ::-1], *walls])
    normal = np.cross(faces[:, 2] - faces[:, 0], faces[:, 3] - faces[:, 1])
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-12)
    seen = normal @ view.axes()[2] > 0
    light = 0.55 + 0.45 * np.maximum(normal @ _lamp(view), 0.0)
    shades = np.tile(colours, (6, 1)) * light[:, None]
    a, b, c, d = faces[seen].swapaxes(0, 1)
    cells = _cells_of(a, b, c, d)
    inks = np.repeat(shades[seen], CELLS**2, axis=0)
    picture, depth = view.project(cells)
    order = np.argsort(depth.mean(axis=1), kind="stable")
    axes.add_collection(
        PolyCollection(
            list(picture[order]),
            facecolors=inks[order],
            edgecolors=inks[order],
            linewidths=0.4,
        )
    )
    frame(axes, picture.reshape(-1, 2))


def draw_line(axes: Axes, points: Array, view: Camera, colour: str, label: str = "") -> None:
    """Draw a curve (N, 3) over a shell, with a pale outline."""
    from matplotlib.patheffects import Normal, Stroke

    outline = [Stroke(linewidth=4.5, foreground="white", alpha=0.85), Normal()]
    picture = view.project(points)[0]
    axes.plot(*picture.T, color=colour, linewidth=2.2, label=label, path_effects=outline)


def draw_ties(axes: Axes, positions: Array, ties: Sequence[Tie], view: Camera) -> None:
    """Draw ties on the ground below a shell: as waves while they are slack, straight when taut."""
    share = np.linspace(0, 1, 20 * WAVES + 1)
    for tie in ties:
        first, last = (positions[vertex] for vertex in tie.ends)
        across = np.cross(last - first, [0.0, 0.0, 1.0])
        slack = max((tie.length / float(np.linalg.norm(last - first))) ** 2 - 1, 0.0)
        wave = np.sqrt(2 * slack) / (2 * np.pi * WAVES) * np.sin(2 * np.pi * WAVES * share)
        line = first + share[:, None] * (last - first) + wave[:, None] * across
        taut = slack < TAUT
        axes.plot(*view.project(line)[0].T, color=TIE, linewidth=2.2 if taut else 1, zorder=0.5)


def draw_pattern(axes: Axes, flat: Array, signs: CreaseValues | None, line: float = 1.2) -> None:
    """Draw the flat sheet (rows, columns, 3): mountains red, valleys blue; None: all in one ink."""
    from matplotlib.collections import LineCollection

    border = np.concatenate([flat[0], flat[1:, -1], flat[-1, -2::-1], flat[-2::-1, 0]])[:, :2]
    axes.fill(*border.T, color=FRONT, zorder=0)
    row, column = _inks(signs, flat.shape)
    for first, last, inks in (
        (flat[1:-1, :-1], flat[1:-1, 1:], row[1:-1]),
        (flat[:-1, 1:-1], flat[1:, 1:-1], column[:, 1:-1]),
    ):
        creases = np.stack([first, last], axis=-2)[..., :2].reshape(-1, 2, 2)
        lines = LineCollection(list(creases), colors=inks.reshape(-1, 4), linewidths=line)
        axes.add_collection(lines)
    axes.plot(*border.T, color=BORDER, linewidth=1.2 * line, solid_joinstyle="miter")
    frame(axes, border)


def same_scale(frames: list[Axes]) -> None:
    """Give all axes the window of the largest, each about its own middle, standing on one line."""
    spans = [(np.ptp(axes.get_xlim()), np.ptp(axes.get_ylim())) for axes in frames]
    width, height = (float(extent) for extent in np.max(spans, axis=0))
    for axes in frames:
        x, y = float(np.mean(axes.get_xlim())), float(np.mean(axes.get_ylim()))
        axes.set_xlim(x - width / 2, x + width / 2)
        axes.set_ylim(y - height / 2, y + height / 2)


def _lamp(view: Camera) -> Array:
    """Unit vector to the light: above, behind the viewer's left shoulder."""
    right, _, towards = view.axes()
    level = np.array([towards[0], towards[1], 0.0])
    lamp = -0.55 * right + 0.25 * level / np.linalg.norm(level) + np.array([0.0, 0.0, 1.0])
    return np.asarray(lamp / np.linalg.norm(lamp))


def _draw_shadow(axes: Axes, positions: Array, view: Camera, lamp: Array, height: float) -> Array:
    """The shadow of all panels on the ground, as one shape; its points (P, 2)."""
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path as Outline
    from shapely import MultiPolygon, Polygon, make_valid, unary_union
    from shapely.geometry.polygon import orient

    fallen = positions - (positions[..., 2:] - height) / lamp[2] * lamp
    picture = view.project(fallen)[0]
    panels = np.stack(_corners(picture), axis=-2).reshape(-1, 4, 2)
    shape = unary_union([make_valid(Polygon(panel)) for panel in panels]).buffer(1e-9)
    parts = shape.geoms if isinstance(shape, MultiPolygon) else [shape]
    rings = [
        Outline(np.asarray(ring.coords), closed=True)
        for part in parts
        for ring in (orient(part).exterior, *orient(part).interiors)
    ]
    shadow = PathPatch(Outline.make_compound_path(*rings), facecolor=SHADOW, linewidth=0, zorder=0)
    axes.add_patch(shadow)
    return picture.reshape(-1, 2)


def _corners(points: Array) -> tuple[Array, Array, Array, Array]:
    return points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]


def _cells_of(*corners: Array, cells: int = CELLS) -> Array:
    """Cells (F * cells**2, 4, 3) of quadrilaterals by their corners (..., 3), in order around."""
    a, b, c, d = (corner.reshape(-1, 1, 1, 3) for corner in corners)
    steps = np.linspace(0, 1, cells + 1)
    u, v = steps[:, None, None], steps[None, :, None]
    points = (1 - u) * ((1 - v) * a + v * d) + u * ((1 - v) * b + v * c)
    parts = (points[:, :-1, :-1], points[:, 1:, :-1], points[:, 1:, 1:], points[:, :-1, 1:])
    return np.stack(parts, axis=-2).reshape(-1, 4, 3)


def _sides(pieces: Array, inks: tuple[Array, Array], cells: int) -> tuple[Array, Array, Integers]:
    """Pieces of all panels' sides as polygons (S, 4, 3), their colours, and whose cell each is."""
    row, column = inks
    number = np.arange(len(pieces)).reshape(-1, cells, cells)
    sides, colours, owners = [], [], []
    for mine, ends, ink in (
        (number[:, 0], (0, 3), row[:-1]),
        (number[:, -1], (1, 2), row[1:]),
        (number[:, :, 0], (0, 1), column[:, :-1]),
        (number[:, :, -1], (3, 2), column[:, 1:]),
    ):
        first, last = (pieces[mine.ravel(), end] for end in ends)
        sides.append(np.stack([first, last, last, first], axis=1))
        colours.append(np.repeat(ink.reshape(-1, 4), cells, axis=0))
        owners.append(mine.ravel())
    return np.concatenate(sides), np.concatenate(colours), np.concatenate(owners)


def _inks(signs: CreaseValues | None, shape: tuple[int, ...]) -> tuple[Array, Array]:
    """Colours of all edges: along rows (rows, columns-1, 4), down columns (rows-1, columns, 4)."""
    from matplotlib.colors import to_rgba_array

    rows, columns = shape[:2]
    if signs is None:
        ink = to_rgba_array(INK)[0]
        return np.tile(ink, (rows, columns - 1, 1)), np.tile(ink, (rows - 1, columns, 1))
    palette = to_rgba_array([UNFOLDED, VALLEY, BORDER, MOUNTAIN])  # by sign; 2 is the border
    row = np.pad(signs.row.astype(int), ((1, 1), (0, 0)), constant_values=2)
    column = np.pad(signs.column.astype(int), ((0, 0), (1, 1)), constant_values=2)
    return palette[row], palette[column]


def _shade(normals: Array, view: Camera, lamp: Array) -> Array:
    """Colours (F, 4) of panels: the paper's front and back, lit by the lamp."""
    normals = normals.reshape(-1, 3)
    front = normals @ view.axes()[2] >= 0
    facing = np.where(front[:, None], normals, -normals)
    brightness = 0.62 + 0.38 * np.clip(facing @ lamp, 0, 1)
    colour = np.where(front[:, None], FRONT, BACK) * brightness[:, None]
    return np.concatenate([colour, np.ones((len(colour), 1))], axis=-1)


def plane_axes(name: str, size: tuple[float, float]) -> tuple[Figure, Axes]:
    """A figure of that name and size (inches) with axes to scale, for plane curves."""
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(num=name, figsize=size, layout="constrained")
    axes.set_aspect("equal")
    axes.axis("off")
    return figure, axes


def show_loaded(shell: Shell) -> None:
    """The shell under its loads, as ``structure.png`` has it."""
    assert shell.document.loaded is not None
    assert shell.analysis is not None
    with TemporaryDirectory() as directory:
        path = Path(directory) / "structure.png"
        draw_structure(path, shell.document.loaded, shell.analysis, shell.file.unit)
        picture = plt.imread(path)
    height, width = picture.shape[:2]
    _, axes = plt.subplots(figsize=(12, 12 * height / width), layout="constrained")
    axes.imshow(picture)
    axes.axis("off")
