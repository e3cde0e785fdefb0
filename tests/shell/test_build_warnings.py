"""What a builder is told: each sentence where it is deserved, and not where it is not."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from orishell.curves import Curve, curve_from_points
from orishell.deployment.feet import find_feet
from orishell.design import Design, PanelSpec
from orishell.design_file import check_design, read_design_file
from orishell.deviation import locked_shell
from orishell.families.longitudinal_linear_repeating import (
    LongitudinalPattern,
    design_longitudinal_linear_repeating,
)
from orishell.families.orthodiagonal import OrthodiagonalPattern, design_orthodiagonal
from orishell.families.parallel_repeating import ParallelRepeatingPattern, design_parallel_repeating
from orishell.locking import lock_without_clash
from orishell.shell.board_warnings import SAW
from orishell.shell.build_warnings import (
    ABOVE,
    BELOW,
    BESIDE,
    DEEP,
    UNEVEN,
    WASTEFUL,
    warn_of_building,
)
from orishell.shell.designed import designed
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES
from orishell.workshop import Workshop
from strategies import graph, pair

EXAMPLES = Path(__file__).parents[2] / "examples"
PARABOLA, LINE = graph("-x**2", -1, 1), graph("0*x", 0, 4)
WAVE = graph("0.25*sin(pi*x/2)", 0, 4)
ELLIPSE = pair("2.5*cos(t)", "3*sin(t)", 0, np.pi)


def caveats(design: Design, unit: str = "m", **workshop: Any) -> list[str]:
    lock, feet = lock_without_clash(design), find_feet(design)
    return warn_of_building(design, lock, feet, unit, Workshop(**workshop))


def matching(design: Design, words: str, unit: str = "m", **workshop: Any) -> list[str]:
    return [each for each in caveats(design, unit, **workshop) if words in each]


def parallel(f: Curve = PARABOLA, g: Curve = WAVE, **options: Any) -> Design:
    defaults = {"rows": 9, "columns": 7, "flap": 0.2, "xi_deg": 50}
    return design_parallel_repeating(f, g, ParallelRepeatingPattern(**{**defaults, **options}))


def orthodiagonal(f: Curve = PARABOLA, g: Curve = WAVE, **options: Any) -> Design:
    defaults = {"rows": 9, "columns": 13, "flap": 0.15, "depth": 0.12}
    return design_orthodiagonal(f, g, OrthodiagonalPattern(**{**defaults, **options}))


def heights(design: Design) -> tuple[float, float, float]:
    """Height of the shell, and how far its flaps reach below and above it."""
    shell = design.mechanism.positions(design.mechanism.target_drive)[..., 2]
    inner = locked_shell(design)[..., 2]
    return (
        float(np.ptp(inner)),
        float(inner.min() - shell.min()),
        float(shell.max() - inner.max()),
    )


def test_flaps_below_the_feet() -> None:
    f, g = graph("-2*x**2", -0.5, 1.5), graph("0*x", 0, 4)
    options: dict[str, Any] = {"columns": 2, "depth": "auto", "flap": 0.4}
    design = orthodiagonal(f, g, **options, flap_side=["end", "end"])
    size, below, _ = heights(design)
    assert below > BELOW * size
    (text,) = matching(design, "the flaps reach")
    assert text.startswith(f"the flaps reach {below:.3g} m below the ")
    assert "flap_side" in text
    other = orthodiagonal(f, g, **options)  # the side that stays clear
    assert heights(other)[1] == pytest.approx(0, abs=1e-12)
    assert matching(other, "m below the") == []


def test_flaps_above_the_crown() -> None:
    wide, narrow = (
        orthodiagonal(ELLIPSE, LINE, rows=7, columns=2, depth="auto", flap=flap)
        for flap in (2.0, 0.2)
    )
    size, _, above = heights(wide)
    assert above > ABOVE * size
    assert matching(wide, f"the flaps reach {above:.3g} m above the top")
    assert heights(narrow)[2] < ABOVE * heights(narrow)[0]
    assert matching(narrow, "the flaps reach") == []


def test_flaps_beside_the_feet() -> None:
    """Parallel repeating flaps move level along f's plane, by their width at the most."""
    wide, narrow = parallel(flap=0.7), parallel(flap=0.3)
    (text,) = matching(wide, "beyond the foot")
    reach = float(text.split()[3])
    assert BESIDE * 2 < reach <= 0.8
    assert matching(narrow, "beyond the foot") == []


def test_strips_of_the_third_family_are_not_called_flaps() -> None:
    f = pair("cos(t)", "sin(t)", 0.3, 2.8416)
    design = design_longitudinal_linear_repeating(
        f,
        graph("0*x", 0, 2.93),
        LongitudinalPattern(rows=7, columns=9, sector_deg=[85, 80, 95, 100]),
    )
    assert not any("flaps reach" in each for each in caveats(design))


def test_feet_that_are_not_level() -> None:
    lopsided = parallel(graph("-x**2", -1, 0.8))
    feet = find_feet(lopsided)
    assert feet is not None
    (text,) = matching(lopsided, "feet are not level")
    assert f"rows {feet.rows[0]} and {feet.rows[1]} differ by 0.36 m" in text  # 1 - 0.64
    assert "f's ends differ by 0.36 m" in text
    untrimmed = orthodiagonal(rows=19, depth=0.06)
    assert untrimmed.parameters["ends"] == ["untrimmed", "untrimmed"]
    (text,) = matching(untrimmed, "feet are not level")
    assert "narrower flaps" in text
    for level in (parallel(), orthodiagonal()):
        feet = find_feet(level)
        assert feet is not None
        assert feet.uneven < UNEVEN * feet.height
        assert matching(level, "feet") == []
    assert matching(parallel(graph("x**2", -1, 1)), "feet") == []  # it has none


def test_a_sheet_much_larger_than_its_surface() -> None:
    def ratio(design: Design) -> float:
        flat = design.mechanism.positions(0.0)
        outline = np.concatenate([flat[0], flat[1:, -1], flat[-1, -2::-1], flat[-2:0:-1, 0]])
        x, y = outline[:, 0], outline[:, 1]
        area = 0.5 * abs((x * np.roll(y, -1) - y * np.roll(x, -1)).sum())
        return float(area / design.surface.area())

    deep, shallow = parallel(graph("-0.3*x**2", -1, 1)), parallel(xi_deg=53)
    for design in (deep, shallow, orthodiagonal(depth=0.3), orthodiagonal()):
        words = f"the sheet is {ratio(design):.2f} times as large as the surface"
        assert bool(matching(design, words)) == (ratio(design) > WASTEFUL)
    assert ratio(deep) > WASTEFUL
    assert ratio(orthodiagonal()) < WASTEFUL
    assert "a wider xi_deg (50 now, possible below " in matching(deep, "times as large")[0]
    assert "an f with less steep ends" in matching(parallel(xi_deg=53), "times as")[0]


@pytest.mark.parametrize("design", [parallel, orthodiagonal])
def test_columns_that_a_straight_g_leaves_unfolded(design: Any) -> None:
    many, two = design(g=LINE, columns=7), design(g=LINE, columns=2)
    (text,) = matching(many, "unfolded")
    assert text.startswith("5 of 7 columns stay unfolded because g is straight: 2 columns suffice")
    assert matching(two, "unfolded") == []
    # They do: it is the same shell.
    np.testing.assert_allclose(
        locked_shell(many)[:, [0, -1]], locked_shell(two), atol=1e-12, rtol=0
    )


def test_columns_on_a_straight_part_and_where_g_bends_back() -> None:
    bent = curve_from_points([[0.0, 0.0], [4.0, 0.0], [7.0, 1.5]], smooth=False)
    (text,) = matching(parallel(g=bent, columns=9), "unfolded")
    assert "fewer columns suffice" in text
    # The middle column of a wave is unfolded, too: there g bends from one side to the other.
    assert matching(orthodiagonal(), "unfolded") == []
    assert matching(orthodiagonal(g=graph("0.02*x**2", 0, 4)), "unfolded") == []


def test_a_sheet_larger_than_any_board() -> None:
    large, small = orthodiagonal(), parallel(g=graph("0.1*x**2", 0, 1), f=PARABOLA.scaled(0.25))
    words = "larger than any board (the largest plywood commonly sold is "
    assert matching(large, f"{words}3.05 x 1.525 m)")
    assert matching(large, words, stock=(2.44, 1.22)) == []
    assert matching(small, words) == []
    # 4.4 x 3.9 feet are not too large.
    assert matching(large, words, unit="ft") == []


def test_a_membrane_is_not_sold_as_boards_are() -> None:
    """Cloth of 1.5 m is, and it says nothing of a sheet that fits the boards, or has none."""
    large, words = orthodiagonal(), "is split for sheets of 2.44 x 1.22 m, as boards are"
    cloth = replace(large, panel=PanelSpec(thickness=0.02, membrane=0.001))
    assert matching(cloth, words, stock=(2.44, 1.22))
    assert matching(cloth, words, stock=(2.44, 1.22), roll=(1.5, 50)) == []
    assert matching(cloth, words, stock=(24.4, 12.2)) == []
    assert matching(cloth, words) == []
    assert matching(large, words, stock=(2.44, 1.22)) == []
    solid = PanelSpec(construction="bevel", thickness=0.02, gap=0.002)
    assert matching(replace(large, panel=solid), words, stock=(2.44, 1.22)) == []


def test_chamfers_steeper_than_saws_make() -> None:
    # With next to no gap a chamfer is half the fold angle of its crease.
    design = parallel(rows=9, columns=11, xi_deg=50, flap=0)
    folds = design.mechanism.fold_angles(design.mechanism.target_drive)
    half = np.rad2deg(np.abs(folds.on_edges())) / 2
    assert half.max() > SAW
    solid = replace(design, panel=PanelSpec(thickness=0.02, construction="bevel", gap=1e-9))
    (said,) = matching(solid, "chamfers lean")
    assert f"up to {half.max():.3g}:" in said
    # Each of the two panels beside a crease has one.
    assert said.startswith(f"{2 * (half > SAW).sum()} of ")
    assert not matching(solid, "larger than any board")
    assert not matching(
        replace(design, panel=PanelSpec(thickness=0.02, membrane=0.001)), "chamfers lean"
    )


def test_folds_that_hide_the_curve() -> None:
    deep, shallow = parallel(graph("-0.3*x**2", -1, 1)), orthodiagonal()
    for design, deserved in ((deep, True), (shallow, False)):
        depth, size = lock_without_clash(design).corrugation_depth, heights(design)[0]
        assert (depth > DEEP * size) == deserved
        share = f"{100 * depth / size:.2g} %"
        words = f"the folds are {share} as deep as the shell is high ({depth:.3g} of {size:.3g} m)"
        assert bool(matching(design, words)) == deserved


BOARD, LEVEL, SIZE, FOLDS = "any board", "not level", "times as large", "the folds are"


@pytest.mark.parametrize(
    ("name", "deserved"),
    [
        ("canopy", [BOARD]),
        ("figure1", [SIZE, BOARD]),
        ("figure2", [BOARD]),
        ("figure3", [LEVEL, BOARD]),
        ("from_dxf", [SIZE, BOARD, FOLDS]),
        ("from_svg", [BOARD]),
        ("shelter", []),
        ("tunnel", [BOARD]),
        ("vault", [LEVEL, BOARD]),
    ],
)
def test_shipped_examples_draw_what_they_deserve(name: str, deserved: list[str]) -> None:
    """All but the shelter, which names its boards, are far larger than a board."""
    file = read_design_file(EXAMPLES / f"{name}.toml")
    shell = make_shell(file, clash="unexamined", skip=MEASURES)
    texts = shell.report.warnings
    assert len(texts) == len(deserved)
    assert all(words in text for words, text in zip(deserved, texts, strict=True))


def fitted(formula: str, half: float, **pattern: Any) -> Design:
    """A sheet of 5 x 5 panels on z(x, y) over a square."""
    sides = {"x": [-half, half], "y": [-half, half]}
    tables = {
        "shell": {"family": "flat-foldable", "unit": "m"},
        "target": {"surface": {"formula": formula, **sides}},
        "pattern": {"rows": 4, "columns": 4, "fold_deg": 92, "direction_deg": 0, **pattern},
    }
    return designed(check_design(tables, Path("shell.toml"), files=False))


def test_a_fitted_sheet_is_put_on_its_corners_where_that_levels_it() -> None:
    dome = "-0.4*x**2-0.4*y**2"
    (text,) = matching(fitted(dome, 0.6), "not level")
    assert text.endswith(
        'it can stand on its four corners, at one height (ground = "corners" in [pattern])'
    )
    feet = find_feet(fitted(dome, 0.6, ground="corners"))
    assert feet is not None
    assert feet.level
    (text,) = matching(replace(fitted(dome, 0.6), grounded=None), "not level")
    assert text.endswith("trim the last panels at the ground, or build the ground up to them")


def test_of_a_fitted_sheet_that_is_large_nothing_is_promised() -> None:
    """Neither other fold angles at the start nor other directions made fits smaller by much."""
    (text,) = matching(fitted("0.5*x*y", 1.0), "times as large")
    assert text.endswith("as large as the surface that it covers")
