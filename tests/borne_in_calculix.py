"""What CalculiX finds that panels bear, read where the analysis states stress, by the same rules.

Stresses in the points of cells give membrane forces and moments, forces on nodes what holds panels
at their edges. Both are put on the mesh of the model, as it is moved, so that patches, stretches of
creases and sections are those of the analysis: what is compared are CalculiX's own figures.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from hinged_decks import Deck, Found
from orishell.numerics.arrays import Array
from orishell.structure.held_panels import panel_loads
from orishell.structure.mesh.edge_forces import EdgeForces, find_edge_forces
from orishell.structure.mesh.hinges import beside_creases
from orishell.structure.mesh.sheet import SheetMesh
from orishell.structure.mesh.stresses import FacetForces, PanelStresses, panel_stresses
from orishell.structure.mesh.triangle import Facets

GAUSS = np.sqrt(3.0)
"""Half a thickness by the height of the points of cells above their middle."""
NODES = [0, 1, 2, 3] * 2 + [4, 5, 6, 7] + [0, 1, 2, 3] + [4, 5, 6, 7]
UPWARDS = np.repeat([-1.0, 1.0, -1.0, 0.0, 1.0], 4)
"""The nodes of a cell that nodes of its solid are at, and how far above these by its half
thickness, as the file of results has them."""


@dataclass(frozen=True)
class Borne:
    """What CalculiX finds that panels bear in a step."""

    patches: PanelStresses
    edges: EdgeForces


def borne(path: Path, deck: Deck, found: Found, off: Array | None = None) -> Borne:
    """What panels bear in the last step of a deck that was run.

    off: By how much nodes (N, 3) are off the places of the model there: the imperfection, and
    displacements where they are large.
    """
    assert off is None or not deck.locked, "solids are taken to be where they were"
    mesh = deck.model.mesh
    points = mesh.facets.points if off is None else mesh.facets.points + off
    mesh = replace(mesh, facets=Facets(points, mesh.facets.triangles))
    patches = panel_stresses(mesh, deck.model.section, _in_cells(deck, mesh, found.stresses[-1]))
    if deck.locked:
        held = _at_nodes(path.with_suffix(".frd").read_text(), deck)
    else:
        held = np.concatenate([found.forces[-1], 0 * found.forces[-1]], axis=1)
    return Borne(patches, _at_edges(deck, mesh, held))


def _in_cells(deck: Deck, mesh: SheetMesh, stresses: Array) -> FacetForces:
    """Forces and moments of triangles: those of their cells, on average."""
    thickness = deck.sections()[0][:, None]
    below, above = stresses[:, :4].mean(axis=1), stresses[:, 4:].mean(axis=1)
    tensors = 0.5 * thickness * (below + above), GAUSS * thickness**2 / 12 * (above - below)
    axes = mesh.facets.axes()
    forces, moments = (_seen(axes, np.repeat(each, 2, axis=0)) for each in tensors)
    return FacetForces(forces, moments, np.repeat(moments[:, None], 3, axis=1))


def _seen(axes: Array, stresses: Array) -> Array:
    """Stresses xx, yy, zz, xy, xz, yz (T, 6) as xx, yy, xy (T, 3) in axes (T, 3, 3)."""
    x, y, z, xy, xz, yz = stresses.T
    tensors = np.array([[x, xy, xz], [xy, y, yz], [xz, yz, z]])
    own = np.einsum("tai,ijt,tbj->tab", axes, tensors, axes)
    return np.stack([own[:, 0, 0], own[:, 1, 1], own[:, 0, 1]], axis=1)


def _at_nodes(text: str, deck: Deck) -> Array:
    """Forces and moments (own + S, 6) with which panels hold their nodes, by those of solids.

    Every cell is a solid, whose nodes are above and below those of the cell.
    """
    corners, _ = deck.cells()
    own = np.concatenate([corners, deck.own + deck.middles()[1]], axis=1)
    body = text.partition("\n    3C")[2].partition("\n -3")[0]
    solids = np.array([_whole(row) for row in re.findall(r"^ -2(.*)$", body, re.MULTILINE)])
    table = text.partition("\n -4  FORC ")[2].partition("\n -3")[0]
    rows = re.findall(r"^ -1(.{10})(.{12})(.{12})(.{12})", table, re.MULTILINE)
    numbers = np.array([int(row[0]) for row in rows])
    forces = np.zeros((1 + numbers.max(), 3))
    forces[numbers] = np.array([row[1:] for row in rows], dtype=float)

    up = 0.5 * deck.sections()[0][:, None] * deck.model.mesh.facets.axes()[::2, 2]
    arms = (UPWARDS[:, None] * up[:, None]).reshape(-1, 3)
    # Cells of a panel share nodes of solids, and panels do not.
    number, first = np.unique(solids.reshape(-1), return_index=True)
    nodes, force = own[:, NODES].ravel()[first], forces[number]
    held = np.zeros((deck.own + len(deck.middles()[0]), 6))
    np.add.at(held, nodes, np.concatenate([force, np.cross(arms[first], force)], axis=1))
    return held


def _whole(row: str) -> list[int]:
    """Whole numbers in columns of ten characters."""
    return [int(row[k : k + 10]) for k in range(0, len(row.rstrip()), 10)]


def _at_edges(deck: Deck, mesh: SheetMesh, held: Array) -> EdgeForces:
    """What holds panels at their edges, by forces and moments (own + S, 6) on their nodes.

    What is in the middle of a side goes to its ends in halves: then they have what linear cells
    would have, by virtual work.
    """
    model, (ends, _) = deck.model, deck.middles()
    at = held[: deck.own].copy()
    for end in ends.T:
        np.add.at(at, end, 0.5 * held[deck.own :])
    # One of the triangles about a place has all that is there.
    triangles = np.zeros((*mesh.places.shape, 6))
    _, first = np.unique(mesh.places.ravel(), return_index=True)
    triangles.reshape(-1, 6)[first] = at
    case = next(each for each in model.structure.cases if each.name == deck.case.name)
    return find_edge_forces(
        mesh,
        model.grid,
        triangles.reshape(-1, 18),
        _about_creases(deck, mesh, at[:, 3:]) if deck.locked else None,
        panel_loads(model, case, model.structure.cases),
        supported=model.supports.restrained[:, 0],
    )


def _about_creases(deck: Deck, mesh: SheetMesh, moments: Array) -> Array:
    """Moments (C (cells+1), 6) that springs in creases would have, by those on panels' places.

    At a vertex a panel's moment is that of two creases, along both.
    """
    _, *sides, _ = beside_creases(mesh, deck.model.grid)
    points = mesh.facets.points[mesh.nodes.ravel()]
    about: dict[int, list[tuple[int, int, int]]] = {}
    for side, places in enumerate(sides):
        for crease, row in enumerate(places.tolist()):
            for node, place in enumerate(row):
                about.setdefault(place, []).append((side, crease, node))
    found = np.zeros((len(sides[0]), len(sides[0][0]), 2))
    along = points[sides[0][:, -1]] - points[sides[0][:, 0]]
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    for place, where in about.items():
        directions = np.array([along[crease] for _, crease, _ in where])
        sizes = np.linalg.lstsq(directions.T, moments[place], rcond=None)[0]
        for (side, crease, node), size in zip(where, sizes, strict=True):
            found[crease, node, side] = size
    # Both panels have the same about a crease, but where a vertex splits it: the mean is taken.
    first, second = found[..., 0], found[..., 1]
    turning = -0.5 * (first - second)[..., None] * along[:, None]
    return np.concatenate([turning, -turning], axis=-1).reshape(-1, 6)
