"""What a sheet must satisfy to be made: positive edges, no overlap, nothing lost in rounding."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import chain

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.quantities import plain
from orishell.curves import Curve
from orishell.curves.plane import is_simple_polygon
from orishell.families.parallel_repeating.mechanism import ParallelRepeating
from orishell.families.shared.candidates import angles, part, sizes, values
from orishell.motion import RESOLUTION
from orishell.numerics.arrays import Array
from orishell.numerics.bisection import largest_below
from orishell.numerics.equals import first_smallest
from orishell.polylines import Staircase

STRETCH = 0.1
"""Logarithm of the stretch of f along g that draws a warning where f's plane is perpendicular."""
PARTS = (1.0, 0.8, 0.5)
"""Shares tried of the part of g that just fits."""
SMALLEST_SHARE = 1e-6
"""No smaller share of flaps, or of xi, is looked for."""
WIDEST_XI = 0.95
"""Above this share of its limit a wider xi_deg gains next to nothing."""
SHORTEST_EDGE = 1e-6
"""A row edge must keep this share of the length it has in the middle row."""


def require_row_edges(mechanism: ParallelRepeating, f: Curve, g: Curve) -> None:
    """Refuse row edges that lose their length; it is affine in the row: the outermost decide."""
    middle = np.abs(np.diff(mechanism.points))
    rows = (0, len(mechanism.lengths))
    share = np.stack([mechanism.row_lengths(row) for row in rows]) / middle
    worst = np.unravel_index(first_smallest(share, size=1.0), share.shape)
    if share[worst] > SHORTEST_EDGE:
        return
    row, column = rows[int(worst[0])], int(worst[1]) + 1
    length = share[worst] * middle[worst[1]]
    reach = abs(mechanism.column_arcs()[row]) * np.sin(mechanism.xi / 2)
    scale = float(1 / (1 - share[worst]))
    raise DesignError(
        "neighbouring columns meet inside the sheet: f reaches too far into a bend of g",
        place=f"at row {row} between columns {column} and {column + 1}",
        size=f"the crease there would be {plain(length)} long; there f reaches "
        f"{plain(reach)} from g",
        candidates=chain(sizes("f", f, scale), sizes("g", g, 1 / scale)),
        excess=SHORTEST_EDGE - share[worst],
    )


def require_flap_resolution(mechanism: ParallelRepeating, flap: float) -> None:
    """Refuse flaps that rounding would bend, or beside which it would bend other panels."""
    sheet = mechanism.positions(0.0)[:, mechanism.inner_columns]
    widest = float(np.linalg.norm(np.ptp(sheet.reshape(-1, 3), axis=0)))
    narrowest = RESOLUTION * widest / min(mechanism.with_flaps(1.0).flaps)
    if flap and not narrowest <= flap <= widest:
        raise DesignError(
            "the flaps are too narrow or too wide for this sheet",
            size=f"they are {plain(flap)} wide, and may be {plain(narrowest)} to {plain(widest)}",
            candidates=values("flap", narrowest, widest, flap),
            excess=max(1 - flap / narrowest, flap / widest - 1),
        )


def require_flat_sheet(
    mechanism: ParallelRepeating,
    flap: float,
    parameters: Array,
    staircase: Callable[[float], Staircase],
    g: Curve,
) -> None:
    """Refuse a flat sheet that overlaps itself; all panels are convex, so its border decides.

    parameters: Parameters of g's vertices.
    staircase: The staircase of f for another xi.
    """
    if _is_flat_sheet(mechanism):
        return
    if _is_flat_sheet(mechanism, flaps=False):
        share = largest_below(
            lambda share: _is_flat_sheet(mechanism.with_flaps(share * flap)),
            1.0,
            smallest=SMALLEST_SHARE,
        )
        raise DesignError(
            "the flaps overlap in the flat sheet",
            size=f"they are {plain(flap)} wide",
            candidates=values("flap", 0.0, share * flap, flap) if share else (),
            excess=1 / share - 1 if share else None,
        )

    def works(xi: float) -> bool:
        other = staircase(xi)
        trial = replace(mechanism, xi=other.xi, lengths=other.lengths, first=other.first)
        return _is_flat_sheet(trial.with_flaps(flap))

    def fits(columns: int) -> bool:
        trial = replace(mechanism, points=mechanism.points[:columns], axes=mechanism.axes[:columns])
        return _is_flat_sheet(trial.with_flaps(flap))

    columns = next(c for c in range(3, len(parameters) + 1) if not fits(c)) - 1

    def candidates() -> Iterator[Remedy]:
        xi = largest_below(works, mechanism.xi, smallest=SMALLEST_SHARE)
        if xi:
            yield from angles("xi_deg", 0.0, xi, mechanism.xi)
        # Shorter by a column, for the vertices will stand elsewhere on the part.
        for share in PARTS:
            end = parameters[max(int(share * (columns - 2)), 1)]
            yield part("g", g, float(parameters[0]), float(end))

    raise DesignError(
        "the flat sheet overlaps itself: g turns too far",
        place=f"first at column {columns + 1}",
        candidates=candidates(),
        excess=len(parameters) / columns - 1,
    )


def warn_of_stretched_columns(mechanism: ParallelRepeating, plane: float) -> tuple[str, ...]:
    """Warn of columns that a coarse g stretches although f's plane is perpendicular to it."""
    scales = mechanism.column_scales()
    if plane != np.pi / 2 or np.abs(np.log(scales)).max() <= STRETCH:
        return ()
    return (
        f"along g, f is stretched to between {plain(scales.min(), 3)} and {plain(scales.max(), 3)} "
        "of its width, because g turns too much from column to column; take more columns",
    )


def _is_flat_sheet(mechanism: ParallelRepeating, *, flaps: bool = True) -> bool:
    """Whether the border never crosses itself; columns are straight, so their ends suffice."""
    flat = mechanism.positions(0.0)
    flat = flat if flaps else flat[:, mechanism.inner_columns]
    return is_simple_polygon(np.concatenate([flat[0, :, :2], flat[-1, ::-1, :2]]))


def less_sheet(xi: float, limit: float) -> str:
    """What would make the flat sheet smaller; both angles in degrees."""
    if xi < WIDEST_XI * limit:
        return f"shallower folds, by a wider xi_deg ({xi:.4g} now, possible below {limit:.4g}),"
    return f"an f with less steep ends (they keep xi_deg below {limit:.4g})"
