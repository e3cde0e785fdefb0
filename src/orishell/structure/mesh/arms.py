"""Arms: fins of sheet metal that carry hinges off the faces of boards.

A fin is a plate upright on its board, from the face to the hinge, along the middle of the crease.
It is clamped on the board, whose face turns with it; at the axis both fins of a hinge have their
translations in common, and turn about it against its spring. All of a hinge, two fins and what is
between them, is one element of the nodes of both boards: what is inside is eliminated at once, with
i for inside and b for boards

    K_bb - K_bi K_ii^-1 K_ib.

A board without a fin, as its face reaches the hinge, holds the axis rigidly.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array, Integers
from orishell.structure.mesh.elements import Elements
from orishell.structure.mesh.hinges import hinge_elements
from orishell.structure.mesh.rotations import cross_matrices
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.sheet import Offsets, SheetMesh, crease_places
from orishell.structure.mesh.triangle import Facets


def joint_elements(mesh: SheetMesh, grid: Grid, stiffness: float) -> list[Elements]:
    """What joins panels, but for what they have in common: springs about creases, and fins.

    stiffness: Moment per length of crease and per angle (force per radian).
    """
    found = [hinge_elements(mesh, grid, stiffness)] if stiffness else []
    if mesh.offsets is not None and mesh.offsets.on_fins.any():
        found.append(fin_elements(mesh, grid, stiffness))
    return found


def fin_elements(mesh: SheetMesh, grid: Grid, stiffness: float) -> Elements:
    """Hinges on fins as elements, each of the nodes of both boards along it.

    stiffness: Moment per length of hinge and per angle (force per radian).
    """
    hinges = mesh.offsets
    assert hinges is not None
    assert hinges.fins is not None
    _, *sides = crease_places(grid, mesh.nodes.shape[1] - 1)
    on_fins = np.flatnonzero(hinges.on_fins)
    middle = hinges.lengths[on_fins[0]] > 0  # alike for all that are on fins
    places = np.stack([each[on_fins][:, middle] for each in sides], axis=1)  # (H, 2, n)
    axis = hinges.axes[on_fins][:, middle]  # (H, n, 3)
    nodes = mesh.nodes.ravel()[places]
    at = mesh.facets.points[nodes]
    heights = hinges.heights[on_fins]
    rigid = heights == 0
    first = np.argsort(rigid, axis=1, kind="stable")  # a board without a fin comes second
    places, nodes, at, heights, rigid = (
        np.take_along_axis(each, first.reshape(*first.shape, *[1] * (each.ndim - 2)), axis=1)
        for each in (places, nodes, at, heights, rigid)
    )
    springs = stiffness * hinges.lengths[on_fins][:, middle]
    found = np.empty((len(axis), 12 * axis.shape[1], 12 * axis.shape[1]))
    for fins in (2, 1):
        some = np.flatnonzero((~rigid).sum(axis=1) == fins)
        if len(some):
            between = _Between(at[some], axis[some], heights[some], springs[some])
            found[some] = between.matrices(hinges.fins, fins)
    count = len(axis)
    own = mesh.translations()[nodes], mesh.rotations().reshape(-1, 3)[places]
    dofs = np.concatenate(own, axis=-1).reshape(count, -1)
    corners = at.reshape(count, -1, 3)
    return Elements(found, dofs, corners[:, 1:] - corners[:, :1], mesh.count)


@record
class _Between:
    """Hinges, and the nodes of the boards that they join."""

    at: Array  # nodes (H, 2, n, 3)
    axis: Array  # points (H, n, 3) of their axes
    heights: Array  # of fins (H, 2) (length)
    springs: Array  # moments by angles (H, n) at these points

    def matrices(self, section: Section, fins: int) -> Array:
        """Their matrices (H, 12 n, 12 n) by the nodes of both boards.

        fins: Whether both boards have one, 2, or only the first, 1.
        """
        count, n = self.axis.shape[:2]
        board, inside = 12 * n, 9 * n
        total = np.zeros((count, board + inside, board + inside))
        by_node = np.arange(n)[:, None]
        shared = board + 3 * by_node + np.arange(3)  # translations of the axis
        turns = [shared + 3 * n * (1 + side) for side in range(2)]  # of fins there
        for side in range(fins):
            own = 6 * n * side + 6 * by_node + np.arange(6)
            top = np.concatenate([shared, turns[side]], axis=1)
            local = np.concatenate([own, top]).ravel()
            fin = _fin(self.at[:, side], self.axis, self.heights[:, side], section)
            total[:, local[:, None], local] += fin
        along = self.axis[:, -1] - self.axis[:, 0]
        along /= np.linalg.norm(along, axis=1, keepdims=True)
        second = 6 * n + 6 * by_node + np.arange(6)
        both = np.concatenate([turns[0], turns[1] if fins == 2 else second[:, 3:]], axis=1)
        turn = np.concatenate([along, -along], axis=1)
        spring = self.springs[:, :, None, None] * (turn[:, :, None] * turn[:, None])[:, None]
        for node in range(n):
            total[:, both[node][:, None], both[node]] += spring[:, node]
        if fins == 1:
            total = _carried(total, self.axis - self.at[:, 1], shared, second)
            inner = turns[0].ravel()
        else:
            inner = np.concatenate([each.ravel() for each in (shared, *turns)])
        kept = np.arange(board)
        across = total[:, kept[:, None], inner]
        inward = np.linalg.solve(total[:, inner[:, None], inner], across.swapaxes(1, 2))
        found = total[:, kept[:, None], kept] - across @ inward
        return np.asarray(0.5 * (found + found.swapaxes(1, 2)))


def _carried(total: Array, arms: Array, shared: Integers, nodes: Integers) -> Array:
    """Matrices (H, m, m) of hinges whose axis, at arms (H, n, 3) from nodes, goes with these.

    shared, nodes: Dofs (n, 3) of the axis, and (n, 6) of these nodes.
    """
    hung = np.tile(np.eye(total.shape[1]), (len(total), 1, 1))
    by_turns = -cross_matrices(arms)
    for node, axis in enumerate(shared):
        hung[:, axis[:, None], axis] = 0.0
        hung[:, axis[:, None], nodes[node, :3]] = np.eye(3)
        hung[:, axis[:, None], nodes[node, 3:]] = by_turns[:, node]
    return np.asarray(hung.swapaxes(1, 2) @ total @ hung)


def _fin(at: Array, axis: Array, heights: Array, section: Section) -> Array:
    """Matrices (H, 12 n, 12 n) of fins, by the nodes of boards, then by those of axes.

    at, axis: Nodes of boards and points of axes (H, n, 3); a fin is the part of the way between
    them that is as high as it is (H,).
    """
    count, n = axis.shape[:2]
    way = at - axis
    share = heights[:, None] / np.linalg.norm(way, axis=-1)
    foot = axis + share[..., None] * way
    points = np.concatenate([foot, axis], axis=1)
    low = np.arange(n - 1)
    first = np.stack([low, low + 1, low + n + 1], axis=1)
    second = np.stack([low, low + n + 1, low + n], axis=1)
    pattern = np.concatenate([first, second])
    corners = (2 * n * np.arange(count)[:, None, None] + pattern).reshape(-1, 3)
    stiffness = Facets(points.reshape(-1, 3), corners).element_stiffness(section)
    each = stiffness.reshape(count, len(pattern), 18, 18)
    total = np.zeros((count, 12 * n, 12 * n))
    for number, three in enumerate(pattern):
        dofs = (6 * three[:, None] + np.arange(6)).ravel()
        total[:, dofs[:, None], dofs] += each[:, number]
    hung = np.tile(np.eye(12 * n), (count, 1, 1))
    by_turns = -cross_matrices(foot - at)
    for node in range(n):
        hung[:, 6 * node : 6 * node + 3, 6 * node + 3 : 6 * node + 6] = by_turns[:, node]
    return np.asarray(hung.swapaxes(1, 2) @ total @ hung)


def arm_stress(hinges: Offsets, hinged: Array, width: float) -> Array:
    """Stress (C, 2) by von Mises of the arms on both boards, 0 where there are none.

    By statics: with V along an arm, T along the crease and m about it, at the foot or at the hinge
    where it is larger, all per length,

        sigma = 6 m/w^2 + V/w,    tau = T/w,

    means over the halves of an arm.

    hinged: What hinges do to boards (C, 2, cells+1, 6), moments about their axes.
    width: Their thickness w (length).
    """
    axes, length = hinges.axes, hinges.lengths
    along = axes[:, -1] - axes[:, 0]
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    place = np.linspace(0.0, 1.0, axes.shape[1])
    halves = np.stack([place <= 0.5, place >= 0.5]) * np.where(place == 0.5, 0.5, 1.0)
    total = np.einsum("hk,cski->cshi", halves, hinged)  # (C, 2, 2, 6)
    per_length = total / np.maximum(length @ halves.T, 1e-300)[:, None, :, None]
    force, moment = per_length[..., :3], per_length[..., 3:]
    foot = hinges.feet[:, :, None]
    at_hinge = np.einsum("cshi,ci->csh", moment, along)
    at_foot = at_hinge - np.einsum("cshi,ci->csh", np.cross(foot, force), along)
    height = hinges.heights[:, :, None]
    upright = foot / np.where(height > 0, height, 1.0)[..., None]
    direct = np.abs((force * upright).sum(axis=-1))
    shear = np.abs(np.einsum("cshi,ci->csh", force, along))
    bent = 6 * np.maximum(np.abs(at_hinge), np.abs(at_foot)) / width**2
    stress = np.sqrt((bent + direct / width) ** 2 + 3 * (shear / width) ** 2)
    return np.asarray(np.where(height > 0, stress, 0.0).max(axis=2))
