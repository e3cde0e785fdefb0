"""The shapes of SVG as pieces, in the user units of their element."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

import numpy as np

from orishell.conventions.errors import InputError
from orishell.curves.pieces import MAX_PIECES, SIMPLIFY, Arc, Piece, polyline
from orishell.curves.svg.path_data import parse_path
from orishell.curves.svg.tree import Element, View, parse_length, parse_numbers


def draw_shape(element: Element, view: View) -> list[Piece]:
    """The pieces of a shape; none for an element that is no shape."""
    drawing = SHAPES.get(element.tag)
    return [] if drawing is None else drawing(element, view)


def length_of(element: Element, name: str, view: View, axis: str = "", default: str = "0") -> float:
    """An attribute that is a length, in user units."""
    try:
        return parse_length(element.attributes.get(name) or default, view.along(axis))
    except InputError as error:
        raise error.located(name) from None


def line_ends(element: Element, view: View) -> list[list[float]]:
    """Both ends of a line, in user units.

    Raises InputError: If a coordinate is no length.
    """
    return [[length_of(element, f"{axis}{k}", view, axis) for axis in "xy"] for k in (1, 2)]


def _points(element: Element, *, closed: bool) -> list[Piece]:
    try:
        numbers = parse_numbers(element.attributes.get("points", ""))
    except InputError as error:
        raise error.located("points") from None
    if len(numbers) % 2:
        raise InputError("a point has no y", where="points", got=f"{len(numbers)} numbers")
    if len(numbers) > 2 * MAX_PIECES:
        raise InputError(
            "the polyline has too many points", expected=f"at most {MAX_PIECES}", remedy=SIMPLIFY
        )
    points = np.reshape(numbers, (-1, 2))
    if closed:
        points = np.concatenate([points, points[:1]])
    return polyline(points)


def _rectangle(element: Element, view: View) -> list[Piece]:
    x, y = (length_of(element, axis, view, axis) for axis in "xy")
    width = length_of(element, "width", view, "x")
    height = length_of(element, "height", view, "y")
    if not (width > 0 and height > 0):
        return []
    given = {name: element.attributes.get(name, "auto").strip() for name in ("rx", "ry")}
    radius = {
        name: None if text in {"", "auto"} else length_of(element, name, view, name[1])
        for name, text in given.items()
    }
    rx = radius["rx"] if radius["rx"] is not None else radius["ry"] or 0.0
    ry = radius["ry"] if radius["ry"] is not None else rx
    rx, ry = min(max(rx, 0.0), width / 2), min(max(ry, 0.0), height / 2)
    if rx == 0 or ry == 0:
        around = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]])
        return polyline(np.array([x, y]) + around * (width, height))
    pieces: list[Piece] = []
    for turn in range(4):  # a side and the quarter of an ellipse after it, clockwise as SVG draws
        out = np.array([[0, -1], [1, 0], [0, 1], [-1, 0]][turn])
        on = np.array([[1, 0], [0, 1], [-1, 0], [0, -1]][turn])
        radii, half = np.array([rx, ry]), np.array([width, height]) / 2
        middle = np.array([x, y]) + half
        side = [middle + out * half + sign * on * (half - radii) for sign in (-1, 1)]
        pieces += polyline(side)
        pieces.append(Arc(side[1] - out * radii, np.array([out, on]) * radii, 0.0, np.pi / 2))
    return pieces


def _ellipse(element: Element, view: View) -> list[Piece]:
    centre = np.array([length_of(element, f"c{axis}", view, axis) for axis in "xy"])
    if element.tag == "circle":
        rx = ry = length_of(element, "r", view)
    else:
        rx, ry = (length_of(element, f"r{axis}", view, axis) for axis in "xy")
    if not (rx > 0 and ry > 0):
        return []
    return [Arc(centre, np.diag([rx, ry]), 0.0, 2 * np.pi)]


SHAPES: Final[dict[str, Callable[[Element, View], list[Piece]]]] = {
    "path": lambda element, _: parse_path(element.attributes.get("d", "")),
    "line": lambda element, view: polyline(line_ends(element, view)),
    "polyline": lambda element, _: _points(element, closed=False),
    "polygon": lambda element, _: _points(element, closed=True),
    "rect": _rectangle,
    "circle": _ellipse,
    "ellipse": _ellipse,
}
