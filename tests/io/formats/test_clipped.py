"""Boards that are clipped on at the target, in the formats that show them there."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import meshio
import numpy as np
import pytest

from documents import EXAMPLES
from orishell.design_file import read_design_file
from orishell.document import Document
from orishell.document.from_design import document_of_design
from orishell.io.format import Settings
from orishell.io.formats.obj import write_obj
from orishell.io.formats.rhino import write_rhino


@pytest.fixture(scope="module")
def document() -> Document:
    file = read_design_file(EXAMPLES / "figure2.toml")
    design = file.pattern.design(file.f, file.g).with_clipped_flaps()
    made = document_of_design(design, "m", frames=3)
    return replace(made, origin=np.array([0.0, 0.0, 4.0]))


def test_obj_has_boards_at_the_target_as_groups_of_their_own(
    document: Document, tmp_path: Path
) -> None:
    pieces = (document, *document.attached)
    write_obj(tmp_path / "shell.obj", document, Settings())
    mesh = meshio.read(tmp_path / "shell.obj")
    corners = np.concatenate([mesh.points[block.data] for block in mesh.cells])
    expected = [(each.shell.positions + document.origin)[each.mesh.faces] for each in pieces]
    np.testing.assert_array_equal(corners[..., [0, 2, 1]] * [1, -1, 1], np.concatenate(expected))
    assert [len(block) for block in mesh.cells[-2:]] == [len(b.mesh.faces) for b in pieces[1:]]
    write_obj(tmp_path / "shell.obj", document, Settings(state="flat"))
    mesh = meshio.read(tmp_path / "shell.obj")
    assert sum(len(block) for block in mesh.cells) == len(document.mesh.faces)


def test_3dm_has_boards_in_the_pattern_and_at_the_target(
    document: Document, tmp_path: Path
) -> None:
    import rhino3dm

    def names(state: int | str) -> list[str]:
        write_rhino(tmp_path / "shell.3dm", document, Settings(state=state))
        model: Any = rhino3dm.File3dm.Read(str(tmp_path / "shell.3dm"))
        return [each.Attributes.Name for each in model.Objects]

    assert {"outline 2", "board 1", "board 2", "panel 0,-1"} <= set(names("target"))
    assert len(names("target")) == len(names(2))  # the target's number
    flat = names("flat")
    assert "outline 2" in flat
    assert "board 1" not in flat
