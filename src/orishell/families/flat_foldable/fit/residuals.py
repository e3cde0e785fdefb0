"""What a fit keeps small, and its exact derivatives.

The distance of a vertex from the surface is n . (p - foot), n the normal at the foot. As p - foot
lies along n, its derivative by p is n. Those of p by the unknowns are found by complex steps, all
at once, in one march of as many sheets as there are unknowns.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.design.piece import Piece
from orishell.families.flat_foldable.fit.unknowns import POSE, Unknowns
from orishell.families.flat_foldable.folding import Numbers
from orishell.motion.quads import dots
from orishell.numerics.arrays import Array

STEP = 1e-25


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
    shortest_sine: float  # of the corners of all panels in the flat sheet, by their edges
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
            unknowns, np.concatenate(residuals), derivatives, _convexity(flat[..., 0].real),
            (float(lengths.min()), float(lengths.max())), found,
        )  # fmt: skip
