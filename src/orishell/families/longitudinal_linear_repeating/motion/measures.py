"""Shapes measured on folded states: planes of rows and columns, radii of cross-sections."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.families.longitudinal_linear_repeating.motion.mechanism import (
    LongitudinalLinearRepeating,
)
from orishell.families.longitudinal_linear_repeating.tessellation.columns import flat_foldable_rows
from orishell.numerics.arrays import Array

PLANAR = 1e-9
"""Points that leave their plane by less than this share of their extent are planar."""
STATES = 5
"""States at which planes are fitted, equally spaced."""


def departures_from_plane(points: Array) -> Array:
    """Largest distance (...) of points (..., K, 3) from their plane, as a share of their extent."""
    centred = points - points.mean(axis=-2, keepdims=True)
    normal = np.linalg.svd(centred, full_matrices=False)[2][..., -1, :]
    distance = np.abs((centred * normal[..., None, :]).sum(axis=-1)).max(axis=-1)
    extent = np.linalg.norm(points.max(axis=-2) - points.min(axis=-2), axis=-1)
    share: Array = distance / extent
    return share


def measure_departures(mechanism: LongitudinalLinearRepeating) -> dict[str, float | list[str]]:
    """How far rows and columns leave their planes, and which stay planar.

    Over the whole motion, to where a crease is folded flat, whether it is stopped before or not.
    Shares of their own extent; inner vertices only. Three vertices or fewer are planar anyway.
    """
    mechanism = replace(mechanism, stop=None)
    rows = mechanism.grid.rows - 2
    flat_foldable = flat_foldable_rows(rows, mechanism.first_row)
    worst = {"f_row": 0.0, "s_row": 0.0, "column": 0.0}
    for drive in np.linspace(0.0, mechanism.target_drive, STATES + 1)[1:]:
        inner = mechanism.positions(drive)[1:-1, 1:-1]
        of_rows = departures_from_plane(inner) if inner.shape[1] > 3 else np.zeros(rows)
        of_columns = departures_from_plane(inner.swapaxes(0, 1)) if rows > 3 else np.zeros(1)
        for name, values in (
            ("f_row", of_rows[flat_foldable]),
            ("s_row", of_rows[~flat_foldable]),
            ("column", of_columns),
        ):
            worst[name] = max(worst[name], float(values.max(initial=0.0)))
    names = {"f_row": "F rows", "s_row": "S rows", "column": "columns"}
    return {
        **{f"{name}_out_of_plane": value for name, value in worst.items()},
        "planar": [names[name] for name, value in worst.items() if value < PLANAR],
    }


def circle_radius(points: Array) -> float:
    """Radius of the circle (least squares) through points (K, 2), K at least 3."""
    x, y = (points - points.mean(axis=0)).T
    system = np.stack([x, y, np.ones_like(x)], axis=-1)
    a, b, c = np.linalg.lstsq(system, x**2 + y**2, rcond=None)[0]
    return float(np.sqrt(max(c + (a * a + b * b) / 4, 0.0)))


def section_radii(seen: Array) -> list[float]:
    """Radii of the sections of column 1 and of the last column.

    seen: Vertices (m+2, n+2, 2) seen along the line that the sheet rolls about.
    """
    return [circle_radius(seen[:, j]) for j in (1, -2)]


def describe_radii(radii: list[float]) -> dict[str, float | list[float]]:
    """The radii and how much they grow, by their names in the report."""
    first, last = radii
    return {"radius": radii, "radius_growth": last / first if first > 0 else float("nan")}
