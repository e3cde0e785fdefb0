import numpy as np
import pytest
from shapely import MultiPolygon, Point, Polygon, affinity, box
from shapely.strtree import STRtree

from documents import FAMILIES, demo_document
from orishell.document import Document
from orishell.motion.mesh import build_mesh
from orishell.workshop import Text, Workshop
from orishell.workshop.cut_parts import CutPart, whole_sheet
from orishell.workshop.draw import part_labels
from orishell.workshop.fitted_words import CHARACTER
from orishell.workshop.settings import Labels


def outline(text: Text) -> Polygon:
    """The rectangle that a label takes in a program whose letters are wide."""
    half = 0.5 * CHARACTER * len(text.words) * text.height
    flat = box(-half, -0.5 * text.height, half, 0.5 * text.height)
    turned = affinity.rotate(flat, text.angle, origin=(0, 0), use_radians=True)
    return affinity.translate(turned, text.x, text.y)


def panels(document: Document) -> list[Polygon]:
    return [Polygon(corners) for corners in document.require_flat()[document.mesh.faces]]


def labels(document: Document, kind: Labels, part: CutPart | None = None) -> tuple[Text, ...]:
    workshop = Workshop(labels=kind)
    return part_labels(document, part or whole_sheet(document), workshop)


@pytest.mark.parametrize("family", FAMILIES)
def test_every_panel_has_its_row_and_column_inside(family: str) -> None:
    document = demo_document(family)
    found = labels(document, "panels")
    assert {text.layer for text in found} == {"ENGRAVE"}
    assert [text.words for text in found] == [
        document.panel_name(panel) for panel in range(len(document.mesh.faces))
    ]
    for panel, text in zip(panels(document), found, strict=True):
        assert panel.contains(outline(text))


@pytest.mark.parametrize("family", FAMILIES)
def test_every_crease_that_folds_has_its_angle_beside_its_middle(family: str) -> None:
    document = demo_document(family)
    found = labels(document, "creases")
    folding = [k for k, letter in enumerate(document.assignment) if letter in "MV"]
    angles = document.fold_angles_deg[folding]
    assert [text.words for text in found] == [f"{angle:+.1f}°" for angle in angles]
    ends = document.require_flat()[document.mesh.edges[folding]]
    for text, (start, end), letter in zip(
        found, ends, np.array(document.assignment)[folding], strict=True
    ):
        middle, way = (start + end) / 2, end - start
        assert Point(text.x, text.y).distance(Point(middle)) == pytest.approx(text.height)
        assert abs(way @ (text.x - middle[0], text.y - middle[1])) < 1e-9 * (way @ way)
        assert text.words[0] == {"M": "-", "V": "+"}[letter]


@pytest.mark.parametrize("kind", ["creases", "both"])
@pytest.mark.parametrize("family", FAMILIES)
def test_labels_lie_in_one_panel_each_and_do_not_overlap(family: str, kind: Labels) -> None:
    document = demo_document(family)
    shapes = [outline(text) for text in labels(document, kind)]
    tree = STRtree(panels(document))
    assert len({first for first, _ in tree.query(shapes, predicate="within").T}) == len(shapes)
    first, second = STRtree(shapes).query(shapes, predicate="overlaps")
    assert len(first) == len(second) == 0


@pytest.mark.parametrize("family", FAMILIES)
def test_no_label_is_upside_down(family: str) -> None:
    angles = [np.rad2deg(text.angle) for text in labels(demo_document(family), "both")]
    assert min(angles) >= -80 - 1e-9
    assert max(angles) <= 100 + 1e-9


def test_labels_of_a_part_stand_on_it() -> None:
    document = demo_document("orthodiagonal")
    mesh = document.mesh
    chosen = np.arange(20, 40)
    inside = np.isin(mesh.edge_faces, chosen).any(axis=1) & mesh.crease
    part = CutPart(1, chosen, np.flatnonzero(inside), ())
    area = MultiPolygon([panels(document)[k] for k in chosen]).buffer(1e-9)
    found = labels(document, "both", part)
    assert len(found) == len(chosen) + sum(document.assignment[k] in "MV" for k in part.creases)
    assert all(area.contains(outline(text)) for text in found)


def test_a_panel_with_a_reflex_corner_is_labelled_inside() -> None:
    flat = np.array([[0, 0], [10, 2], [0, 4], [2, 2.0]])
    for turn in range(4):
        mesh = build_mesh(np.roll([[0, 1, 2, 3]], turn, axis=1), 4)
        document = Document("dart", "mm", mesh, ("B",) * 4, flat, np.zeros(4), (), None, {})
        (text,) = labels(document, "panels")
        assert text.words == "0"
        assert text.height > 0.2
        assert Polygon(flat).contains(outline(text))


def test_nothing_is_engraved_unless_asked() -> None:
    assert labels(demo_document(), "none") == ()
