"""What was drawn in Blender as the target of a design file: two curves, or a mesh."""

from __future__ import annotations

from typing import Any

import bpy
import numpy as np
from numpy.typing import NDArray

from .design import Refusal, Tables

FLAT = 1e-5
"""A curve is planar if it leaves its plane by no more than this share of its size."""


def target_of(context: Any, metres: float) -> Tables:
    """The table [target] of what is selected, in a unit of so many ``metres``.

    Raises Refusal if it is neither two planar curves nor one mesh.
    """
    active = context.view_layer.objects.active
    chosen = [each for each in context.selected_objects if each.type in ("CURVE", "MESH")]
    if [each.type for each in chosen] == ["MESH"]:
        return {"surface": _surface(context, chosen[0], metres)}
    if [each.type for each in chosen] != ["CURVE", "CURVE"] or active not in chosen:
        got = ", ".join(each.name for each in chosen) or "nothing"
        raise Refusal(f"select two curves, f last, to be swept along g; or one mesh. Got: {got}")
    g = next(each for each in chosen if each != active)
    return {"f": _curve(active, metres), "g": _curve(g, metres)}


def _curve(drawn: Any, metres: float) -> Tables:
    splines = drawn.data.splines
    if len(splines) != 1 or splines[0].use_cyclic_u:
        got = "it is closed" if len(splines) == 1 else f"it has {len(splines)}"
        raise Refusal(f"{drawn.name}: a target is one open spline, and {got}. Open or part it")
    plain = drawn.data.copy()
    plain.bevel_mode, plain.bevel_depth, plain.extrude, plain.offset = "ROUND", 0.0, 0.0, 0.0
    made = bpy.data.objects.new(drawn.name, plain)
    points = _points(made.to_mesh(), drawn.matrix_world) / metres
    bpy.data.objects.remove(made)
    bpy.data.curves.remove(plain)
    smooth = splines[0].type != "POLY"
    return {"points": _rounded(in_plane(drawn.name, points)), "smooth": smooth}


def in_plane(name: str, points: NDArray[Any]) -> NDArray[Any]:
    """Points (P, 3) of a planar curve in its plane (P, 2): y upwards, or as drawn if it is level.

    Raises Refusal if they lie in no plane.
    """
    away = points - points.mean(axis=0)
    sizes, axes = np.linalg.svd(away)[1:]
    size, off = float(np.abs(away).max()), float(np.abs(away @ axes[2]).max())
    if off > FLAT * size:
        raise Refusal(
            f"{name}: the curve is not planar: it leaves its plane by {off:.3g}. Scale it to 0 "
            "along the axis that it leaves by, or make it 2D"
        )
    straight = sizes[1] <= FLAT * sizes[0]
    normal = np.cross(axes[0], [0.0, 0.0, 1.0]) if straight else axes[2]
    if np.hypot(*normal[:2]) <= FLAT or (straight and abs(axes[0, 2]) <= FLAT):
        return points[:, :2]
    along = np.array([-normal[1], normal[0], 0.0]) / np.hypot(*normal[:2])
    along *= 1.0 if (points[-1] - points[0]) @ along >= 0 else -1.0
    up = np.cross(along, normal / np.linalg.norm(normal))
    return np.stack([points @ along, points @ up * (1.0 if up[2] >= 0 else -1.0)], axis=1)


def _surface(context: Any, drawn: Any, metres: float) -> Tables:
    seen = drawn.evaluated_get(context.evaluated_depsgraph_get())
    mesh = seen.to_mesh()
    mesh.calc_loop_triangles()
    triangles = [list(each.vertices) for each in mesh.loop_triangles]
    points = _points(mesh, drawn.matrix_world) / metres
    if not triangles:
        raise Refusal(f"{drawn.name}: the mesh has no faces. Fill its edges, or select another")
    return {"vertices": _rounded(points), "triangles": triangles}


def _points(mesh: Any, place: Any) -> NDArray[Any]:
    """Vertices (V, 3) of a mesh in the world."""
    points = np.array([each.co for each in mesh.vertices], dtype=float).reshape(-1, 3)
    matrix = np.array(place)
    moved: NDArray[Any] = points @ matrix[:3, :3].T + matrix[:3, 3]
    return moved


def _rounded(points: NDArray[Any]) -> list[list[float]]:
    """Points with the seven digits that Blender has of them."""
    return [[float(f"{each:.7g}") for each in point] for point in points.tolist()]
