"""The pattern that the lines of a drawing make."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.io.patterns.apart import require_one_piece
from orishell.io.patterns.crossings import split_lines
from orishell.io.patterns.graph import GapError, Graph, counted, prune, straighten, unite
from orishell.io.patterns.lines import WELD, Lines, require_lines
from orishell.io.patterns.rings import Rings, find_rings, loops_of
from orishell.motion.crease_pattern import CreasePattern, pattern_of_panels
from orishell.numerics.arrays import Array, Booleans
from orishell.numerics.components import find_components
from orishell.numerics.equals import first_smallest

SHORT = 0.02
"""An edge is short below this share of the median one."""
WIDEST = 0.02
"""A tolerance is offered up to this share of the drawing's diagonal."""


@record
class Arranged:
    """A pattern and what was done to find it."""

    pattern: CreasePattern
    angles: Array  # fold angles (E,) that the drawing asks for (radians); NaN where for none
    notes: tuple[str, ...]  # what was mended or assumed, in sentences


def arrange(lines: Lines, weld: float | None = None) -> Arranged:
    """Find points, edges and panels; lines may cross, and lie on each other.

    Parameters
    ----------
    weld
        Points nearer to each other than this, and points to lines, are one; None for
        :data:`~orishell.io.patterns.lines.WELD` of the diagonal.

    Raises
    ------
    InputError
        If lines end where no other begins, a mountain lies on a valley, or the panels are not one
        piece; with the tolerance that helps, which has been tried.
    """
    require_lines(lines)
    tolerance = WELD * lines.diagonal if weld is None else weld
    try:
        found = _arranged(lines, tolerance)
    except GapError as error:
        wider = _tried(lines, tolerance, error.gap)
        if wider is not None:
            error.remedy = f"weld = {wider:g} joins them"
            error.changes = {"weld": wider}
        raise
    return found if weld is not None else _with_short_edge(found, lines, tolerance)


def _tried(lines: Lines, weld: float, gap: float) -> float | None:
    """A tolerance that closes a gap and makes a pattern; None if none does."""
    wider = float(f"{1.05 * gap:.2g}") if np.isfinite(gap) else np.inf
    if not weld < wider <= WIDEST * lines.diagonal:
        return None
    try:
        _arranged(lines, wider)
    except InputError:
        return None
    return wider


def _with_short_edge(found: Arranged, lines: Lines, weld: float) -> Arranged:
    """The same with a note if an edge is so short that its ends may be meant to be one."""
    pattern = found.pattern
    ends = pattern.vertices[pattern.edges]
    lengths = np.hypot(*(ends[:, 1] - ends[:, 0]).T)
    shortest = first_smallest(lengths)
    length = float(lengths[shortest])
    wider = None
    if length < SHORT * np.median(lengths):
        wider = _tried(lines, weld, length)
    if wider is None:
        return found
    note = (
        f"an edge at {lines.at(ends[shortest].mean(axis=0))} is only {length:.3g} long: with "
        f"weld = {wider:g} its ends are one"
    )
    return replace(found, notes=(*found.notes, note))


def _arranged(lines: Lines, weld: float) -> Arranged:
    notes: list[str] = []
    long = np.hypot(*(lines.ends[:, 1] - lines.ends[:, 0]).T) > weld
    if not long.any():
        raise InputError("the drawing has no lines of any length", got=f"weld = {weld:.3g}")
    if not long.all():
        notes.append(f"{counted(int((~long).sum()), 'line')} of no length: left out")
    lines = lines.chosen(long)
    graph = prune(unite(split_lines(lines, weld), lines, notes), lines, notes)
    graph = straighten(graph, weld, notes)
    return _panels(graph, lines, notes)


def _panels(graph: Graph, lines: Lines, notes: list[str]) -> Arranged:
    _require_one_piece(graph, lines)
    rings = find_rings(graph.points, graph.edges)
    used = np.unique(graph.edges)
    if len(used) - len(graph.edges) + len(rings.areas) != 2:
        raise InputError(
            "lines cross that should not", remedy="a smaller weld, or draw the lines anew"
        )
    left, right = np.reshape(rings.numbers, (2, -1))
    if (left == right).any():
        edge = int(np.argmax(left == right))
        ends = graph.points[graph.edges[edge]]
        raise InputError(
            "a line has the same panel on both sides",
            where=f"{lines.name(graph.lines[edge])} at {lines.at(ends.mean(axis=0))}",
            remedy="let it end at other lines, or remove it",
        )
    panel, letters = _told_apart(graph, rings, notes)
    if not panel.any():
        raise InputError("the lines enclose no panel")
    beside = panel[left] | panel[right]
    loops = loops_of(rings, graph.edges, np.flatnonzero(panel))
    used, numbers = np.unique(graph.edges[beside], return_inverse=True)
    place = np.full(len(graph.points), -1)
    place[used] = np.arange(len(used))
    pattern = pattern_of_panels(
        graph.points[used],
        np.where(loops < 0, -1, place[loops]),
        numbers.reshape(-1, 2),
        letters[beside],
    )
    require_one_piece(pattern.edge_faces[pattern.crease], len(pattern.faces))
    return Arranged(pattern, graph.angles[beside], tuple(notes))


def _told_apart(graph: Graph, rings: Rings, notes: list[str]) -> tuple[Booleans, NDArray[np.str_]]:
    """Which rings (R,) are panels, not holes; and the letters (E,) of edges beside them."""
    left, right = np.reshape(rings.numbers, (2, -1))
    panel, count = rings.areas > 0, len(rings.areas)
    letters = graph.letters.copy()
    black = np.isin(letters, ["B", "C"])
    inner = panel[left] & panel[right]
    if black.all():
        letters[inner] = "U"
        if inner.any():
            notes.append("all lines look like borders or cuts: no crease is assigned")
        return panel, letters
    creases = np.bincount(rings.numbers, np.tile(~black, 2), count)
    neighbours = np.bincount(rings.numbers, np.tile(inner, 2), count)
    hole = panel & (creases == 0) & (neighbours > 0)
    if hole.any():
        notes.append(f"{counted(int(hole.sum()), 'panel')} between borders only: a hole")
    panel = panel & ~hole
    inner = panel[left] & panel[right]
    cut = inner & (letters == "B")
    if cut.any():
        letters[cut] = "C"
        notes.append(f"{counted(int(cut.sum()), 'border')} between two panels: a cut")
    outer = (panel[left] | panel[right]) & ~inner & ~black
    if outer.any():
        notes.append(f"{counted(int(outer.sum()), 'crease')} along the border: read as border")
    return panel, letters


def _require_one_piece(graph: Graph, lines: Lines) -> None:
    """Refuse a drawing whose lines do not hang together."""
    import shapely

    pieces = find_components(graph.edges, len(graph.points))[graph.edges[:, 0]]
    if (pieces == pieces[0]).all():
        return
    sizes = np.bincount(pieces)
    small = int(np.argmin(np.where(sizes > 0, sizes, np.inf)))
    one, rest = (
        shapely.multilinestrings(np.asarray(shapely.linestrings(graph.points[graph.edges[chosen]])))
        for chosen in (pieces == small, pieces != small)
    )
    edge = int(np.argmax(pieces == small))
    gap = float(shapely.distance(one, rest))
    error = GapError(
        "the lines do not hang together",
        where=f"{lines.name(graph.lines[edge])} at {lines.at(graph.points[graph.edges[edge, 0]])}",
        got=f"{(sizes > 0).sum()} pieces, {gap:.3g} apart",
        expected="one",
        remedy="write each piece to a file of its own",
    )
    error.gap = gap
    raise error
