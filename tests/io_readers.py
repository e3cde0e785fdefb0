"""Every format read back, mostly by other people's libraries: what the parametrised test compares.

A reader gives what a file says of its unit, the vertices that it has, and the lengths of its
creases by assignment; None where the format does not say it.
"""

from __future__ import annotations

import base64
import csv
import json
import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
from numpy.typing import NDArray

from cad_tools import objects_of, read_3mf
from orishell.io import read_fold

Array = NDArray[np.float64]
Lengths = dict[str, float]


@dataclass(frozen=True)
class Content:
    """What a file says.

    Parameters
    ----------
    metres
        Length of the file's unit in metres.
    space
        Vertices (k, 3) of the state that it shows, z up, each at least once, in its unit.
    plane
        Vertices (k, 2) of the flat sheet, up to its place on the page.
    lengths
        Total length of mountains M and valleys V, in its unit.
    """

    metres: float | None = None
    space: Array | None = None
    plane: Array | None = None
    lengths: Lengths | None = None


def _by_letter(lengths: Array, letters: list[str]) -> Lengths:
    return {letter: float(lengths[np.array(letters) == letter].sum()) for letter in "MV"}


def _along(ends: Array) -> Array:
    return np.asarray(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=-1))


METRES = {"mm": 1e-3, "cm": 1e-2, "m": 1.0, "in": 0.0254, "ft": 0.3048}


def fold(path: Path) -> Content:
    file = read_fold(path)
    flat, letters = file.frames[0].positions[:, :2], file.assignment
    assert letters is not None
    lengths = _by_letter(_along(flat[file.mesh.edges]), list(letters))
    return Content(METRES[file.unit], file.frames[-1].positions, flat, lengths)


def dxf(path: Path) -> Content:
    from ezdxf.entities.line import Line
    from ezdxf.entities.lwpolyline import LWPolyline
    from ezdxf.filemanagement import readfile

    document = readfile(path)
    metres = {4: 1e-3, 5: 1e-2, 6: 1.0, 1: 0.0254, 2: 0.3048}[document.header["$INSUNITS"]]
    lengths = {"MOUNTAIN": 0.0, "VALLEY": 0.0}
    plane = []
    for entity in document.modelspace():
        layer = entity.dxf.layer
        if isinstance(entity, Line) and layer in lengths:
            lengths[layer] += float((entity.dxf.end - entity.dxf.start).magnitude)
            plane += [entity.dxf.start.vec2, entity.dxf.end.vec2]
        if isinstance(entity, LWPolyline) and layer == "CUT":
            plane += [point[:2] for point in entity.get_points()]
    sums = {"M": lengths["MOUNTAIN"], "V": lengths["VALLEY"]}
    return Content(metres, plane=np.array([tuple(point) for point in plane]), lengths=sums)


def svg(path: Path) -> Content:
    from svgelements import SVG, Group, Shape
    from svgelements import Path as SvgPath

    drawn = SVG.parse(str(path), ppi=96)
    lengths = {"MOUNTAIN": 0.0, "VALLEY": 0.0}
    for group in drawn.select(lambda element: isinstance(element, Group)):
        if group.id in lengths:
            shapes = [each for each in group if isinstance(each, Shape)]
            lengths[group.id] = sum(float(SvgPath(each).length()) for each in shapes)
    # svgelements measures in pixels of 96 to the inch, whatever unit the page is in.
    return Content(0.0254 / 96, lengths={"M": lengths["MOUNTAIN"], "V": lengths["VALLEY"]})


def pdf(path: Path) -> Content:
    from pypdf import PdfReader

    text = "".join(page.extract_text() for page in PdfReader(path).pages)
    assert re.search(r"1\s*:\s*\d", text)
    return Content()


def booklet(path: Path) -> Content:
    from pypdf import PdfReader

    pages = [page.extract_text() for page in PdfReader(path).pages]
    assert f"{len(pages)} of {len(pages)}" in pages[-1]
    return Content()


def origami_simulator(path: Path) -> Content:
    lines = ElementTree.parse(path).getroot().iter("{http://www.w3.org/2000/svg}line")
    ends: dict[str, list[Any]] = {"#ff0000": [], "#0000ff": [], "#000000": [], "#ffff00": []}
    for line in lines:
        ends[line.attrib["stroke"]].append(
            [[float(line.attrib[f"{axis}{end}"]) for axis in "xy"] for end in (1, 2)]
        )
    mountain, valley, *others = (np.array(each).reshape(-1, 2, 2) for each in ends.values())
    lengths = {"M": float(_along(mountain).sum()), "V": float(_along(valley).sum())}
    plane = np.concatenate([mountain, valley, *others]).reshape(-1, 2) * [1, -1]
    return Content(plane=plane, lengths=lengths)


def _unit_in(path: Path) -> float:
    words = re.search(rb"[Uu]nit[^a-z]{0,3}(mm|cm|m|in|ft)\b", path.read_bytes()[:2000])
    assert words is not None
    return METRES[words[1].decode()]


def obj(path: Path) -> Content:
    import meshio

    points = meshio.read(path).points
    return Content(_unit_in(path), points[:, [0, 2, 1]] * [1, -1, 1])


def ply(path: Path) -> Content:
    import meshio

    return Content(_unit_in(path), meshio.read(path).points)


def stl(path: Path) -> Content:
    import meshio

    return Content(_unit_in(path), meshio.read(path).points)


def vtu(path: Path) -> Content:
    import meshio

    return Content(_unit_in(path), meshio.read(path).points)


def glb(path: Path) -> Content:
    from pygltflib import GLTF2
    from scipy.spatial.transform import Rotation

    file = GLTF2().load(str(path))
    blob = file.binary_blob()
    points = []
    for node in file.nodes:
        if node.mesh is None:
            continue
        accessor = file.accessors[file.meshes[node.mesh].primitives[0].attributes.POSITION]
        view = file.bufferViews[accessor.bufferView]
        begin = (view.byteOffset or 0) + (accessor.byteOffset or 0)
        local = np.frombuffer(blob, "<f4", 3 * accessor.count, begin).reshape(-1, 3)
        turn = Rotation.from_quat(node.rotation or [0, 0, 0, 1])
        points.append(turn.apply(local.astype(float)) + (node.translation or [0, 0, 0]))
    # metres, y up
    return Content(1.0, np.concatenate(points)[:, [0, 2, 1]] * [1, -1, 1])


def rhino(path: Path) -> Content:
    import rhino3dm

    file: Any = rhino3dm.File3dm.Read(str(path))  # its stubs know no iteration
    system = rhino3dm.UnitSystem
    metres = {
        system.Millimeters: 1e-3,
        system.Centimeters: 1e-2,
        system.Meters: 1.0,
        system.Inches: 0.0254,
        system.Feet: 0.3048,
    }[file.Settings.ModelUnitSystem]
    names = {layer.Index: layer.FullPath for layer in file.Layers}
    lengths = {"M": 0.0, "V": 0.0}
    space: Any = None
    for entity in file.Objects:
        layer = names[entity.Attributes.LayerIndex]
        shape: Any = entity.Geometry
        letter = {"MOUNTAIN": "M", "VALLEY": "V"}.get(layer.split("::")[-1])
        if letter:
            start, end = shape.PointAtStart, shape.PointAtEnd
            lengths[letter] += float(np.hypot(end.X - start.X, end.Y - start.Y))
        if isinstance(shape, rhino3dm.Mesh) and layer.split("::")[-1] == "mesh":
            vertices: Any = shape.Vertices
            space = [[vertex.X, vertex.Y, vertex.Z] for vertex in vertices]
    return Content(metres, np.array(space), lengths=lengths)


def step(path: Path) -> Content:
    from build123d import import_step

    corners = import_step(path).vertices()
    return Content(1e-3, np.array([(corner.X, corner.Y, corner.Z) for corner in corners]))


def threemf(path: Path) -> Content:
    meshes = [each.GetVertices() for each in objects_of(read_3mf(path))]
    return Content(1e-3, np.array([tuple(point.Coordinates) for mesh in meshes for point in mesh]))


def read_calculix(path: Path) -> Any:
    """The mesh of a deck without its ties, as meshio has it, which knows no springs."""
    import meshio

    bare = path.with_name(f"{path.stem}-bare.inp")
    bare.write_text(re.sub(r"\*(ELEMENT,TYPE=SPRINGA|SPRING)[^*]*", "", path.read_text()))
    return meshio.read(bare, "abaqus")


def calculix(path: Path) -> Content:
    unit = re.search(r"Units: (\w+),", path.read_text())
    assert unit is not None
    mesh = read_calculix(path)
    corners = mesh.cells_dict["quad8"][:, :4]  # without the middles of sides
    return Content(METRES[unit[1]], mesh.points[corners].reshape(-1, 3))


def tables(path: Path) -> Content:
    with path.open(newline="") as file:
        heads, *rows = list(csv.reader(file))
    unit = heads[3].removeprefix("x1_")
    plane = np.array([row[3:11] for row in rows], dtype=float).reshape(-1, 2)
    with path.with_name("creases.csv").open(newline="") as file:
        creases = list(csv.DictReader(file))
    size = np.array([row[f"length_{unit}"] for row in creases], dtype=float)
    lengths = _by_letter(size, [row["assignment"] for row in creases])
    return Content(METRES[unit], plane=plane, lengths=lengths)


def html(path: Path) -> Content:
    words = re.search(r'id="orishell-view">([^<]*)<', path.read_text())
    assert words is not None
    view = base64.b64decode(words[1])
    length = int.from_bytes(view[:4], "little")
    head = json.loads(view[4 : 4 + length])

    def array(name: str) -> Array:
        place = head["arrays"][name]
        count = int(np.prod(place["shape"]))
        found = np.frombuffer(view, place["type"], count, 4 + length + place["offset"])
        return found.reshape(place["shape"]).astype(float)

    space = array("positions")[-1] + head["origin"]
    lengths = _along(array("flat")[array("edges").astype(int)])
    letters = [" MV  "[int(code)] for code in array("assignment")]
    return Content(METRES[head["unit"]], space, lengths=_by_letter(lengths, letters))


READERS: dict[str, Callable[[Path], Content]] = {
    "fold": fold,
    "dxf": dxf,
    "svg": svg,
    "pdf": pdf,
    "booklet": booklet,
    "origami-simulator": origami_simulator,
    "obj": obj,
    "stl": stl,
    "ply": ply,
    "glb": glb,
    "3dm": rhino,
    "step": step,
    "3mf": threemf,
    "vtu": vtu,
    "inp": calculix,
    "csv": tables,
    "html": html,
}


def json_of(path: Path) -> dict[str, Any]:
    content: dict[str, Any] = json.loads(path.read_text())
    return content
