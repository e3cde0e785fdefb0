"""End walls of shells of all families: they meet nothing, close their end, and change nothing."""

from __future__ import annotations

import itertools
import re
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from design_tables import Tables, formula, made, mended, refused, tables
from documents import EXAMPLES
from orishell.conventions.errors import DesignError, InputError
from orishell.design.end_walls import BuiltEndWall
from orishell.design_file import check_design, read_design_file
from orishell.document import SHELL, Document
from orishell.io.format import Settings
from orishell.io.formats.stl import write_stl
from orishell.numerics.arrays import Array
from orishell.shell import candidate
from orishell.shell.make import Shell, make_shell
from orishell.shell.steps import MEASURES
from orishell.workshop import Workshop
from orishell.workshop.kit.facts import find_facts
from orishell.workshop.kit.parts import kit_parts
from orishell.workshop.kit.steps import kit_steps
from orishell.workshop.kit.words import load_words
from orishell.workshop.printed_plan import print_ground
from overlaps import NOTHING
from samples import THOROUGH
from stiffened import bodies, common, random_design, shell_of

QUICK = (0, 1, 6, 7, 8, 9, 10, 11, 12)
"""Of all four families that are swept or fitted, and all builds."""
BOTH = [{"at": "first"}, {"at": "last"}]
NAMES = ("first wall", "last wall")
ARCH: Tables = {
    **tables(
        "orthodiagonal", formula("-x**2", -1, 1), formula("0.1*cos(2*pi*x)", 0, 2),
        rows=5, columns=5, flap=0, heading_deg=90, spacing="equal",
    ),
    "panel": {"thickness": 0.01, "membrane": 0.001, "density": 500, "membrane_density": 900},
}  # fmt: skip


@cache
def walled(number: int) -> Shell:
    """The first random shell of a number that stands, with a wall at both ends."""
    for attempt in itertools.count():
        design = random_design(number, attempt)
        del design["stiffeners"]
        try:
            return shell_of({**design, "end_wall": BOTH})
        except InputError:
            continue
        except DesignError as error:
            # A shell that cannot stand, and one that reaches past its end, have no walls.
            keys = {key for key in error.keys if key.startswith("end_wall")}
            assert keys <= {"end_wall", "end_wall.0.at", "end_wall.1.at"}
    raise AssertionError


def parts_at(document: Document, wall: BuiltEndWall) -> list[Array]:
    """Corners (N, 3) of the strips of a wall, its boards' where it has some."""
    mine = [
        (part, state)
        for part, state in document.parts_in(SHELL)
        if part.kind == "end_wall" and part.names[0].startswith(wall.at)
    ]
    assert sum(len(part.mesh.faces) for part, _ in mine) == wall.panels
    return [part.corners(state) for part, state in mine]


def rest_of(document: Document) -> Array:
    """Corners (N, 3) of all that is no end wall."""
    return np.concatenate(
        [part.corners(state) for part, state in document.parts_in(SHELL) if part.kind != "end_wall"]
    )


def plane_of(corners: Array, shell: Array) -> Array:
    """The unit normal (3,) of an upright wall's corners (N, 3), away from a shell's (M, 3)."""
    _, _, axes = np.linalg.svd(corners[:, :2] - corners[:, :2].mean(axis=0), full_matrices=False)
    out = np.append(axes[-1], 0.0)
    return np.asarray(out * np.sign((corners.mean(axis=0) - shell.mean(axis=0)) @ out))


@pytest.mark.slow
@pytest.mark.parametrize("number", range(48) if THOROUGH else QUICK)
def test_walls_of_random_shells_meet_nothing_and_keep_their_distance(number: int) -> None:
    """manifold3d finds nothing in common; distances are measured from corners in files."""
    shell = walled(number)
    document, design = shell.document, shell.design
    names, solids = bodies(document)
    total = sum(each.volume() for each in solids)
    shared = common(names, solids, NAMES)
    apart = {pair: volume for pair, volume in shared.items() if not _neighbours(*pair)}
    assert max(apart.values(), default=0.0) < NOTHING * total
    rest = rest_of(document)
    ground = -float(design.origin[2])
    for wall in design.end_walls:
        corners = np.concatenate(parts_at(document, wall))
        assert corners[:, 2].min() == pytest.approx(ground, abs=1e-9)
        out = plane_of(corners, rest)
        face = float((corners @ out).min())
        right = np.cross([0.0, 0.0, 1.0], out)
        low, high = (corners @ right).min(), (corners @ right).max()
        before = rest[((rest @ right) > low) & ((rest @ right) < high)]
        assert face - (before @ out).max() >= wall.clearance * (1 - 1e-6)
        vertices = design.hinges.vertices(
            design.mechanism.positions(design.mechanism.target_drive)
        )[tuple(wall.laced.T)]
        np.testing.assert_allclose(face - vertices @ out, wall.lengths, rtol=0, atol=1e-9)
        assert wall.farthest >= wall.longest_string
        # It is as high as what it closes, over every vertex of its border.
        assert corners[:, 2].max() - ground >= vertices[:, 2].max() - ground - 1e-9
        assert wall.height == pytest.approx(corners[:, 2].max() - ground, abs=1e-9)
        assert wall.width == pytest.approx(high - low, abs=1e-9)


def _neighbours(first: str, second: str) -> bool:
    """Whether both are strips of one wall, which stand side by side."""
    return first.partition("wall")[0] == second.partition("wall")[0] and "wall" in first


@pytest.mark.slow
@pytest.mark.parametrize("number", range(48) if THOROUGH else QUICK[:4])
def test_walls_change_nothing_of_the_shell(number: int) -> None:
    shell = walled(number)
    bare = shell_of({k: v for k, v in shell.file.tables.items() if k != "end_wall"})
    mine, theirs = (each.report.as_dict() for each in (shell, bare))
    same = ("lock", "freedom", "degrees_of_freedom", "stands", "sheet", "deployed", "assignment")
    for key in same:
        assert mine[key] == theirs[key]
    assert shell.design.fixed_by == bare.design.fixed_by
    flat = [[part.kind for part, _ in each.document.parts_in("flat")] for each in (shell, bare)]
    assert flat[0] == flat[1]


@pytest.mark.slow
@pytest.mark.parametrize("name", ["arch_pattern", "shelter_hinged", "figure1"])
def test_a_drawn_sheet_whole_boards_and_folded_flaps_have_walls(name: str) -> None:
    file = read_design_file(EXAMPLES / f"{name}.toml")
    shell = make_shell(file.changed({"end_wall": BOTH}), skip=(*MEASURES, "remedies", "stock"))
    names, solids = bodies(shell.document)
    total = sum(each.volume() for each in solids)
    shared = common(names, solids, NAMES)
    apart = [volume for pair, volume in shared.items() if not _neighbours(*pair)]
    assert max(apart, default=0.0) < NOTHING * total
    for wall in shell.design.end_walls:
        assert wall.farthest < 0.05 * wall.height
    (row, _) = (row for row in shell.report.verdict if row.subject == "closed")
    assert row.sign == "holds"


def arch(**wall: object) -> Tables:
    return {**ARCH, "end_wall": [{"at": "last", **wall}]}


@cache
def shell() -> Shell:
    return made(arch(door={"width": 0.6, "height": 0.6}))


def test_the_report_has_what_was_asked_and_found() -> None:
    report = shell().report
    (wall,) = report.end_walls
    walls: Any = report.as_dict()["end_walls"]
    (table,) = walls
    assert table["at"] == "last"
    assert table["door"] == {"width": 0.6, "height": 0.6, "offset": 0.0}
    assert table["strings"] == len(wall.laced) == wall.strings
    assert "end_walls" not in made(ARCH).report.as_dict()
    assert any("end walls" in each for each in report.not_checked)
    opening = 0.6 * 0.6
    (whole,) = made(arch()).report.end_walls
    assert whole.area - opening == pytest.approx(wall.area, rel=1e-6, abs=1e-3)


@pytest.mark.parametrize("door", [None, {"width": 0.3, "height": 0.5}], ids=["whole", "door"])
def test_the_plan_of_the_ground_has_where_walls_stand(door: Tables | None) -> None:
    """Beyond the feet of their ends, as long as they are wide, but for a door in the midst."""
    walls = [{"at": "first", **({} if door is None else {"door": door})}, {"at": "last"}]
    file = check_design({**ARCH, "end_wall": walls}, Path("x.toml"))
    shell = make_shell(file, skip=["remedies", "deviation", "verification", "stock"])
    plan = shell.document.ground
    assert plan is not None
    lengths = [float(np.hypot(*np.diff(each, axis=0)[0])) for each in plan.walls]
    first, last = shell.report.end_walls
    if door is None:
        assert lengths == pytest.approx([first.width, last.width], rel=1e-9)
    else:
        assert len(lengths) == 3
        assert sum(lengths[:2]) == pytest.approx(first.width - door["width"], rel=1e-9)
        gap = np.abs(np.subtract.outer(plan.walls[0][:, 1], plan.walls[1][:, 1])).min()
        assert gap == pytest.approx(door["width"], rel=1e-9)
    feet = [foot.x for foot in plan.feet]
    xs = np.concatenate(plan.walls)[:, 0]
    assert xs.min() < min(feet)
    assert xs.max() > max(feet)
    assert not ((xs > min(feet)) & (xs < max(feet))).any()
    # As large on paper as the rest of the plan.
    printed = print_ground(shell.document, "A4")
    assert printed is not None
    drawn = [np.hypot(*np.diff(line.points, axis=0)[0]) for line in printed.pages[0].lines]
    for each in lengths:
        assert np.isclose(drawn, 1000 * each / printed.scale, rtol=1e-9).any()


def test_a_wall_far_from_its_border_is_warned_of() -> None:
    (row,) = (r for r in made(arch(gap=0.2)).report.verdict if r.subject == "closed")
    assert row.sign == "warns"
    assert "stay open" in row.finding


def test_files_drawings_and_kit_have_it(tmp_path: Path) -> None:
    with_it, bare = shell(), made(ARCH)
    panels = with_it.design.end_walls[0].panels
    sizes = []
    for state in (SHELL, "flat"):
        of_both = []
        for each in (with_it, bare):
            write_stl(tmp_path / "shell.stl", each.document, Settings(state=state))
            of_both.append((tmp_path / "shell.stl").stat().st_size)
        sizes.append(of_both[0] - of_both[1])
    assert sizes[0] > 0
    assert sizes[1] == 0
    document = with_it.document
    facts = find_facts(document)
    parts = {part.name: part for part in kit_parts(document, Workshop(), facts)}
    assert parts["end_wall"].count == panels
    assert parts["string"].count == with_it.design.end_walls[0].strings
    steps = kit_steps(document, Workshop(), facts, tuple(parts.values()))
    names = [step.name for step in steps]
    assert names.index("fit_end_wall") > names.index("anchor")
    for language in ("en", "de"):
        words = load_words(language)
        step = steps[names.index("fit_end_wall")]
        assert str(parts["string"].count) in words.say("steps.fit_end_wall.text", **step.values)
        words.say("parts.end_wall_note", **parts["end_wall"].values)


def test_its_mass_stands_on_the_ground_and_in_the_bill() -> None:
    with_it, bare = shell(), made(ARCH)
    built = [each.report.quantities.built for each in (with_it, bare)]
    assert built[0] is not None
    assert built[1] is not None
    area = with_it.design.end_walls[0].area
    boards = [each.mass_kg.boards for each in built if each is not None]
    assert boards[0] is not None
    assert boards[1] is not None
    # Two boards of 4.5 mm, 500 kg/m3.
    assert boards[0] - boards[1] == pytest.approx(area * 0.009 * 500, rel=1e-9)


@pytest.mark.parametrize("sides", ["top", "bottom"])
def test_boards_on_one_side_make_strips_with_boards_on_one_side(sides: str) -> None:
    panel = {**ARCH["panel"], "sides": sides}
    one = made({**arch(gap=0.005), "panel": panel})
    (wall,) = one.design.end_walls
    corners = np.concatenate(parts_at(one.document, wall))
    out = plane_of(corners, rest_of(one.document))
    boards = [part.boards for part in one.document.attached if part.boards is not None]
    assert {each for board in boards for each in board.sides.tolist()} == {
        1 if sides == "top" else -1
    }
    # With the bare membrane inside, boards are as far behind the inner face as it is thick.
    before = (rest_of(one.document) @ out).max()
    bare = 0.001 if sides == "top" else 0.0
    assert (corners @ out).min() - before >= 0.005 + bare - 1e-9


LOADED: Tables = {
    "structure": {
        "modulus": 8e9, "strength": 20e6, "cells": 1, "crease_stiffness": "rigid",
        "line_strength": 1e6, "crease_strength": 1e4,
        "membrane_modulus": 1e9, "membrane_strength": 1e9,
        "supports": [{"at": "feet", "kind": "pinned"}],
    },
    "load_case": [
        {"name": "dead", "self_weight": True},
        {"name": "gust", "self_weight": True,
         "wind": {"speed": 5, "terrain": "II", "direction_deg": 90}},
    ],
}  # fmt: skip


def test_wind_on_it_is_said_not_to_be_counted_and_nothing_else_of_the_structure_changes() -> None:
    with_it, bare = (made({**each, **LOADED}).report.structure for each in (arch(), ARCH))
    assert with_it is not None
    assert bare is not None
    for mine, theirs in zip(with_it.cases, bare.cases, strict=True):
        np.testing.assert_allclose(mine.forces, theirs.forces, rtol=0, atol=1e-12)
        windy = mine.name == "gust"
        said = [each for each in mine.findings if "wind on its end walls" in each.text]
        assert len(said) == windy
        assert [each.text for each in mine.findings if each not in said] == [
            each.text for each in theirs.findings
        ]
        if windy:
            assert theirs.carries
            assert mine.carries is None
        else:
            assert mine.carries == theirs.carries
    assert "wind on its end walls" in with_it.in_words()


REFUSED = {
    "cannot stand": {**ARCH, "target": {"f": formula("x**2", -1, 1), "g": ARCH["target"]["g"]}},
    "too far from the end": arch(gap=0.5),
    "no room for its door": arch(door={"width": 0.6, "height": 2.0}),
    "no room for its door ": arch(door={"width": 1.6, "height": 0.7}),
    "no room for its door  ": arch(door={"width": 0.6, "height": 0.6, "offset": 1.2}),
}


@pytest.mark.slow
@pytest.mark.parametrize("words", REFUSED)
def test_what_is_offered_instead_of_a_refusal_makes_a_shell(words: str) -> None:
    design = {"end_wall": [{"at": "last"}], **REFUSED[words]}
    error = refused(design)
    assert error is not None
    assert words.strip() in str(error)
    assert error.candidates
    for remedy in error.candidates:
        assert refused(mended(design, remedy)) is None


@pytest.mark.parametrize("height", [0.95, 2.0])
def test_a_door_is_refused_before_the_proof_with_how_large_a_shell_has_room(
    monkeypatch: pytest.MonkeyPatch, height: float
) -> None:
    """A shell of this form, made so many times as large, has room for it, and hardly less has not.

    That no wall has room is said where the door is higher than the shell, and only there.
    """
    design = arch(door={"width": 0.6, "height": height})

    def begun(*_: Any, **__: Any) -> None:
        raise AssertionError("a proof was begun")

    with monkeypatch.context() as patched:
        patched.setattr(candidate, "ended", begun)
        with pytest.raises(DesignError) as caught:
            make_shell(check_design(design, Path("shell.toml")), skip=["remedies"])
    error = caught.value
    said = re.search(r"has room for it at ([\d.]+) times its size", error.size)
    assert said is not None
    factor = float(said[1])
    assert factor > 1
    for share, does in ((1.0, True), (0.99, False)):
        target = {key: {**ARCH["target"][key], "scale": share * factor} for key in "fg"}
        found = refused({**design, "target": target})
        assert (found is None) is does
    assert ("no wall of it has room" in error.size) is (height > shell().report.outside.height)


def test_strips_fit_the_stock_that_boards_are_cut_from() -> None:
    """The wall is 2.03 m high, and sheets are 1.3 m long."""
    f = formula("-2*x**2", -1, 1)
    high = {**arch(), "target": {**ARCH["target"], "f": f}}
    high["pattern"] = {**high["pattern"], "rows": 9}
    cut = made({**high, "workshop": {"stock": [1.3, 0.7]}})
    assert cut.design.end_walls[0].height > 1.3
    assert cut.design.end_walls[0].panels > made(high).design.end_walls[0].panels
    assert cut.report.quantities.stock is not None
    for part in cut.document.attached:
        sides = np.sort(np.ptp(part.require_flat(), axis=0))
        assert (sides <= [0.7 + 1e-9, 1.3 + 1e-9]).all()


def test_sizes_asked_for_are_those_of_the_shell_without_its_walls() -> None:
    fit = {**ARCH["target"], "fit": {"width": 2.2, "of": "outside"}}
    with_it = make_shell(check_design({**arch(), "target": fit}, Path("shell.toml")), skip=MEASURES)
    assert with_it.report.fitted is not None
    assert with_it.report.deployed.width == pytest.approx(2.2, abs=1e-3)
    assert with_it.report.outside.width > with_it.report.deployed.width + 0.005
