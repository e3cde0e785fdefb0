"""The plan of the ground: feet with coordinates from one corner, and what the shell needs.

Coordinates stand along two lines below and to the left, one tick for each that feet have, so that
no line goes through the plan. Labels are spread along them as far as it takes, and feet are
numbered where nothing is drawn.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise
from pathlib import Path

import numpy as np

from orishell.conventions.quantities import plain, size
from orishell.conventions.version import __version__
from orishell.document import Document
from orishell.document.ground import GroundFoot, GroundPlan
from orishell.numerics.arrays import Array
from orishell.workshop.ground_marks import WIDE, ground_marks
from orishell.workshop.palettes import Anchor, Drawing, Line, Text, load_palette
from orishell.workshop.placing import Content, shifted
from orishell.workshop.title_block import decimal, draw_title_block

LETTERS = 100
"""Heights of letters that make up the longer side of the plan."""
PITCH = 1.6
"""Least distance of labels along a line of coordinates, in letters."""
SMALLER = (1.0, 0.6, 0.35)
"""Sizes of a number that are tried, in letters."""
NAMED = 6
"""So many feet are named at a coordinate."""


def draw_ground(document: Document) -> Drawing | None:
    """The plan of a shell's feet in its unit, at true size; None for a shell that has none."""
    plan = document.ground
    if plan is None:
        return None
    drawn = _Plan(plan, document.require_unit())
    content = drawn.content()
    low, high = _extent(content)
    letter = max(float(high[0] - low[0]) / LETTERS, drawn.letter)
    palette, (wide, tall) = load_palette("plain"), (high - low).tolist()
    block = draw_title_block(
        ground_facts(plan, document.unit),
        palette,
        drawn=Drawing(document.title, document.unit, wide, tall, *content),
        letter=letter,
        legend=ground_legend(plan, document.unit),
    )
    margin = 2 * letter
    up = block.height + 2 * margin - float(low[1])
    placed = shifted(content, margin - float(low[0]), up)
    below = shifted((block.lines, (), block.texts), margin, margin)
    return Drawing(
        f"{document.title}: plan of the ground",
        document.unit,
        max(wide, block.width) + 2 * margin,
        tall + block.height + 3 * margin,
        below[0] + placed[0],
        placed[1],
        below[2] + placed[2],
    )


def ground_beside(path: Path) -> Path:
    """Where the plan goes: ``ground`` beside the files of a designed shell, or ``NAME-ground``."""
    stem = "ground" if path.stem in ("pattern", "panels") else f"{path.stem}-ground"
    return path.with_name(f"{stem}{path.suffix}")


def ground_facts(plan: GroundPlan, unit: str) -> list[str]:
    """What is said of a plan, line by line."""
    x, y = (decimal(each, unit) for each in plan.corner)
    facts = [
        f"{len(plan.feet)} feet; coordinates in {unit} from the corner with the circle, "
        f"which is x {x}, y {y} of the design",
    ]
    if plan.swept is not None:
        facts.append("On its way the middle between both rows of feet stays where it is")
    pulls = [foot.pull for foot in plan.feet if foot.pull is not None]
    asides = [foot.sideways for foot in plan.feet if foot.sideways is not None]
    if pulls and asides:
        facts.append(
            f"Anchors: {plain(max(pulls), 3)} N up and {plain(max(asides), 3)} N aside at most; "
            "ground.csv has those of all feet, and ballast"
        )
    return [*facts, f"North is not known; orishell {__version__}"]


def ground_legend(plan: GroundPlan, unit: str) -> list[tuple[str, str, str]]:
    """What its lines mean, below a row of headings, with sizes."""
    wide, deep = (size(each, unit) for each in np.ptp(plan.hull, axis=0).tolist())
    rows = [("PLAN", "LINE", "SIZE"), ("shell", "solid", f"{wide} × {deep}")]
    if plan.swept is not None:
        swept = plan.swept
        wide, deep = (size(each, unit, bound=True) for each in (swept.width, swept.depth))
        high = size(swept.height, unit, bound=True)
        rows += [("on its way", "dashed", f"{wide} × {deep}"), ("height", "", high)]
    rows.append(("feet", "crosses", str(len(plan.feet))))
    if plan.walls:
        long = float(sum(np.hypot(*(wall[1] - wall[0])) for wall in plan.walls))
        rows.append(("end walls", "solid", size(long, unit)))
    return rows


class _Plan:
    """What is drawn of a plan, in its coordinates."""

    def __init__(self, plan: GroundPlan, unit: str) -> None:
        self.plan, self.unit = plan, unit
        self.feet = np.array([(foot.x, foot.y) for foot in plan.feet])
        points = np.concatenate([*plan.drawn, self.feet])
        self.low, self.high = points.min(axis=0), points.max(axis=0)
        self.ticks = [_grouped(plan.feet, axis, unit) for axis in (0, 1)]
        room = [
            float(side) / (PITCH * len(ticks))
            for side, ticks in zip(self.high - self.low, self.ticks, strict=True)
        ]
        self.letter = min(float((self.high - self.low).max()) / LETTERS, *room)

    def content(self) -> Content:
        """Lines, circles and words."""
        lines, circles, numbers = ground_marks(self.plan, self.letter, SMALLER)
        for axis in (0, 1):
            more, words = self._coordinates(axis)
            lines, numbers = (*lines, *more), (*numbers, *words)
        return lines, circles, numbers

    def _coordinates(self, axis: int) -> tuple[list[Line], list[Text]]:
        """Ticks and labels of one coordinate: below the plan, or to its left."""
        letter, ticks = self.letter, self.ticks[axis]
        values = np.array([value for value, _ in ticks])
        least, most = float(self.low[axis]), float(self.high[axis])
        at = _spread(values, PITCH * letter, least, most)
        line = float(self.low[1 - axis]) - 3 * letter

        def points(*pairs: tuple[float, float]) -> Array:
            found = np.array(pairs)
            return found if axis == 0 else found[:, ::-1]

        lines = [Line("LABEL", points((0.0, line), (max(float(values[-1]), letter), line)))]
        texts = []
        for (value, feet), place in zip(ticks, at.tolist(), strict=True):
            bend, end = line - letter, line - 3 * letter
            path = points((value, line + letter), (value, bend), (place, end))
            lines.append(Line("LABEL", path))
            x, y = points((place, end - 0.6 * letter))[0].tolist()
            words = f"{_listed(feet)}: {decimal(value, self.unit)}"
            angle = 0.5 * np.pi if axis == 0 else 0.0
            texts.append(Text("LABEL", x, y, letter, words, angle, "end"))
        return lines, texts


def _grouped(feet: Iterable[GroundFoot], axis: int, unit: str) -> list[tuple[float, list[int]]]:
    """Coordinates that feet have along an axis, ascending, and the numbers of those feet.

    Those that are written alike are one.
    """
    found: dict[str, tuple[float, list[int]]] = {}
    for foot in feet:
        value = (foot.x, foot.y)[axis]
        found.setdefault(decimal(value, unit), (value, []))[1].append(foot.number)
    return sorted(found.values())


def _listed(numbers: Sequence[int]) -> str:
    """Numbers in words: "1-13", "2, 15" or "1, 3, 5, 7, 9, 11 ..."."""
    steps = {b - a for a, b in pairwise(numbers)}
    if len(numbers) > 2 and steps == {1}:
        return f"{numbers[0]}-{numbers[-1]}"
    more = " ..." if len(numbers) > NAMED else ""
    return ", ".join(map(str, numbers[:NAMED])) + more


def _spread(places: Array, pitch: float, least: float, most: float) -> Array:
    """Ascending places (N,) moved until each is a pitch from the next, as little as it takes.

    They stay between the least and the most.
    """
    order = pitch * np.arange(len(places))
    # Pools of neighbours with one mean are the nearest values that do not fall.
    pools: list[tuple[float, int]] = []
    for value in (places - order).tolist():
        mean, count = value, 1
        while pools and pools[-1][0] > mean:
            before, many = pools.pop()
            mean, count = (before * many + mean * count) / (many + count), many + count
        pools.append((mean, count))
    means = np.concatenate([np.full(count, mean) for mean, count in pools])
    return np.asarray(np.clip(means, least, max(most - float(order[-1]), least)) + order)


def text_box(text: Text) -> Array:
    """The box (4,), left, bottom, right and top, that a text takes at most."""
    wide, half = WIDE * text.height * len(text.words), 0.5 * text.height
    starts: dict[Anchor, float] = {"start": 0.0, "middle": -0.5 * wide, "end": -wide}
    along = starts[text.anchor] + np.array([0.0, wide, wide, 0.0])
    across = np.array([-half, -half, half, half])
    turn = np.array([np.cos(text.angle), np.sin(text.angle)])
    x = text.x + turn[0] * along - turn[1] * across
    y = text.y + turn[1] * along + turn[0] * across
    return np.array([x.min(), y.min(), x.max(), y.max()])


def _extent(content: Content) -> tuple[Array, Array]:
    """Lower left and upper right corner (2,) of all that is drawn."""
    lines, circles, texts = content
    points = [line.points for line in lines]
    points += [text_box(text).reshape(2, 2) for text in texts]
    points += [np.array([[c.x - c.radius, c.y - c.radius]]) for c in circles]
    every = np.concatenate(points)
    return every.min(axis=0), every.max(axis=0)
