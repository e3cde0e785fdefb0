"""The plan of the ground on paper: as large as it fits a page, with a table of its feet below."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import ceil
from textwrap import wrap

import numpy as np

from orishell.conventions.quantities import MILLIMETRES, plain
from orishell.conventions.record import record
from orishell.document import Document
from orishell.document.ground import GroundPlan
from orishell.numerics.arrays import Array
from orishell.workshop.ground_marks import WIDE, ground_marks
from orishell.workshop.ground_plan import ground_facts, ground_legend
from orishell.workshop.palettes import Drawing, Line, Text
from orishell.workshop.placing import shifted
from orishell.workshop.settings import Paper
from orishell.workshop.tiling import BORDER_MM, PAPERS_MM
from orishell.workshop.title_block import decimal, round_length

SCALES = (1, 2, 5, 10, 20, 25, 50, 100, 200, 250, 500, 1000)
"""The plan is printed at one over one of these, or over ten, a hundred ... times one."""
LETTER, TITLE = 2.1, 4.0
"""Heights of capitals (mm): of letters of 8.3 and 15.8 points."""
ROW = 4.2
"""From line to line (mm)."""
PAD = 14.0
"""Room around the plan for numbers of feet (mm)."""
SHARE = 0.35
"""The table takes no more than this of the page with the plan."""
BAR = 40.0
"""Length of the bar that shows the scale, at most (mm)."""
GAP = 3
"""Between columns of the table, in characters."""


@record
class PrintedPlan:
    """The plan on upright pages (mm)."""

    pages: tuple[Drawing, ...]  # the plan, then those that its table needs in addition
    scale: int  # one over this is its scale


def print_ground(document: Document, paper: Paper) -> PrintedPlan | None:
    """The plan, as large as it fits the first page; None for a shell that has no feet.

    No letters are smaller than eight points. The number of a foot that has no room beside it is in
    the table only.
    """
    plan, title = document.ground, document.title
    if plan is None:
        return None
    unit, page = document.require_unit(), np.array(PAPERS_MM[paper])
    table = _Table(plan, unit, float(page[0]) - 2 * BORDER_MM)
    rows = min(table.rows, int(SHARE * page[1] / ROW))
    left, top = BORDER_MM, float(page[1]) - BORDER_MM
    words = [*_header(title, plan, unit, (left, top), float(page[0]) - 2 * left)]
    above, below = words[-1].y - 3 * ROW, BORDER_MM + (rows + 2) * ROW
    room = np.array([page[0] - 2 * left, above - below]) - 2 * PAD
    scale, drawn = _scaled(plan, MILLIMETRES[unit], room)
    low, high = _corners(drawn)
    move = 0.5 * (np.array([page[0], above + below]) - low - high)
    lines, circles, numbers = shifted(ground_marks(drawn, LETTER), *move.tolist())
    bar, said = _bar(scale, unit, (left, words[-1].y - 2 * ROW), paper)
    words += [*said, *numbers, *table.texts(0, rows, (left, below - 1.5 * ROW))]
    wide, tall = page.tolist()
    pages = [Drawing(_titled(title), "mm", wide, tall, (*lines, *bar), circles, tuple(words))]
    most = int((page[1] - 2 * BORDER_MM) / ROW) - 1
    for first in range(rows * table.groups, len(plan.feet), most * table.groups):
        texts = tuple(table.texts(first, most, (left, top - 0.5 * ROW)))
        pages.append(Drawing(_titled(title), "mm", wide, tall, (), (), texts))
    return PrintedPlan(tuple(pages), scale)


def _titled(title: str) -> str:
    return f"{title}: plan of the ground"


def _header(
    title: str, plan: GroundPlan, unit: str, corner: tuple[float, float], wide: float
) -> Iterator[Text]:
    """What the plan is of and what its lines mean, from a corner downwards."""
    x, y = corner
    heading = _titled(title)
    yield Text("CUT", x, y - TITLE, min(TITLE, wide / (WIDE * len(heading))), heading, 0.0, "start")
    y -= TITLE + ROW
    _, *legend = ground_legend(plan, unit)
    lines = "; ".join(f"{name} ({how}) {size}".replace(" ()", "") for name, how, size in legend)
    for fact in (*ground_facts(plan, unit), lines):
        for line in wrap(fact, int(wide / (WIDE * LETTER))):
            y -= ROW
            yield Text("CUT", x, y, LETTER, line, 0.0, "start")


def _scaled(plan: GroundPlan, millimetres: float, room: Array) -> tuple[int, GroundPlan]:
    """The largest usual scale at which a plan fits a room (2,), and the plan in mm on paper."""
    low, high = _corners(plan)
    least = float(((high - low) * millimetres / room).max())
    scale = next(each * 1000**k for k in range(12) for each in SCALES if each * 1000**k >= least)
    factor = millimetres / scale
    swept = plan.swept
    return scale, replace(
        plan,
        hull=plan.hull * factor,
        swept=None if swept is None else replace(swept, hull=swept.hull * factor),
        walls=tuple(wall * factor for wall in plan.walls),
        feet=tuple(replace(each, x=each.x * factor, y=each.y * factor) for each in plan.feet),
    )


def _corners(plan: GroundPlan) -> tuple[Array, Array]:
    """Lower left and upper right corner (2,) of all that a plan has, its own corner included."""
    feet = np.array([(foot.x, foot.y) for foot in plan.feet])
    points = np.concatenate([*plan.drawn, feet, np.zeros((1, 2))])
    return points.min(axis=0), points.max(axis=0)


def _bar(
    scale: int, unit: str, place: tuple[float, float], paper: Paper
) -> tuple[list[Line], list[Text]]:
    """The scale in words, and a bar of a round length behind them."""
    (x, y), true = place, MILLIMETRES[unit] / scale
    length = round_length(BAR / true)
    words = f"SCALE 1:{scale} ON {paper}"
    start, end = x + WIDE * LETTER * (len(words) + GAP), 0.0
    end = start + length * true
    ticks = [np.array([[at, y - 1.5], [at, y + 1.5]]) for at in (start, end)]
    bar = [Line("CUT", points) for points in (np.array([[start, y], [end, y]]), *ticks)]
    said = Text("CUT", end + GAP, y, LETTER, f"{plain(length)} {unit}", 0.0, "start")
    return bar, [Text("CUT", x, y, LETTER, words, 0.0, "start"), said]


class _Table:
    """Feet with their coordinates, in as many columns side by side as a width has room for (mm)."""

    def __init__(self, plan: GroundPlan, unit: str, wide: float) -> None:
        heads = ("foot", f"x ({unit})", f"y ({unit})")
        self._lines = [
            heads,
            *((str(f.number), decimal(f.x, unit), decimal(f.y, unit)) for f in plan.feet),
        ]
        counts = [max(map(len, column)) + GAP for column in zip(*self._lines, strict=True)]
        self._ends = WIDE * LETTER * (np.cumsum(counts) - GAP)
        self._step = WIDE * LETTER * float(sum(counts) + GAP)
        self.groups = max(1, int((wide + 2 * GAP * WIDE * LETTER) / self._step))
        self.rows = ceil(len(plan.feet) / self.groups)

    def texts(self, first: int, rows: int, corner: tuple[float, float]) -> Iterator[Text]:
        """The feet from one on, in so many rows below headings that begin at a corner."""
        heads, *feet = self._lines
        for group in range(self.groups):
            start = first + group * rows
            column = feet[start : start + rows]
            for number, line in enumerate([heads, *column] if column else []):
                for end, words in zip(self._ends.tolist(), line, strict=True):
                    x, y = corner[0] + group * self._step + end, corner[1] - number * ROW
                    yield Text("CUT", x, y, LETTER, words, 0.0, "end")
