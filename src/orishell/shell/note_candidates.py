"""Changes of a design that may do what a note of its report says, by what that is about."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any

from orishell.conventions.errors import Remedy
from orishell.conventions.formatting import rounded
from orishell.conventions.quantities import MILLIMETRES, conversion, plain, size
from orishell.conventions.row import About
from orishell.design_file.tables import value_at
from orishell.shell.cutting import UP
from orishell.shell.designed import on_membrane
from orishell.shell.noted import Noted
from orishell.structure.refine import LADDER

BOARDS = ((2.5, 1.25), (3.05, 1.525))
"""Sizes in which plywood is commonly sold (metres), the usual one first."""
ROLLS = ((1.5, 50.0), (1.6, 50.0), (2.0, 50.0), (3.0, 50.0))
"""Sizes in which fabric is commonly sold (metres), the usual one first."""
MORE_ROWS = (1.25, 1.5, 2.0, 3.0)
"""Rows are tried by so many times as many as there are, where folds are deep."""
LESS = (0.75, 0.5, 0.25)
"""Flaps are made narrower, and boards thinner, to these shares of what they are."""
WIDER = (0.5, 0.8, 0.95)
"""The angle xi is tried at these shares of the way to the widest."""
DEEPER = (1.5, 2.0, 3.0, 4.0)
"""Depths of folds that are tried where feet are not level, as shares of what they are."""
FINER = 3
"""So many finer meshes are tried."""
HEAVIER = (1.05, 1.5, 2.0)
"""Ballast that is tried, in terms of what a foot needs that nothing else holds."""


def _two_columns(_: Noted) -> Iterator[Remedy]:
    yield Remedy({"pattern.columns": 2}, "2 columns")


def _fewer_columns(noted: Noted) -> Iterator[Remedy]:
    columns = noted.file.pattern.columns
    for fewer in range(columns - 1, max(2, columns // 2) - 1, -1):
        yield Remedy({"pattern.columns": fewer}, f"{fewer} columns")


def _more_rows(noted: Noted) -> Iterator[Remedy]:
    rows = noted.file.pattern.rows
    for more in MORE_ROWS:
        odd = 2 * (int(more * rows) // 2) + rows % 2  # some families have odd numbers only
        if odd > rows:
            yield Remedy({"pattern.rows": odd}, f"{odd} rows")


def _boards(noted: Noted) -> Iterator[Remedy]:
    unit = noted.file.unit
    for board in BOARDS:
        sides = [rounded(side / conversion(unit, "m"), 6) for side in board]
        words = " x ".join(plain(side) for side in sides)
        yield Remedy({"workshop.stock": sides}, f"boards of {words} {unit}")


def _rolls(noted: Noted) -> Iterator[Remedy]:
    unit = noted.file.unit
    for roll in ROLLS:
        sides = [rounded(side / conversion(unit, "m"), 6) for side in roll]
        words = " x ".join(plain(side) for side in sides)
        yield Remedy({"workshop.roll": sides}, f"rolls of {words} {unit} for the membrane")


def _other_unit(noted: Noted) -> Iterator[Remedy]:
    for unit in MILLIMETRES:
        if unit != noted.file.unit:
            yield Remedy({"shell.unit": unit}, f"lengths in {unit}")


def _stock_in_other_units(noted: Noted) -> Iterator[Remedy]:
    unit, stock = noted.file.unit, noted.file.workshop.stock
    for meant in MILLIMETRES if stock is not None else ():
        factor = conversion(meant, unit)
        if factor < 1 and stock is not None:
            sides = [rounded(factor * side, 6) for side in stock]
            words = " x ".join(plain(side) for side in sides)
            yield Remedy({"workshop.stock": sides}, f"sheets of {words} {unit}")


def _other_side(_: Noted) -> Iterator[Remedy]:
    for end in ("start", "end"):
        yield Remedy({"pattern.flap_side": end}, f"flaps at the {end} of f")


def _narrower_flaps(noted: Noted) -> Iterator[Remedy]:
    width = noted.report.parameters.get("flap")
    if not isinstance(width, float) or not width:
        return
    for share in LESS:
        narrower = rounded(share * width, 2)
        yield Remedy({"pattern.flap": narrower}, f"flaps of {size(narrower, noted.file.unit)}")


def _smaller_sheet(noted: Noted) -> Iterator[Remedy]:
    parameters, unit = noted.report.parameters, noted.file.unit
    xi, widest = parameters.get("xi_deg"), parameters.get("xi_limit_deg")
    if isinstance(xi, float) and isinstance(widest, float):
        for share in WIDER:
            wider = rounded(xi + share * (widest - xi), 3)
            yield Remedy({"pattern.xi_deg": wider}, f"creases at {wider:g} degrees")
    yield from _of_depth(parameters.get("depth"), LESS, unit)
    yield from _narrower_flaps(noted)


def _of_depth(depth: object, shares: Iterable[float], unit: str) -> Iterator[Remedy]:
    if isinstance(depth, float):
        for share in shares:
            other = rounded(share * depth, 2)
            yield Remedy({"pattern.depth": other}, f"folds {size(other, unit)} deep")


def _level_feet(noted: Noted) -> Iterator[Remedy]:
    parameters, rows = noted.report.parameters, noted.file.pattern.rows
    yield from _on_corners(noted)
    yield from _of_depth(parameters.get("depth"), DEEPER, noted.file.unit)
    for more in (2, -2, -4):
        if rows + more > 2:
            yield Remedy({"pattern.rows": rows + more}, f"{rows + more} rows")
    yield from _narrower_flaps(noted)


def _pieces(noted: Noted, by: Sequence[int]) -> Iterator[Remedy]:
    panel = noted.file.panel
    if panel is not None and isinstance(panel.pieces, int):
        for more in by:
            rows = panel.pieces + more
            if rows > 1:
                yield Remedy({"panel.pieces": rows}, f"pieces of {rows} rows")


def _longer_pieces(noted: Noted) -> Iterator[Remedy]:
    yield from _pieces(noted, (1, 2, 4))
    yield Remedy({"panel.pieces": "whole"}, "one piece")


def _shorter_pieces(noted: Noted) -> Iterator[Remedy]:
    yield from _pieces(noted, (-1, -2))
    yield from _thinner(noted)


def _fewer_rows(noted: Noted) -> Iterator[Remedy]:
    rows = noted.file.pattern.rows
    for fewer in (2, 4, 6):
        if rows - fewer > 2:
            yield Remedy({"pattern.rows": rows - fewer}, f"{rows - fewer} rows")
    yield from _thinner(noted)


def _elsewhere_or_narrower(noted: Noted) -> Iterator[Remedy]:
    yield from _other_side(noted)
    yield from _narrower_flaps(noted)


def _thinner(noted: Noted) -> Iterator[Remedy]:
    thickness = 0.0 if noted.file.panel is None else noted.file.panel.thickness
    for share in LESS if thickness else ():
        thinner = rounded(share * thickness, 2)
        words = f"boards of {size(thinner, noted.file.unit)}"
        yield Remedy({"panel.thickness": thinner}, words)


def _feet_tied_only(_: Noted) -> Iterator[Remedy]:
    yield Remedy({"deployment.ties": "feet"}, "ties between feet only")


def _flaps(_: Noted) -> Iterator[Remedy]:
    yield Remedy({"pattern.flap": "auto"}, "flaps as wide as they may be")


def _on_corners(_: Noted) -> Iterator[Remedy]:
    yield Remedy({"pattern.ground": "corners"}, "let it stand on its four corners")


def _tied_feet(_: Noted) -> Iterator[Remedy]:
    yield Remedy({"deployment.ties": "feet"}, "tie its feet together")


def _square_boards(noted: Noted) -> Iterator[Remedy]:
    panel = noted.file.panel
    if panel is not None:
        yield Remedy(on_membrane(panel).changes, "boards on a membrane, cut square")


def _wider_gap(noted: Noted) -> Iterator[Remedy]:
    cutting, unit = noted.report.cutting, noted.file.unit
    if cutting is not None:
        gap = rounded(UP * cutting.play.largest, 3)
        yield Remedy({"panel.gap": gap}, f"gaps of {size(gap, unit)} between boards")


def _held_edges(noted: Noted) -> Iterator[Remedy]:
    held: Any = [
        each if each["kind"] == "friction" or each.get("patch") else {**each, "edges": True}
        for each in noted.supports
    ]
    yield Remedy({"structure.supports": held}, "hold supports along their edges")


def _edges_for_patches(noted: Noted) -> Iterator[Remedy]:
    held: Any = [
        {**{key: value for key, value in each.items() if key != "patch"}, "edges": True}
        if each.get("patch")
        else each
        for each in noted.supports
    ]
    yield Remedy({"structure.supports": held}, "hold supports along their edges")


def _ballast(noted: Noted) -> Iterator[Remedy]:
    analysis = noted.report.structure
    anchors = () if analysis is None else analysis.anchors
    needed = max((each.ballast_mass for each in anchors if not each.given), default=0.0)
    for more in HEAVIER if needed else ():
        mass = rounded(more * needed, 2)
        under: Any = [
            each if each["kind"] == "friction" else {**each, "ballast": mass}
            for each in noted.supports
        ]
        yield Remedy({"structure.supports": under}, f"ballast of {mass:g} kg at every foot")


def _own_weight(noted: Noted) -> Iterator[Remedy]:
    cases = value_at(noted.file.tables, "load_case")
    without = [number for number, case in enumerate(cases) if not case.get("self_weight")]
    yield Remedy(
        {f"load_case.{number}.self_weight": True for number in without},
        "own weight in every load case",
    )


def _finer_cells(noted: Noted) -> Iterator[Remedy]:
    asked = noted.file.structure
    finer = [each for each in LADDER if asked is not None and each > asked.cells]
    for each in finer[:FINER]:
        yield Remedy({"structure.cells": each}, f"{each} x {each} cells to a panel")


def _large_displacements(_: Noted) -> Iterator[Remedy]:
    yield Remedy({"structure.nonlinear": True}, "follow large displacements")


CANDIDATES: Mapping[About, Callable[[Noted], Iterator[Remedy]]] = {
    "columns": _two_columns,
    "idle columns": _fewer_columns,
    "depth": _more_rows,
    "board": _boards,
    "roll": _rolls,
    "unit": _other_unit,
    "stock": _stock_in_other_units,
    "reach": _elsewhere_or_narrower,
    "sheet": _smaller_sheet,
    "taut": _feet_tied_only,
    "off": _thinner,
    "no flaps": _flaps,
    "closes": _flaps,
    "uneven": _level_feet,
    "opens": _tied_feet,
    "chamfers": _square_boards,
    "play": _wider_gap,
    "open joints": _longer_pieces,
    "cut joints": _shorter_pieces,
    "arms": _fewer_rows,
    "points": _held_edges,
    "patch": _edges_for_patches,
    "pulled": _ballast,
    "weight": _own_weight,
    "cells": _finer_cells,
    "linear": _large_displacements,
}
"""What may do what a note says, by what it is about, the nearest first."""
