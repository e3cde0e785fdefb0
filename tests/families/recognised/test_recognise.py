"""Sheets of every family are known by their sector angles, and by how much they miss."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
import pytest

from flat_foldables import random_sheet
from mechanisms import CLOSED, SAMPLES, longitudinal, random_net, with_flap_columns
from orishell.families.longitudinal_linear_repeating import Sectors, find_solutions
from orishell.families.longitudinal_linear_repeating.tessellation.columns import (
    Directions,
    RowKind,
    repeat_columns,
)
from orishell.families.longitudinal_linear_repeating.tessellation.even_lengths import (
    Wanted,
    find_even_lengths,
)
from orishell.families.recognised import NAMES, misses, recognise
from orishell.motion import Mechanism
from orishell.motion.grid import CreaseValues, crease_signs
from orishell.numerics.arrays import Array
from patterns import huffman, not_folding
from samples import THOROUGH

COUNT = 200 if THOROUGH else 4
JITTER = 1e-9, 1e-6, 1e-3
"""Of every coordinate, by the shortest edge."""


def random_longitudinal(seed: int) -> Mechanism:
    rng = np.random.default_rng(seed)
    while True:
        degrees = tuple(rng.uniform(75, 105, 4).round(3).tolist())
        rows, columns = int(rng.integers(2, 6)), int(rng.integers(2, 7))
        first: RowKind = "F" if rng.integers(2) else "S"
        for number, solution in enumerate(find_solutions(Sectors.from_degrees(degrees))):
            directions = Directions.of(repeat_columns(solution, columns), rows, first)
            inner = find_even_lengths(directions, Wanted())
            if inner is not None and inner.ratio < 100:
                return longitudinal(degrees, rows, columns, first, number)


FAMILIES: dict[str, Callable[[int], Mechanism]] = {
    "parallel-repeating": lambda number: random_sheet(4 * number),
    "orthodiagonal": lambda number: random_sheet(4 * number + 1),
    "flat-foldable": lambda number: random_sheet(4 * number + 2 + number % 2),
    "longitudinal-linear-repeating": random_longitudinal,
}


def sheet(mechanism: Mechanism) -> tuple[Array, CreaseValues]:
    folded = mechanism.fold_angles(mechanism.target_drive)
    return mechanism.positions(0.0)[..., :2], crease_signs(folded)


def shortest(flat: Array) -> float:
    edges = (np.linalg.norm(np.diff(flat, axis=axis), axis=-1) for axis in (0, 1))
    return min(float(each.min()) for each in edges)


def jittered(name: str) -> Iterator[tuple[Array, Array, CreaseValues]]:
    for number in range(COUNT):
        flat, signs = sheet(FAMILIES[name](number))
        move = np.random.default_rng(number).uniform(-1, 1, flat.shape)
        yield flat, shortest(flat) * move, signs


@pytest.mark.parametrize("name", FAMILIES)
def test_by_how_much_a_sheet_misses_grows_as_its_vertices_are_moved(name: str) -> None:
    """Slope 1 within 10 %; 0.1 % seen on 200 of each. As drawn it is rounding: 2.3 digits seen."""
    for flat, move, signs in jittered(name):
        digit = np.finfo(float).eps * np.abs(flat).max() / shortest(flat)
        assert misses(flat, signs)[name] < 16 * digit
        found = [misses(flat + share * move, signs)[name] for share in JITTER]
        slopes = np.diff(np.log(found)) / np.diff(np.log(JITTER))
        np.testing.assert_allclose(slopes, 1.0, atol=0.1)


@pytest.mark.parametrize("name", FAMILIES)
def test_a_sheet_is_known_to_the_tolerance_asked_for(name: str) -> None:
    """Vertices moved by a share of an edge turn it by twice that at most, and sectors by twice it.

    More special families are found first: a sheet of straight columns may be Miura-ori.
    """
    for flat, move, signs in jittered(name):
        for share, tolerance in zip((0.0, *JITTER), (1e-12, 1e-8, 1e-5, 1e-2), strict=True):
            found = recognise(flat + share * move, signs, tolerance)
            assert found is not None
            assert name in (found.family, *found.also)
            assert found.miss <= tolerance
            if share > 0:
                closer = recognise(flat + share * move, signs, 1e-3 * share)
                assert closer is None or name not in (closer.family, *closer.also)


@pytest.mark.parametrize("change", ["turned", "mirrored", "rotated", "upside down"])
@pytest.mark.parametrize("name", FAMILIES)
def test_however_it_is_drawn(name: str, change: str) -> None:
    flat, signs = sheet(FAMILIES[name](2))
    turn = np.array([[0.6, 0.8], [-0.8, 0.6]])
    changed, its_signs = {
        "turned": (flat.swapaxes(0, 1), CreaseValues(signs.column.T, signs.row.T)),
        "mirrored": (flat * [-1, 1], signs),
        "rotated": (1e3 * flat @ turn + [7, -5], signs),
        "upside down": (flat[::-1], CreaseValues(signs.row[::-1], signs.column[::-1])),
    }[change]
    found = recognise(changed, its_signs)
    assert found is not None
    assert name in (found.family, *found.also)
    assert found.turned == (change == "turned" and name != "flat-foldable")


def test_every_kind_of_sheet_is_known() -> None:
    for name in CLOSED:
        if name == "flat-foldable, one row with flaps":
            continue  # the row is known if its flaps are left out, and one of three says nothing
        found = recognise(*sheet(SAMPLES[name].make()))
        assert found is not None, name
        assert found.family in NAMES


def test_flaps_at_a_border_are_left_out() -> None:
    """Kawasaki fails in the last column, beside which the flaps stand."""
    found = recognise(*sheet(with_flap_columns(random_net(6, 6, 4))))
    assert found is not None
    assert found.family == "flat-foldable"
    assert found.beside == (0, 0, 0, 1)


def grid_of_squares(rows: int, columns: int) -> Array:
    i, j = np.indices((rows, columns)).astype(np.float64)
    return np.stack([j, -i], axis=-1)


def test_lines_that_cross_are_no_family() -> None:
    assert recognise(grid_of_squares(5, 6)) is None


def test_huffmans_grid_is_flat_foldable_and_a_random_one_is_nothing() -> None:
    pattern = huffman(4, 5)
    first, second = np.sort(pattern.edges, axis=1).T
    order = np.lexsort((second, first, second - first > 1))  # as a grid numbers its edges
    row, column = pattern.signs[order][:25].reshape(5, 5), pattern.signs[order][25:].reshape(4, 6)
    found = recognise(
        pattern.vertices.reshape(5, 6, 2), CreaseValues(row=row[1:-1], column=column[:, 1:-1])
    )
    assert found is not None
    assert (found.family, found.beside) == ("flat-foldable", (0, 0, 0, 0))
    assert recognise(not_folding().vertices.reshape(5, 5, 2)) is None
