"""Pages of sphinx-gallery as the site has them: the contents are our own, code is folded away."""

from __future__ import annotations

from typing import TYPE_CHECKING

from docutils import nodes

if TYPE_CHECKING:
    from sphinx.application import Sphinx

THUMBNAILS = '.. raw:: html\n\n    <div class="sphx-glr-thumbnails">'
"""Where sphinx-gallery's own contents begin, behind ours."""
HEAD = '<details class="folded-code"><summary>{title}</summary>'


def own_contents(_app: Sphinx, page: str, source: list[str]) -> None:
    """Leave out the thumbnails of plots that follow our contents of the gallery."""
    if page == "gallery/index":
        source[0] = source[0].partition(THUMBNAILS)[0]


def fold_code(app: Sphinx, tree: nodes.document) -> None:
    """Put each block of an example into a box that opens."""
    if not app.env.docname.startswith("gallery/plot_"):
        return
    for block in list(tree.findall(nodes.literal_block)):
        if block.get("language") != "Python":
            continue
        count = len(block.astext().splitlines())
        title = f"Python, {count} line{'s' * (count > 1)}"
        place = block.parent.index(block)
        block.parent.insert(place + 1, nodes.raw("", "</details>", format="html"))
        block.parent.insert(place, nodes.raw("", HEAD.format(title=title), format="html"))


def setup(app: Sphinx) -> dict[str, bool]:
    """Change pages as they are read."""
    app.connect("source-read", own_contents)
    app.connect("doctree-read", fold_code)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
