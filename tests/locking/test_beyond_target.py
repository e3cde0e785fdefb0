"""How the motion of shells without flaps ends beyond the target, against brute force.

Brute force looks at single states with `find_contacts`, which knows nothing of paths. Panels with a
common vertex are left out: their creases fold as the closed form says (tests/motion).
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from orishell import (
    Design,
    DesignError,
    OrthodiagonalPattern,
    ParallelRepeatingPattern,
    design_orthodiagonal,
    design_parallel_repeating,
)
from orishell.clash import find_contacts
from orishell.clash.ranges import TICKS
from orishell.locking import Lock, find_lock
from orishell.motion import Mechanism, diagonal
from orishell.motion.sizes import CONTACT_TOLERANCE
from samples import THOROUGH, led_by
from strategies import graph, pair

SEEDS = 100 if THOROUGH else 6
STATES = 60 if THOROUGH else 20
ROUNDING = 1e-12
"""A tolerance of brute force that only rounding fills, relative to the diagonal."""


def contacts(mechanism: Mechanism, drive: float, tolerance: float) -> int:
    """Number of pairs of panels without a common vertex that touch in a state."""
    faces = mechanism.grid.faces_vertices()
    size = tolerance * diagonal(mechanism.positions(0.0))
    pairs = find_contacts(mechanism.positions(drive).reshape(-1, 3), faces, size)
    shared = (faces[pairs[:, 0]][:, :, None] == faces[pairs[:, 1]][:, None]).any(axis=(1, 2))
    return int((~shared).sum())


def wave(random: np.random.Generator, length: float) -> str:
    """An S, or a sum of two waves."""
    high, low = random.uniform(0.02, 0.25, 2) * length / np.pi
    periods = random.uniform(0.5, 2.0)
    text = f"{high}*sin({2 * np.pi / length}*x)"
    return text if random.random() < 0.5 else f"{text} + {low}*cos({np.pi * periods / length}*x)"


def parallel_repeating(random: np.random.Generator) -> Design:
    f = graph(f"-{random.uniform(0.3, 1.2)}*x**2", -1, random.uniform(0.6, 1))
    length = random.uniform(4, 20)
    return design_parallel_repeating(
        f,
        graph(wave(random, length), 0, length),
        ParallelRepeatingPattern(
            rows=int(random.choice([3, 5, 7, 9])),
            columns=int(random.integers(3, 14)),
            xi_deg=random.uniform(30, 80),
            flap=0,
        ),
    )


def orthodiagonal(random: np.random.Generator) -> Design:
    # Arcs of up to most of a circle, which curl up while the zigzags of the columns close.
    f = pair("cos(t)", f"{random.uniform(0.6, 1.5)}*sin(t)", 0, random.uniform(1, 4.5))
    length = random.uniform(1, 4)
    return design_orthodiagonal(
        f,
        graph(wave(random, 0.6 * length), 0, length),
        OrthodiagonalPattern(
            rows=int(random.choice([3, 5, 7, 9])), columns=int(random.integers(3, 14)), flap=0
        ),
    )


def designs(make: Callable[[np.random.Generator], Design]) -> list[Design]:
    """Designs of seeded random numbers, those that are refused left out."""
    made: list[Design] = []
    random = np.random.default_rng(5)
    while len(made) < SEEDS:
        try:
            made.append(make(random))
        except DesignError:
            continue
    return made


def require_neither_early_nor_late(design: Design) -> Lock:
    mechanism, lock = design.mechanism, find_lock(design)
    if lock.cause == "crease":
        assert lock.drive == mechanism.end_drive
        # Where creases are folded flat at the end, the last thousandth is proved for a narrower
        # tolerance; brute force sees what crosses.
        for drive in np.linspace(0, mechanism.end_drive * (1 - 1e-5), STATES):
            assert contacts(mechanism, drive, ROUNDING) == 0
        return lock
    assert lock.cause == "clash"
    assert lock.drive is not None
    assert lock.first_contact is not None
    assert lock.first_contact.clear_until <= lock.drive
    step = mechanism.end_drive / TICKS
    assert lock.drive - lock.first_contact.clear_until <= step * (1 + 1e-3)
    for drive in np.linspace(0, lock.drive * (1 - 1e-6), STATES):
        assert contacts(mechanism, drive, CONTACT_TOLERANCE) == 0
    # They touch there, or as good as: fast ones cross the tolerance within a few smallest steps.
    near = (lock.drive, lock.drive * (1 + 1e-8))
    assert any(contacts(mechanism, drive, CONTACT_TOLERANCE * (1 + 1e-3)) for drive in near)
    return lock


@pytest.mark.slow
@pytest.mark.parametrize(
    ("make", "causes"),
    led_by([(parallel_repeating, {"clash", "crease"}), (orthodiagonal, {"crease"})]),
)
def test_the_end_found_is_neither_early_nor_late(
    make: Callable[[np.random.Generator], Design], causes: set[str]
) -> None:
    # An orthodiagonal shell's columns stay in parallel planes in their order, so that only panels
    # of one column could meet; the arcs of these do not curl up so far.
    locks = [require_neither_early_nor_late(design) for design in designs(make)]
    assert {lock.cause for lock in locks} == causes
    assert all(lock.drive is not None and lock.drive > lock.target_drive for lock in locks)


@pytest.mark.parametrize("depth", [0.4, 0.2])
def test_an_orthodiagonal_shell_that_curls_up(depth: float) -> None:
    f, g = pair("cos(t)", "sin(t)", 0, 5.6), graph("0.1*sin(2*x)", 0, 3)
    rows = {0.4: 15, 0.2: 25}[depth]
    design = design_orthodiagonal(
        f, g, OrthodiagonalPattern(rows=rows, columns=5, depth=depth, flap=0)
    )
    lock = require_neither_early_nor_late(design)
    # Before its target: its rims pass each other while it is folded up from the flat sheet.
    assert lock.cause == "clash"
    assert lock.early


def test_figure_1_without_flaps_meets_itself_beyond_its_target() -> None:
    # The paper's curves; an S, whose bends sharpen while it closes.
    design = design_parallel_repeating(
        graph("-x**2", -1, 1),
        graph("5*sin(pi*x/10)", 0, 20),
        ParallelRepeatingPattern(rows=9, columns=11, xi_deg=50, flap=0),
    )
    lock = require_neither_early_nor_late(design)
    assert lock.cause == "clash"
    assert lock.drive is not None
    assert lock.target_drive < lock.drive < design.mechanism.end_drive
    assert np.rad2deg(lock.drive) == pytest.approx(157, abs=1)
