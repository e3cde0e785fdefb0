"""Curves that cross themselves: their shells run through themselves, however they fold."""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import DesignError
from orishell.design import Design


def require_uncrossed(design: Design) -> None:
    """Refuse a shell that runs through itself at its target because f does.

    Columns are affine images of f's staircase, so one of them shows it. It is seen here at once,
    where looking for the first contact on the way takes long: all over the sheet panels meet.

    Raises
    ------
    DesignError
        If a column crosses itself.
    """
    import shapely

    if design.swept is None:
        return
    mechanism = design.mechanism
    column = mechanism.positions(mechanism.target_drive)[:, mechanism.inner_columns.start]
    centred = column - column.mean(axis=0)
    flat = centred @ np.linalg.svd(centred, full_matrices=False)[2][:2].T
    pieces = np.asarray(shapely.linestrings(np.stack([flat[:-1], flat[1:]], axis=1)))
    first, second = shapely.STRtree(pieces).query(pieces, predicate="crosses")
    if not len(first):
        return
    one = int(first.argmin())
    rows = [sorted(pair) for pair in zip(first.tolist(), second.tolist(), strict=True)]
    above, below = rows[one]
    places = len({tuple(pair) for pair in rows})
    raise DesignError(
        "f crosses itself, so that the shell would run through itself",
        place=f"panels of row {above} pass through those of row {below}",
        size=f"it does so in {places} place{'s' * (places > 1)}",
    )
