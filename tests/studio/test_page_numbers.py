"""What the pages compute themselves is SciPy's: the numbers that their tests compare with.

``frontend/tests/*.json`` hold them, for ``make test-pages``. To write them anew:
``ORISHELL_WRITE_GOLDEN=1 python -m pytest tests/studio/test_page_numbers.py``.
"""

from __future__ import annotations

import base64
import json
import os
from pathlib import Path
from typing import Any

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation

from orishell import ParallelRepeatingPattern, curve_from_points, design_parallel_repeating
from orishell.design import Design, PanelSpec
from orishell.document.from_design import document_of_motion
from orishell.io.view import dump_view
from orishell.motion import FoldingMotion
from orishell.numerics.arrays import Array
from orishell.solids import build_boards, largest_folds

FIXTURES = Path(__file__).parents[2] / "frontend" / "tests"
SHARES = np.linspace(0.0, 1.0, 9)
POINTS: list[list[list[float]]] = [
    [[0, 0], [3, 4]],
    [[0, 0], [1, 2], [4, 1]],
    [[0, 0], [1, 2], [4, 1], [5, 5]],
    [[-1.5, -2.25], [-0.2, 0.1], [-0.1, 0], [0.9, -0.7], [1.6, -2.3], [7, 3]],
]
"""Points of a line, a parabola (three points bend no further), one cubic, and several."""
STATES = 4


def require_current(name: str, numbers: dict[str, Any], keys: tuple[str, ...]) -> dict[str, Any]:
    """Compare numbers, by their keys, with those that the pages' tests read; return these."""
    path = FIXTURES / name
    if os.environ.get("ORISHELL_WRITE_GOLDEN"):
        lines = (f"{json.dumps(key)}: {json.dumps(value)}" for key, value in numbers.items())
        path.write_text("{\n" + ",\n".join(lines) + "\n}\n")
    found: dict[str, Any] = json.loads(path.read_text())
    assert set(found) == set(numbers)
    for key in keys:
        for mine, theirs in zip(found[key], numbers[key], strict=True):
            np.testing.assert_allclose(mine, theirs, rtol=1e-9, atol=1e-9)
    return found


def test_splines_are_scipys() -> None:
    drawn = []
    for points in POINTS:
        array = np.array(points)
        knots = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(array, axis=0).T))])
        expected = CubicSpline(knots, array)(SHARES * knots[-1])
        ours = curve_from_points(array, smooth=True).position(SHARES * knots[-1])
        np.testing.assert_allclose(ours, expected, atol=1e-12)
        drawn.append(expected.tolist())
    numbers = {
        "source": "scipy.interpolate.CubicSpline, not-a-knot, over chord length",
        "shares": SHARES.tolist(),
        "points": POINTS,
        "drawn": drawn,
    }
    require_current("spline.json", numbers, ("shares", "points", "drawn"))


def turned(start: Array, end: Array, share: float) -> Array:
    """Corners (4, 3) of a rigid panel on the way: an even turn about its centre, which moves on."""
    at = start.mean(axis=0), end.mean(axis=0)
    whole, _ = Rotation.align_vectors(end - at[1], start - at[0])
    turn = Rotation.from_rotvec(share * whole.as_rotvec())
    moved: Array = turn.apply(start - at[0]) + (1 - share) * at[0] + share * at[1]
    return moved


def small_shell(flap: float) -> Design:
    f = curve_from_points([[-1, -0.3], [-0.4, -0.05], [0.4, -0.05], [1, -0.3]], smooth=True)
    g = curve_from_points([[0.0, 0.0], [1.0, 0.2], [2.0, 0.0]], smooth=True)
    return design_parallel_repeating(
        f, g, ParallelRepeatingPattern(rows=3, columns=2, xi_deg=100, flap=flap)
    )


def test_panels_move_as_scipy_turns_them() -> None:
    motion = FoldingMotion(small_shell(flap=0.1).mechanism, STATES)
    document = document_of_motion(motion, "m", title="panels", curves={}, origin=np.zeros(3))
    states = np.array([state.positions.reshape(-1, 3) for state in motion])
    drives = np.array([state.drive for state in motion])
    corners = states[:, document.mesh.faces]
    folds = [*((drives - drives[0]) / (drives[-1] - drives[0])), 0.1, 0.5, 0.95]
    placed = []
    for fold in folds:
        drive = drives[0] + fold * (drives[-1] - drives[0])
        k = min(int(np.searchsorted(drives, drive, side="right")) - 1, STATES - 2)
        share = (drive - drives[k]) / (drives[k + 1] - drives[k])
        pairs = zip(corners[k], corners[k + 1], strict=True)
        placed.append([turned(start, end, share).tolist() for start, end in pairs])
    # At the states themselves that is where the mechanism has the panels.
    np.testing.assert_allclose(placed[:STATES], corners, atol=1e-9)
    view = dump_view(document)
    numbers = {
        "source": "the mechanism's states; between them scipy.spatial.transform.Rotation",
        "view": base64.b64encode(view).decode(),
        "folds": np.round(folds, 12).tolist(),
        "corners": np.round(placed, 10).tolist(),
    }
    require_current("motion.json", numbers, ("folds", "corners"))


def test_boards_are_carried_by_their_panels() -> None:
    """At every state, and on the way between two by the panels as SciPy turns them."""
    mechanism = small_shell(flap=0.0).mechanism
    motion = FoldingMotion(mechanism, STATES)
    flat = mechanism.positions(0.0)
    folds = largest_folds(mechanism, mechanism.target_drive)
    shown = []
    for build in (
        PanelSpec(thickness=0.04, membrane=0.002),
        PanelSpec(thickness=0.04, construction="bevel", gap=0.002),
    ):
        boards = build_boards(flat, mechanism.grid, build, folds)
        document = document_of_motion(
            motion, "m", title="boards", curves={}, origin=np.zeros(3), panel=build, boards=boards
        )
        start, end = (document.states[k].positions[document.mesh.faces] for k in (1, 2))
        half = np.array([turned(*each, 0.5) for each in zip(start, end, strict=True)])
        # Every panel with corners of its own: between two states neighbours part by a hair.
        alone = np.arange(half.size // 3).reshape(-1, 4)
        apart = document.require_flat()[document.mesh.faces].reshape(-1, 2)
        at_half = boards.carried(alone, apart, half.reshape(-1, 3))
        states = [document.boards_in(state) for state in document.states]
        shown.append(
            {
                "view": base64.b64encode(dump_view(document)).decode(),
                "folds": [0, 1, 1.5 / (STATES - 1)],
                "outlines": np.round([states[0], states[-1], at_half], 10).ravel().tolist(),
                "volumes": boards.volumes().tolist(),
            }
        )
    sandwich, bevel = shown
    numbers = {"source": "orishell.motion.Boards", "sandwich": sandwich, "bevel": bevel}
    found = require_current("boards.json", numbers, ())
    for name, mine in (("sandwich", sandwich), ("bevel", bevel)):
        for key in ("folds", "outlines", "volumes"):
            np.testing.assert_allclose(found[name][key], mine[key], rtol=1e-9, atol=1e-9)
