"""Panels that touch: a failure in the flat sheet and on the way, not at the end of the motion.

There panels may touch, but not pass through each other.
"""

import json
from pathlib import Path

import numpy as np
import pytest

from brute_force import distance_of_panels, exact_contacts
from orishell.clash import overlap_depths
from orishell.document.from_design import document_of_motion
from orishell.io import write_fold
from orishell.motion import FoldingMotion
from planted import PLANTED
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
    assert found["crossing_at_end"] == []
    assert any(text.startswith("the order of panels") for text in inspection.not_checked)


@pytest.mark.parametrize("before", [[FLAT, OPEN], [FLAT], []])
def test_panels_that_pass_through_each_other_at_the_end_fail(
    before: list[list[list[float]]], tmp_path: Path
) -> None:
    # A file of one folded frame is tested, too.
    inspection = inspect(strip(*before, PIERCING), tmp_path)
    assert failed(inspection) == {"clash"}
    found = facts(inspection, "clash")
    assert found["contacts"] == []
    assert found["crossing_at_end"] == found["contacts_at_end"]
    assert found["crossing_at_end"][0]["frame"] == len(before)
    # The last panel's line, (2, 1) to (0.8, -0.6), is moved clear of the first panel by the way
    # from its end up to that panel, 0.6.
    assert (
        "panels 0 and 2 pass through each other at the end of the motion, by 6.0e-01"
        in (found["text"])
    )


def test_the_tolerance_decides_on_how_deep_is_through(tmp_path: Path) -> None:
    # The last panel's end, 1e-4 below the first one: of a diagonal of 5.1.
    angle = np.arcsin((1 + 1e-4) / 2)
    through = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [2 - 2 * np.cos(angle), -1e-4]]
    assert failed(inspect(strip(FLAT, through), tmp_path)) == {"clash"}
    assert inspect(strip(FLAT, through), tmp_path, tolerance=1e-4).passed


def test_panels_flat_on_each_other_touch(tmp_path: Path) -> None:
    # Folded up to a pile, whatever the order of its layers.
    pile = [[0.0, 0.0], [2.0, 0.0], [1.0, 0.0], [3.0, 0.0]]
    inspection = inspect(strip(FLAT, pile), tmp_path)
    assert inspection.passed
    assert len(facts(inspection, "clash")["contacts_at_end"][0]["pairs"]) == 3


def test_how_deep_panels_reach_into_each_other() -> None:
    # Random pairs of rectangles, many of which cross: moved by that depth in the best direction
    # they touch, and by less in none. Directions are all normals of faces and of two edges, from
    # scratch; distances are by quadratic programming.
    rng = np.random.default_rng(8)
    deep = 0
    for _ in range(60):
        turns = np.linalg.qr(rng.normal(size=(2, 3, 3)))[0]
        size = rng.uniform(0.5, 2, (2, 2))
        square = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
        flat = [0.5 * square * each for each in size]
        panels = [
            corners @ turn[:2] + shift
            for corners, turn, shift in zip(
                flat, turns, rng.uniform(-0.5, 0.5, (2, 3)), strict=True
            )
        ]
        points = np.concatenate(panels)
        faces = np.arange(8).reshape(2, 4)
        depth = float(overlap_depths(points, faces, np.array([[0, 1]]))[0])
        crosses = bool(len(exact_contacts(points, faces)))
        assert (depth > 0) == crosses
        if not crosses:
            continue
        deep += 1
        ways = rng.normal(size=(400, 3))
        ways /= np.linalg.norm(ways, axis=1, keepdims=True)
        for way in ways:  # less than the depth never clears them
            moved = np.concatenate([panels[0], panels[1] + 0.999 * depth * way])
            assert len(exact_contacts(moved, faces))
        edges = [np.diff(panel[:3], axis=0) for panel in panels]
        crossed = [np.cross(u, v) for u in edges[0] for v in edges[1]]
        best = [np.cross(*edges[0]), np.cross(*edges[1]), *crossed]
        clear = max(
            distance_of_panels(panels[0], panels[1] + sign * 1.001 * depth * n / np.linalg.norm(n))
            for n in best
            for sign in (1, -1)
        )
        assert clear > 0.5e-3 * depth
    assert deep > 15


@pytest.mark.parametrize("name", PLANTED)
def test_planted_shells_beyond_their_first_contact_fail(name: str, tmp_path: Path) -> None:
    # Two frames, flat and run through itself: dozens of pairs cross.
    write_fold(
        tmp_path / "shell.fold",
        document_of_motion(FoldingMotion(PLANTED[name]().mechanism, 2), "m"),
    )
    fold = json.loads((tmp_path / "shell.fold").read_text())
    mechanism = PLANTED[name]().mechanism
    folded = mechanism.positions(0.99 * np.pi).reshape(-1, 3)
    fold["file_frames"][-1]["vertices_coords"] = folded.tolist()
    del fold["edges_foldAngle"], fold["file_frames"][-1]["edges_foldAngle"]
    inspection = inspect({**fold, "file_frames": fold["file_frames"][-1:]}, tmp_path)
    assert failed(inspection) == {"clash"}
    crossing = facts(inspection, "clash")["crossing_at_end"][0]["pairs"]
    exact = {
        tuple(pair) for pair in exact_contacts(folded, mechanism.grid.faces_vertices()).tolist()
    }
    assert {tuple(pair["panels"]) for pair in crossing} & exact


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
