"""Box girders in files: from the drive on at which they are joined to the sheet, and not before."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pygltflib
import pytest

from command_line import orishell
from kits import BOXED, shell_of
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
    """Girders are not in the flat frame, whose panels all others have."""
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
