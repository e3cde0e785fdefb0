"""The booklet: its words, its pages, what is said of a shell, and the same bytes again."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path
from string import Formatter
from typing import Any, get_args
from xml.etree import ElementTree

import numpy as np
import pytest
import shapely
from pypdf import PdfReader

from boarded import boarded_document
from documents import demo_document, folded_only, slit_document
from mechanisms import flat_foldable, random_net
from orishell.conventions.errors import InputError
from orishell.design_file import check_design
from orishell.document import Document, DocumentTie
from orishell.document.from_design import document_of_motion
from orishell.document.ground import GroundFoot, GroundPlan, SweptGround
from orishell.document.measures import BoxReport, Measures
from orishell.io import write_fold
from orishell.io.booklet_drawing import BESIDE, DASHES, dashes_of, width_of
from orishell.io.booklet_pages import FOOT, HIGH, SIDE, WIDE, booklet_pages
from orishell.io.booklet_svg import dump_page
from orishell.io.format import Settings
from orishell.io.formats.booklet import write_booklet
from orishell.motion import FoldingMotion
from orishell.motion.freedom import FreedomOfSheet
from orishell.shell import convert_fold, make_shell
from orishell.workshop import Workshop
from orishell.workshop.kit import words
from orishell.workshop.kit.parts import CutCounts
from orishell.workshop.kit.words import load_words, require_words
from orishell.workshop.settings import Language
from pdf_tools import require_sound

LANGUAGES: tuple[Language, ...] = get_args(Language)
SMALLEST = 8.0
"""Points: what is read at arm's length."""
MOST_BYTES = 3_000_000
TIE = DocumentTie(((0, 2), (6, 2)), 1.2345, slack=True)


def held_document() -> Document:
    """A document of a shell that has a pack, a mass and a tie."""
    document = demo_document()
    box = BoxReport(*np.ptp(document.shell.positions, axis=0).tolist())
    measures = Measures(
        unit="m",
        columns=9,
        starts_packed=True,
        shuts=False,
        deployed=box,
        outside=box,
        packs=((3.0, 2.0, 1.0),),
        layers=12,
        mass=60.0,
        feet=None,
        points=(),
        freedom=FreedomOfSheet(1, 1, None, (), 0, 0.0, None),
    )
    return replace(document, measures=measures, named={"pack": 0, "target": 6}, ties=(TIE,))


FEET = np.array([[0.0, 0.0], [1.0, 0.2], [2.0, 0.0], [0.0, 3.0], [1.0, 3.2], [2.0, 3.0]])
PLAN = GroundPlan(
    corner=(0.0, 0.0),
    feet=tuple(
        GroundFoot(k + 1, (6 * (k // 3), 2 + k % 3), x, y, 0.0)
        for k, (x, y) in enumerate(FEET.tolist())
    ),
    hull=FEET[[0, 2, 5, 3]],
    swept=SweptGround(FEET[[0, 2, 5, 3]], 2.0, 3.0, 6.0, 2.5, 1.0, 0.0, 1.0, 0.01, 9),
)
PIECES = {
    "shell": {"family": "flat-foldable", "unit": "m"},
    "pattern": {"rows": 3, "columns": 4, "sheet": "miura"},
    "panel": {"construction": "hinged", "thickness": 0.02, "pieces": 2, "density": 500},
    "motion": {"frames": 7},
    "deployment": {"from": "pack"},
}


@cache
def pieces_document() -> Document:
    """Whole boards on hinges, folded and carried in two pieces."""
    return make_shell(check_design(PIECES, Path("shell.toml")), skip=["remedies"]).document


def split(**more: Any) -> Workshop:
    return Workshop(stock=(130.0, 130.0), **more)


DOCUMENTS: dict[str, Callable[[], Document]] = {
    "bare": demo_document,
    "held": held_document,
    "slit": slit_document,
    "sandwich": boarded_document,
    "bevel": lambda: boarded_document("bevel"),
    "clipped": lambda: boarded_document(clipped=True),
    "ground": lambda: replace(held_document(), ground=PLAN),
    "pieces": pieces_document,
    "named": lambda: replace(demo_document(), title=f"{'long_' * 20}name: and more"),
}


def text_of(document: Document, workshop: Workshop | None = None) -> str:
    pages = booklet_pages(document, workshop or Workshop())
    return " ".join(said.words for page in pages for said in page.said)


def titles_of(document: Document, workshop: Workshop | None = None) -> list[str]:
    """Titles of steps, with their numbers."""
    pages = booklet_pages(document, workshop or Workshop())
    said = [said.words for page in pages for said in page.said]
    return [words for words in said if re.match(r"\d+  ", words)]


def paths(table: dict[str, Any], before: str = "") -> dict[str, set[str | None]]:
    """Keys of all words, and the names in braces of each."""
    found: dict[str, set[str | None]] = {}
    for key, value in table.items():
        if isinstance(value, dict):
            found |= paths(value, f"{before}{key}.")
        else:
            found[before + key] = {name for _, name, _, _ in Formatter().parse(value)} - {None}
    return found


def test_every_language_says_the_same() -> None:
    folder = Path(words.__file__).parent
    files = {file.name for file in folder.glob("booklet.*.toml")}
    assert files == {f"booklet.{language}.toml" for language in LANGUAGES}
    first = paths(load_words(LANGUAGES[0]).tables)
    for language in LANGUAGES[1:]:
        assert paths(load_words(language).tables) == first


def test_what_a_language_lacks_is_one_message() -> None:
    first = load_words(LANGUAGES[0]).tables
    cover = {key: each for key, each in first["cover"].items() if key != "mass"}
    lacking = {key: each for key, each in (first | {"cover": cover}).items() if key != "check"}
    with pytest.raises(InputError, match=r"booklet.fr.toml: .*got 2 missing: check, cover.mass,"):
        require_words("fr", lacking, first)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", DOCUMENTS)
def test_no_line_crosses_words_and_none_are_small(name: str, language: Language) -> None:
    pages = booklet_pages(DOCUMENTS[name](), Workshop(language=language))
    assert 3 <= len(pages) <= 8
    for page in pages:
        lines = shapely.union_all([shapely.LineString(each.points) for each in page.drawn])
        boxes = []
        for said in page.said:
            assert said.size >= SMALLEST
            wide = width_of(said)
            left = said.x - (wide if said.anchor == "end" else 0)
            # Descenders reach a fifth of the size below the baseline, capitals three quarters up.
            box = shapely.box(
                left, said.y - 0.2 * said.size, left + wide, said.y + 0.75 * said.size
            )
            assert not shapely.intersects(lines, box), said.words
            boxes.append(box)
            assert left >= SIDE - 1
            assert left + wide <= WIDE - SIDE + 1
            assert FOOT / 2 < said.y < HIGH
        first, second = shapely.STRtree(boxes).query(boxes, predicate="overlaps")
        assert len(first) == len(second) == 0


def test_it_says_what_is_known(tmp_path: Path) -> None:
    # Numbers are those of held_document; 60 kg are carried by three with 23 kg each.
    write_booklet(tmp_path / "booklet.pdf", held_document(), Settings())
    pages = [page.extract_text() for page in PdfReader(tmp_path / "booklet.pdf").pages]
    text = " ".join(" ".join(pages).split())
    assert "Packed: 3 x 2 x 1 m, without the thickness of 12 layers" in text
    assert "If each person carries 23 kg, it takes 3." in text
    assert "Ties are 1.234 m long from end to end." in text or "1.235 m long" in text
    titles = re.findall(r"\b\d  ?(Cut and crease|Fold up|Tie|Load|Carry|Open|Anchor)\b", text)
    assert titles == ["Cut and crease", "Fold up", "Tie", "Load", "Carry", "Open"]


def test_ties_that_are_not_proved_slack_are_fixed_once_it_is_open() -> None:
    document = replace(held_document(), ties=(replace(TIE, slack=False),))
    text = " ".join(
        said.words for page in booklet_pages(document, Workshop()) for said in page.said
    )
    titles = re.findall(r"\b\d  (Fold up|Tie|Open)\b", text)
    assert titles == ["Fold up", "Open", "Tie"]
    assert "hang loose" not in text
    assert "Beside the packs: 1 x Ties." in text


@pytest.mark.parametrize("length", [0.3, 1.0, 3.0, 4.0, 6.5, 10.0, 47.0, 500.0])
def test_dashed_lines_have_a_gap_however_short_they_are(length: float) -> None:
    """And end with a dash, so that where they end is seen; those that are long are as usual."""
    dash, gap = dashes_of(np.array([[0.0, 1.0], [0.0, 1.0 + length]]))
    gaps = (length - dash) / (dash + gap)
    assert gaps == pytest.approx(max(round(gaps), 1), abs=0.02)
    assert dash / gap == pytest.approx(DASHES[0] / DASHES[1], rel=0.02)
    assert length < 40 or dash == pytest.approx(DASHES[0], rel=0.1)


def test_what_a_design_does_not_have_is_left_out() -> None:
    pages = booklet_pages(demo_document(), Workshop())
    text = " ".join(said.words for page in pages for said in page.said)
    for word in ("Tie", "Pack", "Carry", "Anchor", "Clip", "Mass", "Screw", "board"):
        assert word not in text
    assert "Fold all creases" in text


def test_the_ground_is_marked_out_before_it_is_opened() -> None:
    # Across corners: the square root of 2^2 + 3^2; the size of the ground is SweptGround's.
    document = DOCUMENTS["ground"]()
    assert titles_of(document)[-2:] == ["6  Mark out", "7  Open"]
    text = text_of(document)
    assert "needs 2 m x 3 m of ground, within the dashed line of that plan, and 2.5 m" in text
    assert "1 - 6: 3.606 m; 3 - 4: 3.606 m" in text


def test_a_booklet_without_a_plan_does_not_speak_of_one(tmp_path: Path) -> None:
    for ground in (True, False):
        write_booklet(tmp_path / "booklet.pdf", DOCUMENTS["ground"](), Settings(ground=ground))
        pages = [page.extract_text() for page in PdfReader(tmp_path / "booklet.pdf").pages]
        assert ("plan of the ground" in " ".join(" ".join(pages).split())) == ground


def test_pieces_are_folded_and_opened_one_by_one() -> None:
    titles = titles_of(pieces_document())
    assert [title.split("  ")[1] for title in titles] == [
        *("Cut", "Lay out", "Hinge", "Fold up", "Load", "Carry", "Open", "Join")
    ]
    text = text_of(pieces_document())
    assert "Fold each piece up by itself" in text
    assert text.count("The picture is of the first of 2 pieces.") == 4
    assert "measures" not in text  # no piece has the size of the whole


@pytest.mark.parametrize(
    ("workshop", "said", "unsaid"),
    [
        (Workshop(), ["Score all creases"], ["Join", "Strips", "All parts"]),
        (Workshop(creases="dashes"), ["bridges between the cuts"], ["Score"]),
        (split(), ["Glue each tab", "numbers 1 to", "All parts"], ["Strips"]),
        (split(joint="strips"), ["Glue each strip", "Strips"], ["Glue each tab"]),
    ],
)
def test_a_sheet_is_cut_and_joined_as_it_is_drawn(
    workshop: Workshop, said: list[str], unsaid: list[str]
) -> None:
    document = replace(boarded_document(), panel=None, boards=None)
    text = text_of(document, workshop)
    assert [words for words in said if words not in text] == []
    assert [words for words in unsaid if words in text] == []
    counts = CutCounts.of(document, workshop)
    assert (counts.strips > 0) == ("Strips" in text)


def test_panels_at_corners_are_named_and_flaps_are_dark() -> None:
    pages = booklet_pages(boarded_document(clipped=True), Workshop())
    names = {said.words for page in pages for said in page.said}
    assert {"0,0", "0,3", "5,0", "5,3"} <= names
    dark = [each for page in pages for each in page.drawn if each.fill == BESIDE]
    panels = sum(len(each.mesh.faces) for each in boarded_document(clipped=True).attached)
    assert len(dark) == 2 * panels  # on the cover, and where they are clipped on


def test_german_has_its_decimal_sign() -> None:
    pages = booklet_pages(held_document(), Workshop(language="de"))
    text = " ".join(said.words for page in pages for said in page.said)
    assert re.search(r"\d\.\d", text) is None
    assert re.search(r"1,23[45] m", text)


@pytest.mark.parametrize("name", ["held", "sandwich"])
def test_the_same_bytes_again_and_other_programs_open_them(name: str, tmp_path: Path) -> None:
    files = [tmp_path / "one.pdf", tmp_path / "other.pdf"]
    for file in files:
        write_booklet(file, DOCUMENTS[name](), Settings())
    content = files[0].read_bytes()
    assert content == files[1].read_bytes()
    assert b"2000" in content  # the time that reportlab writes in place of the clock
    require_sound(files[0])


def test_a_hundred_by_a_hundred_panels(tmp_path: Path) -> None:
    motion = FoldingMotion(flat_foldable(random_net(99, 99, 1)), 3)
    document = document_of_motion(motion, "m", title="many")
    write_booklet(tmp_path / "booklet.pdf", document, Settings())
    assert len(document.mesh.faces) == 10_000
    assert (tmp_path / "booklet.pdf").stat().st_size < MOST_BYTES
    (cover, *_) = PdfReader(tmp_path / "booklet.pdf").pages
    assert "Drawings show one of 3 rows and columns" in cover.extract_text()


def test_a_file_of_another_program_is_refused(tmp_path: Path) -> None:
    write_fold(tmp_path / "shell.fold", demo_document())
    with pytest.raises(
        InputError, match="does not say how it is built, tied and carried"
    ) as caught:
        convert_fold(tmp_path / "shell.fold", tmp_path / "my-booklet.pdf")
    assert "orishell design FILE --out DIRECTORY --write booklet" in str(caught.value)
    assert not (tmp_path / "my-booklet.pdf").exists()


def test_folded_states_alone_are_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no flat sheet"):
        write_booklet(tmp_path / "booklet.pdf", folded_only(demo_document()), Settings())


@pytest.mark.parametrize("name", ["held", "sandwich"])
def test_a_picture_of_a_page_is_the_page_of_the_pdf(name: str, tmp_path: Path) -> None:
    # Read back from both files: words with size and place, and corners of what is drawn.
    document = DOCUMENTS[name]()
    write_booklet(tmp_path / "booklet.pdf", document, Settings())
    pages = PdfReader(tmp_path / "booklet.pdf").pages
    pictures = [dump_page(page) for page in booklet_pages(document, Workshop())]
    assert len(pages) == len(pictures)
    for page, picture in zip(pages, pictures, strict=True):
        root = ElementTree.fromstring(picture)
        svg = "{http://www.w3.org/2000/svg}"
        texts = [*root.iter(f"{svg}text")]
        said = page.extract_text().split("\n")
        assert Counter(text.text for text in texts) == Counter(filter(None, map(str.strip, said)))
        content = page.get_contents()
        assert content is not None
        drawing = content.get_data().decode("latin-1")
        places, size = [], 0.0
        for font, x, y in re.findall(r"/F\d+ ([\d.]+) Tf|([\d.]+) ([\d.]+) Tm", drawing):
            if font:
                size = float(font)
            else:
                places.append((float(x), float(y), size))
        assert [
            (
                float(text.attrib["x"]) - (float(text.attrib["textLength"]) if number else 0.0),
                HIGH - float(text.attrib["y"]),
                float(text.attrib["font-size"]),
            )
            for text in texts
            for number in ["text-anchor" in text.attrib]
        ] == [pytest.approx(place, abs=0.02) for place in places]
        drawn = [path.attrib["d"] for path in root.iter(f"{svg}path")]
        corners = [
            (float(x), HIGH - float(y))
            for each in drawn
            for x, y in re.findall(r"([\d.]+) ([\d.]+)", each)
        ]
        paths = re.findall(r"([\d.]+) ([\d.]+) [ml]\b", drawing)
        assert corners == [pytest.approx(tuple(map(float, each)), abs=0.006) for each in paths]
