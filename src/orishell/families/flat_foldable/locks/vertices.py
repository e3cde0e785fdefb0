r"""Border vertices with two flaps each, which fold flat upon each other at the lock.

Row by row a crease of the sheet ends at a border vertex, at sectors LU and LD, and goes on beyond
it as the crease between two flaps, at sectors RU and RD: a developable vertex of four creases.
Opposite creases of such a vertex keep

    sin LU sin LD sin^2(rho_L/2) = sin RU sin RD sin^2(rho_R/2),

so that the flaps fold flat exactly where rho_L is 2 arctan x, if

    cos(RU - RD) = 2 sin LU sin LD x^2/(1 + x^2) + cos(LU + LD),   RU + RD = 2 pi - LU - LD.

With tan(rho_L/2) = x sin phi the conic of docs/theory/vertex.md has the solutions

    tan(rho_D/2) = -x sin(RD + LD) sin phi / (a + b cos phi),
    a = sin RD,   b^2 = sin RD sin RU sin LD / sin LU,

and others with -b, of which one crease passes 180 degrees before the lock. The crease rho_U has U
and D exchanged.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import DesignError
from orishell.conventions.record import record
from orishell.families.shared.chains import Rates
from orishell.numerics.arrays import Array

FULL = 0.49
"""Flaps are hinged to this share of the edge of the border on their side of the vertex."""
ROOM = 0.9
"""Flaps leave this share of that to the crease between them."""


@record
class FlapVertices:
    """Border vertices of the rows (R,) of one side. Axis 0 of (2, R): up, then down."""

    x: Array  # (R,), signed tangents of half the fold angles of the row creases at the lock
    inner: Array  # (2, R), sectors of the sheet, LU and LD
    outer: Array  # (2, R), sectors of the flaps, RU and RD
    hinges: Array  # (2, R), lengths along which flaps are hinged to the border
    crease: Array  # (R,), lengths of the creases between two flaps

    @classmethod
    def of(cls, flat: Array, x: Array, width: float, *, left: bool) -> FlapVertices:
        """Those of a flat sheet (2, R+2, C+2) whose row creases at a border lock at tangents x.

        width: Of flaps, square to their hinges, at most (length).

        Raises
        ------
        DesignError
            If a row has no such flaps.
        """
        column, beside = (0, 1) if left else (-1, -2)
        border, here = flat[:, :, column], flat[:, 1:-1, column]
        edges = np.stack([border[:, :-2] - here, border[:, 2:] - here])  # (2, 2, R)
        inner = _angles(edges, flat[:, 1:-1, beside] - here)
        outer = _outer(inner, x, left=left)
        hinges = FULL * np.linalg.norm(edges, axis=1)
        wide = width / np.sin(outer).max(axis=0)
        reach = np.maximum(np.cos(outer), 0)
        most = (ROOM * hinges / np.where(reach > 0, reach, 1.0)).min(
            axis=0, where=reach > 0, initial=np.inf
        )
        return cls(x, inner, outer, hinges, np.minimum(wide, most))

    @property
    def widths(self) -> Array:
        """Of flaps square to their hinges (2, R)."""
        return np.asarray(self.crease * np.sin(self.outer))

    @property
    def radii(self) -> Array:
        """Largest distances (R,) of points of flaps from the border vertex."""
        along = self.hinges
        return np.asarray(np.maximum(np.hypot(along, self.widths).max(axis=0), self.crease))

    def _terms(self) -> tuple[Array, Array, Array]:
        """k, a and b (2, R): tangents of half the fold angles are k sin phi/(a + b cos phi)."""
        k = -self.x * np.sin(self.outer + self.inner)
        a = np.sin(self.outer)
        inner = np.sin(self.inner)
        return k, a, np.sqrt(a * a[::-1] * inner / inner[::-1])

    def hinge_folds(self, phi: Array) -> tuple[Array, Array]:
        """Cosines and sines (2, R, B) of the fold angles at the border, valley positive."""
        k, a, b = (each[..., None] for each in self._terms())
        near, far = a + b * np.cos(phi), k * np.sin(phi)
        square = near**2 + far**2
        return (near**2 - far**2) / square, 2 * near * far / square

    def crease_folds(self, phi: Array) -> Array:
        """Fold angles (..., R) between flaps, for phi (...)."""
        cosine = np.where(phi == 0.5 * np.pi, 0.0, np.cos(phi))[..., None]
        sine = np.sign(self.x) * np.hypot(1.0, self.x) * np.sin(phi)[..., None]
        return np.asarray(2 * np.arctan2(sine, cosine))

    def rates(self, start: Array, stop: Array) -> Rates:
        """Of the creases at the border (2 R, S), between drives 2 phi (S,).

        With c = cos phi, P = a c + b and q = k^2 (1 - c^2) + (a + b c)^2 the fold angle rho has

            d rho/d phi = 2 k P/q,   d^2 rho/d phi^2 = 2 k sin phi (P dq/dc - a q)/q^2.

        Polynomials of second degree in c have their extremes at the ends or at their vertex.
        """
        k, a, b = (np.abs(each).ravel()[:, None] for each in self._terms())
        most, least = np.cos(0.5 * start), np.maximum(np.cos(0.5 * stop), 0.0)
        square, linear, constant = b * b - k * k, 2 * a * b, a * a + k * k
        low, high = _range(square, linear, constant, least, most)
        first = k * (a * least + b) / high, k * (a * most + b) / low
        # P dq/dc - a q, by powers of c.
        bent = _range(a * square, 2 * b * square, b * linear - a * constant, least, most)
        largest = np.maximum(np.abs(bent[0]), np.abs(bent[1]))
        return Rates(*first, 0.5 * k * np.sin(0.5 * stop) * largest / low**2)


def _range(
    square: Array, linear: Array, constant: Array, least: Array, most: Array
) -> tuple[Array, Array]:
    """Smallest and largest values of polynomials of second degree over intervals."""

    def at(c: Array) -> Array:
        return (square * c + linear) * c + constant

    with np.errstate(divide="ignore", invalid="ignore"):
        vertex = np.where(square != 0, -0.5 * linear / square, least)
    values = np.stack(np.broadcast_arrays(at(least), at(most), at(np.clip(vertex, least, most))))
    return values.min(axis=0), values.max(axis=0)


def _angles(edges: Array, inward: Array) -> Array:
    """Angles (2, R) between edges (2, 2, R) of the border and row creases (2, R)."""
    dots = (edges * inward).sum(axis=1)
    crosses = edges[:, 0] * inward[1] - edges[:, 1] * inward[0]
    return np.asarray(np.arctan2(np.abs(crosses), dots))


def _outer(inner: Array, x: Array, *, left: bool) -> Array:
    """Sectors RU and RD (2, R) of flaps, so that creases at the border fold as little as can be."""
    product = np.sin(inner).prod(axis=0)
    total = 2 * np.pi - inner.sum(axis=0)
    cosine = 2 * product * x * x / (1 + x * x) + np.cos(inner.sum(axis=0))
    apart = np.arccos(np.clip(cosine, -1.0, 1.0))
    # The smaller sector of flaps is beside the larger one of the sheet.
    apart = np.where(inner[0] < inner[1], apart, -apart)
    outer = 0.5 * np.stack([total + apart, total - apart])
    bad = (np.abs(cosine) > 1) | (outer >= np.pi).any(axis=0) | (outer <= 0).any(axis=0)
    if bad.any():
        row = int(np.flatnonzero(bad)[0]) + 1
        raise DesignError(
            f"no flaps beside the {'left' if left else 'right'} border fold flat at the target",
            keys=("pattern.flap",),
            place=f"at row {row}",
            size=f"{int(bad.sum())} of {len(bad)} rows have none",
        )
    return outer
