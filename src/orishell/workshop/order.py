"""What to order: one table of sheets, rolls, bars and coils, what of them is used, and its mass."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import prod

import numpy as np

from orishell.conventions.quantities import MILLIMETRES, conversion, size
from orishell.design.holes import Holes
from orishell.document import Document
from orishell.motion.quads import signed_areas
from orishell.numerics.arrays import Array
from orishell.workshop.assembly import laid_flat
from orishell.workshop.bars import CutBars, cut_bars
from orishell.workshop.board_masses import mass_of_boards
from orishell.workshop.board_sheets import nest_boards, sheets_of_stocks
from orishell.workshop.board_stock import BoardStock, stocks_of_boards
from orishell.workshop.boards import cut_of_sheet, has_membrane, has_sheet
from orishell.workshop.hinge_parts import fittings_of
from orishell.workshop.layout import Layout, lay_out, on_its_roll
from orishell.workshop.nesting import fewest_sheets
from orishell.workshop.order_row import OrderRow
from orishell.workshop.schedule import BY_LENGTH, WEIGHED, Schedule, find_schedule
from orishell.workshop.settings import Workshop


def find_order(
    document: Document, workshop: Workshop, *, nested: bool = True
) -> tuple[OrderRow, ...]:
    """What to order for a document.

    Masses are of parts: of boards as they are cut, of panels or the membrane without tabs and
    strips. What is cut from sheets and rolls is laid out on them only if ``nested``.

    Raises
    ------
    InputError
        If a tie is longer than a coil, or a hinge than twenty bars; or a kind of hinge does not go
        with the construction.
    """
    return tuple(_rows(document, workshop, nested))


def _rows(document: Document, workshop: Workshop, nested: bool) -> Iterator[OrderRow]:
    everything = laid_flat(document)
    if has_membrane(everything) or not has_sheet(everything):
        stocks, on_stock = stocks_of_boards(document), nested and workshop.stock is not None
        sheets: Sequence[range | None] = [None] * len(stocks)
        if on_stock:
            sheets = sheets_of_stocks(document, nest_boards(document, workshop))
        for stock, own in zip(stocks, sheets, strict=True):
            yield _boards(document, workshop, stock, None if own is None else len(own))
    if has_sheet(everything):
        laid = nested and on_its_roll(document, workshop).stock is not None
        of_sheet = laid_flat(cut_of_sheet(document))
        yield _sheet(of_sheet, workshop, lay_out(document, workshop) if laid else None)
    if fittings_of(everything) is not None:
        yield from _arms(everything)
    schedule = find_schedule(document, workshop)
    for kind in BY_LENGTH:
        if (schedule.kinds == kind).any():
            yield _hinges(everything, workshop, schedule, kind)
    if document.ties:
        yield _ties(document, workshop)
    if everything.holes is not None:
        yield _brackets(everything.unit, everything.holes)


def _boards(
    document: Document, workshop: Workshop, stock: BoardStock, sheets: int | None
) -> OrderRow:
    boards = laid_flat(document).boards
    assert boards is not None
    boards = boards.chosen(stock.boards)
    boards = boards.chosen(~boards.arms)
    row = _flat_row(
        document.unit,
        f"{stock.kind} boards".strip(),
        ("sheet", stock.thickness),
        sides=workshop.stock if sheets is not None else None,
        count=sheets,
        areas=boards.areas(),
        usable=None if sheets is None else workshop.usable_stock,
        mass=mass_of_boards(document, stock.boards) or 0.0,
        price=0.0 if stock.kind else workshop.stock_price,  # which is that of the sheet's boards
    )
    return replace(row, what=row.what + stock.of)


def _sheet(document: Document, workshop: Workshop, layout: Layout | None) -> OrderRow:
    """The membrane, or the sheet if panels have no thickness; its parts where they are laid."""
    build, area = document.panel, float(document.areas().sum())
    laid = on_its_roll(document, workshop)
    areas = document.areas()
    if layout is not None:
        areas = np.array([sum(map(signed_areas, part.outlines)) for part in layout.parts])
    thick, weight = 0.0, _metres(document.unit) ** 2 * workshop.areal_density
    if build is not None:
        thick = build.membrane
        weight = _cubic(document.unit) * build.membrane * build.membrane_density
    return _flat_row(
        document.unit,
        "sheet" if build is None else "membrane",
        ("roll" if laid is not workshop else "sheet", thick),
        sides=None if layout is None else laid.stock,
        count=None if layout is None else layout.sheets,
        areas=areas,
        usable=None if layout is None else laid.usable_stock,
        mass=weight * area,
        price=workshop.roll_price if laid is not workshop else workshop.stock_price,
    )


def _brackets(unit: str, holes: Holes) -> OrderRow:
    """Brackets, one for each hole, and the edges along which they hold a part."""
    hole = size(float(holes.diameters.max()), unit)
    return OrderRow(
        item="brackets",
        what=f"{len(holes)} brackets, {2 * len(holes)} bolts for holes of {hole}",
        count=None,
        least=None,
        size=(),
        unit=unit,
        used=float(holes.lengths.sum()),
        waste=None,
        mass_kg=None,
        price=None,
    )


def _flat_row(
    unit: str,
    item: str,
    sold: tuple[str, float],
    *,
    sides: tuple[float, float] | None,
    count: int | None,
    areas: Array,
    usable: tuple[float, float] | None,
    mass: float,
    price: float,
) -> OrderRow:
    """A row of what is cut from sheets or rolls, sold as something of a thickness."""
    (name, thick), used = sold, float(areas.sum())
    words = f"{name}{'' if count == 1 else 's'}"
    return OrderRow(
        item=item,
        what=f"{words} {size(thick, unit)} thick" if thick else words,
        count=count,
        least=None if count is None or not usable else fewest_sheets(areas, prod(usable)),
        size=sides or (),
        unit=f"{unit}2",
        used=used,
        waste=None if not count or not sides else 1 - used / (count * prod(sides)),
        mass_kg=mass or None,
        price=price * count if count is not None and price else None,
    )


def _arms(document: Document) -> Iterator[OrderRow]:
    fittings, build = fittings_of(document), document.panel
    if fittings is None or build is None or not fittings.arms:
        return
    count, kinds = sum(arm.count for arm in fittings.arms), len(fittings.arms)
    yield OrderRow(
        item="arms",
        what=f"{count} arms of {kinds} {'kind' if kinds == 1 else 'kinds'}, of sheet "
        f"{size(build.fin, document.unit)} thick",
        count=None,
        least=None,
        size=(),
        unit=f"{document.unit}2",
        used=sum(arm.count * arm.area for arm in fittings.arms),
        waste=None,
        mass_kg=_cubic(document.unit) * fittings.arm_mass(build) or None,
        price=None,
    )


def _hinges(document: Document, workshop: Workshop, schedule: Schedule, kind: str) -> OrderRow:
    lengths = schedule.hinge_lengths[schedule.kinds == kind]
    bars = cut_hinges(lengths, kind, workshop)
    density = hinge_density(document, workshop) if kind in WEIGHED else 0.0
    mass = _metres(document.unit) * float(lengths.sum()) * density
    name = "length" if kind == "tape" else "bar"
    cut = _long_row(document.unit, _CALLED.get(kind, kind), name, lengths, bars)
    return replace(cut, mass_kg=mass or None, price=_priced(bars, workshop.hinge_price))


def hinge_density(document: Document, workshop: Workshop) -> float:
    """Mass of hinges per length (kg/m), as [panel.hinge] has that of whole boards; 0 if unknown."""
    panel = document.panel
    if panel is not None and panel.construction == "hinged":
        return panel.hinge.linear_density
    return workshop.hinge_linear_density


_CALLED = {"hinge": "hinges", "piano hinge": "piano hinges"}


def _ties(document: Document, workshop: Workshop) -> OrderRow:
    lengths = tie_lengths(document, workshop)
    coils = cut_ties(lengths, workshop)
    cut = _long_row(document.unit, "ties", "coil", lengths, coils)
    mass = _metres(document.unit) * float(lengths.sum()) * workshop.tie_linear_density
    return replace(cut, mass_kg=mass or None, price=_priced(coils, workshop.tie_price))


def _priced(bars: CutBars | None, price: float) -> float | None:
    return None if bars is None or not price else price * bars.count


def _long_row(
    unit: str,
    item: str,
    name: str,
    lengths: Array,
    bars: CutBars | None,
) -> OrderRow:
    used, count = float(lengths.sum()), None if bars is None else bars.count
    pieces = f"{len(lengths)} {'piece' if len(lengths) == 1 else 'pieces'}"
    return OrderRow(
        item=item,
        what=pieces if bars is None else f"{name}{'' if count == 1 else 's'}",
        count=count,
        least=None if bars is None else bars.least,
        size=() if bars is None else (float(bars.bar),),
        unit=unit,
        used=used,
        waste=None if bars is None else 1 - used / (bars.count * bars.bar),
        mass_kg=None,
        price=None,
    )


END_TO_END = 20
"""Bars that a hinge may be made of; more of them are a mistake."""


def cut_hinges(lengths: Array, kind: str, workshop: Workshop) -> CutBars | None:
    """The bars that hinges of lengths (H,) are cut from; None where nobody says, and of tape."""
    if workshop.hinge_stock is None or kind == "tape":
        return None
    key = "workshop.hinge_stock"
    return cut_bars(
        lengths, workshop.hinge_stock, workshop.spacing, key, "a hinge", most=END_TO_END
    )


def cut_ties(lengths: Array, workshop: Workshop) -> CutBars | None:
    """The coils that ties of lengths (T,) are cut from; None where nobody says."""
    if workshop.tie_stock is None:
        return None
    return cut_bars(lengths, workshop.tie_stock, 0.0, "workshop.tie_stock", "a tie")


def tie_lengths(document: Document, workshop: Workshop) -> Array:
    """Lengths (T,) to which ties are cut: from end to end, and what either end has beyond."""
    lengths = np.array([tie.length for tie in document.ties], dtype=np.float64)
    return lengths + 2 * workshop.tie_end


def _metres(unit: str) -> float:
    """How long the unit is (m); 0 if that is not known, and so no mass is."""
    return conversion(unit, "m") if unit in MILLIMETRES else 0.0


def _cubic(unit: str) -> float:
    return _metres(unit) ** 3
