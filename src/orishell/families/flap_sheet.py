"""What the sheets of the paper's sections 2 and 3 share: flaps, whose clash ends the motion."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, ClassVar, Self

import numpy as np

from orishell.numerics.arrays import Array, Complex
from orishell.sheet.grid import Grid

ALIKE = 1e-14
"""Lengths that differ by less than this share are alike but for rounding."""


class FlapSheet:
    """A grid whose first and last column of panels are flaps, or which has none there.

    Parameters
    ----------
    lengths
        Edge lengths of the first column (m+1,), m odd, in the unit of the curves.
    points
        The middle row at lock (n,), n at least 2: vertices of g's polyline.
    flaps
        Size of the left and the right flap (length); 0 where there is none.
    """

    __slots__ = ()
    __dataclass_fields__: ClassVar[dict[str, Any]]  # every sheet is a dataclass

    lengths: Array
    points: Complex
    flaps: tuple[float, float]

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
        return replace(self, flaps=(0.0, 0.0))

    @property
    def still(self) -> Self:
        """The sheet itself."""
        return self

    @property
    def target_drive(self) -> float:
        """Where the tightest panel column has the fold angle that its rest leaves it: pi if 0."""
        return target_drive(self._rest)

    @property
    def end_drive(self) -> float:
        """The drive pi, at which the tightest row creases are folded flat."""
        return float(np.pi)

    @property
    def _rest(self) -> float:
        """How far the tightest panel column is open at the target, as the mechanism says."""
        raise NotImplementedError

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
    """Return the drive at which the tightest panel column is as open as its rest says (radians).

    Parameters
    ----------
    rest
        Its slope, or the share of its width that is left at the target; 0 for a flap.
    """
    return float(2 * np.arctan2(1.0, rest))


def other_side(whole: Array, part: Array | float) -> Array:
    """Return sqrt(whole**2 - part**2), 0 where they are alike but for rounding.

    A rounding error would be as large as its square root: creases that close together would not.

    Parameters
    ----------
    whole, part
        Hypotenuse and one side of right triangles (...), in any unit of length.
    """
    side = np.sqrt(np.maximum((whole - part) * (whole + part), 0.0))
    return np.asarray(np.where(whole - part <= ALIKE * whole, 0.0, side))
