"""How a target is scaled so that its shell becomes wider, deeper or higher.

Each size has a factor of its own. Height is that of f's y. Of width (along x) and depth (along y)
each is that of the curve that is longer in this direction in plan: of g, along the same axis, or of
f, across g. A surface is scaled along x, y and z. A drawn sheet has one factor only. A sheet
without a target has one of its edges along rows, and one of those down columns.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from orishell.conventions.formatting import rounded
from orishell.conventions.record import record
from orishell.curves.trace import trace_curve
from orishell.design_file import DesignFile
from orishell.design_file.tables import value_at
from orishell.numerics.arrays import Array

DIGITS = 12
"""Significant digits of factors, as if somebody had typed them."""
NONE = 1e-6
"""What extends by less than this share of the whole does not extend that way."""

Place = tuple[str, int]
"""A key of a scale in the design file, and which of its factors, by axis."""


@record
class Scaling:
    """Which factors a target has."""

    places: tuple[Place, Place, Place]  # the factor of width, of depth and of height
    own: Mapping[str, tuple[float, ...]]  # factors that the design file says, by key
    size: Array  # of the target in plan and height (3,), which the shell's is about

    @property
    def uniform(self) -> bool:
        """Whether there is one factor for all sizes."""
        return len(set(self.places)) == 1

    def changes(self, axes: list[int], factors: Array) -> dict[str, float | list[float]]:
        """What the file says at its scales if sizes along some axes have other factors (k,)."""
        scales = {key: np.array(own) for key, own in self.own.items()}
        for axis, factor in zip(axes, factors.tolist(), strict=True):
            key, part = self.places[axis]
            scales[key][part] *= factor
        return {
            key: _written(scale)
            for key, scale in scales.items()
            if scale.tolist() != list(self.own[key])
        }


def _written(scale: Array) -> float | list[float]:
    factors = [rounded(float(each), DIGITS) for each in scale]
    return factors[0] if len(set(factors)) == 1 else factors


def scaling_of(file: DesignFile) -> Scaling:
    """How the target of a file is scaled."""
    if file.drawing is not None:
        key = "target.pattern.scale"
        factor = float(value_at(file.tables, key) or 1.0)
        return Scaling(((key, 0),) * 3, {key: (factor,)}, np.zeros(3))
    lengths = file.pattern.lengths()
    if file.target is None and file.surface is None and lengths is not None:
        wide, deep = (f"pattern.{key}" for key in lengths)
        edges = {f"pattern.{key}": (float(getattr(file.pattern, key)),) for key in lengths}
        return Scaling(((wide, 0), (deep, 0), (deep, 0)), edges, np.zeros(3))
    if file.surface is not None:
        key = "target.surface.scale"
        given = value_at(file.tables, key) or 1.0
        scale = tuple(map(float, given)) if isinstance(given, list) else (float(given),) * 3
        size = np.ptp(file.surface.piece.vertices, axis=0)
        return Scaling(((key, 0), (key, 1), (key, 2)), {key: scale}, np.asarray(size))
    f, g = trace_curve(file.f).points, trace_curve(file.g).points
    (wide, high), along = np.ptp(f, axis=0), np.ptp(g, axis=0)
    chord = g[-1] - g[0]
    across = wide * np.abs(chord[::-1]) / max(float(np.hypot(*chord)), np.finfo(float).tiny)
    of_g = along >= across
    if not of_g.any():
        of_g = along * across[::-1] >= along[::-1] * across
    keys = ("target.f.scale", "target.g.scale")
    places = [(keys[1], axis) if of_g[axis] else (keys[0], 0) for axis in (0, 1)]
    size = np.array([*np.where(of_g, along, wide), high])
    scales = {key: each.scale for key, each in zip(keys, file.require_target(), strict=True)}
    return Scaling((places[0], places[1], (keys[0], 1)), scales, size)


def first_factors(scaling: Scaling, axes: list[int], asked: Array) -> Array:
    """Factors (k,) with which the target itself has the sizes (k,) along some axes."""
    size = scaling.size[axes]
    there = size > NONE * max(float(scaling.size.max()), np.finfo(float).tiny)
    return np.where(there, asked / np.where(there, size, 1.0), 1.0)
