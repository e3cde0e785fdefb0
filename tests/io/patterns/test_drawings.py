"""Drawings as people make them: lines in any order and form, layers, colours, gaps."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from documents import FAMILIES, demo_document, slit_document
from orishell.conventions.errors import InputError
from orishell.document import Document
from orishell.io import ReadPattern, Settings, read_pattern
from orishell.io.formats import format_of
from orishell.numerics.arrays import Integers
from patterns import miura, svg_of

HEAD = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" '
INKSCAPE = 'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '

SQUARE = '<rect x="0" y="0" width="4" height="4" fill="none" stroke="black"/>'
CROSS = '<path d="M 2 0 V 4" stroke="red"/><path d="M 0 2 H 4" stroke="#00f"/>'


def read_svg(
    tmp_path: Path, content: str, page: str = "", weld: float | None = None
) -> ReadPattern:
    path = tmp_path / "drawing.svg"
    path.write_text(f"{HEAD}{page}>{content}</svg>")
    return read_pattern(path, weld=weld)


def letters(found: ReadPattern) -> dict[str, int]:
    names, counts = np.unique(found.letters, return_counts=True)
    return dict(zip(names.tolist(), counts.tolist(), strict=True))


WINDOW = {"B": 8, "M": 2, "V": 2}
"""A square with a cross: four panels, nine vertices."""


@pytest.mark.parametrize(
    "content",
    [
        SQUARE + CROSS,
        # lines that cross nowhere, polylines and polygons
        '<polygon points="0,0 2,0 4,0 4,4 0,4" stroke="#000"/>'
        '<polyline points="2,0 2,2 2,4" stroke="#F00"/>'
        '<line x1="0" y1="2" x2="2" y2="2" stroke="blue"/>'
        '<line x1="4" y1="2" x2="2" y2="2" stroke="rgb(0, 0, 255)"/>',
        # layers by name, whatever the colour
        '<g id="outline" stroke="lime"><path d="M0 0h4v4h-4z"/></g>'
        '<g class="Mountain folds" stroke="gray"><path d="M2 0v4"/></g>'
        '<g id="g1" inkscape:label="VALLEY"><g stroke="red"><path d="M0 2h4"/></g></g>',
        # a style sheet, a style, and what is inherited
        "<style>/* of a program */ .a, .b {stroke: #000000; fill: none} .b {stroke:red}"
        " path {stroke-width: 1}</style>"
        '<path class="a" d="M0 0h4v4h-4z"/><path class="b" d="M2 0v4" stroke="blue"/>'
        '<g style="stroke: blue; fill: none"><path d="M0 2h4"/></g>',
        # moved, turned and reused
        '<defs><path id="half" d="M-2 0h4"/></defs>'
        '<g transform="translate(2 2)"><use xlink:href="#half" stroke="blue"/>'
        '<use xlink:href="#half" stroke="red" transform="rotate(90)"/>'
        '<g transform="scale(2)"><path d="M-1-1h2v2h-2z" stroke="black"/></g></g>',
        # drawn twice, of no length, in the midst of the border, hidden, without a stroke
        SQUARE + CROSS + '<path d="M 2 0 V 3" stroke="red"/><path d="M 1 1 H 1" stroke="red"/>'
        '<path d="M 0 0 H 1" stroke="black"/><g display="none"><path d="M0 0L4 4"/></g>'
        '<path d="M 0 0 L 4 4"/><text stroke="red">words</text><circle r="1" stroke="red"/>',
        # straight lines as a program that knows only curves draws them
        '<path d="M0 0C1 0 2 0 4 0C4 2 4 3 4 4L0 4z" stroke="#111"/>' + CROSS,
    ],
    ids=["crossing", "touching", "layers", "style sheet", "transforms", "mended", "as curves"],
)
def test_a_square_with_a_cross_however_it_is_drawn(content: str, tmp_path: Path) -> None:
    found = read_svg(tmp_path, content, INKSCAPE)
    assert letters(found) == WINDOW
    assert found.flat is not None
    assert sorted(map(tuple, found.flat.vertices.round(12).tolist())) == [
        (float(x), float(y)) for x in (0, 2, 4) for y in (-4, -2, 0)
    ]
    assert len(found.flat.faces) == 4
    assert found.unit == "unit"


def test_what_was_mended_is_said(tmp_path: Path) -> None:
    content = (
        SQUARE + CROSS + '<path d="M 2 0 V 3" stroke="red"/><path d="M 1 1 H 1" stroke="red"/>'
    )
    said = " | ".join(read_svg(tmp_path, content).notes)
    assert "1 line of no length: left out" in said
    assert "drawn twice" in said
    assert "no unit" in said


def test_opacity_is_a_fold_angle_as_origami_simulator_has_it(tmp_path: Path) -> None:
    content = (
        SQUARE + '<path d="M2 0V4" stroke="red" opacity="0.5"/>'
        '<g stroke-opacity="25%"><path d="M0 2H4" stroke="blue"/></g>'
    )
    found = read_svg(tmp_path, content)
    asked = {letter: np.unique(found.fold_angles[found.letters == letter]) for letter in "MV"}
    np.testing.assert_allclose(asked["M"], -np.pi / 2, rtol=1e-15)
    np.testing.assert_allclose(asked["V"], np.pi / 4, rtol=1e-15)
    opaque = read_svg(tmp_path, content.replace(' opacity="0.5"', ""))
    np.testing.assert_allclose(opaque.fold_angles[opaque.letters == "M"], -np.pi, rtol=1e-15)
    assert np.isnan(found.fold_angles[found.letters == "B"]).all()


def test_a_page_with_a_physical_size_has_millimetres(tmp_path: Path) -> None:
    found = read_svg(tmp_path, SQUARE + CROSS, 'width="8cm" height="8cm" viewBox="0 0 4 4"')
    assert found.flat is not None
    assert found.unit == "mm"
    np.testing.assert_allclose(np.ptp(found.flat.vertices, axis=0), 80.0, rtol=1e-12)


def test_black_lines_alone_are_creases_without_a_letter(tmp_path: Path) -> None:
    found = read_svg(tmp_path, (SQUARE + CROSS).replace("red", "black").replace("#00f", "black"))
    assert letters(found) == {"B": 8, "U": 4}
    assert "no crease is assigned" in " ".join(found.notes)


def test_creases_over_outlines_of_panels_keep_their_letters(tmp_path: Path) -> None:
    outlines = "".join(
        f'<rect x="{x}" y="{y}" width="2" height="2" stroke="black"/>'
        for x in (0, 2) for y in (0, 2)
    )  # fmt: skip
    beyond = '<path d="M 0 1 V 3" stroke="red"/>'  # a crease along the border remains a border
    for content in (outlines + CROSS + beyond, CROSS + beyond + outlines):
        found = read_svg(tmp_path, content)
        assert letters(found) == WINDOW
        assert not any("cut" in note for note in found.notes)


@pytest.mark.parametrize(
    "blue", ["#0066cc", "#1f77b4", "dodgerblue", "steelblue", "#0af", "navy", "hsl(240, 100%, 50%)"]
)
def test_what_people_call_blue_is_a_valley(blue: str, tmp_path: Path) -> None:
    found = read_svg(tmp_path, SQUARE + CROSS.replace("#00f", blue))
    assert letters(found) == WINDOW


def test_a_letter_may_be_written_at_a_line(tmp_path: Path) -> None:
    """As Rabbit Ear does; it counts for more than a colour."""
    written = CROSS.replace('stroke="red"', 'stroke="#888" data-assignment="m"')
    assert letters(read_svg(tmp_path, SQUARE + written)) == WINDOW


def test_green_creases_are_said_to_be_cuts(tmp_path: Path) -> None:
    green = '<path d="M2 0V4" stroke="green"/><path d="M3 0V4" stroke="red"/>'
    with pytest.raises(InputError, match="cuts as <path> number 2") as caught:
        read_svg(tmp_path, SQUARE + green)
    assert "draw them red (mountain), blue (valley)" in caught.value.remedy
    mended = read_svg(tmp_path, SQUARE + green.replace("green", "blue"))
    assert letters(mended)["V"] == 1


def test_auxiliary_lines_are_left_out_and_counted(tmp_path: Path) -> None:
    found = read_svg(
        tmp_path, SQUARE + CROSS + '<g id="AuxLines" stroke="lime"><path d="M0 0L4 4"/></g>'
    )
    assert letters(found) == WINDOW
    assert "auxiliary lines are no creases: 1 left out" in found.notes


def test_a_border_between_panels_is_a_cut_and_around_a_panel_a_hole(tmp_path: Path) -> None:
    found = read_svg(tmp_path, SQUARE + CROSS + '<path d="M2 1H4" stroke="black"/>')
    assert letters(found)["C"] == 1
    hole = '<path d="M1.5 1.5h1v1h-1z" stroke="black"/>'
    with pytest.raises(InputError, match="not one piece"):  # four panels within
        read_svg(tmp_path, SQUARE + CROSS + hole)
    around = CROSS.replace("V 4", "V1.5M2 2.5V4").replace("H 4", "H1.5M2.5 2H4")
    found = read_svg(tmp_path, SQUARE + around + hole)
    assert found.flat is not None
    assert len(found.flat.faces) == 4
    # the hole parts both creases, and they part its border into eight edges
    assert letters(found) == {"B": 8 + 8, "M": 2, "V": 2}
    assert "a hole" in " ".join(found.notes)


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (SQUARE + '<path d="M2 0V3" stroke="red"/>',
         r"number 2 at \(2, 3\), y downwards: a line ends"),
        (CROSS, "draw the border"),
        ('<path d="M4 0H0V4" stroke="#000"/>' + CROSS, "ends of lines.*the rest of the border"),
        (SQUARE + '<path d="M0 0V4" stroke="#888"/>' + '<path d="M9 9h1v1h-1z" stroke="red"/>',
         "do not hang together.*2 pieces.*a file of its own"),
        (SQUARE + '<path d="M0 2Q2 3 4 2" stroke="red"/>', "path.*number 2.*curved"),
        (SQUARE + CROSS + '<path d="M2 0V2" stroke="blue"/>',
         r"\(2, 1\).*a mountain and a valley.*number 2 and <path> number 4"),
        (SQUARE + '<path d="M1 1H3V3H1z" stroke="red"/>', "do not hang together"),
        (SQUARE + '<path d="M1 1H3V3H1zM0 0L1 1" stroke="red"/>', "same panel on both sides"),
        ("", "no lines"),
        ('<path d="M0 0h4v4h-4z"/>', "no lines"),
        (SQUARE.replace('"4"', '"1e300"'), "too large"),
        ('<path d="M0 0H4" stroke="red"/><path d="M0 0H4" stroke="red"/>', "ends"),
    ],
)  # fmt: skip
def test_drawings_that_are_no_pattern_are_refused_by_place(
    content: str, said: str, tmp_path: Path
) -> None:
    with pytest.raises(InputError, match=said) as caught:
        read_svg(tmp_path, content)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("gap", [1e-3, 2e-2, 6e-2])
def test_a_gap_is_closed_or_refused_with_the_weld_that_closes_it(
    gap: float, tmp_path: Path
) -> None:
    """Up to a half percent of the diagonal it is closed, and said."""
    content = (
        SQUARE + f'<path d="M2 {gap}V4" stroke="red"/><path d="M0 2H{4 - gap}" stroke="#00f"/>'
    )
    if gap < 0.005 * np.hypot(4, 4):
        found = read_svg(tmp_path, content)
        assert f"ends up to {gap:g} apart were joined" in found.notes[-1]
        assert letters(found) == WINDOW
        return
    with pytest.raises(InputError, match="2 ends of lines") as caught:
        read_svg(tmp_path, content)
    remedy = caught.value.remedy
    assert remedy.startswith("weld = ")
    assert letters(read_svg(tmp_path, content, weld=float(remedy.split()[2].strip(",")))) == WINDOW


def test_creases_that_nearly_meet_in_a_point_are_told_with_the_weld_that_joins_them(
    tmp_path: Path,
) -> None:
    """Three lines through the middle of a square, one of them 0.01 beside it."""
    content = SQUARE + CROSS + '<path d="M0 0.01L3.99 4" stroke="red"/>'
    found = read_svg(tmp_path, content)
    note = next(each for each in found.notes if "long" in each)
    weld = float(note.split("weld = ")[1].split()[0])
    joined = read_svg(tmp_path, content, weld=weld)
    assert len(joined.faces) == 6
    assert len(found.faces) == 7


def test_rounded_coordinates_of_a_drawing_program_are_welded(tmp_path: Path) -> None:
    """Three decimals of a page of 1000: half of the last one is 4e-7 of the diagonal."""
    pattern = miura(20, 20)
    rng = np.random.default_rng(1)
    scale = 1000 / np.ptp(pattern.vertices[:, 0])
    ends = (scale * pattern.vertices)[pattern.edges] + rng.uniform(
        -5e-4, 5e-4, (len(pattern.edges), 2, 2)
    )
    stroke = {"B": "black", "M": "red", "V": "blue"}
    lines = "".join(
        f'<line x1="{a:.3f}" y1="{-b:.3f}" x2="{c:.3f}" y2="{-d:.3f}" stroke="{stroke[letter]}"/>'
        for ((a, b), (c, d)), letter in zip(ends.tolist(), pattern.letters.tolist(), strict=True)
    )
    found = read_svg(tmp_path, lines)
    assert found.flat is not None
    assert len(found.flat.vertices) == len(pattern.vertices)
    assert len(found.flat.inner) == 19 * 19


def dxf_file(tmp_path: Path, tags: str) -> Path:
    path = tmp_path / "drawing.dxf"
    pairs = tags.split()
    path.write_text("".join(f"{a}\n{b}\n" for a, b in zip(pairs[::2], pairs[1::2], strict=True)))
    return path


def test_dxf_has_letters_by_colour_and_layer_and_blocks(tmp_path: Path) -> None:
    found = read_pattern(
        dxf_file(
            tmp_path,
            "0 SECTION 2 HEADER 9 $INSUNITS 70 5 0 ENDSEC "
            "0 SECTION 2 TABLES 0 TABLE 2 LAYER 0 LAYER 2 A 70 0 62 5 6 CONTINUOUS "
            "0 ENDTAB 0 ENDSEC "
            "0 SECTION 2 BLOCKS 0 BLOCK 8 0 2 HALF 70 0 10 0 20 0 30 0 "
            "0 LINE 8 A 10 -2 20 0 30 0 11 2 21 0 31 0 0 ENDBLK 8 0 0 ENDSEC "
            "0 SECTION 2 ENTITIES "
            "0 POLYLINE 8 Outline 66 1 70 1 10 0 20 0 30 0 "
            "0 VERTEX 8 0 10 0 20 0 30 0 0 VERTEX 8 0 10 4 20 0 30 0 "
            "0 VERTEX 8 0 10 4 20 4 30 0 0 VERTEX 8 0 10 0 20 4 30 0 0 SEQEND 8 0 "
            "0 LINE 8 0 62 1 10 2 20 0 30 0 11 2 21 4 31 0 "
            "0 INSERT 8 0 2 HALF 10 2 20 2 30 0 "
            "0 TEXT 8 0 10 1 20 1 30 0 40 1 1 words "
            "0 ENDSEC 0 EOF",
        )
    )
    assert letters(found) == WINDOW
    assert found.unit == "cm"


def test_origami_simulators_page_is_read_as_it_reads_ours(tmp_path: Path) -> None:
    path = tmp_path / "pattern.svg"
    path.write_text(svg_of(miura()))
    found = read_pattern(path)
    assert found.unit == "unit"
    assert found.flat is not None
    assert len(found.flat.inner) == 20


def corners(loops: Integers) -> list[int]:
    """How many each panel has, those on its sides counted."""
    return sorted((loops >= 0).sum(axis=1).tolist())


OURS: dict[str, Callable[[], Document]] = {
    **{name: partial(demo_document, name) for name in FAMILIES},
    "slit flaps": slit_document,
}


@pytest.mark.parametrize("sheet", OURS)
@pytest.mark.parametrize("name", ["a.fold", "a.svg", "a.dxf", "a.origami-simulator.svg"])
def test_our_own_files_are_read_as_the_sheet_that_they_are_of(
    name: str, sheet: str, tmp_path: Path
) -> None:
    """Marks, labels and title left out, at the size of the sheet where the page has one."""
    document = OURS[sheet]()
    format_of(Path(name)).write(tmp_path / name, document, Settings())
    found = read_pattern(tmp_path / name)
    assert found.flat is not None
    assert document.flat is not None
    assert corners(found.faces) == corners(document.mesh.loops)
    wanted = np.array(document.assignment)
    wanted[~document.mesh.crease] = "B"
    assert sorted(found.letters) == sorted(wanted)
    if found.unit != "unit":
        flat = found.in_unit(document.unit).flat
        assert flat is not None
        size = np.ptp(document.flat[np.unique(document.mesh.faces)], axis=0)
        np.testing.assert_allclose(np.ptp(flat.vertices, axis=0), size, atol=1e-8)
