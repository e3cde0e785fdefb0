"""Degrees of freedom of sheets, against the rank of rigid bodies that are joined along creases."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from mechanisms import (
    drawn_from,
    flat_foldable,
    longitudinal,
    miura_net,
    orthodiagonal_of,
    parallel,
    parallel_of,
    random_net,
    straight,
    upright,
    with_flap_columns,
)
from orishell.conventions.errors import OrishellError
from orishell.curves import Curve
from orishell.design import PanelSpec
from orishell.families.flat_foldable.locks.slit import SlitFlaps
from orishell.families.orthodiagonal import OrthodiagonalPattern, design_orthodiagonal
from orishell.families.parallel_repeating import ParallelRepeatingPattern, design_parallel_repeating
from orishell.motion import Mechanism, diagonal
from orishell.motion.freedom import find_freedom_of_sheet, held_at, held_by_flaps, hold_alone
from orishell.motion.grid import Grid
from orishell.solids.hinged import find_hinges
from rigid_rank import freedoms_of_boards, freedoms_of_panels
from samples import led_by, thorough
from strategies import graph
from toy_family import Miura

DESIGNS, QUICK = 300, 20


def _f(rng: np.random.Generator) -> Curve:
    a, b = rng.uniform(-1, -0.3), rng.uniform(-0.2, 0.2)
    return graph(f"{a:.3f}*x**2 + {b:.3f}*x", -1, 1)


def _g(rng: np.random.Generator) -> Curve:
    """Straight, bent to one side, or a wave."""
    slope, bend = rng.uniform(-0.3, 0.3), rng.uniform(0.02, 0.15)
    kind = rng.integers(4)
    text = (
        f"{slope:.3f}*x",
        "0*x + 0.7",
        f"{slope:.3f}*x + {bend:.3f}*x**2",
        f"{bend:.3f}*sin(pi*x/2) + {slope:.3f}*x",
    )[kind]
    return graph(text, 0, 4)


def _swept(rng: np.random.Generator, number: int) -> Mechanism:
    rows, columns = 2 * int(rng.integers(1, 4)) + 1, int(rng.integers(3, 7))
    flap: Any = (0.0, 0.0, 0.1, "auto")[int(rng.integers(4))]
    f, g = _f(rng), _g(rng)
    if number % 2:
        return parallel_of(
            design_parallel_repeating(
                f, g, ParallelRepeatingPattern(rows=rows, columns=columns, flap=flap)
            )
        )
    kind = "zigzag" if rng.integers(4) == 0 else "curve"
    options: Any = {"row": "zigzag"} if kind == "zigzag" else {}
    return orthodiagonal_of(
        design_orthodiagonal(
            f, g, OrthodiagonalPattern(rows=rows, columns=columns, depth=0.1, flap=flap, **options)
        )
    )


def _one_flap(rng: np.random.Generator, number: int) -> Mechanism:
    """Flaps on one side only: one column of them couples all rows."""
    sheet: Any = _swept(rng, number)
    left, right = getattr(sheet, "flaps", (0.0, 0.0))
    one_sided: Mechanism = replace(sheet, flaps=(left, 0.0)) if left and right else sheet
    return one_sided


def _longitudinal(rng: np.random.Generator, number: int) -> Mechanism:
    degrees = tuple(np.round(rng.uniform(75, 105, 4), 3).tolist())
    rows, columns = (int(n) for n in rng.integers(1, 6, 2))
    return longitudinal(degrees, rows, columns + 1, "S" if number % 2 else "F")


def _nets(rng: np.random.Generator, number: int) -> Mechanism:
    rows, columns = (int(n) for n in rng.integers(2, 6, 2))
    net = random_net(rows, columns, int(rng.integers(10**6)), mixed=bool(number % 2))
    return flat_foldable(net)


def _locked(rng: np.random.Generator, number: int) -> Mechanism:
    net = random_net(5, 5, int(rng.integers(10**6)))
    if number % 2:
        return with_flap_columns(net)
    return SlitFlaps(flat_foldable(net), (0.2, 0.3 * (number % 3)))


def _drawn(rng: np.random.Generator, number: int) -> Mechanism:
    return drawn_from(_nets(rng, number) if number % 2 else _longitudinal(rng, number), 0.7)


MAKE: tuple[Callable[[np.random.Generator, int], Mechanism], ...] = (
    _swept, _longitudinal, _swept, _nets, _one_flap, _locked, _swept, _drawn,
)  # fmt: skip


def designs(numbers: range) -> Iterator[tuple[int, Mechanism]]:
    """Sheets by number, of all families; what cannot be made is drawn again."""
    for number in numbers:
        rng = np.random.default_rng(number)
        while True:
            try:
                sheet = MAKE[number % len(MAKE)](rng, number // len(MAKE))
            except (OrishellError, AssertionError, StopIteration, IndexError):
                continue
            yield number, sheet
            break


@pytest.mark.parametrize(
    "numbers",
    [
        range(QUICK),
        *(pytest.param(range(k, k + QUICK), marks=thorough) for k in range(QUICK, DESIGNS, QUICK)),
    ],
    ids=lambda numbers: f"{numbers[0]}-",
)
def test_random_designs_have_as_many_as_rigid_bodies(numbers: range) -> None:
    """Two other states than those that are counted, the least of both."""
    for number, sheet in designs(numbers):
        told = find_freedom_of_sheet(sheet)
        mine = min(freedoms_of_panels(sheet, share * sheet.target_drive) for share in (0.37, 0.66))
        assert told.count == mine, number
        assert (told.count == 1) == told.one_motion, number


def test_a_state_with_one_motion_settles_it() -> None:
    """No state has fewer motions than the sheet; where one has more, others are looked at."""
    assert find_freedom_of_sheet(parallel()).states == 1
    assert find_freedom_of_sheet(straight("0*x").without_flaps()).states == 3


@pytest.mark.parametrize("text", ["0*x", "0.1*x + 1"])
def test_rows_of_a_straight_g_fold_by_themselves(text: str) -> None:
    """Nothing joins the rows where columns stay unfolded; a column of flaps joins all of them."""
    found = find_freedom_of_sheet(straight(text).without_flaps())
    assert found.count == found.nearly == 9
    assert (found.lines, found.parts) == ("rows", tuple((row, row) for row in range(1, 10)))
    assert found.in_words() == "9 degrees of freedom: rows 1 to 9 fold by themselves"
    assert find_freedom_of_sheet(straight(text)).one_motion


def test_rows_of_a_strip_fold_by_themselves() -> None:
    """Two columns of vertices, none of which panels surround: a bus shelter of 13 x 2."""
    f, g = graph("-x**2", -1, 1), graph("0*x", 0, 3)
    strip = orthodiagonal_of(
        design_orthodiagonal(f, g, OrthodiagonalPattern(rows=13, columns=2, depth=0.05, flap=0))
    )
    found = find_freedom_of_sheet(strip)
    assert found.count == freedoms_of_panels(strip, 0.5 * strip.target_drive) == 13
    assert found.in_words() == "13 degrees of freedom: rows 1 to 13 fold by themselves"


def test_parts_of_several_rows_are_named_together() -> None:
    """Of two sheets beside each other, along a row that is cut through by a straight crease."""
    found = find_freedom_of_sheet(straight("0*x").without_flaps())
    joined = replace(found, count=2, parts=((1, 4), (5, 5)))
    assert joined.in_words() == "2 degrees of freedom: rows 1 to 4; 5 fold each by themselves"
    unknown = replace(found, count=None)
    assert not unknown.one_motion
    assert "not known" in unknown.in_words()


@pytest.mark.parametrize(("bend", "one"), [(1e-6, False), (1e-2, True)])
def test_couplings_too_weak_to_be_felt_make_no_one_motion(bend: float, one: bool) -> None:
    """A g that rises by 4e-6 of its length folds columns by less than any hinge has play."""
    found = find_freedom_of_sheet(straight(f"{bend}*x**2").without_flaps())
    assert found.count == 1
    assert found.one_motion is one
    assert found.nearly == (1 if one else 9)
    assert ("nearly 9: rows 1 to 9" in found.in_words()) is not one


def swept_straight() -> Mechanism:
    f, g = graph("-0.5*x**2", -1, 1), graph("0.2*x", 0, 4)
    options: Any = {"plane": "bisector", "flap": 0}
    return parallel_of(
        design_parallel_repeating(f, g, ParallelRepeatingPattern(rows=5, columns=4, **options))
    )


@pytest.mark.parametrize("number", led_by(range(6), 3))
def test_whole_boards_have_as_many_as_their_sheet(number: int) -> None:
    """Hinges stand beside the creases: six equations at a vertex in place of three."""
    sheet = (
        flat_foldable(miura_net()),
        upright(5, 6, row="zigzag", flap=0).straightened(),
        parallel(5, 6, plane="bisector", flap=0),
        straight("0*x").without_flaps(),
        swept_straight(),
        flat_foldable(random_net(4, 5, 3)),
    )[number]
    build = PanelSpec(thickness=1e-3 * diagonal(sheet.positions(0.0)), construction="hinged")
    hinges = find_hinges(sheet, build)
    mine = min(freedoms_of_boards(sheet, hinges, x * sheet.target_drive) for x in (0.37, 0.66))
    assert find_freedom_of_sheet(sheet, hinges).count == mine


def test_flaps_that_are_shut_hold_every_row() -> None:
    """At the target every vertex beside a flap is as far closed as it goes."""
    assert held_by_flaps(straight("0*x"))
    assert held_by_flaps(upright())
    assert held_by_flaps(parallel())
    assert not held_by_flaps(straight("0*x").without_flaps())


def test_which_vertices_hold_a_sheet_alone() -> None:
    """As asked of one after the other: all of a sheet with one motion, none of a straight g's."""
    alone = []
    for _, sheet in [*designs(range(3)), (0, swept_straight())]:
        vertices = np.arange(sheet.grid.rows * sheet.grid.columns)
        each = [held_at(sheet, vertices[k : k + 1]) for k in vertices]
        assert hold_alone(sheet, vertices).tolist() == each
        alone.append(sum(each))
    assert min(alone) == 0
    assert max(alone) > 0


@pytest.mark.parametrize("sheet", [upright(), parallel()], ids=["orthodiagonal", "parallel"])
def test_vertices_hold_flaps_that_are_shut_too(sheet: Mechanism) -> None:
    """What stands still between flaps leaves them no way, although none of it moves with them."""
    between, bare = sheet.grid.vertices()[1:-1, 2:-2].ravel(), sheet.without_flaps()
    assert hold_alone(sheet, between).all()
    assert hold_alone(bare, bare.grid.vertices()[1:-1, 1:-1].ravel()).all()
    assert held_at(sheet, between[:1])


def test_the_count_grows_with_the_sheet() -> None:
    """A hundred times as many panels take at most so many times as long, with room for three."""

    def seconds(rows: int, columns: int) -> float:
        sheet = Miura(Grid(rows, columns), np.deg2rad(60), np.deg2rad(50))
        begin = time.process_time()
        assert find_freedom_of_sheet(sheet).one_motion
        return time.process_time() - begin

    seconds(4, 4)  # what is imported
    assert seconds(200, 200) < 3 * 100 * max(seconds(20, 20), 1e-3)
