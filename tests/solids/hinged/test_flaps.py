"""Why whole boards on hinges have no flaps: at a flap's vertex all four hinges are at one height.

A flap folds flat at the target, where the sheet does not. So its vertices do not fold flat with
the sheet, and a loop of four hinges about one moves only if it is spherical: with hinges at one
height.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from mechanisms import arch_with_flaps, parallel, upright
from orishell.design_file import read_design_file
from orishell.motion import Mechanism
from orishell.motion.layout import Layout, points_of
from orishell.motion.quads import unit_normals
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.shell.designed import designed
from samples import thorough

DOME = Path(__file__).parents[3] / "examples" / "dome_locked.toml"
ZERO = 1e-13
"""Of the largest singular value; 5e-16 is the most that was seen, 0.14 the least of the others."""


def slit() -> Mechanism:
    thin = {"panel.thickness": None, "panel.membrane": None}
    size = {"pattern.rows": 5, "pattern.columns": 5}
    return designed(read_design_file(DOME).changed({**thin, **size})).mechanism


def loops(sheet: Mechanism) -> tuple[Integers, Booleans]:
    """Panels (K, 4) around all vertices, and which of these are flaps' (K,)."""
    layout, across = Layout.of(sheet), sheet.grid.columns - 1
    hosts = dict(layout.hinges.tolist())
    found = [(hosts[a], hosts[b], b, a) for a, b in layout.pairs.tolist()]
    for row in range(sheet.grid.rows - 2):
        for first in range(row * across, (row + 1) * across - 1):
            found.append((first, first + across, first + across + 1, first + 1))
    panels = np.array(found)
    return panels, np.asarray(layout.flaps[panels].any(axis=1))


def ranks(sheet: Mechanism) -> tuple[Array, Booleans]:
    """Singular values (K, 4) of what four heights add up to around each vertex, in 12 states."""
    panels, of_flaps = loops(sheet)
    drives = np.linspace(0.1, 1.0, 12) * sheet.target_drive
    normals = unit_normals(points_of(sheet, drives)[:, Layout.of(sheet).faces])[:, panels]
    steps = normals - np.roll(normals, -1, axis=2)
    matrices = np.moveaxis(steps, (1, 0, 3, 2), (0, 1, 2, 3)).reshape(len(panels), -1, 4)
    values = np.linalg.svd(matrices, compute_uv=False)
    return values / values[:, :1], of_flaps


@pytest.mark.parametrize(
    "make",
    [
        lambda: parallel(5, 6, plane="bisector"),
        lambda: upright(7, 6, row="zigzag", depth=0.1),
        arch_with_flaps,
        pytest.param(slit, marks=thorough),
    ],
    ids=["parallel repeating", "orthodiagonal", "flap columns", "slit flaps"],
)
def test_hinges_about_a_vertex_of_a_flap_must_be_at_one_height(
    make: Callable[[], Mechanism],
) -> None:
    """Of four heights two are free elsewhere, one there: the same for all."""
    values, of_flaps = ranks(make())
    assert of_flaps.any()
    assert (values[~of_flaps, 1] > 0.1).all()
    assert (values[~of_flaps, 2:] < ZERO).all()
    assert (values[of_flaps, 2] > 0.1).all()
    assert (values[of_flaps, 3] < ZERO).all()
