"""SVG: lengths, transforms, every shape and command; against svgelements where it can judge."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from orishell.conventions.errors import InputError
from orishell.curves import read_dxf, read_svg, trace_curve
from orishell.curves.pieces import Arc
from orishell.curves.svg.path_data import parse_path
from orishell.curves.svg.tree import parse_transform

Array = NDArray[np.float64]
EXAMPLES = Path(__file__).parents[2] / "examples"
NAMESPACE = 'xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"'
LINE = '<line id="a" x1="0" y1="0" x2="100" y2="0"/>'


def write(directory: Path, body: str, page: str = "") -> Path:
    path = directory / "drawing.svg"
    path.write_text(f"<svg {NAMESPACE} {page}>{body}</svg>", encoding="utf-8")
    return path


def joints(directory: Path, body: str, page: str = "", **choice: Any) -> Array:
    """In pixels, unless a unit is given; y upwards."""
    chain = read_svg(write(directory, body, page), into="in", **choice)
    return chain.joints * (1 if "unit" in choice else 96)


PAGES = {
    "millimetres by viewBox": ('width="210mm" height="297mm" viewBox="0 0 210 297"', LINE),
    "centimetres by viewBox": (
        'width="21cm" height="10cm" viewBox="0 0 21 10"',
        '<path d="M 1,1 h 10"/>',
    ),
    "pixels": ("", f'<path d="M 0,5 H {100 / 25.4 * 96!r}"/>'),
    "pixels by viewBox": (
        'viewBox="0 0 500 500"',
        f'<polyline points="0,0 {100 / 25.4 * 96!r},0"/>',
    ),
    "lengths": ("", '<line x1="5cm" x2="150mm" y1="0.5in" y2="36pt"/>'),
    "inches": ('width="10in" viewBox="0 0 254 254"', LINE),
    "points": ('height="720pt" viewBox="-5 -5 254 254"', LINE),
    "percentages": ('width="200mm" viewBox="0 0 400 300"', '<line x1="10%" x2="60%"/>'),
    "a nested svg": (
        'width="200mm" height="200mm" viewBox="0 0 100 100"',
        '<svg x="10" y="10" width="50" height="50" viewBox="0 0 10 10"><path d="M0 5h10"/></svg>',
    ),
    "transforms": (
        'width="200mm" height="200mm" viewBox="0 0 200 200"',
        '<g transform="translate(50,20) rotate(90)"><g transform="scale(2)">'
        '<path transform="skewX(30)" d="M0 0H50"/></g></g>',
    ),
}


@pytest.mark.parametrize("name", PAGES)
def test_a_line_of_100_mm_is_a_tenth_of_a_metre(tmp_path: Path, name: str) -> None:
    page, body = PAGES[name]
    curve = read_svg(write(tmp_path, body, page), into="m").curve()
    assert trace_curve(curve).length == pytest.approx(0.1, rel=1e-14)


def test_units_of_the_result_and_of_the_file(tmp_path: Path) -> None:
    path = write(tmp_path, LINE, 'width="10mm" height="10mm" viewBox="0 0 100 100"')
    for into, length in (("mm", 10.0), ("cm", 1.0), ("in", 10 / 25.4), ("ft", 10 / 304.8)):
        assert read_svg(path, into=into).joints[1, 0] == pytest.approx(length, rel=1e-15)
    # The key unit overrides what the width says: a user unit is a centimetre.
    assert read_svg(path, into="m", unit="cm").joints[1].tolist() == [1, 0]


def test_y_is_turned_up_and_the_origin_stays(tmp_path: Path) -> None:
    page = 'width="100mm" height="100mm" viewBox="-50 -50 100 100"'
    path = write(tmp_path, '<path d="M 10 20 L 30 -5"/>', page)
    np.testing.assert_allclose(read_svg(path, into="mm").joints, [(10, -20), (30, 5)], rtol=1e-15)


def test_a_page_that_is_not_like_its_view_box(tmp_path: Path) -> None:
    """SVG 2, 8.2: the smaller scale, unless preserveAspectRatio says otherwise."""
    page, body = 'width="100" height="400" viewBox="0 0 50 100"', '<path d="M0 0L10 10"/>'
    assert joints(tmp_path, body, page)[1] == pytest.approx([20, -20])
    assert joints(tmp_path, body, f'{page} preserveAspectRatio="none"')[1] == pytest.approx(
        [20, -40]
    )
    slices = f'{page} preserveAspectRatio="xMinYMax slice"'
    assert joints(tmp_path, body, slices)[1] == pytest.approx([40, -40])


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("M1 2 L3 4 5 6", "m1 2 2 2 2 2"),
        ("M1 2 H5 V7", "m1,2h4v5"),
        ("M0 0 C1 2 3 4 5 5 S7 8 9 9", "M0 0c1 2 3 4 5 5 2 1 2 3 4 4"),
        ("M0 0 Q1 2 3 0 T6 0", "M0 0q1 2 3 0q2-2 3 0"),
        ("M0 0 S1 2 3 0", "M0 0C0 0 1 2 3 0"),
        ("M0 0 L1 0 T6 2", "M0 0L1 0Q1 0 6 2"),
        ("M.5.5L-1-1e0", "M0.5,0.5 L-1,-1"),
        ("M0 0a5 3 20 0110 2", "M0,0 A5,3,20,0,1,10,2"),
        ("M0 0 L1 1 z m5 5 1 0", "M0 0 L1 1 L0 0 M5 5 L6 5"),
        ("M0 0 L1 1 z L3 0", "M0 0 L1 1 L0 0 L3 0"),
    ],
)
def test_spellings_of_a_path(first: str, second: str) -> None:
    from orishell.curves.piecewise import PieceArrays

    one, two = (PieceArrays.of(parse_path(text)) for text in (first, second))
    for share in (0.0, 0.3, 1.0):
        np.testing.assert_allclose(one.at(share), two.at(share), atol=1e-14)


def test_an_arc_lies_on_its_ellipse_and_goes_the_way_its_flags_say() -> None:
    """A half turn of each of the four arcs from (0, 0) to (2, 1) with radii 3 and 2, turned 30."""
    seen = set()
    for large in (0, 1):
        for sweep in (0, 1):
            (arc,) = parse_path(f"M0 0 A 3 2 30 {large} {sweep} 2 1")
            assert isinstance(arc, Arc)
            assert (abs(arc.sweep) > np.pi) == bool(large)
            assert (arc.sweep > 0) == bool(sweep)
            angle = arc.start + arc.sweep * np.linspace(0, 1, 50)
            points = arc.centre + np.stack([np.cos(angle), np.sin(angle)], axis=1) @ arc.axes
            # Eight roundings of what is 3 long: an angle, its sine, axes, the centre and sums.
            rounding = 8 * 3 * 2.0**-53
            np.testing.assert_allclose(points[[0, -1]], [(0, 0), (2, 1)], atol=rounding)
            turn = np.exp(-1j * np.deg2rad(30))
            x = ((points - arc.centre) @ np.array([1, 1j])) * turn
            np.testing.assert_allclose((x.real / 3) ** 2 + (x.imag / 2) ** 2, 1, atol=1e-14)
            seen.add(tuple(np.round(arc.centre, 9)))
    assert len(seen) == 2


def test_radii_that_are_too_small_are_enlarged_and_none_is_a_line(tmp_path: Path) -> None:
    """SVG 2, 9.5.1."""
    (arc,) = parse_path("M0 0 A 1 2 0 0 1 10 0")
    assert isinstance(arc, Arc)
    np.testing.assert_allclose(arc.centre, [5, 0], atol=1e-15)
    np.testing.assert_allclose(np.abs(np.linalg.det(arc.axes)), 5 * 10)
    assert not isinstance(parse_path("M0 0 A 0 2 0 0 1 10 0")[0], Arc)
    assert len(joints(tmp_path, '<path d="M0 0 A 1 1 0 0 1 0 0 L 1 1"/>')) == 2


STEPS = st.one_of(
    st.tuples(
        st.sampled_from(["translate", "scale"]),
        st.lists(st.sampled_from([0.5, -2.0, 3.25, 10.0, 1.5e1]), min_size=1, max_size=2),
    ),
    st.tuples(st.just("rotate"), st.sampled_from([[30.0], [-90.0], [180.0], [45.0, 3.0, -2.0]])),
    st.tuples(st.sampled_from(["skewX", "skewY"]), st.sampled_from([[10.0], [-30.0]])),
    st.tuples(st.just("matrix"), st.just([0.5, 0.25, -1.0, 2.0, 7.0, -3.0])),
)


@given(st.lists(STEPS, max_size=5))
def test_transforms_against_svgelements(steps: list[tuple[str, list[float]]]) -> None:
    import svgelements

    text = " ".join(f"{name}({', '.join(map(str, numbers))})" for name, numbers in steps)
    mine, theirs = parse_transform(text), svgelements.Matrix(text)
    expected = np.array([[theirs.a, theirs.b], [theirs.c, theirs.d], [theirs.e, theirs.f]])
    scale = 1 + np.abs(expected).max()
    np.testing.assert_allclose(mine.matrix, expected[:2], atol=1e-11 * scale)
    np.testing.assert_allclose(mine.offset, expected[2], atol=1e-11 * scale)


DRAWINGS = [
    '<path d="M10 20 C 30 5 40 60 70 20 s 10 10 30 0 q 10 -10 20 0 t 15 5 a 10 5 15 0 1 20 4"/>',
    '<g transform="translate(3 4) scale(2 3)"><g transform="rotate(30)">'
    '<path transform="skewX(10)" d="M1 2 A 6 3 40 1 0 9 5 L 12 5"/></g></g>',
    '<polyline points="1,2 3,4.5 6-1" transform="matrix(1 .5 -.5 2 3 4)"/>',
    '<defs><path id="p" d="M0 0 Q 5 5 10 0"/></defs><use xlink:href="#p" x="5" y="7"'
    ' transform="rotate(10)"/>',
]


@pytest.mark.parametrize("body", DRAWINGS)
@pytest.mark.parametrize("page", ["", 'width="300" height="150" viewBox="0 0 100 50"'])
def test_drawings_against_svgelements(tmp_path: Path, body: str, page: str) -> None:
    """Every point of theirs is on our curve (their viewBox is rounded to 12 decimals)."""
    import svgelements

    from orishell.curves.nearest import Nearest

    path = write(tmp_path, body, page)
    curve = read_svg(path, into="in").scaled(96).curve()
    nearest = Nearest.to(trace_curve(curve))
    points = []
    # Their points are mapped here, because their arcs are no ellipses after a skew.
    for shape in svgelements.SVG.parse(str(path), reify=False).elements():
        if isinstance(shape, svgelements.Shape):
            for segment in shape.segments(transformed=False):
                if not isinstance(segment, svgelements.Move):
                    places = (segment.point(t) for t in np.linspace(0, 1, 20))
                    points += [place * shape.transform for place in places]
    assert len(points) >= 20
    where = np.array([(point.x, -point.y) for point in points])
    assert nearest(where)[1].max() < 1e-8


def test_shapes_that_are_closed(tmp_path: Path) -> None:
    for shape in (
        '<rect x="1" y="2" width="10" height="5"/>',
        '<rect x="1" y="2" width="10" height="5" rx="2"/>',
        '<rect width="10" height="5" rx="9" ry="1"/>',
        '<circle cx="3" cy="4" r="2"/>',
        '<ellipse rx="3" ry="2"/>',
        '<polygon points="0,0 1,0 1,1"/>',
        '<path d="M0 0H1V1z"/>',
    ):
        with pytest.raises(InputError, match="the curve is closed") as caught:
            joints(tmp_path, shape)
        assert "mm, y downwards" in str(caught.value)


def test_a_rectangle_with_round_corners_is_made_of_what_it_should(tmp_path: Path) -> None:
    """Its outline meets an open line in two pieces: area and perimeter by our own trace."""
    from orishell.curves.piecewise import PieceArrays
    from orishell.curves.svg.shapes import draw_shape
    from orishell.curves.svg.tree import Element, View

    values = {"x": "1", "y": "2", "width": "10", "height": "6", "rx": "2"}
    pieces = draw_shape(Element("rect", values), View(0, 0))
    arrays = PieceArrays.of(pieces)
    assert arrays.lengths.sum() == pytest.approx(2 * (6 + 2) + 4 * np.pi, rel=1e-12)
    np.testing.assert_allclose(arrays.at(1.0), np.roll(arrays.at(0.0), -1, axis=0), atol=1e-14)
    assert np.array([arrays.at(0.0).min(axis=0), arrays.at(0.0).max(axis=0)]).tolist() == [
        [1, 2],
        [11, 8],
    ]


def test_what_is_drawn(tmp_path: Path) -> None:
    body = (
        '<defs><path id="d" d="M0 0H9"/></defs><clipPath><path d="M7 7H8"/></clipPath>'
        '<g id="hidden" style="display: none"><path id="h" d="M0 0H5"/></g>'
        '<path visibility="hidden" d="M0 0H6"/><text>words</text><title>t</title>'
        '<symbol id="s" viewBox="0 0 2 2"><path d="M0 0H1"/></symbol>'
        '<g id="shown"><path id="a" d="M0 0H2"/><path id="b" d="M4 0H2"/></g>'
    )
    assert joints(tmp_path, body)[:, 0] == pytest.approx([0, 2, 4])
    assert joints(tmp_path, body, id="shown")[:, 0] == pytest.approx([0, 2, 4])
    assert joints(tmp_path, body, id="b")[:, 0] == pytest.approx([2, 4])
    # What is chosen is read although it is hidden or only defined.
    assert joints(tmp_path, body, id="h")[:, 0] == pytest.approx([0, 5])
    assert joints(tmp_path, body, id="hidden")[:, 0] == pytest.approx([0, 5])
    assert joints(tmp_path, body, id="d")[:, 0] == pytest.approx([0, 9])
    used = body + '<use id="u" href="#s" x="10" width="8" height="8"/>'
    assert joints(tmp_path, used, id="u")[:, 0] == pytest.approx([10, 14])


FRAME = '<rect id="frame" width="400" height="280"/>'
PROFILE = '<path id="profile" d="M50 200A150 150 0 0 1 350 200"/>'
BESIDE: dict[str, tuple[str, list[str], list[str]]] = {
    "a frame": (
        FRAME + PROFILE,
        ["is closed", '<rect id="frame"> (closed)', '<path id="profile"> (a curve with two ends)'],
        ["profile"],
    ),
    "an axis": (
        f'<path id="axis" d="M0 250H400"/>{PROFILE}',
        ["has gaps", "drawn by", "make ends meet"],
        ["profile", "axis"],
    ),
    "a mark at its end": (
        f'<path id="mark" d="M350 200L400 250M350 200V280"/>{PROFILE}',
        ["branches", "3 ends that meet, drawn by", "remove what does not belong"],
        ["profile", "mark"],
    ),
    "a frame beside a group": (
        f'{FRAME}<g id="parts"><path d="M50 50H90"/><path d="M90 50V90"/></g>',
        ["is closed", "<path> (a curve with two ends)"],
        ["parts"],
    ),
    "a frame, and the curve in a group": (f'{FRAME}<g id="a">{PROFILE}</g>', [], ["profile"]),
    "nothing with an id": (
        '<rect width="9" height="9"/><path d="M0 5H9"/>',
        ["<rect> (closed)", "give the element that is meant an id"],
        [],
    ),
    "many": ("".join(f'<path d="M0 {k}H9"/>' for k in range(9)), ["and 3 more"], []),
}


@pytest.mark.parametrize("name", BESIDE)
def test_what_else_is_drawn_is_named_and_the_ids_to_choose_work(tmp_path: Path, name: str) -> None:
    body, says, ids = BESIDE[name]
    path = write(tmp_path, body)
    with pytest.raises(InputError) as caught:
        read_svg(path, into="mm")
    assert all(text in str(caught.value) for text in says)
    assert re.findall(r'id = "(\w+)"', caught.value.remedy) == ids
    for each in ids:
        assert len(read_svg(path, into="mm", id=each).pieces) > 0


def test_one_element_alone_is_named_where_it_makes_no_curve(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r'<path id="a"> from .*: the curve is closed'):
        read_svg(write(tmp_path, '<path id="a" d="M0 0H9V9Z"/>'), into="mm")


ERRORS: dict[str, tuple[str, dict[str, Any], list[str]]] = {
    "an id that is unknown": ('<path id="profile"/>', {"id": "profil"}, ["profile", "'profil'"]),
    "no ids at all": ("<path/>", {"id": "x"}, ["leave id out"]),
    "nothing drawn": ("<text>a</text>", {}, ["nothing is drawn"]),
    "an empty path": ('<path d=""/>', {}, ["nothing is drawn"]),
    "a gap": ('<path d="M0 0H96M192 0h96"/>', {}, ["gaps", "25.4 apart", "(25.4, 0) mm"]),
    "a branch": (
        '<path d="M0 0H96V96"/><path d="M96 0L192 -96"/>',
        {},
        ["branches", "(25.4, 0) mm", "3 ends"],
    ),
    "a path cut off": (
        '<path id="q" d="M0 0 C 1 2"/>',
        {},
        ['<path id="q">', "character 11", "number"],
    ),
    "no first M": ('<path d="L 1 1"/>', {}, ["first one M"]),
    "an unknown command": ('<path d="M0 0 X 5"/>', {}, ["a command", "character 5"]),
    "a bad flag": (
        '<path d="M0 0 A 5 5 0 2 1 9 9"/>',
        {},
        ["the flag large of the command A at character 6"],
    ),
    "a number that is none": (
        '<path d="M0 0 L nan 1"/>',
        {},
        ["x of the command L at character 6 is no number"],
    ),
    "numbers too large": ('<path d="M0 0 L1e999 1"/>', {}, ["not finite"]),
    "a scale too large": ('<path transform="scale(1e200)" d="M0 0L1 1"/>', {}, ["too large"]),
    "half a point": ('<polyline points="1 2 3"/>', {}, ["points", "3 numbers"]),
    "no list": ('<polyline points="1 2 x"/>', {}, ["points", "list of numbers"]),
    "an unknown unit": ('<line x2="5em"/>', {}, ["x2", "'5em'", "mm"]),
    "an unknown transform": ('<g transform="turn(5)"><path/></g>', {}, ["<g>", "transform"]),
    "a transform cut off": ('<path transform="rotate(5" d="M0 0"/>', {}, ["<path>", "transform"]),
    "a transform short of numbers": ('<path transform="matrix(1 2)"/>', {}, ["transform"]),
    "a transform in a style": ('<path style="transform:scale(2)"/>', {}, ["style"]),
    "words": ("<text>a</text>", {}, ["nothing is drawn", "draw a line"]),
    "an image": ('<image href="a.png"/>', {}, ["nothing is drawn", "images: 1", "trace"]),
    "no stroke": ('<path fill="none" d="M0 0H9"/>', {}, ["not seen: 1", "give them a stroke"]),
    "an id of words": (
        '<text id="t">a</text><path id="p" d="M0 0H9"/>',
        {"id": "t"},
        ["nothing is drawn", '<text id="t">', 'choose one with id = "p"'],
    ),
    "an origin in its own box": (
        '<path transform="scale(2)" style="transform-box:fill-box;transform-origin:center"/>',
        {},
        ["transform-box", "fill-box", "apply the transform"],
    ),
    "two parts of one path": (
        '<path d="M0 0H96M192 0h96"/>',
        {},
        ["gaps", "break it apart (Path > Break Apart in Inkscape"],
    ),
    "endless reuse": ('<g id="g"><use href="#g"/></g>', {}, ["without end"]),
}


@pytest.mark.parametrize("name", ERRORS)
def test_errors(tmp_path: Path, name: str) -> None:
    body, choice, says = ERRORS[name]
    path = write(tmp_path, body)
    with pytest.raises(InputError) as caught:
        read_svg(path, into="m", **choice)
    for text in [str(path), *says]:
        assert text in str(caught.value)
    assert caught.value.remedy


HIDDEN = {
    "a layer": '<g id="a" style="display:none"><path d="M0 0H9" stroke="red"/></g><g id="b"/>',
    "a path": '<path id="a" fill="none" d="M0 0H9"/>',
    "a definition": '<defs><path id="a" d="M0 0H9"/></defs>',
}


@pytest.mark.parametrize("name", HIDDEN)
def test_where_nothing_is_seen_what_there_is_can_be_chosen(tmp_path: Path, name: str) -> None:
    path = write(tmp_path, HIDDEN[name])
    with pytest.raises(
        InputError, match="nothing is drawn here; got shapes that are not"
    ) as caught:
        read_svg(path, into="mm")
    assert caught.value.remedy == 'choose one with id = "a"'
    assert len(read_svg(path, into="mm", id="a").pieces) == 1


ILLUSTRATOR = """<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd" [
  <!ENTITY ns_ai "http://ns.adobe.com/AdobeIllustrator/10.0/">
  <!ENTITY ns_svg "http://www.w3.org/2000/svg">
  <!ENTITY st0 "fill:none;stroke:#000000;">
]>
<svg xmlns:i="&ns_ai;" xmlns="&ns_svg;" viewBox="0 0 283.465 100">
<switch><foreignObject requiredExtensions="&ns_ai;" width="1" height="1"/><g i:extraneous="self">
<rect width="200" height="100" style="fill:none"/><path style="&st0;" d="M0,5H283.465"/>
</g></switch></svg>"""


def test_names_that_illustrator_declares_are_read(tmp_path: Path) -> None:
    """And its numbers, which are points of 72 to the inch, become millimetres as the note says."""
    path = tmp_path / "drawing.svg"
    path.write_text(ILLUSTRATOR, encoding="utf-8")
    chain = read_svg(path, into="mm")
    assert len(chain.pieces) == 1
    (note,) = chain.notes
    assert "96 of its units were read as an inch" in note
    scale = float(note.split("scale = ")[1].rstrip(")"))
    assert scale * chain.joints[1, 0] == pytest.approx(100, rel=1e-5)
    for page, count in (('width="100mm"', 0), ('height="2in"', 0), ('width="100px"', 1)):
        assert len(read_svg(write(tmp_path, LINE, page), into="mm").notes) == count
    assert read_svg(path, into="mm", unit="cm").notes == ()


def test_a_transform_about_an_origin(tmp_path: Path) -> None:
    """SVG 2 and CSS Transforms 1: moved there, transformed, moved back; shares of the viewport."""
    page = 'viewBox="0 0 300 200"'
    turned = joints(tmp_path, '<path transform="rotate(30 150 50)" d="M20 80L90 40"/>', page)
    for origin in ("150px 50px", "150 50", "center 25%", "50% 25%"):
        body = f'<path transform="rotate(30)" style="transform-origin:{origin}" d="M20 80L90 40"/>'
        np.testing.assert_allclose(joints(tmp_path, body, page), turned, atol=1e-12)


def test_ends_that_were_rounded_are_joined_and_wider_gaps_as_the_message_says(
    tmp_path: Path,
) -> None:
    """As Illustrator rounds: to two decimals. The gap is in millimetres of the page, or in unit."""
    body = '<g stroke="#000"><path id="a" d="M20,80L99.99,20"/><path id="b" d="{}L180,80"/></g>'
    page = 'width="400mm" viewBox="0 0 200 100"'
    near = write(tmp_path, body.format("M100,20"), page)
    assert read_svg(near, into="m").notes == ("ends up to 0.02 mm apart were joined",)
    assert read_svg(near, into="m", unit="cm").notes == ("ends up to 0.01 cm apart were joined",)
    far = write(tmp_path, body.format("M102,20"), page)
    for unit, gap in ((None, 4.02), ("cm", 2.01)):
        with pytest.raises(InputError, match="gaps") as caught:
            read_svg(far, into="mm", unit=unit)
        assert 'joins them, or choose the curve with id = "b" or id = "a"' in caught.value.remedy
        join = float(caught.value.remedy.split()[2])
        assert gap < join < 1.1 * gap
        (note,) = read_svg(far, into="mm", unit=unit, join=join).notes
        assert f"ends up to {gap:.2g} {unit or 'mm'} apart" in note


@pytest.mark.parametrize(
    ("content", "says"),
    [
        (b"%PDF-1.7", "this is PDF, not SVG. Remedy: save it as SVG in the program"),
        (b"\x1f\x8b\x08", "this is gzip, not SVG"),
        (b"  0\r\nSECTION\r\n", 'this is DXF, not SVG. Remedy: give it as dxf = "..."'),
    ],
)
def test_files_of_another_kind_are_named(tmp_path: Path, content: bytes, says: str) -> None:
    path = tmp_path / "drawing.svg"
    path.write_bytes(content)
    with pytest.raises(InputError) as caught:
        read_svg(path, into="mm")
    assert says in str(caught.value)
    path.write_text("<svg/>")
    with pytest.raises(
        InputError, match=r'this is SVG, not DXF\. Remedy: give it as svg = "\.\.\."'
    ):
        read_dxf(path, into="mm")


@pytest.mark.parametrize(
    "page",
    [
        'viewBox="0 0 0 5"',
        'viewBox="0 0 5"',
        'width="-5mm"',
        'width="x"',
        'viewBox="0 0 1 1" preserveAspectRatio="middle"',
    ],
)
def test_pages_without_a_size(tmp_path: Path, page: str) -> None:
    with pytest.raises(InputError, match="<svg>"):
        joints(tmp_path, LINE, page)


LAUGHS = (
    '<!DOCTYPE svg [<!ENTITY a "ha">'
    + "".join(f'<!ENTITY {chr(98 + k)} "{f"&{chr(97 + k)};" * 10}">' for k in range(9))
    + ']><svg xmlns="http://www.w3.org/2000/svg"><text>&j;</text></svg>'
)
UNSAFE = {
    "a billion laughs": (LAUGHS, "entities"),
    "an entity that grows": (
        f'<!DOCTYPE svg [<!ENTITY a "{"x" * 1000}">]><svg><text>{"&a;" * 2000}</text></svg>',
        "entities",
    ),
    "an external entity": (
        '<!DOCTYPE svg [<!ENTITY x SYSTEM "file:///etc/passwd">]><svg><text>&x;</text></svg>',
        "entities",
    ),
    "a parameter entity": (
        '<!DOCTYPE svg [<!ENTITY % x SYSTEM "http://localhost/x.dtd"> %x;]><svg/>',
        "entities",
    ),
    "nesting": ("<svg>" + "<g>" * 100_000, "nested too deeply"),
    "elements": ("<svg>" + "<g/>" * 200_001 + "</svg>", "too many elements"),
    "no XML": ("<svg", "not XML"),
    "nothing": ("", "not XML"),
    "HTML": ("<html/>", "not SVG"),
    "an unknown encoding": ('<?xml version="1.0" encoding="klingon"?><svg/>', "file.svg"),
    "many blanks": (f'<svg><path d="M0 0{" " * 300_000}x"/></svg>', "no path"),
    "many blanks in a transform": (f'<svg><g transform="{" " * 300_000}x"/></svg>', "transform"),
    "many points in a row": (
        f'<svg><polyline points="{"1." * 100_000}x"/></svg>',
        "list of numbers",
    ),
    "many pieces": (f'<svg><path d="M0 0{"h1" * 60_000}"/></svg>', "too many pieces"),
    "reuse that doubles": (
        '<svg xmlns:x="http://www.w3.org/1999/xlink"><g id="g0"><path d="M0 0h1"/></g>'
        + "".join(f'<g id="g{k + 1}">' + f'<use x:href="#g{k}"/>' * 4 + "</g>" for k in range(18))
        + "</svg>",
        "too often|too many",
    ),
}


@pytest.mark.parametrize("name", UNSAFE)
def test_files_that_would_do_harm(
    tmp_path: Path, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("orishell.curves.svg.walk.MAX_ELEMENTS", 4_000)  # 200,000 take seconds
    content, says = UNSAFE[name]
    path = tmp_path / "file.svg"
    path.write_text(content, encoding="utf-8")
    with pytest.raises(InputError, match=says) as caught:
        read_svg(path, into="m")
    assert "file.svg" in str(caught.value)
    assert len(str(caught.value)) < 1000


def test_a_document_type_alone_is_harmless(tmp_path: Path) -> None:
    path = tmp_path / "file.svg"
    path.write_text(
        '<?xml version="1.0" encoding="UTF-16"?><!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" '
        f'"http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd"><svg {NAMESPACE}>{LINE}</svg>',
        encoding="utf-16",
    )
    assert read_svg(path, into="in").joints[1, 0] == pytest.approx(100 / 96)


def test_files_that_are_none(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"none\.svg: the SVG file does not exist"):
        read_svg(tmp_path / "none.svg", into="m")
    with pytest.raises(InputError, match="not a file"):
        read_svg(tmp_path, into="m")
    (tmp_path / "huge.svg").write_bytes(b" " * 20_000_001)
    with pytest.raises(InputError, match="too large"):
        read_svg(tmp_path / "huge.svg", into="m")


def test_the_example_is_the_arch_of_the_other_example() -> None:
    """Three arcs: radius 0.6 m over 30 degrees, 1.2 m over 60, 0.6 m over 30."""
    drawn = read_svg(EXAMPLES / "profile.svg", into="m", id="profile").curve()
    other = read_dxf(EXAMPLES / "profile.dxf", into="m", layer="profile").curve()
    traces = [trace_curve(curve) for curve in (drawn, other)]
    for trace in traces:
        assert trace.length == pytest.approx(0.6 * math.pi / 3 + 1.2 * math.pi / 3, rel=1e-9)
        assert len(trace.corners) == 0
    t = np.linspace(0, drawn.stop, 200)[1:-1]
    np.testing.assert_allclose(drawn.position(t), other.position(t), atol=1e-9)
    middle = other.position(other.stop * np.linspace(0.3, 0.7, 50))
    np.testing.assert_allclose(np.hypot(*(middle - [0, -1.2]).T), 1.2, rtol=1e-13)
