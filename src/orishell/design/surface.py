"""The surface f swept along g, its points and normals, and lattices of them as fine as wanted."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property, partial

import numpy as np

from orishell.conventions.record import record
from orishell.curves import Trace
from orishell.design.path import Path
from orishell.design.piece import Piece
from orishell.design.rails import Rail
from orishell.motion.quads import area_vectors, grid_corners, lengths
from orishell.numerics.arrays import Array, Integers

LOOSE = 20.0
"""A lattice leaves the surface by about its step over this, if nothing else is asked for."""
FIRST_LATTICE = 48
"""Steps along the longer side of the first lattice, which tells how large a surface is."""
PIECE_CELLS = 128
"""Cells each way of a surface that is to be covered as a piece."""
FIRST_CELLS = 20_000
"""The most cells that the first lattice may have."""


@record
class Lattice:
    """Points of a surface at all pairs of places along g and parameters of f."""

    # places along g (A,) and parameters of f (B,), increasing
    u: Array
    v: Array
    points: Array  # points (A, B, 3)
    # distance of the surface's corners and bends that are not among them from the chords there
    left_out: float

    def triangles(self) -> Integers:
        """Corners (T, 3) of triangles, two a cell, by row of ``points`` as (A*B, 3).

        Counter-clockwise seen from the side of the surface's normals.
        """
        rows, columns = self.points.shape[:2]
        number = np.arange(rows * columns).reshape(rows, columns)
        a, b = number[:-1, :-1], number[:-1, 1:]
        c, d = number[1:, 1:], number[1:, :-1]
        return np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)

    def area(self) -> float:
        """Area of its cells."""
        return float(lengths(area_vectors(grid_corners(self.points))).sum())


@record
class Surface:
    """f, the profile, carried along g by its rail, upright: z is f's y axis.

    Examples
    --------
    >>> from orishell.curves import curve_from_formulas, parse_formula, trace_curve
    >>> f = trace_curve(curve_from_formulas(None, parse_formula("-x**2"), -1, 1))
    >>> g = trace_curve(curve_from_formulas(None, parse_formula("0*x"), 0, 3))
    >>> from orishell.design import Path, Turning
    >>> surface = Surface(f, np.zeros(2), Turning(Path.of(g), np.pi / 2))
    >>> surface.points(np.array(1.0), np.array(0.5))
    array([ 3.  , -0.5 , -0.25])
    """

    profile: Trace
    origin: Array  # the point (2,) of f's plane that is carried along g itself
    rail: Rail

    def points(self, u: Array, v: Array) -> Array:
        """Points (..., 3) at places u along g (...) and parameters v of f (...)."""
        x, z = np.moveaxis(self.profile.curve.position(v) - self.origin, -1, 0)
        points = self.rail.carry(u, x)[0]
        points[..., 2] += z
        return points

    def normals(self, u: Array, v: Array) -> Array:
        """Unit normals (..., 3) at u, v (...), to the left of f as it is run through.

        They point upwards where f is level. At corners of f they are those of its later side.
        """
        position, first, _ = self.profile.curve.jet(np.asarray(v, dtype=np.float64))
        x = position[..., 0] - self.origin[0]
        _, along, axis = self.rail.carry(u, x)
        across = first[..., :1] * axis + first[..., 1:] * np.array([0.0, 0.0, 1.0])
        normal = np.cross(across, along)
        normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
        return np.asarray(normal)

    def lattice(
        self,
        step: float,
        sagitta: float | None = None,
        longer: float = 1.0,
        *,
        most: int | None = None,
    ) -> Lattice:
        """A lattice of points as close as asked for, with the corners of f and g unless too many.

        Neighbours along f are at most a ``step`` apart, along g ``longer`` times that, and cells a
        ``sagitta`` from the surface, about (length). Where f and g have so many bends that it takes
        more cells than ``most``, step and sagitta are doubled until it does not, and the error of
        that is counted.
        """
        if sagitta is None:
            sagitta = step / LOOSE
        x = self.profile.points[:, 0] - self.origin[0]
        reach = float(x.min()), float(x.max())
        of_f = Path.of(self.profile)
        wanted = sagitta
        while True:
            u = self.rail.stations(longer * step, sagitta, reach)
            places = of_f.stations(step, sagitta, np.zeros(len(of_f)))
            if most is None or (len(u) - 1) * (len(places) - 1) <= most:
                break
            step, sagitta = 2 * step, 2 * sagitta
        piece = np.minimum(places, len(of_f) - 1).astype(np.intp)
        begin, end = (self.profile.arc[of_f.nodes[piece + k]] for k in (0, 1))
        v = np.interp(begin + (places - piece) * (end - begin), self.profile.arc, self.profile.t)
        left_out = _left_out(places, lambda at: self.profile.points[of_f.nodes[at.astype(np.intp)]])
        left_out += max(
            _left_out(u, partial(lambda x, at: self.rail.carry(at, x)[0], np.asarray(each)))
            for each in (*reach, 0.0)
        )
        points = self.points(u[:, None], v[None, :])
        if sagitta > wanted:
            # Along g, along f, and between what joins the chords and the triangles.
            left_out += self.rail.bulge(u, reach) + of_f.bulge(places, np.zeros(len(of_f)))
            a, b, c, d = np.moveaxis(grid_corners(points), -2, 0)
            left_out += 0.5 * float(lengths(a - b + c - d).max())
        return Lattice(u, v, points, left_out)

    @cached_property
    def piece(self) -> Piece:
        """All of it, as a piece to be covered: g runs from left to right, f from top to bottom."""
        u = np.linspace(0.0, self.rail.stop, PIECE_CELLS + 1)[None, :]
        v = np.linspace(self.profile.t[0], self.profile.t[-1], PIECE_CELLS + 1)[:, None]
        u, v = np.broadcast_arrays(u, v)
        return Piece.of_lattice(self.points(u, v), self.normals(u, v))

    def area(self, step: float | None = None) -> float:
        """Area, of cells with sides of about ``step``; roughly, if none is given."""
        if step is not None:
            return self.lattice(step).area()
        return self.lattice(self.size() / FIRST_LATTICE, most=FIRST_CELLS).area()

    def size(self) -> float:
        """A length of the order of its diameter: f's and g's extent."""
        x = self.profile.points
        u = self.rail.stations(np.inf, np.inf, (0.0, 0.0))
        g = self.rail.carry(np.linspace(0.0, self.rail.stop, 64 + len(u)), np.zeros(()))[0]
        return float(np.linalg.norm(np.ptp(g, axis=0)) + np.linalg.norm(np.ptp(x, axis=0)))


def _left_out(places: Array, at: Callable[[Array], Array]) -> float:
    """Largest distance of corners, at whole numbers, from the chords between places (A,)."""
    missing = np.setdiff1d(np.arange(places[-1] + 1), places)
    if not len(missing):
        return 0.0
    after = np.searchsorted(places, missing)
    # The ends of chords that pass corners are corners.
    point, start, end = (at(each) for each in (missing, places[after - 1], places[after]))
    chord = end - start
    share = (chord * (point - start)).sum(axis=-1) / (chord * chord).sum(axis=-1)
    foot = start + np.clip(share, 0, 1)[:, None] * chord
    return float(np.linalg.norm(point - foot, axis=-1).max())
