"""Which sheets exist, and that the lengths found make one."""

import numpy as np
import pytest
from scipy.optimize import linprog

from orishell.conventions.errors import DesignError
from orishell.families.longitudinal_linear_repeating import (
    Sectors,
    describe_solutions,
    find_solutions,
)
from orishell.families.longitudinal_linear_repeating.sheet import (
    require_size,
    with_fitting_border,
)
from orishell.families.longitudinal_linear_repeating.tessellation.columns import (
    Columns,
    Directions,
    continue_columns,
    repeat_columns,
)
from orishell.families.longitudinal_linear_repeating.tessellation.even_lengths import (
    Wanted,
    advance_range,
    find_even_lengths,
    largest_square,
    sheet_exists,
)
from orishell.families.longitudinal_linear_repeating.tessellation.following_sheets import (
    LARGEST_RATIO,
)
from orishell.families.longitudinal_linear_repeating.tessellation.lengths import InnerLengths
from orishell.numerics.arrays import Array

SOLUTION = find_solutions(Sectors.from_degrees([85, 80, 95, 100]))[0]


def directions_of(rows: int, columns: int) -> Directions:
    return Directions.of(repeat_columns(SOLUTION, columns), rows, "F")


def closing(directions: Directions, lengths: InnerLengths) -> float:
    """How far panels are from closing: sums of edge vectors round each."""
    row = lengths.row * np.exp(1j * directions.row[:, 1:-1])
    column = -1j * lengths.column * np.exp(1j * directions.column[1:-1])
    gap = row[:-1] + column[:, 1:] - row[1:] - column[:, :-1]
    return float(np.abs(gap).max())


def test_marched_lengths_close_every_panel() -> None:
    directions = directions_of(8, 11)
    rng = np.random.default_rng(5)
    lengths = InnerLengths.marched(directions, rng.uniform(1, 2, 10), rng.uniform(1, 2, 7))
    assert closing(directions, lengths) < 1e-13


def test_directions_agree_round_every_panel() -> None:
    # R[i+1] from R[i] down any column is the same (geometry.md 5: the panels close).
    directions = directions_of(9, 13)
    step = np.diff(directions.row, axis=0)[:, 1:-1]
    sectors = repeat_columns(SOLUTION, 13).sectors
    alpha, beta, gamma, _ = sectors[:-1].T
    np.testing.assert_allclose(step[::2], np.tile(gamma - beta, (4, 1)), atol=1e-14)
    np.testing.assert_allclose(step[1::2], np.tile(alpha - gamma, (4, 1)), atol=1e-14)


def test_equal_lengths_fail_where_the_program_finds_a_sheet() -> None:
    # geometry.md section 5: equal lengths fail even at 9 x 8 for the paper's angles.
    directions = directions_of(9, 8)
    assert InnerLengths.marched(directions, np.ones(7), np.ones(8)).shortest < 0
    found = find_even_lengths(directions, Wanted())
    assert found is not None
    assert closing(directions, found) < 1e-13
    assert found.ratio < 4
    assert found.column.mean() == pytest.approx(1)


def test_no_sheet_is_more_even() -> None:
    directions = directions_of(5, 6)
    best = find_even_lengths(directions, Wanted())
    assert best is not None
    rng = np.random.default_rng(1)
    for _ in range(200):
        row = best.row[2] * rng.uniform(0.8, 1.25, 5)
        column = best.column[:, 0] * rng.uniform(0.8, 1.25, 4)
        assert InnerLengths.marched(directions, row, column).ratio >= best.ratio - 1e-9


def test_wanted_lengths_are_kept() -> None:
    directions = directions_of(5, 9)
    column = np.array([1.0, 1.2, 0.9, 1.1])
    weights = np.linspace(0.8, 1.0, 8)
    found = find_even_lengths(directions, Wanted(column=column, advance=(weights, 6.0)))
    assert found is not None
    np.testing.assert_allclose(found.column[:, 0], column, rtol=1e-12)
    assert found.row[2] @ weights == pytest.approx(6.0, rel=1e-9)
    row = np.array([1.4, 0.23, 1.0, 1.9] * 2)
    given = find_even_lengths(directions, Wanted(row=row))
    assert given is not None
    np.testing.assert_allclose(given.row[2] / given.row[2, 0], row / row[0], rtol=1e-12)


def most_even_by_program(directions: Directions, column: Array) -> float:
    """The least ratio of lengths with column 1 in given ratios: a linear program by HiGHS."""
    n = directions.column.shape[1]
    unit = np.eye(n)
    made = InnerLengths.marched(directions, unit[:, :-1], unit[:, -1:] * column)
    every = np.concatenate([made.row.reshape(n, -1), made.column.reshape(n, -1)], axis=1).T
    count = len(every)
    found = linprog(
        np.append(np.zeros(n), 1.0),
        A_ub=np.block([[-every, np.zeros((count, 1))], [every, -np.ones((count, 1))]]),
        b_ub=np.append(-np.ones(count), np.zeros(count)),
        bounds=(None, None),
    )
    assert found.fun is not None
    return float(found.fun)


@pytest.mark.parametrize(("rows", "columns"), [(5, 9), (9, 6), (12, 13)])
def test_along_a_column_the_longest_is_as_short_as_a_program_makes_it(
    rows: int, columns: int
) -> None:
    directions = directions_of(rows, columns)
    column = 1 + 0.1 * np.sin(np.arange(rows - 1))
    found = find_even_lengths(directions, Wanted(column=column))
    assert found is not None
    # HiGHS is true to 1e-7, the weight of the choice among equally even sheets costs 2e-8 at most.
    assert found.ratio == pytest.approx(most_even_by_program(directions, column), rel=3e-7)


def test_of_equally_even_sheets_always_the_same_one_is_taken() -> None:
    """Two columns of one kind are as long, and no length jumps when column 1 moves by 1e-9."""
    directions, weights = directions_of(7, 9), np.ones(8)
    rng = np.random.default_rng(2)
    rows = []
    for _ in range(4):
        column = 0.318 * (1 + 1e-9 * rng.normal(size=6))
        found = find_even_lengths(directions, Wanted(column=column, advance=(weights, 3.07)))
        assert found is not None
        rows.append(found.row[3])
    assert np.ptp(rows, axis=0).max() < 1e-6
    # A program that stops at any of them took 0.27 and 0.31 for these.
    assert rows[0][0] == pytest.approx(rows[0][2], abs=1e-6)


def test_range_of_the_row() -> None:
    directions = directions_of(7, 9)
    column, weights = np.ones(6), np.ones(8)
    limits = advance_range(directions, Wanted(column=column), weights)
    assert limits is not None
    for total, exists in (
        (limits[0], True),
        (limits[1], True),
        (0.97 * limits[0], False),
        (1.03 * limits[1], False),
    ):
        found = find_even_lengths(directions, Wanted(column=column, advance=(weights, total)))
        # Outside, there is none, or one with creases out of proportion to column 1's.
        if exists:
            assert found is not None
        elif found is not None:
            lengths = np.concatenate([found.row.ravel(), found.column.ravel()])
            assert lengths.min() < 1 / 10 or lengths.max() > 10


def test_largest_sheet_of_the_papers_angles() -> None:
    columns = repeat_columns(SOLUTION, 40)
    assert largest_square(columns, "F", 40) == 35
    assert sheet_exists(columns.first(35), 35, "F")
    assert not sheet_exists(columns.first(36), 36, "F")


def test_an_impossible_size_names_sizes_that_exist() -> None:
    columns = repeat_columns(SOLUTION, 37)
    with pytest.raises(DesignError, match="no sheet of 37 x 37") as caught:
        require_size(columns, 37, "F")
    sizes = [
        (int(str(changes.get("pattern.rows", 37))), int(str(changes.get("pattern.columns", 37))))
        for changes in (each.changes for each in caught.value.candidates)
        if "pattern.sector_deg" not in changes
    ]
    assert (35, 35) in sizes
    for rows, n in sizes:
        assert sheet_exists(columns.first(n), rows, "F")
        assert n < 37 or not sheet_exists(columns, rows + 1, "F")


def test_near_90_degrees_large_sheets_exist() -> None:
    solution = find_solutions(Sectors.from_degrees([89.95, 89.9, 90.05, 90.1]))[0]
    directions = Directions.of(repeat_columns(solution, 41), 41, "F")
    found = find_even_lengths(directions, Wanted())
    assert found is not None
    assert found.ratio < 1.07


def test_sheets_too_large_for_the_program_get_equal_lengths_or_none() -> None:
    near = find_solutions(Sectors.from_degrees([89.9995, 89.999, 90.0005, 90.001]))[0]
    found = find_even_lengths(Directions.of(repeat_columns(near, 150), 150, "F"), Wanted())
    assert found is not None
    np.testing.assert_allclose(found.column[:, 0], found.column[0, 0], rtol=1e-12)
    assert find_even_lengths(directions_of(150, 150), Wanted()) is None


def test_too_wide_a_flap_names_the_widest() -> None:
    columns = repeat_columns(SOLUTION, 9)
    inner = find_even_lengths(directions_of(7, 9), Wanted())
    assert inner is not None
    with pytest.raises(DesignError, match="flap panels") as caught:
        with_fitting_border(columns, "F", inner, (0.3, 0.3), 50.0)
    works = float(str(next(iter(caught.value.candidates)).changes["pattern.flap"]))
    assert with_fitting_border(columns, "F", inner, (0.3, 0.3), works)


def test_describe_solutions() -> None:
    found = describe_solutions([85, 80, 95, 100])
    assert [entry["version"] for entry in found["solutions"]] == ["cosine", "sine"]
    assert found["solutions"][0]["motion_end_deg"] == pytest.approx(119.747, abs=1e-3)
    # geometry.md section 5: the sine version has no sheet beyond the smallest.
    assert found["solutions"][1]["largest_square"] <= 3
    assert LARGEST_RATIO == 1000


def coupled(*couplings: str) -> Columns:
    return continue_columns(
        SOLUTION, ["solve" if each == "solve" else "parallel" for each in couplings]
    )


def test_couplings_without_the_period() -> None:
    # Figure 3(a) is solve, parallel, solve, parallel.
    figure = coupled("solve", "parallel", "solve", "parallel", "solve")
    periodic = repeat_columns(SOLUTION, 6)
    np.testing.assert_allclose(figure.sectors, periodic.sectors, atol=1e-13)
    np.testing.assert_allclose(figure.multipliers, periodic.multipliers, rtol=1e-12)
    # Solving every time gives other columns than the paper's from the third on.
    other = coupled("solve", "solve", "solve")
    assert np.abs(other.sectors[2] - periodic.sectors[2]).max() > 0.1


def test_columns_stop_where_solutions_stop() -> None:
    sine = find_solutions(Sectors.from_degrees([85, 80, 85, 100]))[1]
    with pytest.raises(DesignError, match="no further solution") as caught:
        continue_columns(sine, ["solve", "solve", "solve"])
    assert caught.value.place == "at column 3"
    first = next(iter(caught.value.candidates)).changes["pattern.couplings"]
    assert first == ["solve", "parallel", "parallel"]
    assert len(continue_columns(sine, ["solve", "parallel", "parallel"])) == 4
