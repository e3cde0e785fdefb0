"""All solutions of the paper's equation (4) for four given sector angles.

In deviations from pi/2 (see ``sectors``) equation (4) reads

    alpha_2 = gamma_1 + delta_2 - beta_1,    beta_2 = gamma_1 + delta_2 - alpha_1,
    cos gamma_1 cos gamma_2 = cos delta_1 cos delta_2,
    c = num/den, the left side of the last line, in its cosine or its sine version.

So everything is a function of one angle x, delta_2 or gamma_2, the other following from the third
line in two branches, plus and minus. x is the one with the larger cosine beside it: the other then
exists for every x, and its branches are smooth.

The square root in the last line, with the sign k, is either of two fractions, equal because of the
third line (one of them may be 0/0):

    c = cos gamma_2 sin(gamma_1 - delta_1) / (cos delta_1 sin(delta_2 - gamma_2))
      = cos delta_1 sin(gamma_2 + delta_2) / (cos gamma_2 sin(gamma_1 + delta_1)).

Both are scanned without their denominators over (-pi/2, pi/2).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from orishell.families.longitudinal_linear_repeating.sectors import Sectors

Array = NDArray[np.float64]
Version = Literal["cosine", "sine"]
VERSIONS: tuple[Version, Version] = ("cosine", "sine")

SCAN = 20001
"""Points of the scan, equally spaced; a tenth as many are gathered about 0 and at either end."""
SOLVED = 1e-8
"""Both sides of the equation agree if they differ by less than this share."""
SAME = 1e-6
"""Angles that differ by less than this share of the deviations are the same."""
MARGIN = 1e-6
"""Sector angles keep this distance from 0 and pi (radians)."""


@dataclass(frozen=True, slots=True)
class Solution:
    """A solution of equation (4).

    Parameters
    ----------
    version
        Which version of the last line of (4) it solves.
    first, second
        Sectors of columns 1 and 2.
    c
        tan(v_2/2) / tan(v_1/2), the columns' fold angles, throughout the motion.
    """

    version: Version
    first: Sectors
    second: Sectors
    c: float


def find_solutions(
    first: Sectors, *, points: int = SCAN, inside: bool = True
) -> tuple[Solution, ...]:
    """All solutions of (4) but the degenerate one: cosine version first, then by delta_2.

    Parameters
    ----------
    first
        Sectors of column 1.
    points
        Points of the scan.
    inside
        False gives the roots whose sector angles are not inside (0, pi) instead: sums that close
        no panel.

    Examples
    --------
    >>> found = find_solutions(Sectors.from_degrees([85, 80, 95, 100]))
    >>> [solution.version for solution in found]
    ['cosine', 'sine']
    >>> [round(angle, 2) for angle in found[0].second.degrees]
    [91.23, 86.23, 106.23, 76.23]
    """
    scan = _scan(points)
    found: list[Solution] = []
    for version in VERSIONS:
        equation = [
            _Equation(first, version, branch, other_fraction)
            for branch in (1.0, -1.0)
            for other_fraction in (False, True)
        ]
        solutions = [each.solution(x) for each in equation for x in _roots(each, scan)]
        for solution in sorted(solutions, key=lambda solution: solution.second.delta):
            known = any(
                other.version == version and _same(solution.second, other.second) for other in found
            )
            if not known and _is_motion(solution) and _is_inside(solution) == inside:
                found.append(solution)
    return tuple(found)


def _scan(points: int) -> Array:
    limit = np.pi / 2
    near = np.geomspace(1e-8, limit, points // 10)[:-1]
    even = np.linspace(-limit, limit, points + 2)[1:-1]
    end = limit - np.geomspace(1e-5, 1.0, points // 10)
    return np.unique(np.concatenate([-near, -end, even, end, near]))


def _same(one: Sectors, other: Sectors) -> bool:
    scale = np.abs(one.deviations).max()
    return bool(np.abs(one.deviations - other.deviations).max() < SAME * scale)


def _is_inside(solution: Solution) -> bool:
    return bool(np.abs(solution.second.deviations).max() < np.pi / 2 - MARGIN)


def _is_motion(solution: Solution) -> bool:
    """Whether it is a solution whose vertices fold, and not the degenerate one."""
    second = solution.second
    if _same(second, solution.first.opposite):
        return False
    for sectors in (solution.first, second):
        alpha, beta, gamma, delta = sectors.deviations
        scale = SAME * np.abs(sectors.deviations).max()
        # Two creases of these vertices are one straight line, and fold alone.
        crossing = abs(alpha - beta if solution.version == "sine" else alpha + beta) < scale
        if crossing or abs(gamma + delta) < scale:
            return False
    return np.isfinite(solution.c) and all(
        _Equation(solution.first, solution.version, 1.0, other).is_solved_by(second)
        for other in (False, True)
    )


@dataclass(frozen=True, slots=True)
class _Equation:
    """The last line of (4) as a function of x, on one branch (+1 or -1)."""

    first: Sectors
    version: Version
    branch: float
    other_fraction: bool

    def second(self, x: Array) -> Array:
        """Deviations of alpha_2, beta_2, gamma_2, delta_2 (4, ...) at x (...)."""
        first = self.first
        by_delta = abs(first.delta) >= abs(first.gamma)
        far, near = (first.delta, first.gamma) if by_delta else (first.gamma, first.delta)
        # cos near cos y = cos far cos x, solved for sin(y)^2 so that small angles keep digits.
        square = np.sin(far - near) * np.sin(far + near) + (np.cos(far) * np.sin(x)) ** 2
        y = self.branch * np.arctan2(np.sqrt(square), np.cos(far) * np.cos(x))
        gamma, delta = (y, x) if by_delta else (x, y)
        total = first.gamma + delta
        return np.stack([total - first.beta, total - first.alpha, gamma, delta])

    def ratio(self, second: Array) -> tuple[Array, Array]:
        """Numerator and denominator of c, from the F rows."""
        half_sum, half_difference = (second[0] + second[1]) / 2, (second[1] - second[0]) / 2
        a = (self.first.alpha + self.first.beta) / 2
        b = (self.first.alpha - self.first.beta) / 2
        if self.version == "cosine":
            return np.cos(b) * np.sin(half_sum), np.sin(a) * np.cos(half_difference)
        return np.sin(b) * np.cos(half_sum), np.cos(a) * np.sin(half_difference)

    def sides(self, second: Array) -> tuple[Array, Array]:
        """Both sides of the equation, multiplied by all denominators."""
        first, gamma, delta = self.first, second[2], second[3]
        numerator, denominator = self.ratio(second)
        if self.other_fraction:
            return (
                numerator * np.cos(gamma) * np.sin(first.gamma + first.delta),
                denominator * np.cos(first.delta) * np.sin(gamma + delta),
            )
        return (
            numerator * np.cos(first.delta) * np.sin(delta - gamma),
            denominator * np.cos(gamma) * np.sin(first.gamma - first.delta),
        )

    def residual(self, x: Array) -> Array:
        """Zero where x solves (4)."""
        left, right = self.sides(self.second(np.asarray(x)))
        return np.asarray(left - right)

    def noise(self, second: Array) -> Array:
        """What rounding may leave of the residual where it is zero."""
        numerator, denominator = self.ratio(second)
        size = np.abs(numerator) * (np.abs(second[2]) + np.abs(second[3]))
        size += np.abs(denominator) * (abs(self.first.gamma) + abs(self.first.delta))
        return np.asarray(1e-14 * size)

    def is_solved_by(self, second: Sectors) -> bool:
        """Whether given sectors satisfy the last line of (4)."""
        left, right = self.sides(second.deviations)
        allowed = SOLVED * (abs(left) + abs(right)) + 1e3 * self.noise(second.deviations)
        return bool(abs(left - right) <= allowed)

    def solution(self, x: float) -> Solution:
        """The solution at a root."""
        second = self.second(np.asarray(x))
        numerator, denominator = self.ratio(second)
        c = float(numerator / denominator) if denominator != 0.0 else np.inf
        return Solution(self.version, self.first, Sectors.of(second), c)


def _roots(equation: _Equation, x: Array) -> list[float]:
    """Roots: changes of sign between points of the scan, and where the residual touches zero."""
    residual = equation.residual(x)
    # Where both sides are zero throughout, 0/0, the other fraction decides.
    residual = np.where(np.abs(residual) > equation.noise(equation.second(x)), residual, 0.0)
    size = np.abs(residual)
    crossing = np.flatnonzero(residual[:-1] * residual[1:] < 0)
    roots = [_polished(equation, x[k], x[k + 1]) for k in crossing]
    before, at, after = residual[:-2], residual[1:-1], residual[2:]
    roots += x[1:-1][(at == 0) & (before != 0) & (after != 0)].tolist()
    least, most = np.minimum(size[:-2], size[2:]), np.maximum(size[:-2], size[2:])
    dip = (size[1:-1] > 0) & (size[1:-1] <= least) & (size[1:-1] < most / 2)
    for k in np.flatnonzero(dip & (before * after > 0)) + 1:
        roots += _touching(equation, x[k - 1], x[k + 1], float(np.sign(residual[k])))
    return roots


def _polished(equation: _Equation, low: float, high: float) -> float:
    from scipy.optimize import brentq

    def residual(x: float) -> float:
        return float(equation.residual(np.asarray(x)))

    if residual(low) * residual(high) > 0:
        return low  # the sign changed by rounding, so the root is here
    root: float = brentq(residual, low, high, xtol=1e-25, rtol=1e-15)
    return root


def _touching(equation: _Equation, low: float, high: float, sign: float) -> list[float]:
    """A double root between low and high, or two that no point of the scan separates."""
    from scipy.optimize import minimize_scalar

    def size(x: float) -> float:
        return sign * float(equation.residual(np.asarray(x)))

    tolerance = 1e-10 * (high - low)
    least = minimize_scalar(
        size, bounds=(low, high), method="bounded", options={"xatol": tolerance}
    )
    if least.fun < 0 < min(size(low), size(high)):
        return [_polished(equation, low, least.x), _polished(equation, least.x, high)]
    touches = least.fun <= 1e-7 * min(size(low), size(high))
    return [float(least.x)] if touches else []
