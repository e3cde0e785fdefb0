"""Files of meshes: OBJ, STL and glTF, read by trimesh from what is put in order here, and PLY.

trimesh reads some of what programs write as another shape without a word. So what it would mistake
is refused or put in order before, and it must find as many triangles as a file lists. Of PLY it
takes no polygons of unlike sizes in binary, and what breaks off in text for whole: to ask for that
beforehand is to read the file. ``tests/mesh_variants.py`` and its like have what was tried.
"""

from __future__ import annotations

import re
from functools import cache
from io import BytesIO
from pathlib import Path
from typing import Any, Final, Literal

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import MILLIMETRES
from orishell.conventions.record import record
from orishell.conventions.source_file import read_source_file, require_source_file
from orishell.design.gltf_mesh import plain_gltf
from orishell.design.mesh_errors import MeshFileError
from orishell.design.mesh_text import plain_obj, plain_stl
from orishell.design.ply_mesh import read_ply
from orishell.numerics.arrays import Array, Integers

GLTF: Final = (".glb", ".gltf")
ENDINGS: Final = (".obj", ".stl", ".ply", *GLTF)
MOST_BYTES: Final = 100_000_000
"""Bytes of a file, and of the buffers that it names, at most."""
WORDS: Final = 2000
"""Bytes at the beginning of a file in which its unit may stand."""
_SAID = re.compile(rb"Unit: (\w+)\. Up: ([yz])\.|orishell, unit (\w+), (z) up")
"""What :mod:`orishell.io.formats` writes of unit and axis into remarks."""
Axis = Literal["y", "z"]


@record
class MeshFile:
    """What a file of a mesh has."""

    vertices: Array  # (V, 3), z up
    triangles: Integers  # (T, 3)
    unit: str  # of its lengths; "" if it does not say
    up: Axis | None  # the axis that is up in the file; None if it does not say


def read_mesh(path: Path, up: Axis | None = None) -> MeshFile:
    """The mesh in a file; polygons are cut into fans of triangles.

    glTF has y up, and lengths in metres. Other files say neither, but those that are written here.

    Parameters
    ----------
    path
        The file.
    up
        Which of the file's axes is up; as the file says if None, and z if it does not.

    Raises
    ------
    InputError
        If there is no mesh in it.
    """
    try:
        found = _read(path)
    except InputError as error:
        raise (error if error.keys else error.at_key("mesh", "mesh")).in_file(path) from None
    except MeshFileError as error:
        raise InputError(
            "the file holds no mesh that can be read",
            file=path,
            keys=("mesh",),
            where=f"mesh {error.where}".strip(),
            got=error.got,
            expected=error.expected,
            remedy="write it once more, whole and without compression, as OBJ, PLY, STL or glTF",
        ) from None
    return MeshFile(
        turned_up(found.vertices, up or found.up or "z"), found.triangles, found.unit, found.up
    )


def turned_up(vertices: Array, up: Axis) -> Array:
    """Points (V, 3) with z up, of such with z or y up."""
    if up == "z":
        return vertices
    x, y, z = vertices.T
    return np.stack([x, 0.0 - z, y], axis=-1)


def require_mesh_file(path: Path) -> None:
    """Refuse what is no file of a kind that is read here, without reading it; InputError."""
    _require_kind(path)
    require_source_file(path, "file", MOST_BYTES)


def _require_kind(path: Path) -> None:
    if path.suffix.lower() not in ENDINGS:
        raise InputError(
            "this kind of file holds no mesh that is read here",
            got=path.suffix,
            expected="an OBJ, STL, PLY or glTF file with one open piece of surface",
        )


def _read(path: Path) -> MeshFile:
    ending = path.suffix.lower()
    _require_kind(path)
    data = read_source_file(path, "file", MOST_BYTES)
    if ending == ".ply":
        vertices, triangles = read_ply(data)
    elif ending in GLTF:
        vertices, triangles = _shown(".gltf", *plain_gltf(data, path.parent, MOST_BYTES))
    else:
        content, count = plain_obj(data) if ending == ".obj" else plain_stl(data)
        vertices, triangles = _shown(ending, content)
        if len(triangles) != count:
            raise MeshFileError("", f"{len(triangles)} triangles", f"{count}, as the file lists")
    if not len(triangles):
        raise MeshFileError("", "no triangles", "triangles in space")
    _require_vertices(triangles, len(vertices))
    said = _SAID.search(data[:WORDS])
    if ending in GLTF or said is None:
        return MeshFile(vertices, triangles, *(("m", "y") if ending in GLTF else ("", None)))
    unit = (said[1] or said[3]).decode()
    up: Axis = "y" if said[2] == b"y" else "z"
    return MeshFile(vertices, triangles, unit if unit in MILLIMETRES else "", up)


@np.errstate(all="ignore")  # what overflows is refused as a surface
def _shown(ending: str, content: bytes, buffers: Any = None) -> tuple[Array, Integers]:
    """Vertices and triangles of all that a file shows, each where its nodes put it."""
    import trimesh

    points, triangles, before = [np.zeros((0, 3))], [np.zeros((0, 3), np.int64)], 0
    try:
        scene = trimesh.load_scene(
            BytesIO(content), file_type=ending[1:], resolver=buffers, process=False
        )
        nodes = scene.graph.transforms

        @cache
        def place(node: str) -> Array:  # trimesh multiplies n matrices in a time that grows as n³
            above = nodes.parents.get(node)
            if above is None:
                return np.eye(4)
            matrix: Array = nodes.edge_data[above, node].get("matrix", np.eye(4))
            return place(above) @ matrix

        for node in scene.graph.nodes_geometry:
            mesh = scene.geometry[nodes.node_data[node]["geometry"]]
            faces = np.asarray(getattr(mesh, "faces", []), np.int64)  # points have none
            if len(faces):
                _require_vertices(faces, len(mesh.vertices))
                divisor = mesh.metadata.get("divisor", 1)
                found = np.array(mesh.vertices, np.float64) / divisor
                found = np.maximum(found, -1.0) if divisor > 1 else found  # -128 of 127 is -1, too
                points.append(found @ place(node)[:3, :3].T + place(node)[:3, 3])
                triangles.append(faces + before)
                before += len(found)
    except MeshFileError:
        raise
    except Exception as error:
        got = f"{type(error).__name__}: {error}".removesuffix(": ")
        raise MeshFileError("", got, "what the standard of its format says") from None
    return np.concatenate(points), np.concatenate(triangles)


def _require_vertices(triangles: Integers, count: int) -> None:
    """Refuse triangles at vertices that are not there."""
    worst = int(triangles.max(initial=0))
    if worst >= count or triangles.min(initial=0) < 0:
        worst = worst if worst >= count else int(triangles.min())
        raise MeshFileError("", f"a triangle at vertex {worst}", f"vertices from 0 to {count - 1}")
