"""Bounds and directions that the proof of boards rests on."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import linprog

from orishell.clash.acceleration_bounds import EdgeBounds, NormalBounds
from orishell.clash.bodies import Apartness, Bodies, BodyState, opposite_panels
from orishell.clash.broad_phase import PanelTree
from orishell.design import Design, PanelSpec
from orishell.design_file import read_design_file
from orishell.locking.boards import prove_boards
from orishell.motion import diagonal, panel_normals
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.layout import Layout, points_of
from orishell.numerics.arrays import Array
from orishell.solids import build_panels
from samples import examples
from strategies import Request, graph, orthodiagonal_requests, parallel_repeating, requests

EXAMPLES = Path(__file__).parents[2] / "examples"


def figure_2(thickness: float) -> Design:
    """Figure 2 without flaps: with boards, opposite ones meet at its vertices."""
    file = read_design_file(EXAMPLES / "figure2.toml")
    design = replace(file.pattern.design(file.f, file.g).with_clipped_flaps(), clipped=None)
    return replace(design, panel=PanelSpec(thickness=thickness, membrane=0.02 * thickness))


def meet(first: Array, second: Array) -> bool:
    """Whether the convex hulls of points (N, 3) and (M, 3) have a common point: HiGHS."""
    count, other = len(first), len(second)
    sums = np.zeros((5, count + other))
    sums[:3, :count], sums[:3, count:] = first.T, -second.T
    sums[3, :count] = sums[4, count:] = 1
    found = linprog(np.zeros(count + other), A_eq=sums, b_eq=[0, 0, 0, 1, 1], bounds=(0, None))
    return bool(found.status == 0)


@settings(max_examples=examples(25))
@given(st.one_of(requests(), orthodiagonal_requests()), st.integers(0, 7))
def test_normals_accelerate_no_more_than_their_bounds(request: Request, part: int) -> None:
    """Second differences in the middle of an eighth of the path; a bound within ten times them."""
    mechanism = request.feasible().mechanism
    grid, end = mechanism.grid, 0.9 * mechanism.target_drive
    place = np.indices((grid.rows - 1, grid.columns - 1)).reshape(2, -1).T
    tree = PanelTree.over(grid.faces_vertices(), place.astype(np.float64))
    bounds = EdgeBounds(mechanism, (0.0, end), tree).within(part / 8, (part + 1) / 8)
    allowed = NormalBounds(Layout.of(mechanism), points_of(mechanism, 0.0)).within(*bounds.steps)
    step, middle = 1e-3 * end, (part + 0.5) / 8 * end
    normals = panel_normals(mechanism.positions(middle + step * np.array([-1, 0, 1])))
    second = (normals[2] - 2 * normals[1] + normals[0]) / step**2
    found = np.linalg.norm(second, axis=-1).ravel()
    assert (found <= allowed * (1 + 1e-6) + 1e-5).all()


def state_of(design: Design, drive: float) -> tuple[Bodies, BodyState]:
    built = build_panels(design, design.mechanism.target_drive)
    faces, lying = design.mechanism.grid.faces_vertices(), panels_laid_flat(design.mechanism)
    bodies = Bodies(built.boards, faces, lying)
    return bodies, bodies.carried(design.mechanism.positions(drive).reshape(-1, 3))


@pytest.mark.parametrize("construction", ["sandwich", "bevel"])
def test_bodies_are_apart_where_their_hulls_have_no_common_point(construction: str) -> None:
    design = figure_2(0.05)
    assert design.panel is not None
    if construction == "bevel":
        design = replace(design, panel=PanelSpec(thickness=0.05, construction="bevel", gap=0.002))
    mechanism = design.mechanism
    bodies, state = state_of(design, mechanism.target_drive)
    inner = np.zeros((mechanism.grid.rows - 2, mechanism.grid.columns - 2), np.bool_)
    panels, _ = opposite_panels(Layout.of(mechanism), inner)
    first, second = bodies.pairs_of(panels)[0]
    pairs = first[::3], second[::3]
    gaps = Apartness.of((state, state), pairs).gaps[0]
    hulls = [
        meet(state.corners[:, :, a].T, state.corners[:, :, b].T)
        for a, b in zip(*pairs, strict=True)
    ]
    sure = np.abs(gaps) > 1e-8
    assert (gaps[sure] < 0).tolist() == np.array(hulls)[sure].tolist()
    if construction == "sandwich":
        assert any(hulls)


def test_corners_are_cut_off_no_further_than_is_needed() -> None:
    """Figure 2 needs it at 32 of its 90 inner vertices; nine tenths of it would not do."""
    design = figure_2(0.05)
    mechanism = design.mechanism
    end = mechanism.target_drive
    built, path = prove_boards(design, end, 1e-9 * diagonal(mechanism.positions(0.0)))
    assert path.contact is None
    cut = built.reliefs > 0
    assert cut.sum() == 32
    assert not cut[[0, -1]].any()
    assert not cut[:, [0, -1]].any()
    assert built.reliefs.max() < built.build.height
    panels, vertices = opposite_panels(Layout.of(mechanism), built.settled())

    def least(share: float) -> Array:
        """The least gap of boards about each vertex that is cut, at the target."""
        boards = build_panels(design, end, share * built.reliefs).boards
        lying = panels_laid_flat(mechanism)
        bodies = Bodies(boards, mechanism.grid.faces_vertices(), lying)
        state = bodies.carried(mechanism.positions(end).reshape(-1, 3))
        pairs, which = bodies.pairs_of(panels)
        gaps = Apartness.of((state, state), pairs).gaps[0]
        found = np.full(mechanism.grid.vertex_count, np.inf)
        np.minimum.at(found, vertices[which], gaps)
        return found[cut.ravel()]

    assert (least(1.0) > 0).all()
    assert (least(0.9) <= 1e-3 * built.build.height).all()


def test_boards_along_a_straight_line_are_settled() -> None:
    """A straight g: column creases do not fold, and boards touch at vertices without a gap."""
    f, g = graph("-x**2", -1, 1), graph("0*x", 0, 4)
    design = parallel_repeating(f, g, rows=5, columns=6, xi_deg=50, flap=0.0).design()
    design = replace(design, panel=PanelSpec(thickness=0.02, membrane=1e-3))
    built, path = prove_boards(design, design.mechanism.target_drive, 1e-9)
    assert built.settled().all()
    assert path.contact is None
    assert not built.reliefs.any()
