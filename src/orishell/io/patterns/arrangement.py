"""The pattern that the lines of a drawing make."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import counted
from orishell.conventions.record import record
from orishell.curves.joining import FAR_APART, STEP, UNASKED, WIDEST
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

BENT = 1e-3
"""Creases that turn by less at a point are in line there (radians)."""
LADDER = 5_000
"""Of drawings with more lines no tolerances are tried but the one that the widest gap asks for."""


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
    tolerance = WELD * lines.diagonal if weld is None else weld
    try:
        found = _arranged(lines, tolerance)
    except GapError as error:
        wider = _wider(lines, tolerance, error.gap)
        if wider is None:
            raise
        tolerance, joined = wider
        if weld is not None or not _joins_ends_only(joined, lines, tolerance):
            error.remedy = f"weld = {tolerance:g} joins them"
            error.changes = {"weld": tolerance}
            raise
        found = joined
    if weld is not None or not _bends(found.pattern):
        return _with_notes(found, lines, tolerance)
    # Creases that bend never fold: lines may miss each other there.
    wider = _wider(lines, tolerance, np.inf, lambda each: _bends(each.pattern) == 0)
    if wider is not None:
        better, joined = wider
        if _joins_ends_only(joined, lines, better):
            return _with_notes(joined, lines, better)
        note = f"creases bend where no other begins: with weld = {better:g} none does"
        found = replace(found, notes=(*found.notes, note))
    return _with_notes(found, lines, tolerance)


def _bends(pattern: CreasePattern) -> int:
    """At how many inner vertices two creases meet that are not in line, and no other."""
    creases, _ = pattern.fans
    two = (creases >= 0).sum(axis=1) == 2
    return int((np.abs(pattern.sectors[two, 0] - np.pi) > BENT).sum()) if two.any() else 0


def _wider(
    lines: Lines,
    weld: float,
    gap: float,
    wanted: Callable[[Arranged], bool] = lambda _: True,
) -> tuple[float, Arranged] | None:
    """The first wider tolerance with a pattern that is wanted, and that; None if there is none.

    If there is one that leaves no edges as short as itself the first such one is taken: ends are
    otherwise joined to lines beside the point that they belong to. ``gap`` is tried, too.
    """
    most = WIDEST * lines.diagonal
    steps = int(np.log(most / weld) / np.log(STEP**2)) + 1 if 0 < weld < most else 0
    ladder = (
        [weld * STEP ** (2 * k) for k in range(1, steps + 1)] if len(lines.ends) <= LADDER else []
    )
    first: tuple[float, Arranged] | None = None
    for tried in sorted({float(f"{each:.2g}") for each in (1.05 * gap, *ladder)}):
        made = _made(lines, tried, weld)
        if made is None or not wanted(made[1]):
            continue
        if made[1].shortest >= FAR_APART * tried:
            return made
        first = first or made
    return first


def _joins_ends_only(found: Arranged, lines: Lines, wider: float) -> bool:
    """Whether a wider tolerance is small beside all edges, and brings no lines onto each other."""
    weld = WELD * lines.diagonal
    if wider > UNASKED * lines.diagonal or found.shortest < FAR_APART * wider:
        return False
    lengths = np.hypot(*(lines.ends[:, 1] - lines.ends[:, 0]).T)
    if ((lengths > weld) & (lengths <= wider)).any():
        return False
    lines = lines.chosen(lengths > weld)
    before, after = (
        length_on_others(split_lines(lines, each), len(lines.ends)) for each in (weld, wider)
    )
    return bool((after - before).max() < FAR_APART * wider)


def _with_notes(found: Arranged, lines: Lines, weld: float) -> Arranged:
    """A pattern with notes on ends that were joined, and on an edge that is as short as a gap."""
    if weld > WELD * lines.diagonal and found.bridged > 0:
        note = f"ends up to {found.bridged:.2g} apart were joined (weld = {weld:g})"
        found = replace(found, notes=(*found.notes, note))
    ends = found.pattern.vertices[found.pattern.edges]
    lengths = np.hypot(*(ends[:, 1] - ends[:, 0]).T)
    shortest = first_smallest(lengths)
    length, wider = float(lengths[shortest]), None
    if length < SHORT * np.median(lengths):
        wider = _made(lines, float(f"{1.05 * length:.2g}"), weld)
    if wider is None:
        return found
    note = (
        f"an edge at {lines.at(ends[shortest].mean(axis=0))} is only {length:.3g} long: with "
        f"weld = {wider[0]:g} its ends are one"
    )
    return replace(found, notes=(*found.notes, note))


def _made(lines: Lines, weld: float, least: float) -> tuple[float, Arranged] | None:
    """A tolerance above the least one and the pattern that it makes; None if it makes none."""
    if not least < weld <= WIDEST * lines.diagonal:
        return None
    try:
        return weld, _arranged(lines, weld)
    except InputError:
        return None


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
