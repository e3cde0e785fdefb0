"""Parts of one file: what it takes to add a kind. ``tests/shell/test_toy_part.py`` adds them.

A gusset is a plane triangle between a vertex and the middles of the two edges that run from it up
and down its column. It is put in at the target. A rib stands upright on a panel and moves with it.
"""

from __future__ import annotations

import numpy as np

from orishell.design.part import MadeStates
from orishell.document import SHELL, Document, DocumentState, Part
from orishell.motion.boards import Boards, panel_axes
from orishell.motion.grid import Vertex
from orishell.motion.mesh import build_mesh
from orishell.numerics.arrays import Array

DENSITY = 700.0
"""Of a gusset's board (kg/m3): another than that of the shell's."""
ONE_PANEL = build_mesh(np.array([[0, 1, 2, 3]]), 4)
LETTERS = ("B", "B", "B", "B")
INSET = 0.8
"""The board of a gusset is its triangle, so much smaller about its middle."""


def gusset(document: Document, at: Vertex) -> Part:
    """The gusset at a vertex of the grid, with a board if panels of the document have one."""
    assert document.grid_shape is not None
    points = document.shell.positions[: np.prod(document.grid_shape)]
    column = points.reshape(*document.grid_shape, 3)[:, at[1]]
    corner, above, below = column[at[0]], column[at[0] - 1], column[at[0] + 1]
    ends = 0.5 * (corner + above), 0.5 * (corner + below)
    placed = np.stack([corner, ends[0], 0.5 * (ends[0] + ends[1]), ends[1]])
    # In its own plane, where the document's flat sheet has the vertex.
    long, wide = (each - corner for each in ends)
    x = long / np.linalg.norm(long)
    y = wide - (wide @ x) * x
    flat = np.stack([(placed - corner) @ x, (placed - corner) @ y / np.linalg.norm(y)], axis=-1)
    across = document.grid_shape[1]
    flat += document.require_flat()[at[0] * across + at[1]]
    panel = document.panel
    return Part(
        title=f"Gusset at {at[0]}, {at[1]}",
        unit=document.unit,
        mesh=ONE_PANEL,
        assignment=LETTERS,
        flat=flat,
        fold_angles_deg=np.zeros(4),
        states=(DocumentState(placed, np.zeros(4), document.shell.drive_deg),),
        named={SHELL: 0},
        names=(f"gusset {at[0]},{at[1]}",),
        panel=None if panel is None else panel.replace_unchecked(density=DENSITY),
        boards=None if panel is None else _board(flat[[0, 1, 3]], 0.5 * panel.thickness),
        kind="gusset",
        borne_at=np.array([(at[0] + step, at[1]) for step in (-1, 0, 1)]),
    )


def _board(outline: Array, half: float) -> Boards:
    middle = outline.mean(axis=0)
    inset = middle + INSET * (outline - middle)
    levels = [np.column_stack([inset, np.full(3, z)]) for z in (-half, 0.0, half)]
    return Boards(np.zeros(1, np.int64), np.zeros(1, np.int64), np.stack(levels)[None])


def rib(document: Document, panel: int, height: float) -> Part:
    """The rib on a panel, along its longer diagonal, in all states of the document."""
    quad = document.require_flat()[document.mesh.faces[panel]]
    long = 0.5 * float(max(np.linalg.norm(quad[2:] - quad[:2], axis=1)))
    own = np.array([[0, 0, 0], [long, 0, 0], [long, 0, height], [0, 0, height]])
    face = document.mesh.faces[[panel]]
    lying = np.pad(document.require_flat(), ((0, 0), (0, 1)))[face]

    def placed(number: int) -> DocumentState:
        state = document.states[number]
        origin, axes = panel_axes(state.positions[face], lying)
        return DocumentState(origin[0] + own @ axes[0].T, np.zeros(4), state.drive_deg)

    flat = np.array([[0, 0], [long, 0], [long, height], [0, height]]) + quad.mean(axis=0)
    return Part(
        title=f"Rib on {document.panel_name(panel)}",
        unit=document.unit,
        mesh=ONE_PANEL,
        assignment=LETTERS,
        flat=flat,
        fold_angles_deg=np.zeros(4),
        states=MadeStates(len(document.states), placed),
        named=document.named,
        names=(f"rib {document.panel_name(panel)}",),
        kind="rib",
    )
