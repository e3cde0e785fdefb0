"""Files that are dropped onto the page, and target curves as it draws them."""

from __future__ import annotations

import base64
import contextlib
import re
from collections.abc import Collection, Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import plain
from orishell.curves import (
    Chain,
    Curve,
    curve_data,
    parse_curve,
    read_dxf,
    read_points,
    read_svg,
    trace_curve,
)
from orishell.curves.pieces import Bezier
from orishell.design_file.target import MOST_POINTS
from orishell.io.output import scratch
from orishell.io.view import Drawn
from orishell.numerics.arrays import Array
from orishell.numerics.equals import largest_of
from orishell.studio.api import DroppedCurve
from orishell.studio.few_points import few_points


@contextmanager
def dropped_file(name: str, content: str, endings: Collection[str], what: str) -> Iterator[Path]:
    """Hold a file by its content, which is in base64; errors name it as the page does.

    Raises InputError if it has none of the endings of ``what``, or no such content.
    """
    ending = Path(name).suffix.lower()
    if ending not in endings:
        expected = ", ".join(endings)
        raise InputError(f"this is not a file of {what}", where=name, got=ending, expected=expected)
    try:
        data = base64.b64decode(content, validate=True)
    except ValueError:
        raise InputError("the content is not base64", where=name) from None
    with scratch() as directory:
        path = directory / f"dropped{ending}"
        path.write_bytes(data)
        try:
            yield path
        except InputError as error:
            for field, text in vars(error).items():
                if isinstance(text, str):
                    setattr(error, field, text.replace(str(path), name))
            raise


DRAWN = 200
"""Points of a curve that are drawn, about."""


def sampled(curve: Curve, name: str) -> Drawn:
    """Points of a curve to be drawn; empty if it cannot be used. Its name is f or g."""
    try:
        trace = trace_curve(curve, name)
    except InputError:
        return []
    kept = np.unique(np.rint(np.linspace(0, len(trace.points) - 1, DRAWN)).astype(int))
    corners = np.flatnonzero(np.abs(trace.heading - trace.arriving) > 0)
    # The page says how wide and how high the curve is.
    extremes = [*trace.points.argmin(axis=0), *trace.points.argmax(axis=0)]
    points = trace.points[np.unique([*kept, *corners[:DRAWN], *extremes])]
    return [(float(x), float(y)) for x, y in points]


IDS = re.compile(r"""\bid\s*=\s*["']([^"']+)["']""")
LAYERS = re.compile(r"^[ ]*8\r?\n(.+?)\r?$", re.MULTILINE)
MOST_LINES = 40
"""Straight lines of a drawing that are kept as they are."""
PARTS = 20
"""Paths or layers of a drawing that are tried, if it is no single curve."""


def read_dropped(name: str, content: str, unit: str) -> DroppedCurve:
    """The table of a target curve, and a note on how its file was read.

    What is drawn stays what it is: lines, arcs and Bezier curves of a path, wherever SVG has such.
    Points that were measured close to each other become a spline through few. The content is in
    base64. Raises InputError if it holds no curve.
    """
    with dropped_file(name, content, (".csv", ".txt", ".svg", ".dxf"), "a curve") as path:
        if path.suffix in {".csv", ".txt"}:
            return _read_points(path, name, unit)
        return _read_drawing(path, path.suffix, name, unit)


def _read_points(path: Path, name: str, unit: str) -> DroppedCurve:
    points = read_points(path, into=unit)
    few = _few(points, name, unit)
    if few is not None:
        return few
    if len(points) > MOST_POINTS:
        raise InputError(
            "no spline of few points follows these",
            where=name,
            got=f"{len(points)} points",
            expected=f"at most {MOST_POINTS}",
        )
    note = f"a spline through the {len(points)} points of {name}"
    return {"table": {"points": points.tolist(), "smooth": True}, "note": note}


def _few(points: Array, name: str, unit: str) -> DroppedCurve | None:
    """A curve of few points along many; None where no such follows them."""
    few, smooth, farthest = few_points(points)
    if len(few) == len(points):
        return None
    kind = "a spline through" if smooth else "straight lines between"
    note = (
        f"{kind} {len(few)} points along the {len(points)} of {name}; none of these "
        f"is farther from it than {plain(farthest, 2)} {unit}"
    )
    return {"table": {"points": few.tolist(), "smooth": smooth}, "note": note}


def _read_drawing(path: Path, ending: str, name: str, unit: str) -> DroppedCurve:
    chain, part = _longest_curve(path, ending, unit)
    straight = all(isinstance(each, Bezier) and len(each.control) == 2 for each in chain.pieces)
    if straight and len(chain.pieces) > MOST_LINES:
        # So many lines are a curve that was measured, or written by another program.
        few = _few(chain.joints, part + name, unit)
        if few is not None:
            return {**few, "note": "; ".join((few["note"], *chain.notes))}
    data, farthest = curve_data(chain)
    curve = parse_curve(data)
    trace_curve(curve.curve(), "the drawing")
    many = len(curve.pieces)
    note = f"{many} piece{'s' * (many > 1)} of a path along {part}{name}, "
    note += f"about {plain(farthest, 2)} {unit} beside it at most" if farthest else "exactly"
    return {"table": {"path": data}, "note": "; ".join((note, *chain.notes))}


def _longest_curve(path: Path, ending: str, unit: str) -> tuple[Chain, str]:
    """The longest curve of a drawing, and the name of the path or layer that it is from.

    Loose ends are joined where that makes one curve of all: how far they were apart is said, and
    the page shows what became of them. Raises InputError if neither the drawing nor one of its
    parts is a curve.
    """
    drawn = path.read_text("utf-8", "replace")
    kind, names = ("path", IDS) if ending == ".svg" else ("layer", LAYERS)

    def read(part: str | None = None, join: float | None = None) -> Chain:
        if ending == ".svg":
            return read_svg(path, into=unit, id=part, join=join)
        return read_dxf(path, into=unit, layer=part, join=join)

    try:
        return read(), ""
    except InputError as error:
        join = error.changes.get("join")
        if isinstance(join, float):
            return read(join=join), ""
        parts: dict[str, Chain] = {}
        for part in list(dict.fromkeys(names.findall(drawn)))[:PARTS]:
            with contextlib.suppress(InputError):
                parts[part] = read(part)
        if not parts:
            raise error from None
    lengths = {part: trace_curve(chain.curve()).length for part, chain in parts.items()}
    longest = largest_of(lengths, lambda part: lengths[part])
    return parts[longest], f"the longest {kind}, {longest}, of "
