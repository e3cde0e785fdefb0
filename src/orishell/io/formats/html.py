"""A page that shows the shell: one file that needs no network and no other file."""

from __future__ import annotations

import base64
from html import escape
from importlib.resources import files
from pathlib import Path

from orishell.document import Document
from orishell.errors import InputError
from orishell.io.format import Format
from orishell.io.settings import Settings
from orishell.io.static_page import content_digest
from orishell.io.view import dump_view

VIEWER = files("orishell.io").joinpath("pages", "viewer.js")
"""The viewer, once it is built."""

NOT_BUILT = "the viewer has not been built"

BUILD_PAGES = (
    "install a wheel of orishell that has the pages; in its sources, `npm run pages` in "
    "frontend/ builds them (Node.js 18 or newer)"
)
"""What to do where the pages of the studio and the viewer are missing."""

_STYLE = """
html, body { margin: 0; height: 100%; background: #f5f3ee; }
@media (prefers-color-scheme: dark) { html, body { background: #14171b; } }
main { height: 100%; }
noscript { display: block; padding: 3em; font: 16px/1.5 system-ui, sans-serif; }
"""

_PAGE = """\
<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<title>{title}</title>
<style>{style}</style>
</head>
<body>
<noscript>{title}: this page draws the shell with JavaScript, which is turned off here.</noscript>
<script type="application/octet-stream" id="orishell-view">{view}</script>
<script type="module">{script}</script>
</body>
</html>
"""


def write_html(path: Path, document: Document, settings: Settings) -> None:
    """Write the viewer with the shell in it: motion, pattern and figures.

    Raises
    ------
    InputError
        If the viewer has not been built.
    """
    script = _inside_script(read_viewer())
    # Only this script and this style run, and nothing is loaded: the page cannot send anything.
    policy = (
        f"default-src 'none'; script-src '{content_digest(script)}'; "
        f"style-src '{content_digest(_STYLE)}'; base-uri 'none'; form-action 'none'"
    )
    page = _PAGE.format(
        policy=policy,
        title=escape(document.title),
        style=_STYLE,
        view=base64.b64encode(dump_view(document)).decode("ascii"),
        script=script,
    )
    path.write_text(page, encoding="utf-8", newline="\n")


def viewer_is_built() -> bool:
    """Whether the viewer has been built, so that pages can be written."""
    return VIEWER.is_file()


def read_viewer() -> str:
    """The viewer's program, one JavaScript module without imports.

    Raises
    ------
    InputError
        If it has not been built.
    """
    if not viewer_is_built():
        raise InputError(
            NOT_BUILT,
            remedy=BUILD_PAGES,
        )
    return VIEWER.read_text(encoding="utf-8")


def _inside_script(program: str) -> str:
    r"""A program as it may stand in a page: ``</`` and ``<!--`` occur in its strings only."""
    return program.replace("</", "<\\/").replace("<!--", "<\\!--")


FORMAT = Format(
    "html",
    "viewer.html",
    (".html",),
    "a page that shows the motion, in one file",
    write_html,
    lays_surface=True,
    ready=viewer_is_built,
    missing=NOT_BUILT,
    remedy=BUILD_PAGES,
)
