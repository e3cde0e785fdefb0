"""Shells that a reader of the site turns and folds: the directive ``live`` and its pages.

``.. live:: canopy`` shows a picture of ``examples/canopy.toml``'s shell; a click puts the viewer in
its place, from ``live/canopy.html``. Every shell has such a page; where the design file asks for a
grid of variants it has sliders for them. All share one program, so that they hold hardly more than
the shells' views. ``.. cards::`` shows pictures that lead to other pages. The pictures are those of
docs/posters, which ``tests/posters.py`` takes of the viewer.
"""

from __future__ import annotations

import base64
import os
import re
import shutil
from dataclasses import fields
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar

from docutils import nodes
from docutils.parsers.rst import directives
from kept import kept, kept_shell
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxDirective

from orishell import search
from orishell.conventions.toml_file import read_toml
from orishell.design_file import DesignFile, read_design_file
from orishell.io.formats.html import read_viewer, viewer_is_built
from orishell.io.view import dump_view
from orishell.search import (
    SearchResult,
    alone,
    journal_in_memory,
    read_problem,
    search_designs,
)
from orishell.search.variants import variants_data
from orishell.shell import make
from orishell.shell.make import Shell
from orishell.shell.pictures import lay_surface
from orishell.shell.steps import MEASURES

if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from sphinx.application import Sphinx

    from orishell.search import Journal, Problem, WorkerPool

HERE = Path(__file__).parent
EXAMPLES = HERE.parents[1] / "examples"
PARTS = HERE / "live"
"""What the pages are made of."""
FOLDER = "live"
"""Where they stand in the site."""
NOT_BUILT = "the site folds its shells in the viewer, which has not been built: make pages"

POSTERS = HERE.parent / "posters"
"""Their pictures, for light pages and for dark ones."""

BRIEFLY = os.environ.get("ORISHELL_BRIEFLY") == "1"
"""Whether the gallery leaves out what takes long, and shells that it did not make have no proof:
for those who look at the site's other pages."""
LONG = (
    *("arch_pattern", "dome", "free_roof", "saddle"),
    *("shelter_boxes", "shelter_gussets", "shelter_sizes", "shelter_snow", "shelter_structure"),
)
"""Examples that take more than 10 s: three quarters of the gallery's time."""

_made: dict[str, Shell] = {}
"""Whole shells that the gallery's scripts made, by the names of their design files."""


class Live(SphinxDirective):
    """A shell to turn and fold, with a caption or without; ``:at-once:`` waits for no click."""

    required_arguments = 1
    has_content = True
    option_spec: ClassVar[dict[str, Callable[[str], Any]] | None] = {"at-once": directives.flag}

    def run(self) -> list[nodes.Node]:
        """Make the page's part."""
        name = self.arguments[0]
        if not (EXAMPLES / f"{name}.toml").is_file():
            raise self.error(f"there is no examples/{name}.toml")
        place = "../" * self.env.docname.count("/") + f"{FOLDER}/{name}"
        words = {
            "place": escape(place),
            "name": escape(name.replace("_", " ")),
            "when": "at-once" if "at-once" in self.options else "asked",
            "what": "Turn and fold it",
            "kind": "",
        }
        if asks_for_variants(EXAMPLES / f"{name}.toml"):
            words |= {"what": "Move its sliders", "kind": " live-variants"}
        caption = self.parse_content_to_nodes() if self.content else []
        head, tail = (PARTS / "figure.html").read_text("utf-8").split("{caption}")
        return [
            nodes.raw("", head.format(**words), format="html"),
            *caption,
            nodes.raw("", tail.format(**words), format="html"),
        ]


class Cards(SphinxDirective):
    """Pictures that lead to pages, a line for each: page | shell | title | words."""

    has_content = True

    def run(self) -> list[nodes.Node]:
        """Make the page's part."""
        up = "../" * self.env.docname.count("/")
        card = (PARTS / "card.html").read_text("utf-8")
        cards = []
        for line in self.content:
            page, name, title, words = (escape(part.strip()) for part in line.split("|"))
            cards.append(
                card.format(
                    page=f"{up}{page}.html", place=f"{up}{FOLDER}/{name}", title=title, words=words
                )
            )
        return [nodes.raw("", f'<ul class="cards">{"".join(cards)}</ul>', format="html")]


def keep_shells(_block: object, block_vars: dict[str, Any], _conf: object) -> str:
    """Keep what a script of the gallery made of a design file, so that it is made once."""
    for thing in block_vars["example_globals"].values():
        if isinstance(thing, Shell) and _is_whole(thing):
            _made[thing.file.path.stem] = thing
    return ""


def draw_from_kept(_config: dict[str, Any], _script: str) -> None:
    """Scripts of the gallery that make a shell or search have what was made of the same files."""
    vars(make)["make_shell"] = kept_shell
    vars(search)["search_designs"] = _searched_as


def _searched_as(problem: Problem, pool: WorkerPool, journal: Journal) -> SearchResult:
    """What is kept of a search, but of one whose journal knows its variants."""
    return search_designs(problem, pool, journal) if len(journal) else _searched(problem.path)


@kept
def _searched(path: Path) -> SearchResult:
    """All variants of a design file's grid."""
    with alone() as pool:
        return search_designs(read_problem(path), pool, journal_in_memory())


def _is_whole(shell: Shell) -> bool:
    """Whether it is all that its design file asks for, and of nothing else."""
    if shell.deviation is None and shell.analysis is None and shell.design.swept is not None:
        return False
    file = shell.file
    asked = read_design_file(file.path)
    named = {each.name for each in fields(DesignFile)} - {"target"}  # curves have no equality
    return all(getattr(file, name) == getattr(asked, name) for name in named)


def require_viewer(app: Sphinx) -> None:
    """Say at the beginning what a site with shells needs."""
    if app.builder.format == "html" and not viewer_is_built():
        raise ExtensionError(NOT_BUILT)


def write_pages(app: Sphinx, fault: Exception | None) -> None:
    """Write the page of every example with its pictures, and the program that the pages share."""
    if fault or app.builder.format != "html":
        return
    place = Path(app.outdir) / FOLDER
    place.mkdir(exist_ok=True)
    (place / "viewer.js").write_text(shared_program(read_viewer()), encoding="utf-8", newline="\n")
    (place / "page.css").write_bytes((PARTS / "page.css").read_bytes())
    for picture in POSTERS.glob("*.webp"):
        shutil.copy(picture, place)
    for path in sorted(EXAMPLES.glob("*.toml")):
        text = variants_page(path) if asks_for_variants(path) else page(path)
        (place / f"{path.stem}.html").write_text(text, encoding="utf-8", newline="\n")


def shared_program(viewer: str) -> str:
    """The viewer as a script of its own, which pages opened from disk may load: no module may be.

    Raises
    ------
    ExtensionError
        If the viewer does not end with what it exports.
    """
    body, found = re.subn(r"export\s*\{[^{}]*\};?\s*$", "", viewer)
    if not found:
        raise ExtensionError("the viewer is no module that ends with its exports")
    own = (PARTS / "page.js").read_text("utf-8")
    return f'(() => {{\n"use strict";\n{body}\n{own}}})();\n'


def page(path: Path) -> str:
    """A page with a shell's view, which draws it with the program beside it."""
    shell = _made.get(path.stem) or _made_of(path)
    document = lay_surface(shell.document, shell.design)
    view = base64.b64encode(dump_view(document)).decode("ascii")
    return _written(document.title, "view", "application/octet-stream", view)


def _made_of(path: Path) -> Shell:
    file = read_design_file(path)
    if BRIEFLY:
        return kept_shell(file, clash="unexamined", skip=(*MEASURES, "structure"))
    return kept_shell(file)


def asks_for_variants(path: Path) -> bool:
    """Whether a design file asks for all variants of a grid, to be shown with sliders."""
    return read_toml(path).get("search", {}).get("method") == "grid"


def variants_page(path: Path) -> str:
    """A page with the variants of a design, as ``orishell search --write html`` makes them."""
    with alone() as pool:
        data = variants_data(read_problem(path), _searched(path), pool)
    return _written(path.stem, "variants", "application/json", data.replace("<", "\\u003c"))


def _written(title: str, name: str, kind: str, data: str) -> str:
    head, tail = (PARTS / "page.html").read_text("utf-8").split("{data}")
    words = {"title": escape(title), "name": name, "kind": kind}
    return head.format(**words) + data + tail


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directives, and write the pages of shells when the others are."""
    app.add_directive("live", Live)
    app.add_directive("cards", Cards)
    app.add_css_file("live.css")
    app.add_js_file("live.js", loading_method="defer")
    app.connect("builder-inited", require_viewer, priority=100)
    app.connect("build-finished", write_pages)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
