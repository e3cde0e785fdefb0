"""Box girders as parts of a structure: what strips and plates add, against CalculiX, in balance.

A small arch of twelve panels of 2 mm on pinned edges at its feet, all creases free, under its own
weight, with a box girder in its valley, and plates across it or none.
"""

from __future__ import annotations

import tomllib
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.sparse.linalg import splu

from calculix_tool import run_calculix
from design_tables import Tables, formula, tables
from hinged_decks import Deck, run_deck
from mechanisms import flat_foldable, random_net
from orishell import Shell
from orishell.conventions.errors import InputError
from orishell.conventions.quantities import GRAVITY
from orishell.design import PanelSpec
from orishell.design_file import check_design
from orishell.io.format import DEFAULT_SETTINGS
from orishell.io.formats.calculix import write_calculix
from orishell.motion import area_of
from orishell.motion.boards import Boards
from orishell.motion.grid import Grid
from orishell.motion.sleeves import Q, R, Sleeve, SleeveForms, W
from orishell.numerics.arrays import Array
from orishell.shell.make import make_shell
from orishell.structure import Analysis
from orishell.structure.carried import LEAST_JOINED, membrane_warnings
from orishell.structure.load_settings import LoadCase
from orishell.structure.mesh.girders import mesh_strips, stops_of_sleeves
from orishell.structure.mesh.parts import join_parts
from orishell.structure.mesh.sections import panel_sections
from orishell.structure.mesh.sheet import mesh_sheet
from orishell.structure.mesh.stops import Stops
from orishell.structure.model import Model
from orishell.structure.panel_forces import panel_forces
from orishell.structure.settings import Structure, Support
from orishell.structure.solve.active_set import respond
from samples import thorough

AREAL = 5.0


def arch(
    *, columns: Any = "none", share: float = 0.7, rows: str = "valleys", **asked: Any
) -> Shell:
    """The arch; of another ``share`` of edges or other ``rows``, and with keys of [structure]."""
    f, g = formula("-x**2", -1, 1), formula("0.1*cos(2*pi*x)", 0, 1.5)
    pattern = {"rows": 3, "columns": 4, "flap": 0, "heading_deg": 90, "spacing": "equal"}
    design: Tables = {
        **tables("orthodiagonal", f, g, **pattern),
        "workshop": {"areal_density": AREAL},
        "stiffeners": {"kind": "boxes", "rows": rows, "share": share, "columns": columns},
        "structure": {
            "modulus": 8e9,
            "thickness": 0.002,
            "supports": [{"at": "feet", "kind": "pinned", "edges": True}],
            "crease_stiffness": "free",
            "nonlinear": False,
            "cells": 3,
            **asked,
        },
        "load_case": [{"name": "weight", "self_weight": True}],
    }
    file = check_design(design, Path("x.toml"))
    return make_shell(file, clash="unexamined", skip=("remedies", "verification"))


@cache
def usual(columns: str = "none") -> Shell:
    """The arch with plates at so many columns."""
    return arch(columns=columns)


def analysed(columns: str = "none") -> Analysis:
    """Its analysis."""
    found = usual(columns).analysis
    assert found is not None
    return found


def linear(model: Model, forces: Array) -> Array:
    """Displacements (N, 3) under forces (N, 3) by linear theory, creases free."""
    found = model.factorised(0.0)
    response = respond(found, found.free_loads(forces))
    assert response.moves is None
    return found.shape(response.displacements)


@pytest.mark.parametrize(("columns", "motions"), [("none", 7), ("all", 6)])
def test_motions_that_take_no_force(columns: str, motions: int) -> None:
    """Six of the whole, and the one with which the sheet folds and the girder with it: no others.

    With plates the girder cannot, nor the sheet. Others take 1e-10 of what the stiffest does, at
    least; these 1e-16.
    """
    model = analysed(columns).model
    parts = [each.assembled() for each in model.plate_elements]
    values = np.linalg.eigvalsh(sum(parts, model.elements.assembled()).toarray())
    shares = np.abs(values) / values[-1]
    assert shares[:motions].max() < 1e-14
    assert shares[motions] > 1e-11


def test_soft_strips_change_nothing() -> None:
    """As their stiffness goes to nothing, displacements of panels go to those of the sheet alone.

    The mesh is the same, with its lines of nodes where strips hang. Displacements differ by 1.3e4
    times the share of stiffness that is left of strips.
    """
    model, forces = analysed().model, analysed().cases[0].forces
    supported, count = model.supports.dofs(model.mesh), model.mesh.count
    own = np.unique(model.elements.dofs)
    loads = np.zeros(count)
    loads[: forces.size] = forces.ravel()
    bare = model.elements.assembled()
    strips = sum((each.assembled() for each in model.plate_elements), 0 * bare)
    moved = []
    for share in (0.0, 1e-14):
        free = np.setdiff1d(own if not share else np.arange(count), supported)
        # Loads on nodes of strips would move these ever farther: they are left out here.
        given = np.where(np.isin(free, own), loads[free], 0.0)
        found = np.zeros(count)
        inner = (bare + share * strips)[free][:, free].tocsc()
        solve = splu(inner).solve
        for _ in range(3):  # what is rounded is found again
            found[free] += solve(given - inner @ found[free])
        moved.append(found[own])
    alone, with_strips = moved
    np.testing.assert_allclose(with_strips, alone, rtol=0, atol=1e-9 * np.abs(alone).max())


@pytest.mark.parametrize("columns", ["none", "all"])
def test_solved_as_its_matrix_is(columns: str) -> None:
    """Factorised part by part: displacements as of the whole matrix at once."""
    model, forces = analysed(columns).model, analysed(columns).cases[0].forces
    found = model.factorised(0.0)
    loads = found.free_loads(forces)
    response = respond(found, loads)
    matrix = sum((each.assembled() for each in found.elements[1:]), found.elements[0].assembled())
    direct = splu(matrix[found.free][:, found.free].tocsc()).solve(loads)
    np.testing.assert_allclose(
        response.displacements, direct, rtol=0, atol=1e-8 * np.abs(direct).max()
    )


@pytest.mark.parametrize("columns", ["none", "all"])
@pytest.mark.parametrize("cells", [6, pytest.param(8, marks=thorough)])
def test_calculix_agrees(columns: str, cells: int, tmp_path: Path) -> None:
    """Displacements of all nodes, of its own elements: S8R, hinged by equations.

    They differ by 2.6 % of the largest without plates, and 3.1 % with them, with 6 cells; by 2.1
    and 1.5 % with 8, of 20.8 and 20.3 mm.
    """
    found = arch(columns=columns, cells=cells).analysis
    assert found is not None
    deck = Deck(found.model, found.cases[0])
    path = tmp_path / "arch.inp"
    deck.write(path, "*STATIC")
    theirs = run_deck(path, deck).displacements[0]
    ours = linear(found.model, found.cases[0].forces)
    apart = np.linalg.norm(ours - theirs, axis=1).max()
    assert apart < 0.045 * np.linalg.norm(theirs, axis=1).max()


def test_all_is_in_balance() -> None:
    """Loads, reactions and every panel; strips and plates weigh what their area does."""
    shell, found = usual("all"), analysed("all")
    model, (case,) = found.model, found.cases
    assert case.equilibrium is not None
    assert case.equilibrium.residual < 1e-9
    assert case.equilibrium.panel_residual < 1e-9
    girders = shell.document.attached
    area = area_of(shell.design.mechanism) + sum(float(each.areas().sum()) for each in girders)
    assert len(girders) == 5
    assert model.mass == pytest.approx(AREAL * area, rel=1e-9)
    assert case.load == pytest.approx((0, 0, -GRAVITY * AREAL * area), rel=1e-9, abs=1e-9)
    acts = panel_forces(model, case)
    total = np.zeros((len(model.mesh.nodes), 6))
    turning = acts.forces[:, 3:] + np.cross(acts.points, acts.forces[:, :3])
    np.add.at(total, acts.panels, np.concatenate([acts.forces[:, :3], turning], axis=1))
    assert np.abs(total).max() < 1e-6 * GRAVITY * AREAL * area
    assert "box girder" in acts.acts


@thorough
@pytest.mark.parametrize("columns", ["none", "all"])
def test_calculix_buckles_it_as_soon(columns: str, tmp_path: Path) -> None:
    """The lowest factor, of its own elements, hinged likewise, of panels of 10 mm.

    With 6, 8 and 10 cells ours is 16, 10.3 and 7.6 % larger, theirs hardly changes. Of panels of 2
    mm CalculiX misses the lowest, of a strip, as it does of thin gussets.
    """
    found = arch(columns=columns, cells=10, thickness=0.01).analysis
    assert found is not None
    (case,) = found.cases
    assert case.equilibrium is not None
    deck = Deck(found.model, case)
    path = tmp_path / "arch.inp"
    deck.write(path, "*BUCKLE")
    theirs = run_deck(path, deck).factors[0]
    assert case.equilibrium.buckling == pytest.approx(theirs, rel=0.1)


@thorough
def test_boards_have_their_mass() -> None:
    """Of panels and girders, by their boards: what the design weighs in its drawings."""
    text = (Path(__file__).parents[2] / "docs" / "guide" / "boxes.md").read_text(encoding="utf-8")
    page = text.split("```toml\n")[1].split("```")[0]
    structure = """
[structure]
modulus = 8e9
supports = [{ at = "feet", kind = "pinned" }]
cells = 3
[[load_case]]
name = "weight"
self_weight = true
"""
    file = check_design(tomllib.loads(page + structure), Path("x.toml"))
    shell = make_shell(file, clash="unexamined", skip=("remedies", "verification"))
    assert shell.analysis is not None
    model = shell.analysis.model
    parts = [shell.document, *(each for each in shell.document.attached)]
    volumes = [each.boards.volumes().sum() for each in parts if each.boards is not None]
    assert len(volumes) == 1 + 3 + 9
    assert model.mass == pytest.approx(500 * sum(volumes), rel=1e-9)


def test_small_loads_move_it_as_by_linear_theory() -> None:
    """Large displacements of boards a thousand times as stiff: displacement and stress agree."""
    more: Tables = {"modulus": 8e12, "columns": "all"}
    followed, straight = (arch(**more, nonlinear=each).analysis for each in (True, False))
    assert followed is not None
    assert straight is not None
    first, second = (each.cases[0].equilibrium for each in (followed, straight))
    assert first is not None
    assert second is not None
    assert first.path is not None
    assert first.path.carries
    assert first.displacement.size == pytest.approx(second.displacement.size, rel=1e-3)
    assert first.boxes is not None
    assert second.boxes is not None
    assert first.boxes.size == pytest.approx(second.boxes.size, rel=1e-3)
    assert first.boxes.part == second.boxes.part


def test_what_governs_is_named() -> None:
    """Where strips use more than they bear, the case says which."""
    found = arch(strength=1e5, modulus=8e11).analysis
    assert found is not None
    (case,) = found.cases
    assert case.equilibrium is not None
    part, shares = case.equilibrium.boxes, case.equilibrium.utilisation
    assert part is not None
    assert part.part.startswith("box 2 ")
    assert shares.boxes == pytest.approx(part.size / 1e5, rel=1e-9)
    assert f"strength of its box girders in {part.part}" in case.said


def test_strips_are_where_the_sleeve_is() -> None:
    """On a sheet whose columns run together: lines are straight, in panels, as in closed form."""
    mechanism = flat_foldable(random_net(5, 6, 3))
    grid, positions = mechanism.grid, mechanism.positions(0.5 * mechanism.target_drive)
    forms = SleeveForms.of(mechanism, 3, slice(1, grid.columns))
    sleeve = Sleeve.over(mechanism, forms, 0.7)
    assert np.ptp(sleeve.above) > 0.01
    sheet = mesh_sheet(positions, grid, 5, stops=stops_of_sleeves(grid, (sleeve,)))
    places = sleeve.carried(positions)
    strips = mesh_strips(sheet, grid, sleeve, places, sheet.node_count)
    whole, plates = join_parts(sheet, strips)
    points, size = whole.facets.points, float(np.ptp(positions))
    for plate, (top, bottom) in zip(plates, ((Q, W), (W, R)), strict=True):
        nodes = points[plate.nodes[plate.own.nodes]]
        for row, line in ((0, top), (-1, bottom)):
            ends = np.stack([nodes[:, row, 0], nodes[:, row, -1]], axis=1)
            wanted = np.stack([places[line, :-1], places[line, 1:]], axis=1)
            np.testing.assert_allclose(ends, wanted, rtol=0, atol=1e-12 * size)
            off = np.cross(nodes[:, row] - ends[:, :1], (ends[:, 1] - ends[:, 0])[:, None])
            assert np.abs(off).max() < 1e-12 * size**2
        hung = plate.nodes[plate.own.nodes[:, 0 if top == Q else -1]]
        panels = sheet.nodes[(sleeve.row - (top == Q)) * (grid.columns - 1) + 1 :][: len(hung)]
        assert all(np.isin(*each).all() for each in zip(hung, panels, strict=True))


def test_a_membrane_that_nobody_knows_is_said() -> None:
    """Of strips on a membrane only, and where its modulus is not given."""
    design = arch().design
    thin = PanelSpec(thickness=0.01, construction="sandwich", membrane=0.001)
    held = (Support(at="feet", kind="pinned"),)
    cases = (LoadCase(name="dead", self_weight=True),)
    for panel, carried, fabric, count in (
        (thin, design.carried, 0.0, 1),
        (thin, design.carried, 1e8, 0),
        (thin, (), 0.0, 0),
        (None, design.carried, 0.0, 0),
    ):
        asked = Structure(modulus=1e9, membrane_modulus=fabric, supports=held, cases=cases)
        said = list(membrane_warnings(replace(design, panel=panel, carried=carried), asked))
        assert len(said) == count


def test_cells_without_lines_to_hang_on_are_refused() -> None:
    """Two cells have one line of nodes between them; two strips hang apart on the same panels."""
    stops = Stops.none(Grid(3, 4))
    stops.down[1] = 0.6
    assert stops.lines(2).tolist() == [[-1, -1], [1, -1]]
    stops.up[1] = 0.7
    for cells in (1, 2):
        with pytest.raises(InputError, match="there are too few") as caught:
            stops.lines(cells)
        assert caught.value.keys == ("structure.cells",)
    assert stops.lines(3).tolist() == [[-1, -1], [2, 1]]


def test_lines_that_cross_are_refused() -> None:
    """From 0.6 down to 0.3 from above, and 0.5 all along from below."""
    stops = Stops.none(Grid(3, 4))
    stops.down[1], stops.up[1] = np.linspace(0.6, 0.3, 4), 0.5
    with pytest.raises(InputError, match="lines that cross there"):
        stops.moved(np.tile(np.linspace(0, 1, 7), (2, 1)))


def test_lines_in_one_row_keep_their_order() -> None:
    """That from above is above the other, or below, or one with it; so are nodes between."""
    even = np.tile(np.linspace(0, 1, 7), (2, 1))
    for down, up in ((0.3, 0.4), (0.75, 0.85), (0.45, 0.55)):
        stops = Stops.none(Grid(3, 4))
        stops.down[1], stops.up[1] = (
            down + np.linspace(-0.1, 0.1, 4),
            up - np.linspace(-0.1, 0.1, 4),
        )
        moved, (_, lines) = stops.moved(even), stops.lines(6)
        assert (np.diff(moved, axis=-1) > 0).all()
        np.testing.assert_allclose(moved[1, :, lines[0]], stops.down[1], atol=1e-12)
        np.testing.assert_allclose(moved[1, :, lines[1]], 1 - stops.up[1], atol=1e-12)


@pytest.mark.parametrize("columns", ["none", pytest.param("all", marks=thorough)])
def test_decks_have_them(columns: str, tmp_path: Path) -> None:
    """What the written deck moves by, as the one above, and its mass: 2.6 and 3.1 % apart."""
    shell = arch(columns=columns, cells=6)
    deck = tmp_path / "x.inp"
    write_calculix(deck, shell.document, DEFAULT_SETTINGS)
    text = deck.read_text()
    assert {f"*ELSET,ELSET=BOX_2_{each}_0" for each in ("UPPER", "LOWER")} <= set(text.split())
    assert "creases and hinges turn freely" in text
    first, _, _ = text.partition("*END STEP\n")
    deck.write_text(f"{first}*END STEP\n")
    found = shell.analysis
    assert found is not None
    ours = linear(found.model, found.cases[0].forces)
    theirs = run_calculix(deck).displacements[0]
    apart = np.linalg.norm(ours - theirs, axis=1).max()
    assert apart < 0.045 * np.linalg.norm(theirs, axis=1).max()
    loaded = shell.document.loaded
    assert loaded is not None
    parts = loaded.parts
    assert parts is not None
    sides = np.diff(loaded.points[parts.triangles], axis=1)
    areas = np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1) / 2
    np.testing.assert_allclose(parts.areal_mass, AREAL)
    girders = sum(float(each.areas().sum()) for each in shell.document.attached)
    assert areas.sum() == pytest.approx(girders)


@pytest.mark.parametrize(("fabric", "least"), [(0.0, 0.1), (1e8, 0.0)])
def test_strips_hang_on_boards_far_from_their_line(fabric: float, least: float) -> None:
    """Boards cover half of a panel. Beyond it a membrane holds its edge, if one is known.

    Else that of a strip is as stiff in its plane as a tenth of both boards: without anything it
    would swing. Panels of a sheet have nothing there.
    """
    build = PanelSpec(thickness=0.01, construction="sandwich", membrane=0.001)
    asked = Structure(
        modulus=1e9,
        membrane_modulus=fabric,
        supports=(Support(at="feet", kind="pinned"),),
        cases=(LoadCase(name="dead", self_weight=True),),
    )
    flat = np.array([[[0.0, 1.0], [0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]])
    half = np.array([[0.0, 0.5], [0.0, 0.0], [1.0, 0.0], [1.0, 0.5]])
    outlines = np.zeros((2, 2, 4, 3))
    outlines[..., :2] = half
    boards = Boards(np.zeros(2, np.int64), np.array([1, -1]), outlines)
    middles = np.array([[[0.05, 0.5], [0.95, 0.5]]])  # beyond the boards, and on them
    found = panel_sections(asked, build, boards, flat, middles, joined=LEAST_JOINED)
    far, near = np.asarray(found.membrane)
    bare, _ = np.asarray(panel_sections(asked, build, boards, flat, middles).membrane)
    assert bare == pytest.approx(fabric * 0.001 / (1 - asked.poisson**2), rel=1e-12)
    alone = fabric * 0.001 / (1 - asked.poisson**2)
    assert far == pytest.approx(least * near + alone, rel=1e-12)
    assert near > 50 * alone
