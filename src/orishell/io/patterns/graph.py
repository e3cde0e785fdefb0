"""A drawing as a graph in the plane: edges with letters, and the panels that they enclose."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import counted
from orishell.conventions.record import record
from orishell.io.patterns.crossings import Split
from orishell.io.patterns.lines import Lines
from orishell.io.patterns.rings import find_rings
from orishell.motion.crease_pattern import Mark
from orishell.motion.panel_sides import pair_keys
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.numerics.components import find_components
from orishell.numerics.equals import first_largest, first_smallest

RANK = {"B": 0, "U": 1, "J": 2, "F": 2, "V": 3, "M": 3, "C": 4}
OUTER = 3.5
"""Of lines on each other the one with the highest rank counts; a border has another rank around the
sheet than within it, where panels may be outlined beneath their creases."""


class GapError(InputError):
    """Lines that do not meet; they might with a larger tolerance."""

    gap: float = np.inf  # the tolerance with which they might
    marks: tuple[Mark, ...] = ()  # where, as far as that is known


@record
class Graph:
    """Points and edges between them that cross nowhere."""

    points: Array  # (P, 2)
    edges: Integers  # ends (E, 2)
    letters: NDArray[np.str_]  # (E,)
    angles: Array  # fold angles (E,) that are asked for (radians), or NaN
    lines: Integers  # a line (E,) of the drawing that each is a part of

    def chosen(self, kept: Booleans) -> Graph:
        """The graph with some of its edges."""
        return Graph(
            self.points,
            self.edges[kept],
            self.letters[kept],
            self.angles[kept],
            self.lines[kept],
        )

    @property
    def degrees(self) -> Integers:
        """Number (P,) of edges that end at each point."""
        return np.bincount(self.edges.ravel(), minlength=len(self.points))

    def between_two(self) -> tuple[Integers, Integers]:
        """Points (N,) at which two edges end, and these edges (N, 2)."""
        two = np.flatnonzero(self.degrees == 2)
        ends = self.edges.ravel()
        order = np.argsort(ends, kind="stable")
        begin = np.searchsorted(ends[order], two)
        return two, order[begin[:, None] + [0, 1]] // 2


def unite(split: Split, lines: Lines, notes: list[str]) -> Graph:
    """One edge of all parts of lines that lie on each other.

    Raises GapError: If one of them is a mountain and another a valley.
    """
    letters = lines.letters[split.lines]
    keys, edge = np.unique(pair_keys(split.pairs, len(split.points)), return_inverse=True)
    for letter in "MV":
        has = np.zeros((2, len(keys)), dtype=np.bool_)
        has[0, edge[letters == "M"]] = has[1, edge[letters == "V"]] = True
        both = np.logical_and(*has)
        if letter == "M" and both.any():
            raise _contradiction(split, lines, edge, both)
    rank = np.array([RANK[letter] for letter in letters.tolist()], dtype=np.float64)
    edges = np.stack(np.divmod(keys, len(split.points)), axis=-1)
    if len(edge) > len(keys):
        rank[(letters == "B") & _around(split.points, edges)[edge]] = OUTER
    order = np.lexsort((np.arange(len(edge)), -rank, edge))
    best = order[np.unique(edge[order], return_index=True)[1]]
    twice = len(edge) - len(keys)
    if twice:
        notes.append(f"{counted(twice, 'line')} drawn twice or on another one: read once")
    chosen = split.lines[best]
    return Graph(split.points, edges, letters[best], lines.angles[chosen], chosen)


def _contradiction(split: Split, lines: Lines, edge: Integers, both: Booleans) -> GapError:
    """Of edges (E,) that are a mountain and a valley as well, the longest."""
    which = np.flatnonzero(both[edge])
    lengths = _lengths(split)[which]
    longest = first_largest(lengths)
    twice = np.flatnonzero(edge == edge[which[longest]])
    ends = split.points[split.pairs[twice[0]]]
    error = GapError(
        "a mountain and a valley lie on each other",
        where=f"at {lines.at(ends.mean(axis=0))}",
        got=" and ".join(dict.fromkeys(lines.name(n) for n in split.lines[twice]))
        + f", over a length of {lengths[longest]:.3g}",
        remedy="remove one of them",
    )
    error.gap = float(lengths[longest])
    first = np.unique(edge[which], return_index=True)[1]
    places = split.points[split.pairs[which[first]]].mean(axis=1)
    error.marks = tuple(Mark(x, y, "a mountain and a valley") for x, y in places.tolist())
    return error


def _lengths(split: Split) -> Array:
    """Lengths (N,) of all parts of lines."""
    ends = split.points[split.pairs]
    return np.asarray(np.hypot(*(ends[:, 1] - ends[:, 0]).T), dtype=np.float64)


def length_on_others(split: Split, count: int) -> Array:
    """How long each of so many lines (S,) lies on others."""
    keys, edge = np.unique(pair_keys(split.pairs, len(split.points)), return_inverse=True)
    shared = np.bincount(edge, minlength=len(keys))[edge] > 1
    return np.asarray(
        np.bincount(split.lines, np.where(shared, _lengths(split), 0.0), count), dtype=np.float64
    )


def _around(points: Array, edges: Integers) -> Booleans:
    """Which edges (E,) have nothing on one side."""
    rings = find_rings(points, edges)
    return np.asarray((rings.areas[rings.numbers] < 0).reshape(2, -1).any(axis=0))


def prune(graph: Graph, lines: Lines, notes: list[str]) -> Graph:
    """Leave out what ends inside a panel: lines that stay flat, and cuts.

    Raises GapError: If another line does; with the tolerance that may close the gap.
    """
    before = graph
    while True:
        loose = (graph.degrees[graph.edges] == 1).any(axis=1)
        mark = np.isin(graph.letters, ["F", "C"])
        if not (loose & mark).any():
            break
        # A mark that goes on in others, and in nothing else, goes with them.
        _, sides = graph.between_two()
        chain = find_components(sides[mark[sides].all(axis=1)], len(graph.edges))
        graph = graph.chosen(~np.isin(chain, chain[loose & mark]))
    for letter, what in (("F", "mark"), ("C", "cut")):
        dropped = int((before.letters == letter).sum() - (graph.letters == letter).sum())
        if dropped:
            notes.append(
                f"{counted(dropped, what)} inside panels, which no crease ends at: left out"
            )
    if loose.any():
        raise _gap(graph, lines)
    if not len(graph.edges):
        raise InputError(
            "the lines enclose no panel", remedy="draw the border of the sheet as a closed outline"
        )
    return graph


def without_windows(graph: Graph, notes: list[str]) -> Graph:
    """Leave out what only borders and cuts enclose within a panel: it folds as without."""
    import shapely

    pieces = find_components(graph.edges, len(graph.points))[graph.edges[:, 0]]
    numbers = np.unique(pieces)
    if len(numbers) == 1:
        return graph
    ends = np.asarray(shapely.linestrings(graph.points[graph.edges]))
    drawn = np.array([shapely.multilinestrings(ends[pieces == each]) for each in numbers])
    sheet = first_largest(shapely.area(shapely.envelope(drawn)))
    panels = shapely.get_parts(shapely.polygonize(ends[pieces == numbers[sheet]]))
    within = np.isin(np.arange(len(numbers)), shapely.STRtree(panels).query(drawn, "within")[0])
    coloured = np.isin(numbers, pieces[~np.isin(graph.letters, ["B", "C"])])
    windows = numbers[within & ~coloured]
    if len(windows):
        notes.append(
            f"{counted(len(windows), 'window')} inside panels, which no crease ends at: left out"
        )
    return graph.chosen(~np.isin(pieces, windows))


def _gap(graph: Graph, lines: Lines) -> GapError:
    """Where a line ends alone, and how far the next point or line is from there."""
    import shapely
    from scipy.spatial import KDTree

    degrees = graph.degrees
    alone = np.flatnonzero(degrees == 1)
    ends = graph.points[alone]
    gaps = np.asarray(KDTree(ends).query(ends, k=[2])[0], dtype=np.float64)[:, 0]
    others = (degrees[graph.edges] > 1).all(axis=1)
    if others.any():
        tree = shapely.STRtree(np.asarray(shapely.linestrings(graph.points[graph.edges[others]])))
        (which, _), apart = tree.query_nearest(
            shapely.points(ends), all_matches=False, return_distance=True
        )
        gaps[which] = np.minimum(gaps[which], apart)
    worst = first_smallest(gaps)
    edge = int(np.argmax((graph.edges == alone[worst]).any(axis=1)))
    no_border = len(alone) > 2 and not (graph.letters == "B").any()
    error = GapError(
        "a line ends where no other begins"
        if len(alone) == 1
        else f"{len(alone)} ends of lines lie where no other line begins",
        where=f"{lines.name(graph.lines[edge])} at {lines.at(ends[worst])}",
        got=f"{gaps[worst]:.3g} from the next line" if np.isfinite(gaps[worst]) else "",
        remedy="draw the border of the sheet as well"
        if no_border
        else "draw on to the next line, or the rest of the border, or remove what ends there",
    )
    error.gap = float(gaps.max())
    error.marks = tuple(
        Mark(x, y, f"ends {gap:.3g} from the next line" if np.isfinite(gap) else "ends alone")
        for (x, y), gap in zip(ends.tolist(), gaps.tolist(), strict=True)
    )
    return error


def straighten(graph: Graph, weld: float, notes: list[str]) -> Graph:
    """Leave out points where one straight line goes on as another with the same letter."""
    two, sides = graph.between_two()
    far = graph.edges[sides].sum(axis=-1) - two[:, None]
    a, b = (graph.points[far[:, k]] for k in (0, 1))
    on = _distance(graph.points[two], a, b) <= weld
    on &= ((a - graph.points[two]) * (b - graph.points[two])).sum(axis=1) < 0
    on &= graph.letters[sides[:, 0]] == graph.letters[sides[:, 1]]
    same = graph.angles[sides]
    on &= (same[:, 0] == same[:, 1]) | np.isnan(same).all(axis=1)
    if not on.any():
        return graph
    chain = find_components(sides[on], len(graph.edges))
    inside = np.zeros(len(graph.points), dtype=np.bool_)
    inside[two[on]] = True
    outer = np.flatnonzero(~inside[graph.edges].ravel())
    pairs = np.full((int(chain.max()) + 1, 2), -1)
    owner = chain[outer // 2]
    by = np.argsort(owner, kind="stable")
    pairs[owner[by[::2]], 0], pairs[owner[by[::2]], 1] = (
        graph.edges.ravel()[outer[by[k::2]]] for k in (0, 1)
    )
    # A chain that turns little by little, or comes back to its beginning, stays as it is.
    middle, its = two[on], chain[sides[on, 0]]
    bent = _distance(graph.points[middle], *graph.points[pairs[its]].transpose(1, 0, 2)) > weld
    stays = pairs[:, 0] < 0
    stays[its[bent]] = True
    first = np.unique(chain, return_index=True)[1]
    kept = stays[chain]
    joined = first[~stays]
    left_out = int((~stays[its]).sum())
    if left_out:
        notes.append(f"{counted(left_out, 'point')} in the midst of a straight line: left out")
    which = np.concatenate([np.flatnonzero(kept), joined])
    edges = np.concatenate([graph.edges[kept], pairs[~stays]])
    return Graph(graph.points, edges, graph.letters[which], graph.angles[which], graph.lines[which])


def _distance(points: Array, a: Array, b: Array) -> Array:
    """Distances of points from the lines through a and b (all N, 2)."""
    way, apart = b - a, points - a
    length = np.maximum(np.hypot(*way.T), np.finfo(float).tiny)
    return np.asarray(np.abs(way[:, 0] * apart[:, 1] - way[:, 1] * apart[:, 0]) / length)
