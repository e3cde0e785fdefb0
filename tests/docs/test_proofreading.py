"""What people read is spelled, and its tables are whole; `make docs` asks the same."""

from __future__ import annotations

from pathlib import Path

import pytest
from proofreading import english, faults, prose, uneven, unknown
from spylls.hunspell import Dictionary

# Lines as they once stood in the guide.
DAMAGED = {
    "the plane square to gest angle of such a plane from the plane square to g": "“gest”",
    "of the sheet, clipped flaps includedh it": "“includedh”",
    "the the plane": "“the” stands twice",
}


def test_pages_and_what_the_program_says_are_spelled() -> None:
    assert not (found := list(faults())), "\n".join(found)


@pytest.fixture(scope="module")
def dictionary() -> Dictionary:
    return english()


@pytest.mark.parametrize("line", DAMAGED)
def test_a_damaged_line_is_seen(dictionary: Dictionary, line: str) -> None:
    ((number, wrong),) = unknown(f"One line.\n{line}", {"flaps"}, dictionary)
    assert number == 2
    assert wrong.startswith(DAMAGED[line])


def test_words_are_those_of_the_list_and_of_sentences(dictionary: Dictionary) -> None:
    text = "Orthodiagonal sheets don't need the author's colour; length², α₁, x2 and a_b are none."
    assert [wrong[:16] for _, wrong in unknown(text, {"orthodiagonal"}, dictionary)] == [
        "“colour” is no w"
    ]


def test_a_row_of_a_table_that_is_not_whole_is_seen() -> None:
    table = "| a | b |\n|---|---|\n| 1 | 2 |\n| 1 | `x\\|y` |\n"
    assert list(uneven(table)) == []
    assert list(uneven(f"{table}| a | b | c |\n")) == [(5, "3 cells in a table of 2")]
    assert list(uneven(f"{table}\n| other |\n|---|\n")) == []


def test_what_is_no_prose_is_not_read(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text(
        "A [word](lnik.md) and `cdoe`, $fromula$.\n```sh\nmkae\n```\n{doc}`gudie`\nEnd.\n"
    )
    assert prose(page).split() == ["A", "[word", "and", ",", ".", "End."]
    script = tmp_path / "plot.py"
    script.write_text('"""\nTitle\n"""\nimport nupmy\n# Text of ``cdoe``.\n')
    assert prose(script).split() == ['"""', "Title", '"""', "Text", "of", "."]
    words = tmp_path / "words.toml"
    words.write_text('# cmment\n[tables.xyzzy]\nlabel = "Sheets of {cuont}"\n')
    assert prose(words).split() == ["Sheets", "of"]
