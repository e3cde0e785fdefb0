"""The folding sheet as a mechanism: what families give and all that follows works on.

A family implements :class:`Mechanism`: positions and fold angles in closed form at any drive
angle. Most are one flat sheet at drive 0. The others begin there, and are made in strips
(:mod:`orishell.motion.as_made`).
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.errors import InputError
from orishell.conventions.formatting import in_degrees
from orishell.conventions.record import record
from orishell.motion.grid import CreaseValues, Grid, Positions, crease_signs
from orishell.motion.quads import grid_corners, is_level, lengths, unit_normals
from orishell.numerics.arrays import Array


class Mechanism(Protocol):
    """A folding sheet with one degree of freedom, the drive angle (radians)."""

    @property
    def grid(self) -> Grid:
        """The grid of vertices."""

    @property
    def inner_columns(self) -> slice:
        """Columns 1 ... n: those that are to meet the target, without flaps or border strips."""

    @property
    def flap_columns(self) -> tuple[int, ...]:
        """Numbers of those columns of panels that are flaps, whose panels meet at the target.

        Where there is one, the motion ends at the target: there they are folded onto themselves,
        or, with a stop, their boards meet, although the sheet would go on.
        """

    def without_flaps(self) -> Mechanism:
        """The sheet without its flaps, which goes on beyond its target; itself if it has none."""

    def with_stop(self, stop: float) -> Mechanism:
        """The sheet whose flaps stop short of folding flat; itself if it has none.

        The row crease of a flap that folds most has the fold angle pi - 2 stop at the target: a
        ``stop`` of 0 folds it flat (radians).

        Raises
        ------
        DesignError
            If it is too large for the sheet.
        """

    @property
    def least_turning(self) -> Mechanism:
        """The sheet, turning as little as possible while it folds: for the proof of contact.

        Contact does not depend on how the sheet turns as a whole, and less turning needs fewer
        states.
        """

    @property
    def target_drive(self) -> float:
        """The drive angle at which the shell meets its target; the motion begins at drive 0."""

    @property
    def end_drive(self) -> float:
        """The drive angle at which a crease is folded flat, at the target or beyond it."""

    def positions(self, drive: ArrayLike) -> Array:
        """Positions (..., rows, columns, 3) of all vertices at drive angles (...) (radians)."""

    def fold_angles(self, drive: ArrayLike) -> CreaseValues:
        """Fold angles of all creases at drive angles (...), in closed form (radians).

        Before ``end_drive`` all of them are below pi in size: the proof of the path rests on it,
        where panels share a vertex.
        """

    def edge_accelerations(self, start: Array, stop: Array) -> tuple[Array, Array]:
        """Bounds of the accelerations of edges while the drive is between ``start`` and ``stop``.

        At ends (S,) of ranges of the drive (radians) they are upper bounds of the length of the
        second derivative by the drive of the vectors between neighbouring vertices, in length per
        radian squared: along rows (S, columns-1), the largest of all rows; down columns
        (S, rows-1), the largest of all columns.
        """


@record
class FoldedState:
    """One state of a mechanism, with fold angles from the closed form (radians)."""

    drive: float  # drive angle (radians)
    positions: Array  # vertices (rows, columns, 3), read-only
    fold_angles: CreaseValues

    @classmethod
    def of(cls, mechanism: Mechanism, drive: float) -> FoldedState:
        """The state of a mechanism at one drive angle (radians)."""
        positions = mechanism.positions(drive)
        positions.flags.writeable = False
        return cls(drive, positions, mechanism.fold_angles(drive))


@record
class FoldingMotion:
    """States of a mechanism: folded up from flat to its target, or opened from its pack to flat."""

    mechanism: Mechanism
    # number of states, at least 2, or 3 from a pack; at nearly equal steps of the drive angle
    frames: int
    # Drive angle of the pack, beyond the target (radians): the states go from there over the target
    # to the flat sheet. None if they go from the flat sheet to the target.
    pack: float | None = None

    def __post_init__(self) -> None:
        if not hasattr(self.mechanism, "positions"):
            raise InputError(
                "this is not a folding sheet",
                where="FoldingMotion",
                got=type(self.mechanism).__name__,
                expected="a mechanism",
                remedy="take design.mechanism of a design",
            )
        least = 2 if self.pack is None else 3
        if not isinstance(self.frames, int | np.integer) or self.frames < least:
            raise InputError(
                "these are no states of a motion",
                where="FoldingMotion: frames",
                got=repr(self.frames)[:60],
                expected=f"a whole number of at least {least}",
            )

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.frames} states of {self.mechanism!r})"

    @property
    def drives(self) -> Array:
        """Drive angles (frames,) of the states (radians)."""
        target = self.mechanism.target_drive
        if self.pack is None:
            return np.linspace(0.0, target, self.frames)
        opened = self.named["target"]
        return np.concatenate(
            [
                np.linspace(self.pack, target, opened + 1),
                np.linspace(target, 0.0, self.frames - opened)[1:],
            ]
        )

    @property
    def named(self) -> dict[str, int]:
        """Numbers of the states that have a name: "flat", "target", and "pack" if there is one.

        A mechanism that is not flat at drive 0 has no "flat" but "open" there.
        """
        last, first = self.frames - 1, "flat" if is_flat_at_first(self.mechanism) else "open"
        if self.pack is None:
            return {first: 0, "target": last}
        share = 1 - self.mechanism.target_drive / self.pack
        return {"pack": 0, "target": int(np.clip(round(share * last), 1, last - 1)), first: last}

    def __len__(self) -> int:
        return self.frames

    def __iter__(self) -> Iterator[FoldedState]:
        """States one after the other, so that only one need be in memory."""
        for drive in self.drives:
            yield FoldedState.of(self.mechanism, float(drive))

    @property
    def flat(self) -> FoldedState:
        """The flat sheet."""
        return FoldedState.of(self.mechanism, 0.0)

    @property
    def target(self) -> FoldedState:
        """The shell: the state that meets the target."""
        return FoldedState.of(self.mechanism, self.mechanism.target_drive)


def is_flat_at_first(mechanism: Mechanism) -> bool:
    """Whether all panels of a mechanism lie in one plane at drive 0, so that it is one sheet."""
    return is_level(mechanism.positions(0.0))


def find_assignment(mechanism: Mechanism) -> CreaseValues:
    """Signs of all creases at the target: +1 valley, -1 mountain, 0 unfolded."""
    return crease_signs(mechanism.fold_angles(mechanism.target_drive))


def mechanism_in_one_line(mechanism: Mechanism) -> str:
    """One line that describes a mechanism: the ``__repr__`` of those of all families."""
    grid = mechanism.grid
    return (
        f"{type(mechanism).__name__}({grid.rows} x {grid.columns} vertices, {grid.panel_count} "
        f"panels, drive to {in_degrees(mechanism.target_drive)} degrees)"
    )


def panel_normals(positions: Positions) -> Array:
    """Unit normals (..., rows-1, columns-1, 3) of the panels, +z on the flat sheet."""
    return unit_normals(grid_corners(positions))


def measure_fold_angles(positions: Positions) -> CreaseValues:
    """Fold angles of all creases measured from the positions (..., rows, columns, 3).

    Signed angles between the normals of the two panels at each crease, valley positive, in
    (-pi, pi] (radians). At pi the sign is undetermined.
    """
    normal = panel_normals(positions)
    return CreaseValues(
        row=_angle_about(
            normal[..., :-1, :, :],
            normal[..., 1:, :, :],
            positions[..., 1:-1, :-1, :] - positions[..., 1:-1, 1:, :],
        ),
        column=_angle_about(
            normal[..., :-1, :],
            normal[..., 1:, :],
            positions[..., 1:, 1:-1, :] - positions[..., :-1, 1:-1, :],
        ),
    )


def _angle_about(first: Array, second: Array, axis: Array) -> Array:
    """Angle (...) that turns unit vectors ``first`` into ``second`` about ``axis`` (..., 3)."""
    axis = axis / lengths(axis)[..., None]
    sine = np.einsum("...i,...i->...", np.cross(first, second), axis)
    return np.asarray(np.arctan2(sine, np.einsum("...i,...i->...", first, second)))
