"""FOLD files of fitted shells: read back, checked by us and by hand, folded by rabbit-ear."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from fitted_shells import fitted
from node_tools import ask_node
from orishell.document import Document
from orishell.document.from_design import document_of_motion
from orishell.io import read_fold, write_fold
from orishell.motion import FoldingMotion
from orishell.numerics.arrays import Array
from orishell.verification import inspect_fold
from rigid import distance_after_motion

surfaces = pytest.mark.parametrize("surface", ["cap", "saddle .5", "roof"])
FRAMES = 7
PANELS = 5
LIMIT = 1e-9
"""Of the diagonal, for what rabbit-ear folds panel by panel. Found: 1e-14."""


@cache
def document(surface: str, *, pack: bool = False) -> Document:
    """From the flat sheet to the target, or from the flat stack over the target to the sheet."""
    mechanism = fitted(surface, PANELS).mechanism
    end = mechanism.end_drive if pack else None
    return document_of_motion(FoldingMotion(mechanism, FRAMES, end), "m")


def written(surface: str, directory: Path, *, pack: bool = False) -> Path:
    path = directory / "shell.fold"
    write_fold(path, document(surface, pack=pack))
    return path


@surfaces
def test_file_reads_back_and_passes_every_check(surface: str, tmp_path: Path) -> None:
    file = read_fold(written(surface, tmp_path))
    ours = [state.positions.reshape(-1, 3) for state in document(surface).states]
    assert len(file.frames) == FRAMES + 1
    for frame, positions in zip(file.frames[1:], ours, strict=True):
        np.testing.assert_array_equal(frame.positions, positions)
    inspection = inspect_fold(file)
    assert inspection.passed
    found = {check.name: check for check in inspection.checks}
    assert {"developable", "panel_length", "planarity", "fold_angle", "maekawa"} <= set(found)


@surfaces
def test_numbers_of_the_file_are_those_of_a_flat_foldable_sheet(
    surface: str, tmp_path: Path
) -> None:
    """By the coordinates that stand in it alone; angles lose a few digits on short edges."""
    content = json.loads(written(surface, tmp_path).read_text())
    rows, columns = content["orishell:grid_shape"]
    flat = np.array(content["vertices_coords"]).reshape(rows, columns, 2) @ [1, 1j]
    here = flat[1:-1, 1:-1]
    ways = [flat[1:-1, 2:], flat[:-2, 1:-1], flat[1:-1, :-2], flat[2:, 1:-1]]
    right, up, left, down = (each - here for each in ways)
    for one, other in (((right, up), (left, down)), ((up, left), (down, right))):
        sectors = np.angle(one[1] / one[0]) + np.angle(other[1] / other[0])  # Kawasaki
        np.testing.assert_allclose(sectors, np.pi, rtol=0, atol=1e-11)
    letters = np.array(content["edges_assignment"])
    meeting = np.array(content["edges_vertices"])
    turns = np.zeros(rows * columns, int)  # Maekawa: mountains and valleys differ by two
    np.add.at(turns, meeting, (letters == "M").astype(int)[:, None] - (letters == "V")[:, None])
    assert (np.abs(turns.reshape(rows, columns)[1:-1, 1:-1]) == 2).all()
    faces = np.array(content["faces_vertices"])
    pairs = [(0, 1), (1, 2), (2, 3), (3, 0), (0, 2), (1, 3)]
    before = spans(np.array(content["vertices_coords"]), faces, pairs)
    for frame in content["file_frames"]:
        now = spans(np.array(frame["vertices_coords"]), faces, pairs)
        np.testing.assert_allclose(now, before, rtol=1e-12)  # rigid, and so plane
        angles = measured_folds(np.array(frame["vertices_coords"]), content)
        np.testing.assert_allclose(frame["edges_foldAngle"], angles, rtol=0, atol=1e-9)


def spans(points: Array, faces: Array, pairs: list[tuple[int, int]]) -> Array:
    return np.stack(
        [np.linalg.norm(points[faces[:, b]] - points[faces[:, a]], axis=-1) for a, b in pairs]
    )


def measured_folds(points: Array, content: dict[str, Any]) -> Array:
    """Degrees, by the normals of the two panels of every edge; valleys are positive."""
    edges = np.array(content["edges_vertices"])
    corners = points[np.array(content["faces_vertices"])]
    normals = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    normals /= np.linalg.norm(normals, axis=-1)[:, None]
    beside: list[list[int]] = [[] for _ in edges]
    for face, own in enumerate(content["faces_edges"]):
        for edge in own:
            beside[edge].append(face)
    middles = corners.mean(axis=1)
    found = np.zeros(len(edges))
    for edge, faces in enumerate(beside):
        if len(faces) == 2:
            one, other = faces
            size = np.arctan2(
                np.linalg.norm(np.cross(normals[one], normals[other])),
                normals[one] @ normals[other],
            )
            # The other panel rises over the first where the crease is a valley.
            rises = (middles[other] - points[edges[edge, 0]]) @ normals[one] > 0
            found[edge] = np.rad2deg(size if rises else -size)
    return found


@surfaces
@pytest.mark.parametrize("pack", [False, True])
def test_rabbit_ear_folds_every_frame_into_our_coordinates(
    surface: str, pack: bool, tmp_path: Path
) -> None:
    path = written(surface, tmp_path, pack=pack)
    content = json.loads(path.read_text())
    stays = len(content["faces_vertices"]) // 2
    answer = ask_node("fold_with_rabbit_ear.cjs", {"path": str(path), "root": stays})
    _, *folded = (np.array(frame) for frame in answer)
    frames = content["file_frames"]
    if pack:  # all creases are folded flat
        folds = np.abs(frames[0]["edges_foldAngle"])[np.array(content["edges_assignment"]) != "B"]
        np.testing.assert_allclose(folds, 180)
    limit = LIMIT * float(np.linalg.norm(np.ptp(np.array(content["vertices_coords"]), axis=0)))
    ours = [np.array(frame["vertices_coords"]) for frame in frames]
    assert max(distance_after_motion(*pair) for pair in zip(folded, ours, strict=True)) <= limit
    answer = ask_node("validate_with_rabbit_ear.cjs", {"path": str(path)})
    assert answer["summary"] == "valid"
