"""Curves and surfaces from Rhino are in a design what they were drawn as."""

from __future__ import annotations

import json
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from orishell.conventions.errors import InputError
from orishell.curves import parse_curve
from orishell.curves.pieces import Arc, Bezier
from orishell.curves.piecewise import PieceArrays
from orishell.io.rhino_geometry import rhino3dm
from orishell.numerics.arrays import Array
from orishell.studio.hops.geometry import f_path, g_path, lines, planes, points, surface_table

rhino = rhino3dm()
ROUNDED = 1e-12
"""Path data have 13 decimals relative to the size: ten times their rounding."""
TURNS = (0.0, 0.4, np.pi / 2, 2.5)
"""Turns of an upright plane about the z axis."""


def at(x: float, y: float, z: float = 0.0) -> Any:
    return rhino.Point3d(x, y, z)


def spline(*places: tuple[float, float, float], degree: int = 3) -> Any:
    return rhino.NurbsCurve.Create(False, degree, [at(*each) for each in places])


def turned(curve: Any, angle: float) -> Any:
    """A curve drawn in x and z, turned about the z axis."""
    curve.Rotate(angle, rhino.Vector3d(0, 0, 1), at(0, 0))
    return curve


def samples(path: str) -> Array:
    """Points of a path, 50 of each of its pieces."""
    pieces = parse_curve(path).pieces
    s = np.tile(np.linspace(0, 1, 50), len(pieces))
    return PieceArrays.of(pieces).jet(np.repeat(np.arange(len(pieces)), 50), s)[0]


def arch(radius: float = 2.0) -> Any:
    """An arc over the x axis, in x and z."""
    ends = (at(-radius * 0.8, 0, radius * 0.6), at(0, 0, radius), at(radius * 0.8, 0, radius * 0.6))
    return rhino.ArcCurve.CreateFromArc(rhino.Arc(*ends))


@pytest.mark.parametrize("angle", TURNS)
def test_an_arc_stays_an_arc_in_any_upright_plane(angle: float) -> None:
    path, notes = f_path(turned(arch(), angle))
    assert notes == []
    assert all(isinstance(piece, Arc) for piece in parse_curve(path).pieces)
    found = samples(path)
    assert np.abs(np.hypot(*found.T) - 2.0).max() < ROUNDED
    assert found[:, 1].min() == pytest.approx(1.2, abs=ROUNDED)
    assert np.abs(found[[0, -1], 0]) == pytest.approx([1.6, 1.6], abs=ROUNDED)


def test_which_way_f_is_seen() -> None:
    """Along x of the document, or y where its plane is square to x: as DXF files are read."""
    places = ((0.0, 0.0, 0.0), (1.0, 0.0, 2.0), (3.0, 0.0, 0.5))
    for angle, sign in ((0.0, 1), (np.pi / 2, 1), (np.pi, -1), (-np.pi / 2, -1)):
        path, _ = f_path(turned(rhino.PolylineCurve([at(*each) for each in places]), angle))
        joints = parse_curve(path).joints[::sign]  # which way they are run through is no matter
        assert joints == pytest.approx(np.array(places)[:, [0, 2]] * [sign, 1], abs=ROUNDED)


def test_a_level_f_has_x_and_y_of_the_document() -> None:
    path, _ = f_path(rhino.PolylineCurve([at(0, 0, 7), at(1, 2, 7), at(3, 1, 7)]))
    assert path == "M0 0 L1 2 L3 1"


def test_a_polyline_keeps_its_corners_and_a_spline_its_spans() -> None:
    corners = np.random.default_rng(3).uniform(-5, 5, (40, 2)).cumsum(axis=0)
    path, _ = g_path(rhino.PolylineCurve([at(x, y) for x, y in corners.tolist()]))
    assert np.abs(parse_curve(path).joints - corners).max() < ROUNDED * 100
    drawn = spline((0, 0, 0), (3, 4, 0), (5, -2, 0), (8, 3, 0), (11, 0, 0), (15, 1, 0))
    path, notes = g_path(drawn)
    pieces = parse_curve(path).pieces
    assert notes == []
    assert [len(piece.control) for piece in pieces if isinstance(piece, Bezier)] == [4, 4, 4]
    knots = sorted({drawn.Knots[k] for k in range(len(drawn.Knots))})
    for number, (low, high) in enumerate(pairwise(knots)):
        for share in np.linspace(0, 1, 11).tolist():
            place = drawn.PointAt(low + share * (high - low))
            ours = PieceArrays.of(pieces).jet(np.array([number]), np.array([share]))[0][0]
            assert ours == pytest.approx([place.X, place.Y], abs=20 * ROUNDED)


def test_pieces_of_a_polycurve_stay_what_they_are() -> None:
    whole = rhino.PolyCurve()
    whole.AppendSegment(rhino.LineCurve(at(0, 0), at(4, 0)))
    whole.AppendSegment(rhino.ArcCurve.CreateFromArc(rhino.Arc(at(4, 0), at(6, 2), at(4, 4))))
    whole.AppendSegment(spline((4, 4, 0), (2, 4, 0), (1, 6, 0), (0, 8, 0)))
    path, notes = g_path(whole)
    assert notes == []
    line, *arcs, bent = parse_curve(path).pieces
    assert isinstance(line, Bezier)
    assert len(line.control) == 2
    assert arcs
    assert all(isinstance(arc, Arc) for arc in arcs)
    assert isinstance(bent, Bezier)
    assert len(bent.control) == 4


def test_a_spline_of_a_high_degree_is_drawn_anew_and_says_how_near() -> None:
    drawn = spline((0, 0, 0), (2, 5, 0), (4, -5, 0), (6, 5, 0), (8, -5, 0), (10, 0, 0), degree=5)
    path, (note,) = g_path(drawn)
    within = float(note.partition("within ")[2].split()[0])
    low, high = drawn.Domain.T0, drawn.Domain.T1
    theirs = [drawn.PointAt(t) for t in np.linspace(low, high, 4001).tolist()]
    far = np.array([[each.X, each.Y] for each in theirs])
    apart = np.hypot(*(samples(path)[:, None] - far[None]).transpose(2, 0, 1)).min(axis=1).max()
    assert apart <= 1.01 * within + 0.003  # between two of theirs
    assert within < 2e-3


@pytest.mark.parametrize(
    ("read", "curve", "word"),
    [
        (f_path, spline((0, 0, 0), (1, 0, 2), (2, 1, 2), (3, 0, 0)), "not flat"),
        (g_path, spline((0, 0, 0), (1, 0, 0), (2, 1, 2), (3, 0, 0)), "Project"),
        (g_path, arch(), "Project"),
        (f_path, rhino.ArcCurve.CreateFromCircle(rhino.Circle(at(0, 0), 1.0)), "closed"),
    ],
)
def test_refused_curves(read: Any, curve: Any, word: str) -> None:
    with pytest.raises(InputError, match=word) as refused:
        read(curve)
    assert refused.value.remedy


def test_a_g_above_the_ground_is_said() -> None:
    path, (note,) = g_path(rhino.PolylineCurve([at(0, 0, 3), at(1, 0, 3), at(2, 1, 3)]))
    assert path == "M0 0 L1 0 L2 1"
    assert "z = 3" in note


def test_a_surface_becomes_a_mesh_as_near_as_it_says() -> None:
    shape = rhino.NurbsSurface.CreateRuledSurface(
        spline((0, 0, 0), (2, 0, 3), (4, 0, 3), (6, 0, 0)), rhino.LineCurve(at(0, 8), at(6, 8))
    )
    found, (note,) = surface_table(shape)
    vertices, triangles = np.array(found["vertices"]), np.array(found["triangles"])
    within = float(note.rpartition("within ")[2].split()[0])
    assert within < 1e-4 * 10.5
    assert triangles.max() == len(vertices) - 1
    brep = rhino.Brep.CreateFromSurface(shape)
    assert surface_table(brep)[0]["triangles"] == found["triangles"]
    # Along the first curve: z of y = 0 at the share t of its length in x.
    front = vertices[vertices[:, 1] == 0]
    t = front[:, 0] / 6
    assert front[:, 2] == pytest.approx(9 * t * (1 - t), abs=1e-12)


def test_a_mesh_keeps_its_vertices_and_quads_are_split() -> None:
    mesh = rhino.Mesh()
    for place in ((0, 0, 0), (1, 0, 0.25), (1, 1, 0), (0, 1, 0), (2, 0, 0)):
        mesh.Vertices.Add(*place)
    mesh.Faces.AddFace(0, 1, 2, 3)
    mesh.Faces.AddFace(1, 4, 2)
    found, notes = surface_table(mesh)
    assert notes == []
    assert found["vertices"][1] == [1, 0, 0.25]
    assert found["triangles"] == [[0, 1, 2], [0, 2, 3], [1, 4, 2]]


def test_several_faces_are_refused() -> None:
    box = rhino.Brep.CreateFromBox(rhino.Box(rhino.BoundingBox(0, 0, 0, 1, 2, 3)))
    with pytest.raises(InputError, match=r"6 faces.*Mesh Brep"):
        surface_table(box)


def test_structures_are_json_with_all_digits() -> None:
    ends = np.random.default_rng(1).normal(size=(3, 2, 3))
    assert [json.loads(each)["From"]["Y"] for each in lines(ends)] == ends[:, 0, 1].tolist()
    assert json.loads(points(ends[:, 1])[2])["Z"] == ends[2, 1, 2]
    (plane,) = planes(np.zeros((1, 3)), np.array([[[0, 0, 1], [1, 0, 0], [0, 1, 0]]], float))
    assert json.loads(plane)["XAxis"] == {"X": 0.0, "Y": 1.0, "Z": 0.0}
