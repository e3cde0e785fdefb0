"""A design that carries, found from one that does not: typed in, it does; else what was tried."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from command_line import orishell
from orishell.conventions.quantities import SPACE
from orishell.design_file import DesignFile, read_design_file
from orishell.shell import carry, carry_steps, make_shell
from orishell.shell.carry import CarrySearch, find_carrying
from orishell.shell.carry_steps import Change
from orishell.shell.steps import MEASURES, Step
from small_arch import SMALL_ARCH

ARCH = (
    f"# a small arch\n{SMALL_ARCH}"
    + """[deployment]
from = "pack"
[panel]
thickness = {thickness}
construction = "bevel"
gap = 0.002
[structure]
material = "birch plywood"
crease_stiffness = "free"
tie_stiffness = 1e6
tie_strength = {tie_strength}
line_strength = {lines}
cells = 2
supports = [{{ at = "feet", kind = "pinned" }}]
[[load_case]]
name = "snow"
snow = {{ ground = {snow} }}
"""
)


def arch(
    directory: Path,
    thickness: float = 0.004,
    snow: float = 2000,
    lines: float = 150e3,
    tie_strength: float = 20e3,
) -> DesignFile:
    path = directory / "arch.toml"
    text = ARCH.format(thickness=thickness, snow=snow, lines=lines, tie_strength=tie_strength)
    path.write_text(text, encoding="utf-8")
    return read_design_file(path)


def no_clock() -> float:
    raise AssertionError("a clock was asked what is to be tried")


@pytest.fixture(scope="module")
def found(tmp_path_factory: pytest.TempPathFactory) -> tuple[DesignFile, CarrySearch]:
    file = arch(tmp_path_factory.mktemp("arch"))
    with pytest.MonkeyPatch.context() as patched:
        for clock in ("thread_time", "process_time", "monotonic"):
            patched.setattr(f"time.{clock}", no_clock)
        # Some steps of one order, so that it does not take long.
        some = (
            carry_steps.ties_across_folds,
            carry_steps.flaps,
            carry_steps.thicker,
            carry_steps.more_rows,
        )
        patched.setattr(carry, "BUILDER", some)
        patched.setattr(carry, "DESIGNER", ())
        return file, find_carrying(file)


def test_what_is_found_carries_once_it_is_typed_in(found: tuple[DesignFile, CarrySearch]) -> None:
    """As whole designs, contact included; no clock decides."""
    file, search = found
    assert search.begun.carries is False
    assert search.found
    for each in search.found:
        skip: tuple[Step, ...] = ("verification", "remedies", "stock", *MEASURES)
        made = make_shell(file.changed(each.change.values), skip=skip)
        assert made.analysis is not None
        assert made.analysis.carries is True
        assert made.analysis.model.mass == pytest.approx(each.mass)
        assert each.parts >= 1 + len(made.report.deployment.ties)
    masses = [each.mass for each in search.found]
    assert masses == sorted(masses)


def test_what_was_tried_is_said(found: tuple[DesignFile, CarrySearch]) -> None:
    _, search = found
    assert len(search.tried) >= len(search.found)
    assert len(search.tried) == len(set(search.tried))
    assert all(": " in each for each in search.tried)


def test_a_file_that_carries_is_left_alone(tmp_path: Path) -> None:
    search = find_carrying(arch(tmp_path, thickness=0.02, snow=60))
    assert search.begun.carries is True
    assert not search.found
    assert not search.tried


def test_the_search_ends_after_its_work(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(carry, "WORK", 1e-9)
    search = find_carrying(arch(tmp_path))
    assert search.ended
    assert not search.found
    assert search.nearest is not None


def test_changes_that_change_the_same_are_said_once() -> None:
    first = Change({"pattern.rows": 7, "deployment.ties": "folds"}, {"rows": "7 rows", "t": "ties"})
    both = first | Change({"pattern.rows": 9}, {"rows": "9 rows"})
    assert both.words == "9 rows, ties"
    assert both.values == {"pattern.rows": 9, "deployment.ties": "folds"}


def test_steps_propose_what_a_file_lacks(
    tmp_path: Path, found: tuple[DesignFile, CarrySearch]
) -> None:
    """And nothing where it has it: each change is a value that the file takes."""
    file, search = found
    for step in {*carry_steps.BUILDER, *carry_steps.DESIGNER}:
        for change in step(file, search.begun):
            changed = file.tried(change.values)
            assert changed.tables != file.tables
    held = file.tried(next(carry_steps.held_edges(file, search.begun)).values)
    assert not list(carry_steps.held_edges(held, search.begun))
    tied = file.tried(carry_steps.FOLDS)
    assert not list(carry_steps.ties_across_folds(tied, search.begun))
    rows = [each.values["deployment.ties"] for each in carry_steps.fewer_ties(tied, search.begun)]
    assert rows == ["feet", {"folds": [2, 5]}, {"folds": [2, 4]}]
    # A number is what its user knows of crease lines: no kind takes its place.
    assert not list(carry_steps.stronger_lines(file, search.begun))


def test_the_command_writes_design_files(
    tmp_path: Path, found: tuple[DesignFile, CarrySearch], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Those of the table, with the comments of the file; of the search itself see above."""
    _, search = found
    arch(tmp_path)
    monkeypatch.setattr(carry, "find_carrying", lambda *_: search)
    done = orishell("structure", "arch.toml", "--make-it-carry", "--out", "out", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert "Designs that carry, the lightest first" in done.stdout
    for number, each in enumerate(search.found, start=1):
        path = tmp_path / "out" / f"carries-{number}.toml"
        assert path.read_text(encoding="utf-8").startswith("# a small arch")
        written = read_design_file(path)
        assert written.tables == arch(tmp_path).changed(each.change.values).tables
        assert each.change.words.replace(SPACE, " ") in done.stdout


def test_where_none_carries_it_ends_with_status_1(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nothing makes crease lines of a model bear the snow of a mountain."""
    arch(tmp_path, snow=9e4, lines=10.0)
    monkeypatch.setattr(carry, "WORK", 0.05)
    done = orishell("structure", "arch.toml", "--make-it-carry", "--out", "out", cwd=tmp_path)
    assert done.returncode == 1
    assert "No design was found that carries." in done.stdout
    assert "Nearest came" in done.stdout
    assert "more would have taken too long" in done.stdout
    assert not (tmp_path / "out" / "carries-1.toml").exists()


def test_json_has_what_was_found_and_tried(
    tmp_path: Path, found: tuple[DesignFile, CarrySearch], monkeypatch: pytest.MonkeyPatch
) -> None:
    _, search = found
    arch(tmp_path)
    monkeypatch.setattr(carry, "find_carrying", lambda *_: search)
    done = orishell("structure", "arch.toml", "--make-it-carry", "--json", cwd=tmp_path)
    told = json.loads(done.stdout)
    assert [each["changes"] for each in told["found"]] == [
        dict(each.change.values) for each in search.found
    ]
    assert told["tried"] == list(search.tried)
    assert told["carries"] is False
