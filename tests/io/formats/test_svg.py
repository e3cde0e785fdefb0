from collections import defaultdict
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from svgelements import SVG, Circle, Group, Shape, SimpleLine
from svgelements import Path as SvgPath

from documents import FAMILIES, demo_document
from orishell.conventions.errors import InputError
from orishell.conventions.quantities import MILLIMETRES
from orishell.document import Document
from orishell.io.format import Settings
from orishell.io.formats.svg import write_svg
from orishell.motion.quads import signed_areas
from orishell.workshop import DEFAULT, Workshop
from orishell.workshop.palettes import load_palette
from orishell.workshop.sheets import draw_sheets

SPACE = "{http://www.w3.org/2000/svg}"
INKSCAPE = "{http://www.inkscape.org/namespaces/inkscape}"


def shapes_mm(path: Path) -> dict[str, list[Shape]]:
    """What a reader sees in each group, in millimetres.

    svgelements takes a millimetre for 0.0393701 inches, which are 25.4 mm each but for 5e-7.
    """
    metric = "m" in ElementTree.parse(path).getroot().get("width", "")
    drawn = SVG.parse(str(path), ppi=1 / 0.0393701 if metric else 25.4)
    shapes: dict[str, list[Shape]] = defaultdict(list)
    for group in drawn.select(lambda element: isinstance(element, Group)):
        if group.id:
            shapes[group.id] = [each for each in group if isinstance(each, Shape)]
    return shapes


def written(path: Path, document: Document, workshop: Workshop = DEFAULT) -> ElementTree.Element:
    write_svg(path, document, Settings(workshop=workshop))
    return ElementTree.parse(path).getroot()


@pytest.mark.parametrize("unit", MILLIMETRES)
@pytest.mark.parametrize("family", FAMILIES)
def test_another_program_sees_it_in_its_physical_size(
    family: str, unit: str, tmp_path: Path
) -> None:
    mm = MILLIMETRES[unit]
    document = demo_document(family)
    document = replace(document, unit=unit, flat=document.require_flat() * (1000 / mm))
    written(tmp_path / "pattern.svg", document)
    shapes = shapes_mm(tmp_path / "pattern.svg")
    ends = mm * document.require_flat()[document.mesh.edges]
    lengths = np.hypot(*(ends[:, 1] - ends[:, 0]).T)
    letters = np.array(document.assignment)
    for layer, letter in {"MOUNTAIN": "M", "VALLEY": "V", "ENGRAVE": "F"}.items():
        drawn = sum(float(SvgPath(shape).length()) for shape in shapes[layer])
        assert drawn == pytest.approx(lengths[letters == letter].sum(), abs=1e-4)
    (outline,) = shapes["CUT"]
    path = SvgPath(outline)
    assert path[-1].__class__.__name__ == "Close"
    points = np.array([(each.end.x, -each.end.y) for each in path[:-1]])
    assert signed_areas(points) == pytest.approx(mm**2 * document.areas().sum(), rel=1e-9)
    # The other way up and at another place, every vertex is where the sheet has it.
    corners = points - points.min(axis=0)
    flat = mm * (document.require_flat() - document.require_flat().min(axis=0))
    away = np.hypot(*np.moveaxis(corners[:, None] - flat, -1, 0)).min(axis=1)
    assert away.max() < 5e-6


@pytest.mark.parametrize(("unit", "said"), [("mm", "mm"), ("cm", "cm"), ("in", "in"), ("m", "mm")])
def test_width_and_height_have_units_and_coordinates_are_in_the_documents(
    unit: str, said: str, tmp_path: Path
) -> None:
    document = replace(demo_document(), unit=unit)
    root = written(tmp_path / "pattern.svg", document)
    (drawing,) = draw_sheets(document, Workshop())
    assert root.get("width", "").endswith(said)
    width = float(root.get("width", "").removesuffix(said)) * MILLIMETRES[said]
    assert width == pytest.approx(drawing.width * MILLIMETRES[unit], abs=1e-5)
    box = [float(number) for number in root.get("viewBox", "").split()]
    assert box == pytest.approx([0, 0, drawing.width, drawing.height], abs=1e-6)


@pytest.mark.parametrize("palette", ["plain", "lightburn", "epilog"])
def test_groups_are_the_palettes_layers_in_the_order_of_work(palette: str, tmp_path: Path) -> None:
    document = replace(demo_document(), unit="in")
    root = written(tmp_path / "pattern.svg", document, Workshop(palette=palette))
    groups = root.findall(f"{SPACE}g")
    pens = {str(layer): pen for layer, pen in load_palette(palette).pens.items()}
    order = ["LABEL", "ENGRAVE", "MOUNTAIN", "VALLEY", "CUT"]
    assert [group.get("id") for group in groups] == [name for name in order if name in pens]
    page_mm = 25.4 * float(root.get("width", "").removesuffix("in"))
    for group in groups:
        name = group.get("id", "")
        assert group.get(f"{INKSCAPE}groupmode") == "layer"
        assert group.get(f"{INKSCAPE}label") == name
        pen = pens[name]
        assert (group.get("stroke"), group.get("fill")) == (pen.colour, "none")
        width = 25.4 * float(group.get("stroke-width", ""))
        expected = pen.width_mm * (page_mm / 420 if palette == "plain" else 1)
        assert width == pytest.approx(expected, rel=1e-5)


def test_hairlines_are_a_thousandth_of_an_inch(tmp_path: Path) -> None:
    document = replace(demo_document(), unit="in")
    root = written(tmp_path / "pattern.svg", document, Workshop(palette="epilog"))
    assert {group.get("stroke-width") for group in root.iter(f"{SPACE}g")} == {"0.001"}


def test_holes_come_before_the_outer_cut_and_words_are_words(tmp_path: Path) -> None:
    document = replace(demo_document("orthodiagonal"), title="A <roof> & more\x07")
    workshop = Workshop(relief_hole=0.01, labels="both")
    root = written(tmp_path / "pattern.svg", document, workshop)
    cut = shapes_mm(tmp_path / "pattern.svg")["CUT"]
    inner = len(document.mesh.inner_vertices())
    assert [type(shape) is Circle for shape in cut] == [True] * inner + [False]
    assert cut[0].rx == pytest.approx(5.0)  # millimetres
    assert root.findtext(f"{SPACE}title") == "A <roof> & more "
    words = [text.text for text in root.iter(f"{SPACE}text")]
    assert {"A <roof> & more ", "0,0", "9,13", "SCALE 1:1"} <= set(words)
    assert all(each.get("stroke") == "none" for each in root.iter(f"{SPACE}text"))


def test_labels_are_turned_about_their_anchor_and_stand_on_it(tmp_path: Path) -> None:
    document = demo_document("orthodiagonal")
    workshop = Workshop(labels="panels", title_block=False)
    root = written(tmp_path / "pattern.svg", document, workshop)
    (drawing,) = draw_sheets(document, workshop)
    for text, element in zip(drawing.texts, root.iter(f"{SPACE}text"), strict=True):
        x, y = float(element.get("x", "")), float(element.get("y", ""))
        turn = element.get("transform", "rotate(0 0 0)").removeprefix("rotate(").split()[0]
        angle = -np.deg2rad(float(turn))
        assert angle == pytest.approx(text.angle, abs=1e-6)
        # From the baseline half the height of capitals upwards lies the drawing's anchor.
        up = 0.5 * text.height * np.array([-np.sin(angle), np.cos(angle)])
        assert x + up[0] == pytest.approx(text.x, abs=1e-6)
        assert drawing.height - y + up[1] == pytest.approx(text.y, abs=1e-6)


def test_creases_are_single_lines(tmp_path: Path) -> None:
    written(tmp_path / "pattern.svg", demo_document(), Workshop(creases="dashes"))
    shapes = shapes_mm(tmp_path / "pattern.svg")
    assert all(isinstance(each, SimpleLine) for each in shapes["MOUNTAIN"] + shapes["VALLEY"])


def test_a_sheet_larger_than_the_stock_is_a_map_and_numbered_sheets(tmp_path: Path) -> None:
    document = demo_document("orthodiagonal")
    workshop = Workshop(stock=(2.0, 3.0), margin=0.05, spacing=0.02)
    written(tmp_path / "pattern.svg", document, workshop)
    count = len(draw_sheets(document, workshop))
    assert count > 2
    names = {f"pattern-{number}.svg" for number in range(1, count)} | {"pattern.svg"}
    assert {path.name for path in tmp_path.iterdir()} == names
    sheet = ElementTree.parse(tmp_path / "pattern-1.svg").getroot()
    assert (sheet.get("width"), sheet.get("height")) == ("2000mm", "3000mm")


def test_a_document_without_a_unit_is_refused_and_no_file_is_left(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="needs a unit of length"):
        write_svg(tmp_path / "a.svg", replace(demo_document(), unit="unit"), Settings())
    assert not list(tmp_path.iterdir())
