"""What a sheet must satisfy to be made: positive edges, no overlap, nothing lost in rounding."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from orishell.errors import DesignError
from orishell.families.parallel_repeating.mechanism import ParallelRepeating
from orishell.geometry import is_simple_polygon
from orishell.polylines import Staircase
from orishell.quoting import in_degrees, inside

Array = NDArray[np.float64]

RESOLUTION = 1e-8
"""A crease must be at least this long relative to the largest coordinate."""
SHORTEST_EDGE = 1e-6
"""A row edge must keep this share of the length it has in the middle row."""


def require_row_edges(mechanism: ParallelRepeating) -> None:
    """Row edges are affine in the distance from the middle row: look at the outermost rows."""
    middle = np.abs(np.diff(mechanism.points))
    rows = (0, len(mechanism.lengths))
    share = np.stack([mechanism.row_lengths(row) for row in rows]) / middle
    worst = np.unravel_index(int(share.argmin()), share.shape)
    if share[worst] > SHORTEST_EDGE:
        return
    row, column = rows[int(worst[0])], int(worst[1]) + 1
    length = share[worst] * middle[worst[1]]
    reach = abs(mechanism.column_arcs()[row]) * np.sin(mechanism.xi / 2)
    scale = inside(1 / (1 - share[worst]), 0.0)
    raise DesignError(
        "neighbouring columns meet inside the sheet: g bends more sharply than f reaches",
        place=f"at row {row} between columns {column} and {column + 1}",
        size=f"the crease there would be {length:.4g} long, where f reaches {reach:.4g} from g",
        nearest=f"scale = {scale:.4g} in [target.f], or scale = {1 / scale:.4g} in [target.g]",
    )


def require_resolution(mechanism: ParallelRepeating) -> None:
    """Panels so small that the rounding of coordinates would bend them are refused."""
    rows = (0, len(mechanism.lengths))
    edges = {
        "crease of a row": min(float(mechanism.row_lengths(row).min()) for row in rows),
        "crease of column 1": float(mechanism.lengths.min()),
        "crease across a flap": min(mechanism.flaps),
    }
    name = min(edges, key=lambda each: edges[each])
    flat = mechanism.positions(0.0)
    smallest = RESOLUTION * float(np.abs(flat).max())
    if edges[name] < smallest:
        raise DesignError(
            "a panel is so small that the rounding of coordinates would bend it",
            place=f"at the shortest {name}",
            size=f"it is {edges[name]:.4g} long with coordinates up to {np.abs(flat).max():.4g}",
            nearest=f"a length of {smallest:.4g}: change rows, columns, flap or xi_deg, or move "
            "the curves nearer to the origin",
        )


def require_flat_sheet(
    mechanism: ParallelRepeating,
    flap: float,
    parameters: Array,
    staircase: Callable[[float], Staircase],
) -> None:
    """The flat sheet must not overlap itself; all panels are convex, so its border decides.

    Parameters
    ----------
    flap
        Width of the flaps.
    parameters
        Parameters of g's vertices.
    staircase
        The staircase of f for another xi.
    """
    if _is_flat_sheet(mechanism):
        return
    if _is_flat_sheet(mechanism, flaps=False):
        share = _bisect_down(
            1.0,
            lambda share: _is_flat_sheet(
                replace(mechanism, flaps=(share * mechanism.flaps[0], share * mechanism.flaps[1]))
            ),
        )
        raise DesignError(
            "the flaps overlap in the flat sheet",
            size=f"they are {flap:.4g} wide",
            nearest=f"flap = {share * flap:.4g}" if share else "a longer g",
        )

    def works(xi: float) -> bool:
        other = staircase(xi)
        return _is_flat_sheet(
            replace(mechanism, xi=other.xi, lengths=other.lengths.copy(), first=other.first)
        )

    def fits(columns: int) -> bool:
        points, axes = mechanism.points[:columns].copy(), mechanism.axes[:columns].copy()
        return _is_flat_sheet(replace(mechanism, points=points, axes=axes))

    xi = _bisect_down(mechanism.xi, works)
    columns = max((c for c in range(2, len(parameters)) if fits(c)), default=2)
    end = inside(parameters[columns - 1], parameters[0])
    part = f"the part of g from parameter {parameters[0]:.6g} to {end:.6g}"
    raise DesignError(
        "the flat sheet overlaps itself: g turns too far",
        place=f"first at column {columns + 1}",
        nearest=f"xi_deg = {in_degrees(xi)}, or {part}" if xi else part,
    )


def _is_flat_sheet(mechanism: ParallelRepeating, *, flaps: bool = True) -> bool:
    flat = mechanism.positions(0.0)
    return _is_simple(flat if flaps else flat[:, 1:-1])


def _is_simple(flat: Array) -> bool:
    """Whether the border of the sheet crosses itself; columns are straight, their ends suffice."""
    return is_simple_polygon(np.concatenate([flat[0, :, :2], flat[-1, ::-1, :2]]))


def _bisect_down(bad: float, works: Callable[[float], bool]) -> float | None:
    """The largest value below ``bad`` that works, or None if not even a twentieth of it does."""
    good = bad / 20
    if not works(good):
        return None
    while bad - good > 1e-3 * bad:
        middle = 0.5 * (good + bad)
        good, bad = (middle, bad) if works(middle) else (good, middle)
    return good
