"""Values of birch plywood of 12 mm against those of 18 mm, by the layup of both.

Both are veneers of 1.4 mm, crossed, an odd number of them, along the grain of the faces outside;
the faces are sanded. What is known of 18 mm: 10048 and 7452 MPa, 40.2 and 34.1 MPa in bending
(Handbook of Finnish Plywood; Metsä Wood, declaration MW/PW/411-001).
"""

from __future__ import annotations

from functools import partial

import numpy as np
import pytest

from orishell.numerics.arrays import Array
from orishell.structure.materials import materials

PLY = 1.4
FACE = 1.1
"""A face when it is sanded (mm): 13 plies are then 17.6 mm, 9 plies 12.0 mm."""
BIRCH = materials()["birch plywood"]
to_rounding = partial(pytest.approx, abs=0.05 + 1e-9)


def layup(plies: int) -> tuple[Array, Array]:
    """Thickness (P,) and middle (P,) of plies, mm from the middle of the board; odd ones along."""
    thick = np.full(plies, PLY)
    thick[[0, -1]] = FACE
    return thick, np.cumsum(thick) - 0.5 * thick - 0.5 * thick.sum()


def shares_of_inertia(plies: int) -> tuple[float, float]:
    """The share of t^3/12 that plies along the grain have, and those across it."""
    thick, middle = layup(plies)
    inertia = thick**3 / 12 + thick * middle**2
    return tuple(inertia[k::2].sum() / inertia.sum() for k in (0, 1))


def of_bending(plies: int, modulus: float, strength: float) -> tuple[float, ...]:
    """Moduli and strengths along and across, by those of a veneer (MPa).

    Stress is that of the whole section, M 6/t^2, as the outermost ply along the grain breaks.
    """
    along, across = shares_of_inertia(plies)
    thick = layup(plies)[0].sum()
    inner = thick / (thick - 2 * FACE)
    return modulus * along, modulus * across, strength * along, strength * across * inner


MODULUS, STRENGTH = 10048 + 7452, 40.2 / shares_of_inertia(13)[0]
"""Of a veneer along its grain, from 18 mm (MPa): 17500 and 70."""


def test_18_mm_follows_from_its_layup() -> None:
    """Two numbers give all four."""
    along, across, bent, bent_across = of_bending(13, MODULUS, STRENGTH)
    assert (along, across) == pytest.approx((10048, 7452), abs=2)
    assert (bent, bent_across) == to_rounding((40.2, 34.1))


def test_bending_of_12_mm() -> None:
    along, across, bent, bent_across = of_bending(9, MODULUS, STRENGTH)
    assert BIRCH.grain is not None
    assert BIRCH.grain_moduli is not None
    for made, found in zip(BIRCH.grain_moduli.bending, (along, across), strict=True):
        assert found - 100 < made / 1e6 <= found
    assert [each / 1e6 for each in BIRCH.grain.bending] == [
        to_rounding(bent),
        to_rounding(bent_across),
    ]


def test_tension_and_compression_of_12_mm() -> None:
    """They are as the area of plies that lie either way; moduli are rounded down."""
    thick, _ = layup(9)
    areas = np.array([thick[k::2].sum() for k in (0, 1)]) / thick.sum()
    assert BIRCH.grain is not None
    assert BIRCH.grain_moduli is not None
    for made, veneer in ((BIRCH.grain.tension, 75), (BIRCH.grain.compression, 52)):
        assert [each / 1e6 for each in made] == [to_rounding(each) for each in veneer * areas]
    for modulus, found in zip(BIRCH.grain_moduli.tension, MODULUS * areas, strict=True):
        assert found - 100 < modulus / 1e6 <= found


def test_rolling_shear_of_12_mm() -> None:
    """The ply that rolls has V S/I; both ways it is the same 2.5 MPa if values are 3 V/2 t."""
    thick, middle = layup(9)
    assert BIRCH.grain is not None
    for bears, made in enumerate(BIRCH.grain.rolling_shear):
        stiff = np.arange(9) % 2 == bears
        inertia = (thick**3 / 12 + thick * middle**2)[stiff].sum()
        rolls = [
            (thick * middle)[stiff & (np.arange(9) > ply)].sum()
            for ply in range(9)
            if not stiff[ply]
        ]
        largest = max(rolls) / inertia
        assert made / 1e6 * largest / (1.5 / thick.sum()) == pytest.approx(2.5, abs=0.005)
