"""No solution of equation (4) is missed and none invented: against roots of a polynomial.

An oracle of its own: (4) as printed is eliminated to a polynomial in x = cot delta_2, all roots of
which are found in 80 digits; those that satisfy (4) as printed, its sign k included, and lie in
(0, pi) are the solutions.
"""

from collections.abc import Sequence

import mpmath
import numpy as np
from mpmath import mp, mpf

from orishell.families.longitudinal_linear_repeating import Sectors, find_solutions
from samples import THOROUGH

DIGITS = 80
SOLVED, REAL, SAME = mpf("1e-30"), mpf("1e-25"), mpf("1e-20")
"""Residuals of (4), imaginary parts of real roots, and distances of equal angles, are below."""
PRECISE = 1e-13
"""Our angles are right to this (radians), however near two solutions are."""

Angles = list[mpf]


def product(p: Sequence[mpf], q: Sequence[mpf]) -> list[mpf]:
    out = [mpf(0)] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            out[i + j] += a * b
    return out


def eliminated(first: Angles, version: str) -> list[mpf]:
    """Coefficients of the polynomial in x = cot delta_2, the highest first: a cubic.

    With y = cot gamma_2 the third line of (4), squared, is
    sin(g1)^2 (1 + x^2) = sin(d1)^2 (1 + y^2), and the last one, squared,
    c^2 (y - x) sin(g1 + d1) = (x + y) sin(g1 - d1), in which c^2 (1 + x^2) is a quadratic in x.
    """
    a1, b1, g1, d1 = first
    lead = g1 - (a1 + b1) / 2  # (alpha_2 + beta_2)/2 = lead + delta_2
    if version == "cosine":
        factor = mp.cos((a1 - b1) / 2) / (mp.cos((a1 + b1) / 2) * mp.cos((b1 - a1) / 2))
        linear = [mp.cos(lead), -mp.sin(lead)]
    else:
        factor = mp.sin((a1 - b1) / 2) / (mp.sin((a1 + b1) / 2) * mp.sin((b1 - a1) / 2))
        linear = [mp.sin(lead), mp.cos(lead)]
    left = [factor**2 * mp.sin(g1 + d1) * each for each in product(linear, linear)]
    right = [mp.sin(g1 - d1) * each for each in (1, 0, 1)]
    # y (left - right) = x (left + right)
    below = [one - other for one, other in zip(left, right, strict=True)]
    above = [*(one + other for one, other in zip(left, right, strict=True)), mpf(0)]
    whole = [mp.sin(g1) ** 2 * each for each in product([1, 0, 1], product(below, below))]
    for part in (product(below, below), product(above, above)):
        for place, each in enumerate(reversed(part)):
            whole[-1 - place] -= mp.sin(d1) ** 2 * each
    without = divided(whole, [mpf(1), mpf(0), mpf(1)])  # 1 + x^2 has no real root
    return divided(without, [mpf(1), mp.cot(g1)])  # the degenerate solution, once


def divided(p: list[mpf], q: list[mpf]) -> list[mpf]:
    """The quotient of polynomials that divide without a remainder."""
    rest, quotient = list(p), []
    while len(rest) >= len(q):
        share = rest[0] / q[0]
        quotient.append(share)
        rest = [each - share * (q[k] if k < len(q) else 0) for k, each in enumerate(rest)][1:]
    assert max(abs(each) for each in rest) < SOLVED * max(abs(each) for each in p)
    return quotient


def solves(first: Angles, second: Angles, version: str) -> bool:
    """Equation (4) as printed, all four lines."""
    (a1, b1, g1, d1), (a2, b2, g2, d2) = first, second
    part = mp.cos if version == "cosine" else mp.sin
    c = part((a1 - b1) / 2) * part((b2 + a2) / 2) / (part((a1 + b1) / 2) * part((b2 - a2) / 2))
    k = mp.sign((g1 + d1 - mp.pi) * (g2 + d2 - mp.pi))
    square = mp.sin(d2 + g2) * mp.sin(g1 - d1) / (mp.sin(d2 - g2) * mp.sin(g1 + d1))
    lines = (
        b1 + a2 - g1 - d2,
        a1 + b2 - g1 - d2,
        mp.sin(g1) * mp.sin(g2) - mp.sin(d1) * mp.sin(d2),
        (c - k * mp.sqrt(square)) / (1 + abs(c)),
    )
    return bool(max(abs(line) for line in lines) < SOLVED)


def all_solutions(degrees: Sequence[float]) -> list[tuple[str, Angles]]:
    """Every solution but the degenerate one, by its version."""
    first = [mpf(angle) * mp.pi / 180 for angle in degrees]
    a1, b1, g1, d1 = first
    found = []
    for version in ("cosine", "sine"):
        falling = eliminated(first, version)
        for root in mpmath.polyroots(falling, maxsteps=500, extraprec=200):
            if abs(mp.im(root)) > REAL * (1 + abs(root)):
                continue
            d2 = mp.atan2(1, mp.re(root))
            sine = mp.asin(mp.sin(d1) * mp.sin(d2) / mp.sin(g1))
            for g2 in {mp.re(sine), mp.pi - mp.re(sine)} if not mp.im(sine) else ():
                second = [g1 + d2 - b1, g1 + d2 - a1, g2, d2]
                degenerate = max(abs(d2 - mp.pi + g1), abs(g2 - mp.pi + d1)) < SAME
                inside = all(0 < angle < mp.pi for angle in second)
                if inside and not degenerate and solves(first, second, version):
                    found.append((version, second))
    return found


def quadruples() -> list[list[float]]:
    """A third anywhere, a third about 90, a third within half a degree of it (degrees)."""
    random = np.random.default_rng(12)
    wide, near, nearest = (
        random.uniform(90 - half, 90 + half, (count, 4))
        for half, count in ((88.0, 333), (15.0, 333), (0.5, 333))
    )
    issue = [90.17410500485727, 90.02745501098471, 90.20103130644854, 89.15155130794687]
    return [issue, *np.concatenate([wide, near, nearest]).tolist()]


def hairs() -> list[list[float]]:
    """Beside the degenerate solution, beside vertices that cross, beside a second column that
    would not fold, beside one that lies along the row: each by less and less."""
    made = []
    for away in 10.0 ** np.arange(-2, -11, -1 if THOROUGH else -2):
        alpha, beta, gamma, delta = 84.0, 79.0, 97.0, 103.0
        made += [
            [alpha, beta, gamma, (alpha + beta) / 2 + away],
            [alpha, beta, delta + away, delta],
            [alpha, beta, 180 - delta + away, delta],
            [alpha, alpha + away, gamma, delta],
            [alpha, 180 - alpha + away, gamma, delta],
            [alpha, beta, alpha + beta - delta + away, delta],
        ]
    return made


def require_complete(degrees: list[float]) -> int:
    with mp.workdps(DIGITS):
        expected = all_solutions(degrees)
        found = find_solutions(Sectors.from_degrees(degrees))
        assert [each.version for each in found] == [version for version, _ in expected], degrees
        for each, (_, second) in zip(found, expected, strict=True):
            deviations = np.array([float(angle - mp.pi / 2) for angle in second])
            np.testing.assert_allclose(each.second.deviations, deviations, rtol=0, atol=PRECISE)
    return len(expected)


def test_no_solution_is_missed_and_none_invented() -> None:
    asked = quadruples()
    assert len(asked) == 1000
    counts = [require_complete(degrees) for degrees in asked[:: 1 if THOROUGH else 8]]
    assert np.bincount(counts).min() > 0.02 * len(counts)  # with none, with one and with two


def test_a_hair_from_the_degenerate() -> None:
    for degrees in hairs():
        require_complete(degrees)
