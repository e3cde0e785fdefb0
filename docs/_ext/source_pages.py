"""The contents beside a page, which take a third of the time of a build as they come.

Sphinx copies the names of all objects of all pages for each page, and leaves them out then where
only titles are shown; here they are left out once. Pages of sources differ by their depth only, so
the first of a depth has the contents of all.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from docutils import nodes
from sphinx import addnodes

if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from sphinx.application import Sphinx

SOURCES = "_modules/"

_contents: dict[tuple[int, tuple[tuple[str, Any], ...]], str] = {}
"""Of this build, by the depth of a page and what its theme asks for."""
_titles: dict[str, nodes.bullet_list] = {}
"""Of this build, by page: its entry without what is in the page."""


def share_contents(
    app: Sphinx, page: str, _template: str, context: dict[str, Any], _document: object
) -> None:
    """Let a page find its contents among titles; let sources take those of the first of a depth."""
    resolve = context["toctree"]

    def contents(**options: Any) -> str:
        if not options.get("titles_only"):
            return str(resolve(**options))
        key = page.count("/"), tuple(sorted(options.items()))
        if page.startswith(SOURCES) and key in _contents:
            return _contents[key]
        found = among_titles(app, lambda: str(resolve(**options)))
        if page.startswith(SOURCES):
            _contents[key] = found
        return found

    context["toctree"] = contents


def among_titles(app: Sphinx, resolve: Callable[[], str]) -> str:
    """What is found while entries of pages are their titles, and what pages follow them."""
    whole = app.env.tocs
    if not _titles:
        _titles.update({page: title_of(entry) for page, entry in whole.items()})
    app.env.tocs = _titles
    try:
        return resolve()
    finally:
        app.env.tocs = whole


def title_of(entry: nodes.bullet_list) -> nodes.bullet_list:
    """An entry without the objects and headings of its page."""
    short = entry.copy()
    for item in entry.children:
        if isinstance(item, nodes.list_item) and not any(item.findall(addnodes.toctree)):
            kept = item.copy()
            kept += item[0].deepcopy()
            short += kept
        else:
            short += item.deepcopy()
    return short


def setup(app: Sphinx) -> dict[str, bool]:
    """Come before the theme, which asks for the contents of every page."""
    app.connect("html-page-context", share_contents, priority=400)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
