"""Tabs and strips: one for every crease that is cut, named on both sides, none in the way."""

from __future__ import annotations

import itertools
from functools import cache

import numpy as np
import pytest
import shapely

from documents import FAMILIES, demo_document
from orishell.document import Document
from orishell.motion.mesh import build_mesh
from orishell.workshop.cut_parts import CutPart, Joint, make_parts
from orishell.workshop.palettes import Text
from orishell.workshop.settings import Joint as JointKind
from orishell.workshop.settings import Workshop
from orishell.workshop.splitting import split_sheet
from orishell.workshop.tabs import choose_joint_width, tab_shapes

every = pytest.mark.parametrize(
    ("family", "kind"), list(itertools.product(FAMILIES, ["tabs", "strips"]))
)


@cache
def made(
    family: str, kind: JointKind
) -> tuple[Document, tuple[CutPart, ...], tuple[CutPart, ...], tuple[Joint, ...]]:
    document = demo_document(family)
    width = choose_joint_width(document, Workshop())
    side = 0.55 * np.ptp(document.require_flat(), axis=0).max()
    split = split_sheet(document, side, 0.8 * side, width)
    assert len(split) > 1
    return document, *make_parts(document, split, kind, width)


def panels_of(document: Document, part: CutPart) -> shapely.Geometry:
    return shapely.union_all(
        shapely.polygons(document.require_flat()[document.mesh.faces[part.panels]])
    )


def words(part: CutPart) -> list[str]:
    return [mark.words for mark in part.marks if isinstance(mark, Text)]


@every
def test_every_crease_that_is_cut_has_one_joint_named_on_both_sides(
    family: str, kind: JointKind
) -> None:
    document, parts, strips, joints = made(family, kind)
    number = np.zeros(len(document.mesh.faces), dtype=int)
    for part in parts:
        number[part.panels] = part.number
    beside = number[document.mesh.edge_faces]
    cut = np.flatnonzero(document.mesh.crease & (beside[:, 0] != beside[:, 1]))
    assert sorted(joint.edge for joint in joints) == cut.tolist()
    assert len({joint.name for joint in joints}) == len(joints)
    for joint in joints:
        bearers = [part.number for part in parts if joint.name in words(part)]
        assert sorted(bearers) == sorted(joint.parts) == sorted(beside[joint.edge])
    assert sum(len(part.marks) for part in parts) == 2 * len(joints)
    assert [words(strip) for strip in strips] == [
        [joint.name] * 2 for joint in joints if kind == "strips"
    ]


@every
def test_every_crease_is_scored_once_and_each_part_has_its_own(
    family: str, kind: JointKind
) -> None:
    """Those inside a part on it, those that are cut on the part with the tab, or the strip."""
    document, parts, strips, joints = made(family, kind)
    scored = np.concatenate([part.creases for part in (*parts, *strips)])
    assert np.array_equal(np.sort(scored), np.flatnonzero(document.mesh.crease))
    for joint in joints if kind == "tabs" else ():
        assert joint.edge in parts[joint.parts[0] - 1].creases


@every
def test_areas_add_up(family: str, kind: JointKind) -> None:
    """Parts without their tabs make up the sheet; tabs, or strips, make up the rest."""
    document, parts, strips, joints = made(family, kind)
    sheet = document.areas().sum()
    outlines = [shapely.Polygon(p.outlines[0], p.outlines[1:]) for p in parts]
    bare = [
        shapely.intersection(o, panels_of(document, p))
        for o, p in zip(outlines, parts, strict=True)
    ]
    assert sum(shape.area for shape in bare) == pytest.approx(sheet, rel=1e-9)
    glued = sum(shapely.Polygon(tab).area for joint in joints for tab in joint.tabs)
    outer = sum(shape.area for shape in outlines) - sheet
    if kind == "tabs":
        assert outer == pytest.approx(glued, rel=1e-9)
    else:
        assert outer == pytest.approx(0, abs=1e-9 * sheet)
        cut = sum(shapely.Polygon(strip.outlines[0]).area for strip in strips)
        assert cut == pytest.approx(glued, rel=1e-9)


@every
def test_tabs_lie_under_their_panel_and_clear_of_each_other(family: str, kind: JointKind) -> None:
    document, parts, _, joints = made(family, kind)
    tabs = [shapely.Polygon(tab) for joint in joints for tab in joint.tabs]
    for one, two in itertools.combinations(tabs, 2):
        assert shapely.intersection(one, two).area < 1e-12 * one.area
    whole = [panels_of(document, part) for part in parts]
    for joint in joints:
        far = shapely.Polygon(joint.tabs[0])
        own, other = (whole[number - 1] for number in joint.parts)
        assert shapely.difference(far, other).area < 1e-9 * far.area
        assert shapely.intersection(far, own).area < 1e-9 * far.area
    for part in parts:
        outline = shapely.Polygon(part.outlines[0], part.outlines[1:])
        assert outline.is_valid
        assert outline.exterior.is_ccw


@every
def test_names_stand_on_what_they_name(family: str, kind: JointKind) -> None:
    """A text as wide as its letters lies on the tab; the panel above is the same place."""
    *_, joints = made(family, kind)
    for joint in joints:
        for mark, tab in zip(joint.marks(), joint.tabs, strict=True):
            along = np.array([np.cos(mark.angle), np.sin(mark.angle)])
            above = np.array([-along[1], along[0]])
            half = 0.4 * len(mark.words) * mark.height
            box = np.array([mark.x, mark.y]) + np.array(
                [
                    a * half * along + 0.5 * b * mark.height * above
                    for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))
                ]
            )
            assert shapely.Polygon(tab).contains(shapely.Polygon(box))
            assert -np.pi / 2 < mark.angle <= np.pi / 2


def test_tabs_of_squares() -> None:
    """On squares of side 1 a tab of 0.2 is a trapezium with ends at 45 degrees: its far side is
    0.6; at most its far side is a third of its root, so that it is no wider than 1/3."""
    flat = np.array([[0, 0], [1, 0], [2, 0], [0, 1], [1, 1], [2, 1]], dtype=float)
    mesh = build_mesh(np.array([[0, 1, 4, 3], [1, 2, 5, 4]]), 6)
    letters = tuple("M" if crease else "B" for crease in mesh.crease)
    document = Document("two", "mm", mesh, letters, flat, np.zeros(7), (), (2, 3), {})
    edge = int(np.flatnonzero(mesh.crease)[0])
    right = int(mesh.edge_faces[edge].tolist().index(1))
    tab = tab_shapes(document, 0.2)[edge, right]
    assert np.allclose(tab, [[1.0, 1.0], [1.0, 0.0], [1.2, 0.2], [1.2, 0.8]])
    wide = tab_shapes(document, 5.0)[edge, right]
    assert np.allclose(wide[2:], [[4 / 3, 1 / 3], [4 / 3, 2 / 3]])
    assert choose_joint_width(document, Workshop()) == 0.25
    assert choose_joint_width(document, Workshop(joint_width=0.1)) == 0.1


def test_tab_beside_a_corner_that_points_inwards_stays_in_its_panel() -> None:
    """An arrowhead below a square: its corner (0.5, -0.1) points inwards, close to the crease."""
    flat = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0.5, -0.1], [0.55, -2]], dtype=float)
    mesh = build_mesh(np.array([[0, 1, 2, 3], [0, 4, 5, 1][::-1]]), 6)
    letters = tuple("M" if crease else "B" for crease in mesh.crease)
    document = Document("arrow", "mm", mesh, letters, flat, np.zeros(7), (), None, {})
    edge = int(np.flatnonzero(mesh.crease)[0])
    for side in (0, 1):
        panel = shapely.Polygon(flat[mesh.faces[mesh.edge_faces[edge, side]]])
        tab = shapely.Polygon(tab_shapes(document, 0.5)[edge, side])
        assert tab.area > 0
        assert shapely.difference(tab, panel).area < 1e-9 * tab.area
