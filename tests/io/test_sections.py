"""Sections: one content, as parts of a page and as lines of a terminal."""

from __future__ import annotations

import pytest

from orishell.conventions.quantities import as_typed, figure
from orishell.io.sections import (
    Bullets,
    Paragraph,
    Picture,
    Section,
    Table,
    section_lines,
    sections_html,
)

LOADS = Table(
    ("", "how", "force (N)"),
    [("snow", "on plan areas", figure(-12e3)), ("wind", "along x", figure(7.5))],
    caption="storm",
    numbers=1,
)


def test_a_terminal_has_columns_numbers_before_words() -> None:
    """The caption stands where the head names nothing."""
    assert list(section_lines([Section("Loads", (LOADS,))])) == [
        "Loads",
        "  storm  force (N)  how",
        "  snow      -12000  on plan areas",
        "  wind         7.5  along x",
    ]


def test_signs_stand_before_rows() -> None:
    table = Table(("case", "carries"), [("a", "no"), ("b", "yes")], signs=("fails", "holds"))
    assert list(table.lines()) == ["  case  carries", "x a     no", "v b     yes"]
    assert table.html().count('<tr class="') == 2


def test_explanations_lists_and_pictures_are_for_pages() -> None:
    parts = (
        Paragraph("why", "soft"),
        Paragraph("what"),
        Picture(b"png", "seen"),
        Table(("foot",), [("1",), ("2",)], lists=True),
        Bullets(("first", "second")),
    )
    section = Section("Title", parts)
    assert list(section_lines([section])) == ["Title", "  what", "  - first", "  - second"]
    page = "".join(sections_html([section]))
    assert [page.count(f"<{tag}") for tag in ("h2", "p ", "p>", "img", "tr", "li")] == [
        1, 1, 1, 1, 3, 2
    ]  # fmt: skip


def test_what_has_no_content_has_no_title() -> None:
    empty = Section("Title", (Bullets(()), Table((), [])))
    assert not list(sections_html([empty]))
    assert not list(section_lines([empty]))


@pytest.mark.parametrize(
    ("value", "text"), [(-1.5, "-1.5"), (123456, "123500"), (1e-12, "1e-12"), (2.7e8, "2.7e8")]
)
def test_figures_of_pages_are_typed_as_numbers(value: float, text: str) -> None:
    assert as_typed(figure(value)) == text
    assert float(as_typed(figure(value))) == float(text)
