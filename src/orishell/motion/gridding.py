"""Rows and columns of a pattern of quadrilaterals in any order, turned or mirrored."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.formatting import rounded
from orishell.motion.crease_pattern import CreasePattern, Mark
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Integers
from orishell.numerics.equals import first_largest


def find_grid(pattern: CreasePattern) -> Integers:
    """Numbers (rows, columns) of a pattern's vertices where its panels are those of a grid.

    Seen from +z rows run along x as far as one of the four sides allows, and columns downwards.

    Parameters
    ----------
    pattern
        The pattern.

    Raises
    ------
    InputError
        If the panels are not those of a grid: where.
    """
    for mark in find_irregular(pattern):
        raise _no_grid("the panels do not make a grid", mark.what, mark.x, mark.y)
    faces, twins = pattern.faces[:, :4], _twins(pattern)
    # A corner of the sheet: both sides of its panel that meet there belong to no other panel.
    panels, starts = np.nonzero((twins < 0) & (np.roll(twins, 1, axis=1) < 0))
    if len(panels) != 4:
        raise _no_grid(
            "the panels do not make one sheet with four corners", f"{len(panels)} corners"
        )
    # Corners of a panel from its start: top left, bottom left, bottom right, top right.
    panel, start = int(panels[0]), int(starts[0])
    column = [4 * panel + start]
    while (below := int(twins[panel, (start + 1) % 4])) >= 0:
        panel, start = below // 4, (below + 1) % 4
        column.append(4 * panel + start)
    panel_columns = [np.array(column)]
    while True:
        panels, starts = panel_columns[-1] // 4, panel_columns[-1] % 4
        beside = twins[panels, (starts + 2) % 4]
        if (beside < 0).any():
            break
        panel_columns.append(beside)
    placed = np.stack(panel_columns, axis=1)
    if placed.size != len(faces):
        raise _no_grid(
            "the panels do not make one sheet",
            f"{placed.size} of {len(faces)} panels hang together",
        )

    def corners(places: Integers, step: int) -> Integers:
        return np.asarray(faces[places // 4, (places + step) % 4])

    upper = np.concatenate([corners(placed, 0), corners(placed[:, -1:], 3)], axis=1)
    last = np.concatenate([corners(placed[-1:], 1), corners(placed[-1:, -1:], 2)], axis=1)
    return _turned(pattern, np.concatenate([upper, last]))


def grid_edges(pattern: CreasePattern, numbers: Integers) -> Integers:
    """Numbers (E,) of a pattern's edges in the order of :meth:`Grid.edges_vertices`.

    Parameters
    ----------
    pattern
        The pattern.
    numbers
        Its vertices (rows, columns), as :func:`find_grid` finds them.
    """
    wanted = numbers.ravel()[Grid(*numbers.shape).edges_vertices()]
    own, asked = (_keys(each, len(pattern.vertices)) for each in (pattern.edges, wanted))
    order = np.argsort(own)
    return np.asarray(order[np.searchsorted(own, asked, sorter=order)])


def grid_creases(pattern: CreasePattern, numbers: Integers) -> tuple[Integers, Integers]:
    """Numbers of a pattern's edges that are row creases (R, C+1) and column creases (R+1, C).

    Parameters
    ----------
    pattern
        The pattern.
    numbers
        Its vertices (rows, columns), as :func:`find_grid` finds them.
    """
    rows, columns = numbers.shape
    row, column = np.split(grid_edges(pattern, numbers), [rows * (columns - 1)])
    return row.reshape(rows, columns - 1)[1:-1], column.reshape(rows - 1, columns)[:, 1:-1]


def find_irregular(pattern: CreasePattern) -> Iterator[Mark]:
    """What keeps the panels of a pattern from making a grid, place by place.

    Panels have four corners; four of them meet at inner vertices, one or two at the border.

    Parameters
    ----------
    pattern
        The pattern.
    """
    counts = (pattern.faces >= 0).sum(axis=1)
    if (counts != 4).any():
        for panel in np.flatnonzero(counts != 4).tolist():
            at = pattern.vertices[pattern.faces[panel, : counts[panel]]].mean(axis=0)
            yield Mark(float(at[0]), float(at[1]), f"a panel of {counts[panel]} vertices")
        return
    met = np.bincount(pattern.faces[:, :4].ravel(), minlength=len(pattern.vertices))
    inner = np.zeros(len(met), dtype=np.bool_)
    inner[pattern.inner] = True
    wrong = np.where(inner, met != 4, met > 2)
    for vertex in np.flatnonzero(wrong).tolist():
        kind = "inside the sheet" if inner[vertex] else "at a border"
        x, y = pattern.vertices[vertex].tolist()
        yield Mark(x, y, f"{met[vertex]} panels at a vertex {kind}")


def _no_grid(what: str, got: str, *at: float) -> InputError:
    where = f"at ({', '.join(str(rounded(float(each))) for each in at)})" if at else ""
    return InputError(
        what,
        where=where,
        got=got,
        expected="rows and columns of quadrilaterals, four panels around every vertex inside",
        remedy="fold it with orishell fold, which takes panels of any shape",
    )


def _keys(edges: Integers, count: int) -> Integers:
    low, high = edges.min(axis=-1), edges.max(axis=-1)
    return np.asarray(low * count + high)


def _twins(pattern: CreasePattern) -> Integers:
    """Panel and side, as 4 panel + side, (F, 4) on the other side of every side; -1 for none."""
    faces = pattern.faces[:, :4]
    sides = np.stack([faces, np.roll(faces, -1, axis=1)], axis=-1).reshape(-1, 2)
    keys = _keys(sides, len(pattern.vertices))
    order = np.argsort(keys, kind="stable")
    pairs = np.flatnonzero(keys[order[1:]] == keys[order[:-1]])
    twins = np.full(len(keys), -1)
    twins[order[pairs]], twins[order[pairs + 1]] = order[pairs + 1], order[pairs]
    cut = ~pattern.crease
    twins[np.isin(keys, _keys(pattern.edges[cut], len(pattern.vertices)))] = -1
    return twins.reshape(-1, 4)


def _turned(pattern: CreasePattern, numbers: Integers) -> Integers:
    """Vertices with rows along x, as far as they are."""
    turns = [np.rot90(numbers, k) for k in range(4)]
    ways = [pattern.vertices[each[:, -1]] - pattern.vertices[each[:, 0]] for each in turns]
    lengths = [np.hypot(*way.mean(axis=0)) for way in ways]
    along = [
        way.mean(axis=0)[0] / length if length > 0 else 0.0
        for way, length in zip(ways, lengths, strict=True)
    ]
    return turns[first_largest(along)]
