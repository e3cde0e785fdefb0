"""Own weight: an A of two boards by hand, finite differences of random shells, three references."""

import tomllib
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any, cast

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from orishell.deployment import OwnWeight, measure_weight
from orishell.deployment.feet import find_feet
from orishell.deployment.weight import Body
from orishell.design import Design
from orishell.design_file import read_design_file
from orishell.design_file.file import check_design
from orishell.families.orthodiagonal import OrthodiagonalPattern, design_orthodiagonal
from orishell.families.parallel_repeating import (
    ParallelRepeating,
    ParallelRepeatingPattern,
    design_parallel_repeating,
)
from orishell.motion import Mechanism
from orishell.motion.grid import Grid
from samples import examples
from strategies import Request, graph, orthodiagonal_requests, requests

EXAMPLES = Path(__file__).parents[2] / "examples"
SHELTER = EXAMPLES / "shelter.toml"
PARABOLA = graph("-x**2", -1, 1)
STRAIGHT = graph("0*x", 0, 2)
G = 9.81


@dataclass(eq=False)
class Boards:
    """Two boards of 1 x 3 hinged at the top: the drive is the angle by which they are folded."""

    target_drive: float
    tilt: float = 0.0
    end_drive: float = np.pi
    grid = Grid(3, 2)
    inner_columns = slice(0, 2)
    flap_columns = ()

    def positions(self, drive: Any) -> np.ndarray:
        drive = np.asarray(drive, dtype=np.float64)[..., None, None]
        x = np.array([[1.0], [0], [-1]]) * np.cos(drive / 2)
        z = np.array([[0.0], [1], [0]]) * np.sin(drive / 2)
        turn = self.tilt * drive * (drive - self.target_drive)  # not at the target
        x, z = x * np.cos(turn) - z * np.sin(turn), x * np.sin(turn) + z * np.cos(turn)
        y = np.broadcast_to([3.0, 0.0], (*x.shape[:-1], 2))
        return np.stack(np.broadcast_arrays(-x, -y, z), axis=-1)


def weigh(design: Design) -> OwnWeight:
    feet = find_feet(design)
    assert feet is not None
    return measure_weight(design.mechanism, feet.rows, G * 2.0)


@pytest.mark.parametrize("tilt", [0.0, 0.3])
def test_two_boards(tilt: float) -> None:
    """V = W sin(d/2)/2 and L = 2 cos(d/2): the thrust of an A is W/4 cot(d/2)."""
    found = measure_weight(cast(Mechanism, Boards(2.0, tilt)), (0, 2), 5.0)
    assert found.total == pytest.approx(30.0, rel=1e-14)
    drives = np.array(found.drives)
    np.testing.assert_allclose(found.energy, 15 * np.sin(drives / 2), atol=1e-13)
    np.testing.assert_allclose(found.span, 2 * np.cos(drives / 2), atol=1e-13)
    assert found.forces[0] is None
    expected = 7.5 / np.tan(drives[1:] / 2)
    np.testing.assert_allclose(
        np.array(found.forces[1:], np.float64), expected, rtol=1e-8, atol=1e-8
    )
    assert found.at_feet == pytest.approx(7.5 / np.tan(1.0), rel=1e-9)
    assert found.tipping == ()
    assert found.largest_from_pack == pytest.approx(found.at_feet)
    assert found.raise_from_flat == pytest.approx(15 * np.sin(1.0), rel=1e-12)
    assert found.raise_from_pack == 0.0  # it is pulled apart, and sinks


def energy_and_span(mechanism: Mechanism, drive: float) -> tuple[float, float]:
    """For a weight of 1 per area, feet in the first and last row; panels one by one.

    The line of the feet is turned to its slope at the target.
    """

    def inclination(inner: np.ndarray) -> float:
        x, y, z = (inner[-1] - inner[0]).mean(axis=0)
        return float(np.arctan2(z, np.hypot(x, y)))

    positions = mechanism.positions(drive)
    inner = positions[:, mechanism.inner_columns]
    target = mechanism.positions(mechanism.target_drive)[:, mechanism.inner_columns]
    turn = inclination(target) - inclination(inner)
    x, y, _ = (inner[-1] - inner[0]).mean(axis=0)
    up = np.array([*np.sin(turn) * np.array([x, y]) / np.hypot(x, y), np.cos(turn)])
    points = positions.reshape(-1, 3) - inner[[0, -1]].mean(axis=(0, 1))
    p, q, r, s = (points[mechanism.grid.faces_vertices()[:, k]] for k in range(4))
    energy = 0.0
    for a, b, c in ((p, q, s), (q, r, s)):  # the other diagonal
        area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=-1)
        energy += float(area @ ((a + b + c) / 3) @ up)
    return energy, float(np.linalg.norm(inner[-1] - inner[0], axis=-1).mean())


@settings(max_examples=examples(50))
@given(st.one_of(requests(), orthodiagonal_requests()), st.floats(0.2, 0.95))
def test_thrust_is_the_slope_of_energies(request: Request, share: float) -> None:
    mechanism = request.feasible().mechanism
    found = measure_weight(mechanism, (0, mechanism.grid.rows - 1), 1.0, states=21)
    k = round(share * (len(found.drives) - 1))
    drive, step = found.drives[k], 1e-4
    states = [energy_and_span(mechanism, drive + sign * step) for sign in (-1, 0, 1)]
    (before, shorter), (energy, span), (after, longer) = states
    assert found.energy[k] == pytest.approx(energy, abs=1e-10 * found.total * span)
    assert found.span[k] == pytest.approx(span, rel=1e-12)
    assume(abs(longer - shorter) > 1e-8 * span)
    expected = -(after - before) / (longer - shorter)
    assert found.forces[k] == pytest.approx(expected, rel=1e-4, abs=1e-4 * found.total)


@pytest.mark.parametrize("bare", [False, True])
@pytest.mark.parametrize("name", ["figure1", "figure2", "canopy", "tunnel", "from_svg"])
def test_thrust_at_the_target_to_eight_digits(name: str, bare: bool) -> None:
    """Against extrapolated differences: to either side, backwards near the end.

    Where the zigzag of a column nearly closes, see the next test: these differences are too wide.
    """
    file = read_design_file(EXAMPLES / f"{name}.toml")
    mechanism = file.pattern.design(file.f, file.g).mechanism
    mechanism = mechanism.without_flaps() if bare else mechanism
    target, rows = mechanism.target_drive, (0, mechanism.grid.rows - 1)
    found = measure_weight(mechanism, rows, 1.0, states=2)
    inside = mechanism.end_drive - target > 0.1
    table = []
    for step in 0.1 / 2.0 ** np.arange(7):
        pair = (target - step, target + step * inside)
        (high, longer), (low, shorter) = (energy_and_span(mechanism, each) for each in pair)
        table.append((low - high) / (longer - shorter))
    for k in range(1, 7):
        order = 4**k if inside else 2**k
        table = [(order * fine - coarse) / (order - 1) for coarse, fine in pairwise(table)]
    # Backwards, differences of nearly stationary energies lose more digits.
    scale = max(abs(found.at_feet), found.total)
    assert abs(found.at_feet - table[0]) < (1e-8 if inside else 4e-8) * scale


def test_columns_whose_zigzags_nearly_close() -> None:
    """The second column is a zigzag of 2.5 degrees, so that the span changes within a degree.

    References from the closed form in 60 digits (mpmath): -d2V/dq2 / d2L/dq2 at q = cos(rho/2) = 0,
    and -dV/dL at a drive beside it.
    """
    axes = np.exp(-1j * np.array([0.003, 0.14]))
    sheet = ParallelRepeating(
        np.pi / 2, np.full(2, 0.5), 1, np.array([0, 50 + 0j]), axes, (0.8, 0.6), ("start", "start")
    )
    body = Body.of(sheet, (0, 2), 1.0)
    total = measure_weight(sheet, (0, 2), 1.0, states=2).total
    at_end, before = body.thrusts(np.array([np.pi, 3.1]))
    assert at_end == pytest.approx(0.3824673787767197, abs=1e-7 * total)
    assert before == pytest.approx(0.5278814090969229, abs=1e-8 * total)


def test_a_parabola_is_opened_by_its_weight() -> None:
    """References found on their own: -dV/dL = 20.9 of 121.7 N, and 15.0 of 175.5 N."""
    size: dict[str, Any] = {"rows": 9, "columns": 9, "flap": 0.0}
    orthodiagonal = weigh(
        design_orthodiagonal(PARABOLA, STRAIGHT, OrthodiagonalPattern(depth=0.05, **size))
    )
    assert orthodiagonal.total == pytest.approx(121.7, abs=0.05)
    assert orthodiagonal.at_feet == pytest.approx(20.9, abs=0.05)
    parallel = weigh(
        design_parallel_repeating(PARABOLA, STRAIGHT, ParallelRepeatingPattern(**size))
    )
    assert parallel.total == pytest.approx(175.5, abs=0.05)
    assert parallel.at_feet == pytest.approx(15.0, abs=0.05)


def test_the_shelter_is_closed_by_its_weight() -> None:
    """Half an ellipse with steep sides: 31.1 of 812 N; it falls over at some 130 degrees."""
    table = tomllib.loads(SHELTER.read_text(encoding="utf-8"))
    table["pattern"]["flap"] = 0
    file = check_design(table, SHELTER)
    design = file.pattern.design(file.f, file.g)
    feet = find_feet(design)
    assert feet is not None
    found = measure_weight(design.mechanism, feet.rows, 1.9 * G)
    assert found.total == pytest.approx(812, abs=1)
    assert found.at_feet == pytest.approx(-31.25, abs=0.05)
    (tipping,) = found.tipping
    assert tipping < design.mechanism.target_drive
    assert found.raise_from_flat > found.energy[found.drives.index(design.mechanism.target_drive)]
    assert found.largest_from_pack > 800
