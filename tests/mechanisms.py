"""Sheets of every family, and the list of those that keep the contract of a ``Mechanism``.

``tests/motion/test_contract.py`` asks the same of all: a new family joins by a line here.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from hypothesis import assume
from hypothesis import strategies as st

from orishell.design import Design
from orishell.families.drawn.mechanism import DrawnSheet
from orishell.families.drawn.sheet import drawn_sheet
from orishell.families.flat_foldable.locks.flaps import FlapColumns
from orishell.families.flat_foldable.locks.straight import straight_bordered, with_parallel_borders
from orishell.families.flat_foldable.mechanism import FlatFoldable
from orishell.families.flat_foldable.named import graded_net
from orishell.families.flat_foldable.net import Net
from orishell.families.longitudinal_linear_repeating import (
    LongitudinalLinearRepeating,
    RowKind,
    Sectors,
    find_solutions,
)
from orishell.families.longitudinal_linear_repeating.sheet import with_fitting_border
from orishell.families.longitudinal_linear_repeating.tessellation.columns import (
    Directions,
    repeat_columns,
)
from orishell.families.longitudinal_linear_repeating.tessellation.even_lengths import (
    Wanted,
    find_even_lengths,
)
from orishell.families.longitudinal_linear_repeating.tessellation.lengths import InnerLengths
from orishell.families.orthodiagonal import (
    Orthodiagonal,
    OrthodiagonalPattern,
    design_orthodiagonal,
)
from orishell.families.parallel_repeating import (
    ParallelRepeating,
    ParallelRepeatingPattern,
    design_parallel_repeating,
)
from orishell.motion import Mechanism, find_assignment
from orishell.motion.complex import Complex
from orishell.motion.grid import Grid
from orishell.motion.skins import Skin
from orishell.motion.sleeves import Sleeve, SleeveForms
from strategies import Request, graph, orthodiagonal_requests, requests
from toy_family import Miura

PARABOLA, WAVE = graph("-x**2", -1, 1), graph("0.25*sin(pi*x/2)", 0, 4)
LEANING = graph("0.5*x + 0.2*sin(2*x)", 0, 3)
PAPER = (85.0, 80.0, 95.0, 100.0)
SINE = (85.0, 80.0, 85.0, 100.0)
ROTATED = 1e-14, 1e-14
NEAR = (89.95, 89.9, 90.05, 90.1)


def parallel_of(design: Design) -> ParallelRepeating:
    assert isinstance(design.mechanism, ParallelRepeating)
    return design.mechanism


def orthodiagonal_of(design: Design) -> Orthodiagonal:
    assert isinstance(design.mechanism, Orthodiagonal)
    return design.mechanism


def parallel(
    rows: int = 9, columns: int = 11, *, scale: float = 1.0, **options: Any
) -> ParallelRepeating:
    """Figure 1 of the paper, by and large."""
    f, g = PARABOLA.scaled(scale), graph("5*sin(pi*x/10)", 0, 20).scaled(scale)
    flap = {"flap": 0.3 * scale} if scale != 1 else {}
    chosen = {"xi_deg": 50, **flap, **options}
    return parallel_of(
        design_parallel_repeating(
            f, g, ParallelRepeatingPattern(rows=rows, columns=columns, **chosen)
        )
    )


def upright(
    rows: int = 9, columns: int = 13, *, scale: float = 1.0, **options: Any
) -> Orthodiagonal:
    """A symmetric f: the middle row is level."""
    f, g = PARABOLA.scaled(scale), WAVE.scaled(scale)
    chosen = {"depth": 0.12 * scale, "flap": 0.15 * scale, **options}
    return orthodiagonal_of(
        design_orthodiagonal(f, g, OrthodiagonalPattern(rows=rows, columns=columns, **chosen))
    )


def leaning(**options: Any) -> Orthodiagonal:
    """An asymmetric f, so that the middle row is tilted."""
    return orthodiagonal_of(
        design_orthodiagonal(LEANING, WAVE, OrthodiagonalPattern(rows=9, columns=12, **options))
    )


def straight(text: str) -> Orthodiagonal:
    """A straight g, whose columns do not fold."""
    return orthodiagonal_of(
        design_orthodiagonal(PARABOLA, graph(text, 0, 4), OrthodiagonalPattern(rows=9, columns=7))
    )


def longitudinal(
    degrees: tuple[float, ...] = PAPER,
    rows: int = 5,
    columns: int = 6,
    first_row: RowKind = "F",
    solution: int = 0,
    *,
    equal: bool = False,
) -> LongitudinalLinearRepeating:
    """A sheet of some sectors, with lengths that are as even as they can be, or begin equal."""
    chosen = find_solutions(Sectors.from_degrees(degrees))[solution]
    made = repeat_columns(chosen, columns)
    directions = Directions.of(made, rows, first_row)
    inner = (
        InnerLengths.marched(directions, np.ones(columns - 1), np.ones(rows - 1))
        if equal
        else find_even_lengths(directions, Wanted())
    )
    assert inner is not None
    return with_fitting_border(made, first_row, inner, (0.02, 0.02), "auto")


def enlarged(sheet: LongitudinalLinearRepeating, scale: float) -> LongitudinalLinearRepeating:
    lengths = type(sheet.lengths)(scale * sheet.lengths.row, scale * sheet.lengths.column)
    return LongitudinalLinearRepeating(sheet.columns, sheet.first_row, lengths)


def random_net(rows: int, columns: int, seed: int, *, mixed: bool = False) -> Net:
    """A sheet near a Miura-ori sheet, the nearer the larger it is: its lists depart in waves.

    If mixed, the row creases of every third row fold less than the columns do: as those rows are
    straight, and others zigzag across the columns, panels between them are wedges, and long.
    """
    rng = np.random.default_rng(seed)
    degrees = np.full(rows, 85.0)
    if mixed:
        degrees[1 + rows // 2 :: 3] = degrees[rows // 2 - 2 :: -3] = 15.0
    longer = 1 + 0.4 * columns if mixed else 1.0
    net = graded_net(
        rows, columns, folds=list(np.deg2rad(degrees)), sectors=[1.1], column_lengths=[longer]
    )

    def waves(count: int, size: float) -> np.ndarray:
        along, parts = np.linspace(0, np.pi, count), np.arange(1, 4)
        phases, sizes = rng.uniform(0, 6, (3, 1)), rng.uniform(-size, size, 3)
        return np.asarray(sizes @ np.cos(np.outer(parts, along) + phases))[:, None]

    small = 0.2 / max(rows, columns, 6)
    row, column = (
        angles + waves(len(angles), small) for angles in (net.row_angles, net.column_angles)
    )
    column[net.middle[0]] = row[net.middle[1]]
    return replace(
        net,
        x=net.x * np.exp(waves(rows, small)),
        y=net.y * np.exp(waves(columns, small)),
        row_angles=row,
        column_angles=column,
        row_lengths=np.exp(waves(columns - 1, 0.1)),
        column_lengths=longer * np.exp(waves(rows - 1, 0.1)),
    )


TURNED: dict[str, Any] = {
    "heading": 0.7,
    "turn": np.array([0.3, -0.4, 0.8]),
    "place": np.array([1.0, -2.0, 0.5]),
}


def flat_foldable(net: Net, scale: float = 1.0, **pose: Any) -> FlatFoldable:
    """The sheet of a net, enlarged."""
    lengths = ("row_lengths", "column_lengths", "top", "bottom", "left", "right")
    scaled = replace(net, **{name: scale * getattr(net, name) for name in lengths})
    if "place" in pose:
        pose = {**pose, "place": scale * pose["place"]}
    return FlatFoldable(scaled.march(), **pose)


def of_flat_foldable(net: Net, **pose: Any) -> Sample:
    return Sample(
        lambda: flat_foldable(net, **pose),
        lambda scale: flat_foldable(net, scale, **pose),
        rounding=(1e-14, 1e-15),
    )


def with_flap_columns(
    net: Net, widths: tuple[float, float] = (0.0, 0.4), scale: float = 1.0, **pose: Any
) -> FlapColumns:
    """A sheet with flaps, its last column the straight border beside which they stand."""
    bare = flat_foldable(straight_bordered(net).net, scale, **pose)
    left, right = widths
    return FlapColumns(bare, (scale * left, scale * right))


def arch_with_flaps(scale: float = 1.0, **pose: Any) -> FlapColumns:
    """An arch with flaps on both sides."""
    net = graded_net(6, 5, folds=list(np.deg2rad([80, 55])), sectors=[1.0])
    bare = flat_foldable(with_parallel_borders(net), scale, **pose)
    return FlapColumns(bare, (0.3 * scale, 0.4 * scale))


def miura_net(rows: int = 5, columns: int = 6) -> Net:
    return graded_net(rows, columns, folds=[np.deg2rad(80)], sectors=[np.deg2rad(60)])


def drawn_from(sheet: Mechanism, share: float, scale: float = 1.0) -> DrawnSheet:
    """The flat sheet of a mechanism, folded to a share of the way to where a crease closes."""
    flat = scale * sheet.positions(0.0)[..., :2]
    return drawn_sheet(flat, find_assignment(sheet), share * np.pi)


def of_drawn(sheet: Callable[[], Mechanism], share: float, **options: Any) -> Sample:
    return Sample(
        lambda: drawn_from(sheet(), share),
        lambda scale: drawn_from(sheet(), share, scale),
        rounding=(1e-14, 1e-15),
        **options,
    )


def sleeve_over(sheet: Mechanism, row: int, share: float = 0.8) -> Sleeve:
    """A sleeve over a row of a sheet, of a share or as much as leaves strips a tenth as wide."""
    forms = SleeveForms.of(sheet, row, slice(0, sheet.grid.columns))
    return Sleeve.over(sheet, forms, min(share, forms.largest(0.1)))


def complex_of(sheet: Mechanism, share: float = 0.8) -> Complex:
    """A sheet with sleeves over all its rows."""
    rows = range(1, sheet.grid.rows - 1)
    return Complex(sheet, tuple(sleeve_over(sheet, row, share) for row in rows))


def sleeves_of(whole: Complex) -> list[Sleeve]:
    """The sleeves among the strips of a complex."""
    return [each for each in whole.strips if isinstance(each, Sleeve)]


def skin_of(sheet: Mechanism) -> Complex:
    """A sheet on a lattice, its flaps left out, with a second skin and all its walls."""
    sheet = sheet.without_flaps()
    skin = Skin.under(sheet, slice(0, sheet.grid.columns), None)
    return Complex(sheet, skin.carried(skin.walls()))


@dataclass(frozen=True)
class Sample:
    """A sheet that keeps the contract, by the same curves or sectors at any scale."""

    make: Callable[[], Mechanism]
    enlarged: Callable[[float], Mechanism] | None = None
    rounding: tuple[float, float] = (0.0, 0.0)  # of positions and folds, alone and together
    steady: tuple[float, float] = (0.0, 1.0)  # shares of the way over which no state jumps
    residual: float = 1e-12  # relative, of lengths


def of_longitudinal(*arguments: Any) -> Sample:
    return Sample(
        lambda: longitudinal(*arguments),
        lambda scale: enlarged(longitudinal(*arguments), scale),
        rounding=(1e-14, 0.0),
        steady=(0.1, 0.5),  # it moves without bounds where a crease folds flat
        residual=1e-11,
    )


SAMPLES: dict[str, Sample] = {
    "parallel": Sample(parallel, lambda scale: parallel(scale=scale, flap=0.3 * scale)),
    "parallel, oblique": Sample(lambda: parallel(plane_deg=70, flap_side=["start", "end"])),
    "parallel, no inflection": Sample(lambda: parallel(columns=12)),
    "parallel, no flaps": Sample(lambda: parallel(flap=0)),
    "parallel, one row": Sample(lambda: parallel(rows=1, columns=4)),
    "orthodiagonal": Sample(upright, lambda scale: upright(scale=scale), rounding=ROTATED),
    "orthodiagonal, leaning": Sample(leaning, rounding=ROTATED),
    "orthodiagonal, no flaps": Sample(lambda: upright(flap=0), rounding=ROTATED),
    "orthodiagonal, g straight": Sample(lambda: straight("0*x"), rounding=ROTATED),
    "orthodiagonal, g oblique": Sample(lambda: straight("0.1*x + 1"), rounding=ROTATED),
    **{
        f"longitudinal, {rows} x {columns} from {first}": of_longitudinal(
            PAPER, rows, columns, first
        )
        for rows, columns in [(1, 2), (1, 7), (2, 2), (4, 3), (5, 6), (9, 9)]
        for first in ("F", "S")
    },
    **{
        f"longitudinal, sine from {first}": of_longitudinal(SINE, 5, 5, first, 1)
        for first in ("F", "S")
    },
    "flat-foldable, Miura": of_flat_foldable(miura_net()),
    "flat-foldable, one row": of_flat_foldable(random_net(1, 4, 1), **TURNED),
    "flat-foldable, one column": of_flat_foldable(random_net(4, 1, 1), **TURNED),
    "flat-foldable": of_flat_foldable(random_net(6, 5, 2)),
    "flat-foldable, turned": of_flat_foldable(random_net(6, 5, 2), **TURNED),
    "flat-foldable, mixed": of_flat_foldable(random_net(7, 6, 3, mixed=True), **TURNED),
    "flat-foldable, flaps on both sides": Sample(
        arch_with_flaps, arch_with_flaps, rounding=(1e-14, 1e-15)
    ),
    "flat-foldable, flaps": Sample(
        lambda: with_flap_columns(random_net(6, 6, 4), **TURNED),
        lambda scale: with_flap_columns(random_net(6, 6, 4), scale=scale, **TURNED),
        rounding=(1e-14, 1e-15),
    ),
    "flat-foldable, one row with flaps": Sample(lambda: with_flap_columns(random_net(1, 3, 4))),
    "drawn, parallel repeating": of_drawn(parallel, 0.8),
    "drawn, longitudinal": of_drawn(longitudinal, 0.9),
    "drawn, flat-foldable": of_drawn(lambda: flat_foldable(random_net(6, 5, 2)), 0.9),
    "toy": Sample(lambda: Miura(Grid(5, 6), np.deg2rad(60), np.deg2rad(50))),
    "sleeve, parallel": Sample(lambda: sleeve_over(parallel(), 4)),
    "sleeve, longitudinal": Sample(
        lambda: sleeve_over(longitudinal(), 2), rounding=(1e-14, 0.0), steady=(0.1, 0.5)
    ),
    "sleeve, flat-foldable": Sample(
        lambda: sleeve_over(flat_foldable(random_net(6, 5, 2)), 3), rounding=(1e-14, 1e-15)
    ),
    "skin, parallel": Sample(lambda: skin_of(parallel()).strips[0]),
    "wall, parallel": Sample(lambda: skin_of(parallel()).strips[2]),
}
"""Of every family the kinds of sheets that its closed form tells apart; what they carry."""
CLOSED = [name for name in SAMPLES if not name.startswith("wall")]
"""Those with inner vertices, about which panels close."""
COMPLEXES = {
    "sheet with sleeves": Sample(
        lambda: complex_of(flat_foldable(random_net(6, 5, 2))), rounding=(1e-14, 1e-15)
    ),
    "sheet with a second skin": Sample(lambda: skin_of(parallel())),
}
"""More than two panels meet at a line: what folds as a sheet, and is none."""


@st.composite
def longitudinal_sheets(draw: st.DrawFn) -> Mechanism:
    """Sheets of 3 x 4 inner vertices, of both versions: they exist for most angles."""
    angle = st.floats(75, 105).map(lambda x: round(x, 3))
    degrees = tuple(draw(st.lists(angle, min_size=4, max_size=4)))
    first: RowKind = draw(st.sampled_from(["F", "S"]))
    solutions = find_solutions(Sectors.from_degrees(degrees))
    assume(solutions)
    number = draw(st.integers(0, len(solutions) - 1))
    directions = Directions.of(repeat_columns(solutions[number], 4), 3, first)
    inner = find_even_lengths(directions, Wanted())
    assume(inner is not None and inner.ratio < 100)
    return longitudinal(degrees, 3, 4, first, number)


def mechanism_of(request: Request) -> Mechanism:
    """Every request works, or works with the nearest value that the error names."""
    return request.feasible().mechanism


@dataclass(frozen=True)
class Kind:
    """Any sheet of a family, in how many examples, and its residuals.

    Angles lose what the rounding of coordinates takes from the shortest edge, and where columns may
    be near each other from what is between them.
    """

    sheets: st.SearchStrategy[Mechanism]
    count: int
    lengths: float = 1e-12
    angles: float = 1e-12
    slim: bool = False


DRAWN: dict[str, Kind] = {
    "parallel": Kind(requests().map(mechanism_of), 150),
    "orthodiagonal": Kind(orthodiagonal_requests().map(mechanism_of), 150, slim=True),
    "longitudinal": Kind(longitudinal_sheets(), 60, 1e-11, 1e-9),
    "flat-foldable": Kind(
        st.builds(
            lambda seed, mixed: flat_foldable(random_net(5, 4, seed, mixed=mixed), **TURNED),
            st.integers(0, 10**6),
            st.booleans(),
        ),
        60,
    ),
    "flat-foldable, flaps": Kind(
        st.builds(
            lambda seed, stop: with_flap_columns(random_net(5, 5, seed), **TURNED).with_stop(stop),
            st.integers(0, 10**6),
            st.floats(0.0, 0.5),
        ),
        60,
    ),
    "toy": Kind(
        st.builds(
            lambda gamma, target: Miura(Grid(4, 5), gamma, target),
            st.floats(0.05, 1.5),
            st.floats(0.05, 1.5),
        ),
        20,
    ),
}
