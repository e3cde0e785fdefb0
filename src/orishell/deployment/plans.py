"""Outlines in plan: convex hulls of points, and of many points without those well inside."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from orishell.numerics.arrays import Array

if TYPE_CHECKING:
    from shapely.geometry import Polygon

FEW_POINTS = 64
"""Of so few points the hull is made as they are; of more, without those inside of an octagon."""


def outermost(plans: Array) -> list[Array]:
    """The points of plans (S, N, 2) that may be corners of their hulls."""
    if plans.shape[1] <= FEW_POINTS:
        return list(plans)
    x, y = plans[..., 0], plans[..., 1]
    views = (x, x + y, y, y - x)
    most = [each.argmax(axis=1) for each in views], [each.argmin(axis=1) for each in views]
    octagon = np.stack([*most[0], *most[1]], axis=1)
    corners = np.take_along_axis(plans, octagon[..., None], axis=1)
    outside = np.zeros(plans.shape[:2], np.bool_)
    for begin, end in zip(range(8), [*range(1, 8), 0], strict=True):
        p, q = corners[:, begin, None], corners[:, end, None]
        side = (q - p)[..., 0] * (y - p[..., 1]) - (q - p)[..., 1] * (x - p[..., 0])
        outside |= side <= 0
    return [plan[kept] for plan, kept in zip(plans, outside, strict=True)]


def polygon(corners: Array) -> Polygon:
    """The polygon with corners (K, 2)."""
    from shapely.geometry import Polygon

    return Polygon(corners)


def hull_of(points: Array) -> Array:
    """Corners (K, 2) of the hull of points (N, 2), counter-clockwise; if in a line, its ends."""
    from shapely import LineString
    from shapely.geometry import Polygon

    hull = LineString(points).convex_hull
    return corners_of(hull) if isinstance(hull, Polygon) else np.array(hull.coords)


def corners_of(shape: Polygon) -> Array:
    """Corners (K, 2) of a polygon, counter-clockwise."""
    from shapely.geometry.polygon import orient

    return np.array(orient(shape).exterior.coords)[:-1]
