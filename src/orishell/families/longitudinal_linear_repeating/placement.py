"""The sheet in world coordinates at its stage, and how well it meets the target there."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from orishell.design import Approached, Parameter
from orishell.families.longitudinal_linear_repeating.measures import (
    describe_radii,
    measure_departures,
    section_radii,
)
from orishell.families.longitudinal_linear_repeating.mechanism import (
    LongitudinalLinearRepeating,
    Pose,
)
from orishell.families.longitudinal_linear_repeating.stage import Stage
from orishell.families.longitudinal_linear_repeating.target import Line, Profile
from orishell.polylines import Closeness, measure_closeness
from orishell.surface import Path, Sliding, Surface

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Placed:
    """A sheet that stands where the target is.

    Parameters
    ----------
    mechanism
        The sheet, its motion ending at the stage.
    targets
        f and g in world coordinates (N, 3).
    closeness
        Distances seen along g ("f": column 1) and from g ("g": the middle row).
    surface
        f swept along the line.
    approached
        What the shell approaches instead.
    measures
        What the report says of its shape.
    """

    mechanism: LongitudinalLinearRepeating
    targets: Mapping[str, Array]
    closeness: Mapping[str, Closeness]
    surface: Surface
    approached: Approached | None
    measures: Mapping[str, Parameter]


def place(
    mechanism: LongitudinalLinearRepeating, profile: Profile, line: Line, stage: Stage
) -> Placed:
    """Put the sheet so that at the stage column 1 lies on f, upright on g's start.

    The middle vertex of column 1's polygon, seen along g, is on g. In other states the middle
    row's centroid is where it is at the stage, and the middle panel's turn grows with the drive.
    """
    forward = np.array([*line.direction, 0.0])
    right = np.array([line.direction[1], -line.direction[0], 0.0])
    up = np.array([0.0, 0.0, 1.0])
    first = stage.polygon[1] - stage.polygon[0]
    first = first / np.hypot(*first)
    # Rotation that takes the section's axis to g, and column 1's first crease to its direction.
    section = stage.section
    here = np.stack([section.axis, section.heading, np.cross(section.axis, section.heading)])
    heading = first[0] * right + first[1] * up
    there = np.stack([forward, heading, np.cross(forward, heading)])
    rotation = there.T @ here

    free = replace(mechanism, stop=stage.drive, pose=Pose())
    sheet = free.positions(stage.drive) @ rotation.T
    middle = sheet.shape[0] // 2
    column = sheet[:, 1]
    seen = np.stack([column @ right, column @ up], axis=-1)
    start = np.array([*line.start, 0.0])
    # The two polygons differ by a translation only; along g, column 1 is at its start.
    goal = stage.polygon - stage.polygon[middle]
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

    final = placed.positions(stage.drive)
    relative = final - start
    seen = np.stack([relative @ right, relative @ up], axis=-1)
    trace = profile.trace
    along_row = (relative[middle, 1:-1] @ forward)[:, None]
    ideal = trace.points - stage.polygon[middle]
    distance = np.hypot(*np.moveaxis(seen[middle, 1:-1], -1, 0))
    radii = section_radii(seen)
    return Placed(
        mechanism=placed,
        targets={
            "f": start + ideal[:, :1] * right + ideal[:, 1:] * up,
            "g": np.stack([start, start + line.length * forward]),
        },
        closeness={
            "f": measure_closeness(trace, seen[:, 1] + stage.polygon[middle]),
            "g": Closeness(float(distance.max()), float(np.sqrt((distance**2).mean()))),
        },
        surface=Surface(
            trace, stage.polygon[middle], Sliding(Path.of(line.trace), complex(*right[:2]))
        ),
        approached=Approached(
            f"the rows are not parallel: the radius of the sections goes from {radii[0]:.4g} at "
            f"column 1 to {radii[1]:.4g} at the last",
            None,
        ),
        measures={
            **describe_radii(radii),
            "row_span": [float(along_row.min()), float(along_row.max())],
            "column_1_depth": float(np.ptp(relative[:, 1] @ forward)),
            **measure_departures(placed),
        },
    )


def pose_of(centroid: Array, rotation: Array) -> Pose:
    """The pose with a centroid (3,) of the middle row, turned by a matrix (3, 3) at the end."""
    from scipy.spatial.transform import Rotation

    return Pose(_vector(centroid), _vector(Rotation.from_matrix(rotation).as_rotvec()))


def _vector(array: Array) -> tuple[float, float, float]:
    x, y, z = (float(each) for each in array)
    return x, y, z
