"""A flat degree-4 vertex in closed form: from one of its creases to the others, without branches.

Derived in docs/theory/vertex.md. Four creases left, right, up, down; s and c are sine and cosine of
half a fold angle. A vertex moves in one of two ways: its row creases have one sign and its column
creases two (mode 1), or the other way round (mode -1). Opposite creases fold by sines in a constant
proportion; from the left crease v, with the right one o beyond it, to the upper crease u

    c_u : s_u = B c_v + P c_o : -A s_v                      (mode 1)
    c_u : s_u = C c_v^2 + D s_v^2 : -s_v (B c_v + P c_o)    (mode -1),

and from u to v the same with A and C, and the modes, exchanged.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.record import record

Numbers = NDArray[Any]
Half = tuple[Numbers, Numbers]
"""Sines and cosines of half the fold angles."""
NONE = 1e-14
"""A sine below this is that of no angle, but for rounding."""


@record
class Vertices:
    """Constants of flat vertices (...)."""

    mode: Numbers
    A: Numbers
    B: Numbers
    C: Numbers
    D: Numbers
    P: Numbers
    sectors: Numbers  # their sines (2, 2, ...), at the left and right, above and below

    @classmethod
    def of(cls, flat: Numbers, mode: Numbers) -> Vertices:
        """Those of the inner vertices of a flat sheet (2, R+2, C+2, ...), modes (R, C, ...)."""
        return cls.of_ways(ways(flat), mode)

    @classmethod
    def of_ways(cls, there: Numbers, mode: Numbers) -> Vertices:
        """Those of vertices from which creases go there (4, 2, ...), see ``ways``; modes (...)."""
        right, up, left, down = there
        ru, lu, ld, rd = (
            crosses(*pair) for pair in ((right, up), (up, left), (left, down), (down, right))
        )
        diagonal = ld * dots(right, up) + dots(left, down) * ru
        return cls(
            mode,
            A=ld * _but_for_rounding(crosses(right, left)),
            B=ld * ru,
            C=ru * _but_for_rounding(crosses(up, down)),
            D=lu * _but_for_rounding(diagonal),
            P=np.sqrt(lu * ld * ru * rd),
            sectors=np.stack([np.stack([lu, ld]), np.stack([ru, rd])]),
        )

    @property
    def beyond_row(self) -> Numbers:
        """Sizes (...) of sines of right creases by those of left ones."""
        (lu, ld), (ru, rd) = self.sectors
        return np.asarray(np.sqrt(lu * ld / (ru * rd)))

    @property
    def beyond_column(self) -> Numbers:
        """Sizes (...) of sines of lower creases by those of upper ones."""
        (lu, ld), (ru, rd) = self.sectors
        return np.asarray(np.sqrt(lu * ru / (ld * rd)))

    @property
    def turned(self) -> Vertices:
        """The vertices with rows and columns (R, C, ...) exchanged."""
        mode, A, B, C, D, P = (
            each.swapaxes(0, 1) for each in (-self.mode, self.C, self.B, self.A, self.D, self.P)
        )
        return Vertices(mode, A, B, C, D, P, self.sectors.swapaxes(0, 1).swapaxes(2, 3))

    def at(self, *which: int | slice) -> Vertices:
        """Those of some rows and columns."""
        mode, A, B, C, D, P = (
            each[which] for each in (self.mode, self.A, self.B, self.C, self.D, self.P)
        )
        return Vertices(mode, A, B, C, D, P, self.sectors[:, :, *which])

    def above(self, left: Half, beyond: Numbers) -> Half:
        """Sines and cosines of half the fold angles of upper creases.

        A cosine below 0 says that a crease has closed before.

        left: Sines and cosines of left creases.
        beyond: Cosines of right creases.
        """
        s, c = left
        base = self.B * c + self.P * beyond
        first, side = self.mode > 0, np.sign(self.C.real)
        sine = np.where(first, -self.A * s, -side * s * base)
        cosine = np.where(first, base, side * (self.C * c * c + self.D * s * s))
        size = np.sqrt(sine * sine + cosine * cosine)
        return sine / size, cosine / size


def ways(flat: Numbers) -> Numbers:
    """Unit vectors (4, 2, R, C, ...) from inner vertices to the right, up, to the left and down."""
    there = (
        flat[:, 1:-1, 2:], flat[:, :-2, 1:-1], flat[:, 1:-1, :-2], flat[:, 2:, 1:-1]
    )  # fmt: skip
    found = np.stack(there) - flat[:, 1:-1, 1:-1]
    return np.asarray(found / np.sqrt((found * found).sum(axis=1, keepdims=True)))


def crosses(first: Numbers, second: Numbers) -> Numbers:
    """Sines (...) of the angles from unit vectors (2, ...) to others, counter-clockwise."""
    return np.asarray(first[0] * second[1] - first[1] * second[0])


def dots(first: Numbers, second: Numbers) -> Numbers:
    """Cosines (...) of the angles between unit vectors (2, ...)."""
    return np.asarray((first * second).sum(axis=0))


def _but_for_rounding(sines: Numbers) -> Numbers:
    return sines - np.where(np.abs(sines.real) < NONE, sines.real, 0.0)
