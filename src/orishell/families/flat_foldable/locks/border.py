r"""The straight border beside which a column of flaps folds flat.

A row crease that folds by 2 arctan(x t) ends at a border column that is straight there, at the
sector a below it. If all of them have one y with

    x cos a = +-y,

its sign changing from row to row, a column of panels beside the border can fold with the sheet,
whose row creases leave the border at sectors a' with

    tan a' = tau tan a,

whichever tau. With tau = y/sqrt(1 + y^2) its row creases fold flat exactly at t = 1, all of them:
then sin a' = sin a sin(rho/2), rho what the row's crease is folded by there, which is the condition
of a vertex whose opposite crease folds flat. Here a' is on the other side of the row than a, so
that the border's crease folds less.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import DesignError
from orishell.conventions.record import record
from orishell.numerics.arrays import Array

STRAIGHT = 1e-9
"""Sines of angles between creases below this are rounding."""


@record
class Border:
    """A straight border of a flat sheet, as it folds with a column of flaps beside it."""

    vertices: Array  # (R+2, 2), from the first row to the last
    down: Array  # (2,), unit vector along it
    outward: Array  # (2,), unit vector square to it
    x: Array  # (R,), tangents of half the fold angles of its row creases at t = 1, signed
    y: float  # of the column crease that would go straight on, without sign
    signs: Array  # (R,) of x cos a, +-1 by turns

    @classmethod
    def of(cls, flat: Array, x: Array, *, left: bool) -> Border:
        """That of a flat sheet (2, R+2, C+2) whose row creases at it have tangents x (R,).

        Raises
        ------
        DesignError
            If it is not straight, or its rows would fold a column beside it differently.
        """
        column, beside = (0, 1) if left else (-1, -2)
        vertices = flat[:, :, column].T
        whole = vertices[-1] - vertices[0]
        down = whole / _lengths(whole)
        outward = np.array([-down[1], down[0]]) * (-1 if left else 1)
        steps = np.diff(vertices, axis=0)
        off = np.abs(steps @ outward / _lengths(steps)).max()
        if not off <= STRAIGHT:
            raise _not_straight(left, f"edges of the border are up to {off:.2g} of their length "
                                "off a straight line")  # fmt: skip
        inward = flat[:, 1:-1, beside].T - vertices[1:-1]
        shares = x * (inward @ down) / _lengths(inward)
        signs = np.where(np.arange(len(x)) % 2 == 0, 1.0, -1.0)
        signs = signs if (signs * shares).sum() >= 0 else -signs
        y = float((signs * shares).mean())
        off = np.abs(signs * shares - y).max()
        if not off <= STRAIGHT * max(1.0, y):
            raise _not_straight(left, "rows would fold it by tangents that differ by up to "
                                f"{off:.2g}")  # fmt: skip
        return cls(vertices, down, outward, x, y, signs)

    @property
    def edge(self) -> float:
        """Mean length of its edges."""
        return float(_lengths(np.diff(self.vertices, axis=0)).mean())

    def leaning(self, further: float) -> Array:
        """Cotangents (R,) of a', the sectors below the flaps' row creases.

        further: t^2 at which these fold flat.
        """
        size = np.abs(self.x)
        sine = np.sqrt((size - self.y) * (size + self.y)) / size
        lean = np.sqrt((1 + further * self.y**2) / further) / (size * sine)
        return np.asarray(-self.signs * np.sign(self.x) * lean)

    def flap(self, width: float, further: float) -> Array:
        """Outer vertices (R+2, 2) of flaps of a width, parallelograms at both ends."""
        along = width * self.leaning(further)
        along = np.concatenate([along[:1], along, along[-1:]])
        return self.vertices + width * self.outward + along[:, None] * self.down

    def widest(self, further: float) -> float:
        """The width at which two row creases of the flaps meet."""
        closing = -np.diff(self.leaning(further))
        steps = _lengths(np.diff(self.vertices[1:-1], axis=0))
        meeting = closing > 0
        return float((steps[meeting] / closing[meeting]).min(initial=np.inf))


def _not_straight(left: bool, size: str) -> DesignError:
    side = "left" if left else "right"
    return DesignError(
        f"a column of flaps needs a straight border, and the {side} border is not",
        keys=("pattern.flap",),
        size=size,
    )


def _lengths(vectors: Array) -> Array:
    return np.asarray(np.linalg.norm(vectors, axis=-1))
