r"""When flaps shut whose shell and whose panels are cut with errors.

The two flaps beside a vertex have sectors alpha and alpha' between their hinges and their common
crease. That crease lacks an angle delta to 180 degrees if the hinges enclose an angle beta with

    cos beta = cos alpha cos alpha' + sin alpha sin alpha' cos delta,

so flaps are shut where beta, which gets less while the shell closes, has come down to this value at
their delta: 0, or what their boards leave. Errors change beta by those of two panels of the shell,
and its least value by those of the flaps; both are linear, and so is beta by the drive of the
shell. The first pair that shuts stops it.

By the drive of the sheet with its flaps they would not be: folded flat, flaps are at a dead point.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.deployment.cutting.gaps import Fit
from orishell.deployment.cutting.shape import Shape
from orishell.motion.quads import dots, lengths, units
from orishell.numerics.arrays import Array, Integers

STILL = 1e-6
"""Flaps whose hinges turn to each other by less than this share of what others do stop nothing."""


@record
class FlapPairs:
    """Pairs of flaps (P,) that lie on each other, beside vertices of a shell."""

    flaps: Integers  # (P, 2)
    vertices: Integers  # (P,), of the shell
    outer: Integers  # (P,), the other ends of the creases between them
    ends: Integers  # (P, 2), the other ends of their hinges
    panels: Integers  # (P, 2), panels of the shell that they are hinged to

    @classmethod
    def of(cls, fit: Fit) -> FlapPairs:
        """Those of a sheet; none if it has no flaps."""
        mesh, flaps, loops = fit.sheet.mesh, fit.sheet.flaps, fit.sheet.loops
        inside = np.zeros(mesh.vertex_count, np.bool_)
        inside[loops[~flaps][loops[~flaps] >= 0]] = True
        own = np.flatnonzero(mesh.crease & flaps[mesh.edge_faces].all(axis=1))
        edges = mesh.edges[own]
        kept = inside[edges].sum(axis=1) == 1
        own, edges = own[kept], edges[kept]
        first = inside[edges[:, 0]]
        vertices, outer = np.where(first[:, None], edges, edges[:, ::-1]).T
        pairs = mesh.edge_faces[own]
        ends, panels = (np.zeros_like(pairs) for _ in range(2))
        around = mesh.loops_edges()
        for side in (0, 1):
            # Of a flap's two edges at the vertex the one that is not the crease.
            edges_of = around[pairs[:, side]]
            at = np.where(edges_of[..., None] < 0, -1, mesh.edges[edges_of])
            hinge = (at == vertices[:, None, None]).any(axis=-1) & (edges_of != own[:, None])
            number = np.take_along_axis(edges_of, hinge.argmax(axis=1)[:, None], axis=1)[:, 0]
            ends[:, side] = mesh.edges[number].sum(axis=1) - vertices
            beside = mesh.edge_faces[number]
            panels[:, side] = np.where(flaps[beside[:, 0]], beside[:, 1], beside[:, 0])
        return cls(pairs, vertices, outer, ends, panels)


@record
class Shutting:
    """How errors change the drive at which pairs of flaps (P,) shut."""

    fit: Fit
    pairs: FlapPairs
    rates: Array  # how beta changes with the drive (P,), below 0 (radians per radian)
    lever: Array  # how cos delta falls with what beta is above its least value (P,)
    lacking: Array  # delta as designed (P,) (radians)
    by_sectors: Array  # how the least beta changes with the two sectors (P, 2)

    @classmethod
    def of(cls, fit: Fit, shape: Shape) -> Shutting | None:
        """That of a sheet; None without flaps."""
        pairs = FlapPairs.of(fit)
        sheet = fit.sheet
        if not len(pairs.vertices):
            return None
        sectors = np.abs(np.stack([_sector(sheet.flat, pairs, side) for side in (0, 1)], axis=-1))
        sine, cosine = np.sin(sectors), np.cos(sectors)
        arms = _arms(sheet.placed, pairs)
        cos_beta = np.clip(dots(arms[0], arms[1]), -1.0, 1.0)
        sin_beta = lengths(np.cross(arms[0], arms[1]))
        product = sine.prod(axis=1)
        cos_delta = np.clip((cos_beta - cosine.prod(axis=1)) / product, -1.0, 1.0)
        by_sectors = sine * cosine[:, ::-1] - cosine * sine[:, ::-1] * cos_delta[:, None]
        rates = _of_angles(fit, pairs, shape.folding[:, None], None)[:, 0]
        return cls(
            fit,
            pairs,
            rates,
            sin_beta / product,
            np.arccos(cos_delta),
            by_sectors / sin_beta[:, None],
        )

    def stop(self, motions: Array, errors: Array) -> tuple[Array, Array]:
        """Where the first pair shuts, and what the last one then lacks.

        Parameters
        ----------
        motions, errors
            Of panels (n, S), and of corners (2 F K, S).

        Returns
        -------
        tuple
            By how much the drive's hinge is then folded more than as designed (S,), and how much
            further the last pair would have to fold (S,) (radians).
        """
        least = sum(
            self.by_sectors[:, side, None] * _of_sector(self.fit, self.pairs, errors, side)
            for side in (0, 1)
        )
        over = _of_angles(self.fit, self.pairs, motions, errors) - least
        rates = self.closing * self.rates
        moving = rates < STILL * rates.min()
        stop = (-over[moving] / rates[moving, None]).min(axis=0)
        left = np.maximum(over + rates[:, None] * stop, 0.0)
        cosine = np.cos(self.lacking)[:, None] - self.lever[:, None] * left
        lacks = np.arccos(np.clip(cosine, -1.0, 1.0)) - self.lacking[:, None]
        return self.closing * stop, lacks.max(axis=0)

    @property
    def closing(self) -> float:
        """1 if the drive's hinge folds by more as the flaps shut, -1 if by less."""
        return -float(np.sign(self.rates.sum()))


def _arms(points: Array, pairs: FlapPairs) -> Array:
    """Unit vectors (2, P, 3) along the hinges of pairs, and away from their vertices."""
    return units(points[pairs.ends.T] - points[pairs.vertices])


def _of_angles(fit: Fit, pairs: FlapPairs, motions: Array, errors: Array | None) -> Array:
    """Changes (P, S) of the angles that hinges of pairs enclose, by what moves the shell."""
    sheet = fit.sheet
    arms = _arms(sheet.placed, pairs)
    cosine = dots(arms[0], arms[1])[:, None]
    sine = lengths(np.cross(arms[0], arms[1]))
    changes = np.zeros((len(sine), motions.shape[1]))
    for side in (0, 1):
        panels, ends = pairs.panels[:, side], pairs.ends[:, side]
        moved = sum(
            sign * _held(fit, panels, vertices, motions, errors)
            for sign, vertices in ((1.0, ends), (-1.0, pairs.vertices))
        )
        own, other = arms[side], arms[1 - side]
        long = lengths(sheet.placed[ends] - sheet.placed[pairs.vertices])
        slope = (cosine * own - other) / (sine * long)[:, None]
        changes += np.einsum("pi,pis->ps", slope, moved)
    return changes


def _held(
    fit: Fit, panels: Integers, vertices: Integers, motions: Array, errors: Array | None
) -> Array:
    """Moves (P, 3, S) of what panels of the shell hold at vertices."""
    moved = fit.sheet.by_motions(panels, vertices) @ motions
    if errors is not None:
        moved = moved + fit.sheet.by_errors(panels, vertices) @ errors
    return np.asarray(moved).reshape(len(panels), 3, -1)


def _sides(flat: Array, pairs: FlapPairs, side: int) -> tuple[Array, Array]:
    """Vectors (P, 2) in the flat sheet along the hinge of a flap, and along the common crease."""
    start = flat[pairs.vertices]
    return flat[pairs.ends[:, side]] - start, flat[pairs.outer] - start


def _sector(flat: Array, pairs: FlapPairs, side: int) -> Array:
    """Sectors (P,) of flaps, above 0 if they are counter-clockwise from hinge to crease."""
    hinge, crease = _sides(flat, pairs, side)
    cross = hinge[:, 0] * crease[:, 1] - hinge[:, 1] * crease[:, 0]
    return np.asarray(np.arctan2(cross, (hinge * crease).sum(axis=1)))


def _of_sector(fit: Fit, pairs: FlapPairs, errors: Array, side: int) -> Array:
    """Changes (P, S) of the sectors of flaps by errors of their corners."""
    sheet, flaps = fit.sheet, pairs.flaps[:, side]
    by_vertex = errors.reshape(-1, 2, errors.shape[1])
    start, end, outer = (
        by_vertex[sheet.corner(flaps, vertices)]
        for vertices in (pairs.vertices, pairs.ends[:, side], pairs.outer)
    )
    # A vector v turns counter-clockwise by (v x dv)/v^2.
    turned = [
        (vector[:, :1] * moved[:, 1] - vector[:, 1:] * moved[:, 0])
        / (vector**2).sum(axis=1)[:, None]
        for vector, moved in zip(
            _sides(sheet.flat, pairs, side), (end - start, outer - start), strict=True
        )
    ]
    way = np.sign(_sector(sheet.flat, pairs, side))[:, None]
    return np.asarray(way * (turned[1] - turned[0]))
