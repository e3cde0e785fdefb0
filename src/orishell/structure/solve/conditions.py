"""What holds in one direction only: ties, flaps and the ground.

A condition is a row b of the dofs and a gap g = b u that it keeps from growing, with a force
that is never negative: lambda = g/c for a compliance c, or g = 0 for none. A tie keeps its two ends
from parting, two flaps folded onto each other keep their outer corners from approaching, the ground
keeps a foot from sinking. The force on the structure is -b lambda.

Flaps are no part of the mesh. Folded flat they cannot turn to first order, so that a mesh would
hold them by the stiffness of their planes in both directions; but they give way as soon as the
shell opens, for the distance of their outer corners is smallest where they are folded flat.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Booleans, Integers

if TYPE_CHECKING:
    from scipy.sparse import csr_array


@record
class Conditions:
    """Rows between displacements of nodes, and what they ask."""

    nodes: Integers  # nodes (m, 2) of every row; the same twice where the ground is the other
    # unit vectors (m, 3): g is their product with the displacement of the second node, less that of
    # the first; only of the first where both are the same
    directions: Array
    compliance: Array  # gap by force (m,); 0 for none
    # coefficient of friction (m,) of feet on the ground; 0 elsewhere, and where it is smooth
    friction: Array
    grounded: Booleans  # which of them (m,) are feet on the ground

    def __len__(self) -> int:
        return len(self.nodes)

    @property
    def rough(self) -> Integers:
        """Numbers (G,) of those that have friction."""
        return np.flatnonzero(self.friction)


def make_rows(nodes: Integers, directions: Array, count: int) -> csr_array:
    """Rows (m, D) of conditions.

    nodes, directions: Nodes (m, 2) and unit vectors (m, 3), as of :class:`Conditions`.
    count: Number of all dofs D.
    """
    from scipy.sparse import coo_array, csr_array

    number = np.repeat(np.arange(len(nodes)), 3)
    apart = nodes[:, 0] != nodes[:, 1]
    first = np.where(apart[:, None], -directions, directions)
    second = np.where(apart[:, None], directions, 0.0)
    dofs = [(3 * nodes[:, k, None] + np.arange(3)).ravel() for k in (0, 1)]
    entries = np.concatenate([first.ravel(), second.ravel()])
    places = np.concatenate([number, number]), np.concatenate(dofs)
    rows = csr_array(coo_array((entries, places), shape=(len(nodes), count)))
    rows.eliminate_zeros()
    return rows


def between(points: Array, pairs: Integers, stiffness: Array, *, approach: bool) -> Conditions:
    """Conditions on the distances of pairs of nodes.

    points: Nodes (N, 3).
    pairs: Their pairs (m, 2).
    stiffness: Force by strain (m,); infinite for none (N).
    approach: Whether they are kept from approaching; from parting otherwise.
    """
    apart = points[pairs[:, 1]] - points[pairs[:, 0]]
    length = np.linalg.norm(apart, axis=1)
    sign = -1.0 if approach else 1.0
    none = np.zeros(len(pairs))
    directions = sign * apart / length[:, None]
    return Conditions(pairs, directions, length / stiffness, none, none > 0)


def on_ground(nodes: Integers, friction: Array) -> Conditions:
    """Conditions that keep feet from sinking.

    nodes: Nodes (m,) on the ground.
    friction: Its coefficient of friction (m,) under each.
    """
    down = np.tile([0.0, 0.0, -1.0], (len(nodes), 1))
    pairs = np.stack([nodes, nodes], axis=1)
    return Conditions(pairs, down, np.zeros(len(nodes)), friction, friction >= 0)


def joined(parts: list[Conditions]) -> Conditions:
    """All conditions one after the other.

    parts: Those of ties, of flaps, of the ground.
    """
    names = ("nodes", "directions", "compliance", "friction", "grounded")
    return Conditions(*(np.concatenate([getattr(part, name) for part in parts]) for name in names))
