"""Edges of gussets, and hinges of box girders: in balance, by hand, judged, or not known."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from design_tables import Tables, formula, tables
from orishell.conventions.quantities import GRAVITY
from orishell.design_file import check_design
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array
from orishell.shell.make import make_shell
from orishell.structure import Analysis
from orishell.structure.held_panels import PanelLoads, by_mesh
from orishell.structure.mesh.edge_forces import ABOUT, ACROSS, IN_PLANE, NORMAL
from orishell.structure.mesh.plate_edges import find_plate_edges
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.sheet import mesh_sheet
from orishell.structure.model import Model
from orishell.structure.solve.active_set import respond

AREAL = 8.0
KINDS: dict[str, dict[str, Any]] = {
    "gussets": {"kind": "gussets"},
    "strips": {"kind": "boxes", "columns": "none", "share": 0.7},
    "girders": {"kind": "boxes", "columns": "all", "share": 0.7},
}
STRONG = 1e6


def arch(kind: str, **asked: Any) -> Analysis:
    """An arch of twelve panels on pinned edges, all hinges free, under its own weight.

    asked: Keys of [structure].
    """
    f, g = formula("-x**2", -1, 1), formula("0.1*cos(2*pi*x)", 0, 1.5)
    pattern = {"rows": 3, "columns": 4, "flap": 0, "heading_deg": 90, "spacing": "equal"}
    design: Tables = {
        **tables("orthodiagonal", f, g, **pattern),
        "workshop": {"areal_density": AREAL},
        "stiffeners": KINDS[kind],
        "structure": {
            "modulus": 8e9,
            "strength": 20e6,
            "thickness": 0.01,
            "supports": [{"at": "feet", "kind": "pinned", "edges": True}],
            "crease_stiffness": "free",
            "cells": 4,
            "line_strength": STRONG,
            **asked,
        },
        "load_case": [{"name": "weight", "self_weight": True}],
    }
    file = check_design(design, Path("x.toml"))
    found = make_shell(file, clash="unexamined", skip=("remedies", "verification")).analysis
    assert found is not None
    return found


@cache
def analysed(kind: str, cells: int = 4) -> Analysis:
    return arch(kind, cells=cells, edge_strength=STRONG)


def moved_and_loaded(model: Model) -> tuple[Array, list[Array]]:
    """Displacements and rotations (D,) under its weight, and loads of plates by their own nodes."""
    (case,) = model.structure.cases
    (forces,) = [each.forces for each in analysed_cases(model)]
    found = model.factorised(0.0)
    response = respond(found, found.free_loads(forces))
    assert response.moves is None
    _, *loads = by_mesh(model, PanelLoads(model, [case]).of(case))
    return found.moved(response.displacements), loads


def analysed_cases(model: Model) -> Any:
    return next(each.cases for kind in KINDS if (each := analysed(kind)).model is model)


def lever(points: Array, forces: Array) -> Array:
    """Moments (3,) of forces (n, 3) at points about their mean."""
    return np.asarray(np.cross(points - points.mean(axis=0), forces).sum(axis=0))


@pytest.mark.parametrize("kind", KINDS)
def test_forces_along_edges_hold_the_weight_of_each_plate(kind: str) -> None:
    """Those at its edges, corners counted once, and its weight add up to nothing; moments, too.

    Along the edges at which nothing is joined, there is nothing.
    """
    model = analysed(kind).model
    moved, loads = moved_and_loaded(model)
    parts = zip(model.plates, model.plate_elements, loads, model.plate_masses, strict=True)
    total = 0.0
    for plates, elements, load, masses in parts:
        own, forces = plates.own, elements.forces(moved)
        np.testing.assert_allclose(load[:, 2], -GRAVITY * masses, rtol=1e-12)
        total += masses.sum()
        edges = find_plate_edges(own, own.facets.points, forces, load, plates.shared)
        held = np.zeros((own.nodes.size, 3))
        np.add.at(held, own.places, forces.reshape(-1, 3, 6)[..., :3])
        held -= load
        most = np.abs(held).max()
        assert edges.missing < 1e-9 * most
        inside = np.zeros(own.nodes.shape, dtype=bool)
        inside[:, 1:-1, 1:-1] = True
        assert np.abs(held[inside.ravel()]).max() < 1e-9 * most
        points = own.facets.points[own.nodes]
        by_plate = held.reshape(*own.nodes.shape, 3)
        weights = load.reshape(by_plate.shape)
        for place, force, weight in zip(points, by_plate, weights, strict=True):
            acting = (force + weight).reshape(-1, 3)
            assert np.abs(acting.sum(axis=0)).max() < 1e-9 * most
            assert np.abs(lever(place.reshape(-1, 3), acting)).max() < 1e-9 * most
        # Forces per length, over their stretches, are those of the nodes of each edge.
        sides = by_plate[:, :, 0], by_plate[:, -1], by_plate[:, :, -1], by_plate[:, 0]
        for edge, nodes in enumerate(sides):
            mean = edges.per_length[:, edge, :, :3].mean(axis=1)
            whole = np.linalg.norm(mean, axis=-1) * edges.lengths[:, edge]
            np.testing.assert_allclose(
                whole, np.linalg.norm(nodes.sum(axis=1), axis=-1), rtol=0, atol=1e-9 * most
            )
        if kind == "gussets":
            assert np.abs(by_plate[:, 1:, -1]).max() < 1e-9 * most
            assert np.abs(by_plate[:, -1, 1:]).max() < 1e-9 * most
    assert model.mass == pytest.approx(AREAL * model.mesh.facets.areas().sum() + total)


def test_a_plate_that_is_pulled() -> None:
    """By hand: stress s along x in a plate of thickness t has N = s t on the edges across.

    Of a corner all is counted on both of its edges: it is half a cell of the pulled edge, and on
    the other edge a shear over the first quarter.
    """
    width, height, thickness, stress, cells = 2.0, 1.0, 0.01, 3e6, 4
    x, y = np.meshgrid([0.0, width], [height, 0.0])
    positions = np.stack([x, y, 0 * x], axis=-1)
    mesh = mesh_sheet(positions, Grid(2, 2), cells, grading=0.0)
    elements = mesh.elements(Section.solid(10e9, thickness, 0.0))
    moved = np.zeros(mesh.count)
    moved[mesh.translations()[:, 0]] = stress / 10e9 * mesh.facets.points[:, 0]
    nothing = np.zeros((mesh.nodes.size, 3))
    alone = np.zeros(mesh.node_count, np.bool_)
    found = find_plate_edges(mesh, mesh.facets.points, elements.forces(moved), nothing, alone)
    np.testing.assert_allclose(found.lengths[0], [height, width, height, width])
    pulled, pull = found.per_length[0, [0, 2]], stress * thickness
    np.testing.assert_allclose(pulled[..., NORMAL], pull, rtol=1e-9)
    np.testing.assert_allclose(pulled[..., [IN_PLANE, ACROSS, ABOUT]], 0.0, atol=1e-6 * pull)
    beside = found.per_length[0, [1, 3]]
    corner = pull * height / cells / 2
    sheared = np.array([-1, 0, 0, 1]) * corner / (width / 4)
    np.testing.assert_allclose(np.abs(beside[..., IN_PLANE]), np.abs([sheared] * 2), atol=1e-6)
    np.testing.assert_allclose(beside[..., NORMAL], 0.0, atol=1e-6 * pull)
    assert found.missing < 1e-9 * pull


@pytest.mark.parametrize("kind", KINDS)
def test_finer_cells_change_them_little(kind: str) -> None:
    """By a tenth from 4 to 8 cells; means over quarters of edges are of no single node."""
    for name in ("box_lines", "plate_edges"):
        coarse, fine = (getattr(analysed(kind, cells).balanced[0][0], name) for cells in (4, 8))
        there = name == ("plate_edges" if kind == "gussets" else "box_lines") or kind == "girders"
        assert (coarse is not None) == there
        if there:
            assert fine.largest.size == pytest.approx(coarse.largest.size, rel=0.15)


@pytest.mark.parametrize("kind", ["gussets", "girders"])
def test_edges_bear_more_or_less_than_what_is_given(kind: str) -> None:
    """Just above the force that there is the arch carries; just below it does not."""
    found = analysed(kind).balanced[0][0].plate_edges
    assert found is not None
    for share, carries in ((1.001, True), (0.999, False)):
        analysis = arch(kind, edge_strength=share * found.largest.size)
        assert analysis.carries is carries, analysis.in_words()
        balanced, case = analysis.balanced[0]
        assert balanced.utilisation.plate_edges == pytest.approx(1 / share)
        assert balanced.utilisation.governs == "plate_edges"
        assert all(each.kind == "exceeds strength" for each in case.findings)
        assert [found.largest.part in each.text for each in case.findings] == [True] * (not carries)


@pytest.mark.parametrize("kind", ["gussets", "girders"])
def test_what_holds_edges_is_not_known_where_it_is_not_given(kind: str) -> None:
    """In no direction, or not in all: then the force is said that a fixing has to bear."""
    for given in ({}, {"edge_strength": {"pull": STRONG, "push": STRONG, "across": STRONG}}):
        analysis = arch(kind, **given)
        assert analysis.carries is None
        balanced, case = analysis.balanced[0]
        assert balanced.unknown == ("plate_edges",)
        edges = balanced.plate_edges
        assert edges is not None
        (finding,) = case.findings
        assert finding.kind == "unknown"
        assert edges.unknown.in_words() in finding.text
        assert (edges.unknown.size == edges.largest.size) == (not given)


def test_strips_alone_have_no_edges_that_are_fixed() -> None:
    """Their hinges bear what crease lines do, and are not known where these are not."""
    analysis = analysed("strips")
    balanced = analysis.balanced[0][0]
    assert analysis.carries is True
    assert balanced.plate_edges is None
    lines = balanced.box_lines
    assert lines is not None
    assert lines.used is not None
    assert lines.used.size == pytest.approx(lines.largest.size / STRONG)
    assert balanced.utilisation.box_lines == lines.used.size
    unknown = arch("strips", line_strength={"pull": STRONG, "push": STRONG, "across": STRONG})
    assert unknown.carries is None
    balanced, case = unknown.balanced[0]
    assert set(balanced.unknown) == {"lines", "box_lines"}
    assert "box 2" in case.findings[0].text


@pytest.mark.parametrize("kind", ["gussets", "girders"])
def test_large_displacements_hold_them_likewise(kind: str) -> None:
    """Under small displacements forces are those of linear theory, to a share of these."""
    linear = analysed(kind).balanced[0][0].plate_edges
    balanced, _ = arch(kind, edge_strength=STRONG, nonlinear=True).balanced[0]
    assert balanced.path is not None
    assert linear is not None
    followed = balanced.plate_edges
    assert followed is not None
    assert followed.largest.size == pytest.approx(linear.largest.size, rel=0.05)
    assert (followed.largest.part, followed.largest.beside) == (
        linear.largest.part,
        linear.largest.beside,
    )
