"""Sweeps over a surface: the f and g whose shell comes nearest to it, and where it stands.

The sweep stands upright in the surface's frame, so that feet, ground and weight mean what they
say. Leaning sweeps come nearer to some surfaces inside their rim, but reach far beyond it
(docs/theory/sweeps.md).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.curves import Curve, curve_from_points, remembered, trace_curve
from orishell.design import Approached, Design, PiecedSurface, Surface
from orishell.design.asked import Shifted
from orishell.design.piece import Piece
from orishell.families.shared.sweep_fit import Sweep, SweepLimits, fit_upright
from orishell.numerics.arrays import Array
from orishell.numerics.equals import smallest_of

POINTS = 21
"""Points of f, and of a g that bends: a spline through them is within 1e-5 of the polynomials."""
CONVEX_POINTS = 41
"""Points of an f that must be convex: through fewer, a spline turns back where the curvature of a
convex polynomial falls steeply towards an end, as that of the nearest to a saddle does."""
DIGITS = 5
"""Decimals of their coordinates, relative to the surface's size."""


BEYOND = 0.01
"""A sweep that reaches beyond the rim by a larger share of the surface's diagonal draws a warning.
"""


@remembered
def best_sweep(piece: Piece, kinds: tuple[SweepLimits, ...]) -> Sweep:
    """The upright sweep that comes nearest to a piece, both ways, within the first of limits."""
    x, y = piece.axes[0, :2]
    turn = float(np.arctan2(y, x))
    found = [fit_upright(piece.vertices, piece.normals, limits, turn) for limits in kinds]
    return smallest_of(found, lambda each: each.reach)


def design_sweep(
    surface: PiecedSurface,
    limits: tuple[SweepLimits, ...],
    design: Callable[[Curve, Curve, float], Design],
    by_direction: Callable[[float], Mapping[str, Any]] = lambda _: {},
) -> Design:
    """The design of the sweep that comes nearest to a surface, to be compared with the surface.

    A family carries f along g by the middle vertex of its column, and where that lies on f is known
    once the column is: so the shell is designed twice, the second time with g beside the first g.

    Parameters
    ----------
    surface
        What is asked for, with its ``piece``.
    limits
        What the family can sweep; where there are several, the nearest sweep is taken.
    design
        Designs the shell of f, g and the direction of g from end to end (radians).
    by_direction
        What else the design file says for that direction.

    Raises
    ------
    DesignError
        If the family cannot make the nearest sweep.
    """
    piece = surface.piece
    sweep = best_sweep(piece, limits)
    convex = any(each.convex for each in limits)
    curves = _Curves.of(sweep, CONVEX_POINTS if convex else POINTS)
    f, middle = curves.f, 0.5 * sum(sweep.across)
    for _ in range(2):
        g = curves.g(middle)
        found = design(_curve(f), _curve(g), curves.direction)
        assert isinstance(found.surface, Surface)
        on_f = found.surface.origin + trace_curve(_curve(f), "f").in_own_frame().origin
        middle = -curves.side * float(on_f[0])
    origin = np.array([*found.origin[:2], found.origin[2] + on_f[1]])
    beyond = sweep.beyond > BEYOND * piece.diagonal
    return replace(
        found,
        swept=Shifted(surface, -origin),
        approached=Approached(
            f"this family sweeps an f along a g, and the nearest of these comes within "
            f"{plain(sweep.max)} of the surface",
            found.swept,
        ),
        origin=origin,
        by_curves={
            "target.surface": None,
            **_table("f", f),
            **_table("g", g),
            **by_direction(curves.direction),
        },
        warnings=(*found.warnings, *_warn_of_reach(sweep, beyond)),
    )


def _warn_of_reach(sweep: Sweep, beyond: bool) -> Iterator[str]:
    if beyond:
        yield (
            f"f along g covers the whole surface, and reaches beyond its rim by up to "
            f"{plain(sweep.beyond, 2)}"
        )


@record
class _Curves:
    """f and g of a sweep as tables of points, g in plan where the surface lies."""

    sweep: Sweep
    side: int  # 1 if g runs along the sweep's x axis, -1 if it runs the other way
    count: int  # points of f

    @classmethod
    def of(cls, sweep: Sweep, count: int) -> _Curves:
        """The curves of an upright sweep; g runs to the right, or up if it is vertical."""
        x, y = sweep.frame[:2, 0]
        return cls(sweep, 1 if x > VERTICAL or (abs(x) <= VERTICAL and y > 0) else -1, count)

    @property
    def direction(self) -> float:
        """Direction of g's axis in plan (radians)."""
        x, y = self.side * self.sweep.frame[:2, 0]
        return float(np.arctan2(y, x))

    @property
    def f(self) -> Array:
        """Points (N, 2) of f: heights in the surface's frame, to the right of g."""
        d = np.linspace(*self.sweep.across, self.count)[:: -self.side]
        height = self.sweep.profile(d) + self.sweep.centre[2]
        return self._rounded(np.stack([-self.side * d, height], axis=-1))

    def g(self, d: float) -> Array:
        """Points (N, 2) beside g at a distance d, as the sweep has it."""
        sweep = self.sweep
        count = POINTS if sweep.g.any() else 2
        x = np.linspace(*sweep.along, count)[:: self.side]
        plan = sweep.path(x, d) @ sweep.frame[:2, :2].T
        return self._rounded(plan + sweep.centre[:2])

    def _rounded(self, points: Array) -> Array:
        return np.round(points, DIGITS - int(np.floor(np.log10(self.sweep.size))))


VERTICAL = 1e-9
"""A g that leaves the vertical of the plan by less than this share runs along it."""


def _curve(points: Array) -> Curve:
    return curve_from_points(points, smooth=len(points) > 2)


def _table(name: str, points: Array) -> dict[str, Any]:
    """The table of a curve through points, as the design file has it."""
    smooth = {f"target.{name}.smooth": True} if len(points) > 2 else {}
    return {f"target.{name}.points": points.tolist(), **smooth}
