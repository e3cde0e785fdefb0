"""Creases as a machine makes them: scored, cut in dashes or perforated, with holes at vertices."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.errors import InputError
from orishell.conventions.formatting import inside
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.document import Document, Part
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.numerics.components import find_components
from orishell.numerics.equals import first_smallest
from orishell.workshop.cut_parts import STRAIGHT, CutPart
from orishell.workshop.palettes import Circle, Layer, Line
from orishell.workshop.settings import Workshop

Names = NDArray[np.str_]

KEPT = 0.1
"""Gaps and holes leave at least this share of every crease."""

DASHES_PER_PANEL, CUTS_PER_PANEL = 4, 20
"""Dashes, and cuts of a perforation, along a mean panel's edge if ``dash`` is "auto"."""

MOST_CUTS = 1_000_000
"""Finer dashes are refused: no machine would read the file."""

CREASE_LETTERS: dict[Layer, str] = {"ENGRAVE": "FJU", "MOUNTAIN": "M", "VALLEY": "V"}
"""Assignments of the creases in each layer, in the order in which they are drawn."""


@record
class _Creases:
    """Creases (C,) between the rims of holes: where they begin, which way, how long they are."""

    edges: Integers
    layers: Names
    starts: Array
    directions: Array
    lengths: Array


def crease_lines(document: Document, part: CutPart, workshop: Workshop) -> tuple[Line, ...]:
    """The creases of a part, in the sheet's own coordinates.

    Mountains and valleys are scored, cut in dashes or perforated. Creases that do not fold (F, J)
    or are not assigned (U) are engraved, as continuous lines. Scores without gaps and holes run
    through vertices where the crease goes on straight in the same layer.

    Of a dash with its bridge the share ``duty`` is cut. Dashes are as long as ``dash`` but for the
    rounding to whole numbers of them, and half a bridge (``corner_gap`` if that is more) stays at
    either end. Perforations have cuts of exactly ``duty * dash``, as many as fit, spread evenly.
    Both are symmetric about the crease's middle. No more than ``duty`` of any crease is cut.

    Raises InputError if holes or gaps leave nothing of a crease.
    """
    holes = _holed(document, part, workshop)
    creases = _between_rims(document, part, np.where(holes, 0.5 * workshop.relief_hole, 0.0))
    gap = _corner_gap(document, creases, workshop)
    if not len(creases.edges):
        return ()
    if workshop.creases == "score" and not gap and not workshop.relief_hole:
        layers, points = _straight_runs(document, creases)
    else:
        folded = creases.layers != "ENGRAVE"
        found, first, pitch, length = _cuts(document, creases.lengths, gap, workshop, folded)
        counts = _require_few(document, found, workshop)
        crease = np.repeat(np.arange(len(counts)), counts)
        number = np.arange(len(crease)) - np.repeat(np.cumsum(counts) - counts, counts)
        along = (first[crease] + number * pitch[crease])[:, None] + np.column_stack(
            [np.zeros(len(crease)), length[crease]]
        )
        points = creases.starts[crease, None] + along[..., None] * creases.directions[crease, None]
        layers = creases.layers[crease]
    return tuple(Line(layer, line) for layer in CREASE_LETTERS for line in points[layers == layer])


def relief_holes(document: Document, part: CutPart, workshop: Workshop) -> tuple[Circle, ...]:
    """Holes at the vertices that panels of the part surround, in the sheet's own coordinates."""
    flat = document.require_flat()
    return tuple(
        Circle("CUT", x, y, 0.5 * workshop.relief_hole)
        for x, y in flat[_holed(document, part, workshop)].tolist()
    )


@record
class MadeLengths:
    """How far a machine goes along what is within the outlines of a part (lengths)."""

    creases: float  # scored, cut in dashes or perforated, or engraved
    holes: float  # around relief holes


def made_lengths(document: Document, part: CutPart, workshop: Workshop) -> MadeLengths:
    """The lengths of what is drawn by :func:`crease_lines` and :func:`relief_holes`.

    Holes, gaps and dashes that do not fit the sheet, so that nothing is drawn, are not refused.
    """
    holed = _surrounded(document, part, workshop)
    creases = _between_rims(document, part, np.where(holed, 0.5 * workshop.relief_hole, 0.0))
    gap = 0.0 if workshop.corner_gap == "auto" else workshop.corner_gap
    folded = creases.layers != "ENGRAVE"
    counts, _, _, length = _cuts(document, creases.lengths, gap, workshop, folded)
    return MadeLengths(
        creases=float(np.maximum(counts * length, 0.0).sum()),
        holes=float(np.pi * workshop.relief_hole * holed.sum()),
    )


def mean_edge(document: Part) -> float:
    """Mean length of the panels' edges in the flat sheet: what "auto" sizes follow."""
    corners = document.require_flat()[document.mesh.faces]
    sides = np.roll(corners, -1, axis=1) - corners
    return float(np.mean(np.hypot(sides[..., 0], sides[..., 1])))


def dash_length(document: Document, workshop: Workshop) -> float:
    """Length of a dash with its bridge, before it is rounded to a whole number of them."""
    if workshop.dash != "auto":
        return workshop.dash
    perforation = workshop.creases == "perforation"
    return mean_edge(document) / (CUTS_PER_PANEL if perforation else DASHES_PER_PANEL)


def _holed(document: Document, part: CutPart, workshop: Workshop) -> Booleans:
    """Which vertices (V,) get a hole; refused where there is no room for it."""
    holed = _surrounded(document, part, workshop)
    if workshop.relief_hole > 0:
        _require_room(document, part, holed, workshop.relief_hole)
    return holed


def _surrounded(document: Document, part: CutPart, workshop: Workshop) -> Booleans:
    """Which vertices (V,) are to get a hole: inner ones with all their panels in the part."""
    mesh = document.mesh
    holed = np.zeros(mesh.vertex_count, dtype=np.bool_)
    if workshop.relief_hole > 0:
        holed[mesh.inner_vertices()] = True
        holed[np.delete(mesh.faces, part.panels, axis=0)] = False
    return holed


def _between_rims(document: Document, part: CutPart, radius: Array) -> _Creases:
    """The part's creases, shortened by the holes of radius (V,) at their ends."""
    flat = document.require_flat()
    letters = np.array([document.assignment[edge] for edge in part.creases.tolist()], dtype="<U1")
    layers = np.full(len(letters), "", dtype="<U8")
    for layer, marks in CREASE_LETTERS.items():
        layers[np.isin(letters, list(marks))] = layer
    edges = part.creases[layers != ""]
    ends = document.mesh.edges[edges]
    vectors = flat[ends[:, 1]] - flat[ends[:, 0]]
    lengths = np.hypot(*vectors.T)
    directions = vectors / lengths[:, None]
    rims = radius[ends]
    return _Creases(
        edges,
        layers[layers != ""],
        flat[ends[:, 0]] + rims[:, :1] * directions,
        directions,
        lengths - rims.sum(axis=1),
    )


def _corner_gap(document: Document, creases: _Creases, workshop: Workshop) -> float:
    gap = 0.0 if workshop.corner_gap == "auto" else workshop.corner_gap
    if not len(creases.edges):
        return gap
    shortest = first_smallest(creases.lengths)
    largest = 0.5 * (1 - KEPT) * float(creases.lengths[shortest])
    if gap > largest:
        raise InputError(
            f"the gaps leave less than {KEPT:.0%} of "
            f"{_edge_name(document, creases.edges[shortest])}",
            keys=("workshop.corner_gap",),
            got=f"{gap:g} {document.unit}",
            expected=f"at most {plain(inside(largest, 0.0))} {document.unit}",
        )
    return gap


def _require_room(document: Document, part: CutPart, holed: Booleans, diameter: float) -> None:
    """Refuse holes that leave too little of a crease, or reach beyond the panels around them."""
    flat, mesh = document.require_flat(), document.mesh
    ends = mesh.edges[part.creases]
    lengths = np.hypot(*(flat[ends[:, 1]] - flat[ends[:, 0]]).T)
    share = 0.5 * holed[ends].sum(axis=1)
    limits = np.divide(
        (1 - KEPT) * lengths, share, out=np.full(len(share), np.inf), where=share > 0
    )
    faces = mesh.faces[part.panels]
    corners = flat[faces]
    for k in range(4):
        here, after, across, before = (corners[:, (k + i) % 4] for i in range(4))
        reach = np.minimum(_distances(here, after, across), _distances(here, before, across))
        room = np.where(holed[faces[:, k]], 2 * (1 - KEPT) * reach, np.inf)
        limits = np.append(limits, room)
        if k < 2:
            both = holed[faces[:, k]] & holed[faces[:, k + 2]]
            apart = np.hypot(*(across - here).T)
            limits = np.append(limits, np.where(both, (1 - KEPT) * apart, np.inf))
    largest = float(limits.min(initial=np.inf))
    if diameter > largest:
        raise InputError(
            f"the holes leave too little of the creases and panels ({KEPT:.0%} must remain)",
            keys=("workshop.relief_hole",),
            got=f"{diameter:g} {document.unit}",
            expected=f"at most {plain(inside(largest, 0.0))} {document.unit}",
        )


def _distances(points: Array, starts: Array, ends: Array) -> Array:
    """Distances (N,) of points (N, 2) from segments between starts and ends (N, 2)."""
    along = ends - starts
    share = ((points - starts) * along).sum(axis=1) / (along**2).sum(axis=1)
    nearest = starts + np.clip(share, 0.0, 1.0)[:, None] * along
    return np.asarray(np.hypot(*(points - nearest).T))


def _cuts(
    document: Document, lengths: Array, gap: float, workshop: Workshop, folded: Booleans
) -> tuple[Array, Array, Array, Array]:
    """Number of cuts (C,), start of the first, distance from one to the next, and their length."""
    if workshop.creases == "score":
        one = np.ones(len(lengths))
        return one, gap * one, lengths, lengths - 2 * gap
    perforation = workshop.creases == "perforation"
    dash, duty = dash_length(document, workshop), workshop.duty
    bridge = (1 - duty) * dash
    whole = (lengths - 2 * max(gap, 0.5 * bridge) + bridge) / dash
    counts = np.floor(whole * (1 + STRAIGHT)) if perforation else np.rint(whole)
    counts = np.where(folded, np.maximum(counts, 1), 1)
    if perforation:
        cut = np.minimum(duty * np.minimum(dash, lengths / counts), lengths - 2 * gap)
        margin = np.maximum(gap, 0.5 * (lengths / counts - cut))
        pitch = (lengths - 2 * margin - cut) / np.maximum(counts - 1, 1)
    else:
        margin = np.maximum(gap, 0.5 * (1 - duty) * lengths / counts)
        pitch = (lengths - 2 * margin) / (counts - 1 + duty)
        cut = duty * pitch
    first = np.where(folded, np.where(counts > 1, margin, 0.5 * (lengths - cut)), gap)
    return counts, first, pitch, np.where(folded, cut, lengths - 2 * gap)


def _require_few(document: Document, counts: Array, workshop: Workshop) -> Integers:
    """Numbers of cuts, as whole numbers; refused if they are too many to be drawn."""
    if counts.sum() > MOST_CUTS:
        raise InputError(
            "the dashes are too fine",
            keys=("workshop.dash",),
            got=f"{dash_length(document, workshop):g} {document.unit}, "
            f"{plain(counts.sum(), 3)} cuts",
            expected=f"at most {MOST_CUTS:g} cuts",
        )
    return counts.astype(np.int64)


def _straight_runs(document: Document, creases: _Creases) -> tuple[Names, Array]:
    """Layers (L,) and ends (L, 2, 2) of creases, those that go on straight in one layer joined."""
    flat, count = document.require_flat(), len(creases.edges)
    vertices = document.mesh.edges[creases.edges].T.ravel()
    outward = np.concatenate([creases.directions, -creases.directions])
    owners, layers = np.tile(np.arange(count), 2), np.tile(creases.layers, 2)
    order = np.argsort(vertices, kind="stable")
    free = np.ones(2 * count, dtype=np.bool_)
    pairs = []
    for step in range(1, int(np.bincount(vertices).max())):
        one, two = order[:-step], order[step:]
        cross = outward[one, 0] * outward[two, 1] - outward[one, 1] * outward[two, 0]
        straight = (np.abs(cross) < STRAIGHT) & ((outward[one] * outward[two]).sum(axis=1) < 0)
        joined = straight & (vertices[one] == vertices[two]) & (layers[one] == layers[two])
        free[one[joined]] = free[two[joined]] = False
        pairs.append(np.stack([owners[one[joined]], owners[two[joined]]], axis=1))
    together = np.concatenate([*pairs, np.zeros((0, 2), dtype=owners.dtype)])
    runs = find_components(together, count)[owners]
    tips = np.flatnonzero(free)
    ends = tips[np.argsort(runs[tips], kind="stable")].reshape(-1, 2)
    return layers[ends[:, 0]], flat[vertices[ends]]


def _edge_name(document: Document, edge: np.int64) -> str:
    panels = document.mesh.edge_faces[edge]
    names = [document.panel_name(int(panel)) for panel in panels if panel >= 0]
    return "the crease between panels " + " and ".join(names)
