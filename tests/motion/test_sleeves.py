"""Sleeves over rows of random sheets: rigid in all states, one motion, none with a plate.

That a sleeve is a folding sheet as all are, and a sheet with sleeves too, is asked in
``test_contract.py``.
"""

from __future__ import annotations

import numpy as np
import pytest

from mechanisms import complex_of, flat_foldable, miura_net, parallel, sleeves_of
from orishell.motion import Mechanism, diagonal
from orishell.motion.complex import Complex
from orishell.motion.layout import points_of
from orishell.motion.sleeves import Q, R, Sleeve, SleeveForms, W
from rigid_rank import freedoms_of_complex, strained
from samples import THOROUGH
from stiffened import sheet_of

NARROWEST = 0.05
QUICK, ALL = 24, 200


def random_complex(number: int) -> Complex:
    """A random sheet without flaps, every row closed by a random share within the conditions."""
    sheet: Mechanism = sheet_of(number).without_flaps()
    draw, sleeves = np.random.default_rng(number), []
    for row in range(1, sheet.grid.rows - 1):
        forms = SleeveForms.of(sheet, row, slice(0, sheet.grid.columns))
        share = draw.uniform(0.1, 1.0) * min(0.99, forms.largest(NARROWEST))
        sleeves.append(Sleeve.over(sheet, forms, share))
    return Complex(sheet, tuple(sleeves))


@pytest.mark.parametrize("number", range(ALL if THOROUGH else QUICK))
def test_panels_stay_what_they_are(number: int) -> None:
    """All distances in every panel with all that lies on its sides, and its plane, in 40 states."""
    whole = random_complex(number)
    rigid, off = strained(whole)
    assert off < 1e-14
    flat, end, size = points_of(whole, 0.0), whole.end_drive, diagonal(whole.positions(0.0))
    # The sheet's own panels are as rigid as its family makes them.
    own = whole.layout.faces[: whole.grid.panel_count]
    sheet = max(
        np.abs(
            np.linalg.norm(points_of(whole, d)[own] - points_of(whole, d)[own[:, [2]]], axis=-1)
            - np.linalg.norm(flat[own] - flat[own[:, [2]]], axis=-1)
        ).max()
        for d in (0.5 * end, end)
    )
    assert rigid < max(1e-14, 4 * sheet / size)


@pytest.mark.parametrize("number", range(ALL if THOROUGH else 8))
def test_one_motion_and_none_with_a_plate(number: int) -> None:
    whole = random_complex(number)
    alone = freedoms_of_complex(Complex(whole.sheet, ()), whole.target_drive)
    assert freedoms_of_complex(whole, whole.target_drive) == alone
    which = number % len(whole.strips)
    column = number % len(sleeves_of(whole)[which].above)
    if alone == 1:
        assert freedoms_of_complex(whole, whole.target_drive, [(which, column)]) == 0


def test_strips_are_parallel_to_the_panels_on_the_other_side() -> None:
    whole = complex_of(parallel())
    for drive in (0.3, 1.1, whole.target_drive):
        sheet = whole.sheet.positions(drive)
        for sleeve in sleeves_of(whole):
            points, row = sleeve.positions(drive), sleeve.row
            x = sheet[row, sleeve.columns]
            down = sheet[row + 1, sleeve.columns] - x
            up = sheet[row - 1, sleeve.columns] - x
            np.testing.assert_allclose(
                points[W] - points[Q], sleeve.below[:, None] * down, rtol=0, atol=1e-14 * 30
            )
            np.testing.assert_allclose(
                points[W] - points[R], sleeve.above[:, None] * up, rtol=0, atol=1e-14 * 30
            )
            along = np.diff(x, axis=0)
            for line, width in zip(points, sleeve.widths, strict=True):
                np.testing.assert_allclose(
                    np.diff(line, axis=0), width[:, None] * along, rtol=0, atol=1e-13 * 30
                )


def test_the_largest_share_is_where_a_side_is_as_narrow_as_it_may_be() -> None:
    for number in range(QUICK):
        sheet = sheet_of(number).without_flaps()
        forms = SleeveForms.of(sheet, 1, slice(0, sheet.grid.columns))
        for narrowest in (0.05, 0.5):
            share = forms.largest(narrowest)
            if np.isfinite(share):
                assert forms.widths(share).min() == pytest.approx(narrowest, abs=1e-12)
            else:
                assert forms.widths(1.0).min() >= 1 - 1e-12


def test_a_straight_sheet_has_sleeves_as_wide_as_its_creases() -> None:
    """Of Miura-ori columns are parallel: a parallelogram is swept, all shares alike."""
    sheet = flat_foldable(miura_net())
    sleeve = sleeves_of(complex_of(sheet, 0.6))[1]
    np.testing.assert_allclose(sleeve.widths, 1.0, rtol=0, atol=1e-12)
    np.testing.assert_allclose(sleeve.above, 0.6, rtol=0, atol=1e-12)
    np.testing.assert_allclose(sleeve.below, 0.6, rtol=0, atol=1e-12)
