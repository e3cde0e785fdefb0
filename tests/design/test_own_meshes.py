"""Files of shells that are written here come back as they were, and others may say what is up."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from documents import FAMILIES, demo_document
from orishell.conventions.errors import InputError
from orishell.conventions.quantities import conversion
from orishell.design import MeshSurface
from orishell.design.mesh_files import read_mesh
from orishell.design_file.file import check_design
from orishell.io.format import Settings
from orishell.io.formats.gltf import write_gltf
from orishell.io.formats.obj import write_obj
from orishell.io.formats.ply import write_ply
from orishell.io.formats.stl import write_stl
from orishell.numerics.arrays import Array
from vaulted_roof import AREA, POINTS, TRIANGLES

WRITERS = {".obj": write_obj, ".ply": write_ply, ".stl": write_stl, ".glb": write_gltf}
DIGITS = {".obj": 0.0, ".ply": 0.0, ".stl": 1e-7, ".glb": 1e-6}
"""What the format leaves of coordinates, as a share of the shell."""


@pytest.mark.parametrize("ending", WRITERS)
@pytest.mark.parametrize("family", FAMILIES)
def test_a_shell_that_was_written_comes_back_where_it_was(
    family: str, ending: str, tmp_path: Path
) -> None:
    document = demo_document(family)
    WRITERS[ending](tmp_path / f"shell{ending}", document, Settings(state="target"))
    file = read_mesh(tmp_path / f"shell{ending}")
    there = file.vertices * conversion(file.unit, document.unit)
    corners = document.in_world(document.shell.positions)[document.mesh.faces].reshape(-1, 3)
    size = float(np.linalg.norm(np.ptp(corners, axis=0)))
    assert _farthest(there[file.triangles].reshape(-1, 3), corners) <= DIGITS[ending] * size
    assert _farthest(corners, there) <= DIGITS[ending] * size


def _farthest(points: Array, others: Array) -> float:
    """How far the farthest of points (N, 3) is from the nearest of others (M, 3)."""
    from scipy.spatial import KDTree

    return float(np.max(KDTree(others).query(points)[0]))


@pytest.mark.parametrize("ending", WRITERS)
def test_a_sheet_that_was_written_is_one_piece_again(ending: str, tmp_path: Path) -> None:
    document = demo_document()
    WRITERS[ending](tmp_path / f"shell{ending}", document, Settings(state="flat"))
    file = read_mesh(tmp_path / f"shell{ending}")
    surface = MeshSurface.of(file.vertices, file.triangles)
    flat = document.state("flat").positions[document.mesh.faces]
    assert len(surface.piece.vertices) == len(np.unique(document.mesh.faces))
    a, b, c, d = np.moveaxis(flat, 1, 0)
    area = 0.5 * np.linalg.norm(np.cross(c - a, d - b), axis=1).sum()
    area *= conversion(document.unit, file.unit) ** 2
    assert surface.area() == pytest.approx(area, rel=1e-6)


def _obj(remark: str = "", *, up: str = "y") -> str:
    x, y, z = POINTS.T
    points = np.stack([x, z, -y], axis=-1) if up == "y" else POINTS
    lines = ["v {} {} {}".format(*point) for point in points.tolist()]
    faces = ["f {} {} {}".format(*each) for each in (TRIANGLES + 1).tolist()]
    return "\n".join([f"# {remark}", *lines, *faces, ""])


def _surface(path: Path, text: str, **keys: Any) -> MeshSurface:
    (path / "roof.obj").write_text(text)
    tables = {
        "shell": {"family": "flat-foldable", "unit": "m"},
        "target": {"surface": {"mesh": "roof.obj", **keys}},
        "pattern": {"rows": 7, "columns": 7},
    }
    surface = check_design(tables, path / "x.toml").surface
    assert isinstance(surface, MeshSurface)
    assert surface.area() == pytest.approx(AREA, rel=1e-6)
    return surface


def _stands(surface: MeshSurface) -> bool:
    extents = np.ptp(surface.piece.vertices, axis=0)
    return bool(np.allclose(extents, [4, 3, 0.75]))


def test_a_mesh_with_y_up_is_turned_where_that_is_said(tmp_path: Path) -> None:
    said = _surface(tmp_path, _obj("Unit: m. Up: y."))
    assert _stands(said)
    assert said.notes == ()
    asked = _surface(tmp_path, _obj(), up="y")
    assert _stands(asked)
    assert asked.notes == ()
    np.testing.assert_allclose(np.sort(asked.piece.vertices[:, 2]), np.sort(POINTS[:, 2]))


def test_a_mesh_that_lies_on_its_side_draws_a_warning(tmp_path: Path) -> None:
    lying = _surface(tmp_path, _obj())
    assert not _stands(lying)
    assert '(up = "y" in [target.surface])' in lying.notes[0]
    assert _surface(tmp_path, _obj(), up="z").notes == ()
    standing = _surface(tmp_path, _obj(up="z"))
    assert _stands(standing)
    assert standing.notes == ()


def test_up_is_offered_where_it_was_tried(tmp_path: Path) -> None:
    """A rectangle in plan of a mesh that lies on its side has no height over its places."""
    part = {"x": [-1, 1], "y": [-1, 1]}
    with pytest.raises(InputError) as refused:
        _surface(tmp_path, _obj(), **part)
    assert refused.value.remedy.startswith('up = "y" if y points up in it, or ')
    with pytest.raises(InputError) as refused:
        _surface(tmp_path, _obj(), x=[-9, 9], y=[-9, 9])
    assert "up =" not in refused.value.remedy


def test_a_unit_in_a_remark_counts_unless_the_design_says_another(tmp_path: Path) -> None:
    text = _obj("Unit: cm. Up: y.")
    (tmp_path / "roof.obj").write_text(text)
    surface = {"mesh": "roof.obj"}
    shell = {"family": "flat-foldable", "unit": "m"}
    sizes = []
    for unit in ({}, {"unit": "m"}, {"unit": "mm"}):
        tables = {
            "shell": shell,
            "target": {"surface": {**surface, **unit}},
            "pattern": {"rows": 7, "columns": 7},
        }
        made = check_design(tables, tmp_path / "x.toml").surface
        assert made is not None
        sizes.append(float(np.ptp(made.piece.vertices[:, 0])))
    assert sizes == pytest.approx([0.04, 4, 0.004])
