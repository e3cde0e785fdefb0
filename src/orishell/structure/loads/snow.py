"""Snow, EN 1991-1-3: s = mu C_e C_t s_k on plan areas.

Folds hold the snow that would slide off a smooth vault: the next panel stands in its way, as a
fence does, and 5.3.2 then has mu at least 0.8 on any slope. So how steep a panel is does not
matter: undrifted, mu is 0.8 all over, and drifts are spread over the whole width between the feet.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.quantities import plain
from orishell.numerics.arrays import Array
from orishell.numerics.equals import first_largest
from orishell.structure.load_settings import Snow
from orishell.structure.loads.cases import Effect, Scale, load
from orishell.structure.loads.exposure import UP, Exposure

LYING = 0.8
"""mu_1 of 5.3.2, up to 30 degrees and wherever snow does not slide off."""
FULL = np.deg2rad(30)
"""The slope from which valleys between such slopes hold the most (radians)."""
DEEPEST = 1.6
"""mu_2 of 5.3.4 at valleys between slopes of 30 degrees or more."""

GROUND = (50.0, 30e3)
"""Half the least of the maps of EN 1991-1-3, 100 N/m2; three times what lies at 1500 m in the Alps
(N/m2)."""


def _doubt(asked: Snow, scale: Scale) -> str:
    if GROUND[0] <= asked.ground / scale.area <= GROUND[1]:
        return ""
    return f"snow of {asked.ground:g} on the ground is {scale.per_area(asked.ground)}"


@load("snow", _doubt)
def snow(exposure: Exposure, asked: Snow) -> Effect:
    """Down on the plan of panels.

    Raises InputError: If a cylinder has no feet.
    """
    level = np.clip(exposure.outer()[:, 2], 0, 1)
    arranged = asked.arrangements[0]
    if arranged.arrangement == "undrifted":
        share = np.full(len(level), LYING)
        rule = "undrifted, mu = 0.8 all over, as folds hold it (EN 1991-1-3, 5.3.2 (2), 5.3.5 (i))"
    elif arranged.arrangement == "in valleys":
        share, rule = _in_valleys(exposure)
    else:
        share, rule = _drifted(exposure, left=arranged.arrangement == "drifted left")
    factor = asked.exposure_factor * asked.thermal_factor
    forces = exposure.on_corners(-(factor * asked.ground * share * level)[:, None] * UP)
    if factor != 1:
        rule += f", C_e C_t = {plain(factor)} (5.2)"
    return Effect(forces, asked.ground, f"{rule}, on plan areas")


def drift_shape(rise: float, span: float) -> float:
    """mu_3 of a cylindrical roof, 5.3.5."""
    return min(0.2 + 10 * rise / span, 2.0)


def _drifted(exposure: Exposure, *, left: bool) -> tuple[Array, str]:
    """Shares (T,) of figure 5.6, case (ii), and the rule.

    mu_3 in the middle of one half of the width, 0.5 mu_3 in that of the other.

    left: Whether the first half is that of the first foot.
    """
    across, way = exposure.across()
    assert exposure.span is not None
    rise, span = exposure.rise, exposure.span
    most = drift_shape(rise, span)
    peaks = [0, 0.5 * most, 0, most, 0]
    share = np.interp(across, np.linspace(0, 1, 5), peaks[::-1] if left else peaks)
    side = (-1 if left else 1) * way.mean(axis=0)
    axis = first_largest(np.abs(side))
    rule = (
        f"drifted towards {'-' if side[axis] < 0 else '+'}{'xy'[axis]}: mu_3 = {plain(most)} there "
        f"and half of it on the other side, by a rise of {plain(rise)} and a span of {plain(span)} "
        f"{exposure.unit} (EN 1991-1-3, 5.3.5 (ii), over the whole width, as folds hold it)"
    )
    return np.asarray(share), rule


def valley_shape(mean_slope: Array) -> Array:
    """mu_2 at a valley between two slopes, by their mean (radians), 5.3.4 and table 5.2."""
    return np.asarray(LYING + (DEEPEST - LYING) * np.clip(mean_slope / FULL, 0, 1))


def _in_valleys(exposure: Exposure) -> tuple[Array, str]:
    """Shares (T,) of figure 5.4, case (ii), and the rule.

    mu_2 along creases lower than both neighbours, 0.8 along others, and straight lines between.
    """
    ridges = exposure.ridges()
    height = ridges[..., 2]
    shape = np.full(height.shape, LYING)
    panels = (len(height) - 1, height.shape[1])
    areas = exposure.mesh.areas()
    normals = np.zeros((*panels, 3))
    np.add.at(normals, (exposure.rows, exposure.columns), areas[:, None] * exposure.outer())
    slopes = np.arccos(np.clip(normals[..., 2] / np.linalg.norm(normals, axis=-1), -1, 1))
    valley = (height[1:-1] < height[:-2]) & (height[1:-1] < height[2:])
    deep = valley_shape(0.5 * (slopes[:-1] + slopes[1:]))
    shape[1:-1] = np.where(valley, deep, LYING)
    first, second = (ridges[exposure.rows + k, exposure.columns] for k in (0, 1))
    way = second - first
    along = ((exposure.centroids() - first) * way).sum(axis=1) / (way**2).sum(axis=1)
    ends = [shape[exposure.rows + k, exposure.columns] for k in (0, 1)]
    share = ends[0] + np.clip(along, 0, 1) * (ends[1] - ends[0])
    count = int(valley.sum())
    rule = (
        f"in {count} valleys of the folds, mu_2 = {plain(shape.max())} at most, 0.8 elsewhere "
        "(EN 1991-1-3, 5.3.4 (ii))"
    )
    return np.asarray(share), rule
