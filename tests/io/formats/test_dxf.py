from collections import Counter
from dataclasses import replace
from pathlib import Path

import ezdxf
import numpy as np
import pytest
from ezdxf import bbox, units
from ezdxf.document import Drawing as DxfDocument
from ezdxf.entities.circle import Circle
from ezdxf.entities.line import Line
from ezdxf.entities.lwpolyline import LWPolyline
from ezdxf.entities.text import Text
from ezdxf.lldxf.encoding import decode_dxf_unicode

from documents import FAMILIES, demo_document
from orishell.conventions.errors import InputError
from orishell.conventions.quantities import MILLIMETRES
from orishell.document import Document
from orishell.io.format import Settings
from orishell.io.formats.dxf import write_dxf
from orishell.motion.quads import signed_areas
from orishell.workshop import DEFAULT, LAYERS, Workshop
from orishell.workshop.palettes import load_palette
from orishell.workshop.settings import CreaseStyle
from orishell.workshop.sheets import draw_sheets


def written(path: Path, document: Document, workshop: Workshop = DEFAULT) -> DxfDocument:
    """The file as ezdxf reads it, its audit without findings."""
    write_dxf(path, document, Settings(workshop=workshop))
    file = ezdxf.readfile(path)
    auditor = file.audit()
    assert not auditor.errors
    assert not auditor.fixes
    return file


@pytest.mark.parametrize("family", FAMILIES)
def test_lengths_by_layer_are_those_of_the_creases_by_assignment(
    family: str, tmp_path: Path
) -> None:
    document = demo_document(family)
    file = written(tmp_path / "pattern.dxf", document)
    ends = document.require_flat()[document.mesh.edges]
    lengths = np.hypot(*(ends[:, 1] - ends[:, 0]).T)
    letters = np.array(document.assignment)
    drawn: Counter[str] = Counter()
    for line in file.modelspace().query("LINE"):
        assert isinstance(line, Line)
        drawn[line.dxf.layer] += (line.dxf.end - line.dxf.start).magnitude
    for layer, letter in {"MOUNTAIN": "M", "VALLEY": "V", "ENGRAVE": "F"}.items():
        assert drawn[layer] == pytest.approx(lengths[letters == letter].sum(), rel=1e-12)


@pytest.mark.parametrize("family", FAMILIES)
def test_the_outer_cut_is_closed_last_and_encloses_the_sheet(family: str, tmp_path: Path) -> None:
    document = demo_document(family)
    *_, outline = written(tmp_path / "pattern.dxf", document).modelspace()
    assert isinstance(outline, LWPolyline)
    assert (outline.dxf.layer, outline.closed) == ("CUT", True)
    area = signed_areas(np.array(outline.get_points("xy")))
    assert area == pytest.approx(document.areas().sum(), rel=1e-9)


@pytest.mark.parametrize("unit", MILLIMETRES)
def test_the_unit_is_declared(unit: str, tmp_path: Path) -> None:
    document = replace(demo_document(), unit=unit)
    file = written(tmp_path / "pattern.dxf", document)
    assert file.dxfversion == "AC1015"
    assert units.decode(file.header["$INSUNITS"]) == unit
    assert file.header["$MEASUREMENT"] == (0 if unit in ("in", "ft") else 1)
    (drawing,) = draw_sheets(document, Workshop())
    assert file.header["$LIMMIN"] == (0, 0)
    assert file.header["$LIMMAX"] == pytest.approx((drawing.width, drawing.height))
    box = bbox.extents(entity for entity in file.modelspace() if not isinstance(entity, Text))
    assert tuple(file.header["$EXTMIN"]) == pytest.approx(tuple(box.extmin))
    assert tuple(file.header["$EXTMAX"]) == pytest.approx(tuple(box.extmax))


@pytest.mark.parametrize("palette", ["plain", "lightburn", "epilog"])
def test_layers_have_the_palettes_colours_and_are_empty_where_it_leaves_them_out(
    palette: str, tmp_path: Path
) -> None:
    file = written(tmp_path / "pattern.dxf", demo_document(), Workshop(palette=palette))
    pens = load_palette(palette).pens
    drawn = {entity.dxf.layer for entity in file.modelspace()}
    for layer in LAYERS:
        pen = pens.get(layer)
        assert file.layers.get(layer).color == (pen.aci if pen else 7)
        assert (layer in drawn) == (pen is not None)
    assert drawn <= set(LAYERS)
    assert {entity.dxf.color for entity in file.modelspace()} == {256}  # by layer


def test_holes_and_labels_are_circles_and_words(tmp_path: Path) -> None:
    document = replace(demo_document("orthodiagonal"), title="50%%c ^J\nroof Ω")
    workshop = Workshop(relief_hole=0.01, labels="both", creases="dashes")
    space = written(tmp_path / "pattern.dxf", document, workshop).modelspace()
    holes = [entity for entity in space if isinstance(entity, Circle)]
    assert len(holes) == len(document.mesh.inner_vertices())
    assert {(hole.dxf.layer, hole.dxf.radius) for hole in holes} == {("CUT", 0.005)}
    words = [text for text in space if isinstance(text, Text)]
    engraved = [text.dxf.text for text in words if text.dxf.layer == "ENGRAVE"]
    folding = sum(letter in "MV" for letter in document.assignment)
    assert len(engraved) == len(document.mesh.faces) + folding
    assert {"0,0", "9,13"} <= set(engraved)
    assert any(word.endswith("°") for word in engraved)
    titles = [decode_dxf_unicode(text.plain_text()) for text in words if "roof" in text.dxf.text]
    assert titles == ["50% %c ^J roof Ω"]


@pytest.mark.parametrize("creases", ["score", "dashes"])
def test_entities_are_what_ezdxf_writes(creases: CreaseStyle, tmp_path: Path) -> None:
    """ezdxf reads the entities and writes the same text again."""
    document = replace(demo_document("orthodiagonal"), title="Dach 'Süd' ^ Ω")
    workshop = Workshop(relief_hole=0.01, labels="both", creases=creases)
    file = written(tmp_path / "pattern.dxf", document, workshop)
    kinds = Counter(entity.dxftype() for entity in file.modelspace())
    assert set(kinds) == {"LINE", "LWPOLYLINE", "CIRCLE", "TEXT"}
    file.saveas(tmp_path / "again.dxf")
    first, second = (
        path.read_text("cp1252").partition("ENTITIES")[2].partition("ENDSEC")[0].splitlines()
        for path in (tmp_path / "pattern.dxf", tmp_path / "again.dxf")
    )
    assert len(first) > 10_000
    assert first == second


def test_a_sheet_larger_than_the_stock_is_a_map_and_numbered_sheets(tmp_path: Path) -> None:
    document = demo_document("orthodiagonal")
    workshop = Workshop(stock=(2.0, 3.0), margin=0.05, spacing=0.02)
    written(tmp_path / "pattern.dxf", document, workshop)
    count = len(draw_sheets(document, workshop))
    assert count > 2
    names = {f"pattern-{number}.dxf" for number in range(1, count)} | {"pattern.dxf"}
    assert {path.name for path in tmp_path.iterdir()} == names
    for name in names:
        assert not ezdxf.readfile(tmp_path / name).audit().errors


def test_a_document_without_a_unit_is_refused_and_no_file_is_left(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="needs a unit of length"):
        write_dxf(tmp_path / "a.dxf", replace(demo_document(), unit="unit"), Settings())
    assert not list(tmp_path.iterdir())


def test_ezdxf_is_left_as_it_was(tmp_path: Path) -> None:
    written(tmp_path / "pattern.dxf", demo_document())
    assert ezdxf.options.write_fixed_meta_data_for_testing is False
