"""Hinges and arms of whole boards as parts: where they are, how many, and what they weigh."""

from __future__ import annotations

import csv
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely

from cad_tools import ask_freecad, require_build123d
from flat_foldables import random_sheet
from orishell.conventions.errors import DesignError
from orishell.design import HingeSpec, PanelSpec
from orishell.design.fittings import LARGEST_LEAF, TRIMMED, Fittings, fit_hinges
from orishell.design_file.file import check_design
from orishell.document import Document
from orishell.io.format import Settings
from orishell.io.formats.step import write_step
from orishell.io.formats.tables import write_tables
from orishell.motion import Mechanism, diagonal, drive_at_fold
from orishell.motion.boards import ARM, KNUCKLE
from orishell.motion.grid import CreaseValues
from orishell.motion.hinges import Hinges
from orishell.motion.quads import grid_corners, unit_normals
from orishell.numerics.arrays import Array
from orishell.shell.make import Shell, make_shell
from orishell.shell.steps import Step
from orishell.solids.hinged import find_hinges
from orishell.workshop import Workshop
from orishell.workshop.board_sheets import board_parts, draw_boards
from orishell.workshop.hinge_parts import draw_arms, fittings_of
from samples import thorough

PANEL: dict[str, Any] = {
    "construction": "hinged",
    "thickness": 0.02,
    "gap": 0.002,
    "density": 500,
    "arm_density": 7800,
    "hinge": {"knuckle": 0.004, "linear_density": 0.7},
}
TABLES: dict[str, Any] = {
    "shell": {"family": "flat-foldable", "unit": "m"},
    "pattern": {"rows": 3, "columns": 4, "sheet": "miura"},
    "panel": PANEL,
    "motion": {"frames": 3},
    "deployment": {"from": "pack"},
}
THICK, RADIUS = 0.02, 0.004


@cache
def shell() -> Shell:
    return make_shell(check_design(TABLES, Path("shell.toml")), skip=("remedies", "stock"))


def fittings() -> Fittings:
    found = fittings_of(shell().document)
    assert found is not None
    return found


def hinged(seed: int, **hinge: object) -> tuple[Mechanism, Hinges, PanelSpec, float]:
    sheet = random_sheet(seed)
    size = diagonal(sheet.positions(0.0))
    spec = HingeSpec().replace_unchecked(**hinge)
    build = PanelSpec(thickness=1e-3 * size, construction="hinged", hinge=spec)
    return sheet, find_hinges(sheet, build), build, size


def panels_of(sheet: Mechanism) -> Array:
    return grid_corners(sheet.positions(0.0))[..., :2].reshape(-1, 4, 2)


@pytest.mark.parametrize("seed", range(4))
def test_knuckles_stand_off_all_faces_and_loops_stay_closed(seed: int) -> None:
    sheet, thin, build, size = hinged(seed)
    knuckle = 7e-4 * size
    build = build.replace_unchecked(hinge=HingeSpec(knuckle=knuckle))
    hinges = find_hinges(sheet, build)
    for sign, arms in zip((hinges.signs.row, hinges.signs.column), hinges.arms, strict=True):
        assert arms[:, sign != 0].min() >= knuckle * (1 - 1e-9)
        assert not arms[:, sign == 0].any()
    faces = hinges.levels + 0.5 * hinges.thickness
    first = hinges.heights.row - faces[:-1]
    folds = hinges.signs.row != 0
    off = hinges.signs.row * first - 0.5 * hinges.thickness
    assert np.allclose(off[folds], hinges.arms[0][0][folds], atol=1e-12 * size)
    last = drive_at_fold(sheet, np.deg2rad(179.9))
    for drive in np.linspace(0.0, last, 5):
        assert hinges.gap(sheet.positions(drive)) <= 1e-12 * size
    # Arms are those of boards thicker by two knuckles, and one knuckle more.
    times = (build.thickness + 2 * knuckle) / build.thickness
    assert hinges.longest_arm == pytest.approx(times * thin.longest_arm + knuckle, rel=1e-9)


@pytest.mark.parametrize("seed", range(4))
def test_leaves_and_holes_lie_on_their_boards(seed: int) -> None:
    sheet, hinges, build, size = hinged(seed)
    panels = panels_of(sheet)
    found = fit_hinges(panels, hinges, build)
    middles, hinge, panel = found.holes()
    assert len(middles) == 2 * found.counts.sum()
    outlines = shapely.polygons(panels[panel])
    discs = shapely.buffer(shapely.points(middles), 0.5 * found.hole)
    assert shapely.covers(outlines, discs).all()
    # Each is half a leaf from the edge of its board, which is half a gap from the crease.
    lines = shapely.linestrings(found.ends[hinge])
    expected = found.away + 0.5 * found.leaves[hinge]
    np.testing.assert_allclose(
        shapely.distance(lines, shapely.points(middles)), expected, atol=1e-12 * size
    )
    folding = [sign != 0 for sign in (hinges.signs.row, hinges.signs.column)]
    assert len(found.edges) == sum(int(each.sum()) for each in folding)
    flat = sheet.positions(0.0)
    lengths = CreaseValues(
        np.linalg.norm(np.diff(flat[1:-1], axis=1), axis=-1),
        np.linalg.norm(np.diff(flat[:, 1:-1], axis=0), axis=-1),
    ).on_edges()[found.edges]
    np.testing.assert_allclose(found.lengths, (1 - 2 * TRIMMED) * lengths, rtol=1e-12)
    assert (found.counts >= 2).all()
    assert ((found.counts - 1) * found.steps <= found.lengths).all()


def test_arms_are_counted_by_kinds() -> None:
    found, document = fittings(), shell().document
    assert document.boards is not None
    fins = document.boards.chosen(document.boards.sides == ARM)
    assert sum(arm.count for arm in found.arms) == len(fins) == int((found.fins > 0).sum())
    # Fins end at the knuckle; the longest are on arms of three rows of boards and knuckles.
    tall = np.ptp(fins.outlines[:, :, 0, 2], axis=1)
    assert sorted(tall.tolist()) == pytest.approx(sorted(found.fins[found.fins > 0].tolist()))
    assert max(arm.height for arm in found.arms) == pytest.approx(3 * (THICK + 2 * RADIUS))
    kinds = {(round(arm.height, 9), round(arm.length, 9)) for arm in found.arms}
    assert len(kinds) == len(found.arms)
    for number, arm in enumerate(found.arms):
        mine = found.of_kind == number
        assert int(mine.sum()) == arm.count
        np.testing.assert_allclose(found.fins[mine], arm.height, atol=1e-3 * THICK)


def test_the_bill_weighs_arms_and_hinges() -> None:
    bill, found = shell().report.quantities.built, fittings()
    assert bill is not None
    assert bill.hinges is not None
    mass = bill.mass_kg
    sheet = sum(arm.count * arm.length * (arm.height + arm.foot) for arm in found.arms)
    assert bill.hinges.arm_area == pytest.approx(sheet)
    assert mass.arms == pytest.approx(7800 * 0.1 * THICK * sheet)
    assert mass.hinges == pytest.approx(0.7 * bill.hinges.length)
    assert mass.total == pytest.approx(
        sum(each for each in (mass.boards, mass.arms, mass.hinges) if each is not None)
    )
    in_fins = sum(arm.count * len(arm.along) for arm in found.arms if arm.in_fin is not None)
    assert bill.hinges.screws == 2 * found.counts.sum() + in_fins
    assert bill.hinge_length == bill.hinges.length == pytest.approx(found.lengths.sum())
    # Own weight is that of all.
    assert shell().site.areal_density * shell().report.sheet.area == pytest.approx(mass.total)
    assert not any("masses" in warning for warning in shell().report.warnings)


def test_what_is_not_known_is_said_and_not_in_the_total() -> None:
    panel = {key: value for key, value in PANEL.items() if key != "arm_density"}
    file = check_design({**TABLES, "panel": panel}, Path("shell.toml"))
    other = make_shell(file, skip=("remedies", "stock", "pack", "deviation"))
    bill = other.report.quantities.built
    assert bill is not None
    mass = bill.mass_kg
    assert mass.arms is None
    assert mass.boards is not None
    assert mass.hinges is not None
    assert mass.total == pytest.approx(mass.boards + mass.hinges)
    assert any("masses leave out arms or hinges" in warning for warning in other.report.warnings)


def test_masses_are_per_metre_and_per_cubic_metre() -> None:
    skip: tuple[Step, ...] = ("remedies", "stock", "pack", "deviation", "verification")
    tables = {**TABLES, "shell": {"family": "flat-foldable", "unit": "cm"}}
    small = make_shell(check_design(tables, Path("shell.toml")), clash="unexamined", skip=skip)
    large, bill = shell().report.quantities.built, small.report.quantities.built
    assert large is not None
    assert bill is not None
    for name, scale in (("boards", 1e-6), ("arms", 1e-6), ("hinges", 1e-2)):
        mass = getattr(large.mass_kg, name)
        assert getattr(bill.mass_kg, name) == pytest.approx(scale * mass, rel=1e-9)


def test_the_centre_of_mass_is_that_of_boards_arms_and_hinges() -> None:
    """But for the distance of fins from their creases, which the bill leaves out."""
    document, found, bill = shell().document, fittings(), shell().report.quantities.built
    boards = document.boards
    assert boards is not None
    assert isinstance(boards.hinges, Hinges)
    assert boards.edges is not None
    assert bill is not None
    assert bill.centre_of_mass is not None
    mass = np.where(boards.arms, 0.0, 500 * boards.volumes())
    places = document.boards_in(document.shell).reshape(len(boards), -1, 3).mean(axis=1)
    for kinds, panels, at in zip(found.of_kind.T, found.panels.T, found.at.T, strict=True):
        for kind, panel, edge in zip(kinds, panels, at, strict=True):
            if kind >= 0:
                mine = (boards.sides == ARM) & (boards.panels == panel) & (boards.edges == edge)
                mass[mine] = 7800 * 0.1 * THICK * found.arms[kind].area
    corners = document.panel_corners(document.shell)
    panel, edge = found.panels[:, 1], found.at[:, 1]
    middle = 0.5 * (corners[panel, edge] + corners[panel, (edge + 1) % 4])
    up = boards.hinges.heights.on_edges()[found.edges, None] * unit_normals(corners)[panel]
    hinges = 0.7 * found.lengths
    moment = mass @ places + hinges @ (middle + up)
    centre = moment / (mass.sum() + hinges.sum())
    assert bill.mass_kg.total == pytest.approx(mass.sum() + hinges.sum())
    away = 1e-4  # four times what was seen
    assert np.linalg.norm(document.in_world(centre) - bill.centre_of_mass) < away
    # Boards alone have it elsewhere.
    alone = mass[~boards.arms] @ places[~boards.arms] / mass[~boards.arms].sum()
    assert np.linalg.norm(centre - alone) > 4 * away


def test_tables_and_drawings_agree(tmp_path: Path) -> None:
    document, found = shell().document, fittings()
    write_tables(tmp_path / "panels.csv", document, Settings())
    hinges, arms = (
        list(csv.DictReader((tmp_path / f"{name}.csv").read_text().splitlines()))
        for name in ("hinges", "arms")
    )
    assert [row["hinge"] for row in hinges] == [f"H{edge}" for edge in found.edges]
    used = [row[key] for row in hinges for key in ("kind_1", "kind_2") if row[key]]
    assert {row["kind"]: int(row["count"]) for row in arms} == {
        kind: used.count(kind) for kind in used
    }
    assert sum(float(row["mass_kg"]) for row in hinges) == pytest.approx(0.7 * found.lengths.sum())
    # Names stand on both boards of a hinge, and holes on the layer of its face.
    names: dict[str, set[int]] = {}
    holes = dict.fromkeys(("VALLEY", "MOUNTAIN"), 0)
    for part in board_parts(document):
        for text in part.texts:
            if text.words.startswith("H"):
                names.setdefault(text.words, set()).add(part.panel)
        for circle in part.circles:
            holes[circle.layer] += 1
    assert names == {row["hinge"]: {int(row["panel_1"]), int(row["panel_2"])} for row in hinges}
    for layer, side in (("VALLEY", "top"), ("MOUNTAIN", "bottom")):
        assert holes[layer] == sum(2 * int(row["holes"]) for row in hinges if row["side"] == side)
    drawings = dict(draw_boards(document, Workshop()))
    assert set(drawings) == {"-panels", "-arms"}
    drawn = [line for line in drawings["-arms"].lines if line.layer == "CUT"]
    assert sorted(tuple(np.ptp(line.points, axis=0).round(9)) for line in drawn) == sorted(
        (round(arm.length, 9), round(arm.height + arm.foot, 9)) for arm in found.arms
    )


def test_arms_are_drawn_apart_with_their_holes_inside() -> None:
    drawing = draw_arms(shell().document, Workshop())
    assert drawing is not None
    blanks = [shapely.Polygon(line.points) for line in drawing.lines if line.layer == "CUT"]
    tree = shapely.STRtree(blanks)
    assert len(tree.query(blanks, predicate="intersects").T) == len(blanks)
    holes = [shapely.Point(circle.x, circle.y).buffer(circle.radius) for circle in drawing.circles]
    assert len(tree.query(holes, predicate="covered_by").T) == len(holes)
    assert shapely.union_all(holes).area == pytest.approx(sum(hole.area for hole in holes))


def test_fins_as_thick_as_leaves_are_wide_are_blocks_without_feet() -> None:
    sheet, hinges, build, _ = hinged(0)
    thick = build.replace_unchecked(arm_width=build.hinge.leaf_on(build.thickness))
    found, thin = (fit_hinges(panels_of(sheet), hinges, each) for each in (thick, build))
    assert found.arms
    assert not any(arm.foot or arm.in_foot for arm in found.arms)
    assert all(arm.foot and arm.in_foot for arm in thin.arms)
    assert [arm.height for arm in found.arms] == [arm.height for arm in thin.arms]
    # Holes of boards lead into the blocks.
    assert np.array_equal(found.holes()[0], thin.holes()[0])
    document = shell().document
    assert document.panel is not None
    drawing = draw_arms(
        replace(document, panel=document.panel.replace_unchecked(arm_width=0.04)), Workshop()
    )
    assert drawing is not None
    assert not any(line.layer == "ENGRAVE" for line in drawing.lines)


def test_leaves_may_take_half_of_the_way_across() -> None:
    sheet, hinges, build, size = hinged(0)
    panels = panels_of(sheet)

    def with_leaf(width: float) -> Fittings:
        return fit_hinges(panels, hinges, build.replace_unchecked(hinge=HingeSpec(leaf=width)))

    with pytest.raises(DesignError) as refusal:
        with_leaf(size)
    (remedy,) = refusal.value.candidates
    (most,) = remedy.changes.values()
    assert isinstance(most, float)
    assert (with_leaf(most).leaves == most).all()
    with pytest.raises(DesignError):
        with_leaf(1.01 * most)
    assert LARGEST_LEAF <= 0.5


def ask(document: Document, place: Path, state: str) -> tuple[int, float]:
    require_build123d()
    write_step(place / "shell-target.step", document, Settings())
    return ask_freecad(place / f"shell-{state}.step")


@thorough
def test_freecad_finds_boards_arms_and_knuckles_valid(tmp_path: Path) -> None:
    document = shell().document
    assert document.boards is not None
    solids, volume = ask(document, tmp_path, "pack")
    hinges, arms = (int((document.boards.sides == side).sum()) for side in (KNUCKLE, ARM))
    assert hinges == len(fittings().edges)
    assert solids == len(document.boards) == 20 + arms + hinges
    assert volume == pytest.approx(1e9 * document.boards.volumes().sum(), rel=1e-6)


@thorough
def test_freecad_opens_the_shelter(tmp_path: Path) -> None:
    from orishell.design_file import read_design_file

    path = Path(__file__).parents[3] / "examples" / "shelter_hinged.toml"
    skip: tuple[Step, ...] = ("remedies", "deviation", "weight", "stock", "verification", "pack")
    document = make_shell(read_design_file(path), clash="unexamined", skip=skip).document
    assert document.boards is not None
    solids, volume = ask(document, tmp_path, "target")
    assert solids == len(document.boards) == 144 + 198
    assert volume == pytest.approx(1e9 * document.boards.volumes().sum(), rel=1e-6)
