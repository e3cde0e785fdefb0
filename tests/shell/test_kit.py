"""Kits: every part counted once in all files, every file in its folder, models at their scale."""

from __future__ import annotations

import re
import signal
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from ezdxf.entities.line import Line
from pypdf import PdfReader

from kits import CARD_SHELL, read_sound, shell_of
from orishell.conventions.errors import InputError
from orishell.document.from_design import states_of
from orishell.io import OutputDirectory, Settings
from orishell.io.format import Format
from orishell.io.formats import find_formats
from orishell.shell import write_format, write_kit
from orishell.shell.export import write_document
from orishell.shell.fit.built_size import BuiltShell
from orishell.shell.kit import CARD, FOLDERS, FORMATS, TRADES, folder_of
from orishell.workshop.kit.card_model import make_card_model
from orishell.workshop.kit.facts import find_facts
from orishell.workshop.kit.parts import kit_parts, kit_tools
from orishell.workshop.kit.steps import kit_steps
from orishell.workshop.tiling import PAPERS_MM
from pdf_tools import require_sound
from samples import led_by, thorough

MOST_BYTES = 3_000_000
SHEETS = ["canopy", *(pytest.param(name, marks=thorough) for name in ("shelter", "dome_locked"))]


def files_in(directory: Path) -> dict[str, bytes]:
    """All files, lists of a kit's files too."""
    return {
        path.relative_to(directory).as_posix(): path.read_bytes()
        for path in directory.rglob("*")
        if path.is_file()
    }


@pytest.mark.parametrize("name", [CARD_SHELL, "canopy"])
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
    names: set[str] = set()
    for name in (CARD_SHELL, "canopy"):
        shell = shell_of(name)
        for format_ in find_formats({*FORMATS, *CARD}):
            settings = Settings(workshop=shell.file.workshop, ground=True)
            for file in write_format(shell, format_, tmp_path, settings):
                names.add(file.name)
    for name in names:
        folder = folder_of(name, "")
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
    shell = shell_of(CARD_SHELL)
    document = replace(shell.document, states=states_of(shell.motion))
    model = make_card_model(document, shell.file.workshop)
    clipped = [replace(piece, panel=None, boards=None) for piece in document.attached]
    bare = replace(document, panel=None, boards=None, attached=tuple(clipped))
    known, small = find_facts(bare), find_facts(model.document)
    whole = find_facts(replace(bare, measures=None))  # without boards
    assert shell.document.unit == "mm"
    for name in ("sheet", "opened", "whole", "apart"):
        of = known if name == "apart" else whole
        large, little = np.array(getattr(of, name)), np.array(getattr(small, name))
        assert np.abs(little - model.scale * large).max() < 1e-9 * large.max()
    assert small.attached == whole.attached
    assert small.mass is None
    assert not small.packs


@pytest.mark.parametrize("name", led_by([CARD_SHELL, "shelter_boards", "shelter_hinged"]))
def test_an_opened_shell_is_as_large_as_it_is_built(name: str) -> None:
    """As its report and [target.fit] have it: boards and what is clipped on, but no membrane."""
    shell = shell_of(name)
    document = replace(shell.document, states=states_of(shell.motion))
    whole = find_facts(document).whole
    built = BuiltShell.of(shell.design, shell.lock).outside()
    assert whole == pytest.approx(tuple(built), rel=1e-9)
    assert all(part <= of for part, of in zip(find_facts(document).opened, whole, strict=True))


@pytest.mark.parametrize("name", led_by([CARD_SHELL, "canopy", "dome_locked", "shelter"]))
def test_the_tape_reaches_all_that_is_measured(name: str) -> None:
    """Among the tools: diagonals of the flat sheet are longer than its sides."""
    shell = shell_of(name)
    document = replace(shell.document, states=states_of(shell.motion))
    facts, workshop = find_facts(document), shell.file.workshop
    tools = dict(kit_tools(document, facts, kit_parts(document, workshop, facts)))
    length, unit = tools["tape"]["length"].split()
    longest = max(np.ravel(facts.diagonals).max(), *facts.sheet, *facts.opened)
    steps = kit_steps(document, workshop, facts, kit_parts(document, workshop, facts))
    for crossed in re.findall(r": ([\d.]+)", " ".join(s.values.get("crossed", "") for s in steps)):
        longest = max(longest, float(crossed))
    assert unit == document.unit
    assert float(length) >= longest * (1 - 1e-9)


def test_a_scale_of_too_many_pages_is_refused() -> None:
    shell = shell_of("canopy")
    document = replace(shell.document, states=states_of(shell.motion))
    with pytest.raises(InputError, match="more than 400 pages") as caught:
        make_card_model(document, shell.file.workshop.replace_unchecked(paper_scale=0.5))
    assert "got 0.5" in str(caught.value)


def test_files_of_an_earlier_kit_are_removed_and_others_stay(tmp_path: Path) -> None:
    shell = shell_of(CARD_SHELL)
    first = write_kit(shell, tmp_path)
    (tmp_path / "cut/notes.txt").write_text("mine")
    second = write_kit(shell, tmp_path, paper=True)
    there = {path for path in tmp_path.rglob("*") if path.is_file() and path.name[0] != "."}
    assert there == {*second.files, tmp_path / "cut/notes.txt"}
    assert set(first.files) - there
    assert not (tmp_path / "hinges").exists()


def test_the_same_kit_again(tmp_path: Path) -> None:
    shell = shell_of(CARD_SHELL)
    one, other = (write_kit(shell, tmp_path / name) for name in ("one", "other"))
    for first, second in zip(one.files, other.files, strict=True):
        assert first.read_bytes() == second.read_bytes()


def test_what_other_commands_wrote_there_stays(tmp_path: Path) -> None:
    shell = shell_of(CARD_SHELL)
    (table,) = find_formats(["csv"])
    with OutputDirectory(tmp_path).replacing() as draft:
        write_format(shell, table, draft, Settings(workshop=shell.file.workshop))
    before = files_in(tmp_path)
    kit = write_kit(shell, tmp_path)
    both = files_in(tmp_path)
    assert {**both, **before} == both  # order.csv is the same in both
    with OutputDirectory(tmp_path).replacing() as draft:
        (draft / "other").write_text("other")
    assert {*kit.files} - {tmp_path / "order.csv"} <= {*tmp_path.rglob("*")}


def test_a_kit_that_fails_changes_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    shell = shell_of(CARD_SHELL)
    write_kit(shell, tmp_path / "kit", paper=True)
    (tmp_path / "kit/hinges/schedule.csv").mkdir(parents=True)
    before = files_in(tmp_path)
    with pytest.raises(InputError, match="a directory is in the way of a file"):
        write_kit(shell, tmp_path / "kit")  # the last of the folders but one cannot be written
    assert files_in(tmp_path) == before

    def fails(format_: Format, *rest: Any) -> None:
        if format_.name == "booklet":
            raise OSError(28, "No space left on device")
        write_document(format_, *rest)

    monkeypatch.setattr("orishell.shell.kit.write_document", fails)
    with pytest.raises(InputError, match="cannot be written; got No space left on device"):
        write_kit(shell, tmp_path / "other")
    assert files_in(tmp_path) == before
    assert not (tmp_path / "other").exists()


def test_a_kit_that_is_stopped_while_files_are_moved_is_whole(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # Ctrl-C comes while the files of the first folder are moved, and is heeded after the last.
    shell, move = shell_of(CARD_SHELL), OutputDirectory._move
    write_kit(shell, tmp_path / "whole")

    def stopped(place: OutputDirectory, *rest: Any) -> None:
        move(place, *rest)
        signal.raise_signal(signal.SIGINT)

    monkeypatch.setattr(OutputDirectory, "_move", stopped)
    before = signal.signal(signal.SIGINT, signal.default_int_handler)  # ignored in the background
    try:
        with pytest.raises(KeyboardInterrupt):
            write_kit(shell, tmp_path / "stopped")
    finally:
        signal.signal(signal.SIGINT, before)
    assert files_in(tmp_path / "stopped") == files_in(tmp_path / "whole")
