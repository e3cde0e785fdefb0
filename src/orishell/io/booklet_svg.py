"""A page of the booklet as a picture: SVG of what the PDF has, at the same places and sizes.

Lengths are points. Lines of words are as wide as in the PDF, whatever letters a browser has.
"""

from __future__ import annotations

from html import escape

from orishell.io.booklet_drawing import Drawn, Said, dashes_of, width_of
from orishell.io.booklet_pages import HIGH, THIN, TIE, WIDE, BookletPage
from orishell.io.format import plain_line

FONT = "Helvetica, Arial, sans-serif"


def dump_page(page: BookletPage) -> str:
    """The text of an SVG file: black on a page without a colour of its own, for white paper."""
    return "\n".join(
        (
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDE}pt" height="{HIGH}pt"'
            f' viewBox="0 0 {WIDE} {HIGH}">',
            f'<g fill="none" stroke="#000" stroke-width="{THIN}" stroke-linejoin="round">',
            *map(_line, page.drawn),
            "</g>",
            f'<g font-family="{FONT}">',
            *map(_words, page.said),
            "</g>",
            "</svg>",
            "",
        )
    )


def _line(each: Drawn) -> str:
    places = "L".join(f"{_number(x)} {_number(HIGH - y)}" for x, y in each.points.tolist())
    look = ""
    if each.fill is not None:
        grey = f"{round(255 * each.fill):02x}"
        look += f' fill="#{3 * grey}"'
    if each.dashed or each.thick:
        look += f' stroke-width="{TIE}"'
    if each.dashed:
        dash, gap = dashes_of(each.points)
        look += f' stroke-dasharray="{dash:g} {gap:g}"'
    return f'<path d="M{places}{"Z" if each.closed else ""}"{look}/>'


def _words(said: Said) -> str:
    look = ' font-weight="bold"' if said.bold else ""
    if said.anchor != "start":
        look += f' text-anchor="{said.anchor}"'
    return (
        f'<text x="{_number(said.x)}" y="{_number(HIGH - said.y)}" font-size="{said.size:g}"'
        f' textLength="{_number(width_of(said))}" lengthAdjust="spacingAndGlyphs"{look}>'
        f"{escape(plain_line(said.words), quote=False)}</text>"
    )


def _number(value: float) -> str:
    return f"{value:.2f}".rstrip("0").rstrip(".")
