"""Panels of any number of corners joined along shared sides: which sides are which edges.

Panels are loops: vertices (F, K) around every panel, those on its sides too, -1 behind the last.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.numerics.arrays import Booleans, Integers
from orishell.numerics.components import find_components


@record
class JoinedLoops:
    """Loops that all go round the same way, and the edges between them."""

    loops: Integers  # vertices (F, K) around every panel, the same one first as it was listed
    edges: Integers  # vertices (E, 2) of every edge
    # panels (E, 2) to the left and to the right of every edge seen from the side from which the
    # panels go counter-clockwise; -1 where there is none
    edge_faces: Integers
    crease: Booleans  # which edges (E,) join two panels
    pieces: Integers  # number (F,) of the connected piece that a panel belongs to
    turned: Booleans  # which panels (F,) were listed the other way round


def join_loops(
    loops: Integers,
    vertex_count: int,
    edges: Integers | None = None,
    cut: Booleans | None = None,
    turned: Booleans | None = None,
) -> JoinedLoops:
    """Find which panels share which edges; turn panels so that all go round the same way.

    Parameters
    ----------
    edges
        Vertices (E, 2) of every edge, in the order in which they are to be numbered; None to
        number the panels' sides by their vertices.
    cut
        Which edges (E,) do not join the panels beside them.
    turned
        Which panels (F,) are to be turned; None to find it, so that most of a connected piece keep
        their way.

    Raises
    ------
    InputError
        If an edge is listed twice or not at all, has more than two panels or two on the same side,
        or if the sheet has only one side (a Moebius strip).
    """
    sides, owners = sides_of(loops)
    keys = pair_keys(sides, vertex_count)
    if edges is None:
        found = np.unique(keys)
        edges = np.stack(np.divmod(found, vertex_count), axis=-1)
    else:
        edges = edges.copy()
    face_edges = find_edges(keys, owners, edges, vertex_count)
    count = np.bincount(face_edges, minlength=len(edges))
    if (count > 2).any():
        edge = int(np.argmax(count > 2))
        raise InputError(
            f"edge {_pair(edges[edge])} has more than two panels",
            got="panels " + ", ".join(map(str, owners[face_edges == edge])),
            expected="one or two",
            remedy="leave out the panels that are no part of one sheet",
        )
    crease = count == 2 if cut is None else (count == 2) & ~cut
    forward = sides[:, 0] == edges[face_edges, 0]
    pieces, agreeing = _orient(face_edges, forward, crease, owners)
    forward ^= (agreeing if turned is None else turned)[owners]
    edge_faces = np.full((len(edges), 2), -1)
    edge_faces[face_edges, np.where(forward, 0, 1)] = owners
    lost = (count == 2) & (edge_faces < 0).any(axis=1)
    if turned is None:
        turned = agreeing
    elif lost.any():
        edge = int(np.argmax(lost))
        first, second = owners[face_edges == edge]
        raise InputError(
            f"panels {first} and {second} lie on the same side of their edge {_pair(edges[edge])}",
            expected="one on each side: panels must not lie on each other in the flat sheet",
        )
    around = np.where(turned[:, None], _reversed(loops), loops)
    for array in (around, edges, edge_faces, crease, pieces, turned):
        array.flags.writeable = False
    return JoinedLoops(around, edges, edge_faces, crease, pieces, turned)


def sides_of(loops: Integers) -> tuple[Integers, Integers]:
    """Vertices (S, 2) of all sides of panels, panel by panel, and the panel (S,) of each."""
    after = np.roll(np.where(loops < 0, loops[:, :1], loops), -1, axis=1)
    there = loops >= 0
    return np.stack([loops[there], after[there]], axis=-1), np.nonzero(there)[0]


def _reversed(loops: Integers) -> Integers:
    """Loops (F, K) the other way round, the same vertex first."""
    count = (loops >= 0).sum(axis=1)[:, None]
    place = np.arange(loops.shape[1])[None]
    return np.take_along_axis(loops, np.where(place < count, -place % count, place), axis=1)


def pair_keys(pairs: Integers, vertex_count: int) -> Integers:
    """One number for each pair of vertices (..., 2), in either order."""
    return np.asarray(pairs.min(axis=-1) * np.int64(vertex_count) + pairs.max(axis=-1))


def find_edges(keys: Integers, owners: Integers, edges: Integers, vertex_count: int) -> Integers:
    """Numbers (S,) of the edges that are sides of panels (S,)."""
    listed = pair_keys(edges, vertex_count)
    order = np.argsort(listed, kind="stable")
    ordered = listed[order]
    twice = np.flatnonzero(ordered[1:] == ordered[:-1])
    if len(twice):
        raise InputError(f"edge {_pair(edges[order[twice[0]]])} is listed twice")
    place = np.minimum(np.searchsorted(ordered, keys), len(ordered) - 1)
    missing = ordered[place] != keys
    if missing.any():
        side = int(missing.argmax())
        raise InputError(
            f"a side of panel {owners[side]} is not among the edges",
            got=_pair(np.array(divmod(keys[side], vertex_count))),
            remedy="list all edges, or none",
        )
    return order[place]


def _orient(
    face_edges: Integers, forward: Booleans, crease: Booleans, owners: Integers
) -> tuple[Integers, Booleans]:
    """Connected pieces (F,) of panels, and which panels (F,) must be turned to agree.

    Sides (S,) of panels, ``owners``, are given by their edges and by whether they go along them.
    Every panel stands for two nodes of a graph, as listed and turned; creases join the nodes
    that agree. The sheet has two sides if no panel is connected with itself turned.
    """
    faces = int(owners[-1]) + 1
    slots = np.argsort(face_edges, kind="stable")
    slots = slots[crease[face_edges[slots]]].reshape(-1, 2)
    first, second = owners[slots].T
    opposed = forward[slots[:, 0]] == forward[slots[:, 1]]
    one = np.concatenate([first, first + faces])
    two = np.concatenate([second + faces * opposed, second + faces * ~opposed])
    labels = find_components(np.stack([one, two], axis=-1), 2 * faces)
    one_sided = labels[:faces] == labels[faces:]
    if one_sided.any():
        raise InputError(
            "the sheet has only one side, so that no fold is a mountain or a valley",
            got=f"panels that cannot all go round the same way, panel {np.argmax(one_sided)} "
            "among them",
        )
    _, start, pieces = np.unique(
        np.minimum(labels[:faces], labels[faces:]), return_index=True, return_inverse=True
    )
    turned = labels[:faces] != labels[start][pieces]
    most = np.bincount(pieces, turned) > 0.5 * np.bincount(pieces)
    return pieces, turned ^ most[pieces]


def _pair(vertices: Integers) -> str:
    return f"{vertices[0]}-{vertices[1]}"
