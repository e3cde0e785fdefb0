"""The pattern that the lines of a drawing make."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.errors import InputError
from orishell.conventions.formatting import counted
from orishell.conventions.record import record
from orishell.curves.joining import FAR_APART, UNASKED, WIDEST
from orishell.io.patterns.connectivity import PiecesError, require_one_piece
from orishell.io.patterns.crossings import split_lines
from orishell.io.patterns.graph import (
    GapError,
    Graph,
    length_on_others,
    prune,
    straighten,
    unite,
    without_windows,
)
from orishell.io.patterns.lines import WELD, Lines, require_lines
from orishell.io.patterns.rings import Rings, find_rings, loops_of
from orishell.motion.crease_pattern import CreasePattern, pattern_of_panels
from orishell.numerics.arrays import Array, Booleans
from orishell.numerics.components import find_components
from orishell.numerics.equals import first_smallest

SHORT = 0.02
"""An edge is short below this share of the median one."""


@record
class Arranged:
    """A pattern and what was done to find it."""

    pattern: CreasePattern
    angles: Array  # fold angles (E,) that the drawing asks for (radians); NaN where for none
    notes: tuple[str, ...]  # what was mended or assumed, in sentences
    bridged: float  # how far ends were apart, at most, that were joined

    @property
    def shortest(self) -> float:
        """Length of the shortest edge."""
        ends = self.pattern.vertices[self.pattern.edges]
        return float(np.hypot(*(ends[:, 1] - ends[:, 0]).T).min())


def arrange(lines: Lines, weld: float | None = None) -> Arranged:
    """Find points, edges and panels; lines may cross, and lie on each other.

    Parameters
    ----------
    weld
        Points nearer to each other than this, and points to lines, are one; None for
        :data:`~orishell.io.patterns.lines.WELD` of the diagonal, or if ends are then loose, for
        the first wider one that joins them and nothing else.

    Raises
    ------
    InputError
        If lines end where no other begins, a mountain lies on a valley, or the panels are not one
        piece; with the tolerance that helps, which has been tried.
    """
    require_lines(lines)
    if weld is not None:
        return _arranged(lines, weld)
    least = WELD * lines.diagonal
    try:
        found = _arranged(lines, least)
    except GapError as error:
        return _joined(lines, least, error)
    return _with_short_edge(found, lines, least)


def _joined(lines: Lines, weld: float, error: GapError) -> Arranged:
    """The pattern with the first tolerance beyond one that makes any, if it joins only ends.

    Raises GapError: The one given, with that tolerance as its remedy if it might join more.
    """
    wider, gap = weld, error.gap
    while True:
        wider = float(f"{max(2 * wider, 1.05 * gap if np.isfinite(gap) else 0.0):.2g}")
        if wider > WIDEST * lines.diagonal:
            raise error
        try:
            found = _arranged(lines, wider)
            break
        except GapError as another:
            gap = another.gap
        except InputError:
            raise error from None
    if wider <= UNASKED * lines.diagonal and _joins_ends_only(found, lines, weld, wider):
        note = f"ends up to {found.bridged:.2g} apart were joined (weld = {wider:g})"
        return replace(found, notes=(*found.notes, note))
    error.remedy = f"weld = {wider:g} joins them"
    error.changes = {"weld": wider}
    raise error


def _joins_ends_only(found: Arranged, lines: Lines, weld: float, wider: float) -> bool:
    """Whether all edges are long beside a wider tolerance, and no lines came onto each other."""
    lengths = np.hypot(*(lines.ends[:, 1] - lines.ends[:, 0]).T)
    if ((lengths > weld) & (lengths <= wider)).any():
        return False
    if found.shortest < FAR_APART * wider:
        return False
    lines = lines.chosen(lengths > weld)
    before, after = (
        length_on_others(split_lines(lines, each), len(lines.ends)) for each in (weld, wider)
    )
    return bool((after - before).max() < FAR_APART * wider)


def _tried(lines: Lines, weld: float, gap: float) -> float | None:
    """A tolerance that closes a gap and makes a pattern; None if none does."""
    wider = float(f"{1.05 * gap:.2g}")
    if not weld < wider <= WIDEST * lines.diagonal:
        return None
    try:
        _arranged(lines, wider)
    except InputError:
        return None
    return wider


def _with_short_edge(found: Arranged, lines: Lines, weld: float) -> Arranged:
    """The pattern with a note if an edge is so short that its ends may be meant to be one."""
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
    split = split_lines(lines, weld)
    graph = without_windows(prune(unite(split, lines, notes), lines, notes), notes)
    pattern, angles = _panels(straighten(graph, weld, notes), lines, notes)
    return Arranged(pattern, angles, tuple(notes), split.bridged)


def _panels(graph: Graph, lines: Lines, notes: list[str]) -> tuple[CreasePattern, Array]:
    _require_one_piece(graph, lines)
    rings = find_rings(graph.points, graph.edges)
    used = np.unique(graph.edges)
    if len(used) - len(graph.edges) + len(rings.areas) != 2:
        raise GapError(
            "lines cross that should not", remedy="a smaller weld, or draw the lines anew"
        )
    left, right = np.reshape(rings.numbers, (2, -1))
    if (left == right).any():
        edge = int(np.argmax(left == right))
        ends = graph.points[graph.edges[edge]]
        raise GapError(
            "a line has the same panel on both sides",
            where=f"{lines.name(graph.lines[edge])} at {lines.at(ends.mean(axis=0))}",
            remedy="let it end at other lines, or remove it",
        )
    panel, letters = _told_apart(graph, rings, notes)
    if not panel.any():
        raise InputError(
            "the lines enclose no panel", remedy="draw the border of the sheet as a closed outline"
        )
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
    try:
        require_one_piece(pattern.edge_faces[pattern.crease], len(pattern.faces))
    except PiecesError as error:
        cuts = np.flatnonzero(graph.letters == "C")
        if len(cuts):
            error.got += f", parted by cuts as {lines.name(graph.lines[cuts[0]])}"
            error.remedy = (
                "if these are creases, draw them red (mountain), blue (valley) or magenta (any), "
                "not green or black; else write each piece to a file of its own"
            )
        raise
    return pattern, graph.angles[beside]


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
    sides = np.bincount(rings.numbers, np.ones(len(rings.numbers)), count)
    hole = panel & (creases == 0) & (neighbours == sides)  # else it is a piece, parted by cuts
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
