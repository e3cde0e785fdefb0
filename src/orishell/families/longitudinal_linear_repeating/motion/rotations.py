"""Rotations of panels as unit quaternions A + B i, with complex A = w + z k and B = x + y k.

A planar direction x + y k in the flat sheet is a complex number; the rules of quaternions leave
ordinary complex products, which act on whole arrays.
"""

from __future__ import annotations

from types import EllipsisType

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Complex

Index = int | slice | EllipsisType | None


@record
class Rotations:
    """An array of rotations."""

    # the two complex numbers of every quaternion (...)
    a: Complex
    b: Complex

    @classmethod
    def about(cls, axis: Complex, sine: Array, cosine: Array) -> Rotations:
        """Rotations about directions x + y k, from sine and cosine of half the angles."""
        b = sine * axis
        return cls(np.broadcast_to(cosine.astype(np.complex128), b.shape), b)

    @classmethod
    def of_vector(cls, vector: Array) -> Rotations:
        """Rotations about vectors (..., 3), by angles as large as their lengths (radians)."""
        angle = np.linalg.norm(vector, axis=-1)
        share = 0.5 * np.sinc(angle / (2 * np.pi))
        x, y, z = np.moveaxis(vector * share[..., None], -1, 0)
        return cls(np.cos(angle / 2) + 1j * z, x + 1j * y)

    def __getitem__(self, index: tuple[Index, ...]) -> Rotations:
        return Rotations(self.a[index], self.b[index])

    def __setitem__(self, index: tuple[Index, ...], value: Rotations) -> None:
        self.a[index], self.b[index] = value.a, value.b

    def __matmul__(self, other: Rotations) -> Rotations:
        """The rotation that makes first ``other``, then this."""
        return Rotations(
            self.a * other.a - self.b * other.b.conj(), self.a * other.b + self.b * other.a.conj()
        )

    def inverse(self) -> Rotations:
        """The inverse rotations."""
        return Rotations(self.a.conj(), -self.b)

    def normalised(self) -> Rotations:
        """The rotations as unit quaternions, freed of rounding."""
        a, b = self.a, self.b
        share = 1 / np.sqrt(a.real**2 + a.imag**2 + b.real**2 + b.imag**2)
        return Rotations(a * share, b * share)

    def turned(self, planar: Complex) -> Array:
        """Images (..., 3) of planar vectors x + y k."""
        a, b = self.a, self.b
        across = a * planar
        plane = a * across + b * b * planar.conj()
        out = np.empty((*plane.shape, 3))
        out[..., 0], out[..., 1] = plane.real, plane.imag
        out[..., 2] = 2 * (across.imag * b.real - across.real * b.imag)
        return out


def running_products(steps: Rotations) -> Rotations:
    """Products 1, q_1, q_1 q_2, ... (..., K+1) of rotations (..., K), by doubling."""
    one = np.ones((*steps.a.shape[:-1], 1), np.complex128)
    products = Rotations(
        np.concatenate([one, steps.a], axis=-1), np.concatenate([0 * one, steps.b], axis=-1)
    )
    reach = 1
    while reach < products.a.shape[-1]:
        joined = (products[..., :-reach] @ products[..., reach:]).normalised()
        products = Rotations(
            np.concatenate([products.a[..., :reach], joined.a], axis=-1),
            np.concatenate([products.b[..., :reach], joined.b], axis=-1),
        )
        reach *= 2
    return products


def multiply_on(products: Rotations, steps: Rotations, places: range) -> None:
    """Fill rows of rotations (..., K+1, n) from row to row by steps (..., K, n) between them.

    places: Of the steps, in their order, from the row that is known: upwards or downwards.
    """
    conjugate, b_conjugate = steps.a.conj(), steps.b.conj()
    ahead = int(places.step > 0)
    for i in places:
        a, b = products.a[..., i + 1 - ahead, :], products.b[..., i + 1 - ahead, :]
        np.subtract(
            a * steps.a[..., i, :], b * b_conjugate[..., i, :], out=products.a[..., i + ahead, :]
        )
        np.add(a * steps.b[..., i, :], b * conjugate[..., i, :], out=products.b[..., i + ahead, :])
