"""Geometry from Rhino as keys of a design file, exactly where these can hold it, and back.

Limit: NURBS of a degree above 3, or rational ones that are no arc, become curves of degree 3 in
Grasshopper, within a ten-thousandth of their size; Hops says by how much. Surfaces become meshes.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Final

import numpy as np
import orjson

from orishell.conventions.errors import CurveError, InputError
from orishell.conventions.quantities import plain
from orishell.curves import curve_data
from orishell.curves.joining import join_pieces
from orishell.curves.pieces import Piece, nurbs
from orishell.io.rhino_geometry import rhino3dm
from orishell.numerics.arrays import Array

FLAT: Final = 1e-6
"""How far a curve may leave its plane, relative to its size."""
FINE: Final = 1e-4
"""How far a mesh may be from its surface, relative to the size of that, if cells are few enough."""
CELLS: Final = (16, 32, 64, 128)
"""Numbers of cells, each way, that are tried for a surface."""
MESHED: Final = "mesh it in Grasshopper (Mesh Brep, or Mesh Surface) and connect the mesh"
POINT: Final = '{"X":%s,"Y":%s,"Z":%s}'
LINE: Final = f'{{"From":{POINT},"To":{POINT}}}'
PLANE: Final = f'{{"Origin":{POINT},"XAxis":{POINT},"YAxis":{POINT},"ZAxis":{POINT}}}'


def f_path(curve: Any) -> tuple[str, list[str]]:
    """Path data of the ``curve`` f in its own plane, and what is to be said of it.

    Level curves have x and y of the document. Others stand upright: their height is z, and x runs
    along their plane, towards x of the document, or y if that plane is square to x.

    Raises
    ------
    InputError
        If it lies in no such plane, or has not two ends.
    """
    points, size = _outline(curve)
    if np.ptp(points[:, 2]) <= FLAT * size:
        return _path(curve, np.eye(3)[:2])
    far = points[np.argmax(np.hypot(*(points[:, :2] - points[0, :2]).T)), :2] - points[0, :2]
    along = far / np.hypot(*far) if np.hypot(*far) > FLAT * size else np.array([1.0, 0.0])
    if along[0] < -FLAT or (along[0] <= FLAT and along[1] < 0):
        along = -along
    off = points[:, :2] @ np.array([-along[1], along[0]])
    if np.ptp(off) > FLAT * size:
        raise _off_plane(np.ptp(off), "a level or an upright plane", "turn it upright (Rotate 3D)")
    return _path(curve, np.array([[*along, 0.0], [0.0, 0.0, 1.0]]))


def g_path(curve: Any) -> tuple[str, list[str]]:
    """Path data of the ``curve`` g in plan, and what is to be said of it.

    Raises
    ------
    InputError
        If it is not level, or has not two ends.
    """
    points, size = _outline(curve)
    rise, height = float(np.ptp(points[:, 2])), float(points[0, 2])
    if rise > FLAT * size:
        raise _off_plane(rise, "a level plane", "project it to the ground (Project)")
    path, notes = _path(curve, np.eye(3)[:2])
    if abs(height) > FLAT * size:
        notes.append(f"g lies at z = {plain(height)}, but shells stand on z = 0: move the state up")
    return path, notes


def _off_plane(off: float, plane: str, remedy: str) -> CurveError:
    got = f"points up to {plain(off)} beside it"
    return CurveError(
        "the curve is not flat", got=got, expected=f"a curve in {plane}", remedy=remedy
    )


def _outline(curve: Any) -> tuple[Array, float]:
    """Control points (N, 3) of a curve, within which it stays in a plane, and its size."""
    control = np.concatenate([_control(each)[:, :3] for each in _segments(curve)])
    size = float(np.linalg.norm(np.ptp(control, axis=0)))
    if not np.isfinite(size) or size == 0:
        raise CurveError("the curve has no size", remedy="draw it anew")
    return control, size


def _path(curve: Any, basis: Array) -> tuple[str, list[str]]:
    """Path data in a plane's axes (2, 3), and what is to be said of it."""
    pieces = [piece for each in _segments(curve) for piece in _pieces(each, basis)]
    chain = join_pieces(pieces, lambda point: f"({point[0]:.15g}, {point[1]:.15g})")
    path, off = curve_data(chain)
    said = f"drawn anew with curves of degree 3, within {plain(off)} of it"
    return path, [*chain.notes, *([said] if off else [])]


def _segments(curve: Any) -> Iterator[Any]:
    """A curve in parts that are NURBS, each of its own degree."""
    if hasattr(curve, "SegmentCurve"):
        for number in range(curve.SegmentCount):
            yield from _segments(curve.SegmentCurve(number))
    else:
        made = curve.ToNurbsCurve()
        if made is None:
            raise CurveError("the curve has no NURBS form", remedy="rebuild it (Rebuild Curve)")
        yield made


def _control(curve: Any) -> Array:
    """Control points (N, 4) of a NURBS: x, y, z and weight."""
    points = [curve.Points[k] for k in range(len(curve.Points))]
    control = np.array([[each.X, each.Y, each.Z, each.W] for each in points])
    control[:, :3] /= control[:, 3:]
    return control


def _pieces(curve: Any, basis: Array) -> list[Piece]:
    control, inner = _control(curve), [curve.Knots[k] for k in range(len(curve.Knots))]
    knots = [inner[0], *inner, inner[-1]]  # Rhino leaves out the first and the last
    weights = control[:, 3] / control[:, 3].max()
    return nurbs(curve.Degree, knots, control[:, :3] @ basis.T, weights)


def surface_table(shape: Any) -> tuple[dict[str, Any], list[str]]:
    """The table of a mesh, a surface or a brep, the ``shape``, and what is to be said of it.

    Raises
    ------
    InputError
        If it has several faces, or a trimmed one.
    """
    rhino = rhino3dm()
    if isinstance(shape, rhino.Mesh):
        corners = [shape.Faces[k] for k in range(len(shape.Faces))]
        points = [shape.Vertices[k] for k in range(len(shape.Vertices))]
        split = [half for a, b, c, d in corners for half in ((a, b, c), (a, c, d))]
        triangles = [[*each] for each in split if len({*each}) == 3]
        return _table(np.array([[p.X, p.Y, p.Z] for p in points]), triangles), []
    if isinstance(shape, rhino.Extrusion):
        shape = shape.ToBrep(True)
    if isinstance(shape, rhino.Brep):
        if len(shape.Faces) != 1 or not shape.IsSurface:
            got = f"{len(shape.Faces)} faces" if len(shape.Faces) != 1 else "a trimmed face"
            what = "this is not one untrimmed surface"
            raise InputError(what, where="input surface", got=got, remedy=MESHED)
        shape = shape.Faces[0].UnderlyingSurface()
    if not isinstance(shape, rhino.Surface):
        got = type(shape).__name__
        what = "this is neither a mesh nor a surface"
        raise InputError(what, where="input surface", got=got, remedy=MESHED)
    return _sampled(shape)


def _sampled(surface: Any) -> tuple[dict[str, Any], list[str]]:
    """A mesh of points on a surface, fine enough or the finest."""
    for cells in CELLS:
        finer = _lattice(surface, 2 * cells)
        points = finer[::2, ::2]
        off = float(np.linalg.norm(_between(points) - finer[1::2, 1::2], axis=-1).max())
        if off <= FINE * np.linalg.norm(np.ptp(points.reshape(-1, 3), axis=0)):
            break
    corner = np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)
    a, b, c, d = corner, corner + cells + 1, corner + cells + 2, corner + 1
    triangles = np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3).tolist()
    said = f"the surface became a mesh of {cells} x {cells} cells, within {plain(off)} of it"
    return _table(points.reshape(-1, 3), triangles), [said]


def _lattice(surface: Any, cells: int) -> Array:
    """Points (cells + 1, cells + 1, 3) of a surface."""
    (u0, u1), (v0, v1) = ((surface.Domain(k).T0, surface.Domain(k).T1) for k in (0, 1))
    ends = np.linspace(u0, u1, cells + 1), np.linspace(v0, v1, cells + 1)
    at = [[surface.PointAt(u, v) for v in ends[1].tolist()] for u in ends[0].tolist()]
    return np.array([[(p.X, p.Y, p.Z) for p in row] for row in at])


def _between(points: Array) -> Array:
    """Middles of the cells of a lattice."""
    return 0.5 * (points[:-1, :-1] + points[1:, 1:])


def _table(points: Array, triangles: list[Any]) -> dict[str, Any]:
    return {"vertices": points.tolist(), "triangles": triangles, "up": "z"}


def points(places: Array) -> list[str]:
    """Points (N, 3), the ``places``, as Rhino's JSON has them."""
    return _written(POINT, places)


def lines(ends: Array) -> list[str]:
    """Lines between ``ends`` (N, 2, 3) as Rhino's JSON has them."""
    return _written(LINE, ends)


def planes(origins: Array, axes: Array) -> list[str]:
    """Planes by ``origins`` (N, 3) and ``axes`` (N, 3, 3), as columns, as Rhino's JSON has them."""
    return _written(PLANE, np.concatenate([origins[:, None], axes.swapaxes(1, 2)], axis=1))


def _written(form: str, values: Array) -> list[str]:
    """Values (N, ...) in a form each, with all digits."""
    whole = orjson.dumps(np.ascontiguousarray(values).ravel(), option=orjson.OPT_SERIALIZE_NUMPY)
    texts = iter(whole.decode()[1:-1].split(","))
    count = form.count("%s")
    return [form % each for each in zip(*[texts] * count, strict=False)] if len(values) else []
