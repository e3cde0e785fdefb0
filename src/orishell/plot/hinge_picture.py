"""The picture of a section through a hinge, to scale."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.colours import LIGHT
from orishell.numerics.arrays import Array
from orishell.plot.scene import BORDER, LEGEND, TITLE, WIDTH, add_part, set_title
from orishell.plot.sections import HingeSection, Profile, folded

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

FACES = {1: ("upper board", "panel-front"), -1: ("lower board", "panel-back")}
SOLID = ("panel", "panel-front")
LINE, PLANE, HINGE = "#33363c", LIGHT["unfolded"], LIGHT["target"]
BESIDE, ABOVE = 0.8, 0.3
"""What is drawn beside the set-back, and above the highest point, as shares of the set-back and the
thickness together."""
LEAST = 0.8
"""Width of lines at least (points): boards are thin beside a large set-back, and are seen."""
ABREAST = 3
"""States that a row has room for."""


def section_height(section: HingeSection) -> float:
    """Height (inches) of the row of pictures that :func:`draw_hinge_section` draws."""
    low, high = _window(section)
    return (high - low) * _scale(section) + TITLE + LEGEND


def draw_hinge_section(figure: Figure, section: HingeSection, unit: str) -> None:
    """Draw the section in its states, at the bottom of a picture, all to one scale."""
    low, high = _window(section)
    width = WIDTH / ABREAST
    left = 0.5 * (WIDTH - width * len(section.folds))
    height = (high - low) * _scale(section)
    for k, (state, fold) in enumerate(zip(section.states, section.folds, strict=True)):
        axes = add_part(figure, left + k * width, LEGEND, width, height)
        _draw_state(axes, section, fold)
        axes.set_xlim(-_reach(section), _reach(section))
        axes.set_ylim(low, high)
        axes.set_aspect("equal")
        axes.axis("off")
        words = f"{state.capitalize()}, folded by {abs(np.rad2deg(fold)):.3g}°"
        if k == 0:
            names = " and ".join(f"[{i}, {j}]" for i, j in section.panels)
            words = f"Section through panels {names}, flat"
            _write_sizes(axes, section, unit)
        set_title(axes, words)
    _explain(figure, section)


def _reach(section: HingeSection) -> float:
    """How far from the crease panels are drawn (length)."""
    return section.setback + BESIDE * (section.setback + section.build.thickness)


def _scale(section: HingeSection) -> float:
    """Inches on the picture for a unit of length."""
    return (WIDTH / ABREAST - 2 * BORDER) / (2 * _reach(section))


def _window(section: HingeSection) -> tuple[float, float]:
    """Lowest and highest point of the pictures of all states (length)."""
    margin = ABOVE * (section.setback + section.build.thickness)
    heights = np.concatenate(
        [
            folded(_profile(each, _reach(section)), fold, right=each.right)[:, 1]
            for fold in section.folds
            for each in section.profiles
        ]
    )
    return float(heights.min() - margin), float(heights.max() + margin)


def _profile(profile: Profile, reach: float) -> Array:
    """The outline (P, 2) up to where it is drawn."""
    return np.minimum(profile.points, [reach, np.inf])


def _draw_state(axes: Axes, section: HingeSection, fold: float) -> None:
    reach, build = _reach(section), section.build
    thin = float(np.clip(72 * 0.08 * build.height * _scale(section), LEAST, 1.1))
    axes.axvline(0, color=PLANE, linewidth=0.8, linestyle=(0, (6, 3)), zorder=1)
    for profile in section.profiles:
        points = folded(_profile(profile, reach), fold, right=profile.right)
        colour = LIGHT[FACES.get(profile.side, SOLID)[1]]
        axes.fill(*points.T, facecolor=colour, edgecolor="none", zorder=2)
        # What is cut off at the picture's end has no line there.
        heights = len(points) // 2
        line = np.concatenate([points[heights - 1 :], points[:1]])
        axes.plot(*line.T, color=LINE, linewidth=thin, solid_joinstyle="miter", zorder=4)
    if build.membrane:
        half = 0.5 * build.membrane
        for right, end in enumerate(section.ends):
            far = min(end, reach)
            strip = np.array([[0, -half], [far, -half], [far, half], [0, half]])
            points = folded(strip, fold, right=bool(right))
            axes.fill(*points.T, facecolor=HINGE, edgecolor=HINGE, linewidth=thin, zorder=3)
    axes.plot(0, 0, "o", color=HINGE, markersize=4, zorder=5)


def _write_sizes(axes: Axes, section: HingeSection, unit: str) -> None:
    """Set-back and thickness, with dimension lines."""
    build, back, closing = section.build, section.setback, section.closing
    top, bottom = build.heights
    outer = top if closing > 0 else -bottom
    beyond = outer + closing * 0.15 * (back + build.thickness)
    look = {"arrowstyle": "<->", "shrinkA": 0, "shrinkB": 0, "color": LINE, "linewidth": 0.8}

    def measure(start: tuple[float, float], end: tuple[float, float]) -> None:
        points = 72 * _scale(section) * float(np.hypot(*np.subtract(start, end)))
        arrow = {**look, "mutation_scale": float(np.clip(0.4 * points, 3, 10))}
        axes.annotate("", start, end, arrowprops=arrow, zorder=6)

    if back:
        for x in (0.0, back):
            axes.plot([x, x], [outer, beyond], color=LINE, linewidth=0.5)
        measure((0.0, beyond), (back, beyond))
        words = f"s = {back:.3g} {unit}"
        axes.annotate(words, (back, beyond), (5, 0), textcoords="offset points", va="center")
    place = -0.5 * (back + min(section.ends[0], _reach(section)))
    measure((place, -bottom), (place, top))
    axes.annotate(
        f"t = {build.thickness:.3g} {unit}",
        (place, outer),
        (0, closing * 4),
        textcoords="offset points",
        ha="center",
        va="bottom" if closing > 0 else "top",
    )


def _explain(figure: Figure, section: HingeSection) -> None:
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    sides = sorted({each.side for each in section.profiles}, reverse=True)
    named = [FACES.get(side, SOLID) for side in sides]
    marks: list[Patch | Line2D] = [
        Patch(facecolor=LIGHT[colour], edgecolor=LINE, label=name) for name, colour in named
    ]
    hinge = "membrane" if section.build.membrane else "hinge"
    marks.append(Line2D([], [], color=HINGE, linewidth=2, label=hinge))
    marks.append(Line2D([], [], color=PLANE, linestyle="--", label="bisecting plane"))
    figure.legend(
        handles=marks,
        loc="lower center",
        bbox_to_anchor=(0.5, 0.0),
        ncols=len(marks),
        frameon=False,
    )
