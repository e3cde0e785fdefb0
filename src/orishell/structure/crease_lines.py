"""Crease lines of a loaded shell: the forces that they have to bear, and the share of it they use.

What they bear, and how several forces count together: :mod:`orishell.structure.hinge_lines`.
"""

from __future__ import annotations

import numpy as np

from orishell.numerics.arrays import Array
from orishell.structure.crease_forces import AtCrease, largest_at, spread_forces
from orishell.structure.hinge_lines import DIRECTIONS, UNKNOWN
from orishell.structure.mesh.edge_forces import ABOUT, ACROSS, IN_PLANE, NORMAL, EdgeForces
from orishell.structure.model import Model


def by_direction(per_length: Array, lever: float) -> Array:
    """Pull, push, shear along and across (..., 2, 4) of lines, for both signs of their moments.

    per_length: N, V_in, V, M (..., 4).
    lever: Lever arm of what locks creases.
    """
    normal, pair = per_length[..., NORMAL, None], per_length[..., ABOUT, None] / lever
    both = normal + pair * np.array([1.0, -1.0])
    shear = np.abs(per_length[..., None, [IN_PLANE, ACROSS]])
    sides = np.stack([np.maximum(both, 0.0), np.maximum(-both, 0.0)], axis=-1)
    return np.concatenate([sides, np.broadcast_to(shear, (*both.shape, 2))], axis=-1)


def line_forces(model: Model, found: EdgeForces) -> Array:
    """What crease lines have to bear (C, 2, S, 2, 4) on stretches, seen from both of their sides.

    That is all of it by direction, for both signs of the pair of forces that a moment is, but what
    a membrane bears whose strength is known: pull and shear in its plane.
    """
    forces = by_direction(spread_forces(model, found), model.lever)
    build = model.design.panel
    if build is not None and build.membrane and model.structure.membrane_strength is not None:
        borne = [DIRECTIONS.index("pull"), DIRECTIONS.index("along")]
        forces[..., borne] = 0.0
    return forces


def hinge_line(model: Model, found: EdgeForces) -> AtCrease:
    """The largest force per length that a crease line has to bear, in any direction."""
    return largest_at(model, _over_lines(np.linalg.norm(line_forces(model, found), axis=-1)))


def unknown_line(model: Model, found: EdgeForces) -> AtCrease:
    """The largest force per length in directions in which no strength of lines is known."""
    strength = model.structure.line_strength or UNKNOWN
    return largest_at(model, _over_lines(strength.unknown(line_forces(model, found))))


def used_lines(model: Model, found: EdgeForces) -> Array:
    """The share (C,) of what every crease line bears, in the directions whose strength is known."""
    strength = model.structure.line_strength or UNKNOWN
    return _over_lines(strength.used(line_forces(model, found)))


def most_used_line(model: Model, found: EdgeForces) -> AtCrease | None:
    """The crease line that uses most of what it bears; None if nothing is known of any."""
    strength = model.structure.line_strength
    return None if strength is None else largest_at(model, used_lines(model, found))


def _over_lines(sizes: Array) -> Array:
    """The largest (C,) of sizes (C, 2, S, 2) on stretches of crease lines."""
    return np.asarray(sizes.max(axis=(1, 2, 3)))
