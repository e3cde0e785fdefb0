"""Box girders in files: from the drive on at which they are joined to the sheet, and not before."""

from __future__ import annotations

import json
from collections import Counter
from itertools import pairwise
from pathlib import Path

import numpy as np
import pygltflib
import pytest

from command_line import orishell
from kits import BOXED, SKINNED, shell_of
from orishell.conventions.errors import InputError
from orishell.document import FLAT, SHELL
from orishell.io import read_fold, write_fold
from orishell.io.format import Settings
from orishell.io.formats.gltf import write_gltf
from orishell.io.view import dump_view


def test_girders_are_there_from_where_they_are_joined() -> None:
    document, lock = shell_of(BOXED).document, shell_of(BOXED).lock
    assert lock is not None
    assert lock.boxes is not None
    joined = np.rad2deg(lock.boxes.joined_from)
    assert 0 < joined < np.rad2deg(lock.target_drive)
    for which in (FLAT, SHELL, "pack", *range(len(document.states))):
        there = [part for part, _ in document.parts_in(which) if part.kind == "girder"]
        drive = document.state(which).drive_deg
        assert drive is not None
        assert len(there) == (3 if drive >= joined else 0)


def test_fold_is_the_sheet_which_passes_the_check(tmp_path: Path) -> None:
    """Girders are not in the flat frame, whose panels all frames of the sheet have."""
    document = shell_of(BOXED).document
    write_fold(tmp_path / "shell.fold", document)
    assert len(read_fold(tmp_path / "shell.fold").mesh.faces) == len(document.mesh.faces)
    done = orishell("check", tmp_path / "shell.fold")
    assert done.returncode == 0, done.stdout
    assert "FAIL" not in done.stdout


@pytest.mark.parametrize("which", [FLAT, SHELL])
def test_glb_has_them_as_points_before(which: str, tmp_path: Path) -> None:
    document = shell_of(BOXED).document
    write_gltf(tmp_path / "shell.glb", document, Settings(state=which))
    file = pygltflib.GLTF2().load(str(tmp_path / "shell.glb"))
    blob = file.binary_blob()
    strips = {k for k, node in enumerate(file.nodes) if node.name.startswith("panel box ")}
    assert len(strips) == 24
    points = {k for k, node in enumerate(file.nodes) if node.scale == [0, 0, 0]}
    assert points == (strips if which == FLAT else set())
    (motion,) = file.animations
    scaled = [each for each in motion.channels if each.target.path == "scale"]
    assert {each.target.node for each in scaled} == strips
    part = next(part for part in document.attached if part.kind == "girder")
    shown = [part.is_joined_in(state) for state in document.states]
    assert any(shown)
    assert not all(shown)
    for channel in scaled:
        sampler = motion.samplers[channel.sampler]
        entry = file.accessors[sampler.output]
        assert (sampler.interpolation, entry.count) == ("STEP", len(shown))
        begin = file.bufferViews[entry.bufferView].byteOffset + entry.byteOffset
        sizes = np.frombuffer(blob, "<f4", 3 * entry.count, begin).reshape(-1, 3)
        assert (sizes == np.array(shown)[:, None]).all()


def test_the_view_says_from_which_drive_on() -> None:
    document = shell_of(BOXED).document
    data = dump_view(document)
    begin = 4 + int.from_bytes(data[:4], "little")
    header = json.loads(data[4:begin])
    for number, part in enumerate(document.attached):
        first = begin + header["arrays"][f"clipped_{number}"]["offset"]
        length = int.from_bytes(data[first : first + 4], "little")
        own = json.loads(data[first + 4 : first + 4 + length])
        moves = part.kind == "girder"
        assert own.get("joined_from_deg") == (part.joined_from_deg if moves else None)
        assert len(own["drives_deg"]) == (len(header["drives_deg"]) if moves else 1)


def test_further_frames_have_girders_hung_on_the_sheet(tmp_path: Path) -> None:
    """Three panels meet at every line, all rigid from frame to frame, and where parts are."""
    document = shell_of(BOXED).document
    write_fold(tmp_path / "shell.fold", document)
    content = json.loads((tmp_path / "shell.fold").read_text())
    frames = content["file_frames"]
    girders = [frame for frame in frames if "nonManifold" in frame["frame_attributes"]]
    parts = [part for part in document.attached if part.kind == "girder"]
    there = [
        k for k, state in enumerate(document.states) if all(p.is_joined_in(state) for p in parts)
    ]
    assert len(there) == len(girders) == len(frames) - len(document.states)
    first = girders[0]
    assert [frame.get("frame_parent") for frame in girders[1:]] == [frames.index(first) + 1] * (
        len(girders) - 1
    )
    faces, edges = first["faces_vertices"], [tuple(each) for each in first["edges_vertices"]]
    sides = Counter((min(pair), max(pair)) for face in faces for pair in pairwise([*face, face[0]]))
    assert sorted(edges) == sorted(sides)
    letters = dict(zip(edges, first["edges_assignment"], strict=True))
    lines = sum(len(part.hung) for part in parts if part.hung is not None)
    assert sum(times == 3 for times in sides.values()) == lines
    assert {letters[each] for each, times in sides.items() if times == 3} == {"J"}
    assert all(letters[each] == "B" for each, times in sides.items() if times == 1)
    lengths = []
    for number, frame in zip(there, girders, strict=True):
        points = np.array(frame["vertices_coords"])
        assert frame["orishell:drive_deg"] == document.states[number].drive_deg
        own = [document.in_world(part.states[number].positions[part.mesh.faces]) for part in parts]
        strips = points[np.array(faces[-sum(map(len, own)) :])]
        np.testing.assert_allclose(strips, np.concatenate(own), rtol=0, atol=1e-12)
        for face in faces:
            corners = points[face] - points[face[0]]
            assert np.linalg.svd(corners, compute_uv=False)[2] < 1e-9
        apart = [np.linalg.norm(points[f] - points[f[0]], axis=1) for f in faces]
        lengths.append(np.concatenate(apart))
        angles = frame["edges_foldAngle"]
        for (one, other), angle in zip(edges, angles, strict=True):
            if sides[one, other] == 3:
                assert angle is None
            elif letters[one, other] in "MV":
                assert np.sign(angle) == {"M": -1, "V": 1}[letters[one, other]]
    np.testing.assert_allclose(lengths[0], lengths[-1], rtol=0, atol=1e-12)


def test_frames_that_are_no_sheets_are_passed_over(tmp_path: Path) -> None:
    """And those that have their mesh from them; the key frame is not."""
    document = shell_of(BOXED).document
    write_fold(tmp_path / "shell.fold", document)
    content = json.loads((tmp_path / "shell.fold").read_text())
    assert len(read_fold(tmp_path / "shell.fold").frames) == 1 + len(document.states)
    child = {**content["file_frames"][-1], "frame_attributes": ["3D"]}
    content["file_frames"].append(child)
    (tmp_path / "child.fold").write_text(json.dumps(content))
    assert len(read_fold(tmp_path / "child.fold").frames) == 1 + len(document.states)
    (girders, *_) = (f for f in content["file_frames"] if "nonManifold" in f["frame_attributes"])
    (tmp_path / "key.fold").write_text(json.dumps(girders))
    with pytest.raises(InputError, match="panel"):
        read_fold(tmp_path / "key.fold")


def test_a_sheet_without_girders_has_no_further_frames(tmp_path: Path) -> None:
    document = shell_of(BOXED).document.sheet
    write_fold(tmp_path / "sheet.fold", document)
    content = json.loads((tmp_path / "sheet.fold").read_text())
    assert len(content["file_frames"]) == len(document.states)


def test_further_frames_have_a_second_skin_on_its_walls(tmp_path: Path) -> None:
    """Three panels meet at both lines of every wall; panels are the same from frame to frame."""
    document = shell_of(SKINNED).document
    write_fold(tmp_path / "shell.fold", document)
    frames = json.loads((tmp_path / "shell.fold").read_text())["file_frames"]
    skins = [frame for frame in frames if "nonManifold" in frame["frame_attributes"]]
    assert skins
    assert skins[-1]["frame_title"] == "target, with skin and walls"
    faces, edges = skins[0]["faces_vertices"], [tuple(e) for e in skins[0]["edges_vertices"]]
    sides = Counter((min(pair), max(pair)) for face in faces for pair in pairwise([*face, face[0]]))
    assert sorted(edges) == sorted(sides)
    walls = sum(len(part.mesh.faces) for part in document.attached if part.kind == "wall")
    others = len(document.mesh.faces) + sum(
        len(part.mesh.faces) for part in document.attached if part.kind == "skin"
    )
    # Every panel of a wall parts one of the sheet and one of the second skin.
    assert len(faces) == others + 3 * walls
    letters = dict(zip(edges, skins[0]["edges_assignment"], strict=True))
    assert sum(times == 3 for times in sides.values()) == 2 * walls
    assert {letters[each] for each, times in sides.items() if times == 3} == {"J"}
    assert {letters[each] for each, times in sides.items() if times == 1} == {"B"}
    lengths = []
    for frame in skins:
        points = np.array(frame["vertices_coords"])
        for face in faces:
            corners = points[face] - points[face[0]]
            assert np.linalg.svd(corners, compute_uv=False)[2] < 1e-9
        apart = [np.linalg.norm(points[face] - points[face[0]], axis=1) for face in faces]
        lengths.append(np.concatenate(apart))
    np.testing.assert_allclose(lengths[0], lengths[-1], rtol=0, atol=1e-12)
    lying = document.in_world(document.shell.positions)
    np.testing.assert_allclose(
        np.array(skins[-1]["vertices_coords"])[: len(lying)], lying, rtol=0, atol=1e-12
    )
