"""A page that shows the shell: one file that needs no network and no other file."""

from __future__ import annotations

import base64
from pathlib import Path

from orishell.document import Document
from orishell.io.format import Format, Settings
from orishell.io.html_pages import BUILD_PAGES, place_of, program_page, read_program
from orishell.io.view import dump_view

VIEWER = place_of("viewer.js")
"""The viewer, once it is built."""

NOT_BUILT = "the viewer has not been built"


def write_html(path: Path, document: Document, settings: Settings) -> None:
    """Write the viewer with the shell in it: motion, pattern and figures."""
    page = program_page(
        read_viewer(),
        title=document.title,
        what="the shell",
        name="orishell-view",
        data=base64.b64encode(dump_view(document)).decode("ascii"),
        kind="application/octet-stream",
    )
    path.write_text(page, encoding="utf-8", newline="\n")


def viewer_is_built() -> bool:
    """Whether the viewer has been built, so that pages can be written."""
    return VIEWER.is_file()


def read_viewer() -> str:
    """The viewer's program, one JavaScript module without imports, if it has been built."""
    return read_program(VIEWER, NOT_BUILT)


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
