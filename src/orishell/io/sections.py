"""Sections of what is said of a subject: made once, written into a page and printed in a terminal.

A terminal leaves out explanations, pictures, and tables that list many things one by one.
"""

from __future__ import annotations

import base64
from collections.abc import Iterable, Iterator, Sequence
from html import escape

from orishell.conventions.quantities import as_typed
from orishell.conventions.record import record
from orishell.conventions.row import MARKS, Sign

GAP = "  "
"""Before the lines of a section in a terminal, and between columns."""


@record
class Paragraph:
    """A paragraph; ``kind`` is a class of the page's style, "soft" that of explanations."""

    text: str
    kind: str = ""

    def html(self) -> str:
        """The paragraph as a page has it."""
        return f"<p{_of(self.kind)}>{escape(self.text)}</p>"

    def lines(self) -> Iterator[str]:
        """Its one line, if it is no explanation."""
        if self.kind != "soft":
            yield as_typed(self.text)


@record
class Bullets:
    """A list of sentences."""

    texts: Sequence[str]

    def html(self) -> str:
        """The list as a page has it; empty without sentences."""
        items = "".join(f"<li>{escape(text)}</li>" for text in self.texts)
        return f"<ul>{items}</ul>" if items else ""

    def lines(self) -> Iterator[str]:
        """A line for each sentence."""
        return (f"- {as_typed(text)}" for text in self.texts)


@record
class Picture:
    """A picture of a page, and what it shows."""

    png: bytes
    text: str

    def html(self) -> str:
        """The picture as a page has it, inside the page."""
        source, text = base64.b64encode(self.png).decode("ascii"), escape(self.text)
        image = f'<img src="data:image/png;base64,{source}" alt="{text}"/>'
        return f'<figure>{image}<figcaption class="soft">{text}</figcaption></figure>'

    def lines(self) -> Iterator[str]:
        """No line."""
        return iter(())


@record
class Table:
    """A table whose rows begin with their names; one of names and values has no ``head``.

    The last ``numbers`` cells of each row are numbers, the last ``totals`` rows are totals. Rows
    may have ``signs``. One that ``lists`` things one by one is for pages only.
    """

    head: Sequence[str]
    rows: Sequence[Sequence[str]]
    caption: str = ""
    numbers: int = 0
    totals: int = 0
    signs: Sequence[Sign] = ()
    lists: bool = False

    def html(self) -> str:
        """The table as a page has it; empty without rows."""
        if not self.rows:
            return ""
        title = f"<caption>{escape(self.caption)}</caption>" if self.caption else ""
        above = f"<thead>{self._row(self.head, 'th', '')}</thead>" if self.head else ""
        plain = len(self.rows) - self.totals
        kinds: Sequence[str] = self.signs or (*plain * [""], *self.totals * ["total"])
        body = "\n".join(map(self._row, self.rows, len(self.rows) * ["td"], kinds))
        return f"<table>{title}{above}<tbody>{body}</tbody></table>"

    def _row(self, cells: Sequence[str], tag: str, kind: str) -> str:
        """A row in HTML, its name as a heading, numbers set to the right."""
        words = len(cells) - self.numbers
        made = "".join(
            f"<{name}{_of('number' if k >= words else '')}>{escape(cell)}</{name}>"
            for k, cell in enumerate(cells)
            for name in (tag if k else "th",)
        )
        return f"<tr{_of(kind)}>{made}</tr>"

    def lines(self) -> Iterator[str]:
        """Its rows in columns: names, numbers, and then words, however long they are."""
        if self.lists or not self.rows:
            return
        rows = [*self.rows]
        if any(self.head):
            rows.insert(0, (self.head[0] or self.caption, *self.head[1:]))
        words = len(rows[0]) - self.numbers
        cells = [
            [as_typed(cell) for cell in (each[0], *each[words:], *each[1:words])] for each in rows
        ]
        marks = [""] * len(rows)
        if self.signs:
            marks = [GAP, *(f"{MARKS[sign]} " for sign in self.signs)]
        widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
        for mark, row in zip(marks, cells, strict=True):
            shown = (
                cell.rjust(width) if 1 <= k <= self.numbers else cell.ljust(width)
                for k, (cell, width) in enumerate(zip(row, widths, strict=True))
            )
            yield mark + GAP.join(shown).rstrip()


Part = Paragraph | Bullets | Picture | Table
"""A piece of a section."""


@record
class Section:
    """What is said of one matter, under its title."""

    title: str
    parts: Sequence[Part]
    level: int = 2  # of its heading, 1 the highest


def sections_html(sections: Iterable[Section]) -> Iterator[str]:
    """Sections as parts of a page; those without content are left out."""
    for section in sections:
        parts = [text for part in section.parts if (text := part.html())]
        if parts and section.title:
            yield f"<h{section.level}>{escape(section.title)}</h{section.level}>"
        yield from parts


def section_lines(sections: Iterable[Section]) -> Iterator[str]:
    """Sections as lines of a terminal, the content of titled ones indented."""
    for section in sections:
        lines = [line for part in section.parts for line in part.lines()]
        if lines and section.title:
            yield section.title
        yield from (f"{GAP if section.title else ''}{line}" for line in lines)


def _of(kind: str) -> str:
    return f' class="{kind}"' if kind else ""
