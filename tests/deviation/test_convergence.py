"""Shells come close to their surfaces at the orders that the geometry gives: 1 in rows of a
corrugation, 2 in chords of g and in the polygon of a convex f."""

import runpy
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from samples import thorough

EXAMPLE = Path(__file__).parents[2] / "examples" / "convergence.py"


@pytest.fixture(scope="module")
def example() -> dict[str, Any]:
    return runpy.run_path(str(EXAMPLE))


@thorough
@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "order", "tolerances"),
    [
        # The first step is from 10 to 18 edges, where the order is not yet settled everywhere.
        pytest.param("parallel_rows", 1, (0.1, 0.1, 0.05, 0.05), marks=thorough),
        ("parallel_polylines", 1, (0.1, 0.1, 0.05, 0.05)),
        ("parallel_columns", 2, (0.1, 0.05, 0.05, 0.05)),
        ("orthodiagonal_rows", 1, (0.1, 0.1, 0.05, 0.05)),
        ("orthodiagonal_approach", 1, (0.1, 0.25, 0.05, 0.05)),
        ("longitudinal_rows", 1, (0.05, 0.05, 0.05)),
        ("longitudinal_column", 2, (0.05, 0.05, 0.05)),
    ],
)
def test_orders(
    example: dict[str, Any], name: str, order: int, tolerances: tuple[float, ...]
) -> None:
    series = example[name]()
    assert series.order == order
    off = np.abs(series.orders() - order)
    assert (off < np.array(tolerances)).all(), f"orders {series.orders()}"
    assert (np.diff(series.values) < 0).all()


def test_the_picture_has_the_same_bytes_each_time(example: dict[str, Any], tmp_path: Path) -> None:
    counts = np.array([10.0, 20.0, 40.0])
    series = [example["Series"]("name", k, counts, counts**-k) for k in (1, 2)]
    for name in ("one.png", "two.png"):
        example["draw"](series, tmp_path / name)
    assert (tmp_path / "one.png").read_bytes() == (tmp_path / "two.png").read_bytes()
    np.testing.assert_allclose(series[1].orders(), 2)
