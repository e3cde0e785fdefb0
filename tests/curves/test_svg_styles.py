"""What a style sheet says of an element is what a browser shows; what nobody sees is not read.

What is right of each drawing is by the rules of CSS (cascade, inheritance) and SVG (painting).
"""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest

from orishell.conventions.errors import InputError
from orishell.curves import read_svg
from orishell.curves.svg.styles import MOST_SIBLINGS, is_painted, read_styled
from orishell.io import read_pattern

ARCH = "M0 100 C 50 0 150 0 200 100"
SEEN = f'<path class="seen" d="{ARCH}"/>'
RECTANGLE = '<rect class="other" width="300" height="200" {}/>'


def written(directory: Path, body: str, attributes: str = "") -> Path:
    path = directory / "drawing.svg"
    root = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 300 200" {attributes}>'
    path.write_text(f"{root}{body}</svg>", encoding="utf-8")
    return path


UNSEEN = {
    "an artboard": '<rect style="fill:none" width="300" height="200"/>',
    "a page without a stroke": '<rect width="300" height="200" fill="white"/>',
    "a stroke of no width": '<rect width="300" height="200" stroke="red" stroke-width="0px"/>',
    "an opacity of 0": '<g opacity="0"><rect width="300" height="200" stroke="red"/></g>',
    "a stroke that is not opaque": (
        '<rect width="300" height="200" stroke="red" stroke-opacity="0.0"/>'
    ),
    "a layer by its class": (
        "<style>.hidden{display:none} .line{display:inline;stroke:#000}</style>"
        '<g class="hidden"><path class="line" d="M0 0H9"/></g>'
    ),
    "a layer by its id": '<style>#guides{visibility:hidden}</style><g id="guides">'
    '<path stroke="red" d="M0 0H9"/></g>',
    "an important declaration": "<style>path.b{display:none !important}</style>"
    '<path class="b" style="display:inline" stroke="red" d="M0 0H9"/>',
    "a screen's rule": "<style>@media screen {.b{display:none}}</style>"
    '<path class="b" d="M0 0H9"/>',
    "the first of several": "<style>svg &gt; g path:first-child{display:none}</style>"
    '<g><path stroke="red" d="M0 0H9"/></g>',
}


@pytest.mark.parametrize("name", UNSEEN)
def test_what_nobody_sees_is_no_part_of_the_curve(tmp_path: Path, name: str) -> None:
    stroked = SEEN.replace("/>", ' stroke="#000"/>')
    alone = read_svg(written(tmp_path, stroked), into="mm").joints
    np.testing.assert_array_equal(
        read_svg(written(tmp_path, UNSEEN[name] + stroked), into="mm").joints, alone
    )


SHOWN = {
    "visible within what is not": '<g visibility="hidden"><path stroke="red" visibility="visible" '
    'd="M0 0H9"/></g>',
    "a style beats a sheet": "<style>path{stroke:none}</style>"
    '<path style="stroke:red" d="M0 0H9"/>',
    "a sheet beats an attribute": '<style>path{stroke:red}</style><path stroke="none" d="M0 0H9"/>',
    "the more special selector": "<style>.a path{stroke:red} path{stroke:none}</style>"
    '<g class="a"><path d="M0 0H9"/></g>',
    "a rule for print": '<style>@media print {path{display:none}}</style><path d="M0 0H9"/>',
    "a rule that is none": '<style>path:[{display:none} path{fill:red}</style><path d="M0 0H9"/>',
    "fill alone": '<path fill="red" d="M0 0H9"/>',
}


@pytest.mark.parametrize("name", SHOWN)
def test_what_is_shown_is_read(tmp_path: Path, name: str) -> None:
    joints = read_svg(written(tmp_path, SHOWN[name]), into="mm", unit="mm").joints
    np.testing.assert_array_equal(joints, [[0, 0], [9, 0]])


def test_what_is_chosen_is_read_though_nobody_sees_it(tmp_path: Path) -> None:
    path = written(tmp_path, f'{SEEN}<path id="axis" stroke="none" fill="none" d="M0 0H9"/>')
    assert len(read_svg(path, into="mm", id="axis").joints) == 2


LETTERS = {
    "a class": "<style>.m{stroke:#f00}</style>",
    "an element with a class": "<style>line.m{stroke:red}</style>",
    "within another": "<style>svg g .m{stroke:hsl(0,100%,50%)}</style>",
    "important": "<style>.m{stroke:red!important} line.m{stroke:blue}</style>",
    "an attribute": '<style>line[class="m"]{stroke:rgb(100%,0%,0%)}</style>',
    "a comment": "<style>/* .m{stroke:blue} */ .m{/*red*/stroke:/**/red}</style>",
}


@pytest.mark.parametrize("name", LETTERS)
def test_a_line_has_the_colour_that_a_style_sheet_gives(tmp_path: Path, name: str) -> None:
    square = '<path fill="none" stroke="#000" d="M0 0H10V10H0Z"/>'
    body = f'{LETTERS[name]}{square}<g><line class="m" x2="10" y2="10"/></g>'
    flat = read_pattern(written(tmp_path, body)).flat
    assert flat is not None
    assert flat.letters[flat.crease].tolist() == ["M"]


def test_rules_that_would_take_too_long_are_refused(tmp_path: Path) -> None:
    lines = '<path stroke="red" d="M0 0H9"/>' * (MOST_SIBLINGS + 1)
    rules = "".join(f"path[d='{n}']{{stroke:red}}" for n in range(10_000))
    for body in (f"<style>path:nth-child(2n){{fill:red}}</style>{lines}",
                 f"<style>{rules}</style>{lines}"):  # fmt: skip
        with pytest.raises(InputError, match="style sheets take too long"):
            read_svg(written(tmp_path, body), into="mm")


def test_a_style_that_is_none_is_passed_over(tmp_path: Path) -> None:
    path = written(tmp_path, '<path style=";;stroke:;:x;stroke : red" d="M0 0H9"/>')
    root = read_styled(path)
    assert is_painted("stroke", (root, root.children[0]))
    assert root.children[0].style("stroke") == "red"


@pytest.mark.parametrize(
    "body",
    [
        f"<style>{'@media screen{' * 3000}</style>{SEEN}",
        f"<style>.a{{x:{'(' * 3000}</style>{SEEN}",
        f'<path style="stroke:{"(" * 3000}" d="M0 0H9"/>',
    ],
)
def test_brackets_without_end_are_refused_or_passed_over(tmp_path: Path, body: str) -> None:
    """No other error comes of them, whatever the library makes of them."""
    with suppress(InputError):
        read_svg(written(tmp_path, body), into="mm")
