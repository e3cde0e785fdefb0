"""Wrong fold angles and wrong mountains and valleys."""

from pathlib import Path

import numpy as np
import pytest

from sheets import facts, failed, inspect, miura

CREASE = 13
"""An edge of the Miura sheet with two panels."""


def test_a_wrong_fold_angle_is_found_in_its_frame(tmp_path: Path) -> None:
    fold = miura([0.3, 0.6, 0.9])
    fold["file_frames"][1]["edges_foldAngle"][CREASE] += 0.1
    inspection = inspect(fold, tmp_path)
    assert failed(inspection) == {"fold_angle"}
    found = facts(inspection, "fold_angle")
    assert (found["frame"], found["edge"], found["beyond"]) == (2, CREASE, 1)
    assert found["vertices"] == fold["edges_vertices"][CREASE]
    assert found["worst"] == pytest.approx(np.deg2rad(0.1))


def test_a_fold_angle_on_the_border(tmp_path: Path) -> None:
    fold = miura([0.3])
    border = fold["edges_assignment"].index("B")
    fold["file_frames"][0]["edges_foldAngle"][border] = 5
    assert facts(inspect(fold, tmp_path), "fold_angle")["edge"] == border


def test_the_flat_sheet_gives_the_angles_of_a_folded_frame(tmp_path: Path) -> None:
    fold = miura([0.3, 0.6, 0.9])
    fold["edges_foldAngle"] = list(fold["file_frames"][2]["edges_foldAngle"])
    assert inspect(fold, tmp_path).passed
    fold["edges_foldAngle"][CREASE] *= 0.99
    inspection = inspect(fold, tmp_path)
    assert failed(inspection) == {"fold_angle"}
    found = facts(inspection, "fold_angle")
    assert (found["frame"], found["edge"]) == (0, CREASE)


def test_the_flat_sheet_may_give_angles_that_no_frame_has(tmp_path: Path) -> None:
    # Other programs give the pattern's creases 180 degrees, whatever the frames show.
    fold = miura([0.3, 0.6])
    sign = {"B": 0, "M": -180, "V": 180}
    fold["edges_foldAngle"] = [sign[letter] for letter in fold["edges_assignment"]]
    inspection = inspect(fold, tmp_path)
    assert inspection.passed
    assert "edges_foldAngle of the flat sheet (no frame folds like that)" in inspection.not_checked
    fold["edges_foldAngle"] = len(sign) * [0] + (len(fold["edges_vertices"]) - len(sign)) * [0]
    inspection = inspect(fold, tmp_path)
    assert inspection.passed


def test_unknown_fold_angles_are_not_compared(tmp_path: Path) -> None:
    fold = miura([0.3])
    fold["file_frames"][0]["edges_foldAngle"][CREASE] = None
    assert inspect(fold, tmp_path).passed
    # 0 stands for an unassigned crease.
    for frame in (fold, fold["file_frames"][0]):
        frame["edges_assignment"] = list(frame["edges_assignment"])
        frame["edges_assignment"][CREASE] = "U"
    fold["file_frames"][0]["edges_foldAngle"][CREASE] = 0
    inspection = inspect(fold, tmp_path)
    assert inspection.passed
    assert "1 creases of unknown assignment" in inspection.not_checked
    assert any("Maekawa's condition at " in text for text in inspection.not_checked)


def test_at_180_degrees_the_sign_is_undetermined(tmp_path: Path) -> None:
    # Two squares folded onto each other: in the last frame a mountain or a valley.
    square = {
        "faces_vertices": [[0, 1, 4, 3], [1, 2, 5, 4]],
        "edges_vertices": [[1, 4], [0, 1], [1, 2], [2, 5], [5, 4], [4, 3], [3, 0]],
        "edges_assignment": ["V", "B", "B", "B", "B", "B", "B"],
        "vertices_coords": [[0, 0], [1, 0], [2, 0], [0, 1], [1, 1], [2, 1]],
    }
    half = [[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 1, 0], [1, 1, 0], [1, 1, 1]]
    closed = [[0, 0], [1, 0], [0, 0], [0, 1], [1, 1], [0, 1]]
    frames = [
        {"frame_parent": 0, "frame_inherit": True, "vertices_coords": half},
        {"frame_parent": 0, "frame_inherit": True, "vertices_coords": closed},
    ]
    for degrees in (180, -180):
        frames[1]["edges_foldAngle"] = [degrees, 0, 0, 0, 0, 0, 0]
        inspection = inspect({**square, "file_frames": frames}, tmp_path)
        assert facts(inspection, "fold_angle")["passed"]
        # But what is written down must have the sign of the letter.
        assert failed(inspection) == (set() if degrees > 0 else {"assignment"})
    inspection = inspect({**square, "file_frames": frames[1:]}, tmp_path)
    assert "the sign of 1 mountains and valleys" in " ".join(inspection.not_checked)


@pytest.mark.parametrize(
    ("letter", "fails"),
    [
        ("opposite", {"assignment", "maekawa"}),
        ("F", {"assignment", "maekawa"}),
        ("B", {"assignment"}),
        ("U", set()),
    ],
)
def test_a_wrong_letter_is_found(letter: str, fails: set[str], tmp_path: Path) -> None:
    fold = miura([0.3, 0.6])
    letters = fold["edges_assignment"]
    letters[CREASE] = {"M": "V", "V": "M"}[letters[CREASE]] if letter == "opposite" else letter
    for frame in fold["file_frames"]:
        frame["edges_assignment"] = letters
    inspection = inspect(fold, tmp_path)
    assert failed(inspection) == fails
    if "assignment" in fails:
        assert facts(inspection, "assignment")["vertices"] == fold["edges_vertices"][CREASE]
    if "maekawa" in fails:
        assert facts(inspection, "maekawa")["vertex"] in fold["edges_vertices"][CREASE]


def test_a_crease_on_the_border_is_wrong(tmp_path: Path) -> None:
    fold = miura([])
    border = fold["edges_assignment"].index("B")
    fold["edges_assignment"][border] = "V"
    inspection = inspect(fold, tmp_path)
    assert failed(inspection) == {"assignment"}
    assert facts(inspection, "assignment")["edge"] == border


def test_a_sheet_that_is_seen_from_the_other_side(tmp_path: Path) -> None:
    fold = miura([0.5])
    swap = {"M": "V", "V": "M", "B": "B"}
    for frame in (fold, *fold["file_frames"]):
        frame["edges_assignment"] = [swap[letter] for letter in frame["edges_assignment"]]
    inspection = inspect(fold, tmp_path)
    assert "seen from the other side" in facts(inspection, "assignment")["text"]


def test_a_crease_that_changes_its_sign(tmp_path: Path) -> None:
    # The sheet folds one way and then, mirrored, the other way.
    fold = miura([0.3, 0.6, 0.9])
    last = fold["file_frames"][2]
    last["vertices_coords"] = (np.array(last["vertices_coords"]) * [1, 1, -1]).tolist()
    del last["edges_foldAngle"]
    for frame in (fold, *fold["file_frames"]):
        frame.pop("edges_assignment")
    inspection = inspect(fold, tmp_path)
    assert failed(inspection) == {"constant_sign"}
    assert facts(inspection, "constant_sign")["frame"] == 3
    assert "fold angles of frame 3 (no edges_foldAngle of their own)" in inspection.not_checked


def test_unfolded_creases_through_a_vertex(tmp_path: Path) -> None:
    # A square grid folded along its middle column only: two valleys and two unfolded creases.
    fold = {
        "vertices_coords": [[j, -i] for i in range(3) for j in range(3)],
        "faces_vertices": [[0, 3, 4, 1], [1, 4, 5, 2], [3, 6, 7, 4], [4, 7, 8, 5]],
        "edges_vertices": [[1, 4], [4, 7], [3, 4], [4, 5], [0, 1], [1, 2], [2, 5], [5, 8], [8, 7],
                           [7, 6], [6, 3], [3, 0]],
        "edges_assignment": ["V", "V", "F", "F", *(8 * "B")],
    }  # fmt: skip
    raised = [[min(j, 1), -i, max(j - 1, 0)] for i in range(3) for j in range(3)]
    frame = {"frame_parent": 0, "frame_inherit": True, "vertices_coords": raised}
    assert inspect({**fold, "file_frames": [frame]}, tmp_path).passed
    fold["edges_assignment"] = ["V", "M", "F", "F", *(8 * "B")]
    assert failed(inspect({**fold, "file_frames": [frame]}, tmp_path)) == {
        "assignment",
        "maekawa",
    }


def test_creases_of_unknown_assignment_are_not_said_to_fold_as_assigned(tmp_path: Path) -> None:
    fold = miura([0.4])
    for frame in (fold, *fold["file_frames"]):
        frame["edges_assignment"] = [
            "B" if each == "B" else "U" for each in frame["edges_assignment"]
        ]
    inspection = inspect(fold, tmp_path)
    assert inspection.passed
    text = facts(inspection, "assignment")["text"]
    assert text == "edges_assignment says of no crease how it folds"
    assert "31 creases of unknown assignment" in inspection.not_checked
