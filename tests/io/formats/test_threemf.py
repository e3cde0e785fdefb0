"""3MF, read back by lib3mf and by PrusaSlicer: closed objects in millimetres, named, lying."""

import hashlib
import locale
import zipfile
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cad_tools import ask_prusa_slicer, objects_of, read_3mf
from documents import FAMILIES, demo_document, thick_document
from orishell.conventions.errors import InputError
from orishell.design import Construction
from orishell.document import Document
from orishell.io.format import Settings
from orishell.io.formats import threemf
from orishell.io.formats.threemf import write_3mf
from orishell.workshop import Workshop

SCALE = 0.05
MODEL = Workshop(model_scale=SCALE)


def vertices_of(thing: Any) -> np.ndarray:
    return np.array([tuple(vertex.Coordinates) for vertex in thing.GetVertices()])


def names(document: Document) -> list[str]:
    return [
        each.board_name(board)
        for each in (document, *document.attached)
        for board in range(len(each.boards or ()))
    ]


@pytest.mark.parametrize("family", FAMILIES)
@pytest.mark.parametrize("construction", ["sandwich", "bevel"])
def test_every_board_is_a_closed_object(
    family: str, construction: Construction, tmp_path: Path
) -> None:
    document = thick_document(family, construction)
    write_3mf(tmp_path / "a.3mf", document, Settings(workshop=MODEL))
    objects = objects_of(read_3mf(tmp_path / "a.3mf"))
    assert [each.GetName() for each in objects] == names(document)
    assert all(each.IsManifoldAndOriented() and each.IsValid() for each in objects)
    points = np.concatenate([vertices_of(each) for each in objects])
    assert document.panel is not None
    # They lie: as high as panels are thick, at model scale, and from 0.
    np.testing.assert_array_equal(points.min(axis=0), 0.0)
    assert points[:, 2].max() == pytest.approx(1000 * SCALE * document.panel.thickness, rel=1e-6)


def test_prusa_slicer_finds_them_manifold_and_in_millimetres(tmp_path: Path) -> None:
    document = thick_document("orthodiagonal", "bevel")
    write_3mf(tmp_path / "a.3mf", document, Settings(workshop=MODEL))
    said = ask_prusa_slicer(tmp_path / "a.3mf")
    pieces = [each.boards for each in (document, *document.attached) if each.boards is not None]
    assert len(said) == sum(map(len, pieces))
    assert {each["manifold"] for each in said} == {"yes"}
    assert {each["number_of_parts"] for each in said} == {"1"}
    volumes = np.concatenate([each.volumes() for each in pieces]) * (1000 * SCALE) ** 3
    np.testing.assert_allclose([float(each["volume"]) for each in said], volumes, rtol=1e-4)
    outlines = np.concatenate([each.outlines for each in pieces])
    sizes = np.ptp(outlines, axis=(1, 2)) * 1000 * SCALE
    for axis, expected in zip("xyz", sizes.T, strict=True):
        found = [float(each[f"size_{axis}"]) for each in said]
        np.testing.assert_allclose(found, expected, atol=1e-3)


def test_another_state_where_it_is_asked_for(tmp_path: Path) -> None:
    document = thick_document("orthodiagonal")
    write_3mf(tmp_path / "a.3mf", document, Settings(print_state="target"))
    points = np.concatenate(
        [vertices_of(each) for each in objects_of(read_3mf(tmp_path / "a.3mf"))]
    )
    expected = np.concatenate(
        [each.boards_in(each.shell).reshape(-1, 3) for each in (document, *document.attached)]
    )
    np.testing.assert_allclose(np.ptp(points, axis=0), 1000 * np.ptp(expected, axis=0), rtol=1e-6)


def test_same_bytes_without_clock_or_chance(tmp_path: Path) -> None:
    digests = set()
    for again in range(2):
        file = tmp_path / f"{again}.3mf"
        write_3mf(file, thick_document("orthodiagonal"), Settings())
        digests.add(hashlib.sha256(file.read_bytes()).hexdigest())
    assert len(digests) == 1
    with zipfile.ZipFile(file) as archive:
        assert {entry.date_time[0] for entry in archive.infolist()} == {1980}


def test_the_locale_stays_what_it_was(tmp_path: Path) -> None:
    """lib3mf changes it, and with it how the rest of the program reads and writes text."""
    before = locale.setlocale(locale.LC_ALL)
    try:
        locale.setlocale(locale.LC_ALL, "C.UTF-8")
        here = locale.setlocale(locale.LC_ALL)
        write_3mf(tmp_path / "a.3mf", thick_document("orthodiagonal"), Settings())
        assert locale.setlocale(locale.LC_ALL) == here
    finally:
        locale.setlocale(locale.LC_ALL, before)


def test_what_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "a.3mf"
    with pytest.raises(InputError, match=r"\[panel\] thickness: panels have no thickness"):
        write_3mf(path, demo_document(), Settings())
    document = thick_document("orthodiagonal")
    with pytest.raises(InputError, match="unit of length"):
        write_3mf(path, replace(document, unit="unit"), Settings())
    with pytest.raises(InputError, match="no such state"):
        write_3mf(path, document, Settings(print_state=99))
    monkeypatch.setattr(threemf, "FORMAT", replace(threemf.FORMAT, ready=lambda: False))
    with pytest.raises(InputError, match=r"lib3mf.*pip install \"orishell\[print\]\""):
        write_3mf(path, document, Settings())
    assert not list(tmp_path.iterdir())
