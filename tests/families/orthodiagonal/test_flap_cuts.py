"""Flaps end where the columns end, stay rigid and still meet."""

from typing import Any

import numpy as np
import pytest
import shapely

from orishell.curves import Curve
from orishell.design import Design
from orishell.families.orthodiagonal import (
    Orthodiagonal,
    OrthodiagonalPattern,
    design_orthodiagonal,
)
from orishell.families.orthodiagonal.flaps import SMALLEST_KEPT
from orishell.locking import find_lock
from orishell.motion import FoldingMotion
from orishell.verification.residuals import measure_residuals
from strategies import graph, pair

ELLIPSE = pair("1.55*cos(t)", "2.3*sin(t)", 0, np.pi)
CROSSING = graph("0.1*cos(2*pi*x)", 0, 6)


def shelter(**options: Any) -> Design:
    """Half an ellipse 2.3 high, with flaps as wide as "auto" makes them: 0.5."""
    return design_orthodiagonal(
        ELLIPSE, CROSSING, OrthodiagonalPattern(rows=11, columns=13, **options)
    )


def mechanism_of(design: Design) -> Orthodiagonal:
    assert isinstance(design.mechanism, Orthodiagonal)
    return design.mechanism


def heights(design: Design) -> tuple[np.ndarray, np.ndarray]:
    """Heights at lock of all vertices, and of those without flaps."""
    height = design.mechanism.positions(design.mechanism.target_drive)[..., 2]
    return height, height[:, design.mechanism.inner_columns]


def depth_below_feet(design: Design) -> float:
    """How far flaps reach below the columns that they are beside at lock."""
    height, inner = heights(design)
    return float(inner[:, [0, -1]].min() - height[:, [0, -1]].min())


def meetings(mechanism: Orthodiagonal, column: int) -> np.ndarray:
    """Areas (m,) on which a flap's panels beside each row crease meet, by the smaller panel."""
    locked = mechanism.positions(np.pi)
    t = np.exp(-1j * mechanism.heading)
    along = locked[..., 0] * t.real + locked[..., 1] * t.imag
    plane = np.stack([along, locked[..., 2]], axis=-1)[:, [column, column + 1]]
    corners = np.stack([plane[:-1, 0], plane[1:, 0], plane[1:, 1], plane[:-1, 1]], axis=1)
    panels = np.asarray(shapely.polygons(corners), dtype=object)
    assert shapely.is_valid(panels).all()
    both = np.minimum(shapely.area(panels[1:]), shapely.area(panels[:-1]))
    return np.asarray(shapely.area(shapely.intersection(panels[1:], panels[:-1])) / both)


def test_flaps_of_an_arch_end_level_with_its_feet() -> None:
    design = shelter()
    mechanism = mechanism_of(design)
    height, inner = heights(design)
    assert (mechanism.kept < 1).any()
    assert design.parameters["ends"] == ["level", "level"]
    np.testing.assert_allclose(height[[0, -1]], inner.min(), atol=1e-12)
    assert height.min() == pytest.approx(inner.min(), abs=1e-12)
    # Whole they reach 0.2 below; before they were cut they made the ends square, and reached 1.05.
    whole = design_orthodiagonal(
        ELLIPSE, CROSSING, OrthodiagonalPattern(rows=11, columns=13, flap=0.2)
    )
    assert (mechanism_of(whole).kept == 1).all()


def test_cut_flaps_still_meet_along_every_row() -> None:
    mechanism = mechanism_of(shelter())
    for column in (0, mechanism.grid.columns - 2):
        # The whole flaps of the other rows meet on 0.33 to 0.5 of their panels.
        assert meetings(mechanism, column).min() > 0.3
    assert mechanism.kept.min() >= 0.5 * SMALLEST_KEPT


def test_cut_flaps_are_rigid_and_lock() -> None:
    design = shelter()
    motion = FoldingMotion(design.mechanism, 9)
    residuals, assignment = measure_residuals(motion, motion.flat)
    assert max(residuals.panel_length, residuals.planarity) < 1e-14
    assert residuals.fold_angle_rad < 1e-12
    assert assignment.maekawa
    lock = find_lock(design)
    assert lock.cause == "flaps"
    assert lock.path is not None


@pytest.mark.parametrize("flap", [0.3, 0.6, 2.0])
def test_the_wider_the_flaps_the_more_is_cut(flap: float) -> None:
    f = pair("2.5*cos(t)", "3*sin(t)", 0, np.pi)
    design = design_orthodiagonal(
        f, graph("0*x", 0, 6), OrthodiagonalPattern(rows=7, columns=3, flap=flap)
    )
    height, inner = heights(design)
    assert height.min() == pytest.approx(inner.min(), abs=1e-12)
    assert (mechanism_of(design).kept < 1).any() == (flap == 2.0)


@pytest.mark.parametrize(
    ("f", "g", "flap", "sides", "depth"),
    [
        (graph("-x**2", -0.5, 1.5), graph("0.1*sin(2*x)", 0, 4), 0.4, ("end", "start"), 0.596),
        (graph("-2*x**2", -0.5, 1.5), graph("0*x", 0, 4), 0.4, ("end", "end"), 0.842),
        (graph("0.5*x + 0.2*sin(2*x)", 0, 2), graph("0.1*x", 0, 4), 0.2, ("start", "start"), 0.274),
    ],
)
def test_a_side_that_stays_clear_is_chosen(
    f: Curve, g: Curve, flap: float, sides: Any, depth: float
) -> None:
    """Asked for, the flaps reach so far below the feet; left open, they do not."""
    options: dict[str, Any] = {"rows": 9, "columns": 7, "flap": flap}
    asked = design_orthodiagonal(f, g, OrthodiagonalPattern(**options, flap_side=sides))
    assert depth_below_feet(asked) == pytest.approx(depth, abs=1e-3)
    assert depth_below_feet(design_orthodiagonal(f, g, OrthodiagonalPattern(**options))) < 1e-12


def test_flaps_that_no_trim_helps_are_not_cut() -> None:
    """An end that no plane cuts off: flaps asked to fold there stay whole and reach below."""
    options: dict[str, Any] = {"flap": 0.4, "flap_side": "end"}
    f, g = graph("-2*x**2", -0.5, 1.5), graph("0*x", 0, 4)
    design = design_orthodiagonal(f, g, OrthodiagonalPattern(rows=9, columns=7, **options))
    ends = design.parameters["ends"]
    assert isinstance(ends, list)
    assert "untrimmed" in ends
    assert (mechanism_of(design).kept == 1).all()
    assert depth_below_feet(design) > 0.1
