"""FOLD files of any origin: what frames inherit, what is refused, and what is read."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from orishell.conventions.errors import InputError
from orishell.document.from_design import document_of_motion
from orishell.families.parallel_repeating import ParallelRepeatingPattern, design_parallel_repeating
from orishell.io import FoldFile, read_fold, write_fold
from orishell.motion import FoldingMotion
from orishell.verification import inspect_fold
from strategies import graph

SQUARES: dict[str, Any] = {
    "vertices_coords": [[0, 0], [1, 0], [2, 0], [0, 1], [1, 1], [2, 1]],
    "faces_vertices": [[0, 1, 4, 3], [1, 2, 5, 4]],
    "edges_vertices": [[1, 4], [0, 1], [1, 2], [2, 5], [5, 4], [4, 3], [3, 0]],
    "edges_assignment": ["V", "B", "B", "B", "B", "B", "B"],
    "edges_foldAngle": [90, 0, 0, 0, 0, 0, 0],
}
RAISED = [[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 1, 0], [1, 1, 0], [1, 1, 1]]


def read(path: Path, content: dict[str, Any], **change: Any) -> FoldFile:
    path = path / "sheet.fold"
    path.write_text(json.dumps({**content, **change}))
    return read_fold(path)


def frame(**keys: Any) -> dict[str, Any]:
    return {"frame_parent": 0, "frame_inherit": True, **keys}


def test_our_own_file_is_read_back(tmp_path: Path) -> None:
    design = design_parallel_repeating(
        graph("-x**2", -1, 1),
        graph("2*sin(pi*x/10)", 0, 20),
        ParallelRepeatingPattern(rows=5, columns=7, xi_deg=np.rad2deg(0.8), flap=0.3),
    )
    motion = FoldingMotion(design.mechanism, 4)
    write_fold(tmp_path / "shell.fold", document_of_motion(motion, "m"))
    file = read_fold(tmp_path / "shell.fold")
    grid = motion.mechanism.grid
    assert file.unit == "m"
    assert file.grid_shape == (7, 9)
    np.testing.assert_array_equal(file.mesh.faces, grid.faces_vertices())
    np.testing.assert_array_equal(file.mesh.edges, grid.edges_vertices())
    assert file.assignment is not None
    np.testing.assert_array_equal(np.array(file.assignment) == "B", ~file.mesh.crease)
    assert [each.number for each in file.frames] == [0, 1, 2, 3, 4]
    assert [each.classes for each in file.frames] == [("creasePattern",)] + 4 * [("foldedForm",)]
    # Full double precision: reading back gives the same bits.
    for found, state in zip(file.frames[1:], motion, strict=True):
        np.testing.assert_array_equal(found.positions, state.positions.reshape(-1, 3))
        assert found.fold_angles is not None
        expected = state.fold_angles.on_edges()
        np.testing.assert_allclose(found.fold_angles, expected, atol=1e-14)
        assert not found.positions.flags.writeable


def test_two_coordinates_and_whole_numbers(tmp_path: Path) -> None:
    file = read(tmp_path, SQUARES)
    assert file.unit == "unit"
    assert file.grid_shape is None
    np.testing.assert_array_equal(file.frames[0].positions[5], [2.0, 1.0, 0.0])
    assert file.frames[0].positions.dtype == np.float64
    assert file.frames[0].fold_angles is not None
    assert file.frames[0].fold_angles[0] == pytest.approx(np.pi / 2)


def test_only_coordinates_and_faces_are_needed(tmp_path: Path) -> None:
    content = {key: SQUARES[key] for key in ("vertices_coords", "faces_vertices")}
    file = read(tmp_path, content)
    assert len(file.mesh.edges) == 7
    assert file.mesh.crease.sum() == 1
    assert file.assignment is None
    assert file.frames[0].fold_angles is None


def test_a_byte_order_mark_is_no_fault(tmp_path: Path) -> None:
    path = tmp_path / "sheet.fold"
    path.write_bytes(b"\xef\xbb\xbf" + json.dumps(SQUARES).encode())
    assert len(read_fold(path).frames) == 1


def test_a_frame_inherits_through_its_parents(tmp_path: Path) -> None:
    # Frame 1 takes its coordinates from frame 3, which comes later, and that its faces from 0.
    frames = [
        frame(frame_parent=3),
        frame(frame_title="the key frame again"),
        frame(vertices_coords=RAISED, edges_foldAngle=SQUARES["edges_foldAngle"]),
    ]
    file = read(tmp_path, SQUARES, frame_classes=["creasePattern"], file_frames=frames)
    np.testing.assert_array_equal(file.frames[1].positions, RAISED)
    assert file.frames[2].positions is file.frames[0].positions
    # What a frame is, and its fold angles, are not inherited.
    assert [each.classes for each in file.frames] == [("creasePattern",), (), (), ()]
    assert [each.fold_angles is None for each in file.frames] == [False, True, True, False]


def test_frames_may_be_complete_and_the_key_frame_empty(tmp_path: Path) -> None:
    content = {"file_spec": 1.1, "file_frames": [SQUARES, {**SQUARES, "vertices_coords": RAISED}]}
    file = read(tmp_path, content)
    assert [each.number for each in file.frames] == [1, 2]


def test_a_grid_shape_that_does_not_fit_names_nothing(tmp_path: Path) -> None:
    key = "orishell:grid_shape"
    assert read(tmp_path, SQUARES, **{key: [2, 3]}).grid_shape == (2, 3)
    for shape in ([3, 2], [2, 4], [6, 1], "2 x 3", [2.0, 3.0], None):
        assert read(tmp_path, SQUARES, **{key: shape}).grid_shape is None


def test_null_fold_angles_are_unknown(tmp_path: Path) -> None:
    file = read(tmp_path, SQUARES, edges_foldAngle=[None] + 6 * [0])
    assert file.frames[0].fold_angles is not None
    assert np.isnan(file.frames[0].fold_angles).tolist() == [True] + 6 * [False]


FAULTS: list[tuple[dict[str, Any], str]] = [
    ({"vertices_coords": []}, "vertices_coords: this list is empty"),
    ({"vertices_coords": None}, "vertices_coords: this value does not fit; got None"),
    (
        {"vertices_coords": [[0, 0], [1, 0, 0]]},
        "vertices_coords[1]: vertex 1 does not fit; got 3 numbers, expected 2",
    ),
    (
        {"vertices_coords": [[0], [1]]},
        "vertex 0 does not fit; got 1 numbers, expected 2 or 3 numbers for each vertex",
    ),
    ({"vertices_coords": [[0, 0], ["1", 0]]}, "vertices_coords[1]"),
    ({"vertices_coords": [[0, 0], [None, 0]]}, "vertices_coords[1]"),
    ({"vertices_coords": 6 * [[1e60, 0]]}, "a coordinate is too large"),
    ({"vertices_coords": 6 * [[10**400, 0]]}, "sheet.fold"),
    ({"vertices_coords": [[0, 0], [1, 0]]}, "faces_vertices[0]: there is no such vertex"),
    ({"faces_vertices": []}, "faces_vertices: this list is empty"),
    ({"faces_vertices": {}}, "faces_vertices: this value does not fit"),
    (
        {"faces_vertices": [[0, 1, 4, 3], [1, 2, 5]]},
        "faces_vertices[1]: panel 1 does not fit; got 3 whole numbers, expected 4 whole numbers",
    ),
    ({"faces_vertices": [[0, 2, 1, 5, 4, 3]]}, "panel 0 does not fit; got 6 whole numbers"),
    ({"faces_vertices": [[0, 1, 4.0, 3]]}, "panel 0 does not fit; got [0, 1, 4.0, 3]"),
    ({"faces_vertices": [[0, 1, 4, -1]]}, "numbers from 0 to 5"),
    ({"faces_vertices": [[0, 1, 4, 2**63]]}, "the numbers are too large"),
    ({"faces_vertices": [[0, 1, -4, 2**63]]}, "faces_vertices"),
    ({"faces_vertices": [[0, 1, 4, 2**70]]}, "panel 0 does not fit"),
    ({"faces_vertices": [[0, 1, 1, 3]]}, "panel 0 repeats a corner"),
    (
        {"edges_vertices": [[1, 4], [0, 1]]},
        "edges_assignment: this list does not fit; got 7 entries, expected 2",
    ),
    ({"edges_vertices": [[1, 4, 2]]}, "edge 0 does not fit; got 3 whole numbers, expected 2"),
    ({"edges_vertices": [[1, 9]]}, "edges_vertices[0]: there is no such vertex"),
    ({"edges_assignment": 7 * ["X"]}, "edges_assignment[0]: this is no assignment"),
    ({"edges_assignment": 7 * [1]}, "edges_assignment[0]: this is no assignment"),
    ({"edges_assignment": "BBBBBBB"}, "edges_assignment: this list does not fit"),
    ({"edges_foldAngle": [190] + 6 * [0]}, "edges_foldAngle[0]: a fold angle is out of range"),
    ({"edges_foldAngle": ["90"] + 6 * [0]}, "a number for each edge"),
    ({"edges_foldAngle": [True] + 6 * [0]}, "a number for each edge"),
    ({"frame_unit": 3}, "frame_unit: this value does not fit"),
    ({"frame_classes": "creasePattern"}, "frame_classes: this value does not fit"),
    ({"file_frames": {}}, "file_frames: this value does not fit"),
    ({"file_frames": [3]}, "file_frames: this value does not fit"),
    ({"file_frames": [{"frame_inherit": 1}]}, "frame 1 frame_inherit: this value does not fit"),
    ({"file_frames": [{"frame_inherit": True}]}, "frame 1 frame_parent: this frame inherits from"),
    ({"file_frames": [frame(frame_parent=1)]}, "got 1, expected the number of another frame"),
    ({"file_frames": [frame(frame_parent=7)]}, "from 0 to 1"),
    ({"file_frames": [frame(frame_parent=-1)]}, "got -1"),
    ({"file_frames": [frame(frame_parent="0")]}, "got '0'"),
    (
        {"file_frames": [frame(frame_parent=2), frame(frame_parent=3), frame(frame_parent=1)]},
        "inherit from each other in a circle; got 1 -> 2 -> 3",
    ),
    (
        {"file_frames": [{"vertices_coords": RAISED}]},
        "frame 1 faces_vertices: this key is missing. Remedy: add faces_vertices, or frame_parent",
    ),
    (
        {"file_frames": [frame(vertices_coords=RAISED[:5])]},
        "frame 1 vertices_coords: the frames differ in the number of vertices; got 5, expected 6",
    ),
    (
        {"file_frames": [frame(faces_vertices=[[0, 1, 4, 3]])]},
        "frame 1 faces_vertices: the frames differ",
    ),
    ({"file_frames": [frame(edges_assignment=7 * ["U"])]}, "frame 1 edges_assignment: the frames"),
    ({"frame_unit": "m", "file_frames": [frame(frame_unit="mm")]}, "frame 1 frame_unit"),
]


@pytest.mark.parametrize(("change", "says"), FAULTS)
def test_faults_are_named_with_file_frame_and_key(
    tmp_path: Path, change: dict[str, Any], says: str
) -> None:
    with pytest.raises(InputError) as error:
        read(tmp_path, SQUARES, **change)
    assert str(error.value).startswith(str(tmp_path / "sheet.fold"))
    assert says in str(error.value)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("key", ["vertices_coords", "faces_vertices", "edges_vertices"])
def test_missing_keys(tmp_path: Path, key: str) -> None:
    content = {name: value for name, value in SQUARES.items() if name != key}
    with pytest.raises(InputError, match=r"missing|without edges_vertices"):
        read(tmp_path, content)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        (b"", "this is not JSON"),
        (b"v 0 0 0\nf 1 2 3 4\n", "this is not JSON"),
        (b'{"vertices_coords": [[NaN, 0]]}', "this is not JSON"),
        (b"\xff\xfe\x00", "this is not JSON"),
        (b"[" * 100_000, "this is not JSON"),
        (b"[]", "this is not FOLD"),
        (b"3", "this is not FOLD"),
        (b"{}", "vertices_coords: this key is missing in every frame"),
        (b'{"vertices_coords": [[1e999, 0]], "faces_vertices": [[0, 0, 0, 0]]}', "large|not JSON"),
    ],
)
def test_what_is_no_fold_file(tmp_path: Path, text: bytes, says: str) -> None:
    path = tmp_path / "sheet.fold"
    path.write_bytes(text)
    with pytest.raises(InputError, match=says):
        read_fold(path)


def test_a_directory_and_nothing(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="this is not a file"):
        read_fold(tmp_path)
    with pytest.raises(InputError, match="the file does not exist"):
        read_fold(tmp_path / "none.fold")


def test_vertices_may_lie_on_sides_of_a_panel(tmp_path: Path) -> None:
    # One panel of 2 x 1 begins at a vertex on its side; two squares are hinged to a half each.
    content = {
        "vertices_coords": [[0, 0], [1, 0], [2, 0], [0, 1], [1, 1], [2, 1], [0, 2], [1, 2], [2, 2]],
        "faces_vertices": [[4, 3, 0, 1, 2, 5], [6, 3, 4, 7], [7, 4, 5, 8]],
    }
    file = read(tmp_path, content)
    assert file.mesh.faces[0].tolist() == [3, 0, 2, 5]
    assert file.mesh.loops[0].tolist() == [3, 0, 1, 2, 5, 4]
    joined = {tuple(each) for each in file.mesh.edges[file.mesh.crease].tolist()}
    assert joined == {(3, 4), (4, 5), (4, 7)}
    # The three panels surround the vertex on the side: 180 and twice 90 degrees.
    inspection = inspect_fold(file)
    assert file.mesh.inner_vertices().tolist() == [4]
    assert inspection.passed
    sides = file.mesh.faces_edges()[0]
    assert (sides >= 0).tolist() == [True, False, True, False]
