"""What is offered because it carries all cases: typed in, it does."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from orishell.conventions.quantities import SPACE
from orishell.design_file import read_design_file
from orishell.shell import Shell, make_shell
from orishell.shell.steps import MEASURES
from orishell.structure.materials import materials
from small_arch import SMALL_ARCH

ARCH = (
    SMALL_ARCH
    + """[structure]
modulus = 9e9
strength = 40e6
crease_stiffness = "rigid"
crease_strength = 1e9
line_strength = 1e9
thickness = {thickness}
cells = {cells}
supports = [{{ at = "feet", kind = "{kind}" }}]
[[load_case]]
name = "snow"
snow = {{ ground = 20000, arrangement = "undrifted" }}
"""
)


def made(directory: Path, thickness: float, kind: str = "pinned") -> Shell:
    path = directory / "arch.toml"
    path.write_text(ARCH.format(thickness=thickness, kind=kind, cells=1))
    skip = ("verification", *MEASURES)
    return make_shell(read_design_file(path), clash="unexamined", skip=skip)


def offer(shell: Shell) -> str:
    return next(row.remedy for row in shell.report.verdict if row.subject == "stands")


def no_clock() -> float:
    raise AssertionError("a clock was asked what is to be offered")


def test_what_is_offered_carries(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """And no clock decides it."""
    for clock in ("thread_time", "process_time", "monotonic"):
        monkeypatch.setattr(f"time.{clock}", no_clock)
    weak = made(tmp_path, 0.003)
    assert weak.analysis is not None
    assert weak.analysis.carries is False
    row = next(row for row in weak.report.verdict if row.subject == "stands")
    assert re.fullmatch(r".*panels [\d.]+\s*mm thick carry all cases \(tried\)", row.remedy)
    strong = make_shell(weak.file.changed(row.changes), clash="unexamined")
    assert strong.analysis is not None
    assert strong.analysis.carries is True
    assert offer(strong) == ""


def test_no_thickness_holds_what_gives_way(tmp_path: Path) -> None:
    """Feet that slide, and panels that are far too soft to hold them together."""
    loose = made(tmp_path, 0.0003, "sliding")
    assert loose.analysis is not None
    assert loose.analysis.carries is False
    assert offer(loose).startswith("tried, and not enough: ties across the folds")


def of_plywood(directory: Path, thickness: float, snow: float) -> Shell:
    """The arch of birch plywood under so much snow."""
    path = directory / "arch.toml"
    text = ARCH.replace("modulus = 9e9\nstrength = 40e6", 'material = "birch plywood"')
    text = text.replace("20000", f"{snow:g}")
    path.write_text(text.format(thickness=thickness, kind="pinned", cells=1))
    skip = ("verification", *MEASURES)
    return make_shell(read_design_file(path), clash="unexamined", skip=skip)


def test_boards_of_a_material_are_offered_as_they_are_sold(tmp_path: Path) -> None:
    """And none beyond the thickest on the market, which is said."""
    weak = of_plywood(tmp_path, 0.005, 5000)
    row = next(row for row in weak.report.verdict if row.subject == "stands")
    assert row.changes["structure.thickness"] in materials()["birch plywood"].sold
    thickest = of_plywood(tmp_path, 0.04, 4e6)
    assert thickest.analysis is not None
    assert thickest.analysis.carries is False
    assert ": no thicker board of birch plywood is on the market (40 mm)" in offer(
        thickest
    ).replace(SPACE, " ")


def test_it_is_not_tried_where_every_case_would_be_followed_again(tmp_path: Path) -> None:
    """Large displacements take a minute a case, and nothing could end them in time.

    As designed, not off its shape, it buckles, and what is said of its last load is in balance,
    without the nudge that found more.
    """
    path = tmp_path / "arch.toml"
    text = ARCH.replace("[[load_case]]", "nonlinear = true\nimperfection = 0\n[[load_case]]")
    path.write_text(text.format(thickness=0.002, kind="pinned", cells=2))
    shell = make_shell(read_design_file(path), clash="unexamined")
    assert shell.analysis is not None
    assert shell.analysis.carries is False
    found = shell.analysis.cases[0].equilibrium
    assert found is not None
    assert found.path is not None
    assert found.path.ending == "branches"
    assert found.residual < 1e-8
    assert offer(shell).startswith("what would carry its loads is not sought")
