"""Target surfaces as the page draws them, and meshes that are dropped onto it."""

from __future__ import annotations

import base64
from typing import Any

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import conversion, plain
from orishell.design import FormulaSurface, PiecedSurface
from orishell.design.mesh_files import ENDINGS, read_mesh
from orishell.design.open_mesh import open_mesh
from orishell.design_file import DesignFile
from orishell.numerics.arrays import Array
from orishell.studio.api import DrawnSurface, DroppedTarget, Patch
from orishell.studio.dropped import dropped_file

COARSE, ENOUGH = 6, 0.8
"""Panels along the longer side of the sheet that is shown first, and the share of the panels that
are asked for from which on none is."""
ONE_START = {"direction_deg": 0, "fold_deg": 90}
"""How its fit is begun, in a family that tries several ways."""
CELLS = 32
"""Cells of the lattice that is drawn, along its longer side, about."""
MOST_TRIANGLES = 200_000
"""Triangles of a mesh in a design of the studio, which is sent with every request."""
DIGITS = 7
"""Digits of a coordinate, by the size of the mesh."""


def coarser(file: DesignFile) -> DesignFile | None:
    """The design with fewer rows and columns, its fit begun in one way; None if its own are few."""
    size = {"rows": file.pattern.rows, "columns": file.pattern.columns}
    share = COARSE / (max(size.values()) + 1)
    if file.tolerance is not None or share > ENOUGH:
        return None
    values = {f"pattern.{key}": max(3, round(share * (each + 1)) - 1) for key, each in size.items()}
    fields = type(file.pattern).model_fields
    begun = {f"pattern.{key}": each for key, each in ONE_START.items() if key in fields}
    return file.changed({**values, **begun})


def draw_surface(surface: PiecedSurface, table: dict[str, Any], unit: str) -> DrawnSurface:
    """A surface and its rim, to be drawn; its ``table`` says what of it can be dragged."""
    points = surface.lattice(surface.size() / (2 * CELLS), most=CELLS**2).points
    vertices, sides = surface.piece.vertices, surface.piece.sides
    rows, columns = points.shape[:2]
    own = conversion(table.get("unit", unit), unit)
    factor = (own * np.array(table.get("scale", 1.0)) * np.ones(3)).tolist()
    ends = np.cumsum([0, *(len(side) - 1 for side in sides[:-1])]).tolist()
    return {
        "points": _text(points),
        "lattice": (rows, columns),
        "rim": _text(vertices[np.concatenate([side[:-1] for side in sides])]),
        "corners": (ends[0], ends[1], ends[2], ends[3]),
        "patch": _patch(surface),
        "factor": (factor[0], factor[1], factor[2]),
    }


def _patch(surface: object) -> Patch | None:
    """The rectangle in plan, if there is one that lies where it is said."""
    if not isinstance(surface, FormulaSurface) or len(surface.formulas) > 1 or surface.scale != 1.0:
        return None
    (a, b), (c, d) = surface.first, surface.second
    middle = np.array([0.5 * (a + b), 0.5 * (c + d)])
    x, y = np.array(surface.centre) + _rotated(middle, surface.turn)
    turn = float(np.rad2deg(surface.turn))
    return {"centre": (float(x), float(y)), "size": (b - a, d - c), "turn_deg": turn}


def _text(points: Array) -> str:
    return base64.b64encode(points.astype("<f4").tobytes()).decode()


def _rotated(point: Array, turn: float) -> Array:
    """A point (2,) turned about the origin (radians)."""
    c, s = np.cos(turn), np.sin(turn)
    return np.array([[c, -s], [s, c]]) @ point


def read_dropped_mesh(name: str, content: str, unit: str) -> DroppedTarget:
    """The table of a surface in the file of a mesh, and a note on how it was read.

    The content is in base64. Raises InputError if it holds no open piece of surface.
    """
    with dropped_file(name, content, ENDINGS, "a mesh") as path:
        file = read_mesh(path)
        mesh = open_mesh(file.vertices, file.triangles)
    if len(mesh.triangles) > MOST_TRIANGLES:
        raise InputError(
            "the mesh has too many triangles for the studio",
            file=name,
            got=f"{len(mesh.triangles)} triangles",
            expected=f"at most {MOST_TRIANGLES}",
            remedy="make it coarser, or name its file in a design file for orishell design",
        )
    size = np.ptp(mesh.vertices, axis=0)
    places = DIGITS - 1 - int(np.floor(np.log10(size.max())))
    table: dict[str, Any] = {
        "vertices": (np.round(mesh.vertices, places) + 0.0).tolist(),
        "triangles": mesh.triangles.tolist(),
    }
    if file.unit not in {"", unit}:
        table["unit"] = file.unit
    if file.up is not None:
        table["up"] = "z"  # as its vertices are listed
    sizes = " x ".join(plain(float(each), 3) for each in size)
    note = f"{len(mesh.triangles)} triangles of {name}, {sizes} {file.unit or unit}"
    return {"table": table, "note": note}
