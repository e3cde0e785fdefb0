"""Files of meshes: OBJ, STL and PLY, read by meshio, and glTF."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.source_file import require_source_file
from orishell.design.gltf_mesh import read_gltf
from orishell.numerics.arrays import Array, Integers

ENDINGS = (".obj", ".stl", ".ply", ".glb", ".gltf")
LARGEST = 100_000_000
"""Bytes of a file, at most."""


def read_mesh(path: Path) -> tuple[Array, Integers]:
    """Vertices (V, 3) and triangles (T, 3) of a file; polygons are cut into fans of triangles.

    Raises
    ------
    InputError
        If there is no mesh in it.
    """
    if path.suffix.lower() not in ENDINGS:
        raise _refused(path, "this kind of file holds no mesh that is read here", path.suffix)
    try:
        require_source_file(path, "file", LARGEST)
    except InputError as error:
        raise error.at_key("mesh", "mesh").in_file(path) from None
    if path.suffix.lower() in (".glb", ".gltf"):
        return read_gltf(path)
    import meshio

    try:
        with np.errstate(all="ignore"):  # of a text STL, meshio takes eight letters for a number
            mesh = meshio.read(path)
    except (Exception, SystemExit) as error:  # meshio ends the program itself on some faults
        raise _refused(path, "the file holds no mesh that can be read", str(error)[:80]) from None
    triangles = [
        fan
        for block in mesh.cells
        if block.type in ("triangle", "quad") or block.type.startswith("polygon")
        for fan in _fans(np.asarray(block.data))
    ]
    points = np.asarray(mesh.points, np.float64)
    if not triangles or points.ndim != 2 or points.shape[1] != 3:
        raise _refused(path, "the file holds no triangles in space", f"{len(points)} points")
    found = np.concatenate(triangles).astype(np.int64)
    if found.min() < 0 or found.max() >= len(points):
        raise _refused(path, "a triangle names a vertex that is not there", str(found.max()))
    return points, found


def _fans(polygons: Integers) -> list[Integers]:
    """Polygons (P, N) as triangles, N - 2 each."""
    return [polygons[:, [0, k, k + 1]] for k in range(1, polygons.shape[1] - 1)]


def _refused(path: Path, what: str, got: str) -> InputError:
    return InputError(
        what,
        file=path,
        keys=("mesh",),
        where="mesh",
        got=got,
        expected="an OBJ, STL, PLY or glTF file with one open piece of surface",
    )
