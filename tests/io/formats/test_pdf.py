"""The paper model, read back with pypdf: pages, scale, register marks, and the same bytes again."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from pathlib import Path
from typing import Any, Literal

import numpy as np
import pytest
from pypdf import PageObject, PdfReader
from pypdf.generic import ContentStream

from documents import FAMILIES, demo_document, folded_only
from orishell.conventions.errors import InputError
from orishell.document import Document
from orishell.io.format import Settings
from orishell.io.formats.pdf import write_pdf
from orishell.workshop import Workshop

MM = 72 / 25.4
A4 = (210 * MM, 297 * MM)
FRAME_LEFT, FRAME_BOTTOM = 10 * MM, 22 * MM
"""Borders of 10 mm, and 12 mm for words at the foot."""

Segment = tuple[tuple[float, float], tuple[float, float]]


def written(path: Path, document: Document, **workshop: Any) -> PdfReader:
    file = path / "pattern.pdf"
    write_pdf(file, document, Settings(workshop=Workshop(**workshop)))
    return PdfReader(file)


def segments(page: PageObject, *, clipped: bool) -> list[Segment]:
    """Straight lines that are drawn: within a clip path (the sheet), or around it."""
    found: list[Segment] = []
    depth, clip, place = [False], False, (0.0, 0.0)
    for operands, operator in ContentStream(page.get_contents(), page.pdf).operations:
        numbers = [float(x) for x in operands if isinstance(x, (int, float))]
        if operator == b"q":
            depth.append(depth[-1])
        elif operator == b"Q":
            depth.pop()
        elif operator in (b"W", b"W*"):
            clip = True
        elif operator == b"n" and clip:
            depth[-1], clip = True, False
        elif operator == b"m":
            place = start = (numbers[0], numbers[1])
        elif operator in (b"l", b"h"):
            end = (numbers[0], numbers[1]) if operator == b"l" else start
            if depth[-1] == clipped:
                found.append((place, end))
            place = end
    return found


def crosses(page: PageObject) -> set[tuple[float, float]]:
    """Middles of register marks: where an upright and a level line of 5 mm halve each other."""
    middles = Counter(
        (round((a[0] + b[0]) / 2, 2), round((a[1] + b[1]) / 2, 2))
        for a, b in segments(page, clipped=False)
        if abs(np.hypot(b[0] - a[0], b[1] - a[1]) - 5 * MM) < 1e-3
    )
    return {middle for middle, count in middles.items() if count == 2}


def place(page: PageObject) -> tuple[int, int]:
    """Row and column, as the page says."""
    words = page.extract_text().split("row ")[1].split()
    return int(words[0].rstrip(",")), int(words[2])


@pytest.mark.parametrize("paper", ["A4", "A3"])
@pytest.mark.parametrize("family", list(FAMILIES))
def test_pages_have_the_size_of_the_paper(tmp_path: Path, family: str, paper: str) -> None:
    reader = written(tmp_path, demo_document(family), paper=paper)
    size = sorted(A4) if paper == "A4" else sorted((297 * MM, 420 * MM))
    for page in reader.pages:
        assert sorted(map(float, page.mediabox[2:])) == pytest.approx(size, abs=1e-3)
    assert 2 <= len(reader.pages) <= 1 + 9


def test_number_of_pages(tmp_path: Path) -> None:
    """4.41 m x 3.86 m at 1:10 are 441 mm x 386 mm. Upright A4 shows 190 mm x 265 mm, of which
    10 mm are shared: 3 x 2 pages; lying 277 mm x 178 mm: 2 x 3 pages. And the first page."""
    document = demo_document("orthodiagonal")
    assert len(written(tmp_path, document, paper_scale=0.1).pages) == 1 + 6
    assert len(written(tmp_path, document, paper_scale=0.04).pages) == 1  # 176 mm x 155 mm
    assert len(written(tmp_path, document).pages) == 1 + 6  # 1:10 is the scale that is chosen


@pytest.mark.parametrize("family", list(FAMILIES))
def test_register_marks_stand_at_the_same_places_of_the_sheet(tmp_path: Path, family: str) -> None:
    """Between pages side by side the sheet moves by the frame less 10 mm: so must their marks."""
    reader = written(tmp_path, demo_document(family))
    pages = {place(page): page for page in reader.pages[1:]}
    width, height = (float(x) for x in reader.pages[0].mediabox[2:])
    step = np.array([width - 20 * MM - 10 * MM, height - 32 * MM - 10 * MM])
    pairs = 0
    for (row, column), page in pages.items():
        for other, shift in (((row, column + 1), (1, 0)), ((row + 1, column), (0, -1))):
            if other not in pages:
                continue
            pairs += 1
            moved = {tuple(p + step * shift) for p in np.array(sorted(crosses(pages[other])))}
            same = [
                p for p in crosses(page) if min(np.hypot(*(np.array(p) - q)) for q in moved) < 0.02
            ]
            assert len(same) >= 4  # the corners of the strip that both show
            along = np.ptp(np.array(same), axis=0)
            assert along.max() >= min(step)
            assert along.min() == pytest.approx(10 * MM, abs=0.02) or len(same) > 4
    assert pairs >= len(pages) - 1


@pytest.mark.parametrize("family", list(FAMILIES))
def test_the_sheet_is_drawn_to_scale(tmp_path: Path, family: str) -> None:
    """Lines of the sheet on a single page are the document's edges times the scale."""
    document = demo_document(family)
    size = float(np.ptp(document.require_flat(), axis=0).max())
    scale = 0.15 / size
    (page,) = written(tmp_path, document, paper_scale=scale).pages
    flat = document.require_flat()
    points = np.array(segments(page, clipped=True)).reshape(-1, 2) / (scale * 1000 * MM)
    assert np.ptp(points, axis=0) == pytest.approx(np.ptp(flat, axis=0), rel=1e-4)
    points += flat.min(axis=0) - points.min(axis=0)
    nearest = np.abs(points[:, None] - flat).max(axis=2).min(axis=1)
    assert nearest.max() < 1e-4 * size


@pytest.mark.parametrize(("unit", "length"), [("m", 1000.0), ("mm", 1.0), ("in", 25.4)])
def test_scale_bar_is_as_long_as_it_says(tmp_path: Path, unit: str, length: float) -> None:
    document = replace(demo_document("orthodiagonal"), unit=unit)
    scale: float | Literal["auto"] = 0.03 if unit == "m" else "auto"
    page = written(tmp_path, document, paper_scale=scale).pages[-1]
    text = page.extract_text()
    bar, said = text.split(" mm on paper")[0].split("\n")[-1].split(" = ")
    if isinstance(scale, float):
        assert float(said) == pytest.approx(float(bar.split()[0]) * length * scale, rel=1e-3)
    lengths = [
        abs(b[0] - a[0])
        for a, b in segments(page, clipped=False)
        if a[1] == b[1] and a[1] < FRAME_BOTTOM
    ]
    assert min(abs(found - float(said) * MM) for found in lengths) < 0.01
    assert "Print at 100 %" in text


def test_neighbouring_pages_draw_the_same_lines_within_the_frame(tmp_path: Path) -> None:
    """Each page has a clip path, exactly its frame."""
    reader = written(tmp_path, demo_document())
    for page in reader.pages[1:]:
        width, height = (float(x) for x in page.mediabox[2:])
        operations = ContentStream(page.get_contents(), page.pdf).operations
        clips = [k for k, (_, operator) in enumerate(operations) if operator in (b"W", b"W*")]
        assert len(clips) == 1
        rectangle = [float(x) for x in operations[clips[0] - 1][0]]
        frame = [FRAME_LEFT, FRAME_BOTTOM, width - 20 * MM, height - 32 * MM]
        assert rectangle == pytest.approx(frame, abs=0.01)


def test_colours_come_from_the_palette_and_dashes_tell_folds_apart(tmp_path: Path) -> None:
    document = demo_document("orthodiagonal")
    for palette, mountain in (("plain", (0xD6, 0x27, 0x28)), ("plotter", (0xFF, 0, 0))):
        (page,) = written(tmp_path, document, paper_scale=0.03, palette=palette).pages
        colour, dashes = None, {}
        for operands, operator in ContentStream(page.get_contents(), page.pdf).operations:
            if operator == b"RG":
                colour = tuple(round(float(x) * 255) for x in operands)
            elif operator == b"d":
                dashes[colour] = len(operands[0])
        assert dashes[mountain] == 4  # dash, gap, dot, gap
        assert 2 in dashes.values()
        assert 0 in dashes.values()


def test_creases_that_do_not_fold_are_explained_where_there_are_some(tmp_path: Path) -> None:
    """On a single page, beside mountains and valleys."""
    document = demo_document("orthodiagonal")
    assert "F" in document.assignment
    letters = ("M" if letter == "F" else letter for letter in document.assignment)
    for drawn, said in ((document, True), (replace(document, assignment=(*letters,)), False)):
        (page,) = written(tmp_path, drawn, paper_scale=0.03).pages
        assert ("not folded" in page.extract_text()) is said
        assert "mountain" in page.extract_text()


def test_labels_are_words_on_the_page(tmp_path: Path) -> None:
    document = demo_document("orthodiagonal")
    (page,) = written(tmp_path, document, paper_scale=0.04, labels="panels").pages
    words = page.extract_text().split()
    names = {document.panel_name(k) for k in range(len(document.mesh.faces))}
    assert names <= set(words)


def test_refusals(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="more than 400 pages") as caught:
        written(tmp_path, demo_document(), paper_scale=1.0)
    assert caught.value.where == "[workshop] paper_scale"
    with pytest.raises(InputError, match="no flat sheet"):
        written(tmp_path, folded_only(demo_document()))
    with pytest.raises(InputError, match="unit of length"):
        written(tmp_path, replace(demo_document(), unit="unit"))
    assert not list(tmp_path.iterdir())


def test_titles_of_any_letters_can_be_printed(tmp_path: Path) -> None:
    reader = written(tmp_path, replace(demo_document(), title="Schale 貝 (Größe \\ 1) " * 9))
    assert "Größe" in reader.pages[0].extract_text()


def test_a_title_is_whole_where_the_bar_leaves_it_room(tmp_path: Path) -> None:
    """As that of a dome's card model, of 43 letters; a longer one ends before the bar."""
    title = "dome: flat-foldable, 11 x 11 inner vertices"
    scaled = {"paper_scale": 0.04}
    (page,) = written(
        tmp_path, replace(demo_document("orthodiagonal"), title=title), **scaled
    ).pages
    assert title in page.extract_text()
    (page,) = written(
        tmp_path, replace(demo_document("orthodiagonal"), title=3 * title), **scaled
    ).pages
    shown = next(line for line in page.extract_text().splitlines() if line.startswith("dome"))
    assert shown.endswith("...")
    assert title in shown
