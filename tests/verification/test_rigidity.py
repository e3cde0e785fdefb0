"""Panels that are bent, stretched or not convex, and vertices that are not developable."""

from pathlib import Path

import numpy as np
import pytest

from sheets import facts, failed, inspect, miura, shuffled, strip


def test_a_bent_panel_is_found_in_its_frame(tmp_path: Path) -> None:
    # A corner of the sheet, lifted off the plane of its panel: only panel 0 has that corner.
    fold = miura([0.3, 0.6, 0.9])
    fold["file_frames"][1]["vertices_coords"][0][2] += 1e-3
    inspection = inspect(fold, tmp_path)
    assert {"planarity", "panel_length", "fold_angle"} <= failed(inspection)
    for name in ("planarity", "panel_length"):
        found = facts(inspection, name)
        assert (found["frame"], found["panel"], found["beyond"]) == (2, 0, 1)
    # The gap between the diagonals is at most the lift; here half of it and more.
    gap = facts(inspection, "planarity")["worst"] * inspection.sheet.diagonal
    assert 2e-4 < gap < 1e-3


def test_a_stretched_panel_is_found_in_its_frame(tmp_path: Path) -> None:
    # A corner of the sheet, drawn out along an edge of its panel: it stays plane.
    fold = miura([0.3, 0.6, 0.9])
    coords = np.array(fold["file_frames"][2]["vertices_coords"])
    edge = coords[29] - coords[28]
    coords[29] += 1e-3 * edge / np.linalg.norm(edge)
    fold["file_frames"][2]["vertices_coords"] = coords.tolist()
    inspection = inspect(fold, tmp_path)
    assert failed(inspection) == {"panel_length"}
    found = facts(inspection, "panel_length")
    assert (found["frame"], found["panel"], found["beyond"]) == (3, 19, 1)
    assert found["worst"] * inspection.sheet.diagonal == pytest.approx(1e-3, rel=0.01)


def test_a_frame_in_another_size(tmp_path: Path) -> None:
    fold = miura([0.3, 0.6])
    frame = fold["file_frames"][1]
    frame["vertices_coords"] = (1.001 * np.array(frame["vertices_coords"])).tolist()
    inspection = inspect(fold, tmp_path)
    assert failed(inspection) == {"panel_length"}
    assert facts(inspection, "panel_length")["beyond"] == 20


def test_a_vertex_that_is_not_developable(tmp_path: Path) -> None:
    # Three squares at a corner of a cube: 270 degrees, so 90 are missing.
    cube = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 1, 1], [0, 0, 1], [1, 0, 1]]
    fold = {
        "vertices_coords": cube,
        "faces_vertices": [[0, 1, 2, 3], [0, 3, 4, 5], [0, 5, 6, 1]],
    }
    inspection = inspect(fold, tmp_path)
    assert failed(inspection) == {"developable"}
    found = facts(inspection, "developable")
    assert (found["vertex"], found["frame"]) == (0, 0)
    assert found["worst"] == pytest.approx(np.pi / 2)


def test_a_pattern_that_is_not_flat(tmp_path: Path) -> None:
    # It calls itself a crease pattern, but an inner vertex stands out of the plane.
    fold = {**miura([]), "frame_classes": ["creasePattern"]}
    fold["vertices_coords"] = [[x, y, 0] for x, y in fold["vertices_coords"]]
    fold["vertices_coords"][8][2] = 0.05
    inspection = inspect(fold, tmp_path)
    assert {"flat", "planarity", "developable"} <= failed(inspection)
    assert facts(inspection, "developable")["vertex"] in (8, 2, 7, 9, 14)
    assert facts(inspection, "planarity")["panel"] in (0, 1, 5, 6)


def test_a_chevron_is_not_convex_but_developable(tmp_path: Path) -> None:
    # Its sector of more than 180 degrees counts as such where the angles are added up.
    fold = {
        "vertices_coords": [[0, 0], [2, -2], [0, 3], [-2, -2], [0, -4]],
        "faces_vertices": [[0, 1, 2, 3], [0, 3, 4, 1]],
    }
    inspection = inspect(fold, tmp_path)
    assert failed(inspection) == {"convex"}
    assert facts(inspection, "convex")["panel"] == 0
    assert facts(inspection, "convex")["worst_deg"] == pytest.approx(270)
    assert "contact (some panels are not convex)" in inspection.not_checked


def test_a_straight_corner_is_convex(tmp_path: Path) -> None:
    fold = {"vertices_coords": [[0, 0], [1, 0], [2, 0], [1, 1]], "faces_vertices": [[0, 1, 2, 3]]}
    assert inspect(fold, tmp_path).passed


def test_small_panels_may_turn_more(tmp_path: Path) -> None:
    # A strip of a long, a short and a long panel; the short one's corners are rounded away
    # by a length below the tolerance, which turns it by more than the tolerance in radians.
    long, short, error = 1.0, 1e-3, 5e-7
    flat = [[0.0, 0.0], [long, 0.0], [long + short, 0.0], [2 * long + short, 0.0]]
    bent = [[0.0, 0.0], [long, 0.0], [long, short], [long, short + long]]
    bent[2] = [long + error, short]
    bent[3] = [long + error, short + long]
    fold = strip(flat, bent)
    fold["edges_vertices"] = [
        [1, 5],
        [2, 6],
        *[[k, k + 1] for k in (0, 1, 2, 4, 5, 6)],
        [0, 4],
        [3, 7],
    ]
    fold["file_frames"][0]["edges_foldAngle"] = [90, 0] + 8 * [0]
    inspection = inspect(fold, tmp_path)
    assert inspection.passed
    # Two corners moved by e turn a panel of width w by e / w.
    assert facts(inspection, "fold_angle")["worst"] == pytest.approx(error / short, rel=0.01)
    fold["file_frames"][0]["edges_foldAngle"][0] = 89
    assert failed(inspect(fold, tmp_path)) == {"fold_angle"}


@pytest.mark.parametrize("seed", range(3))
def test_the_verdict_does_not_depend_on_the_order(seed: int, tmp_path: Path) -> None:
    fold = miura([0.3, 0.6])
    fold["file_frames"][1]["vertices_coords"][14][2] += 1e-3
    straight, mixed = inspect(fold, tmp_path), inspect(shuffled(fold, seed), tmp_path)
    assert failed(straight) == failed(mixed)
    for name in ("planarity", "panel_length", "developable", "fold_angle"):
        first, second = facts(straight, name), facts(mixed, name)
        assert first["worst"] == pytest.approx(second["worst"], rel=1e-6)
        assert (first["frame"], first["beyond"]) == (second["frame"], second["beyond"])
