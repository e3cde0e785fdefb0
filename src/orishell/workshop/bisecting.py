"""Sheets that are no grids, cut in two until the pieces fit the stock."""

from __future__ import annotations

import math

import numpy as np

from orishell.numerics.arrays import Integers
from orishell.workshop.fitting import CutSheet


def bisect_sheet(sheet: CutSheet, pieces: Integers) -> list[Integers]:
    """Connected parts that fit the stock, made few by joining neighbours.

    Parameters
    ----------
    sheet
        The sheet; every panel fits.
    pieces
        Number (F,) of the connected piece that a panel belongs to.

    Returns
    -------
    parts
        Numbers of the panels of every part, ascending.
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
