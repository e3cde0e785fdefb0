"""Shells far from the origin: as rigid as beside it, and files as exact as their numbers can be.

A curve drawn at 1e9 is rounded to 1.2e-7 by whoever draws it; everything after that is exact.
"""

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pygltflib
import pytest
from hypothesis import given
from hypothesis import strategies as st

from orishell.curves import trace_curve
from orishell.design_file.file import check_design
from orishell.deviation import measure_deviation
from orishell.io import read_fold
from orishell.io.format import Settings
from orishell.io.formats import find_formats
from orishell.io.view import dump_view
from orishell.numerics.arrays import nearby_origin
from orishell.shell.export import convert_fold, write_format
from orishell.shell.make import Shell, make_shell
from orishell.shell.steps import MEASURES
from orishell.verification import inspect_fold
from strategies import graph, pair

FAMILIES: dict[str, tuple[tuple[str, str, list[float]], tuple[str, str, list[float]], Any]] = {
    "parallel-repeating": (
        ("t", "-t**2", [-1, 1]),
        ("t", "5*sin(pi*t/10)", [0, 20]),
        {"rows": 5, "columns": 7, "flap": 0.3, "xi_deg": 50},
    ),
    "orthodiagonal": (
        ("t", "-t**2", [-1, 1]),
        ("t", "0.25*sin(pi*t/2)", [0, 4]),
        {"rows": 5, "columns": 9, "flap": 0.15, "depth": 0.12},
    ),
    "longitudinal-linear-repeating": (
        ("cos(t)", "sin(t)", [0.3, 2.8416]),
        ("t", "0*t", [0, 2.93]),
        {"rows": 7, "columns": 9, "sector_deg": [85, 80, 95, 100], "column_lengths": [1] * 8},
    ),
}
PLACES = [1e7, 1e9]


@cache
def shell(family: str, at: float) -> Shell:
    """A figure of the paper, of fewer panels, with both curves moved by ``at`` along x and y."""
    f, g, pattern = FAMILIES[family]
    targets = {
        name: {"formula": [f"{at!r} + {x}", f"{at!r} + {y}"], "range": ends}
        for name, (x, y, ends) in (("f", f), ("g", g))
    }
    tables = {
        "shell": {"family": family, "unit": "m"},
        "target": targets,
        "pattern": pattern,
        "motion": {"frames": 5},
    }
    return make_shell(check_design(tables, Path("far.toml")), skip=(*MEASURES, "stock"))


def written(shell: Shell, name: str, directory: Path) -> Path:
    (format_,) = find_formats([name])
    write_format(shell, format_, directory, Settings())
    return directory / format_.file


@pytest.mark.parametrize("family", FAMILIES)
@pytest.mark.parametrize("at", PLACES)
def test_residuals_are_those_at_the_origin(family: str, at: float) -> None:
    here, there = shell(family, 0.0), shell(family, at)
    for key, limit in (("panel_length", 1e-15), ("planarity", 1e-15), ("fold_angle_rad", 3e-14)):
        assert getattr(here.report.residuals, key) < limit
        assert getattr(there.report.residuals, key) < limit
    assert there.report.lock.cause == here.report.lock.cause
    # The curves are off by the rounding of their own coordinates, and so is what follows them.
    digit = np.spacing(at)
    for key in ("f", "g"):
        before, after = (each.design.closeness[key].max for each in (here, there))
        assert after == pytest.approx(before, abs=100 * digit)
    before, after = (measure_deviation(each.design, samples=2000).rms for each in (here, there))
    assert after == pytest.approx(before, rel=1e-3)


@pytest.mark.parametrize("family", FAMILIES)
@pytest.mark.parametrize("at", PLACES)
def test_fold_has_world_coordinates_and_check_says_how_many_digits(
    family: str, at: float, tmp_path: Path
) -> None:
    far = shell(family, at)
    file = read_fold(written(far, "fold", tmp_path))
    locked = far.motion.target.positions.reshape(-1, 3)
    world = file.frames[-1].positions
    np.testing.assert_array_equal(world, locked + far.design.origin)
    # g is where it was drawn: its first point is the middle row's first vertex, in plan.
    g = far.file.g.position(np.array([far.file.g.start]))[0]
    assert np.abs(far.design.targets["g"][0, :2] + far.design.origin[:2] - g).max() == 0
    found = inspect_fold(file)
    assert found.passed
    digit = np.spacing(np.abs(world).max()) / found.sheet.diagonal
    lengths = next(check for check in found.checks if check.name == "panel_length")
    assert 0.1 * digit < lengths.facts["worst"] < 4 * digit
    assert any(f"better than {digit:.1e} of the diagonal" in text for text in found.not_checked)


def test_check_says_nothing_of_digits_beside_the_origin(tmp_path: Path) -> None:
    file = read_fold(written(shell("parallel-repeating", 0.0), "fold", tmp_path))
    assert not any("digits" in text for text in inspect_fold(file).not_checked)


@pytest.mark.parametrize("at", PLACES)
def test_single_precision_formats_stay_exact(at: float, tmp_path: Path) -> None:
    far = shell("parallel-repeating", at)
    corners = far.motion.target.positions.reshape(-1, 3)[far.document.mesh.faces]
    stl = written(far, "stl", tmp_path).read_bytes()
    assert f"about ({at:g}"[:9] in stl[:80].decode()
    record = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])
    triangles = np.frombuffer(stl[84:], record)["corners"]
    offset = far.document.origin - far.document.nearby
    np.testing.assert_allclose(triangles[::2], corners[:, :3] + offset, atol=1e-5)

    glb = pygltflib.GLTF2().load(str(written(far, "glb", tmp_path)))
    root, *panels = glb.nodes
    x, y, z = far.document.nearby
    assert root.translation == [x, z, -y]
    middles = corners.mean(axis=1) + offset
    places = np.array([panel.translation for panel in panels])
    np.testing.assert_allclose(places, middles[:, [0, 2, 1]] * [1, 1, -1], atol=1e-5)

    # The same from the FOLD file alone, whose coordinates are the world's.
    convert_fold(written(far, "fold", tmp_path), tmp_path / "converted.glb")
    again = pygltflib.GLTF2().load(str(tmp_path / "converted.glb"))
    assert again.nodes[0].translation == root.translation
    converted = np.array([panel.translation for panel in again.nodes[1:]])
    np.testing.assert_allclose(converted, places, atol=1e-5 + 2 * np.spacing(at))


@pytest.mark.parametrize("at", PLACES)
def test_the_view_is_drawn_about_the_shell(at: float) -> None:
    import orjson

    far = shell("parallel-repeating", at)
    view = dump_view(far.document)
    size = int.from_bytes(view[:4], "little")
    header = orjson.loads(view[4 : 4 + size])
    place = header["arrays"]["positions"]
    count = int(np.prod(place["shape"]))
    drawn = np.frombuffer(view, "<f4", count, 4 + size + place["offset"]).reshape(place["shape"])
    locked = far.motion.target.positions.reshape(-1, 3)
    middle = (locked.min(axis=0) + locked.max(axis=0)) / 2
    np.testing.assert_allclose(drawn[-1], locked - middle, atol=1e-5)
    np.testing.assert_array_equal(header["origin"], far.design.origin + middle)


@given(
    st.lists(st.tuples(*[st.floats(-1, 1)] * 2), min_size=2, max_size=5),
    st.tuples(*[st.floats(-1e9, 1e9)] * 2),
)
def test_a_frame_beside_points_costs_no_digit(
    drawn: list[tuple[float, float]], at: tuple[float, float]
) -> None:
    points = np.array(drawn) + np.array(at)
    origin = nearby_origin(points)
    near = points - origin
    # Extents of a few units of the last place cannot be told from none.
    if np.ptp(points, axis=0).max() > 16 * np.spacing(np.abs(points).max()):
        np.testing.assert_array_equal(near + origin, points)
    assert np.abs(near).max() <= 5 * np.ptp(points, axis=0).max()


def test_a_curve_near_the_origin_stays_in_its_frame() -> None:
    trace = trace_curve(graph("-x**2", 1, 3))
    assert trace.in_own_frame() is trace


def test_a_trace_knows_where_its_frame_lies_on_the_drawing() -> None:
    trace = trace_curve(pair("1e6 + t", "t**2 - 3e6", 0, 1))
    moved = trace.in_own_frame().rotated(0.3).reversed().rotated(-0.3)
    assert np.abs(moved.points).max() < 5
    np.testing.assert_allclose(moved.points + moved.origin, trace.points[::-1], atol=1e-8)
    np.testing.assert_allclose(
        moved.curve.position(moved.t) + moved.origin, trace.points[::-1], atol=1e-8
    )


@pytest.mark.parametrize("at", [0.0, 1e6])
def test_small_panels_are_small_beside_the_sheet(at: float) -> None:
    """Columns of 1e-7 of the sheet are kept, wherever it is (1e-8 is the limit)."""
    from orishell.families.orthodiagonal import OrthodiagonalPattern, design_orthodiagonal

    f = graph("-x**2", -1, 1)
    g = pair(f"{at!r} + t", "0*t", 0, 4)
    design = design_orthodiagonal(f, g, OrthodiagonalPattern(rows=9, columns=13, flap=1e-6))
    assert design.parameters["flap"] == 1e-6
