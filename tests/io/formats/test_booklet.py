"""The booklet: its words, its pages, what is said of a shell, and the same bytes again."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from string import Formatter
from typing import Any, get_args

import pytest
import shapely
from pypdf import PdfReader

from boarded import boarded_document
from documents import demo_document, folded_only, slit_document
from mechanisms import flat_foldable, random_net
from orishell.conventions.errors import InputError
from orishell.document import Document, DocumentTie
from orishell.document.from_design import document_of_motion
from orishell.io import write_fold
from orishell.io.booklet_drawing import width_of
from orishell.io.booklet_pages import FOOT, HIGH, SIDE, WIDE, booklet_pages
from orishell.io.format import Settings
from orishell.io.formats.booklet import write_booklet
from orishell.motion import FoldingMotion
from orishell.shell import convert_fold
from orishell.workshop import Workshop
from orishell.workshop.kit import words
from orishell.workshop.kit.words import load_words
from orishell.workshop.settings import Language
from pdf_tools import require_sound

LANGUAGES: tuple[Language, ...] = get_args(Language)
SMALLEST = 8.0
"""Points: what is read at arm's length."""
MOST_BYTES = 3_000_000
HELD = {
    "unit": "m",
    "columns": 9,
    "deployment": {
        "start": "pack",
        "packed": {"length": 3.0, "width": 2.0, "height": 1.0, "layers": 12},
    },
    "quantities": {"mass_kg": 60.0},
}
"""As report.json has it: a pack and a mass."""
TIE = DocumentTie(((0, 2), (6, 2)), 1.2345, slack=True)


def held_document() -> Document:
    document = demo_document()
    return replace(document, report=HELD, named={"pack": 0, "target": 6}, ties=(TIE,))


DOCUMENTS: dict[str, Callable[[], Document]] = {
    "bare": demo_document,
    "held": held_document,
    "slit": slit_document,
    "sandwich": boarded_document,
    "bevel": lambda: boarded_document("bevel"),
    "clipped": lambda: boarded_document(clipped=True),
}


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
    # Numbers are those of HELD; 60 kg are carried by three with 23 kg each.
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


def test_what_a_design_does_not_have_is_left_out() -> None:
    pages = booklet_pages(demo_document(), Workshop())
    text = " ".join(said.words for page in pages for said in page.said)
    for word in ("Tie", "Pack", "Carry", "Anchor", "Clip", "Mass", "Screw", "board"):
        assert word not in text
    assert "Fold all creases" in text


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
