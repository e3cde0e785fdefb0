"""Panels and edges as FOLD files list them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.quantities import counted
from orishell.motion.panel_sides import pair_keys
from orishell.numerics.arrays import Integers


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
