"""All that acts on panels, force by force: loads, creases, supports, ties, flaps.

At a vertex, and along a crease that something holds from outside, only sums are known of what acts
on the panels there: each has an equal part. What is left at a crease is equal and opposite on both
sides of it then; where nothing holds a crease, both sides are as they were found.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers
from orishell.structure.case import CaseResult
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.mesh.edge_forces import crease_sides
from orishell.structure.mesh.sheet import CORNERS
from orishell.structure.model import Model

LEAST = 1e-10
"""Forces below this share of the largest one are rounding, and moments of that with a panel's size
as their arm."""
OUTSIDE = ("support", "rail", "gusset", "box girder", "second skin")
"""What holds nodes from outside the panels, and is no tie and no flap."""
NAMES = np.array(
    ["remainder"]
    + [
        " and ".join(name for bit, name in enumerate(OUTSIDE) if code >> bit & 1)
        for code in range(1, 1 << len(OUTSIDE))
    ]
)
"""What holds a node, by a number with a bit for each of these."""
NONE = -1


@record
class PanelForces:
    """Forces on panels, row by row, the panels one after the other."""

    panels: Integers  # the panel (R,) that each acts on
    acts: Array  # what acts (R,), in a word
    beside: Integers  # the panel (R,) on the other side of a crease, else -1
    vertices: Integers  # the vertex (R,) where it acts, else -1
    points: Array  # where it acts (R, 3) (length)
    forces: Array  # force and moment about that point (R, 6)


def panel_forces(model: Model, case: CaseResult) -> PanelForces:
    """All that acts on panels in a case that is in equilibrium.

    Their sum is nothing, for every panel. Where large displacements are followed, points are those
    of the panels as they are moved.
    """
    found = case.equilibrium
    assert found is not None
    on = found.edges.on_panels
    panels = np.arange(len(on.points))
    codes = _held(model)
    blocks = [
        _rows(panels, "load", on.middles, on.loads),
        _rows(panels, _within(model, codes), on.middles, on.within),
        *_at_edges(model, found, codes),
        *_at_corners(model, case, found, codes),
    ]
    acts, *others = (np.concatenate(each) for each in zip(*blocks, strict=True))
    panel, beside, vertices, points, forces = others
    force = LEAST * np.abs(forces[:, :3]).max(initial=0.0)
    size = np.linalg.norm(on.points[:, 2] - on.points[:, 0], axis=1).mean()
    least = np.repeat([force, force * size], 3)
    forces = np.where(np.abs(forces) > least, forces, 0.0)
    kept = np.flatnonzero(forces.any(axis=1))
    kept = kept[np.argsort(panel[kept], kind="stable")]
    return PanelForces(
        panel[kept], acts[kept], beside[kept], vertices[kept], points[kept], forces[kept]
    )


_Rows = tuple[Array, Integers, Integers, Integers, Array, Array]


def _rows(
    panels: Integers,
    acts: str | Array,
    points: Array,
    forces: Array,
    *,
    beside: Integers | int = NONE,
    vertices: Integers | int = NONE,
) -> _Rows:
    count = len(panels)
    return (
        np.broadcast_to(acts, count),
        panels,
        np.broadcast_to(beside, count),
        np.broadcast_to(vertices, count),
        points,
        forces,
    )


def _held(model: Model) -> Integers:
    """What holds every node (N,) from outside: a number with a bit for each of ``OUTSIDE``."""
    supports = model.supports
    found = np.zeros(len(model.mesh.facets.points), np.int64)
    found[supports.restrained[:, 0]] |= 1
    found[supports.ground] |= 1
    for rail in model.rails:
        found[rail.nodes] |= 2
    for each in model.plates:
        own = 4 if model.design.plates else 16 if model.has_skin else 8
        found[each.nodes[each.nodes < len(found)]] |= own
    return found


def _within(model: Model, codes: Integers) -> Array:
    """What holds panels (F,) at nodes inside them, in words."""
    inside = codes[model.mesh.nodes[:, 1:-1, 1:-1]]
    return np.asarray(NAMES[np.bitwise_or.reduce(inside, axis=(1, 2))])


def _moved_to(forces: Array, arms: Array) -> Array:
    """Forces and moments (..., 6) about a point from which arms (..., 3) lead to their own."""
    turning = forces[..., 3:] + np.cross(arms, forces[..., :3])
    return np.concatenate([forces[..., :3], turning], axis=-1)


def _at_edges(model: Model, found: Equilibrium, codes: Integers) -> list[_Rows]:
    """What acts at edges: at creases the panel beside them, and what holds edges."""
    acts = found.edges.resultants
    seen = codes[model.mesh.nodes]
    inner = seen[:, 1:-1, 0], seen[:, -1, 1:-1], seen[:, 1:-1, -1], seen[:, 0, 1:-1]
    held = np.stack([np.bitwise_or.reduce(each, axis=1) for each in inner], axis=1)  # (F, 4)
    points = found.edges.on_panels.between
    _, sides = crease_sides(model.grid)
    one, other = (tuple(each) for each in sides.transpose(1, 2, 0))
    beside = np.full(held.shape, NONE)
    beside[one], beside[other] = other[0], one[0]
    border = (beside < 0)[..., None]
    by_crease, outside = np.where(border, 0.0, acts), np.where(border, acts, 0.0)

    split = np.flatnonzero(held[one])
    first, second = (tuple(index[split] for index in each) for each in (one, other))
    there = _moved_to(acts[second], points[second] - points[first])
    part = 0.5 * (acts[first] + there)
    points[second] = points[first]
    by_crease[first], by_crease[second] = acts[first] - part, there - part
    outside[first] = outside[second] = part

    panels = np.repeat(np.arange(len(acts)), 4)
    at, flat = points.reshape(-1, 3), held.ravel()
    return [
        _rows(panels, "crease", at, by_crease.reshape(-1, 6), beside=beside.ravel()),
        _rows(panels, NAMES[flat], at, outside.reshape(-1, 6)),
    ]


def _at_corners(model: Model, case: CaseResult, found: Equilibrium, codes: Integers) -> list[_Rows]:
    """What acts at corners: ties, flaps, loads at vertices, and what holds these."""
    edges, mesh = found.edges, model.mesh
    on, count = edges.on_panels, model.grid.vertex_count
    nodes = mesh.seats[:, *CORNERS].ravel()
    points, rest = on.points.reshape(-1, 3), edges.corners.reshape(-1, 6).copy()
    corners = np.flatnonzero(nodes < count)
    own = nodes[corners]
    many = np.bincount(own, minlength=count)
    loads = edges.factor * case.forces[:count]
    np.subtract.at(loads, own, on.at_corners.reshape(-1, 3)[corners])
    places = np.zeros((count, 3))
    places[own] = points[corners]
    ordered = corners[np.argsort(own, kind="stable")]

    def at_vertices(acts: str, vertices: Integers, forces: Array) -> _Rows:
        """Forces (k, 3) at vertices (k,), in equal parts on the panels there; less is left."""
        times = many[vertices]
        begin = (np.cumsum(many) - many)[vertices]
        which = np.repeat(np.arange(len(vertices)), times)
        here = ordered[np.arange(len(which)) + np.repeat(begin - (np.cumsum(times) - times), times)]
        parts = np.zeros((len(which), 6))
        parts[:, :3] = forces[which] / times[which, None]
        np.subtract.at(rest, here, parts)
        return _rows(here // 4, acts, points[here], parts, vertices=vertices[which])

    blocks = [at_vertices("load", np.arange(count), loads)]
    pairs = (
        ("tie", model.site.ties, found.tie_forces),
        ("flap", model.flaps, -found.flap_forces),
    )
    for acts, asked, sizes in pairs:
        ends = model.nodes_of(asked)
        way = places[ends[:, 1]] - places[ends[:, 0]]
        pull = sizes[:, None] * way / np.linalg.norm(way, axis=1, keepdims=True)
        blocks.append(at_vertices(acts, ends.T.ravel(), np.concatenate([pull, -pull])))
    vertex = np.where(nodes < count, nodes, NONE)
    every = np.arange(len(nodes)) // 4
    blocks.append(_rows(every, NAMES[codes[nodes]], points, rest, vertices=vertex))
    return blocks
