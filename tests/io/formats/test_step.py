"""STEP, read back by build123d and by FreeCAD: as many solids as boards, named, in millimetres."""

import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cad_tools import ask_freecad, require_build123d
from documents import SMALL, demo_document, thick_document
from orishell.conventions.errors import InputError
from orishell.design import Construction
from orishell.document import Document
from orishell.io.format import Settings
from orishell.io.formats import step
from orishell.io.formats.step import write_step
from samples import thorough

CUBIC_MILLIMETRES = 1e9  # in a cubic metre, the unit of these documents


def read_back(file: Path) -> Any:
    from build123d import import_step

    return import_step(file)


def all_boards(document: Document, *, clipped: bool = True) -> list[tuple[str, float]]:
    """Names and volumes (mm^3) of all boards."""
    return [
        (each.board_name(board), CUBIC_MILLIMETRES * float(volume))
        for each in (document, *(document.attached if clipped else ()))
        if each.boards is not None
        for board, volume in enumerate(each.boards.volumes())
    ]


@thorough
@pytest.mark.parametrize("construction", ["sandwich", "bevel"])
def test_build123d_reads_every_board(construction: Construction, tmp_path: Path) -> None:
    require_build123d()
    origin = np.array([0.0, 0.0, 0.25])
    document = replace(thick_document("orthodiagonal", construction), origin=origin)
    write_step(tmp_path / "shell-target.step", document, Settings())
    assert {path.name for path in tmp_path.iterdir()} == {"shell-target.step", "shell-flat.step"}
    expected = all_boards(document)
    for name in ("target", "flat"):
        shape = read_back(tmp_path / f"shell-{name}.step")
        solids = shape.solids()
        assert all(solid.is_valid for solid in solids)
        # The reader writes names with underscores.
        assert [each.label.replace("_", " ") for each in shape.children] == [
            each for each, _ in expected
        ]
        np.testing.assert_allclose(
            [solid.volume for solid in solids], [volume for _, volume in expected], rtol=1e-6
        )
    # The flat sheet lies, with the clipped boards beside it.
    assert document.panel is not None
    box = shape.bounding_box()
    assert pytest.approx(1000 * document.panel.height) == box.max.Z
    assert pytest.approx(-1000 * document.panel.height) == box.min.Z
    target = read_back(tmp_path / "shell-target.step").bounding_box()
    outlines = np.concatenate(
        [each.boards_in(each.shell).reshape(-1, 3) for each in (document, *document.attached)]
    )
    outlines += origin
    np.testing.assert_allclose([*target.min], 1000 * outlines.min(axis=0), atol=1e-3)
    np.testing.assert_allclose([*target.max], 1000 * outlines.max(axis=0), atol=1e-3)


@pytest.mark.slow
def test_freecad_opens_it(tmp_path: Path) -> None:
    require_build123d()
    document = thick_document("orthodiagonal", "bevel", size=SMALL)
    write_step(tmp_path / "shell-target.step", document, Settings())
    expected = all_boards(document)
    for name in ("target", "flat"):
        count, volume = ask_freecad(tmp_path / f"shell-{name}.step")
        assert count == len(expected)
        assert volume == pytest.approx(sum(each for _, each in expected), rel=1e-6)


@pytest.mark.slow
def test_names_of_files_and_what_they_say(tmp_path: Path) -> None:
    """A pack where the document names one; the same bytes again; no clock; far from the origin."""
    require_build123d()
    document = thick_document("orthodiagonal", frames=3, size=SMALL)
    document = replace(
        document, named={"pack": 0, "target": 2, "flat": 1}, origin=np.array([1e9, 0, 0]), title="ü"
    )
    contents = []
    for again in ("one", "two"):
        (tmp_path / again).mkdir()
        write_step(tmp_path / again / "shelter.step", document, Settings())
        contents.append({path.name: path.read_bytes() for path in (tmp_path / again).iterdir()})
    assert contents[0] == contents[1]
    assert contents[0].keys() == {"shelter.step", "shelter-flat.step", "shelter-pack.step"}
    text = contents[0]["shelter.step"].decode("ascii")
    assert "SI_UNIT(.MILLI.,.METRE.)" in text
    assert set(re.findall(r"\d{4}-\d\d-\d\dT[\d:]+", text)) == {"1970-01-01T00:00:00"}
    assert re.search(r"FILE_NAME\('\? about \(1e\+12, 0, 0\) mm'", text)
    box = read_back(tmp_path / "one" / "shelter.step").bounding_box()
    assert np.abs([*box.min, *box.max]).max() < 1e5


def test_panels_without_thickness_are_refused(tmp_path: Path) -> None:
    require_build123d()
    with pytest.raises(InputError, match=r"\[panel\] thickness: panels have no thickness"):
        write_step(tmp_path / "shell-target.step", demo_document(), Settings())
    unknown = replace(thick_document("orthodiagonal"), unit="unit")
    with pytest.raises(InputError, match="unit of length"):
        write_step(tmp_path / "shell-target.step", unknown, Settings())


def test_without_build123d_one_message_says_what_to_install(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(step, "FORMAT", replace(step.FORMAT, ready=lambda: False))
    with pytest.raises(InputError, match=r"build123d.*pip install \"orishell\[cad\]\""):
        write_step(tmp_path / "a.step", thick_document("orthodiagonal"), Settings())
    assert not list(tmp_path.iterdir())
