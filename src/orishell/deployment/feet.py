"""What a shell stands on: the rows that are its feet, how even they are, and the ground."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.conventions.record import record
from orishell.design import Design
from orishell.motion import Mechanism
from orishell.motion.grid import Vertex
from orishell.motion.layout import has_flaps, points_of
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.equals import first_largest, first_smallest

RISE = 0.1
"""Both ends of f lie this share of its height below its highest point, or it has no two feet."""
DIP = 0.01
"""Nothing between an end and the highest point lies lower than the end by more than this share."""
ROOF = 0.05
"""A sheet without f that rises by less than this share of its span is no arch, but a roof."""
TIE = 1e-9
"""Rows whose heights differ by less than this share of the shell's height are equally low."""
LEVEL = 1e-6
"""Feet that differ in height by less than this share of the shell's height are level."""


@record
class Feet:
    """What a locked shell stands on, flaps left out."""

    REPORTED = ("rows", "z", "uneven", "level", "points", "below")

    rows: tuple[int, int]  # the rows of vertices that are its feet, the lowest towards each end
    z: float  # height of the lowest of their vertices
    uneven: float  # by how much the highest lies above it, 0 where they are level
    height: float  # of the shell
    # where it stands on single vertices of its border: those, all at one height, or nearly for
    # whole boards; the columns that have one in both rows are its feet
    points: tuple[Vertex, ...] = ()
    below: float = 0.0  # how far vertices of flaps reach below the lowest foot; 0 if none do

    @property
    def level(self) -> bool:
        """Whether all are at one height."""
        return self.uneven == 0.0

    def vertices(self, mechanism: Mechanism) -> Integers:
        """Rows and columns (K, 2) of the whole grid of all vertices that are feet."""
        if self.points:
            return np.array(self.points)
        rows, columns = np.meshgrid(self.rows, self.columns(mechanism), indexing="ij")
        return np.stack([rows.ravel(), columns.ravel()], axis=-1)

    def columns(self, mechanism: Mechanism) -> Integers:
        """Columns (K,) of the whole grid in which both rows have a foot."""
        if not self.points:
            return np.arange(mechanism.grid.columns)[mechanism.inner_columns]
        first, last = ({column for row, column in self.points if row == at} for at in self.rows)
        return np.array(sorted(first & last))


def find_feet(design: Design) -> Feet | None:
    """The feet of a locked shell; None if it cannot stand: f's ends are not its lowest part.

    Where there is no f, the line through the middles of its rows shows whether it is an arch.
    """
    mechanism = design.mechanism
    placed = mechanism.positions(mechanism.target_drive)[:, mechanism.inner_columns]
    # Whole boards stand where the panels that they meet would.
    shell = placed if design.meant is None else design.meant[:, mechanism.inner_columns]
    height = shell[..., 2]
    lowest = design.hinges.lowest(placed)
    f, column = design.targets.get("f"), shell[:, 0]
    if f is None and design.may_stand:
        found = _on_points(design, height, lowest)
        if found is not None:
            return found
        # Half way between rows, so that the corrugation does not count.
        column = shell.mean(axis=1)
        f = 0.5 * (column[1:] + column[:-1])
        if np.ptp(f[:, 2]) < ROOF * np.linalg.norm(f[-1] - f[0]):
            return None
    if f is None or not _is_arch(f):
        return None
    size = float(np.ptp(height))
    low = height.min(axis=1)
    # The row that stands on f's highest point parts the rows; column 1 stands on f, or the middle.
    away = np.linalg.norm(column - f[first_largest(f[:, 2])], axis=-1)
    top = 1 + first_smallest(away[1:-1], size=size)
    rows = (
        _outermost(low[:top], size),
        len(low) - 1 - _outermost(low[:top:-1], size),
    )
    feet = height[list(rows)]
    if feet.min() > low.min() + TIE * size:  # the corrugation reaches lower in the middle
        return None
    return _feet(design, rows, lowest[list(rows)], size)


def _feet(
    design: Design,
    rows: tuple[int, int],
    lowest: Array,
    size: float,
    points: tuple[Vertex, ...] = (),
) -> Feet:
    """Feet by the lowest corners of panels or boards at them (...), of a shell so high."""
    mechanism, foot = design.mechanism, float(lowest.min())
    below = 0.0
    if has_flaps(mechanism):
        below = foot - float(points_of(mechanism, mechanism.target_drive)[:, 2].min())
    uneven, below = (far if far > LEVEL * size else 0.0 for far in (float(np.ptp(lowest)), below))
    return Feet(rows, foot + float(design.origin[2]), uneven, size, points, below)


def stand(design: Design, feet: Feet | None) -> tuple[Design, Feet | None]:
    """The design and its feet, if it has any, raised or lowered until the lowest is on z = 0."""
    if feet is None:
        return design, None
    origin = design.origin - np.array([0.0, 0.0, feet.z])
    return replace(design, origin=origin), replace(feet, z=0.0)


def _on_points(design: Design, height: Array, lowest: Array) -> Feet | None:
    """Feet that are vertices of the border at one height (R, C), in two columns or more."""
    size = float(np.ptp(height))
    on = height <= height.min() + LEVEL * size
    if on[1:-1, 1:-1].any() or any(row.all() for row in on):
        return None
    common = np.triu(on.astype(np.int64) @ on.T, 1)
    # Of rows with as many feet in common, those that are farthest apart.
    first, last = np.indices(common.shape)
    found = np.lexsort(((last - first).ravel(), common.ravel()))[-1]
    rows = int(first.ravel()[found]), int(last.ravel()[found])
    if common[rows] < 2:
        return None
    before = design.mechanism.inner_columns.start
    points = tuple((row, column + before) for row, column in np.argwhere(on).tolist())
    return _feet(design, rows, lowest[on], size, points)


def _outermost(low: Array, size: float) -> int:
    """The lowest row by the heights ``low`` of rows; of equally low ones the first."""
    return int(np.argmax(low <= low.min() + TIE * size))


def _is_arch(curve: Array) -> bool:
    """Whether a curve (N, 3) rises from one end and falls to the other, which are its lowest."""
    height = curve[:, 2]
    top, size = int(height.argmax()), float(np.ptp(height))
    if size <= TIE * np.ptp(curve, axis=0).max():
        return False
    return all(
        bool(side[-1] - side[0] > RISE * size and side.min() >= side[0] - DIP * size)
        for side in (height[: top + 1], height[top:][::-1])
    )
