"""Pattern, shell and target curves as Rhino 3dm."""

from __future__ import annotations

import base64
import struct
import zlib
from math import isnan
from pathlib import Path
from typing import Any, Final

import numpy as np

from orishell.conventions.colours import rgb
from orishell.document import Document, Part
from orishell.io.format import Format, Settings, numbered_ids
from orishell.io.rhino_geometry import UNIT_SYSTEMS, mesh_of_faces, polyline_curve, rhino3dm
from orishell.io.solids import mesh_of, solids_in
from orishell.motion.quads import reflex_corners, unit_normals
from orishell.numerics.arrays import Array
from orishell.workshop.assembly import laid_flat
from orishell.workshop.board_sheets import LAYERS
from orishell.workshop.creases import CREASE_LETTERS
from orishell.workshop.cut_parts import find_outlines

VERSION: Final = 6
"""The oldest Rhino that reads the file."""

_MEANINGS = {
    "CUT": "border-crease",
    "MOUNTAIN": "mountain",
    "VALLEY": "valley",
    "ENGRAVE": "unfolded",
    "mesh": "panel-front",
    "panels": "panel-front",
    "top": "panel-front",
    "bottom": "panel-back",
    "f": "curve-f",
    "g": "curve-g",
}
"""What the colours of the layers mean."""
_LETTERS = {letter: layer for layer, letters in CREASE_LETTERS.items() for letter in letters}
_FIRST_CHUNK, _CHUNK_HEAD = 32, 12
_PROPERTIES, _HISTORY, _SHORT = 0x10000014, 0x20008021, 0x80000000
_NO_TIME = struct.pack("<8i", 0, 0, 0, 1, 0, 70, 4, 0)


def write_rhino(path: Path, document: Document, settings: Settings) -> None:
    """Write the flat pattern as curves, the chosen state as mesh and as panels, and the curves.

    Layers are "flat pattern" with CUT, MOUNTAIN, VALLEY and, if there are unfolded or unassigned
    creases, ENGRAVE; "shell" with "mesh" (one mesh, welded, double precision) and "panels" (one
    surface each, named by row and column); "board 1", ... likewise for other parts that are there,
    as boards clipped on at the target. Where panels have a thickness "mesh" is the surface of the
    hinges; boards are closed meshes, named by panel and side, on the layers "top" and "bottom", or
    on "panels" if they are in one piece. "target" has a layer for each curve. The pattern lies at
    z = 0: its outlines are closed polylines, its creases lines with their fold angle as user text.
    The z axis is up. A panel is the bilinear surface of its corners, plane if they are; one with a
    corner that points inwards is a trimmed plane.

    The unit is the model's unit system, "no units" if none is known. The same document gives the
    same bytes with the same version of rhino3dm: objects have ids by their order, and the
    times that rhino3dm writes are replaced by the first second of 1970. It also writes its own
    version and the kind of operating system it ran on.
    """
    rhino = rhino3dm()
    model = _Model(document)
    if document.flat is not None:
        _add_pattern(model, laid_flat(document))
    parts = document.parts_in(settings.state)
    names = ["shell", *(f"board {number}" for number in range(1, len(parts)))]
    for name, (part, state) in zip(names, parts, strict=True):
        _add_shell(model, part, document.in_world(state.positions), name)
    if document.boards is not None:
        for name, solids in zip(names, solids_in(document, settings.state), strict=True):
            mesh = mesh_of((solids,))
            for side, (board, points, faces) in zip(mesh.sides.tolist(), mesh.each(), strict=True):
                layer = model.layer(name, LAYERS[side])
                model.add(mesh_of_faces(document.in_world(points), faces), layer, f"panel {board}")
    for name, points in document.curves.items():
        model.add(polyline_curve(document.in_world(points)), model.layer("target", name), name)
    options = rhino.File3dmWriteOptions()
    options.Version = VERSION
    path.write_bytes(_without_clock(base64.b64decode(model.file.Encode(options))))


class _Model:
    """A file with layers that are made when something is put on them."""

    def __init__(self, document: Document) -> None:
        rhino = rhino3dm()
        self.file = rhino.File3dm()
        system = getattr(rhino.UnitSystem, UNIT_SYSTEMS.get(document.unit, "None"))
        self.file.Settings.ModelUnitSystem = system
        self.file.ApplicationName = "orishell"
        self.file.StartSectionComments = (
            f"{' '.join(document.title.split())}\nUnit: {document.unit}. Up: z.\n"
        )
        self._layers: dict[tuple[str, ...], int] = {}
        self._ids = numbered_ids()

    def layer(self, *path: str) -> int:
        """The number of a layer; path is its name after those of the layers it is in."""
        rhino = rhino3dm()
        if path not in self._layers:
            layer = rhino.Layer()
            layer.Name = path[-1]
            layer.Id = next(self._ids)
            red, green, blue = rgb(_MEANINGS.get(path[-1], "border-crease"))
            layer.Color = (round(255 * red), round(255 * green), round(255 * blue), 255)
            if path[:-1]:
                layer.ParentLayerId = self.file.Layers[self.layer(*path[:-1])].Id
            self._layers[path] = self.file.Layers.Add(layer)
        return self._layers[path]

    def add(self, geometry: Any, layer: int, name: str, **user_text: str) -> None:
        """Put something on a layer."""
        rhino = rhino3dm()
        attributes = rhino.ObjectAttributes()
        attributes.LayerIndex = layer
        attributes.Name = name
        attributes.Id = next(self._ids)
        for key, text in user_text.items():
            attributes.SetUserString(key, text)
        self.file.Objects.Add(geometry, attributes)


def _add_pattern(model: _Model, document: Document) -> None:
    """Outlines and creases of the flat sheet, and what is cut inside it."""
    rhino = rhino3dm()
    flat = document.require_flat()
    points = np.column_stack([flat, np.zeros(len(flat))])
    for name in ("CUT", "MOUNTAIN", "VALLEY"):
        model.layer("flat pattern", name)
    for number, loop in enumerate(find_outlines(document.mesh.loops, flat)):
        outline = polyline_curve(points[[*loop, loop[0]]])
        model.add(outline, model.layer("flat pattern", "CUT"), f"outline {number}")
    inner = np.flatnonzero((document.mesh.edge_faces >= 0).all(axis=1))
    ends = points[document.mesh.edges[inner]].tolist()
    angles = document.fold_angles_deg[inner].tolist()
    for edge, (start, end), angle in zip(inner.tolist(), ends, angles, strict=True):
        layer = _LETTERS.get(document.assignment[edge], "CUT")
        line = rhino.LineCurve(rhino.Point3d(*start), rhino.Point3d(*end))
        known = {} if layer == "CUT" or isnan(angle) else {"fold_angle_deg": repr(angle)}
        kind = "cut" if layer == "CUT" else "crease"
        model.add(line, model.layer("flat pattern", layer), f"{kind} {edge}", **known)


def _add_shell(model: _Model, part: Part, positions: Array, name: str) -> None:
    """A part of the shell in space as one mesh, and panel by panel if these are surfaces."""
    model.add(mesh_of_faces(positions, part.mesh.faces), model.layer(name, "mesh"), name)
    if part.boards is not None:
        return
    corners = positions[part.mesh.faces]
    layer = model.layer(name, "panels")
    reflex: list[bool] = np.any(reflex_corners(corners), axis=1).tolist()
    for panel, (points, concave) in enumerate(zip(corners, reflex, strict=True)):
        surface = _trimmed(points) if concave else _bilinear(points)
        model.add(surface, layer, f"panel {part.panel_name(panel)}")


def _bilinear(corners: Array) -> Any:
    """The surface with these corners (4, 3) and straight sides."""
    rhino = rhino3dm()
    a, b, c, d = (rhino.Point3d(*point) for point in corners.tolist())
    return rhino.NurbsSurface.CreateRuledSurface(rhino.LineCurve(a, b), rhino.LineCurve(d, c))


def _trimmed(corners: Array) -> Any:
    """The part of a plane inside these corners (4, 3)."""
    rhino = rhino3dm()
    plane = rhino.Plane(
        rhino.Point3d(*corners[0].tolist()), rhino.Vector3d(*unit_normals(corners).tolist())
    )
    return rhino.Brep.CreateTrimmedPlane(plane, polyline_curve(corners[[0, 1, 2, 3, 0]]))


def _without_clock(data: bytes) -> bytes:
    """A file with 1970-01-01 for the times at which it was made and edited.

    They are in a chunk of the table of properties: a byte, a name, a time, a name, a time, a
    count and the checksum of these. Names are strings of two bytes a letter after their number
    of letters, times are eight integers (second, minute, hour, day, month, year,
    day of the week and of the year; C's ``struct tm``). Chunks begin with a typecode and
    their length; short ones have a value in its place and no content.
    """
    begin = _FIRST_CHUNK
    while True:
        kind, length = struct.unpack_from("<IQ", data, begin)
        begin += _CHUNK_HEAD
        if kind == _HISTORY:
            break
        begin += 0 if kind == _PROPERTIES or kind & _SHORT else length
    end = begin + length
    content = bytearray(data[begin : end - 4])
    place = 1
    for _ in ("made", "edited"):
        place += 4 + 2 * int(struct.unpack_from("<I", content, place)[0])
        content[place : place + len(_NO_TIME)] = _NO_TIME
        place += len(_NO_TIME)
    checksum = struct.pack("<I", zlib.crc32(content))
    return data[:begin] + content + checksum + data[end:]


FORMAT = Format(
    "3dm", "shell.3dm", (".3dm",), "pattern, shell and curves (Rhino)", write_rhino, task="cad"
)
