"""Why CalculiX' buckling factors are not asked of decks with springs: it counts these twice.

A strut that is clamped at one end and rests on a spring at the other, against its closed form. An
independent check once had a factor of 0.94 of a shelter with 6 cells, about a vertex where a tie
and a flap act as springs, where there are 2.9 with equations in their place.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import brentq

from calculix_tool import run_calculix

LENGTH, WIDTH, THICKNESS, MODULUS = 1.0, 0.1, 0.01, 1e10
BENDING = MODULUS * WIDTH * THICKNESS**3 / 12
ALONG, ACROSS = 10, 2


def closed_form(stiffness: float) -> float:
    """The load that buckles the strut: tan s = s - s^3 EI/(k L^3) with s^2 = P L^2/EI."""
    share = stiffness * LENGTH**3 / BENDING

    def missing(s: float) -> float:
        return float(np.sin(s) - (s - s**3 / share) * np.cos(s))

    at = np.linspace(0.5, 5.0, 2000)
    values = [missing(each) for each in at]
    first = next(k for k in range(len(at)) if values[k] * values[k + 1] < 0)
    return float(brentq(missing, at[first], at[first + 1])) ** 2 * BENDING / LENGTH**2


def strut(stiffness: float) -> str:
    """The deck of a strut under 100 N, its end on a spring (force per length)."""
    xs, ys = np.linspace(0, LENGTH, 2 * ALONG + 1), np.linspace(0, WIDTH, 2 * ACROSS + 1)
    at = [(i, j) for i in range(len(xs)) for j in range(len(ys)) if not i % 2 * (j % 2)]
    number = {place: k for k, place in enumerate(at, 1)}
    ground, end = len(at) + 1, number[2 * ALONG, ACROSS]
    lines = ["*NODE,NSET=ALL", *(f"{number[i, j]},{xs[i]},{ys[j]},0." for i, j in at)]
    lines += [f"{ground},{LENGTH},{WIDTH / 2},1.", "*ELEMENT,TYPE=S8R,ELSET=PLATE"]
    sides = [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)]
    for i in range(ALONG):
        for j in range(ACROSS):
            around = [str(number[2 * i + x, 2 * j + y]) for x, y in sides]
            lines.append(",".join([str(i * ACROSS + j + 1), *around]))
    lines += ["*MATERIAL,NAME=M", "*ELASTIC", f"{MODULUS},0."]
    lines += ["*SHELL SECTION,ELSET=PLATE,MATERIAL=M", f"{THICKNESS}"]
    lines += ["*ELEMENT,TYPE=SPRINGA,ELSET=SPRING", f"{ALONG * ACROSS + 1},{end},{ground}"]
    lines += ["*SPRING,ELSET=SPRING", "", f"{stiffness:.9e}", "*BOUNDARY", f"{ground},1,3"]
    lines += [f"{number[0, j]},1,6" for j in range(len(ys))]
    lines += ["*STEP", "*BUCKLE", "3,1e-4,40,1000", "*CLOAD"]
    shares = np.zeros(len(ys))
    for j in range(ACROSS):
        shares[2 * j : 2 * j + 3] += np.array([1, 4, 1]) / (6 * ACROSS)
    lines += [f"{number[2 * ALONG, j]},1,{-100 * share}" for j, share in enumerate(shares)]
    return "\n".join([*lines, "*END STEP", ""])


@pytest.mark.parametrize("share", [3.0, 100.0])
def test_buckling_counts_springs_twice(tmp_path: Path, share: float) -> None:
    """It finds the load of a strut on a spring twice as stiff, within 1e-3.

    405 N are right where k L^3/EI is 3, and it finds 595.
    """
    stiffness = share * BENDING / LENGTH**3
    (tmp_path / "strut.inp").write_text(strut(stiffness))
    factor = run_calculix(tmp_path / "strut.inp").buckling[0]
    assert 100 * factor == pytest.approx(closed_form(2 * stiffness), rel=1e-3)
    assert 100 * factor > 1.01 * closed_form(stiffness)
