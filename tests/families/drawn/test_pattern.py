"""The family of drawn sheets: from a file, or from what the design file lists, to a shell."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from mechanisms import CLOSED, flat_foldable, random_net
from mechanisms import SAMPLES as SHEETS
from orishell.conventions.errors import DesignError, InputError
from orishell.conventions.toml_file import parse_toml
from orishell.design_file import DesignFile, check_design, read_design_file, starter_file
from orishell.design_file.drawing import DrawingTable, table_of
from orishell.families.drawn import DrawnSheet
from orishell.families.drawn.decided import nearby_as_drawn
from orishell.families.drawn.nearest import FOLDS, Nearby, disagreement, find_nearby
from orishell.families.drawn.sheet import drawn_sheet
from orishell.families.drawn.signs import MOST_WAYS, find_signs
from orishell.motion import Mechanism, find_assignment, largest_fold
from orishell.motion.drawing import drawing_of
from orishell.motion.grid import CreaseValues
from orishell.shell.designed import designed
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES
from patterns import SAMPLES, jittered, mirrored, miura, of_mechanism, shuffled, write
from samples import thorough

Array = np.ndarray


def file_of(folder: Path, name: str, **pattern: Any) -> DesignFile:
    tables = {
        "shell": {"family": "pattern", "unit": "m"},
        "target": {"pattern": name},
        "pattern": pattern,
    }
    return check_design(tables, folder / "shell.toml")


def starter(**values: Any) -> DesignFile:
    found = check_design(parse_toml(starter_file("pattern")), Path("shell.toml"), files=False)
    return found.changed(values) if values else found


@pytest.mark.parametrize("ending", ["fold", "svg", "dxf"])
def test_a_file_becomes_a_shell(tmp_path: Path, ending: str) -> None:
    write(tmp_path / f"mine.{ending}", shuffled(SAMPLES["graded Miura"].make()))
    file = file_of(tmp_path, f"mine.{ending}")
    assert (file.pattern.rows, file.pattern.columns) == (5, 6)
    assert designed(file).parameters["fold_deg"] == pytest.approx(90, abs=1e-6)
    if ending == "svg":
        shell = make_shell(file, skip=MEASURES)
        assert shell.report.feasible
        assert shell.report.residuals is not None
        assert shell.report.residuals.panel_length < 1e-12


@pytest.mark.parametrize("name", ["longitudinal", "parallel repeating", "Huffman's grid"])
def test_the_sheet_in_the_file_is_that_of_the_list(tmp_path: Path, name: str) -> None:
    write(tmp_path / "mine.fold", mirrored(SAMPLES[name].make()))
    file = file_of(tmp_path, "mine.fold", fold_deg=40)
    assert file.drawing is not None
    listed = file.changed({"target": {"pattern": table_of(file.drawing)}})
    one, other = (designed(each).mechanism for each in (file, listed))
    np.testing.assert_array_equal(one.positions(0.3), other.positions(0.3))
    table = DrawingTable(file="mine.fold", scale=2.0)
    again = DrawingTable.model_validate(table.without_files(tmp_path, "m")).drawing(None, "m")
    np.testing.assert_array_equal(again.flat, 2 * file.drawing.flat)


def test_the_largest_fold_angle_is_what_is_asked_for() -> None:
    for degrees in (30, 120):
        sheet = designed(starter(**{"pattern.fold_deg": degrees})).mechanism
        found = largest_fold(sheet, np.array([sheet.target_drive]))
        assert np.rad2deg(found[0]) == pytest.approx(degrees, abs=1e-6)


def test_auto_folds_as_far_as_it_goes() -> None:
    shell = make_shell(starter(**{"pattern.fold_deg": "auto"}), skip=(*MEASURES, "verification"))
    assert shell.report.parameters["fold_deg"] == 180
    limited = starter(**{"pattern.fold_deg": "auto", "deployment.largest_fold_deg": 150})
    assert designed(limited).parameters["fold_deg"] == pytest.approx(150)


def test_a_thickness_is_given_as_to_any_shell() -> None:
    thick = starter(**{"panel": {"thickness": 0.02, "membrane": 0.001}})
    report = make_shell(thick, skip=MEASURES).report
    assert report.feasible
    assert report.panel is not None


NEARBY = [
    "flat-foldable",
    "parallel, no flaps",
    "orthodiagonal, g straight",
    "longitudinal, 5 x 6 from F",
    "flat-foldable, one row",
    "toy",
]
OTHERS = [name for name in CLOSED if name not in NEARBY and not name.startswith("drawn")]


def jittered_sheet(name: str, seed: int, share: float = 1e-3) -> tuple[Array, Array, CreaseValues]:
    """A sheet, jittered by a share of its shortest edge, what it was jittered by, and its signs."""
    sheet = SHEETS[name].make()
    flat = sheet.positions(0.0)[..., :2]
    edges = np.diff(flat, axis=0), np.diff(flat, axis=1)
    size = share * min(np.linalg.norm(each, axis=-1).min() for each in edges)
    jitter = size * np.random.default_rng(seed).uniform(-1, 1, flat.shape)
    return flat + jitter, jitter, find_assignment(sheet)


def near(flat: Array, signs: CreaseValues) -> Nearby:
    """What is found near a sheet."""
    found = find_nearby(flat, drawn_sheet(flat, signs, 2.0).drive)
    assert found is not None
    return found


def require_nearest(name: str, seed: int) -> None:
    """It folds, conditions for the nearest hold, and it is no farther than where the jitter began.

    The sheet without its jitter folds, so that the nearest one moves by no more, all in all. The
    largest coordinate may: by 1.5 times the jitter in the worst of 68 sheets.
    """
    flat, jitter, signs = jittered_sheet(name, seed)
    found = near(flat, signs)
    assert disagreement(drawn_sheet(found.vertices, signs, 2.0).drive) < 1e-12
    assert found.nearest
    assert np.linalg.norm(found.vertices - flat) <= np.linalg.norm(jitter)
    assert np.abs(found.vertices - flat).max() <= 2 * np.abs(jitter).max()


@pytest.mark.parametrize("name", NEARBY)
def test_a_jittered_sheet_is_moved_to_the_nearest_that_folds(name: str) -> None:
    require_nearest(name, 7)


@thorough
@pytest.mark.parametrize("name", NEARBY + OTHERS)
def test_jittered_sheets_of_all_families(name: str) -> None:
    for seed in range(2):
        require_nearest(name, seed)


def test_no_other_sheet_of_its_kind_is_nearer() -> None:
    # Others are found from places around it; |x|^2 grows by half of the way between at least.
    flat, _, signs = jittered_sheet("flat-foldable", 3)
    nearest = near(flat, signs).vertices
    least = np.sum((nearest - flat) ** 2)
    for seed in range(4):
        away = 1e-3 * np.random.default_rng(seed).normal(size=flat.shape)
        other = near(nearest + away, signs).vertices
        apart = np.sum((other - nearest) ** 2)
        assert apart > 0.1 * np.sum(away**2)
        assert np.sum((other - flat) ** 2) > least + 0.5 * apart


@thorough
def test_a_large_sheet_is_moved_to_the_nearest_that_folds() -> None:
    sheet = flat_foldable(random_net(60, 60, 2))
    flat = sheet.positions(0.0)[..., :2]
    signs, jitter = (
        find_assignment(sheet),
        1e-4 * np.random.default_rng(0).uniform(-1, 1, flat.shape),
    )
    found = near(flat + jitter, signs)
    assert found.nearest
    assert disagreement(drawn_sheet(found.vertices, signs, 2.0).drive) < 1e-11
    assert np.linalg.norm(found.vertices - flat - jitter) <= np.linalg.norm(jitter)


def test_what_folds_only_nearly_is_moved_and_said(tmp_path: Path) -> None:
    exact = of_mechanism(SHEETS["longitudinal, 4 x 3 from S"].make())
    write(tmp_path / "near.fold", jittered(exact, 1e-4))
    moved_sheet = designed(file_of(tmp_path, "near.fold", fold_deg=30))
    assert "vertices are moved by up to" in moved_sheet.warnings[0]
    moved = moved_sheet.parameters["moved"]
    assert isinstance(moved, float)
    assert moved > 0
    assert isinstance(moved_sheet.mechanism, DrawnSheet)
    assert disagreement(moved_sheet.mechanism.drive) < FOLDS
    write(tmp_path / "far.fold", jittered(exact, 2e-2))
    file = file_of(tmp_path, "far.fold", fold_deg=30)
    with pytest.raises(DesignError) as caught:
        make_shell(file, skip=MEASURES)
    assert caught.value.place.startswith("worst at vertex ")
    (remedy,) = caught.value.remedies
    assert make_shell(file.changed(remedy.changes), skip=MEASURES).report.feasible


def test_what_does_not_fold_is_refused_with_how_far(tmp_path: Path) -> None:
    write(tmp_path / "twist.fold", SAMPLES["square twist"].make())
    with pytest.raises(DesignError) as caught:
        make_shell(file_of(tmp_path, "twist.fold"))
    assert "disagree by" in caught.value.size
    assert caught.value.excess is not None
    write(tmp_path / "letters.fold", SAMPLES["not folding"].make())
    with pytest.raises(DesignError, match="no mountains and valleys were found"):
        make_shell(file_of(tmp_path, "letters.fold"))


def without_letters(sheet: Mechanism) -> tuple[Array, CreaseValues, CreaseValues]:
    """Its vertices, its signs, and none in their place."""
    flat, signs = sheet.positions(0.0)[..., :2], find_assignment(sheet)
    nothing = CreaseValues(np.full_like(signs.row, np.nan), np.full_like(signs.column, np.nan))
    return flat, signs, nothing


@pytest.mark.parametrize("name", [each for each in CLOSED if not each.startswith("drawn")])
def test_mountains_and_valleys_are_found(name: str) -> None:
    flat, signs, nothing = without_letters(SHEETS[name].make())
    ways = find_signs(flat, nothing)
    for each in ways:
        assert disagreement(drawn_sheet(flat, each, 1.0).drive, np.array([0.2, 0.6])) < 1e-8
    kept = [each.on_edges().tolist() for each in ways]
    assert len({tuple(each) for each in kept}) == len(ways)
    if len(ways) < MOST_WAYS:  # else the sheet's own way may be one of those left out
        own = signs.on_edges()
        assert any(each in ((own + 0.0).tolist(), (0.0 - own).tolist()) for each in kept)


def test_letters_that_are_given_are_kept() -> None:
    # One crease tells which side is up, two which of the ways.
    flat, signs, nothing = without_letters(SHEETS["longitudinal, 5 x 6 from F"].make())
    nothing.row[0], nothing.column[:, 0] = signs.row[0], signs.column[:, 0]
    for each in find_signs(flat, nothing):
        np.testing.assert_array_equal(each.row[0], signs.row[0])
        np.testing.assert_array_equal(each.column[:, 0], signs.column[:, 0])


def test_letters_that_were_found_are_said() -> None:
    unknown = starter(**{"target.pattern.row_creases": ["U" * 7] * 5, "pattern.fold_deg": 40})
    found, given = designed(unknown), designed(starter(**{"pattern.fold_deg": 40}))
    assert "35 of 71 creases have no letter: mountains and valleys were found" in found.warnings[0]
    np.testing.assert_array_equal(found.mechanism.positions(0.5), given.mechanism.positions(0.5))


FAULTS: dict[str, tuple[dict[str, Any], str]] = {
    "no drawing": ({"target": None}, "a shell of a drawn sheet"),
    "curves": ({"target": {"f": {"formula": "x", "range": [0, 1]}}}, "missing"),
    "rows": ({"pattern.rows": 3}, "rows and columns are those of the drawn sheet"),
    "tolerance": ({"tolerance": {"surface": 0.1}}, "those of the drawn sheet"),
    "another family": ({"shell.family": "orthodiagonal"}, 'asks for family = "pattern"'),
    "letters": ({"target.pattern.row_creases": ["V"]}, "5 words of 7 letters"),
    "a letter": ({"target.pattern.row_creases": ["VVVVVVX"] * 5}, "row_creases"),
    "a short row": ({"target.pattern.vertices.1": [[0, -1], [1, -1], [2, -1]]}, "as many vertices"),
    "a flap": ({"pattern.flap": 1}, "flap"),
    "no file": ({"target": {"pattern": "mine.fold"}}, "files are not opened here"),
    "a file too": ({"target.pattern.file": "mine.fold"}, "a file or its vertices"),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_faults_of_the_table(fault: str) -> None:
    changes, words = FAULTS[fault]
    with pytest.raises(InputError, match=words):
        starter(**changes)


def test_panels_that_are_no_grid_are_refused_by_place(tmp_path: Path) -> None:
    write(tmp_path / "hole.fold", SAMPLES["Miura with a hole"].make())
    path = tmp_path / "shell.toml"
    path.write_text(
        '[shell]\nfamily = "pattern"\nunit = "m"\n[target]\npattern = "hole.fold"\n',
        encoding="utf-8",
    )
    with pytest.raises(InputError, match="do not make a grid") as caught:
        read_design_file(path)
    assert "hole.fold" in str(caught.value)
    turned = starter().changed
    with pytest.raises(InputError, match="from left to right"):
        turned({"target.pattern.scale": 1.0, "target.pattern.vertices.0": [[0, -9]] * 8})


def test_a_vertex_that_is_drawn_twice_is_refused() -> None:
    with pytest.raises(InputError, match="panel 6, 1 with a side of no length"):
        starter().changed({"target.pattern.vertices.6.1": [0.0, -6.0]})


def test_a_sheet_nearby_folds_all_creases_as_they_are_asked_to() -> None:
    """Of signs that the sheet nearby does not fold with, as where it stays flat, there is none."""
    drawing = drawing_of(jittered(miura(3, 3), 1e-3))
    sheet = drawn_sheet(drawing.flat, drawing.signs, np.pi)
    found = nearby_as_drawn(drawing.flat, drawing.signs, sheet)
    assert found is not None
    other = CreaseValues(-drawing.signs.row, -drawing.signs.column)
    assert nearby_as_drawn(drawing.flat, other, sheet) is not None  # turned over
    flat = CreaseValues(drawing.signs.row, 0 * drawing.signs.column)
    assert nearby_as_drawn(drawing.flat, flat, sheet) is None
