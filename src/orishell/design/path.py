"""A trace cut at its corners into smooth pieces, each going on straight beyond its ends."""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.curves import Trace
from orishell.curves.trace import SMALLEST_CELL
from orishell.numerics.arrays import Array, Booleans, Complex, Integers

EVEN = 1e-6
"""Stations that the whole curve needs at least: they are even where nothing else asks for more."""
COUNT_ROUNDING = 1e-9
"""A count of chords that exceeds a whole number by less than this share, as sums of parts do by
rounding, is that number."""
FEW_CORNERS = 64
"""Up to this many corners are all kept."""


@record
class Path:
    """The pieces of a curve, its trace, between its corners.

    Points and directions are complex numbers x + iy.
    """

    trace: Trace
    nodes: Integers  # samples (K+1,) of the trace at which its K pieces begin and end
    last: Array  # the last parameter (K,) at which the curve's derivative is that of the piece

    @classmethod
    def of(cls, trace: Trace) -> Path:
        """Cut a trace at its corners."""
        nodes = np.concatenate([[0], trace.corners, [len(trace.t) - 1]])
        ends = nodes[1:]
        last = np.nextafter(trace.t[ends], -np.inf)
        # A corner that was found inside the smallest cell stands at this cell's end.
        tiny = trace.t[ends] - trace.t[ends - 1] <= 2 * SMALLEST_CELL * np.ptp(trace.t)
        last = np.where(tiny, trace.t[ends - 1], last)
        last[-1] = trace.t[-1]
        return cls(trace, nodes, last)

    def __len__(self) -> int:
        return len(self.nodes) - 1

    @property
    def lengths(self) -> Array:
        """Arc lengths (K,) of the pieces."""
        return np.asarray(np.diff(self.trace.arc[self.nodes]))

    @property
    def straight(self) -> Booleans:
        """Which of the pieces (K,) are straight."""
        return np.asarray(np.add.reduceat(np.abs(self.trace.turns), self.nodes[:-1]) < 1e-9)

    @property
    def of_cells(self) -> Integers:
        """The piece (N-1,) that each cell of the trace, from sample to sample, belongs to."""
        return np.repeat(np.arange(len(self)), np.diff(self.nodes))

    def corner_turns(self) -> Array:
        """Turns (K-1,) at the corners, positive to the left (radians)."""
        at = self.nodes[1:-1]
        return np.asarray(self.trace.heading[at] - self.trace.arriving[at])

    def at(self, piece: Integers, arc: Array) -> tuple[Complex, Array, Array]:
        """Points, directions (radians, continuous along a piece) and curvatures on pieces (...).

        ``arc`` (...) counts from the beginning of the piece; beyond its ends the curve goes on
        straight.
        """
        trace = self.trace
        inside = np.clip(arc, 0.0, self.lengths[piece])
        at = trace.arc[self.nodes[piece]] + inside
        t = np.interp(at, trace.arc, trace.t)
        within = np.minimum(t, self.last[piece])
        position, first, second = trace.curve.jet(within)
        late = t > within
        if late.any():
            position = np.where(late[..., None], trace.curve.position(t), position)
        rough = np.interp(within, trace.t, trace.heading)
        turned = np.arctan2(first[..., 1], first[..., 0]) - rough
        heading = rough + np.mod(turned + np.pi, 2 * np.pi) - np.pi
        speed = np.hypot(first[..., 0], first[..., 1])
        bend = (first[..., 0] * second[..., 1] - first[..., 1] * second[..., 0]) / speed**3
        beyond = arc - inside
        point = position @ np.array([1, 1j]) + beyond * np.exp(1j * heading)
        return point, heading, np.where(beyond == 0, bend, 0.0)

    def stations(self, step: float, sagitta: float, reach: Array) -> Array:
        """Places along the path, as piece + share of the piece, close enough to join by chords.

        Neighbours are at most a ``step`` apart, chords a ``sagitta`` from the curve, about
        (length). Curves that go beside each piece on its outer side, as far as ``reach`` (K,) away,
        count too; it is 0 for the path itself. Pieces that are too short to matter share a chord
        with the next.
        """
        trace = self.trace
        cells = np.diff(trace.arc)
        turn = np.abs(trace.turns)
        outer = cells + reach[self.of_cells] * turn
        need = np.maximum(outer / step, np.sqrt(outer * turn / (8 * sagitta)))
        need = np.maximum(need, EVEN * cells / trace.length)
        progress = np.concatenate([[0.0], np.cumsum(need)])
        found = []
        chords = np.ceil(np.diff(progress[self.nodes]) * (1 - COUNT_ROUNDING))
        for k in np.flatnonzero(self._kept(progress, sagitta, reach)):
            a, b = self.nodes[k], self.nodes[k + 1]
            goals = np.linspace(progress[a], progress[b], max(int(chords[k]), 1) + 1)[:-1]
            arc = np.interp(goals, progress[a : b + 1], trace.arc[a : b + 1])
            share = (arc - trace.arc[a]) / (trace.arc[b] - trace.arc[a])
            found.append(k + np.minimum(share, 1.0))
        return np.concatenate([*found, [float(len(self))]])

    def bulge(self, places: Array, reach: Array) -> float:
        """Bound of the distance of the path, and of curves beside it, from chords between places.

        ``places`` (A,) and ``reach`` (K,) are those of :meth:`stations`.
        """
        trace = self.trace
        turn = np.abs(trace.turns) + np.abs(trace.heading - trace.arriving)[:-1]
        outer = np.diff(trace.arc) + reach[self.of_cells] * turn
        piece = np.minimum(places, len(self) - 1).astype(np.intp)
        arc = trace.arc[self.nodes[piece]] + (places - piece) * self.lengths[piece]
        lengths, turns = (
            np.diff(np.interp(arc, trace.arc, np.concatenate([[0.0], np.cumsum(each)])))
            for each in (outer, turn)
        )
        # A curve that turns by T over a chord c leaves it by (c/2) tan(T/2), and never by more than
        # half of its own length.
        return float((0.5 * lengths * np.tan(0.5 * np.minimum(turns, 0.5 * np.pi))).max())

    def _kept(self, progress: Array, sagitta: float, reach: Array) -> Booleans:
        """Which pieces (K,) begin with a station: others are so short that they need none.

        A corner counts as if its turn were spread over the pieces beside it.
        """
        if len(self) <= FEW_CORNERS:
            return np.ones(len(self), np.bool_)
        half = 0.5 * np.concatenate([[0.0], np.abs(self.corner_turns()), [0.0]])
        turn = half[:-1] + half[1:]
        bends = np.sqrt((self.lengths + reach * turn) * turn / (8 * sagitta))
        need = np.maximum(np.diff(progress[self.nodes]), bends)
        sums = np.concatenate([[0.0], np.cumsum(need)])
        kept = np.concatenate([[True], np.floor(sums[1:-1]) > np.floor(sums[:-2])])
        long = need >= 1
        kept |= long
        kept[1:] |= long[:-1]
        return np.asarray(kept)
