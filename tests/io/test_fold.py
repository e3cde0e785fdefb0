"""shell.fold, key by key as the contract says."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from orishell.document.from_design import document_of_motion
from orishell.families.parallel_repeating import ParallelRepeatingPattern, design_parallel_repeating
from orishell.io import write_fold
from orishell.motion import FoldingMotion, measure_fold_angles
from strategies import graph

M, N, FRAMES = 5, 7, 4


@pytest.fixture(scope="module")
def motion() -> FoldingMotion:
    design = design_parallel_repeating(
        graph("-x**2", -1, 1),
        graph("2*sin(pi*x/10)", 0, 20),
        ParallelRepeatingPattern(rows=M, columns=N, xi_deg=np.rad2deg(0.8), flap=0.3),
    )
    return FoldingMotion(design.mechanism, FRAMES)


@pytest.fixture(scope="module")
def fold(motion: FoldingMotion, tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    path: Path = tmp_path_factory.mktemp("fold") / "shell.fold"
    write_fold(path, document_of_motion(motion, "m"))
    content: dict[str, Any] = json.loads(path.read_text())
    return content


def test_key_frame(fold: dict[str, Any]) -> None:
    assert fold["file_spec"] == 1.2
    assert fold["frame_classes"] == ["creasePattern"]
    assert fold["frame_unit"] == "m"
    assert fold["orishell:grid_shape"] == [M + 2, N + 2]
    vertices = np.array(fold["vertices_coords"])
    assert vertices.shape == ((M + 2) * (N + 2), 2)
    edges = len(fold["edges_vertices"])
    assert len(fold["edges_assignment"]) == len(fold["edges_foldAngle"]) == edges
    assert len(fold["faces_vertices"]) == len(fold["faces_edges"]) == (M + 1) * (N + 1)


def test_two_columns_without_flaps(tmp_path: Path) -> None:
    design = design_parallel_repeating(
        graph("-x**2", -1, 1),
        graph("x/2", 0, 3),
        ParallelRepeatingPattern(rows=1, columns=2, xi_deg=np.rad2deg(0.8), flap=0),
    )
    motion = FoldingMotion(design.mechanism, 2)
    write_fold(tmp_path / "shell.fold", document_of_motion(motion, "m"))
    content = json.loads((tmp_path / "shell.fold").read_text())
    assert content["orishell:grid_shape"] == [3, 2]
    assert "".join(content["edges_assignment"]) in {"BMBBBBB", "BVBBBBB"}
    assert len(content["faces_vertices"]) == 2


def test_faces_are_counter_clockwise(fold: dict[str, Any]) -> None:
    corners = np.array(fold["vertices_coords"])[np.array(fold["faces_vertices"])]
    x, y = corners[..., 0], corners[..., 1]
    area = (x * np.roll(y, -1, axis=1) - np.roll(x, -1, axis=1) * y).sum(axis=1)
    assert (area > 0).all()


def test_assignment_follows_the_fold_angle(fold: dict[str, Any]) -> None:
    letters, angles = np.array(fold["edges_assignment"]), np.array(fold["edges_foldAngle"])
    assert set(letters) == {"B", "M", "V", "F"}
    assert (angles[letters == "V"] > 0).all()
    assert (angles[letters == "M"] < 0).all()
    np.testing.assert_allclose(angles[(letters == "B") | (letters == "F")], 0, atol=1e-7)
    np.testing.assert_allclose(np.abs(angles).max(), 180, atol=1e-6)
    faces = np.bincount(np.array(fold["faces_edges"]).ravel())
    np.testing.assert_array_equal(letters == "B", faces == 1)


def test_frames_go_from_flat_to_locked(fold: dict[str, Any], motion: FoldingMotion) -> None:
    frames = fold["file_frames"]
    assert [frame["orishell:drive_deg"] for frame in frames] == [0, 60, 120, 180]
    for frame, state in zip(frames, motion, strict=True):
        assert frame["frame_classes"] == ["foldedForm"]
        assert frame["frame_parent"] == 0
        assert frame["frame_inherit"] is True
        # Full double precision: reading back gives the same bits.
        found = np.array(frame["vertices_coords"]).reshape(M + 2, N + 2, 3)
        np.testing.assert_array_equal(found, state.positions)
    flat = np.array(frames[0]["vertices_coords"])
    np.testing.assert_array_equal(flat[:, :2], fold["vertices_coords"])
    assert not flat[:, 2].any()
    assert not np.any(frames[0]["edges_foldAngle"])
    np.testing.assert_array_equal(frames[-1]["edges_foldAngle"], fold["edges_foldAngle"])


def test_fold_angles_are_those_of_the_coordinates(fold: dict[str, Any]) -> None:
    for frame in fold["file_frames"][1:-1]:
        positions = np.array(frame["vertices_coords"]).reshape(M + 2, N + 2, 3)
        measured = np.rad2deg(measure_fold_angles(positions).on_edges())
        np.testing.assert_allclose(frame["edges_foldAngle"], measured, atol=1e-9)


def test_no_negative_zero_and_no_line_ending_surprises(
    motion: FoldingMotion, tmp_path: Path
) -> None:
    first, second = tmp_path / "a.fold", tmp_path / "b.fold"
    write_fold(first, document_of_motion(motion, "mm"))
    write_fold(second, document_of_motion(motion, "mm"))
    content = first.read_bytes()
    assert content == second.read_bytes()
    assert b"-0.0," not in content
    assert b"-0.0]" not in content
    assert content.endswith(b"\n")
