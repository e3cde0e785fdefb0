"""SVG as Origami Simulator reads it: one line for each edge, its colour the assignment.

Its importer takes lines that stand directly in the file, told apart by stroke: border black,
mountain red, valley blue, cut green, ``facet`` yellow (a crease that stays flat), hinge magenta (a
crease that nothing drives). The fold angle is 180 degrees times the opacity. Vertices nearer to
each other than 3 px are merged.
"""

from __future__ import annotations

from html import escape
from pathlib import Path
from typing import Final

import numpy as np

from orishell.document import Document
from orishell.io.format import Format, Settings, plain_line

STROKES: Final[dict[str, str]] = {
    "B": "#000000",
    "M": "#ff0000",
    "V": "#0000ff",
    "C": "#00ff00",
    "F": "#ffff00",
    "J": "#ffff00",
    "U": "#ff00ff",
}
"""Stroke of every assignment."""

NOTHING = 1e-4
"""Edges shorter than this share of the sheet are merged all the same."""

WIDTH, APART, BORDER = 600.0, 12.0, 20.0
"""The sheet's longer side, the least length of its shortest edge, and the page's margin (px)."""


def write_origami_simulator(path: Path, document: Document, settings: Settings) -> None:
    """Write the flat sheet with the fold angles of the last state.

    The sheet is :data:`WIDTH` large, or larger so that its vertices stay apart. Creases whose angle
    is not known have no opacity, which Origami Simulator takes for 180 degrees.
    """
    del settings
    flat, mesh = document.require_flat(), document.mesh
    beside = (mesh.edge_faces >= 0).any(axis=1)
    ends = flat[mesh.edges]
    used = ends[beside].reshape(-1, 2)
    low, size = used.min(axis=0), np.ptp(used, axis=0)
    longest = float(size.max())
    lengths = np.hypot(*(ends[beside, 1] - ends[beside, 0]).T)
    scale = max(WIDTH, APART * longest / max(float(lengths.min()), NOTHING * longest)) / longest
    x = BORDER + scale * (ends[..., 0] - low[0])
    y = BORDER + scale * (low[1] + size[1] - ends[..., 1])
    page = 2 * BORDER + scale * size
    opacity = np.minimum(np.abs(document.fold_angles_deg) / 180, 1.0)
    with path.open("w", encoding="utf-8", newline="\n") as file:
        file.write(
            '<svg xmlns="http://www.w3.org/2000/svg" version="1.1"'
            f' width="{page[0]:.6g}" height="{page[1]:.6g}"'
            f' viewBox="0 0 {page[0]:.6g} {page[1]:.6g}">\n'
            f"<title>{escape(plain_line(document.title), quote=False)}</title>\n"
        )
        for edge in np.flatnonzero(beside).tolist():
            (x1, x2), (y1, y2) = x[edge], y[edge]
            file.write(
                f'<line x1="{x1:.9g}" y1="{y1:.9g}" x2="{x2:.9g}" y2="{y2:.9g}"'
                f' stroke="{STROKES[document.assignment[edge]]}"'
                f"{_opacity(document.assignment[edge], float(opacity[edge]))} />\n"
            )
        file.write("</svg>\n")


def _opacity(letter: str, opacity: float) -> str:
    """The attribute that carries a fold angle; none for edges that are not folded."""
    return f' opacity="{opacity:.9g}"' if letter in "MV" and np.isfinite(opacity) else ""


FORMAT = Format(
    "origami-simulator",
    "pattern.origami-simulator.svg",
    (".origami-simulator.svg",),
    "flat pattern for Origami Simulator",
    write_origami_simulator,
    joined=True,
)
