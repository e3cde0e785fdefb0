"""The sheet in world coordinates at its target state, and how well it meets the target there."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np

from orishell.conventions.quantities import plain
from orishell.design import Approached, Design, Parameter, Path, Sliding, Surface
from orishell.families.longitudinal_linear_repeating.motion.measures import (
    describe_radii,
    measure_departures,
    section_radii,
)
from orishell.families.longitudinal_linear_repeating.motion.mechanism import (
    LongitudinalLinearRepeating,
    Pose,
)
from orishell.families.longitudinal_linear_repeating.target import Line, Profile
from orishell.families.longitudinal_linear_repeating.target_state import TargetState
from orishell.numerics.arrays import Array
from orishell.polylines import Closeness, measure_closeness


def place(
    mechanism: LongitudinalLinearRepeating,
    profile: Profile,
    line: Line,
    state: TargetState,
    describe: Callable[[LongitudinalLinearRepeating], Mapping[str, Parameter]],
) -> Design:
    """Put the sheet so that at its target state column 1 lies on f, upright on g's start.

    The middle vertex of column 1's polygon, seen along g, is on g. In other states the middle
    row's centroid is where it is there, and the middle panel's turn grows with the drive.

    mechanism, profile, line, state: The sheet, f and g, and where column 1 follows f.
    describe: Says what was used and found, of the placed sheet.
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

    free = replace(mechanism, stop=state.drive, pose=Pose())
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
            **describe(placed),
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
            f"the rows are not parallel: the radius of the sections goes from {plain(radii[0])} at "
            f"column 1 to {plain(radii[1])} at the last",
            None,
        ),
        origin=np.append(line.trace.origin, 0.0),
        warnings=(),
    )


def pose_of(centroid: Array, rotation: Array) -> Pose:
    """The pose with a centroid (3,) of the middle row, turned by a matrix (3, 3) at the end."""
    from scipy.spatial.transform import Rotation

    return Pose(_vector(centroid), _vector(Rotation.from_matrix(rotation).as_rotvec()))


def _vector(array: Array) -> tuple[float, float, float]:
    x, y, z = (float(each) for each in array)
    return x, y, z
