"""Curves in files that are dropped onto the page: points that the page can show and drag."""

from __future__ import annotations

import base64
import contextlib
import re
import tempfile
from pathlib import Path

import numpy as np

from orishell.curves import Curve, read_dxf, read_points, read_svg, trace_curve
from orishell.errors import InputError
from orishell.numerics.arrays import Array
from orishell.studio.api import DroppedCurve

CONTROLS = 41
"""Points of a spline through a smooth drawing."""
MOST = 400
"""Points of a polyline along a drawing with corners."""
IDS = re.compile(r"""\bid\s*=\s*["']([^"']+)["']""")
LAYERS = re.compile(r"^[ ]*8\r?\n(.+?)\r?$", re.MULTILINE)
PARTS = 20
"""Paths or layers of a drawing that are tried, if it is no single curve."""
CORNER = 1e-3
"""A turn of the tangent at one point that counts as a corner (radians)."""


def read_dropped(name: str, content: str, unit: str) -> DroppedCurve:
    """Points, whether a spline goes through them, and a note on what was made of the file.

    Parameters
    ----------
    name
        The file's name; its ending says what it is.
    content
        Its bytes in base64.
    unit
        Unit of length of the points.

    Raises
    ------
    InputError
        If it holds no curve.
    """
    try:
        data = base64.b64decode(content, validate=True)
    except ValueError:
        raise InputError("the content is not base64", where=name) from None
    ending = Path(name).suffix.lower()
    if ending not in {".csv", ".txt", ".svg", ".dxf"}:
        raise InputError(
            "this is not a file of a curve", where=name, got=ending, expected=".csv, .svg or .dxf"
        )
    with tempfile.TemporaryDirectory(prefix="orishell-") as directory:
        path = Path(directory) / f"curve{ending}"
        path.write_bytes(data)
        try:
            if ending in {".csv", ".txt"}:
                points, smooth = read_points(path, into=unit), True
                note = f"a spline through the {len(points)} points of {name}"
            else:
                curve, part = _read_drawing(path, ending, unit)
                points, smooth = points_along(curve)
                kind = "a spline through" if smooth else "the polyline of"
                note = f"{kind} {len(points)} points along {part}{name}"
        except InputError as error:
            for field, text in vars(error).items():
                if isinstance(text, str):
                    setattr(error, field, text.replace(str(path), name))
            raise
    return {"points": points.tolist(), "smooth": smooth, "note": note}


def _read_drawing(path: Path, ending: str, unit: str) -> tuple[Curve, str]:
    """The longest curve of a drawing, and the name of the path or layer that it is from.

    Raises
    ------
    InputError
        If neither the drawing nor one of its parts is a curve.
    """
    drawn = path.read_text("utf-8", "replace")
    kind, names = ("path", IDS) if ending == ".svg" else ("layer", LAYERS)

    def read(part: str | None = None) -> Curve:
        if ending == ".svg":
            return read_svg(path, into=unit, id=part).curve()
        return read_dxf(path, into=unit, layer=part).curve()

    try:
        return read(), ""
    except InputError as error:
        parts: dict[str, Curve] = {}
        for part in list(dict.fromkeys(names.findall(drawn)))[:PARTS]:
            with contextlib.suppress(InputError):
                parts[part] = read(part)
        if not parts:
            raise error from None
    lengths = {part: trace_curve(curve).length for part, curve in parts.items()}
    longest = max(lengths, key=lambda part: lengths[part])
    return parts[longest], f"the longest {kind}, {longest}, of "


def points_along(curve: Curve) -> tuple[Array, bool]:
    """Points (k, 2) along a drawing, and whether a spline through them follows it.

    Parameters
    ----------
    curve
        The drawing.
    """
    trace = trace_curve(curve, "the drawing")
    corners = np.flatnonzero(np.abs(trace.heading - trace.arriving)[1:-1] > CORNER) + 1
    if not len(corners):
        arc = np.linspace(0.0, trace.arc[-1], CONTROLS)
        points = curve.position(trace.parameter_at(arc))
        points[[0, -1]] = trace.points[[0, -1]]
        return points, True
    # Samples sit where the curve turns: on straight parts none but the corners are needed.
    kept = np.flatnonzero(np.abs(trace.arriving[1:] - trace.heading[:-1]) > CORNER / 10)
    kept = kept[:: max(1, -(-len(kept) // MOST))]
    return trace.points[np.unique([0, *corners, *kept, len(trace.points) - 1])], False
