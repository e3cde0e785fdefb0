"""Panels of a FOLD file: polygons, those of four corners among them, and the edges beside them."""

from __future__ import annotations

from itertools import chain
from typing import Any

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import counted
from orishell.io.fold_values import misfit, require_vertices, shown
from orishell.motion.panel_sides import pair_keys
from orishell.motion.quads import dots, lengths
from orishell.numerics.arrays import Array, Integers

MOST_PLACES = 50_000_000
"""Number of panels times the corners of the one that has most."""
STRAIGHT = 1e-6
"""A side may turn by this sine at a vertex that lies on it."""


def read_polygons(value: Any, where: str, vertex_count: int) -> Integers:
    """Vertices (F, K) around every panel, -1 behind the last.

    Raises InputError: Naming the first panel that does not fit.
    """
    if not isinstance(value, list):
        raise misfit(value, where, "a list of panels")
    if not value:
        raise InputError("this list is empty", where=where)
    for number, row in enumerate(value):
        if not isinstance(row, list) or len(row) < 3 or any(type(each) is not int for each in row):
            raise InputError(
                f"panel {number} does not fit",
                where=f"{where}[{number}]",
                got=shown(row),
                expected="3 or more whole numbers for each panel",
            )
    size = np.array([len(row) for row in value])
    if len(value) * int(size.max()) > MOST_PLACES:
        raise InputError("a panel has too many corners", where=where, got=str(size.max()))
    there = np.arange(int(size.max())) < size[:, None]
    loops = np.full(there.shape, -1)
    try:
        loops[there] = np.fromiter(chain.from_iterable(value), np.int64, int(size.sum()))
    except OverflowError:
        raise InputError("the numbers are too large", where=where) from None
    require_vertices(loops, vertex_count, where, count=size)
    require_different(loops, where)
    return loops


def require_different(loops: Integers, where: str) -> None:
    """Refuse a panel (F, K) with the same vertex twice.

    Raises InputError: Naming the first.
    """
    ordered = np.sort(loops, axis=1)
    twice = ((ordered[:, 1:] == ordered[:, :-1]) & (ordered[:, 1:] >= 0)).any(axis=1)
    if twice.any():
        panel = int(np.argmax(twice))
        raise InputError(
            f"panel {panel} repeats a corner",
            where=f"{where}[{panel}]",
            got=str(loops[panel][loops[panel] >= 0].tolist())[:60],
            expected="different vertices",
            remedy="a smaller weld" if "weld" in where else "list each of its vertices once",
        )


def find_corners(loops: Integers, positions: Array, where: str) -> Integers:
    """The four corners (F, 4) of panels (F, K): other vertices lie on their sides.

    Raises InputError: If a panel of more than four vertices has not four corners.
    """
    if loops.shape[1] == 4 and (loops >= 0).all():
        return loops
    count = (loops >= 0).sum(axis=1)[:, None]
    place = np.arange(loops.shape[1])[None]
    here = positions[loops]
    after, before = (
        positions[np.take_along_axis(loops, (place + step) % count, axis=1)] - here
        for step in (1, -1)
    )
    bent = lengths(np.cross(after, before)) > STRAIGHT * lengths(after) * lengths(before)
    bent |= dots(after, before) >= 0
    corner = (place < count) & (bent | (count == 4))
    wrong = corner.sum(axis=1) != 4
    if wrong.any():
        panel = int(np.argmax(wrong))
        raise InputError(
            f"panel {panel} does not fit",
            where=f"{where}[{panel}]",
            got=f"{int(count[panel, 0])} whole numbers",
            expected="4 whole numbers for each panel, or more where all but 4 lie on its sides",
        )
    order = np.argsort(~corner, axis=1, kind="stable")[:, :4]
    return np.asarray(np.take_along_axis(loops, order, axis=1))


def sides_among(
    edges: Integers,
    letters: NDArray[np.str_] | None,
    sides: Integers,
    vertex_count: int,
    *,
    welded: bool,
    notes: list[str],
) -> tuple[Integers, NDArray[np.str_] | None]:
    """Which edges are sides of panels, and their letters."""
    known, count = np.unique(pair_keys(sides, vertex_count), return_counts=True)
    keys = pair_keys(edges, vertex_count)
    at = np.minimum(np.searchsorted(known, keys), len(known) - 1)
    is_side = known[at] == keys
    chosen = np.flatnonzero(is_side)
    if not is_side.all():
        notes.append(f"{counted(int((~is_side).sum()), 'edge')} of no panel: left out")
    if welded:  # of edges that become one, a crease rather than a border
        black = np.zeros(len(chosen)) if letters is None else letters[chosen] == "B"
        order = chosen[np.lexsort((chosen, black))]
        chosen = order[np.unique(keys[order], return_index=True)[1]]
    if letters is None:
        return chosen, None
    letters = letters[chosen]
    inner = (count[at[chosen]] > 1) & (letters == "B")
    if inner.any():
        unknown = bool(np.isin(letters, ["B", "C"]).all())
        letters = np.where(inner, "U" if unknown else "C", letters)
        what = "no crease is assigned" if unknown else "a cut"
        notes.append(f"{counted(int(inner.sum()), 'border')} between two panels: {what}")
    return chosen, letters
