"""Crease patterns of a single vertex, and those of mechanisms whose motion is known."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.motion import Mechanism
from orishell.motion.crease_pattern import CreasePattern, pattern_of_panels
from orishell.motion.layout import edge_signs, mesh_of, points_of
from patterns import of_loops


def star(degrees: Sequence[float], letters: str = "U") -> CreasePattern:
    """One vertex with creases of length 1 in these directions, letters repeated round it."""
    angles = np.deg2rad(degrees)
    count = len(angles)
    tips = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    loops = [[0, 1 + k, 1 + (k + 1) % count] for k in range(count)]
    return of_loops(
        np.vstack([[0.0, 0.0], tips]), loops, lambda _, tip: letters[(tip - 1) % len(letters)]
    )


def of_mechanism(mechanism: Mechanism) -> CreasePattern:
    """The flat sheet of a mechanism, flaps beside its grid included, with its edges in order."""
    mesh = mesh_of(mechanism)
    letters = np.where(mesh.crease, np.array(["M", "F", "V"])[edge_signs(mechanism) + 1], "B")
    return pattern_of_panels(points_of(mechanism, 0.0)[:, :2], mesh.loops, mesh.edges, letters)
