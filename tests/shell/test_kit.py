"""Kits: every part counted once in all files, every file in its folder, models at their scale."""

from __future__ import annotations

import csv
import re
from collections import Counter
from dataclasses import replace
from functools import cache
from itertools import pairwise
from pathlib import Path

import ezdxf
import numpy as np
import pytest
from ezdxf.document import Drawing
from ezdxf.entities.line import Line
from pypdf import PdfReader

from cad_tools import require_build123d
from documents import EXAMPLES
from orishell.conventions.errors import InputError
from orishell.design_file import read_design_file
from orishell.document.from_design import states_of
from orishell.io import Settings
from orishell.io.formats import find_formats
from orishell.shell import Shell, make_shell, write_format, write_kit
from orishell.shell.kit import CARD, FOLDERS, FORMATS, TRADES, folder_of
from orishell.shell.steps import MEASURES
from orishell.workshop.kit.card_model import make_card_model
from orishell.workshop.kit.facts import find_facts
from orishell.workshop.tiling import PAPERS_MM
from pdf_tools import require_sound
from samples import thorough

MOST_BYTES = 3_000_000
QUICK = "figure1_card"
"""48 panels of card on paper, with flaps that are clipped on; four seconds."""
KITS = [
    QUICK,
    *(
        pytest.param(name, marks=thorough)
        for name in ("shelter", "shelter_boards", "shelter_hinged", "dome")
    ),
]
SHEETS = ["canopy", *(pytest.param(name, marks=thorough) for name in ("shelter", "dome_locked"))]


@cache
def shell_of(name: str) -> Shell:
    """An example, with its pack and quantities; distances from its target are not measured."""
    skip = {*MEASURES} - {"pack", "weight", "stock"}
    return make_shell(read_design_file(EXAMPLES / f"{name}.toml"), skip=skip)


def rows_of(file: Path) -> list[dict[str, str]]:
    with file.open(newline="") as stream:
        return [*csv.DictReader(stream)]


def read_sound(file: Path) -> Drawing:
    drawing = ezdxf.readfile(file)
    auditor = drawing.audit()
    assert not auditor.errors
    assert not auditor.fixes
    return drawing


def names_in(files: list[Path]) -> Counter[str]:
    """How often each part number is written in drawings."""
    return Counter(
        text.dxf.text for file in files for text in read_sound(file).modelspace().query("TEXT")
    )


def booklet_counts(file: Path) -> dict[str, int]:
    """What the page of parts says: counts by the name that stands below each."""
    text = PdfReader(file).pages[1].extract_text()
    return {name: int(count) for count, name in re.findall(r"(\d+) x\n(.+)", text)}


@pytest.mark.parametrize("name", KITS)
def test_every_part_is_counted_once_in_all_files(name: str, tmp_path: Path) -> None:
    # Counted anew in each: names in drawings, rows of tables, words of the booklet.
    write_kit(shell_of(name), tmp_path / "kit")
    counts = booklet_counts(tmp_path / "kit/booklet/booklet.pdf")
    boards = rows_of(tmp_path / "kit/cut/boards.csv")
    sides = Counter(row["side"] for row in boards)
    called = {"Upper boards": "top", "Lower boards": "bottom", "Boards": "panel"}
    assert {called[key]: n for key, n in counts.items() if key in called} == sides
    drawings = names_in(sorted((tmp_path / "kit/cut").glob("pattern-[bp]*.dxf")))
    assert {row["part"]: drawings[row["part"]] for row in boards} == dict.fromkeys(
        (row["part"] for row in boards), 1
    )
    if sides["panel"]:
        hinges = rows_of(tmp_path / "kit/hinges/hinges.csv")
        arms = rows_of(tmp_path / "kit/cut/arms.csv")
        assert counts["Hinges"] == len(hinges) == len({row["hinge"] for row in hinges})
        kinds = Counter(row[key] for row in hinges for key in ("kind_1", "kind_2") if row[key])
        assert kinds == {row["kind"]: int(row["count"]) for row in arms}
        assert counts["Arms"] == kinds.total()
    split = counts.get("Parts of the sheet", counts.get("Parts of the membrane", 0))
    if split:  # the parts of the sheet are numbered from 1, those of clipped flaps go on
        numbers = names_in(sorted((tmp_path / "kit/fabric").glob("pattern-[0-9]*.dxf")))
        flaps = counts.get("Flaps to clip on", 0)
        assert {name for name in numbers if name.isdecimal()} >= {*map(str, range(1, split + 1))}
        assert split + flaps <= len([name for name in numbers if name.isdecimal()])
    readme = (tmp_path / "kit/README.md").read_text()
    for part, count in counts.items():
        assert f"| {part.lower()} | {count} |" in readme


@thorough
@pytest.mark.parametrize("name", [QUICK, "shelter_hinged"])
def test_the_solids_of_step_are_the_parts_of_the_booklet(name: str, tmp_path: Path) -> None:
    require_build123d()
    write_kit(shell_of(name), tmp_path / "kit")
    (step,) = find_formats(["step"])
    write_format(shell_of(name), step, tmp_path, Settings())
    solids = (tmp_path / step.file).read_text()
    counts = booklet_counts(tmp_path / "kit/booklet/booklet.pdf")
    sides = Counter(re.findall(r"PRODUCT\('[^']*( top| bottom| arm| knuckle)[^']*',", solids))
    fittings = sides[" arm"] + sides[" knuckle"]
    boards = sum(counts.get(key, 0) for key in ("Upper boards", "Lower boards", "Boards"))
    assert solids.count("MANIFOLD_SOLID_BREP(") - fittings == boards
    assert sides[" top"] == counts.get("Upper boards", 0)
    assert sides[" bottom"] == counts.get("Lower boards", 0)
    assert sides[" arm"] == counts.get("Arms", 0)


@pytest.mark.parametrize("name", [QUICK, "canopy"])
@pytest.mark.parametrize("paper", [False, True], ids=["kit", "paper"])
def test_every_file_is_in_its_folder_and_named_in_the_readme(
    name: str, paper: bool, tmp_path: Path
) -> None:
    kit = write_kit(shell_of(name), tmp_path, paper=paper)
    found = {path for path in tmp_path.rglob("*") if path.is_file() and path.name[0] != "."}
    assert found == set(kit.files)
    folders = {path.parent.relative_to(tmp_path).as_posix().replace(".", "") for path in found}
    assert folders <= set(TRADES)
    readme = (tmp_path / "README.md").read_text()
    for folder in folders - {""}:
        assert f"| {folder}/ |" in readme
    for file in found - {tmp_path / "README.md"}:
        numbered = re.sub(r"-\d+\.", "-N.", file.name)
        assert file.name in readme or f"{numbered} (N = 1 to" in readme
    booklet = tmp_path / "booklet/booklet.pdf"
    assert booklet.stat().st_size < MOST_BYTES
    require_sound(booklet)


def test_the_table_names_every_file_that_is_written(tmp_path: Path) -> None:
    # A format that writes another file fails here, and wants a row.
    for name in (QUICK, "canopy"):
        shell = shell_of(name)
        for format_ in find_formats({*FORMATS, *CARD}):
            write_format(
                shell, format_, tmp_path, Settings(workshop=shell.file.workshop, ground=True)
            )
    for file in tmp_path.iterdir():
        folder = folder_of(file.name, "")
        assert folder is None or folder in TRADES
    assert {folder for _, folder in FOLDERS} - {None} == set(TRADES)
    assert folder_of("pattern.dxf", "bevel") == "hinges"  # a plan, not a sheet
    with pytest.raises(KeyError):
        folder_of("unknown.xyz", "")


@pytest.mark.parametrize("name", SHEETS)
def test_a_card_model_is_cut_at_its_scale_from_one_page(name: str, tmp_path: Path) -> None:
    shell = shell_of(name)
    kit = write_kit(shell, tmp_path, paper=True)
    drawing = read_sound(tmp_path / "fabric/pattern.dxf")
    assert drawing.header["$INSUNITS"] == 4  # mm
    # Creases in the drawing are as long as those of the sheet, in mm, times the scale.
    drawn = 0.0
    for line in drawing.modelspace().query('*[layer=="MOUNTAIN" | layer=="VALLEY"]'):
        assert isinstance(line, Line)
        ends = [line.dxf.start, line.dxf.end]
        drawn += sum(float(np.hypot(*(np.subtract(b, a)[:2]))) for a, b in pairwise(ends))
    length = shell.report.quantities.crease_length
    assert drawn == pytest.approx(1000 * kit.scale * (length.mountain + length.valley), rel=1e-9)
    (page,) = PdfReader(tmp_path / "fabric/pattern.pdf").pages
    upright = sorted(float(each) * 25.4 / 72 for each in page.mediabox[2:])
    assert upright == pytest.approx(PAPERS_MM["A4"], abs=0.01)
    assert f"Scale 1:{1 / kit.scale:g}" in page.extract_text()
    text = " ".join(
        each.extract_text() for each in PdfReader(tmp_path / "booklet/booklet.pdf").pages
    )
    assert f"Card model, 1:{1 / kit.scale:g} of the shell" in text
    for word in ("Anchor", "Load", "Carry", "kg"):
        assert word not in text


def test_sizes_of_a_model_are_those_of_the_shell_to_scale() -> None:
    shell = shell_of(QUICK)
    document = replace(shell.document, states=states_of(shell.motion))
    model = make_card_model(document, shell.file.workshop)
    whole, small = find_facts(document), find_facts(model.document)
    assert shell.document.unit == "mm"
    for name in ("sheet", "opened", "apart"):
        large, little = np.array(getattr(whole, name)), np.array(getattr(small, name))
        assert np.abs(little - model.scale * large).max() < 1e-9 * large.max()
    assert small.flaps == whole.flaps
    assert small.mass is None
    assert not small.packs


def test_a_scale_of_too_many_pages_is_refused() -> None:
    shell = shell_of("canopy")
    document = replace(shell.document, states=states_of(shell.motion))
    with pytest.raises(InputError, match="more than 400 pages") as caught:
        make_card_model(document, shell.file.workshop.having(paper_scale=0.5))
    assert "got 0.5" in str(caught.value)


def test_files_of_an_earlier_kit_are_removed_and_others_stay(tmp_path: Path) -> None:
    shell = shell_of(QUICK)
    first = write_kit(shell, tmp_path)
    (tmp_path / "cut/notes.txt").write_text("mine")
    second = write_kit(shell, tmp_path, paper=True)
    there = {path for path in tmp_path.rglob("*") if path.is_file() and path.name[0] != "."}
    assert there == {*second.files, tmp_path / "cut/notes.txt"}
    assert set(first.files) - there
    assert not (tmp_path / "hinges").exists()


def test_the_same_kit_again(tmp_path: Path) -> None:
    shell = shell_of(QUICK)
    one, other = (write_kit(shell, tmp_path / name) for name in ("one", "other"))
    for first, second in zip(one.files, other.files, strict=True):
        assert first.read_bytes() == second.read_bytes()
