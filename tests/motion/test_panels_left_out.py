"""How many motions a sheet has whose panels are left out: what the guide says of windows."""

from __future__ import annotations

import tomllib
from collections.abc import Collection
from pathlib import Path

import numpy as np
import pytest

from documents import EXAMPLES
from orishell.design_file import check_design, read_design_file
from orishell.motion import Mechanism
from orishell.motion.layout import mesh_of, points_of
from orishell.shell.designed import designed

PAGE = Path(__file__).parents[2] / "docs" / "guide" / "end-walls.md"
NOTHING = 1e-9
"""Singular values below this share of the largest are none: 3e-16 were seen, and 5e-05 above."""


def narrow() -> Mechanism:
    """The sheet of the guide's page: ten rows of four panels."""
    tables = tomllib.loads(PAGE.read_text(encoding="utf-8").split("```toml\n")[1].split("```")[0])
    del tables["target"]["fit"], tables["end_wall"]
    return designed(check_design(tables, Path("bus.toml"))).mechanism


def wide() -> Mechanism:
    """Six rows of seven panels."""
    return designed(read_design_file(EXAMPLES / "arch_pattern.toml")).mechanism


def motions(mechanism: Mechanism, gone: Collection[tuple[int, int]]) -> int:
    """Freedoms of rigid panels on hinges, half way to the target, by the rank of their speeds.

    Both ends of a hinge move alike with both of its panels, each of which turns and shifts.
    """
    mesh, columns = mesh_of(mechanism), mechanism.grid.columns - 1
    points = points_of(mechanism, 0.5 * mechanism.target_drive)
    points = points / np.ptp(points, axis=0).max()
    left = np.ones(len(mesh.faces), bool)
    left[[row * columns + column for row, column in gone]] = False
    hinges = mesh.crease & left[mesh.edge_faces].all(axis=1)
    ends, panels = mesh.edges[hinges], mesh.edge_faces[hinges]
    speeds = np.zeros((len(ends), 2, 3, len(left), 6))
    for number, (pair, both) in enumerate(zip(ends, panels, strict=True)):
        for end, vertex in enumerate(pair):
            turning = np.cross(np.eye(3), points[vertex])
            for panel, sign in zip(both, (1, -1), strict=True):
                speeds[number, end, :, panel] += sign * np.hstack([turning.T, np.eye(3)])
    matrix = speeds[:, :, :, left].reshape(6 * len(ends), -1)
    sizes = np.linalg.svd(matrix, compute_uv=False)
    return matrix.shape[1] - int((sizes > NOTHING * sizes[0]).sum()) - 6


@pytest.mark.parametrize("gone", [(), [(3, 3)], [(0, 3)], [(3, 3), (3, 4)], [(0, 3), (1, 3)]])
def test_a_sheet_of_seven_columns_keeps_its_one_motion(gone: list[tuple[int, int]]) -> None:
    assert motions(wide(), gone) == 1


@pytest.mark.parametrize(
    ("gone", "left"), [((), 1), ([(5, 2)], 1), ([(0, 2)], 2), ([(0, 2), (1, 2)], 3)]
)
def test_a_sheet_of_four_columns_does_not_at_its_foot(
    gone: list[tuple[int, int]], left: int
) -> None:
    assert motions(narrow(), gone) == left
