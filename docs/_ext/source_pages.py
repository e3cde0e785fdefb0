"""The contents beside pages of sources, which differ by the depth of a page only.

They are made once for each depth. For each page they took a sixth of the time of a build.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from typing import Any

    from sphinx.application import Sphinx

SOURCES = "_modules/"

_contents: dict[tuple[int, tuple[tuple[str, Any], ...]], str] = {}
"""Of this build, by the depth of a page and what its theme asks for."""


def share_contents(
    _app: Sphinx, page: str, _template: str, context: dict[str, Any], _document: object
) -> None:
    """Let a page of sources take the contents of the first of its depth."""
    if not page.startswith(SOURCES):
        return
    resolve = context["toctree"]

    def contents(**options: Any) -> str:
        key = page.count("/"), tuple(sorted(options.items()))
        if key not in _contents:
            _contents[key] = resolve(**options)
        return _contents[key]

    context["toctree"] = contents


def setup(app: Sphinx) -> dict[str, bool]:
    """Come before the theme, which asks for the contents of every page."""
    app.connect("html-page-context", share_contents, priority=400)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
