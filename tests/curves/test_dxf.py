"""DXF: entities, units, layers and blocks, in files that ezdxf writes."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from ezdxf import path as paths
from ezdxf.filemanagement import new, readfile
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
        lambda s: s.add_line((0, 0, 0), (1, 0, 1)),
        ["LINE", "leaves", "z from 0 to 1"],
    ),
    "a spline that rises": (
        lambda s: s.add_open_spline([(0, 0, 0), (1, 0, 0), (2, 0, 0), (3, 1, 1)]),
        ["SPLINE", "leaves"],
    ),
    "an upright arc": (lambda s: s.add_arc((0, 0), 1, 0, 90, dxfattribs=TILTED), ["ARC", "0.6"]),
    "two levels": (_levels, ["different planes", "z = 5", "LINE"]),
    "a mesh": (lambda s: s.add_polymesh((3, 3)), ["POLYLINE", "mesh"]),
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
