"""The table [target.surface]: which keys go together, files, units, and what is refused."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import meshio
import numpy as np
import pytest

from orishell.conventions.errors import InputError
from orishell.design import FormulaSurface
from orishell.design_file.file import DesignFile, check_design
from surface_files import obj

CAP = {"formula": "sqrt(4 - x**2 - y**2)", "x": [-1, 1], "y": [-1, "sqrt(2)/2"]}


def checked(surface: dict[str, Any], path: Path = Path("x.toml"), **more: Any) -> DesignFile:
    shell = {"family": "flat-foldable", "unit": "m"}
    tables = {"shell": shell, "target": {"surface": surface}, "pattern": {"rows": 7, "columns": 7}}
    return check_design({**tables, **more}, path)


def test_a_formula_is_a_surface_and_stays_the_same_while_the_pattern_changes() -> None:
    file = checked(CAP)
    assert file.surface is not None
    assert file.surface.size() == pytest.approx(2.7, abs=0.1)
    assert file.changed({"pattern.rows": 9}).surface is file.surface
    other = file.changed({"target.surface.scale": 2.0}).surface
    assert other is not None
    assert other.size() == pytest.approx(2 * file.surface.size())


@pytest.mark.parametrize("kind", ["formula", "mesh", "rectangle"])
def test_lengths_along_x_y_and_z_may_have_factors_of_their_own(kind: str, tmp_path: Path) -> None:
    """Also over a rectangle that is turned, which becomes a parallelogram; normals stay square."""
    (tmp_path / "mesh.obj").write_text(obj())
    part = {"centre": [0, 0], "size": [0.6, 0.4], "turn_deg": 30}
    tables: dict[str, dict[str, Any]] = {
        "formula": {"formula": CAP["formula"], **part},
        "mesh": {"mesh": "mesh.obj"},
        "rectangle": {"mesh": "mesh.obj", **part},
    }
    table = tables[kind]
    factors = [2.0, 0.5, 3.0]
    one, other = (
        checked({**table, "scale": scale}, tmp_path / "x.toml").surface for scale in (1.0, factors)
    )
    assert one is not None
    assert other is not None
    assert np.ptp(other.piece.vertices, axis=0) == pytest.approx(
        np.ptp(one.piece.vertices, axis=0) * factors, rel=1e-12
    )
    if isinstance(one, FormulaSurface):
        u, v = np.linspace(*one.second, 5)[:, None], np.linspace(*one.first, 5)[None, :]
        assert other.points(u, v) == pytest.approx(one.points(u, v) * factors, rel=1e-12)
    p = other.piece
    a, b, c = np.moveaxis(p.vertices[p.triangles], 1, 0)
    facing = np.cross(b - a, c - a)
    facing /= np.linalg.norm(facing, axis=1)[:, None]
    along = np.einsum("tki,ti->tk", p.normals[p.triangles], facing)
    assert along.min() > 0.7


def test_three_formulas_make_what_is_no_graph() -> None:
    barrel = {"formula": ["v", "cos(u)", "sin(u)"], "u": [0, "pi"], "v": [0, 3]}
    surface = checked(barrel).surface
    assert surface is not None
    assert surface.area() == pytest.approx(3 * np.pi, rel=1e-3)


@pytest.mark.parametrize("ending", ["obj", "stl", "ply"])
def test_a_mesh_comes_from_a_file_in_its_own_unit(tmp_path: Path, ending: str) -> None:
    x, y = np.meshgrid(np.linspace(0, 2000, 5), np.linspace(0, 1000, 4))
    points = np.column_stack([x.ravel(), y.ravel(), 0 * x.ravel()])
    number = np.arange(20).reshape(4, 5)
    quads = np.stack([number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]], axis=-1)
    quads = quads.reshape(-1, 4)
    triangles = np.concatenate([quads[:, :3], quads[:, [0, 2, 3]]])
    cells = [("triangle", triangles)] if ending == "stl" else [("quad", quads)]
    meshio.Mesh(points, cells).write(tmp_path / f"roof.{ending}")
    surface = checked({"mesh": f"roof.{ending}", "unit": "mm"}, tmp_path / "x.toml").surface
    assert surface is not None
    assert surface.area() == pytest.approx(2.0)


@pytest.mark.parametrize(
    ("surface", "key"),
    [
        ({"formula": "x*y", "x": [-1, 1]}, "target.surface.y"),
        ({**CAP, "mesh": "roof.obj"}, "target.surface"),
        ({**CAP, "unit": "mm"}, "target.surface.unit"),
        ({**CAP, "size": [1, 1]}, "target.surface.size"),
        ({**CAP, "turn_deg": 10}, "target.surface.turn_deg"),
        ({**CAP, "formula": "x*q"}, "target.surface.formula"),
        ({**CAP, "x": [1, -1]}, "target.surface.x"),
        ({**CAP, "x": [-3, 3]}, "target.surface.formula"),
        ({"mesh": "roof.obj", "x": [0, 1]}, "target.surface.y"),
        ({"mesh": "roof.obj", "centre": [0, 1]}, "target.surface.centre"),
        ({"mesh": "roof.obj", "size": [1, 1], "x": [0, 1]}, "target.surface.size"),
        (
            {"mesh": "roof.obj", "size": [1, 1], "corners": [[0, 0, 0]] * 4},
            "target.surface.corners",
        ),
        ({**CAP, "turn_deg": "auto"}, "target.surface.turn_deg"),
        ({"mesh": "roof.docx"}, "target.surface.mesh"),
        ({"mesh": "missing.obj"}, "target.surface.mesh"),
    ],
)
def test_what_does_not_fit_is_refused_at_its_key(surface: dict[str, Any], key: str) -> None:
    with pytest.raises(InputError) as refused:
        checked(surface)
    assert refused.value.keys == (key,)


def test_f_and_a_surface_exclude_each_other() -> None:
    f = {"formula": "x", "range": [0, 1]}
    with pytest.raises(InputError, match="either f and g, or a surface"):
        checked(CAP, target={"surface": CAP, "f": f})


def test_files_are_not_opened_where_they_may_not_be() -> None:
    tables = {
        "shell": {"family": "flat-foldable", "unit": "m"},
        "target": {"surface": {"mesh": "roof.obj"}},
        "pattern": {"rows": 7, "columns": 7},
    }
    with pytest.raises(InputError, match="files are not opened here"):
        check_design(tables, Path("x.toml"), files=False)


def test_a_rectangle_of_a_mesh_is_in_the_unit_of_the_mesh(tmp_path: Path) -> None:
    (tmp_path / "roof.obj").write_text(obj())
    roof = {"mesh": "roof.obj", "unit": "mm"}
    ranges = checked({**roof, "x": [-0.5, 0.3], "y": [-1, 0.2]}, tmp_path / "x.toml").surface
    turned = {**roof, "size": [0.8, 1.2], "centre": [-0.1, -0.1], "turn_deg": 20}
    surface = checked(turned, tmp_path / "x.toml").surface
    assert ranges is not None
    assert surface is not None
    assert np.ptp(ranges.piece.vertices[:, 0]) == pytest.approx(0.8e-3)
    assert np.ptp(ranges.piece.vertices[:, 1]) == pytest.approx(1.2e-3)
    assert surface.piece.extents == pytest.approx((0.8e-3, 1.2e-3), rel=0.1)


def test_an_open_turn_is_tried_at_a_few_angles_of_which_some_need_not_fit(tmp_path: Path) -> None:
    (tmp_path / "roof.obj").write_text(obj())
    roof = {"mesh": "roof.obj", "turn_deg": "auto"}
    file = checked({**roof, "size": [1, 0.8]}, tmp_path / "x.toml")
    assert file.turns == (0, 30, 60, 90, 120, 150)
    assert checked({**roof, "size": [1, 1]}, tmp_path / "x.toml").turns == (0, 30, 60)
    assert file.changed({"target.surface.turn_deg": 30}).turns == ()
    with pytest.raises(InputError, match="ends within"):
        checked({**roof, "size": [4, 4]}, tmp_path / "x.toml")
