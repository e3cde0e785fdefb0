"""How f is carried along g: sliding without turning, or turning with g."""

from __future__ import annotations

from abc import ABC, abstractmethod

import numpy as np

from orishell.conventions.record import record
from orishell.design.path import Path
from orishell.numerics.arrays import Array, Complex, Integers

NEWTON_STEPS = 8
MET = 1e-9
"""Curves beside g meet when they come this near, relative to g's length."""


@record
class Rail(ABC):
    """Carries points x of f's horizontal axis along its path, g.

    A place along g is a number u: the count of corners of g before it plus its share of the
    stretch between two corners.
    """

    path: Path

    @property
    def stop(self) -> float:
        """The largest u; the smallest is 0."""
        return float(len(self.path))

    @abstractmethod
    def carry(self, u: Array, x: Array) -> tuple[Array, Array, Array]:
        """Where x (...) is at u (...), the tangent along g and f's axis there, (..., 3) each.

        The axis is as long as f is stretched along it.
        """

    @abstractmethod
    def beside(self, reach: tuple[float, float]) -> Array:
        """Return how far from each piece of g (K,) curves run that turn with it, x in ``reach``."""

    def stations(self, step: float, sagitta: float, reach: tuple[float, float]) -> Array:
        """Return places u (A,) from 0 to ``stop``, corners included.

        ``step`` and ``sagitta`` are those of :meth:`Path.stations`, for x in the range ``reach``.
        """
        return self.path.stations(step, sagitta, self.beside(reach))

    def bulge(self, u: Array, reach: tuple[float, float]) -> float:
        """Return how far curves at x in ``reach`` leave chords between places u (A,), at most."""
        return self.path.bulge(u, self.beside(reach))


@record
class Sliding(Rail):
    """f slides along g and stays parallel to itself."""

    axis: complex  # unit direction of f's horizontal axis, as a complex number
    # angle by which g's plane rises along the axis from g's first point (radians)
    tilt: float = 0.0

    def carry(self, u: Array, x: Array) -> tuple[Array, Array, Array]:
        """Where x (...) is at u (...), the tangent along g and the axis, (..., 3) each."""
        piece, share = _piece(u, len(self.path))
        point, heading, _ = self.path.at(piece, share * self.path.lengths[piece])
        start = complex(*self.path.trace.points[0])
        axis = np.array([self.axis.real, self.axis.imag, 0.0])
        place = _in_space(np.asarray(start)) + self._tilted(point - start)
        along = self._tilted(np.exp(1j * heading))
        points = place + x[..., None] * axis
        return points, np.broadcast_to(along, points.shape), np.broadcast_to(axis, points.shape)

    def beside(self, reach: tuple[float, float]) -> Array:
        """Zeros (K,): the curves of all points of f are copies of g."""
        return np.zeros(len(self.path))

    def _tilted(self, step: Complex) -> Array:
        """Steps (...) in g's plane as vectors (..., 3)."""
        along = (step * self.axis.conjugate()).real
        out = _in_space(step + (np.cos(self.tilt) - 1) * along * self.axis)
        out[..., 2] = np.sin(self.tilt) * along
        return out


@record
class Turning(Rail):
    """f turns with g: its axis is g's tangent turned clockwise by ``plane``.

    At a corner of g what is carried along either side goes on straight until the two meet, as
    in a mitre joint.
    """

    plane: float  # angle from f's plane to g's tangent, in (0, pi) (radians)
    # stretch f along its axis by lambda with lambda'/lambda = cot(plane) times the turning of g, 1
    # at its beginning, so that f's points are carried parallel to g; otherwise f is rigid
    affine: bool = False

    def carry(self, u: Array, x: Array) -> tuple[Array, Array, Array]:
        """Where x (...) is at u (...), the tangent along g and the axis, (..., 3) each."""
        piece, share = _piece(u, len(self.path))
        length = self.path.lengths[piece]
        if len(self.path) == 1:
            begin, end = np.zeros(()), length
        else:
            begin, end = self._ends(piece, x)
            end = length + end
        point, along, axis = self._beside(piece, begin + share * (end - begin), x)
        along, axis = np.broadcast_arrays(along, axis, point)[:2]
        return _in_space(point), _in_space(along), _in_space(axis)

    def beside(self, reach: tuple[float, float]) -> Array:
        """How far from each piece (K,) f reaches."""
        return np.asarray(max(abs(x) for x in reach) * self.scales().max(axis=-1))

    def scales(self) -> Array:
        """The stretch lambda at the beginning and the end of every piece (K, 2)."""
        trace, nodes = self.path.trace, self.path.nodes
        turn = trace.arriving[nodes[1:]] - trace.heading[nodes[:-1]]
        if not self.affine:
            return np.ones((len(self.path), 2))
        grown = np.exp(turn / np.tan(self.plane))
        half = 0.5 * self.path.corner_turns()
        jump = np.sin(self.plane + half) / np.sin(self.plane - half)
        begin = np.cumprod(np.concatenate([[1.0], grown[:-1] * jump]))
        return np.stack([begin, begin * grown], axis=-1)

    def scale_range(self) -> tuple[float, float]:
        """The smallest and the largest stretch lambda along g."""
        trace, nodes = self.path.trace, self.path.nodes
        piece = self.path.of_cells
        turned = trace.heading[:-1] - trace.heading[nodes[piece]]
        inner = self.scales()[piece, 0] * np.exp(turned / np.tan(self.plane))
        every = np.concatenate([inner, self.scales().ravel()])
        return float(every.min()), float(every.max())

    def _beside(self, piece: Integers, arc: Array, x: Array) -> tuple[Complex, Complex, Complex]:
        """Points (...) of the curve that x is carried along, its derivative by arc, the axis."""
        point, heading, bend = self.path.at(piece, arc)
        direction = np.exp(1j * heading)
        axis = direction * np.exp(-1j * self.plane)
        if self.affine:
            first = self.path.trace.heading[self.path.nodes[piece]]
            axis *= self.scales()[piece, 0] * np.exp((heading - first) / np.tan(self.plane))
            growth = np.abs(axis) * direction / np.sin(self.plane)
        else:
            growth = 1j * axis
        return point + x * axis, direction + x * bend * growth, axis

    def _ends(self, piece: Integers, x: Array) -> tuple[Array, Array]:
        """How far (...) a carried curve begins after its piece begins, and ends after it ends."""
        first, last = piece == 0, piece == len(self.path) - 1
        begin = self._meeting(np.maximum(piece - 1, 0), x)[1]
        end = self._meeting(np.minimum(piece, len(self.path) - 2), x)[0]
        return np.where(first, 0.0, begin), np.where(last, 0.0, end)

    def _meeting(self, corner: Integers, x: Array) -> tuple[Array, Array]:
        """Where the curves beside g meet at corners (...): arcs from the corner, before and after.

        The straight continuations meet in a mitre; where it is g's pieces themselves that are cut
        off, and they are curved, Newton's method goes on from there.
        """
        trace = self.path.trace
        node = self.path.nodes[1:-1]
        directions = np.exp(1j * np.stack([trace.arriving[node], trace.heading[node]]))
        scales = self.scales()
        axes = directions * np.exp(-1j * self.plane) * np.stack([scales[:-1, 1], scales[1:, 0]])
        across = (directions[0].conj() * directions[1]).imag
        gap = axes[1] - axes[0]
        before = (gap * directions[1].conj()).imag / (directions[0] * directions[1].conj()).imag
        after = (gap * directions[0].conj()).imag / -across
        before, after = (
            np.broadcast_to(each[corner] * x, np.broadcast(corner, x).shape).copy()
            for each in (before, after)
        )
        curved = ~self.path.straight
        cut = (curved[corner] & (before < 0)) | (curved[corner + 1] & (after > 0))
        if cut.any():
            places = np.broadcast_to(corner, cut.shape)[cut]
            of = np.broadcast_to(x, cut.shape)[cut]
            before[cut], after[cut] = self._polished(places, of, before[cut], after[cut])
        return before, after

    def _polished(
        self, corner: Integers, x: Array, before: Array, after: Array
    ) -> tuple[Array, Array]:
        """Where curves (N,) beside g meet: by Newton's method, from where their tangents meet."""
        arcs = np.stack([before, after])
        length = self.path.lengths[corner]
        for _ in range(NEWTON_STEPS):
            p, u, _ = self._beside(corner, length + arcs[0], x)
            q, v, _ = self._beside(corner + 1, arcs[1], x)
            gap, cross = q - p, (u.conj() * v).imag
            cross = np.where(cross == 0, np.inf, cross)
            arcs += np.stack([(gap.conj() * v).imag, (gap.conj() * u).imag]) / cross
        p = self._beside(corner, length + arcs[0], x)[0]
        q = self._beside(corner + 1, arcs[1], x)[0]
        met = np.abs(q - p) <= MET * self.path.trace.length
        return np.where(met, arcs[0], before), np.where(met, arcs[1], after)


def _piece(u: Array, count: int) -> tuple[Integers, Array]:
    piece = np.clip(np.floor(u), 0, count - 1).astype(np.intp)
    return piece, u - piece


def _in_space(flat: Complex) -> Array:
    """Horizontal vectors (..., 3) of complex numbers (...)."""
    return np.stack([flat.real, flat.imag, np.zeros(flat.shape)], axis=-1)
