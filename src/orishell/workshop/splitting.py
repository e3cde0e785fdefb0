"""Splitting a sheet larger than the stock along creases, into few parts."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from itertools import pairwise

import numpy as np

from orishell.document import Document
from orishell.numerics.arrays import Integers
from orishell.workshop.fitting import CutSheet, require_panels_fit


def bisect_sheet(sheet: CutSheet, pieces: Integers) -> list[Integers]:
    """Connected parts that fit the stock, made few by joining neighbours.

    sheet: The sheet; every panel fits.
    pieces: Number (F,) of the connected piece that a panel belongs to.

    Returns parts: Numbers of the panels of every part, ascending.
    """
    return _join_pieces(sheet, _bisect(sheet, pieces))


def _bisect(sheet: CutSheet, pieces: Integers) -> list[Integers]:
    """Connected sets of panels that fit, by cuts across the longer side."""
    todo = [np.flatnonzero(pieces == k) for k in range(int(pieces.max()) + 1)]
    done = []
    while todo:
        panels = todo.pop()
        if sheet.fits(panels):
            done.append(panels)
            continue
        centres = sheet.corners[panels].mean(axis=1)
        axis = np.linalg.svd(centres - centres.mean(axis=0), full_matrices=False)[2][0]
        along = centres @ axis
        length = float(np.ptp(along))
        order = np.argsort(np.round(along / max(length, np.finfo(float).tiny), 9), kind="stable")
        need = max(2, math.ceil(length / max(sheet.width, sheet.height)))
        shares = np.cumsum(sheet.areas[panels][order]) / sheet.areas[panels].sum()
        cut = int(np.clip(np.searchsorted(shares, need // 2 / need), 1, len(panels) - 1))
        for half in (panels[order[:cut]], panels[order[cut:]]):
            todo += _connected(sheet, np.sort(half))
    return done


def _connected(sheet: CutSheet, panels: Integers) -> list[Integers]:
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    beside = sheet.neighbours[panels]
    here, side = np.nonzero(np.isin(beside, panels))
    there = np.searchsorted(panels, beside[here, side])
    graph = coo_array((np.ones(len(here)), (here, there)), shape=(len(panels),) * 2)
    count, labels = connected_components(graph, directed=False)
    return [panels[labels == k] for k in range(count)]


def _join_pieces(sheet: CutSheet, parts: list[Integers]) -> list[Integers]:
    """Join neighbouring parts, smallest first, as long as the two together fit."""
    parts = sorted((np.sort(part) for part in parts), key=lambda part: int(part[0]))
    tried: set[tuple[int, int]] = set()
    names = list(range(len(parts)))
    while True:
        pair = _next_pair(sheet, parts, names, tried)
        if pair is None:
            return parts
        i, j = pair
        tried.add((names[i], names[j]))
        both = np.sort(np.concatenate([parts[i], parts[j]]))
        if sheet.fits(both):
            parts[i], names[i] = both, max(names) + 1
            del parts[j], names[j]


def _next_pair(
    sheet: CutSheet, parts: list[Integers], names: list[int], tried: set[tuple[int, int]]
) -> tuple[int, int] | None:
    number = np.full(len(sheet.corners), -1)
    for k, part in enumerate(parts):
        number[part] = k
    here = np.broadcast_to(number[:, None], sheet.neighbours.shape)
    pairs = np.stack([here, number[sheet.neighbours]], axis=-1)[sheet.neighbours >= 0]
    pairs = np.unique(pairs[pairs[:, 0] < pairs[:, 1]], axis=0)
    size = [float(sheet.areas[part].sum()) for part in parts]
    left = [(i, j) for i, j in pairs.tolist() if (names[i], names[j]) not in tried]
    return min(left, key=lambda p: (size[p[0]] + size[p[1]], p), default=None)


LINES = 24
"""Grids with more lines are cut along about so many of them, and more where panels are large."""

Block = tuple[int, int, int, int]
Cost = tuple[int, float]


def split_sheet(
    document: Document, stock_width: float, stock_height: float, allowance: float
) -> tuple[Integers, ...]:
    """Split the flat sheet along creases into parts that fit the stock, at any angle.

    A grid is cut into bands along whole lines, rows or columns, and every band across, with the
    fewest parts that this allows, of areas as even as can be. Other sheets are cut in two
    across their longer side until the pieces fit, and pieces that fit together are joined.

    stock_width, stock_height: What can be used of the sheets that are cut.
    allowance: Width of the tabs along cut creases; 0 for none.

    Returns parts: Numbers of the panels of every part, ascending; parts by their first panel.

    Raises InputError if a panel does not fit, or if there is no flat sheet.
    """
    sheet = CutSheet.of(document, stock_width, stock_height, allowance)
    require_panels_fit(document, sheet)
    if document.grid_shape is not None and not document.mesh.pieces.any():
        rows, columns = document.grid_shape
        parts = _split_grid(sheet, rows - 1, columns - 1)
    else:
        parts = bisect_sheet(sheet, document.mesh.pieces)
    return tuple(sorted((np.sort(part) for part in parts), key=lambda part: int(part[0])))


def _split_grid(sheet: CutSheet, rows: int, columns: int) -> list[Integers]:
    """The better of bands of rows and bands of columns."""
    number = np.arange(rows * columns).reshape(rows, columns)
    found = _split_bands(sheet, number, *_choose_lines(sheet, number))
    if found is None:
        raise AssertionError("every panel fits, so there is a split into panels")
    return found


def _choose_lines(sheet: CutSheet, number: Integers) -> tuple[list[int], list[int]]:
    """Rows and columns along which to cut: evenly spread, then more until what is between fits."""
    lines = [_spread(count) for count in number.shape]
    while True:
        more: tuple[set[int], set[int]] = set(), set()
        for i, k in pairwise(lines[0]):
            for j, m in pairwise(lines[1]):
                if not sheet.fits(number[i:k, j:m].ravel()):
                    axis = int(m - j > k - i)
                    more[axis].add((j + m) // 2 if axis else (i + k) // 2)
        if not any(more):
            return lines[0], lines[1]
        lines = [sorted({*old, *new}) for old, new in zip(lines, more, strict=True)]


def _spread(count: int) -> list[int]:
    parts = min(count, LINES)
    return sorted({round(count * k / parts) for k in range(parts + 1)})


def _split_bands(
    sheet: CutSheet, number: Integers, rows: list[int], columns: list[int]
) -> list[Integers] | None:
    """The fewest blocks that fit, from bands cut across; None if there are none."""

    def block(i: int, k: int, j: int, m: int) -> Integers:
        return number[rows[i] : rows[k], columns[j] : columns[m]].ravel()

    @cache
    def fits(i: int, k: int, j: int, m: int) -> bool:
        panels = number[rows[i] : rows[k], columns[j] : columns[m]]
        rim = np.concatenate([panels[0], panels[-1], panels[:, 0], panels[:, -1]])
        return sheet.fits(panels.ravel(), rim)

    area = np.zeros((len(rows), len(columns)))
    sums = sheet.areas[number].cumsum(axis=0).cumsum(axis=1)
    area[1:, 1:] = sums[np.ix_(np.array(rows[1:]) - 1, np.array(columns[1:]) - 1)]
    stock = sheet.width * sheet.height

    def share(i: int, k: int, j: int, m: int) -> float:
        return float(area[k, m] - area[i, m] - area[k, j] + area[i, j]) / stock

    down = _cut_bands(len(rows) - 1, len(columns) - 1, fits, share)
    across = _cut_bands(
        len(columns) - 1,
        len(rows) - 1,
        lambda i, k, j, m: fits(j, m, i, k),
        lambda i, k, j, m: share(j, m, i, k),
    )
    choices = [down, None if across is None else (across[0], [b[2:] + b[:2] for b in across[1]])]
    found = [choice for choice in choices if choice is not None]
    if not found:
        return None
    return [block(*b) for b in min(found, key=lambda choice: choice[0])[1]]


def _cut_bands(
    bands: int,
    pieces: int,
    fits: Callable[[int, int, int, int], bool],
    share: Callable[[int, int, int, int], float],
) -> tuple[Cost, list[Block]] | None:
    """Cut lines 0 ... ``bands`` into bands and every band across, for the lowest cost.

    A block inside one that fits fits as well, so that from every line and for every width of
    band the farthest line that fits is found going one way only.
    """
    reach = np.zeros((bands + 1, bands + 1, pieces + 1), dtype=np.int64)
    for i in range(bands):
        for j in range(pieces):
            end = pieces
            for k in range(i + 1, bands + 1):
                least = max(j, int(reach[i - 1, k, j]) if i else j)
                while end > least and not fits(i, k, j, end):
                    end -= 1
                reach[i, k, j] = end
                if end == j:
                    break

    def band(i: int, k: int) -> tuple[Cost, list[int]] | None:
        return _cut_line(pieces, lambda j: int(reach[i, k, j]), lambda j, m: share(i, k, j, m))

    best: list[tuple[Cost, list[Block]] | None] = [((0, 0.0), [])] + [None] * bands
    for i in range(bands):
        before = best[i]
        if before is None:
            continue
        for k in range(i + 1, bands + 1):
            found = band(i, k)
            if found is None:
                break
            cost = (before[0][0] + found[0][0], before[0][1] + found[0][1])
            now = best[k]
            if now is None or cost < now[0]:
                cuts = found[1]
                blocks = [(i, k, j, m) for j, m in pairwise(cuts)]
                best[k] = (cost, before[1] + blocks)
    return best[bands]


def _cut_line(
    count: int, reach: Callable[[int], int], share: Callable[[int, int], float]
) -> tuple[Cost, list[int]] | None:
    """Cut 0 ... ``count`` into the fewest pieces, of these the most even; None if impossible."""
    best: list[tuple[Cost, list[int]] | None] = [((0, 0.0), [0])] + [None] * count
    for j in range(count):
        before = best[j]
        if before is None:
            continue
        for m in range(j + 1, reach(j) + 1):
            cost = (before[0][0] + 1, before[0][1] + share(j, m) ** 2)
            now = best[m]
            if now is None or cost < now[0]:
                best[m] = (cost, [*before[1], m])
    return best[count]
