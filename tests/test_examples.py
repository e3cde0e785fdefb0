"""The examples run, and their shells have the sizes that their design files ask for."""

import importlib.util
import math
import runpy
from functools import cache
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from kept import kept_shell

from orishell import Shell
from orishell.deployment import find_pack
from orishell.design import Setback
from orishell.design_file import read_design_file
from orishell.motion import extents, sheet_area
from orishell.numerics.arrays import Array
from orishell.shell.steps import MEASURES
from orishell.solids import drive_for_height
from samples import thorough

EXAMPLES = Path(__file__).parents[1] / "examples"
SHELLS = ("shelter", "tunnel", "canopy", "vault", "from_dxf", "from_svg")
PANELS = (0.2, 1.35)
"""Shortest and longest edge of a panel: what one person can carry (metres)."""


def test_figure_1(capsys: pytest.CaptureFixture[str]) -> None:
    runpy.run_path(str(EXAMPLES / "figure1.py"), run_name="__main__")
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "11 x 13 vertices"
    assert lines[1] == "f is met to 0.1335, g to 0.1134"
    assert lines[2].startswith("panels keep their lengths to ")


def test_figure_2(capsys: pytest.CaptureFixture[str]) -> None:
    runpy.run_path(str(EXAMPLES / "figure2.py"), run_name="__main__")
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "f is met to 0.1200, g to 0.0051"
    assert lines[1].startswith("its ends stand on the ground to ")
    assert float(lines[1].split()[-1]) < 1e-12
    assert lines[2].startswith("panels keep their lengths to ")
    assert lines[3].startswith("neighbouring rows meet inside the sheet: at heading_deg = 60 ")
    assert "heading_deg must lie between" in lines[3]


def test_sectors(capsys: pytest.CaptureFixture[str]) -> None:
    """The paper's Figure 3 from angles and lengths alone: the radius goes from r to 1.67 r."""
    runpy.run_path(str(EXAMPLES / "sectors.py"), run_name="__main__")
    lines = capsys.readouterr().out.splitlines()
    first, last = (float(line.split()[0]) for line in lines[0].split("radius ")[1].split(", "))
    assert first / last == pytest.approx(1.67, abs=0.02)
    assert lines[1] == "panels first touch at 8.7802 degrees of v_1: the last frame"
    assert lines[2].startswith("sine version: panels keep their lengths to ")
    assert float(lines[2].split()[-1]) < 1e-14
    assert lines[3] == "it goes on to 119.7471 degrees, where it is ended by a crease"


class Example:
    """An example's module, its shell, and what it measures of it."""

    def __init__(self, name: str) -> None:
        self.name = name
        spec = importlib.util.spec_from_file_location(name, EXAMPLES / f"{name}.py")
        assert spec is not None
        assert spec.loader is not None
        self.module: ModuleType = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(self.module)
        # The distance from the surface takes longest, and no other example's sizes need what goes
        # with it.
        file = read_design_file(EXAMPLES / f"{name}.toml")
        self.shell: Shell = kept_shell(file, skip=() if name.startswith("shelter") else MEASURES)
        self.size: dict[str, float] = self.module.measure(self.shell)


@cache
def load(name: str) -> Example:
    return Example(name)


@pytest.fixture(params=SHELLS)
def example(request: pytest.FixtureRequest) -> Example:
    return load(request.param)


@pytest.mark.slow
def test_ends_as_it_says(example: Example) -> None:
    """Flaps lock it, it is stopped at f, or opened from its pack; on the way nothing touches."""
    lock = example.shell.report.lock
    assert example.shell.report.feasible
    assert example.shell.design.warnings == ()
    assert not example.shell.lock.early
    if example.name == "vault":
        assert lock.cause == "clash"
        assert lock.drive is not None
        assert lock.target_drive < lock.drive
    else:
        cause = "crease" if example.name == "shelter" else "flaps"
        assert (lock.cause, lock.drive, lock.touching_at_end) == (cause, np.pi, ())
        assert lock.first_contact is not None
        assert np.rad2deg(lock.first_contact.clear_until) == pytest.approx(180, abs=1e-3)


def test_panels_are_of_a_size_to_carry(example: Example) -> None:
    flat = example.shell.motion.flat.positions
    edges = [np.linalg.norm(np.diff(flat, axis=axis), axis=-1) for axis in (0, 1)]
    assert min(each.min() for each in edges) > PANELS[0]
    assert max(each.max() for each in edges) < PANELS[1]


def test_prints_its_sizes(
    example: Example, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(example.module, "design", lambda: example.shell)
    monkeypatch.setattr("sys.argv", [example.name])
    example.module.main()
    lines = capsys.readouterr().out.splitlines()
    assert 3 <= len(lines) <= 5
    key = {"vault": "growth", "tunnel": "length", "canopy": "rise", "shelter": "headroom"}
    shown = example.size[key.get(example.name, "sheet width")]
    assert any(f"{shown:.2f}" in line for line in lines)


def test_shelter() -> None:
    """What its design file promises: 3 m by 6 m of floor, 2 m of headroom, level ground."""
    shelter = load("shelter")
    size = shelter.size
    assert 3.0 <= size["clear width"] < 3.1
    assert size["length"] == pytest.approx(6, abs=1e-12)  # g's range
    assert 2.0 < size["headroom"] < 2.3
    assert size["uneven"] < 1e-12
    lowest = shelter.shell.motion.target.positions[..., 2].argmin(axis=0)
    assert set(lowest.tolist()) <= {0, shelter.shell.design.mechanism.grid.rows - 1}


def test_shelter_travels() -> None:
    """From 6.0 x 3.3 x 2.4 m to a flat bundle, proved all the way; 72 panels on each other."""
    shelter = load("shelter")
    size, shell = shelter.size, shelter.shell
    assert [round(extent, 1) for extent in extents(shell.motion.target.positions)] == [6, 3.3, 2.4]
    assert size["pack length"] == pytest.approx(2.093, abs=1e-3)
    assert size["pack width"] == pytest.approx(1.229, abs=1e-3)
    assert size["pack height"] < 0.0002
    assert size["layers"] == 72  # of 10 mm: 0.72 m, as its design file says
    assert shell.motion.pack == shell.lock.closes_to
    assert shell.lock.path is not None
    assert shell.report.warnings == ()


def test_shelter_is_held() -> None:
    """It closes, with 31 of 812 N, and flaps carry that; ties hold it where it would fall flat."""
    shelter = load("shelter")
    size, deployment = shelter.size, shelter.shell.report.deployment
    assert size["closing force"] == pytest.approx(31.25, abs=0.05)
    assert size["weight"] == pytest.approx(9.81 * 1.9 * size["sheet"], rel=0.02)
    assert (deployment.closing, deployment.opening) == ("clipped flaps", "ties")
    assert size["ties"] == len(deployment.ties) == 13
    assert deployment.weight is not None
    (tipping,) = np.rad2deg(deployment.weight.tipping)
    # It would fall flat if it were opened by 6 degrees more.
    assert 5 < np.rad2deg(shelter.shell.report.lock.target_drive) - tipping < 6


def test_shelter_is_cut_from_boards() -> None:
    """The boards hold the sheet and its flaps, and weigh what 1.9 kg/m2 of them weigh."""
    shelter = load("shelter")
    size = shelter.size
    area = sheet_area(shelter.shell.motion.flat.positions)
    assert size["sheet"] == pytest.approx(area, rel=1e-12)
    flaps = sum(board.areas().sum() for board in shelter.shell.document.attached)
    assert size["flaps"] == pytest.approx(flaps, rel=1e-9)
    assert size["mass"] == pytest.approx(1.9 * (area + flaps), rel=1e-12)
    assert size["boards"] * 2.44 * 1.22 > area + flaps
    assert size["boards"] < 30


def test_tunnel() -> None:
    """g is 1.75 radians of a circle of 8 m; f spans 3.6 m and rises by f(0) - f(1.8)."""
    size = load("tunnel").size
    # A circle's chords are equal: 24 of them, inscribed.
    assert size["length"] == pytest.approx(24 * 2 * 8 * math.sin(1.75 / 48), rel=1e-9)
    assert size["turn_deg"] == pytest.approx(math.degrees(1.75), rel=1e-9)
    assert size["width"] == pytest.approx(3.6, abs=1e-9)
    rise = 1.7 * (math.sqrt(1.8**2 + 0.5) - math.sqrt(0.5))
    # The corner over f's middle is among the farthest: they are equal but for rounding.
    assert size["headroom"] == pytest.approx(rise, abs=size["from f"] * (1 + 1e-12))
    assert size["headroom"] > 2
    assert size["uneven"] < 1e-12


def test_canopy() -> None:
    """g is 300 degrees of a circle; the flat sheet turns by less, by spherical trigonometry."""
    size = load("canopy").size
    assert size["outer radius"] - size["inner radius"] == pytest.approx(3.2, abs=1e-9)
    assert size["turn_deg"] == pytest.approx(300, abs=0.01)
    # Equation (2): cos alpha_4 = cos delta sin(xi/2), delta = 90 - 5 degrees for 30 equal chords.
    step = math.asin(math.cos(math.radians(90 - 5)) * math.sin(math.radians(85 / 2)))
    assert size["flat_turn_deg"] == pytest.approx(30 * math.degrees(2 * step), abs=0.01)


def test_vault() -> None:
    """f is an arc of 2.2 m; the radius grows by a quarter, as its design file says."""
    size = load("vault").size
    assert size["largest radius"] == pytest.approx(2.2, rel=0.01)
    assert size["growth"] == pytest.approx(1.25, abs=0.03)
    assert size["length"] == pytest.approx(7, abs=0.01)
    assert size["span"] == pytest.approx(2 * 2.2 * math.cos(0.1), abs=0.03)
    assert size["contact_deg"] > 2 * size["stage_deg"]


@pytest.mark.parametrize("name", ["from_dxf", "from_svg"])
def test_from_drawings(name: str) -> None:
    """The arch: ends 819.6 mm from its axis, arcs of 1200 and 600 mm; built twice as large."""
    size = load(name).size
    assert size["span of f"] == pytest.approx(2 * 2 * 0.819615242271, abs=1e-6)
    assert size["rise of f"] == pytest.approx(2 * 0.380384757729, abs=1e-5)
    if name == "from_svg":
        assert size["from f"] == pytest.approx(0.12, abs=1e-9)  # depth, in from_svg.toml


@pytest.mark.slow
def test_figure_1_card(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """One sheet of A3 paper, one of card, boards that can be cut; and it folds to its target."""
    monkeypatch.setattr("sys.argv", ["figure1_card.py", str(tmp_path)])
    runpy.run_path(str(EXAMPLES / "figure1_card.py"), run_name="__main__")
    assert capsys.readouterr().out.splitlines() == [
        "407 mm x 180 mm of paper on 1 sheet of A3",
        "96 boards on 1 sheet of card, the narrowest 6.2 mm wide",
        "109 g; it folds by 130.5 degrees at most",
    ]
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        "pattern-1.svg",
        "pattern-back-1.svg",
        "pattern-boards-1.svg",
        "pattern.svg",
    ]
    shell = kept_shell(read_design_file(EXAMPLES / "figure1_card.toml"), skip=MEASURES)
    assert shell.report.feasible
    assert (shell.report.lock.cause, shell.lock.early) == ("boards", False)


@pytest.mark.slow
def test_shelter_of_boards(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Boards of 10 mm panels: what they stand back, weigh and take; and no two of them meet."""
    kit = load("shelter_boards")
    shell, size = kit.shell, kit.size
    assert shell.report.feasible
    assert (shell.report.lock.cause, shell.lock.early) == ("boards", False)
    assert shell.report.lock.first_contact is None
    assert shell.report.not_checked == ("how clipped flaps are brought to their place",)
    # s = b tan(phi/2) with b = 5 mm, at the crease that folds most; the pack ends where two of
    # them take half of the way across a panel.
    fold = size["largest fold"]
    assert fold == pytest.approx(177.093, abs=1e-3)
    back = 0.005 * math.tan(math.radians(fold / 2))
    assert size["largest set-back"] == pytest.approx(back, rel=1e-5)
    assert back == pytest.approx(0.197, abs=5e-4)
    # Two boards on each of 12 x 12 panels, and of 12 on both flaps.
    assert size["boards"] == 2 * 12 * (12 + 2)
    assert size["corners cut"] == 0
    # Masses from areas: boards of 4.75 mm and 190 kg/m3, fabric of 0.5 mm and 1000 kg/m3.
    assert shell.document.boards is not None
    areas = [shell.document.boards.areas().sum()]
    areas += [
        piece.boards.areas().sum() for piece in shell.document.attached if piece.boards is not None
    ]
    assert size["board area"] == pytest.approx(sum(areas), rel=1e-9)
    assert size["mass of boards"] == pytest.approx(0.00475 * 190 * size["board area"], rel=1e-9)
    assert size["mass of fabric"] == pytest.approx(0.5 * size["fabric area"], rel=1e-9)
    assert [round(size[f"mass of {each}"]) for each in ("boards", "fabric")] == [64, 24]
    assert size["fabric area"] == pytest.approx(shell.report.quantities.area, rel=1e-9)
    # Own weight is that of the sheet, flaps left out.
    weight = shell.report.deployment.weight
    assert weight is not None
    assert weight.force_unit == "N"
    sheet_mass = 0.00475 * 190 * areas[0] + 0.5 * shell.report.sheet.area
    assert weight.total == pytest.approx(9.81 * sheet_mass, rel=1e-6)
    # The box that its design file names, which 72 panels of 10 mm fit into; sheets that hold them.
    pack = [size[f"pack {each}"] for each in ("length", "width", "height")]
    assert pack == pytest.approx([2.10, 1.23, 0.97], abs=0.005)
    assert size["layers"] * 0.010 < size["pack height"]
    assert size["board area"] / (2.44 * 1.22) < size["sheets of board"] == 33
    # With shorter set-backs a larger one, as the design file says.
    sheet = shell.design.mechanism
    assert shell.design.panel is not None
    build = shell.design.panel.replace_unchecked(largest_setback=Setback(length=0.05))
    assert (build.height, build.gap) == (0.005, 0.004)
    box = find_pack(sheet, drive_for_height(sheet, build), 5, 0.010).box
    assert [box.length, box.width, box.height] == pytest.approx([3.2, 2.2, 1.3], abs=0.05)
    # Flaps stop where set-backs of their boards take half of the way between their row creases.
    assert size["stop of flaps"] == pytest.approx(5.55, abs=1e-9)
    monkeypatch.setattr(kit.module, "design", lambda: shell)
    kit.module.main()
    assert capsys.readouterr().out.splitlines() == [
        "336 boards, set back by up to 197 mm from creases that fold by up to 177.1 degrees",
        "a pack of 2.10 m x 1.23 m x 0.97 m, 72 panels on each other",
        "64 kg of boards from 33 sheets, 24 kg of fabric, 159 m of hinges",
        "flaps stop 5.55 degrees short of folding flat, and bear on 7.4 m of edges",
    ]


@thorough
@pytest.mark.slow
def test_the_kit_of_boards_does_not_carry_snow_and_wind() -> None:
    module = runpy.run_path(str(EXAMPLES / "shelter_structure.py"))
    design, judge, with_creases = (module[name] for name in ("design", "judge", "with_creases"))
    boards = design()
    report = boards.report.structure
    assert report is not None
    assert report.governs is not None
    governs = report.governs
    assert (governs.part, governs.case, governs.creases) == (
        "buckling",
        "winter, drifted right",
        "free",
    )
    kit = judge(boards, with_creases(boards))
    assert kit.mass == pytest.approx(86.8, abs=0.05)
    assert kit.buckling == pytest.approx(0.0241, rel=0.01)
    assert kit.displaced > 1
    assert not kit.carries
    # With free creases it is far too soft for a storm, pinned as it is.
    moving = {(case.name, case.stiffness) for case in boards.analysis.cases if case.motion}
    assert moving == {("storm across", 0.0), ("storm along", 0.0)}


@thorough
@pytest.mark.slow
def test_plywood_with_locked_creases_carries_snow_and_wind() -> None:
    module = runpy.run_path(str(EXAMPLES / "shelter_structure.py"))
    judge, with_creases = module["judge"], module["with_creases"]
    plywood = module["design"](module["PLYWOOD"])
    rigid = judge(plywood, with_creases(plywood))
    assert rigid.carries
    assert (round(rigid.buckling, 2), round(rigid.displaced, 3)) == (4.78, 0.010)


@thorough
@pytest.mark.slow
def test_whole_boards_carry_more_snow_than_boards_on_a_membrane() -> None:
    """Figures of the guide, hinges locked, under 0.5 kN/m2 of snow; nothing with free ones."""
    module = runpy.run_path(str(EXAMPLES / "shelter_constructions.py"))
    design, load, snow = module["design"], module["load"], module["SNOW"]
    expected = {
        "sandwich": ((3.41, 2.15, 1.09, 1.54), 3.40),
        "hinged, arms of 1 mm": ((0.68, 0.34, 0.16, 0.62), 2.28),
        "in three pieces": ((0.58, 0.30, 0.14, 0.65), 2.34),
    }
    for name, (shares, buckling) in expected.items():
        last = "membrane" if name == "sandwich" else "arms"
        used = dict(zip(("panels", "panel_shear", "rolling_shear", last), shares, strict=True))
        shell = design(name)
        found = load(shell, snow)
        assert found.used == pytest.approx(used, abs=0.01)
        assert found.buckling == pytest.approx(buckling, abs=0.01)
        assert load(shell, 0.0, 0.0).share > 1


@thorough
@pytest.mark.slow
def test_plywood_stands_with_creases_of_some_stiffness_and_on_the_ground() -> None:
    module = runpy.run_path(str(EXAMPLES / "shelter_structure.py"))
    judge, with_creases = module["judge"], module["with_creases"]
    plywood = module["design"](module["PLYWOOD"])
    sprung, free = (judge(plywood, with_creases(plywood, k)) for k in (2e4, 0.0))
    assert (sprung.carries, free.carries) == (True, False)
    assert [round(each.buckling, 2) for each in (sprung, free)] == [3.51, 0.51]
    assert [round(each.displaced, 3) for each in (sprung, free)] == [0.014, 0.208]
    # What the gallery says of cells half as large.
    rigid, finer = (judge(plywood, with_creases(plywood, **more)) for more in ({}, {"cells": 8}))
    assert finer.displaced / rigid.displaced == pytest.approx(1.025, abs=0.002)
    assert finer.buckling / rigid.buckling == pytest.approx(0.98, abs=0.005)
    assert finer.used / rigid.used == pytest.approx(1.11, abs=0.01)
    ground = module["on_the_ground"](plywood, 0.0).cases
    assert [case.name for case in ground if case.motion] == ["storm across", "storm along"]
    (snow,) = (case for case in ground if not case.motion)
    pulls = snow.equilibrium.tie_forces
    assert pulls.max() == pytest.approx(984, abs=1)
    assert pulls.argmax() in {0, len(pulls) - 1}  # at a gable
    (rough,) = (case for case in module["on_the_ground"](plywood, 0.3).cases if not case.motion)
    assert rough.equilibrium.friction <= 1 + 1e-9  # stuck feet would need 3.08 times what there is


def test_loads_of_the_shelter_by_hand() -> None:
    """Snow on the plan, wind on the faces, reactions against both: from areas and formulas."""
    module = runpy.run_path(str(EXAMPLES / "shelter_structure.py"))
    plywood = module["design"](module["PLYWOOD"])
    found = module["with_creases"](plywood, cells=1)
    by_name = {case.name: case for case in found.cases}
    positions = plywood.design.mechanism.positions(plywood.design.mechanism.target_drive)
    across = positions[1:, 1:] - positions[:-1, :-1]
    down = positions[1:, :-1] - positions[:-1, 1:]
    area = 0.5 * np.cross(across, down).reshape(-1, 3)
    area *= np.sign(area[:, 2].sum())
    size = np.linalg.norm(area, axis=1)
    rise = np.ptp(positions[..., 2])
    # EN 1991-1-3, 5.3.5 (i): 0.8 on the plan of all that looks up.
    snow = 500 * 0.8 * area[:, 2].clip(0).sum()
    # EN 1991-1-4, terrain II: z0 = 0.05 m, 0.19 ln(z/z0), I = 1/ln(z/z0); air of 1.25 kg/m3.
    log = math.log(rise / 0.05)
    pressure = (1 + 7 / log) * 0.5 * 1.25 * (26 * 0.19 * log) ** 2

    def wind(x: float, y: float) -> Array:
        facing = np.degrees(np.arccos(-(area @ [x, y, 0]) / size))
        return np.asarray(-pressure * np.interp(facing, [0, 90, 180], [0.8, -1, -0.4]) @ area)

    weight = np.array([0, 0, -9.81 * found.model.mass])
    expected = {
        "winter, undrifted": 1.35 * weight + [0, 0, -1.5 * snow] + 0.9 * wind(0, 1),
        "storm across": weight + 1.5 * wind(0, 1),
        "storm along": weight + 1.5 * wind(1, 0),
    }
    drifted = {"winter, drifted left", "winter, drifted right"}
    assert set(by_name) == set(expected) | drifted
    for name in drifted:  # 3/8 of mu_3 = 2 over the width, a little less by where panels overlap
        snowed = by_name[name].load - 1.35 * weight - 0.9 * wind(0, 1)
        assert snowed[2] == pytest.approx(-1.5 * 0.375 / 0.4 * snow, rel=0.1)
    for name, load in expected.items():
        case = by_name[name]
        assert case.load == pytest.approx(load, rel=1e-6, abs=1e-3)
        assert case.equilibrium.reaction == pytest.approx(-load, rel=1e-6, abs=1e-3)
        assert case.equilibrium.residual < 1e-9
    # Panels and flaps, 10.2 kg per square metre; wind alone lifts more than that weighs.
    assert found.model.mass > 10.2 * size.sum()
    assert wind(0, 1)[2] > -weight[2]


@pytest.mark.slow
def test_writes_the_pattern(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """With a directory, ``from_dxf.py`` writes the shell's files and the pattern for a cutter."""
    monkeypatch.setattr("sys.argv", ["from_dxf.py", str(tmp_path / "roof")])
    runpy.run_path(str(EXAMPLES / "from_dxf.py"), run_name="__main__")
    written = {path.name for path in (tmp_path / "roof").iterdir()}
    assert {"pattern.dxf", "shell.fold", "report.json", "overview.png"} <= written


def test_gallery_has_a_page_for_every_example() -> None:
    """Each design file is shown by a page, and each page runs on files that are there."""
    pages = "".join(path.read_text() for path in (EXAMPLES / "gallery").glob("plot_*.py"))
    for path in EXAMPLES.glob("*.toml"):
        assert path.name in pages
