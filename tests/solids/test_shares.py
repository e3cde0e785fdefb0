"""The least share of a panel that is board, and the steepest chamfer, as figures of the report."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from design_tables import Tables, formula, tables
from orishell.design_file import check_design
from orishell.search.figures import figure
from orishell.shell.make import Shell, make_shell
from orishell.shell.steps import STEPS
from orishell.workshop.boards import chamfer_angles

F, G = formula("-x**2", -1, 1), formula("0.3*sin(pi*x/2)", 0, 3)
BUILDS: dict[str, Tables] = {
    "sandwich": {"thickness": 0.01, "membrane": 0.001},
    "bevel": {"construction": "bevel", "thickness": 0.01, "gap": 0.002},
}


def shell_of(build: str) -> Shell:
    design = tables("parallel-repeating", F, G, rows=5, columns=5, flap=0)
    design["panel"] = BUILDS[build]
    return make_shell(check_design(design, Path("shell.toml")), skip=STEPS)


@pytest.mark.parametrize("build", BUILDS)
def test_shares_are_those_of_boards_one_by_one(build: str) -> None:
    """Areas by shapely's polygons, of every outline of every board; to rounding."""
    import shapely

    shell = shell_of(build)
    boards, document = shell.document.boards, shell.document
    assert boards is not None
    flat = document.require_flat()
    shares = [
        shapely.Polygon(level).area / shapely.Polygon(flat[document.mesh.faces[panel]]).area
        for panel, outlines in zip(boards.panels, boards.outlines[..., :2], strict=True)
        for level in outlines
    ]
    found = figure("panel.least_share").read(shell.report)
    assert found == pytest.approx(min(shares), rel=1e-9)


def test_a_chamfer_leans_by_half_the_largest_fold_or_less() -> None:
    """Faces that close by phi stand back by half the thickness times tan(phi/2)."""
    shell = shell_of("bevel")
    panel, boards = shell.report.panel, shell.document.boards
    assert panel is not None
    assert boards is not None
    steepest = figure("panel.steepest_chamfer_deg").read(shell.report)
    assert steepest is not None
    assert steepest == pytest.approx(chamfer_angles(boards).max(), abs=1e-6)
    assert 0 < steepest <= np.rad2deg(0.5 * panel.largest_fold) + 1e-6


def test_square_boards_have_no_chamfer() -> None:
    assert figure("panel.steepest_chamfer_deg").read(shell_of("sandwich").report) is None
