"""Nothing of the user's is lost: foreign and changed files where commands write.

The properties, whatever a command does: a file that orishell did not write, or that was changed
since, has its bytes afterwards, and so has every file that the command reads. A refusal leaves the
folder as it was.
"""

from __future__ import annotations

import os
import random
import resource
import shutil
import tempfile
from collections.abc import Callable
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from command_line import orishell
from documents import EXAMPLES, demo_document
from kits import CARD_SHELL, shell_of
from orishell.conventions.errors import InputError
from orishell.document import Document
from orishell.io import OutputDirectory, write_fold
from orishell.io.format import Format
from orishell.io.formats import find_formats
from orishell.io.manifest import LISTS
from orishell.shell import convert_fold, write_kit, write_shell, write_structure
from orishell.shell.folded import Folded, fold_pattern, write_folded
from orishell.shell.make import Shell, design_shell
from patterns import miura, write
from samples import thorough

WRITERS = ("design", "kit", "fold", "convert", "structure", "write_fold")


@cache
def _loaded() -> Shell:
    return design_shell(EXAMPLES / "shelter_structure.toml", clash="unexamined")


@cache
def _folded(source: Path) -> Folded:
    return fold_pattern(source, unit="mm", frames=3)


@pytest.fixture(scope="module")
def source(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A crease pattern outside of all folders."""
    place = tmp_path_factory.mktemp("source")
    write_fold(place / "states.fold", demo_document())
    return write(place / "miura.fold", miura(3, 4))


def writer(name: str, source: Path, chance: random.Random) -> Callable[[Path, bool], object]:
    """What writes into a folder, in one of its variations, with force or without it."""
    shell = shell_of(CARD_SHELL)
    match name:
        case "design":
            formats = find_formats(chance.choice([["svg"], ["obj", "csv"]]))
            return lambda out, force: write_shell(shell, out, formats, force=force)
        case "kit":
            paper = chance.random() < 0.5
            return lambda out, force: write_kit(shell, out, paper=paper, force=force)
        case "fold":
            return lambda out, force: write_folded(_folded(source), out, force=force)
        case "convert":
            states = source.with_name("states.fold")
            target = chance.choice(["pattern.svg", "shell.obj", "shell.fold"])
            return lambda out, force: convert_fold(states, out / target, force=force)
        case "structure":
            return lambda out, force: write_structure(_loaded(), out, force=force)
        case _:
            return lambda out, force: write_fold(out / "shell.fold", demo_document(), force=force)


def files_in(folder: Path) -> dict[Path, bytes]:
    """All files but lists, by their paths."""
    return {
        path: path.read_bytes()
        for path in folder.rglob("*")
        if path.is_file() and not LISTS.fullmatch(path.name)
    }


def disturb(out: Path, names: list[Path], chance: random.Random) -> dict[Path, bytes]:
    """Change some of the files, add some under such names and others; what is the user's then."""
    mine = {}
    for number, name in enumerate(chance.sample(names, chance.randrange(min(4, len(names) + 1)))):
        path = out / name
        path.parent.mkdir(parents=True, exist_ok=True)
        before = path.read_bytes() if path.exists() else b""
        mine[path] = before + f"\n# mine {number}\n".encode()
        path.write_bytes(mine[path])
    (out / "notes.txt").write_text("mine")
    return mine | {out / "notes.txt": b"mine"}


def trial(name: str, seed: int, source: Path, place: Path) -> str:
    """One folder: perhaps a first run, then the user, then a run of the same or another variation.

    Returns how it went.
    """
    chance = random.Random(seed)
    probe, out = place / "probe", place / "out"
    out.mkdir(parents=True)
    run = writer(name, source, chance)
    run(probe, False)
    names = sorted(path.relative_to(probe) for path in files_in(probe))
    if chance.random() < 0.7:
        writer(name, source, chance)(out, False)
    mine = disturb(out, names, chance)
    before = files_in(out)
    refused = ""
    try:
        run(out, False)
    except InputError as error:
        refused = error.what
    if refused:
        assert "not of orishell" in refused or "changed since orishell wrote it" in refused
        assert files_in(out) == before
        assert len(mine) > 1  # never refused for what it does not write
        run(out, True)  # the remedy works
        written = files_in(out)
        assert all((out / each).read_bytes() == (probe / each).read_bytes() for each in names)
        assert {path for path in mine if path.relative_to(out) not in names} <= {*written}
        ended = "refused"
    else:
        after = files_in(out)
        assert {path: after.get(path) for path in mine} == mine
        ended = "written"
    assert not [path for path in out.rglob(".orishell-*") if path.is_dir()]
    run(out, False)  # its own files it writes again
    shutil.rmtree(place)
    return ended


@pytest.fixture
def copied(monkeypatch: pytest.MonkeyPatch) -> None:
    """Files are drawn once, then copied: what is tried here is where they go."""
    kept: dict[tuple[str, ...], dict[str, bytes]] = {}

    def copying(draw: Callable[..., object]) -> Callable[..., None]:
        def drawn(*arguments: Any, **named: Any) -> None:
            first = [each.name for each in arguments[:2] if isinstance(each, Format)]
            path = next(each for each in arguments[:2] if isinstance(each, Path))
            names = [each for each in (*first, path.name) if not each.startswith(".")]
            model = [each.model_scale for each in arguments if isinstance(each, Document)]
            key = (draw.__name__, *names, *map(str, model))
            folder = path.parent if first else path
            if key not in kept:
                before = {*folder.iterdir()}
                draw(*arguments, **named)
                new = {*folder.iterdir()} - before
                kept[key] = {each.name: each.read_bytes() for each in new}
            for name, content in kept[key].items():
                (folder / name).write_bytes(content)

        return drawn

    for name in (
        "export.write_document",
        "kit.write_document",
        "export.draw_pictures",
        "export.write_structure_files",
    ):
        module, function = name.split(".")
        draw = getattr(import_module(f"orishell.shell.{module}"), function)
        monkeypatch.setattr(f"orishell.shell.{name}", copying(draw))


@pytest.mark.usefixtures("copied")
@pytest.mark.parametrize("name", ["fold", "convert", "write_fold"])
def test_nothing_is_lost(name: str, source: Path, tmp_path: Path) -> None:
    ends = {trial(name, seed, source, tmp_path / str(seed)) for seed in range(4)}
    assert "refused" in ends


@thorough
@pytest.mark.slow
@pytest.mark.usefixtures("copied")
@pytest.mark.parametrize("name", WRITERS)
def test_nothing_is_lost_in_a_hundred_runs(name: str, source: Path, tmp_path: Path) -> None:
    ends = [trial(name, seed, source, tmp_path / str(seed)) for seed in range(100)]
    assert min(ends.count("refused"), ends.count("written")) > 10


def put(path: Path, text: str) -> None:
    with OutputDirectory(path.parent, inputs=(path.parent / "mine",), force=True).adding() as draft:
        (draft / path.name).write_text(text)


@pytest.mark.parametrize("kind", ["itself", "link", "hard link", "link to it", "chain"])
def test_what_is_read_is_never_written_over(kind: str, tmp_path: Path) -> None:
    """By none of its names, also not with force."""
    mine, other = tmp_path / "mine", tmp_path / "other"
    mine.write_text("mine")
    match kind:
        case "itself":
            other = mine
        case "link to it":
            other.symlink_to(mine)
        case "hard link":
            os.link(mine, other)
        case "link":
            mine.rename(other)
            mine.symlink_to(other)
        case _:
            (tmp_path / "between").symlink_to(mine)
            other.symlink_to("between")
    there = {path: path.is_symlink() for path in tmp_path.iterdir()}
    with pytest.raises(InputError, match="this file is read, and would be written over"):
        put(other, "new")
    assert {path: path.is_symlink() for path in tmp_path.iterdir()} == there
    assert all(path.read_text() == "mine" for path in there)
    put(tmp_path / "third", "new")
    assert mine.read_text() == "mine"


def test_what_is_read_is_not_removed_with_an_earlier_run(tmp_path: Path) -> None:
    with OutputDirectory(tmp_path).replacing() as draft:
        (draft / "pattern.svg").write_text("drawing")
    with OutputDirectory(tmp_path, inputs=(tmp_path / "pattern.svg",)).replacing() as draft:
        (draft / "report.json").write_text("{}")
    assert (tmp_path / "pattern.svg").read_text() == "drawing"


def test_a_design_is_not_written_over_its_own_files(tmp_path: Path) -> None:
    """A design beside its drawing: the drawing, a report and a picture of the user's stay."""
    shutil.copy(EXAMPLES / "arch_pattern.svg", tmp_path / "pattern.svg")
    text = (EXAMPLES / "arch_pattern.toml").read_text().replace("arch_pattern.svg", "pattern.svg")
    (tmp_path / "own.toml").write_text(text)
    before = files_in(tmp_path)
    design = ("design", "own.toml", "--out", ".", "--write", "svg")
    for more in ((), ("--force",)):
        ran = orishell(*design, *more, cwd=tmp_path)
        assert ran.returncode == 2
        assert "pattern.svg: this file is read, and would be written over" in ran.stderr
        assert files_in(tmp_path) == before
    for name in ("report.json", "shell.fold", "overview.png"):
        (tmp_path / name).write_text("mine")
        ran = orishell("design", "own.toml", "--out", ".", cwd=tmp_path)
        assert ran.returncode == 2
        assert f"{name}: this file is not of orishell" in ran.stderr
        (tmp_path / name).unlink()
        assert files_in(tmp_path) == before


def test_fold_and_convert_and_check_leave_what_they_read(source: Path, tmp_path: Path) -> None:
    shutil.copy(source, tmp_path / "shell.fold")
    before = files_in(tmp_path)
    for command in (
        ("fold", "shell.fold", "--unit", "mm", "--out", "."),
        ("convert", "shell.fold", "shell.fold"),
        ("check", "shell.fold", "--nearby", "shell.fold"),
    ):
        for more in ((), ("--force",)):
            ran = orishell(*command, *more, cwd=tmp_path)
            assert ran.returncode == 2
            assert "shell.fold: this file is read, and would be written over" in ran.stderr
            assert files_in(tmp_path) == before


def test_a_kit_over_a_kit_that_was_changed(tmp_path: Path) -> None:
    """An order that was written into, and a drawing that was changed: no kit beside them."""
    shell = shell_of(CARD_SHELL)
    write_kit(shell, tmp_path)
    for name in ("order.csv", "README.md", "fabric/pattern.dxf"):
        path = tmp_path / name
        whole = path.read_bytes()
        path.write_bytes(whole + b"ordered\n")
        before = files_in(tmp_path)
        with pytest.raises(InputError, match=f"{path.name}: this file was changed"):
            write_kit(shell, tmp_path, paper=True)
        assert files_in(tmp_path) == before
        path.write_bytes(whole)
    write_kit(shell, tmp_path, paper=True)


# reportlab leaves a file open that it could not write
@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
@pytest.mark.filterwarnings("ignore::ResourceWarning")
def test_a_kit_needs_no_room_elsewhere_and_a_full_disk_is_one_message(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Files of a kit are drafted where they will be; none may be larger than 20 kB here."""
    shell = shell_of(CARD_SHELL)
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "none"))
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, before[1]))
    try:
        with pytest.raises(InputError, match="the files cannot be written; got File too large"):
            write_kit(shell, tmp_path / "kit")
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    assert not list(tmp_path.iterdir())
    write_kit(shell, tmp_path / "kit", paper=True)


def test_what_has_no_loads_is_not_checked_and_not_made(tmp_path: Path) -> None:
    file = EXAMPLES / "figure1.toml"
    ran = orishell("design", file, "--out", tmp_path / "out", "--check", cwd=tmp_path)
    assert ran.returncode == 2
    assert "there are no loads to check" in ran.stderr
    assert ran.stderr.count("orishell: ") == 1
    assert not list(tmp_path.iterdir())
