"""Warnings about a design before it is built, each with numbers and what to change.

All thresholds are here, each with its reason. A sentence says what is so, by how much, and what
to change; words of the mathematics do not occur in it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from orishell.conventions.errors import DesignError
from orishell.conventions.quantities import conversion, plain
from orishell.conventions.row import About, Note
from orishell.curves.plane import extent_across
from orishell.deployment.feet import Feet, find_feet
from orishell.design import Design
from orishell.locking import Lock
from orishell.motion import Mechanism, area_of, extents, find_assignment
from orishell.motion.as_made import sheet_sides
from orishell.motion.layout import has_flaps
from orishell.numerics.arrays import Array, Booleans
from orishell.shell.board_warnings import warn_of_boards
from orishell.workshop import Workshop

BELOW = 0.01
"""Flaps lower than the feet by this share of the height carry the shell: mortar evens out less."""
ABOVE = 0.1
"""Flaps this share of the height above the crown are seen as an edge that f does not have."""
BESIDE = 0.25
"""Flaps beyond a foot by this share of the span need more floor than f shows."""
UNEVEN = 0.005
"""Feet uneven by this share of the height, 15 mm of 3 m, need more than packing."""
WASTEFUL = 1.5
"""A sheet this many times as large as the surface: half as much again is paid for and carried."""
STRAIGHT = 1e-6
"""A g that leaves a line by less than this share of its length is straight."""
SMALLEST_SHELL, LARGEST_SHELL = 0.005, 500.0
"""A shell smaller than a fingernail, or larger than any roof, is in another unit (metres)."""
LONGEST_STOCK = 100.0
"""Rolls of paper and cloth are shorter than this (metres)."""
LARGEST_BOARD = (3.05, 1.525)
"""The largest plywood that is commonly sold, 10 by 5 feet (metres)."""
DEEP = 0.3
"""A corrugation this share of the height deep hides the curve: one sees the folds."""


def warn_of_building(
    design: Design, lock: Lock, feet: Feet | None, unit: str, workshop: Workshop
) -> list[str]:
    """Warnings for whoever builds the shell."""
    mechanism = design.mechanism
    shell = mechanism.positions(mechanism.target_drive)
    height = float(np.ptp(shell[:, mechanism.inner_columns, 2]))
    return [
        *_of_unit(design, shell, unit, workshop),
        *_of_flaps(design, shell, feet, unit),
        *_of_feet(design, feet, unit),
        *_of_size(design),
        *_of_unfolded_columns(design),
        *_of_boards(design, unit, workshop),
        *_of_depth(design, lock, height, unit),
        *warn_of_boards(design, lock, unit),
    ]


def _of_unit(design: Design, shell: Array, unit: str, workshop: Workshop) -> Iterator[str]:
    """Sizes that no shell, and no board, has: another unit may be meant."""
    metres = conversion(unit, "m")
    size = max(extents(shell))
    if not SMALLEST_SHELL <= size * metres <= LARGEST_SHELL:
        drawn = "; of a drawing, in [target.f] and [target.g]"
        yield Note(
            f"the shell is {plain(size, 3)} {unit} across: is {unit} the unit of its "
            f"{'curves' if design.targets else 'lengths'}? (unit in [shell]"
            f"{drawn if design.targets else ''})",
            "unit",
        )
    if workshop.stock is not None and max(workshop.stock) * metres > LONGEST_STOCK:
        stock = " x ".join(plain(side) for side in workshop.stock)
        yield Note(
            f"sheets of {stock} {unit} are larger than any that is sold: their sizes are in the "
            f"unit of the shell, {unit}",
            "stock",
        )


def _of_flaps(design: Design, shell: Array, feet: Feet | None, unit: str) -> Iterator[str]:
    """Flaps outside the envelope of f: below the feet, above the crown, beyond the span."""
    inner = range(*design.mechanism.inner_columns.indices(shell.shape[1]))
    if design.swept is None:
        return
    ends = [(0, inner[0])] * (inner[0] > 0) + [(-1, inner[-1])] * (inner[-1] + 1 < shell.shape[1])
    if not ends:
        return
    height = shell[:, inner, 2]
    size = float(np.ptp(height))
    flaps = shell[:, [flap for flap, _ in ends], 2]
    flapped = bool(design.mechanism.flap_columns)
    name = "flaps" if flapped else "strips beside the first and last column"
    remedy = "make them narrower"
    about: About | None = "reach" if flapped else None
    if flapped:
        remedy += ' or turn them to the other end of f (flap_side = "start" or "end")'
    below, above = float(height.min() - flaps.min()), float(flaps.max() - height.max())
    if below > BELOW * size:
        what = "the feet" if feet else "the lowest point"
        yield Note(
            f"the {name} reach {plain(below, 3)} {unit} below {what} of a shell {plain(size, 3)} "
            f"{unit} high, which would rest on them: {remedy}",
            about,
        )
    if above > ABOVE * size:
        yield Note(
            f"the {name} reach {plain(above, 3)} {unit} above the top of a shell {plain(size, 3)} "
            f"{unit} high: {remedy}",
            about,
        )
    beyond, span = max(_beyond(shell[:, near], shell[:, flap]) for flap, near in ends)
    if beyond > BESIDE * span:
        yield Note(
            f"the {name} reach {plain(beyond, 3)} {unit} beyond the foot of a shell that spans "
            f"{plain(span, 3)} {unit}: {remedy}",
            about,
        )


def _beyond(column: Array, flap: Array) -> tuple[float, float]:
    """How far in plan a flap (R, 3) reaches beyond the ends of its column (R, 3), and its span."""
    across = (column[-1] - column[0])[:2]
    span = float(np.hypot(*across))
    if not span:
        return 0.0, 0.0
    own, its = column[:, :2] @ across / span, flap[:, :2] @ across / span
    return float(max(its.max() - own.max(), own.min() - its.min())), span


def _of_feet(design: Design, feet: Feet | None, unit: str) -> Iterator[str]:
    if feet is None or feet.uneven <= UNEVEN * feet.height:
        return
    f = design.targets.get("f")
    gap = 0.0 if f is None else float(np.ptp(f[[0, -1], 2]))
    remedy = "trim the last panels at the ground, or build the ground up to them"
    about: About | None = None
    if gap > 0.5 * feet.uneven:
        remedy = f"f's ends differ by {plain(gap, 3)} {unit} in height: level them, or build a step"
    elif _level_on_corners(design):
        remedy = 'it can stand on its four corners, at one height (ground = "corners" in [pattern])'
        about = "uneven"
    elif design.levelled_by:
        remedy, about = f"{design.levelled_by} may level them; else {remedy}", "uneven"
    yield Note(
        f"the feet are not level, rows {feet.rows[0]} and {feet.rows[1]} differ by "
        f"{plain(feet.uneven, 3)} {unit} in height: {remedy}",
        about,
    )


def _level_on_corners(design: Design) -> bool:
    """Whether ground = "corners" gives a sheet without flaps level feet: it is tried."""
    if design.grounded is None or has_flaps(design.mechanism):
        return False
    try:
        feet = find_feet(replace(design, mechanism=design.grounded("corners")))
    except DesignError:
        return False
    return feet is not None and feet.level


def _of_size(design: Design) -> Iterator[str]:
    if design.swept is None:
        return
    ratio = area_of(design.mechanism) / design.swept.area()
    if ratio <= WASTEFUL:
        return
    less = design.smaller_by
    flaps = "narrower flaps" if has_flaps(design.mechanism) or less else ""
    remedies = " or ".join(each for each in (less, flaps) if each)
    yield Note(
        f"the sheet is {ratio:.2f} times as large as the surface that it covers"
        f"{f': {remedies} would make it smaller' if remedies else ''}",
        "sheet" if remedies else None,
    )


def _of_unfolded_columns(design: Design) -> Iterator[str]:
    unfolded = _unfolded(design.mechanism)
    g = design.targets.get("g")
    if g is None or not unfolded.any():
        return
    count = len(unfolded)
    if extent_across(g[:, :2]) <= STRAIGHT * np.ptp(g, axis=0).max():
        yield Note(
            f"{int(unfolded.sum())} of {count} columns stay unfolded because g is straight: 2 "
            "columns suffice, unless panels have to be shorter",
            "columns",
        )
        return
    # One by itself is where g bends from one side to the other.
    beside = np.zeros(count + 2, np.bool_)
    beside[1:-1] = unfolded
    idle = int((unfolded & (beside[:-2] | beside[2:])).sum())
    if idle:
        yield Note(
            f"{idle} of {count} columns stay unfolded because g is straight there: fewer columns "
            "suffice, unless panels have to be shorter",
            "idle columns",
        )


def _unfolded(mechanism: Mechanism) -> Booleans:
    """Which of columns 1 ... n stay unfolded (n,); never said of the first and the last."""
    creases = find_assignment(mechanism).column
    inner = range(*mechanism.inner_columns.indices(mechanism.grid.columns))
    unfolded = np.zeros(len(inner), np.bool_)
    unfolded[1:-1] = (creases[:, inner[1] - 1 : inner[-1] - 1] == 0).all(axis=0)
    return unfolded


def _of_boards(design: Design, unit: str, workshop: Workshop) -> Iterator[str]:
    """A sheet larger than any board, or than boards that cloth is no board of.

    Solid panels are cut one by one.
    """
    if design.panel is not None and design.panel.is_solid:
        return
    width, height, strips = sheet_sides(design.mechanism)
    metres = conversion(unit, "m")
    long, short = (metres * side for side in (max(width, height), min(width, height)))
    if design.panel is not None and workshop.stock is not None and workshop.roll is None:
        yield from _of_roll((width, height), workshop.stock, unit)
    if workshop.stock is not None or (long <= LARGEST_BOARD[0] and short <= LARGEST_BOARD[1]):
        return
    board = " x ".join(plain(side / metres) for side in LARGEST_BOARD)
    yield Note(
        f"{'a strip' if strips else 'the flat sheet'}, {plain(width, 3)} x {plain(height, 3)} "
        f"{unit}, is larger than any board "
        f"(the largest plywood commonly sold is {board} {unit}): say how large your boards are "
        "(stock in [workshop]), and the pattern is split into parts with joints",
        "board",
    )


def _of_roll(membrane: tuple[float, float], stock: tuple[float, float], unit: str) -> Iterator[str]:
    """A membrane that is split as if it were sold as boards are."""
    if max(membrane) <= max(stock) and min(membrane) <= min(stock):
        return
    wide, high = (plain(side, 3) for side in membrane)
    sheets = " x ".join(plain(side, 3) for side in stock)
    yield Note(
        f"the membrane, {wide} x {high} {unit}, is split for sheets of {sheets} {unit}, as boards "
        "are: say how wide and long the rolls are that it comes on (roll in [workshop])",
        "roll",
    )


def _of_depth(design: Design, lock: Lock, height: float, unit: str) -> Iterator[str]:
    depth = lock.corrugation_depth
    if design.swept is not None and depth > DEEP * height > 0:
        seen = "curve f" if design.targets else "surface"
        yield Note(
            f"the folds are {plain(100 * depth / height, 2)} % as deep as the shell is high "
            f"({plain(depth, 3)} of {plain(height, 3)} {unit}): "
            f"one sees them rather than the {seen}; more rows make them shallower",
            "depth",
        )
