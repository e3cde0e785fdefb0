"""The sheet in world coordinates at its target state, and what is measured on folded states."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from orishell.conventions.quantities import plain
from orishell.curves.nearest import Closeness
from orishell.design import Approached, Design, Parameter, Path, Sliding, Surface
from orishell.families.longitudinal_linear_repeating.motion.mechanism import (
    LongitudinalLinearRepeating,
    Pose,
)
from orishell.families.longitudinal_linear_repeating.target import Line, Profile
from orishell.families.longitudinal_linear_repeating.target_state import TargetState
from orishell.families.longitudinal_linear_repeating.tessellation.columns import flat_foldable_rows
from orishell.numerics.arrays import Array
from orishell.polylines import measure_closeness

PLANAR = 1e-9
"""Points that leave their plane by less than this share of their extent are planar."""
STATES = 5
"""States at which planes are fitted, equally spaced."""


def place(
    mechanism: LongitudinalLinearRepeating,
    profile: Profile,
    line: Line,
    state: TargetState,
    parameters: Mapping[str, Parameter],
) -> Design:
    """Put the sheet so that at its target state column 1 lies on f, upright on g's start.

    The middle vertex of column 1's polygon, seen along g, is on g. In other states the middle
    row's centroid is where it is there, and the middle panel's turn grows with the drive.
    """
    forward = np.array([*line.direction, 0.0])
    right = np.array([line.direction[1], -line.direction[0], 0.0])
    up = np.array([0.0, 0.0, 1.0])
    first = state.polygon[1] - state.polygon[0]
    first = first / np.hypot(*first)
    # Rotation that takes the section's axis to g, and column 1's first crease to its direction.
    section = state.section
    here = np.stack([section.axis, section.heading, np.cross(section.axis, section.heading)])
    heading = first[0] * right + first[1] * up
    there = np.stack([forward, heading, np.cross(forward, heading)])
    rotation = there.T @ here

    free = replace(mechanism, pose=Pose())
    sheet = free.positions(state.drive) @ rotation.T
    middle = sheet.shape[0] // 2
    column = sheet[:, 1]
    seen = np.stack([column @ right, column @ up], axis=-1)
    start = np.array([*line.start, 0.0])
    # The two polygons differ by a translation only; along g, column 1 is at its start.
    goal = state.polygon - state.polygon[middle]
    offset = (goal - seen).mean(axis=0)
    shift = (
        offset[0] * right
        + offset[1] * up
        + (start @ forward - (column @ forward).mean()) * forward
        + (start @ right) * right
    )
    centroid = shift + sheet[1 + (sheet.shape[0] - 2) // 2, 1:-1].mean(axis=0)
    pose = pose_of(centroid, rotation)
    placed = replace(free, pose=pose)

    final = placed.positions(state.drive)
    relative = final - start
    seen = np.stack([relative @ right, relative @ up], axis=-1)
    trace = profile.trace
    along_row = (relative[middle, 1:-1] @ forward)[:, None]
    ideal = trace.points - state.polygon[middle]
    distance = np.hypot(*np.moveaxis(seen[middle, 1:-1], -1, 0))
    radii = section_radii(seen)
    return Design(
        mechanism=placed,
        parameters={
            **parameters,
            **describe_radii(radii),
            "row_span": [float(along_row.min()), float(along_row.max())],
            "column_1_depth": float(np.ptp(relative[:, 1] @ forward)),
            **measure_departures(placed),
        },
        targets={
            "f": start + ideal[:, :1] * right + ideal[:, 1:] * up,
            "g": np.stack([start, start + line.length * forward]),
        },
        closeness={
            "f": measure_closeness(trace, seen[:, 1] + state.polygon[middle]),
            "g": Closeness(float(distance.max()), float(np.sqrt((distance**2).mean()))),
        },
        swept=Surface(
            trace, state.polygon[middle], Sliding(Path.of(line.trace), complex(*right[:2]))
        ),
        approached=Approached(
            f"the rows are not parallel: the radius of the cross-section goes from "
            f"{plain(radii[0])} at column 1 to {plain(radii[1])} at the last column",
            None,
        ),
        origin=np.append(line.trace.origin, 0.0),
        folded_by="stage_deg",
        smaller_by="sector angles nearer to 90 degrees",
        warnings=(),
    )


def pose_of(centroid: Array, rotation: Array) -> Pose:
    """The pose with a centroid (3,) of the middle row, turned by a matrix (3, 3) at the end."""
    from scipy.spatial.transform import Rotation

    turn = Rotation.from_matrix(rotation).as_rotvec()
    return Pose(tuple(centroid.tolist()), tuple(turn.tolist()))


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
    drives = np.linspace(0.0, mechanism.target_drive, STATES + 1)[1:]
    inner = mechanism.positions(drives)[:, 1:-1, 1:-1]
    of_rows = departures_from_plane(inner) if inner.shape[2] > 3 else np.zeros((STATES, rows))
    of_columns = departures_from_plane(inner.swapaxes(1, 2)) if rows > 3 else np.zeros((STATES, 1))
    worst = {
        name: float(values.max(initial=0.0))
        for name, values in (
            ("f_row", of_rows[:, flat_foldable]),
            ("s_row", of_rows[:, ~flat_foldable]),
            ("column", of_columns),
        )
    }
    names = {"f_row": "F rows", "s_row": "S rows", "column": "columns"}
    return {
        **{f"{name}_out_of_plane": value for name, value in worst.items()},
        "planar": [names[name] for name, value in worst.items() if value < PLANAR],
    }


def section_radii(seen: Array) -> list[float]:
    """Radii of column 1 and of the last, of vertices (m+2, n+2, 2) seen along the rolling axis.

    Each is that of a circle through the column, by least squares.
    """
    radii = []
    for points in (seen[:, 1], seen[:, -2]):
        x, y = (points - points.mean(axis=0)).T
        system = np.stack([x, y, np.ones_like(x)], axis=-1)
        a, b, c = np.linalg.lstsq(system, x**2 + y**2, rcond=None)[0]
        radii.append(float(np.sqrt(max(c + (a * a + b * b) / 4, 0.0))))
    return radii


def describe_radii(radii: list[float]) -> dict[str, float | list[float]]:
    """The radii and how much they grow, by their names in the report."""
    first, last = radii
    return {"radius": radii, "radius_growth": last / first if first > 0 else float("nan")}
