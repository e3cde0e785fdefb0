"""How small panels may be beside their sheet."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.quantities import plain
from orishell.motion.mechanism import Mechanism
from orishell.motion.quads import lengths

RESOLUTION = 1e-8
"""An edge must be at least this long relative to the diagonal of the flat sheet."""


def require_resolution(mechanism: Mechanism, candidates: Iterable[Remedy]) -> None:
    """Refuse panels so small that the rounding of coordinates would bend them.

    Parameters
    ----------
    candidates
        What may give larger panels.

    Raises
    ------
    DesignError
        If an edge is shorter than :data:`RESOLUTION` of the sheet's diagonal.
    """
    flat = mechanism.positions(0.0)
    size = float(np.linalg.norm(np.ptp(flat.reshape(-1, 3), axis=0)))
    edges = {
        "a row": lengths(np.diff(flat, axis=1)),
        "a column": lengths(np.diff(flat, axis=0)),
    }
    name = min(edges, key=lambda each: float(edges[each].min()))
    shortest = float(edges[name].min())
    if shortest < RESOLUTION * size:
        row, column = np.unravel_index(int(edges[name].argmin()), edges[name].shape)
        raise DesignError(
            "a panel is so small that the rounding of coordinates would bend it",
            place=f"at row {row}, column {column}",
            size=f"an edge of {name} is {plain(shortest)} long, and must be at least "
            f"{RESOLUTION:g} "
            f"of the sheet's diagonal, which is {plain(size)}",
            candidates=candidates,
            excess=1 - shortest / (RESOLUTION * size),
        )
