"""DXF: entities, units, layers and blocks, in files that ezdxf writes."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from ezdxf import path as paths
from ezdxf.filemanagement import new, readfile
from ezdxf.math import Matrix44
from numpy.typing import NDArray

from orishell.conventions.errors import InputError
from orishell.curves import read_dxf, trace_curve
from orishell.curves.nearest import Nearest

Array = NDArray[np.float64]
Draw = Callable[[Any], object]
DOWN = {"extrusion": (0, 0, -1)}


def write(directory: Path, draw: Draw, units: int | None = 6, version: str = "R2000") -> Path:
    """A file with the value ``units`` of $INSUNITS; without it if that is None."""
    document = new(version)
    if units is not None:
        document.header["$INSUNITS"] = units
    draw(document.modelspace())
    path = directory / "drawing.dxf"
    document.saveas(path)
    return path


def line(space: Any) -> None:
    space.add_line((0, 0), (100, 0))


@pytest.mark.parametrize(
    ("units", "metres"),
    [(4, 0.1), (5, 1.0), (6, 100.0), (1, 2.54), (2, 30.48), (14, 10.0), (10, 91.44), (13, 1e-4)],
)
def test_units_are_those_that_the_file_states(tmp_path: Path, units: int, metres: float) -> None:
    """Values of $INSUNITS: DXF reference, HEADER section. 100 of each, in metres."""
    chain = read_dxf(write(tmp_path, line, units), into="m")
    np.testing.assert_allclose(chain.joints[1], [metres, 0], rtol=1e-15)


def test_without_units_the_numbers_are_taken_as_they_are(tmp_path: Path) -> None:
    for units, version in ((0, "R2000"), (None, "R12")):
        path = write(tmp_path, line, units, version)
        assert read_dxf(path, into="ft").joints[1].tolist() == [100, 0]
        assert read_dxf(path, into="m", unit="mm").joints[1] == pytest.approx([0.1, 0])
    path = write(tmp_path, line, 4)
    assert read_dxf(path, into="m", unit="m").joints[1].tolist() == [100, 0]


def _spline_by_points(space: Any) -> None:
    space.add_spline([(0, 0), (1, 1), (2, 0.5), (3, 1)], degree=3)


def _old_polyline(space: Any) -> None:
    points = [(0, 0, 0.3), (1, 0, 0), (2, 1, -0.5), (3, 0, 0)]
    space.add_polyline2d(points, format="xyb")


DRAWINGS: dict[str, Draw] = {
    "LINE": lambda s: s.add_line((1, 2), (3, 5)),
    "ARC": lambda s: s.add_arc((1, 2), 3, 100, 20),
    "ARC from below": lambda s: s.add_arc((1, 2), 3, 10, 80, dxfattribs=DOWN),
    "ELLIPSE": lambda s: s.add_ellipse((1, 2), (2, 1), 0.4, 0.3, 4),
    "ELLIPSE over its beginning": lambda s: s.add_ellipse((1, 2), (2, 1), 0.4, 5, 8),
    "ELLIPSE from below": lambda s: s.add_ellipse((0, 0), (2, 1), 0.4, 0.3, 3, dxfattribs=DOWN),
    "LWPOLYLINE": lambda s: s.add_lwpolyline([(0, 0), (1, 1), (2, 0)]),
    "LWPOLYLINE with bulges": lambda s: s.add_lwpolyline(
        [(0, 0, 0.5), (1, 1, -1), (2, 0, 0.1), (4, 1, 0)], format="xyb"
    ),
    "LWPOLYLINE from below": lambda s: s.add_lwpolyline(
        [(0, 0, 0.5), (1, 1, -1), (2, 0, 0)], format="xyb", dxfattribs=DOWN
    ),
    "POLYLINE": _old_polyline,
    "POLYLINE in space": lambda s: s.add_polyline3d([(0, 0, 7), (1, 1, 7), (2, 0, 7)]),
    "SPLINE": lambda s: s.add_open_spline([(0, 0), (1, 2), (2, -1), (3, 0), (5, 1)], degree=3),
    "SPLINE of degree 5": lambda s: s.add_open_spline([(k, (-1) ** k) for k in range(8)], degree=5),
    "SPLINE with weights": lambda s: s.add_rational_spline(
        [(0, 0), (1, 2), (2, -1), (3, 0)], weights=[1, 3, 0.5, 1], degree=3
    ),
    "SPLINE by points": _spline_by_points,
}


@pytest.mark.parametrize("name", DRAWINGS)
def test_entities_against_ezdxf(tmp_path: Path, name: str) -> None:
    """Points of ezdxf's curve are on ours: exact for splines, Bezier curves near arcs otherwise."""
    path = write(tmp_path, DRAWINGS[name])
    entity = readfile(path).modelspace()[0]
    spline = entity.dxftype() == "SPLINE"
    theirs = entity.construction_tool() if spline else paths.make_path(entity)
    flat = np.array(list(theirs.flattening(1e-3, 16)))
    chain = read_dxf(path, into="m")
    curve = chain.curve()
    assert Nearest.to(trace_curve(curve))(flat[:, :2])[1].max() < (1e-12 if spline else 1e-3)
    ends = np.sort(flat[[0, -1], :2], axis=0)
    np.testing.assert_allclose(np.sort(chain.joints[[0, -1]], axis=0), ends, atol=1e-9)


def test_arcs_are_circles_to_the_last_digits(tmp_path: Path) -> None:
    arc = read_dxf(write(tmp_path, DRAWINGS["ARC from below"]), into="m").curve()
    points = arc.position(np.linspace(0, arc.stop, 500))
    # Seen along -z the x axis points to the left: the centre is (-1, 2).
    np.testing.assert_allclose(np.hypot(*(points - [-1, 2]).T), 3, rtol=1e-15 * 8)
    path = write(tmp_path, lambda s: s.add_lwpolyline([(0, 0, -0.25), (2, 0)], format="xyb"))
    bulged = read_dxf(path, into="m").curve()
    # Height of the arc: bulge times half the chord; radius (1/2 chord)(1 + b^2)/(2 b).
    radius = (1 + 0.25**2) / (2 * 0.25)
    points = bulged.position(np.linspace(0, bulged.stop, 500))
    np.testing.assert_allclose(np.hypot(*(points - [1, 0.25 - radius]).T), radius, rtol=1e-12)
    assert trace_curve(bulged).length == pytest.approx(4 * np.arctan(0.25) * radius, rel=1e-13)


def test_a_drawing_in_any_order_becomes_one_curve(tmp_path: Path) -> None:
    def draw(space: Any) -> None:
        space.add_line((7, 1), (5, 1))
        space.add_arc((1, 0), 1, 90, 180)
        space.add_line((1, 1), (3, 1))
        space.add_spline([(5, 1), (4, 2), (3, 1)])
        space.add_text("NOTE").set_placement((9, 9))
        space.add_point((20, 20))

    chain = read_dxf(write(tmp_path, draw), into="m")
    np.testing.assert_allclose(
        chain.joints[[0, 1, 2, -2, -1]], [(0, 0), (1, 1), (3, 1), (5, 1), (7, 1)], atol=1e-15
    )


UPRIGHT = {
    "x and z": lambda points: np.stack(
        [points[..., 0], 0 * points[..., 0] + 7, points[..., 1]], -1
    ),
    "y and z": lambda points: np.stack(
        [0 * points[..., 0] + 7, points[..., 0], points[..., 1]], -1
    ),
}
"""Points in space of those (..., 2) in a plane, as engineers draw a section."""


@pytest.mark.parametrize("name", DRAWINGS)
@pytest.mark.parametrize("plane", UPRIGHT)
def test_a_section_that_was_drawn_upright_is_the_same_curve(
    tmp_path: Path, name: str, plane: str
) -> None:
    """Every entity, turned by ezdxf: its plane's two axes go to the axes of the other plane."""
    flat = read_dxf(write(tmp_path, DRAWINGS[name]), into="m")
    x, y, origin = UPRIGHT[plane](np.array([[1.0, 0], [0, 1], [0, 0]]))
    x, y = x - origin, y - origin
    numbers = [*x, 0, *y, 0, *np.cross(x, y), 0, *origin, 1]

    def upright(space: Any) -> None:
        DRAWINGS[name](space)
        space[0].transform(Matrix44([float(each) for each in numbers]))

    chain = read_dxf(write(tmp_path, upright), into="m")
    (note,) = chain.notes
    assert f"drawn in {plane}" in note
    np.testing.assert_allclose(chain.joints, flat.joints, rtol=0, atol=1e-12)
    found, wanted = chain.curve(), flat.curve()
    shares = np.linspace(0, 1, 40)
    np.testing.assert_allclose(
        found.position(shares * found.stop), wanted.position(shares * wanted.stop), atol=1e-9
    )


def test_an_upright_section_in_lines_arcs_and_blocks(tmp_path: Path) -> None:
    """As Rhino and AutoCAD write it: arcs and polylines in their own planes, lines in space."""
    front = {"extrusion": (0, -1, 0)}

    def draw(space: Any) -> None:
        space.add_line((0, 5, 0), (0, 5, 3))
        space.add_arc((1, 3, -5), 1, 0, 180, dxfattribs=front)
        block = space.doc.blocks.new("POST")
        block.add_line((0, 0, 3), (0, 0, 0))
        space.add_blockref("POST", (2, 5, 0))

    chain = read_dxf(write(tmp_path, draw), into="m")
    np.testing.assert_allclose(chain.joints, [(0, 0), (0, 3), (2, 3), (2, 0)], atol=1e-12)
    curve = chain.curve()
    assert trace_curve(curve).length == pytest.approx(6 + np.pi, rel=1e-12)
    assert curve.position(0.5 * curve.stop) == pytest.approx([1, 4])
    assert curve.notes == ("drawn in x and z, as seen from the front: z is its height",)


def test_of_several_sections_one_is_chosen_as_the_message_says(tmp_path: Path) -> None:
    path = write(tmp_path, _sections)
    with pytest.raises(InputError, match="choose one with layer or handle") as caught:
        read_dxf(path, into="m")
    named = re.search(r"POLYLINE (\w+) on layer '(.+)'", caught.value.where)
    assert named is not None
    for handle, layer in ((named[1], None), (None, named[2])):
        chain = read_dxf(path, into="m", handle=handle, layer=layer)
        assert chain.joints.tolist() == [[0, 0], [1, 1], [2, 0]]


def test_what_is_inserted_on_a_frozen_layer_is_not_seen(tmp_path: Path) -> None:
    """Whatever its own layer; on one that is off it is, as AutoCAD shows it."""
    for hide, seen in (("freeze", False), ("off", True)):

        def draw(space: Any, hide: str = hide) -> None:
            block = space.doc.blocks.new("B")
            block.add_line((1, 0), (2, 1), dxfattribs={"layer": "A"})
            space.doc.layers.add("A")
            getattr(space.doc.layers.add("OLD"), hide)()
            space.add_line((0, 0), (1, 0), dxfattribs={"layer": "A"})
            space.add_blockref("B", (0, 0), dxfattribs={"layer": "OLD"})

        assert len(read_dxf(write(tmp_path, draw), into="m").pieces) == 1 + seen


def test_a_gap_is_joined_in_the_unit_of_the_file(tmp_path: Path) -> None:
    """Arcs whose angles were rounded: 0.0004 degrees of a radius of 1000 are 0.007."""

    def draw(space: Any) -> None:
        space.add_arc((0, 0), 1000, 30, 90)
        space.add_arc((0, 0), 1000, 90.0004, 150)

    path = write(tmp_path, draw, 4)
    assert read_dxf(path, into="m").notes == ("ends up to 0.007 mm apart were joined",)

    def wide(space: Any) -> None:
        space.add_line((0, 0), (1000, 0))
        space.add_line((1020, 0), (2000, 500))

    path = write(tmp_path, wide, 4)
    with pytest.raises(InputError, match="gaps") as caught:
        read_dxf(path, into="m")
    assert caught.value.remedy.startswith("join = 21 joins them, or choose the curve with handle")
    chain = read_dxf(path, into="m", join=21.0)
    assert caught.value.changes == {"join": 21.0}
    np.testing.assert_allclose(chain.joints, [(0, 0), (1.01, 0), (2, 0.5)], rtol=1e-12)


def test_a_file_without_a_unit_says_so(tmp_path: Path) -> None:
    path = write(tmp_path, line, 0)
    assert "no unit of length: its numbers were read as ft" in read_dxf(path, into="ft").notes[0]
    assert read_dxf(path, into="m", unit="mm").notes == ()
    assert read_dxf(write(tmp_path, line, 4), into="m").notes == ()


def _layers(space: Any) -> None:
    for name, y in (("Profile", 0), ("AXIS", 1), ("Frozen", 2), ("Off", 3)):
        space.doc.layers.add(name)
        space.add_line((0, y), (y + 1, y), dxfattribs={"layer": name})
    space.doc.layers.get("Frozen").freeze()
    space.doc.layers.get("Off").off()
    space.add_line((8, 8), (9, 9), dxfattribs={"layer": "AXIS", "invisible": 1})


def test_layers_and_handles(tmp_path: Path) -> None:
    path = write(tmp_path, _layers)
    assert read_dxf(path, into="m", layer="profile").joints[1].tolist() == [1, 0]
    assert read_dxf(path, into="m", layer="axis").joints[1].tolist() == [2, 1]
    assert read_dxf(path, into="m", layer="Frozen").joints[1].tolist() == [3, 2]
    handle = readfile(path).modelspace()[1].dxf.handle
    assert read_dxf(path, into="m", handle=handle.lower()).joints[1].tolist() == [2, 1]
    with pytest.raises(InputError, match="2 separate parts"):  # what is frozen or off is not drawn
        read_dxf(path, into="m")
    with pytest.raises(InputError, match="'Nothing', expected one of AXIS, Frozen, Off, Profile"):
        read_dxf(path, into="m", layer="Nothing")
    with pytest.raises(InputError, match=rf"'FFFF', expected one of .*{handle}"):
        read_dxf(path, into="m", handle="FFFF")


def _blocks(space: Any) -> None:
    inner = space.doc.blocks.new("INNER")
    inner.add_arc((0, 0), 1, 0, 180)
    inner.add_line((9, 9), (10, 10), dxfattribs={"layer": "NOTES"})
    outer = space.doc.blocks.new("OUTER")
    outer.add_blockref("INNER", (0, 0), dxfattribs={"xscale": 2, "yscale": 0.5})
    space.add_blockref("OUTER", (5, 1), dxfattribs={"rotation": 90, "layer": "SHAPE"})


def test_blocks_are_exploded(tmp_path: Path) -> None:
    """Half a circle, stretched to half axes 2 and 1/2, turned by 90 degrees, moved to (5, 1)."""
    curve = read_dxf(write(tmp_path, _blocks), into="m", layer="shape").curve()
    points = curve.position(np.linspace(0, curve.stop, 100))
    x, y = (points - [5, 1]).T
    np.testing.assert_allclose((x / 0.5) ** 2 + (y / 2) ** 2, 1, rtol=1e-12)
    assert x.max() < 1e-12


def _loop(space: Any) -> None:
    block = space.doc.blocks.new("LOOP")
    block.add_line((0, 0), (1, 0))
    block.add_blockref("LOOP", (1, 0))
    space.add_blockref("LOOP", (0, 0))


def _many(space: Any) -> None:
    block = space.doc.blocks.new("MANY")
    block.add_line((0, 0), (1, 0))
    attributes = {"row_count": 1000, "column_count": 1000, "row_spacing": 1, "column_spacing": 1}
    space.add_blockref("MANY", (0, 0), dxfattribs=attributes)


def _levels(space: Any) -> None:
    space.add_line((0, 0, 0), (1, 0, 0))
    space.add_line((1, 0, 5), (2, 0, 5))


def _sections(space: Any) -> None:
    for y in (0, 4):
        ends = [(0, y, 0), (1, y, 1), (2, y, 0)]
        space.add_polyline3d(ends, dxfattribs={"layer": f"at {y}"})


def _off(space: Any) -> None:
    space.doc.layers.add("Notes").off()
    space.add_line((0, 0), (1, 0), dxfattribs={"layer": "Notes"})


TILTED = {"extrusion": (0, 0.6, 0.8)}
ERRORS: dict[str, tuple[Draw, list[str]]] = {
    "nothing": (lambda s: s.add_text("a"), ["nothing is drawn"]),
    "a circle": (lambda s: s.add_circle((1, 2), 3), ["closed", "from (4, 2) mm"]),
    "an ellipse": (lambda s: s.add_ellipse((0, 0), (1, 0), 0.5), ["closed"]),
    "a closed polyline": (
        lambda s: s.add_lwpolyline([(0, 0), (1, 0), (1, 1)], close=True),
        ["closed", "from (0, 0) mm"],
    ),
    "a closed spline": (
        lambda s: s.add_open_spline([(0, 0), (1, 0), (1, 1), (0, 0)]),
        ["closed"],
    ),
    "a line that rises": (
        lambda s: s.add_line((0, 0, 0), (1, 2, 1)),
        ["LINE", "leaves", "z from 0 to 1", "3DROTATE"],
    ),
    "a spline that rises": (
        lambda s: s.add_open_spline([(0, 0, 0), (1, 0, 0), (2, 0, 0), (3, 1, 1)]),
        ["SPLINE", "leaves"],
    ),
    "an upright arc": (lambda s: s.add_arc((0, 0), 1, 0, 90, dxfattribs=TILTED), ["ARC", "0.6"]),
    "two levels": (_levels, ["different planes", "z = 5", "LINE"]),
    "two sections": (_sections, ["different planes", "y = 4", "as POLYLINE", "layer or handle"]),
    "a mesh": (lambda s: s.add_polymesh((3, 3)), ["POLYLINE", "mesh", "layer or handle"]),
    "a hatch": (
        lambda s: s.add_hatch().paths.add_polyline_path([(0, 0), (1, 0), (1, 1)]),
        ["nothing is drawn", "1 HATCH", "EXPLODE"],
    ),
    "a layout": (
        lambda s: s.doc.layout("Layout1").add_line((0, 0), (1, 0)),
        ["nothing is drawn", "1 in paper space", "CHSPACE"],
    ),
    "a layer that is off": (_off, ["nothing is drawn", "not seen", 'layer = "Notes"']),
    "a block in itself": (_loop, ["without end"]),
    "a block a million times": (_many, ["too often"]),
    "a gap": (
        lambda s: [s.add_line((0, 0), (1, 0)), s.add_line((1.5, 0), (2, 0))],
        ["gaps", "between (1, 0) mm and (1.5, 0) mm", "0.5 apart"],
    ),
    "a spline of a high degree": (
        lambda s: s.add_open_spline([(k, 0) for k in range(20)], degree=15),
        ["SPLINE", "degree", "15"],
    ),
}


@pytest.mark.parametrize("name", ERRORS)
def test_errors(tmp_path: Path, name: str) -> None:
    draw, says = ERRORS[name]
    path = write(tmp_path, draw, 4)
    with pytest.raises(InputError) as caught:
        read_dxf(path, into="m")
    for text in [str(path), *says]:
        assert text in str(caught.value)
    assert caught.value.remedy
    assert caught.value.exit_status == 2


def _beside_a_frame(space: Any) -> None:
    space.add_lwpolyline([(0, 0), (9, 0), (9, 9)], close=True, dxfattribs={"layer": "FRAME"})
    space.add_arc((4, 4), 2, 0, 180, dxfattribs={"layer": "PROFILE"})


def test_what_else_is_drawn_is_named_and_what_to_choose_works(tmp_path: Path) -> None:
    path = write(tmp_path, _beside_a_frame, 4)
    frame, arc = (each.dxf.handle for each in readfile(path).modelspace())
    with pytest.raises(InputError, match="is closed") as caught:
        read_dxf(path, into="mm")
    assert caught.value.got == (
        f"LWPOLYLINE {frame} on layer 'FRAME' (closed), ARC {arc} on layer 'PROFILE' "
        "(a curve with two ends)"
    )
    assert caught.value.remedy == 'choose the curve with layer = "PROFILE"'
    assert len(read_dxf(path, into="mm", layer="PROFILE").pieces) == 1


def test_of_a_closed_curve_of_lines_the_longest_is_named(tmp_path: Path) -> None:
    corners = [(0, 0), (0, 2), (3, 4), (6, 2), (6, 0), (0, 0)]

    def draw(space: Any, count: int = 5) -> None:
        for k in range(count):
            space.add_line(corners[k], corners[k + 1])

    with pytest.raises(InputError, match="closed") as caught:
        read_dxf(write(tmp_path, draw, 4), into="mm")
    named = "as the straight line from (6, 0) mm to (0, 0) mm, or choose the curve with handle"
    assert named in caught.value.remedy
    assert len(read_dxf(write(tmp_path, lambda s: draw(s, 4)), into="mm").pieces) == 4


def test_two_curves_on_a_layer_are_chosen_by_their_handles(tmp_path: Path) -> None:
    def draw(space: Any) -> None:
        line(space)
        space.add_line((0, 50), (100, 50))

    path = write(tmp_path, draw, 4)
    handles = [each.dxf.handle for each in readfile(path).modelspace()]
    with pytest.raises(InputError, match="make ends meet") as caught:
        read_dxf(path, into="mm")
    chosen = " or ".join(f'handle = "{each}"' for each in handles)
    assert caught.value.remedy.endswith(f", or choose the curve with {chosen}")
    for each in handles:
        assert len(read_dxf(path, into="mm", handle=each).pieces) == 1


def test_entities_of_unknown_types_are_passed_over(tmp_path: Path) -> None:
    """As programs built on CAD programs write them."""
    path = write(tmp_path, line, 4)
    text = path.read_text()
    strange = "  0\nACME_WIDGET\n  5\nABCD\n100\nAcDbEntity\n  8\n0\n100\nAcmeWidget\n 40\n1.5\n"
    path.write_text(text.replace("  0\nLINE\n", f"{strange}  0\nLINE\n"))
    assert read_dxf(path, into="mm").joints[1].tolist() == [100, 0]


def test_a_handle_of_what_is_no_curve(tmp_path: Path) -> None:
    path = write(tmp_path, lambda s: s.add_text("a"))
    handle = readfile(path).modelspace()[0].dxf.handle
    with pytest.raises(InputError, match=rf"no curve; got TEXT {handle} on layer '0'"):
        read_dxf(path, into="m", handle=handle)


def test_dwg_is_named(tmp_path: Path) -> None:
    path = tmp_path / "profile.dwg"
    path.write_bytes(b"AC1027\0\0")
    with pytest.raises(InputError, match=r"this is DWG, not DXF\. Remedy: save it as DXF"):
        read_dxf(path, into="m")


def test_files_that_are_cut_off_or_none(tmp_path: Path) -> None:
    path = write(tmp_path, line)
    content = path.read_bytes()
    for share in (0.0, 0.3, 0.9, 0.999):
        path.write_bytes(content[: int(share * len(content))])
        with pytest.raises(InputError, match=r"drawing\.dxf: this is not DXF, or it is cut off"):
            read_dxf(path, into="m")
    path.write_text("hello EOF")
    with pytest.raises(InputError, match="damaged"):
        read_dxf(path, into="m")
    with pytest.raises(InputError, match="DXF file does not exist"):
        read_dxf(tmp_path / "none.dxf", into="m")


def test_binary_and_minimal_files(tmp_path: Path) -> None:
    document = new("R2000")
    document.header["$INSUNITS"] = 4
    document.modelspace().add_arc((0, 0), 1000, 30, 150)
    document.saveas(tmp_path / "binary.dxf", fmt="bin")
    joints = read_dxf(tmp_path / "binary.dxf", into="m").joints
    # 150 degrees are 2.6 radians, an eps off: by its cosine 2.3 eps; sine, radius and unit 1 eps.
    np.testing.assert_allclose(joints[:, 1], 0.5, rtol=0, atol=4 * np.finfo(float).eps)
    minimal = tmp_path / "minimal.dxf"
    tags = "0 SECTION 2 ENTITIES 0 LINE 8 0 10 1 20 2 11 3 21 4 0 ENDSEC 0 EOF"
    minimal.write_text("\r\n".join(tags.split()) + "\r\n")
    assert read_dxf(minimal, into="cm").joints.tolist() == [[1, 2], [3, 4]]
