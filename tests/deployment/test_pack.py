"""Layers that can be counted by hand, and the smallest state of shells that close to a bundle."""

import numpy as np
import pytest

from orishell.deployment import count_layers, find_pack, smallest_box
from orishell.families.parallel_repeating import ParallelRepeatingPattern, design_parallel_repeating
from orishell.motion.grid import Grid
from strategies import graph

STRAIGHT = graph("0*x", 0, 2)


def miura(rows: int, columns: int, width: float) -> tuple[np.ndarray, np.ndarray]:
    """A folded Miura sheet of panels of height 1 and row creases of this many steps.

    Row creases fold onto each other: column j begins at 0 or at the width, in turn. Columns zigzag:
    row i begins at x = i, at the bottom or the top in turn.
    """
    i, j = np.meshgrid(np.arange(rows + 1.0), np.arange(columns + 1), indexing="ij")
    points = np.stack([i + width * (j % 2), i % 2, 0 * i], axis=-1)
    return points.reshape(-1, 3), Grid(rows + 1, columns + 1).faces_vertices()


@pytest.mark.parametrize(
    ("rows", "columns", "width", "layers"),
    [
        (1, 1, 9.0, 1),
        (1, 5, 9.0, 5),
        (4, 1, 9.0, 4),  # wide panels: all overlap
        (6, 3, 0.9, 6),  # rows touch in pairs near their row creases only
        (6, 3, 2.5, 12),  # near a row crease that two rows share, the next such one overlaps
        (2, 2, 1.5, 4),
    ],
)
def test_layers_of_a_folded_miura_sheet(rows: int, columns: int, width: float, layers: int) -> None:
    assert count_layers(*miura(rows, columns, width), np.eye(3)) == layers


@pytest.mark.parametrize("count", [1, 2, 7])
def test_layers_of_a_strip_folded_to_and_fro(count: int) -> None:
    i, j = np.meshgrid(np.arange(count + 1.0), [0.0, 2.0], indexing="ij")
    points = np.stack([i % 2, j, 1e-3 * i], axis=-1).reshape(-1, 3)
    assert count_layers(points, Grid(count + 1, 2).faces_vertices()) == count


def test_panels_far_smaller_than_their_sheet_do_not_lie_on_those_beside_them() -> None:
    i, j = np.meshgrid(np.arange(2.0), np.arange(3001.0), indexing="ij")
    points = np.stack([j, i, 0 * i], axis=-1).reshape(-1, 3)
    assert count_layers(points, Grid(2, 3001).faces_vertices(), np.eye(3)) == 1


def test_layers_of_more_panels_than_are_looked_at_are_not_too_many(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    folded = miura(6, 30, 2.5)
    assert count_layers(*folded, np.eye(3)) == 120
    monkeypatch.setattr("orishell.deployment.pack.MOST_PAIRS", 1000)
    monkeypatch.setattr("orishell.deployment.pack.MOST_EACH", 1)
    assert 60 <= count_layers(*folded, np.eye(3)) <= 120


def test_a_flat_sheet_is_one_layer() -> None:
    design = design_parallel_repeating(
        graph("-x**2", -1, 1), STRAIGHT, ParallelRepeatingPattern(rows=5, columns=4, flap=0.2)
    )
    mechanism = design.mechanism
    points = mechanism.positions(0.0).reshape(-1, 3)
    assert count_layers(points, mechanism.grid.faces_vertices()) == 1


def test_a_straight_tunnel_closes_to_a_bundle_of_all_its_rows() -> None:
    f = graph("0.01*sin(x)", 0, 9)  # so nearly straight that all rows overlap
    design = design_parallel_repeating(
        f, STRAIGHT, ParallelRepeatingPattern(rows=5, columns=4, flap=0.0, xi_deg=np.rad2deg(1.0))
    )
    mechanism = design.mechanism
    pack = find_pack(mechanism, mechanism.end_drive, 9)
    assert pack.drive == mechanism.end_drive
    assert pack.box.height < 1e-7
    assert pack.box.length * pack.box.width < 9  # of more than 18 in the flat sheet
    # Panels are rectangles here, columns unfolded: one lies on the other, in every column.
    assert pack.layers >= 3


def test_a_thick_limit_is_compared_with_the_states_before() -> None:
    design = design_parallel_repeating(
        graph("-x**2", -1, 1),
        STRAIGHT,
        ParallelRepeatingPattern(rows=5, columns=4, flap=0.0, xi_deg=np.rad2deg(0.8)),
    )
    mechanism = design.mechanism
    limit = mechanism.target_drive + 0.1
    pack = find_pack(mechanism, limit, 5)
    boxes = [
        smallest_box(mechanism.positions(drive).reshape(-1, 3)).volume
        for drive in np.linspace(mechanism.target_drive, limit, 5)
    ]
    assert pack.box.volume == pytest.approx(min(boxes))
