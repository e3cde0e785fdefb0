"""What sheets of the paper's sections 2 and 3 share: vertices, flaps, the place of f.

Column-straight vertices (sections LU + LD = RU + RD = pi): with psi the angle between the two
column creases, write c = cos(psi/2), and for a row crease with the sector angle a below it
k = cos a, w = sqrt(sin(psi/2)^2 - k^2). The row crease then leaves the column's axis t at the
angle eps with cos eps = k/sin(psi/2), sin eps = w/sin(psi/2); it exists where w is real.

The paper has these relations at lock, within equations (2) and (3); here they hold in every state.
Fold angles are deviations from flat, valley positive, in (-pi, pi]; here without sign.

Derived in docs/theory/vertex.md.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import NDArray

from orishell.curves import Trace
from orishell.families.shared.candidates import refuse_stop
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array, Complex
from orishell.polylines import Staircase, Zigzag


def row_fold_angle(c: Array, w: Array) -> Array:
    """Size of the fold angle of a row crease at a column-straight vertex (radians).

    The panels beside the crease are inclined to the row's plane by phi with
    sin phi = c/sin a, cos phi = w/sin a; the crease folds by 2 phi.

    Parameters
    ----------
    c, w
        As in the module's text (...); both may carry the same positive factor.
    """
    angle: Array = 2 * np.arctan2(c, w)
    return angle


def column_fold_angle(
    c: Array, k_left: Array, w_left: Array, k_right: Array, w_right: Array
) -> Array:
    """Fold angle of the column creases at a column-straight vertex (radians).

    Each side's panels make the angle arctan(c k/w) with the normal of the column's plane; together
    these are the fold angle. Its sign is that of cos eps_L + cos eps_R: zero where the row is
    straight, the same through the whole motion.

    Parameters
    ----------
    c, k_left, w_left, k_right, w_right
        As in the module's text (...); k and w of one side may carry the same positive factor.
    """
    angle: Array = np.arctan2(c * k_left, w_left) + np.arctan2(c * k_right, w_right)
    return angle


ALIKE = 1e-14
"""Lengths that differ by less than this share are alike but for rounding."""


class FlapSheet:
    """A grid whose first and last column of panels are flaps, or which has none there."""

    __slots__ = ()
    __dataclass_fields__: ClassVar[dict[str, Any]]  # every sheet is a dataclass

    lengths: Array  # edge lengths of the first column (m+1,), m odd, in the unit of the curves
    points: Complex  # the middle row at lock (n,), n at least 2: vertices of g's polyline
    flaps: tuple[float, float]  # size of the left and the right flap; 0 where there is none
    # by how much flaps stop short of folding flat at the target: half of what the row crease of a
    # flap that folds most lacks to pi there (radians)
    stop: float
    _columns: Any  # the family's columns; ``rest`` is how far the tightest is open at the target

    @property
    def grid(self) -> Grid:
        """The grid of vertices, flap columns included."""
        return Grid(len(self.lengths) + 1, len(self.points) + sum(map(bool, self.flaps)))

    @property
    def inner_columns(self) -> slice:
        """Columns 1 ... n among the columns of the grid."""
        start = int(self.flaps[0] != 0)
        return slice(start, start + len(self.points))

    @property
    def flap_columns(self) -> tuple[int, ...]:
        """The first and the last column of panels, as far as they are flaps."""
        last = self.grid.columns - 2
        return tuple(k for k, width in zip((0, last), self.flaps, strict=True) if width)

    def without_flaps(self) -> Self:
        """The sheet without its flaps; what stays meets the target as it did."""
        return replace(self, flaps=(0.0, 0.0), stop=0.0)

    def with_stop(self, stop: float) -> Self:
        """The sheet whose flaps, as wide as they are, stop short of folding flat by this angle.

        Raises
        ------
        DesignError
            If it is no less than half of the sharpest angle of the columns beside them.
        """
        if not self.flap_columns:
            return self
        limit = self._sharpest_angle() / 2
        if stop >= limit:
            raise refuse_stop(stop, limit, "half of the sharpest angle of the columns beside them")
        return self._stopped(stop)

    def free_lengths(self) -> Mapping[str, Array]:
        """Lengths of column 1 (m+1,) and of the middle row (n-1,), free while angles stay."""
        return {"column": self.lengths, "row": np.abs(np.diff(self.points))}

    def with_lengths(self, lengths: Mapping[str, Array]) -> Self:
        """The sheet with other lengths of column 1 (m+1,) and of the middle row (n-1,)."""
        edges = np.diff(self.points)
        steps = lengths["row"] * edges / np.abs(edges)
        points = self.points[0] + np.append(0.0, np.cumsum(steps))
        return replace(self, lengths=lengths["column"], points=points)

    def described_lengths(self) -> Mapping[str, Any]:
        """Nothing: reports say angles of these sheets."""
        return {}

    @property
    def least_turning(self) -> Self:
        """The sheet itself."""
        return self

    @property
    def target_drive(self) -> float:
        """Where the tightest panel column has the fold angle that its rest leaves it: pi if 0."""
        return target_drive(self._columns.rest)

    @property
    def end_drive(self) -> float:
        """The drive pi, at which the tightest row creases are folded flat."""
        return float(np.pi)

    def _sharpest_angle(self) -> float:
        """The smallest angle of the first and the last column at the target (radians)."""
        raise NotImplementedError

    def _stopped(self, stop: float) -> Self:
        """The sheet with a stop that it can have, its flaps as wide as they are."""
        return replace(self, stop=stop)

    @property
    def _existing(self) -> slice:
        """The n+2 columns (or n+1 panel columns, or n creases) less those of missing flaps."""
        return slice(int(self.flaps[0] == 0), None if self.flaps[1] else -1)

    def _freeze(self, *names: str) -> None:
        """Replace arrays with read-only copies of them."""
        for name in names:
            array = np.array(getattr(self, name))
            array.flags.writeable = False
            object.__setattr__(self, name, array)


def target_drive(rest: float) -> float:
    """Drive at which the tightest panel column is as open as its rest says (radians).

    Parameters
    ----------
    rest
        Its slope, or the share of its width that is left at the target; 0 for a flap.
    """
    return float(2 * np.arctan2(1.0, rest))


def other_side(whole: Array, part: Array | float) -> Array:
    """sqrt(whole**2 - part**2), 0 where they are alike but for rounding.

    A rounding error would be as large as its square root: creases that close together would not.
    """
    side = np.sqrt(np.maximum((whole - part) * (whole + part), 0.0))
    return np.asarray(np.where(whole - part <= ALIKE * whole, 0.0, side))


def running_sums(steps: NDArray[Any], start: int) -> NDArray[Any]:
    """Running sums (..., K+1) of steps (..., K) from a place on, where they are 0."""
    before = -np.cumsum(steps[..., :start][..., ::-1], axis=-1)[..., ::-1]
    zero = np.zeros((*steps.shape[:-1], 1))
    return np.concatenate([before, zero, np.cumsum(steps[..., start:], axis=-1)], axis=-1)


def running_products(turns: Complex) -> Complex:
    """Running products (..., K+1) of numbers (..., K) of modulus 1, beginning with 1."""
    ones = np.ones((*turns.shape[:-1], 1), dtype=np.complex128)
    return np.asarray(np.concatenate([ones, np.cumprod(turns, axis=-1)], axis=-1))


def middle_vertex(polyline: Staircase | Zigzag) -> Array:
    """The vertex (2,) of column 1 at lock that lies on g."""
    vertex: Array = polyline.vertices[len(polyline.vertices) // 2]
    return vertex


def upright(f: Trace, middle: Array, start: complex, axis: complex) -> Array:
    """f (N, 3) upright over an axis in g's plane, its point ``middle`` at g's start."""
    relative = f.points - middle
    across = start + relative[:, 0] * axis
    return np.stack([across.real, across.imag, relative[:, 1]], axis=-1)
