"""Panels that touch: a failure in the flat sheet and on the way, not at the end of the motion."""

from pathlib import Path

import pytest

from sheets import facts, failed, inspect, strip

FLAT = [[0.0, 0.0], [2.0, 0.0], [3.0, 0.0], [5.0, 0.0]]
OPEN = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.8, 2.6]]
"""Panels of length 2, 1 and 2: an open mouth (a 3-4-5 triangle)."""
PIERCING = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.8, -0.6]]
"""The last panel comes down through the first."""
TOUCHING = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [2 - 3**0.5, 0.0]]
"""The last panel's end lies on the first panel."""


def test_the_strips_are_rigid(tmp_path: Path) -> None:
    inspection = inspect(strip(FLAT, OPEN, PIERCING, TOUCHING, OPEN), tmp_path)
    assert failed(inspection) == {"clash"}


@pytest.mark.parametrize("profile", [PIERCING, TOUCHING])
def test_contact_on_the_way_fails(profile: list[list[float]], tmp_path: Path) -> None:
    inspection = inspect(strip(FLAT, OPEN, profile, OPEN), tmp_path)
    assert failed(inspection) == {"clash"}
    found = facts(inspection, "clash")
    assert found["contacts"] == [{"frame": 2, "count": 1, "pairs": [{"panels": [0, 2]}]}]
    assert found["contacts_at_end"] == []
    assert found["text"].startswith("panels 0 and 2 touch in frame 2")


def test_contact_at_the_end_is_reported(tmp_path: Path) -> None:
    inspection = inspect(strip(FLAT, OPEN, TOUCHING), tmp_path)
    assert inspection.passed
    found = facts(inspection, "clash")
    assert found["contacts_at_end"] == [{"frame": 2, "count": 1, "pairs": [{"panels": [0, 2]}]}]
    assert "contact at the end of the motion" in found["text"]
    assert "whether panels that touch at the end of the motion also cross" in inspection.not_checked


def test_a_pair_that_touches_on_the_way_and_at_the_end(tmp_path: Path) -> None:
    inspection = inspect(strip(FLAT, PIERCING, OPEN, TOUCHING), tmp_path)
    assert failed(inspection) == {"clash"}
    assert facts(inspection, "clash")["contacts"][0]["frame"] == 1


def test_the_end_may_stand_in_several_frames(tmp_path: Path) -> None:
    # A locked key frame for show, and the motion held at its end: the same fold angles.
    moved = [[x + 7, z + 1] for x, z in TOUCHING]
    inspection = inspect(strip(TOUCHING, FLAT, OPEN, TOUCHING, moved), tmp_path)
    assert inspection.passed
    assert [each["frame"] for each in facts(inspection, "clash")["contacts_at_end"]] == [0, 3, 4]


def test_a_motion_that_ends_flat_has_its_end_first(tmp_path: Path) -> None:
    assert inspect(strip(FLAT, TOUCHING, OPEN, FLAT), tmp_path).passed
    assert not inspect(strip(FLAT, OPEN, TOUCHING, OPEN, FLAT), tmp_path).passed


def test_overlap_in_the_flat_sheet_fails(tmp_path: Path) -> None:
    # Two separate squares, one half over the other; and a strip that turns back on itself.
    squares = {
        "vertices_coords": [[0, 0], [2, 0], [2, 2], [0, 2], [1, 1], [3, 1], [3, 3], [1, 3]],
        "faces_vertices": [[0, 1, 2, 3], [4, 5, 6, 7]],
    }
    inspection = inspect(squares, tmp_path)
    assert failed(inspection) == {"clash"}
    assert facts(inspection, "clash")["contacts"][0]["frame"] == 0
    back = strip([[0.0, 0.0], [2.0, 0.0], [1.0, 0.0], [3.0, 0.0]], OPEN)
    back["frame_classes"] = ["creasePattern"]
    assert {"flat", "clash"} <= failed(inspect(back, tmp_path))


def test_panels_are_named_by_row_and_column(tmp_path: Path) -> None:
    fold = {**strip(FLAT, PIERCING, OPEN), "orishell:grid_shape": [2, 4]}
    found = facts(inspect(fold, tmp_path), "clash")
    assert found["contacts"][0]["pairs"] == [{"panels": [0, 2], "grid": [[0, 0], [0, 2]]}]
    assert found["text"].startswith("panels 0 [0, 0] and 2 [0, 2] touch")
