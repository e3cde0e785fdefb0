"""Curves whose formulas were given degrees: they run along themselves, or wave, many times."""

from __future__ import annotations

import ast
from collections.abc import Callable

import numpy as np

from orishell.conventions.errors import CurveError
from orishell.curves.formula_syntax import syntax_tree
from orishell.numerics.arrays import Array

WINDINGS = 4
"""A curve that turns more often than this in radians, each time along the last one, and at most
once in degrees, was meant in degrees: no family takes a curve that runs along itself. A spiral may
be meant."""
AGAIN = 1e-9
"""A turn runs along the last one if it leaves it by less than this share of its size."""
SPAN, LARGEST_NUMBER = 30, 720
"""Degrees are whole numbers, the ends at least this far apart and no larger than this."""
CELLS = 8192
"""Steps along the range, none of which may turn by half a turn or more."""

RIGHT, HALF_RIGHT = 90, 45
"""Waves of whole numbers from end to end, as many as these degrees or more and in steps of those,
may be meant in degrees."""

CurveJet = Callable[[Array], tuple[Array, Array, Array]]


def require_radians(jet: CurveJet, start: float, stop: float) -> None:
    """Refuse a range that looks like degrees, where the curve runs along itself in radians."""
    if not look_like_degrees(start, stop):
        return
    turns = _turns(jet, start, stop)
    if turns <= WINDINGS or _turns(jet, np.deg2rad(start), np.deg2rad(stop)) > 1 + 1e-6:
        return
    if not _runs_again(jet, start, stop):
        return
    raise CurveError(
        f"the curve runs {turns:.0f} times along itself, because formulas take radians",
        where="range",
        got=f"[{start:g}, {stop:g}], which look like degrees",
        expected="radians",
        remedy=f'range = ["{start:g}*pi/180", "{stop:g}*pi/180"]',
    )


def look_like_degrees(start: float, stop: float) -> bool:
    """Whether the ends of a range are whole numbers far apart, as an architect writes degrees."""
    whole = not start % 1 and not stop % 1
    return whole and stop - start >= SPAN and max(-start, stop) <= LARGEST_NUMBER


def _turns(jet: CurveJet, start: float, stop: float) -> float:
    """By how many turns the tangent turns in all; 0 where it has none."""
    first = jet(np.linspace(start, stop, CELLS + 1))[1]
    if not np.isfinite(first).all() or not first.any(axis=1).all():
        return 0.0
    turned = np.unwrap(np.arctan2(first[:, 1], first[:, 0]))
    return float(abs(turned[-1] - turned[0]) / (2 * np.pi))


def _runs_again(jet: CurveJet, start: float, stop: float) -> bool:
    """Whether each turn of a curve, a whole one in radians, runs along the last one."""
    one = np.linspace(start, stop - 2 * np.pi, CELLS + 1)
    here, there = jet(one)[0], jet(one + 2 * np.pi)[0]
    return bool(np.abs(there - here).max() <= AGAIN * np.ptp(here, axis=0).max())


def note_degrees(text: str, start: float, stop: float) -> tuple[str, ...]:
    """What to ask of a formula whose waves look as if they were given degrees.

    Parameters
    ----------
    text
        The formula.
    start, stop
        The range of its variable.
    """
    tree, _ = syntax_tree(text)
    for node in ast.walk(tree):
        match node:
            case ast.Call(func=ast.Name(id="sin" | "cos" as name), args=[argument]):
                slope = _slope(argument)
                ends = (slope or 0.0) * start, (slope or 0.0) * stop
                span = abs(ends[1] - ends[0])
                whole = not ends[0] % 1 and not ends[1] % 1 and not span % HALF_RIGHT
                if whole and span >= RIGHT:
                    said = ast.unparse(argument).replace(" ", "")
                    waves = span / (2 * np.pi)
                    return (
                        f"formulas take radians: {name}({said}) goes through {waves:.0f} waves "
                        f"from {start:g} to {stop:g}. If degrees were meant, write "
                        f"{name}({said}*pi/180)",
                    )
    return ()


def _slope(node: ast.expr) -> float | None:
    """What an argument grows by with the variable, if it is a whole number times it, or alone."""
    match node:
        case ast.Name(id=name) if name not in ("pi", "e"):
            return 1.0
        case ast.BinOp(left=ast.Constant(value=int() as factor), op=ast.Mult(), right=ast.Name()):
            return float(factor) if _slope(node.right) else None
        case ast.BinOp(left=ast.Name(), op=ast.Mult(), right=ast.Constant(value=int() as factor)):
            return float(factor) if _slope(node.left) else None
    return None
