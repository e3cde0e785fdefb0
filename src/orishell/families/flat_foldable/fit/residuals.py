"""What a fit keeps small, and its exact derivatives.

The distance of a vertex from the surface is n . (p - foot), n the normal at the foot. As p - foot
lies along n, its derivative by p is n. Those of p by the unknowns are found by complex steps, all
at once, in one march of as many sheets as there are unknowns.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from orishell.conventions.record import record
from orishell.design.piece import Piece
from orishell.families.flat_foldable.fit.unknowns import Unknowns
from orishell.families.flat_foldable.folding import Numbers
from orishell.families.flat_foldable.net import Sheet
from orishell.numerics.arrays import Array

STEP = 1e-25
SLIMMEST = 0.05
"""Sectors and corners of panels are at least so much away from 0 and 180 degrees (radians)."""
MARGIN = 0.9
"""Edges are kept to this share of the ratio that they may have."""
BORDERS = (0, slice(None)), (slice(None), -1), (-1, slice(None)), (slice(None), 0)
"""Vertices of the border that belong to the sides of a piece."""
Add = Callable[[float, Array, "Array | None"], None]


@record
class Weights:
    """Of residuals, beside 1 for the distance of vertices from the offset surfaces."""

    rim: float = 0.3  # of the border from the rim
    centre: float = 0.2  # of panels' centres from the surface
    near: float = 0.05  # of vertices from where they were at the start, along the mean plane
    even: float = 5e-3  # of lengths of edges from their mean, by logarithms
    smooth: float = 3e-3  # of second differences of what makes the sheet
    ratio: float = 0.1  # of logarithms of edges that are too short or too long


@record
class State:
    """A sheet on the way."""

    unknowns: Array  # (P,)
    residuals: Array  # (N,)
    derivatives: Array | None  # (N, P)
    edges: tuple[float, float]  # the shortest and the longest
    places: Array  # vertices (R+2, C+2, 3)

    @property
    def error(self) -> float:
        """Sum of squares."""
        return float(self.residuals @ self.residuals)


@record
class Problem:
    """A sheet that is to cover a piece."""

    piece: Piece  # its diagonal is the unit of length
    of: Unknowns
    weights: Weights
    ratio: float  # largest of the longest to the shortest edge

    def state(self, unknowns: Array, *, derived: bool = False) -> State | None:
        """The sheet of unknowns (P,), with derivatives or without; None if there is none."""
        vectors = unknowns[:, None].astype(np.complex128 if derived else np.float64)
        if derived:
            vectors = vectors + 1j * STEP * np.eye(len(unknowns))
        with np.errstate(all="ignore"):
            sheet = self.of.sheet(vectors)
            flat = sheet.flat()
            places = self.of.places(sheet, flat, vectors)
        if not np.isfinite(places.real[..., 0]).all() or not self._exists(sheet, flat):
            return None
        edges = _edges(flat)
        found = np.moveaxis(places[..., 0].real, 0, -1)
        residuals, slopes = self._parts(found, places, edges, unknowns, vectors)
        lengths = np.concatenate([each[..., 0].real.ravel() for each in edges])
        derivatives = np.concatenate(slopes) if derived else None
        return State(
            unknowns, np.concatenate(residuals), derivatives,
            (float(lengths.min()), float(lengths.max())), found,
        )  # fmt: skip

    def _exists(self, sheet: Sheet, flat: Numbers) -> bool:
        """Whether there is such a sheet, its panels convex and no sector or edge next to nothing."""
        sectors = np.stack([sheet.a[..., 0].real, sheet.b[..., 0].real])
        if not (
            sheet.net.row_mode.all() and (np.abs(sectors - np.pi / 2) < np.pi / 2 - SLIMMEST).all()
        ):
            return False
        lengths = [each[..., 0].real for each in (sheet.rows, sheet.columns)]
        return (
            min(each.min(initial=1.0) for each in lengths) > 0
            and least_sine(flat[..., 0].real) > SLIMMEST
        )

    def _parts(
        self, found: Array, places: Numbers, edges: list[Numbers], unknowns: Array, vectors: Numbers
    ) -> tuple[list[Array], list[Array]]:
        """Residuals (N,) and their derivatives (N, P), part by part."""
        weights, piece = self.weights, self.piece
        residuals: list[Array] = []
        slopes: list[Array] = []
        moved = np.moveaxis(places.imag / STEP, 0, -2) if np.iscomplexobj(places) else None

        def add(weight: float, values: Array, derivatives: Array | None) -> None:
            residuals.append(weight * values.ravel())
            if derivatives is not None:
                slopes.append(weight * derivatives.reshape(values.size, derivatives.shape[-1]))

        def along(normals: Array, moved: Array | None) -> Array | None:
            return None if moved is None else np.einsum("...k,...kp->...p", normals, moved)

        distances, normals = piece.nearest(found.reshape(-1, 3))
        distances, normals = distances.reshape(found.shape[:2]), normals.reshape(found.shape)
        slope = along(normals, moved)
        if slope is not None:
            slope[..., -1] -= self.of.sides
        add(1.0, distances - unknowns[-1] * self.of.sides, slope)
        for side, border in enumerate(BORDERS):
            away, outwards = piece.beside(side, found[border])
            add(weights.rim, away, along(outwards, None if moved is None else moved[border]))
        centres = _centres(found)
        away, normals = piece.nearest(centres.reshape(-1, 3))
        normals = normals.reshape(centres.shape)
        add(weights.centre, away, along(normals, None if moved is None else _centres(moved)))
        across, up, _ = piece.axes
        for axis in (across, up):
            beside = (found - self.of.places_at_start) @ axis
            add(weights.near, beside, along(np.broadcast_to(axis, found.shape), moved))
        logs = [np.log(each) for each in edges]
        self._add_edges(add, logs)
        rows = self.of.smoothing
        add(weights.smooth, rows @ (unknowns - self.of.first), rows if moved is not None else None)
        return residuals, slopes

    def _add_edges(self, add: Add, logs: list[Numbers]) -> None:
        """How even edges are, and how far beyond the ratio that they may have."""
        half = 0.5 * np.log(MARGIN * self.ratio)
        whole = np.concatenate([each.reshape(-1, each.shape[-1]) for each in logs])
        apart = [each - each.mean(axis=(0, 1)) for each in logs]
        for each in apart:
            add(self.weights.even, each[..., 0].real, _slope(each))
        from_mean = whole - whole.mean(axis=0)
        size = np.abs(from_mean[:, 0].real)
        far = size > half
        slope = _slope(from_mean[far])
        sign = np.sign(from_mean[far, 0].real)
        add(self.weights.ratio, size[far] - half, None if slope is None else sign[:, None] * slope)


def _slope(values: Numbers) -> Array | None:
    """Derivatives (..., P) of values that are complex."""
    return values.imag / STEP if np.iscomplexobj(values) else None


def _centres(places: Array) -> Array:
    """Means of the corners of all panels."""
    return 0.25 * (places[:-1, :-1] + places[1:, :-1] + places[1:, 1:] + places[:-1, 1:])


def _edges(flat: Numbers) -> list[Numbers]:
    """Lengths of all edges, along rows (R+2, C+1, B) and down columns (R+1, C+2, B)."""
    steps = flat[:, :, 1:] - flat[:, :, :-1], flat[:, 1:] - flat[:, :-1]
    return [np.sqrt((each * each).sum(axis=0)) for each in steps]


def least_sine(flat: Array) -> float:
    """The smallest sine of the corners of all panels of a flat sheet (2, R+2, C+2)."""
    along, down = flat[:, :, 1:] - flat[:, :, :-1], flat[:, 1:] - flat[:, :-1]
    along, down = (each / np.sqrt((each * each).sum(axis=0)) for each in (along, down))
    least = [
        (row[1] * column[0] - row[0] * column[1]).min()
        for row in (along[:, :-1], along[:, 1:])
        for column in (down[:, :, :-1], down[:, :, 1:])
    ]
    return float(min(least))
