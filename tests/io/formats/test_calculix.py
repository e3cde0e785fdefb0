"""Decks for CalculiX, read back by meshio; what CalculiX makes of them: tests/structure."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from documents import demo_document, loaded_document
from io_readers import read_calculix
from orishell.conventions.errors import InputError
from orishell.document.loaded import LoadedShell
from orishell.io.format import Settings
from orishell.io.formats.calculix import write_calculix

DOCUMENT = loaded_document(cells=2)


def loaded() -> LoadedShell:
    assert DOCUMENT.loaded is not None
    return DOCUMENT.loaded


def written(path: Path, shell: LoadedShell | None = None, unit: str = "m") -> str:
    write_calculix(path, replace(DOCUMENT, unit=unit, loaded=shell or loaded()), Settings())
    return path.read_text()


def block(deck: str, keyword: str, number: int = 0) -> list[list[float]]:
    """Numbers of the lines after a keyword, the first with that beginning or a later one."""
    lines = deck.split(f"\n{keyword}")[number + 1].splitlines()[1:]
    end = next(k for k, line in enumerate(lines) if line.startswith("*"))
    return [[float(word) for word in line.split(",")] for line in lines[:end]]


def test_cells_are_quadrilaterals_with_middles(tmp_path: Path) -> None:
    written(tmp_path / "a.inp")
    mesh = read_calculix(tmp_path / "a.inp")
    corners, middles = np.split(mesh.cells_dict["quad8"], 2, axis=1)
    shell = loaded()
    np.testing.assert_allclose(mesh.points[: len(shell.points)], shell.points, atol=1e-11)
    ends = np.stack([mesh.points[corners], mesh.points[np.roll(corners, -1, axis=1)]])
    np.testing.assert_allclose(mesh.points[middles], ends.mean(axis=0), atol=1e-11)
    halves = np.sort(shell.triangles, axis=1).reshape(-1, 6)
    assert all(set(cell) == set(half) for cell, half in zip(corners.tolist(), halves, strict=True))
    sides = mesh.points[np.roll(corners, -1, axis=1)] - mesh.points[corners]
    turns = np.cross(sides, np.roll(sides, -1, axis=1))
    assert (np.einsum("cka,cla->ckl", turns, turns) > 0).all()  # none crosses itself
    # Middles are shared: as many as there are sides.
    sides = np.sort(np.stack([corners, np.roll(corners, -1, axis=1)], axis=-1), axis=-1)
    assert len(mesh.points) - len(shell.points) == len(np.unique(sides.reshape(-1, 2), axis=0))


def test_one_section_for_every_stiffness(tmp_path: Path) -> None:
    """A solid plate of 10 mm, 8 GPa and 600 kg/m3, and two boards of 2 mm at 8 mm."""
    shell = loaded()
    panels = len(np.unique(shell.panels))
    plane = 8e9 / (1 - 0.25**2)
    solid = (plane * 0.01, plane * 0.01**3 / 12)
    boards = (plane * 0.004, 2 * plane * (0.002**3 / 12 + 0.002 * 0.004**2))
    of_boards = shell.panels % 2 == 0
    values = np.where(of_boards, np.array(boards)[:, None], np.array(solid)[:, None])
    deck = written(tmp_path / "a.inp", replace(shell, membrane=values[0], bending=values[1]))
    thickness = [block(deck, "*SHELL SECTION", number)[0][0] for number in (0, 1)]
    modulus = [block(deck, "*ELASTIC", number)[0][0] for number in (0, 1)]
    density = [block(deck, "*DENSITY", number)[0][0] for number in (0, 1)]
    assert thickness == pytest.approx([0.01, np.sqrt(12 * boards[1] / boards[0])])
    assert modulus == pytest.approx([8e9, 8e9 * 0.004 / thickness[1]])
    assert np.multiply(density, thickness) == pytest.approx(6.0)
    cells = [len(block(deck, f"*ELSET,ELSET=SECTION{number}")) for number in (1, 2)]
    assert cells == [4 * (panels // 2), 4 * (panels - panels // 2)]


def test_a_newton_is_a_mass_times_an_acceleration(tmp_path: Path) -> None:
    """1 N = 1000 kg * 1 mm/s2: masses are tonnes where lengths are millimetres."""
    metres, millimetres = (
        block(written(tmp_path / "a.inp", unit=unit), "*DENSITY") for unit in ("m", "mm")
    )
    assert millimetres[0][0] == pytest.approx(metres[0][0] / 1000)
    assert "masses in 1000 kg, so that N = mass times mm/s2" in (tmp_path / "a.inp").read_text()


def test_loads_are_written_once_for_all_stiffnesses_of_creases(tmp_path: Path) -> None:
    deck = written(tmp_path / "a.inp")
    assert "** Case 1: snow, free creases; snow, rigid creases\n** Case 2: wind\n" in deck
    assert (deck.count("*STATIC"), deck.count("*BUCKLE"), deck.count("*FREQUENCY")) == (2, 2, 1)
    cases = loaded().cases
    for step, case in ((0, cases[0]), (1, cases[1]), (2, cases[0]), (3, cases[1])):
        forces = np.zeros_like(case.forces)
        for node, axis, force in block(deck, "*CLOAD", step):
            forces[int(node) - 1, int(axis) - 1] = force
        np.testing.assert_array_equal(forces, case.forces)


def test_supports_and_ties(tmp_path: Path) -> None:
    deck = written(tmp_path / "a.inp", replace(loaded(), tie_stiffness=5e4))
    held = [[node + 1, axis + 1, axis + 1] for node, axis in loaded().restrained.tolist()]
    assert block(deck, "*BOUNDARY") == held
    shell = loaded()
    for number, ends in enumerate(shell.ties.tolist()):
        ((_, first, second),) = block(deck, "*ELEMENT,TYPE=SPRINGA", number)
        assert [first - 1, second - 1] == ends
        length = np.linalg.norm(shell.points[ends[1]] - shell.points[ends[0]])
        lines = deck.split(f"*SPRING,ELSET=TIE{number + 1}\n\n")[1].splitlines()
        assert float(lines[0]) == pytest.approx(5e4 / length)
    assert "SPRING" not in written(
        tmp_path / "a.inp", replace(loaded(), ties=np.zeros((0, 2), np.int64))
    )


@pytest.mark.parametrize(("axes", "more"), [((), 6), ((2,), 3), ((0, 2), 1), ((0, 1, 2), 0)])
def test_a_shell_that_slides_is_kept_still(
    axes: tuple[int, ...], more: int, tmp_path: Path
) -> None:
    """On its corners, held along some axes: a body has six motions."""
    held = loaded().restrained
    held = held[np.isin(held[:, 1], axes)]
    rows = block(written(tmp_path / "a.inp", replace(loaded(), restrained=held)), "*BOUNDARY")
    assert len(rows) == len(held) + more
    assert len({(node, axis) for node, axis, _ in rows}) == len(rows)


def test_numbers_fit_into_twenty_characters(tmp_path: Path) -> None:
    """CalculiX reads no more of one."""
    moved = loaded().points * -1.2345678901234567e-101
    deck = written(tmp_path / "a.inp", replace(loaded(), points=moved))
    words = [word for line in deck.splitlines()[2:] if "*" not in line for word in line.split(",")]
    assert max(map(len, words)) == 20


def test_same_bytes(tmp_path: Path) -> None:
    assert written(tmp_path / "a.inp") == written(tmp_path / "b.inp")


def test_what_was_not_analysed_has_no_deck(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"not analysed.*\[structure\] and \[\[load_case\]\]"):
        write_calculix(tmp_path / "a.inp", demo_document(), Settings())
    with pytest.raises(InputError, match="names none"):
        write_calculix(tmp_path / "a.inp", replace(DOCUMENT, unit="unit"), Settings())
    assert not list(tmp_path.iterdir())
