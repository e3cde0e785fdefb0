r"""What sheets with flaps share that fold flat at the target: their drive, and their stop.

Flaps fold flat at t = sqrt(E): at the target, t = 1, or beyond it if they are to stop short of that
there. The drive rho = 2 phi runs to pi where they do, with

    t = sqrt(E) sin phi.

So row creases of the sheet fold by 2 arctan(x sin phi), x being sqrt(E) times its tangent of half a
fold angle at the target, and its column creases likewise. Row creases of flaps fold by

    2 arctan(sqrt(1 + x^2) tan phi):

the root of a flap's vertex, 1 - (t/sqrt(E))^2, is cos(phi)^2, so that all angles are smooth up to
the lock. A flap's crease has the fold angle pi - 2 stop at the target if

    E = (1 + T)/(1 - X^2 T),   T = tan(stop)^2,

X being the largest of all x at the target: the flap that folds most is beside it.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property
from typing import Any, ClassVar, Self

import numpy as np

from orishell.families.flat_foldable.mechanism import FlatFoldable
from orishell.families.shared.candidates import refuse_stop
from orishell.families.shared.chains import Rates
from orishell.numerics.arrays import Array


class Locked:
    """A flat-foldable sheet with flaps."""

    __dataclass_fields__: ClassVar[dict[str, Any]]  # every sheet is a dataclass

    bare: FlatFoldable
    stop: float  # by how much flaps stop short of folding flat at the target (radians)

    def without_flaps(self) -> FlatFoldable:
        """The sheet without its flaps."""
        return self.bare

    def with_stop(self, stop: float) -> Self:
        """The sheet whose flaps, as wide as they are, stop short of folding flat by this angle.

        Raises
        ------
        DesignError
            If its flaps would fold no further than the row creases beside them.
        """
        limit = float(np.arctan(1 / self._steepest))
        if stop >= limit:
            raise refuse_stop(stop, limit, "where they fold as far as the row creases beside them")
        return replace(self, stop=stop)

    @property
    def least_turning(self) -> Self:
        """The sheet whose middle crease stays where it is."""
        return replace(self, bare=self.bare.least_turning)

    @property
    def target_drive(self) -> float:
        """The drive at which t is 1: pi without a stop."""
        return float(2 * np.arctan2(1.0, np.sqrt(self._beyond)))

    @property
    def end_drive(self) -> float:
        """180 degrees: flaps are folded flat."""
        return float(np.pi)

    @cached_property
    def _steepest(self) -> float:
        """The largest tangent of half a fold angle of a row crease at the target."""
        return float(np.abs(self.bare.sheet.net.x).max())

    @cached_property
    def _beyond(self) -> float:
        """E - 1."""
        square, steepest = np.tan(self.stop) ** 2, self._steepest**2
        return float(square * (1 + steepest) / (1 - steepest * square))

    @property
    def _further(self) -> float:
        """E, t^2 where flaps fold flat."""
        return 1 + self._beyond

    @property
    def _spin(self) -> float:
        """Rate at which the sheet turns as a whole."""
        return float(np.linalg.norm(self.bare.turn)) / self.target_drive

    @cached_property
    def _tangents(self) -> tuple[Array, Array]:
        """Of half the fold angles where flaps fold flat, (R, C+1, 1) and (R+1, C, 1)."""
        row, column = self.bare.sheet.tangents()
        root = np.sqrt(self._further)
        return root * row, root * column


def sine_rates(m: Array, start: Array, stop: Array) -> Rates:
    """Of 2 arctan(m sin(rho/2)), for m (K,) between drives (S,).

    The rate m cos/(1 + m^2 sin^2) falls, and the size of its derivative is

        (m/2) sin (1 + 2 m^2 - m^2 sin^2)/(1 + m^2 sin^2)^2.
    """
    m = m[:, None]
    low, high = np.sin(0.5 * start), np.sin(0.5 * stop)

    def rate(drive: Array) -> Array:
        return m * np.maximum(np.cos(0.5 * drive), 0.0) / (1 + (m * np.sin(0.5 * drive)) ** 2)

    base = 1 + (m * low) ** 2
    second = 0.5 * m * high * (1 + 2 * m * m - (m * low) ** 2) / base**2
    return Rates(rate(stop), rate(start), second)
