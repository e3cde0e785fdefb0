"""Splitting a sheet larger than the stock along creases, into few parts."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import cache, partial
from itertools import pairwise

import numpy as np

from orishell.document import Part
from orishell.numerics.arrays import Integers
from orishell.numerics.components import find_components
from orishell.workshop.fitting import CutSheet, require_panels_fit


def _bisect(sheet: CutSheet, pieces: Integers) -> list[Integers]:
    """Connected sets of panels that fit, by cuts of pieces (F,) across their longer side."""
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
    beside = sheet.neighbours[panels]
    here, side = np.nonzero(np.isin(beside, panels))
    there = np.searchsorted(panels, beside[here, side])
    labels = find_components(np.stack([here, there], axis=1), len(panels))
    return [panels[labels == k] for k in range(labels.max(initial=-1) + 1)]


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
    document: Part, stock_width: float, stock_height: float, allowance: float
) -> tuple[Integers, ...]:
    """Split the flat sheet along creases into parts that fit the stock, at any angle.

    A grid is cut into bands along whole lines, rows or columns, and every band across, with the
    fewest parts that this allows, of areas as even as can be. Other sheets are cut in two
    across their longer side until the pieces fit, and pieces that fit together are joined.
    Cut creases have tabs of a width, ``allowance``. Panels of a part ascend, and so do parts by
    their first panel.
    """
    sheet = CutSheet.of(document, stock_width, stock_height, allowance)
    require_panels_fit(document, sheet)
    if document.whole_grid is not None and not document.mesh.pieces.any():
        rows, columns = document.whole_grid
        number = np.arange((rows - 1) * (columns - 1)).reshape(rows - 1, columns - 1)
        parts = _split_bands(sheet, number, *_choose_lines(sheet, number))
    else:
        parts = _join_pieces(sheet, _bisect(sheet, document.mesh.pieces))
    return tuple(sorted((np.sort(part) for part in parts), key=lambda part: int(part[0])))


def _choose_lines(sheet: CutSheet, number: Integers) -> tuple[list[int], list[int]]:
    """Rows and columns along which to cut: evenly spread, then more until what is between fits."""
    lines = []
    for count in number.shape:
        parts = min(count, LINES)
        lines.append(sorted({round(count * k / parts) for k in range(parts + 1)}))
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


def _split_bands(
    sheet: CutSheet, number: Integers, rows: list[int], columns: list[int]
) -> list[Integers]:
    """The fewest blocks that fit, from bands of rows or of columns that are cut across."""

    def block(i: int, k: int, j: int, m: int) -> Integers:
        return number[rows[i] : rows[k], columns[j] : columns[m]]

    @cache
    def fits(i: int, k: int, j: int, m: int) -> bool:
        panels = block(i, k, j, m)
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
        raise AssertionError("every panel fits, so there is a split into panels")
    return [block(*b).ravel() for b in min(found, key=lambda choice: choice[0])[1]]


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

    def blocks_from(i: int, k: int, j: int) -> Iterator[tuple[int, Cost, list[Block]]]:
        for m in range(j + 1, int(reach[i, k, j]) + 1):
            yield m, (1, share(i, k, j, m) ** 2), [(i, k, j, m)]

    def bands_from(i: int) -> Iterator[tuple[int, Cost, list[Block]]]:
        for k in range(i + 1, bands + 1):
            found = _cheapest(pieces, partial(blocks_from, i, k))
            if found is None:
                return
            yield k, *found

    return _cheapest(bands, bands_from)


def _cheapest(
    count: int, steps: Callable[[int], Iterator[tuple[int, Cost, list[Block]]]]
) -> tuple[Cost, list[Block]] | None:
    """The cheapest way from 0 to ``count`` by steps from each place; None if there is none.

    A step is where it ends, what it costs (blocks, and how uneven they are) and its blocks.
    """
    best: list[tuple[Cost, list[Block]] | None] = [((0, 0.0), [])] + [None] * count
    for begin in range(count):
        before = best[begin]
        if before is None:
            continue
        for end, added, blocks in steps(begin):
            cost = (before[0][0] + added[0], before[0][1] + added[1])
            now = best[end]
            if now is None or cost < now[0]:
                best[end] = (cost, before[1] + blocks)
    return best[count]
