"""Shells that a reader of the site turns and folds: the directive ``live`` and its pages.

``.. live:: canopy`` shows a picture of ``examples/canopy.toml``'s shell; a click puts the viewer in
its place, from ``live/canopy.html``. Every shell has such a page. All share one program, so that
they hold hardly more than the shell's view.
"""

from __future__ import annotations

import base64
import re
import sys
from dataclasses import fields
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxDirective

from orishell.design_file import DesignFile, read_design_file
from orishell.io.formats.html import read_viewer, viewer_is_built
from orishell.io.view import dump_view
from orishell.shell.make import Shell, make_shell
from orishell.shell.pictures import lay_surface

if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from sphinx.application import Sphinx

HERE = Path(__file__).parent
EXAMPLES = HERE.parents[1] / "examples"
PARTS = HERE / "live"
"""What the pages are made of."""
FOLDER = "live"
"""Where they stand in the site."""
NOT_BUILT = "the site folds its shells in the viewer, which has not been built: make pages"

POSTER = (11.0, 6.875)
"""Size of a picture (inches), as wide to high as its place on a page."""
DPI, QUALITY = 100, 82
TURN, HEIGHT = -0.52, 0.5
"""From where the viewer looks first: about the longer side of the plan, and up (radians)."""
DRAWN = 0.995
"""Share of the drive at the target that is drawn: at 1 flaps lie in one plane with panels."""

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
        }
        caption = self.parse_content_to_nodes() if self.content else []
        head, tail = (PARTS / "figure.html").read_text("utf-8").split("{caption}")
        return [
            nodes.raw("", head.format(**words), format="html"),
            *caption,
            nodes.raw("", tail.format(**words), format="html"),
        ]


def keep_shells(_block: object, block_vars: dict[str, Any], _conf: object) -> str:
    """Keep what a script of the gallery made of a design file, so that it is made once."""
    for thing in block_vars["example_globals"].values():
        if isinstance(thing, Shell) and _is_whole(thing):
            _made[thing.file.path.stem] = thing
    return ""


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
    """Write the page and the picture of every example, and the program that the pages share."""
    if fault or app.builder.format != "html":
        return
    place = Path(app.outdir) / FOLDER
    place.mkdir(exist_ok=True)
    (place / "viewer.js").write_text(shared_program(read_viewer()), encoding="utf-8", newline="\n")
    (place / "page.css").write_bytes((PARTS / "page.css").read_bytes())
    for path in sorted(EXAMPLES.glob("*.toml")):
        shell = _made.get(path.stem) or make_shell(read_design_file(path))
        (place / f"{path.stem}.html").write_text(page(shell), encoding="utf-8", newline="\n")
        draw_poster(place / f"{path.stem}.webp", shell)


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


def page(shell: Shell) -> str:
    """A page with a shell's view, which draws it with the program beside it."""
    document = lay_surface(shell.document, shell.design)
    view = base64.b64encode(dump_view(document)).decode("ascii")
    return (PARTS / "page.html").read_text("utf-8").format(title=escape(document.title), view=view)


def draw_poster(path: Path, shell: Shell) -> None:
    """Draw a shell at its target, about as the viewer shows it first."""
    import numpy as np
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure
    from PIL import Image

    sys.path.insert(0, str(EXAMPLES / "gallery"))
    from drawing import draw_shell

    from orishell.plot.scene import Camera

    sheet = shell.design.mechanism
    positions = sheet.positions(DRAWN * sheet.target_drive)
    plan = positions[..., :2].reshape(-1, 2)
    along = np.linalg.svd(plan - plan.mean(axis=0), full_matrices=False)[2][0]
    azimuth = float(np.arctan(along[1] / along[0])) - np.pi / 2 + TURN
    figure = Figure(figsize=POSTER, dpi=DPI)
    canvas = FigureCanvasAgg(figure)
    axes = figure.add_axes((0.07, 0.16, 0.86, 0.74))
    draw_shell(axes, positions, Camera(azimuth, HEIGHT), line=0.7)
    figure.patch.set_alpha(0.0)
    canvas.draw()
    Image.fromarray(np.asarray(canvas.buffer_rgba())).save(path, quality=QUALITY)


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directive, and write its pages when the others are."""
    app.add_directive("live", Live)
    app.add_css_file("live.css")
    app.add_js_file("live.js", loading_method="defer")
    app.connect("builder-inited", require_viewer, priority=100)
    app.connect("build-finished", write_pages)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
