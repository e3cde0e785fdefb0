"""How close whole boards are to f, g and the surfaces of crests and valleys: by brute force."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from orishell.design import Design
from orishell.design_file import read_design_file
from orishell.deviation import drawn_shell, locked_shell
from orishell.deviation.of_boards import boards_closeness
from orishell.motion.hinges import Hinges
from orishell.numerics.arrays import Array
from orishell.shell.designed import designed
from samples import thorough

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def shelter() -> Design:
    return designed(read_design_file(EXAMPLES / "shelter_hinged.toml"))


def along(edges: Array, count: int = 400) -> Array:
    """Points (P, 3) on edges (E, 2, 3)."""
    share = np.linspace(0, 1, count)[:, None, None]
    return np.asarray((edges[:, 0] * (1 - share) + edges[:, 1] * share).reshape(-1, 3))


def test_distances_from_curves_are_those_of_points_on_edges_of_boards(shelter: Design) -> None:
    """Points 1 mm apart on the edges, samples of the curves as they are traced: to 1 mm."""
    from scipy.spatial import cKDTree

    hinges, mechanism = shelter.hinges, shelter.mechanism
    assert isinstance(hinges, Hinges)
    boards = hinges.boards(mechanism.positions(mechanism.target_drive))
    edges = {
        "f": boards[:, 0, :2],
        "g": np.concatenate([boards[5][:, [1, 2]], boards[6][:, [0, 3]]]),
    }
    found = boards_closeness(shelter)
    assert set(found) == {"f", "g"}
    for name, own in edges.items():
        curve, points = shelter.targets[name], along(own)
        ways = cKDTree(points).query(curve)[0], cKDTree(curve).query(points)[0]
        farthest = max(float(np.max(each)) for each in ways)
        assert found[name].max == pytest.approx(farthest, abs=1e-3)


def test_pictures_draw_boards_where_they_are(shelter: Design) -> None:
    """Means of their corners lie within 5 mm of the panels that meet the target.

    The sheet without a thickness lies up to 76 mm beside these.
    """
    assert shelter.meant is not None
    assert np.linalg.norm(drawn_shell(shelter) - shelter.meant, axis=-1).max() < 5e-3
    assert np.linalg.norm(locked_shell(shelter) - shelter.meant, axis=-1).max() > 0.02


def test_boards_follow_the_curves_as_the_sheet_would(shelter: Design) -> None:
    """Not exactly: they slide in their planes, by up to 20 mm, and end short of its vertices."""
    found = boards_closeness(shelter)
    for name, sheet in shelter.closeness.items():
        assert found[name].max == pytest.approx(sheet.max, abs=5e-3)
        assert found[name].rms == pytest.approx(sheet.rms, abs=5e-3)


@thorough
def test_crests_and_valleys_of_a_fitted_sheet_are_those_of_its_boards() -> None:
    """Beside what vertices leave of their surfaces, boards leave what lengths cannot follow."""
    file = read_design_file(EXAMPLES / "saddle.toml").changed(
        {
            "panel.construction": "hinged",
            "panel.membrane": None,
            "pattern.rows": 5,
            "pattern.columns": 5,
        }
    )
    design = designed(file)
    found = boards_closeness(design)
    assert set(found) == {"crests", "valleys"}
    for name, sheet in design.closeness.items():
        assert 0.8 * sheet.rms < found[name].rms < sheet.rms + 3e-3
