"""By how much a refusal fails: more the farther from its limit, and nothing near it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from design_tables import Tables, formula, tables
from orishell.conventions.errors import DesignError
from orishell.design import Design
from orishell.design_file import DesignFile, check_design
from orishell.design_file.tables import with_values
from orishell.locking import Lock, require_pack
from orishell.motion import largest_fold
from orishell.shell.candidate import ended
from orishell.shell.designed import designed
from orishell.shell.steps import Work
from samples import led_by, thorough

LONG, ORTHO = "longitudinal-linear-repeating", "orthodiagonal"
FIGURE_1 = tables(
    "parallel-repeating",
    formula("-x**2", -1, 1),
    formula("5*sin(pi*x/10)", 0, 8),
    rows=5,
    columns=5,
    flap=0.3,
    xi_deg=50,
)
BOARDS = FIGURE_1 | {"panel": {"membrane": 0.001, "thickness": 0.02}}
WAVE = tables(
    ORTHO,
    formula("-x**2", -1, 1),
    formula("0.25*sin(pi*x/2)", 0, 4),
    rows=9,
    columns=11,
    flap=0.15,
    depth=0.3,
    heading_deg=100,
)
ARCH = tables(
    LONG,
    formula(["cos(t)", "sin(t)"], 0.3, 2.8416),
    formula("0*x", 0, 2.93),
    rows=7,
    columns=9,
    sector_deg=[85, 80, 95, 100],
)
FREE = {
    "shell": {"family": LONG, "unit": "m"},
    "pattern": {"rows": 7, "columns": 9, "sector_deg": [85, 80, 95, 100]},
}
SOLID = ARCH | {"panel": {"construction": "bevel", "gap": 0.002}}
RING = tables(
    "parallel-repeating",
    formula("-x**2", -1, 1),
    formula(["2.2*cos(t)", "2.2*sin(t)"], 0, 5.5),
    rows=5,
    columns=12,
    flap_side="start",
    xi_deg=50,
)
Ladder = tuple[Tables, str, list[float], float | None, str]
"""A design, a key, values ever farther beyond the limit, one within it, and what is said."""

LADDERS: dict[str, Ladder] = {
    "xi": (FIGURE_1, "pattern.xi_deg", [53.2, 55, 60, 80, 120], 53, "too large for f"),
    "theta": (FIGURE_1, "pattern.theta_deg", [40, 60, 80], None, "no staircase"),
    "rows cross": (FIGURE_1, "target.f.scale", [3, 4, 6, 8], 2, "columns meet inside the sheet"),
    "plane": (FIGURE_1, "pattern.plane_deg", [170, 175, 178], None, "does not cross the chord"),
    "flap": (FIGURE_1, "pattern.flap", [20, 50, 200], None, "too narrow or too wide"),
    "hinges": (FIGURE_1, "deployment.largest_fold_deg", [179, 150, 90, 30], 180, "do not close"),
    "boards": (BOARDS, "panel.thickness", [0.3, 0.4, 0.8], 0.2, "room for"),
    "gap": (BOARDS, "panel.gap", [0.3, 0.6, 1.0], 0.1, "the gap between panels"),
    "stop": (BOARDS, "panel.stop_deg", [26, 30, 40], 24, "so far short of folding flat"),
    "depth": (WAVE, "pattern.depth", [0.51, 0.6, 0.8, 1.2], 0.45, "cusps"),
    "heading": (WAVE, "pattern.heading_deg", [60, 50, 40], None, "rows meet inside the sheet"),
    "crossing": (WAVE, "pattern.heading_deg", [15, 10, 2], None, "does not cross the chord"),
    "wide flap": (WAVE, "pattern.flap", [1.5, 2, 4], 1, "the flaps are too wide"),
    "long g": (ARCH, "target.g.scale", [2, 3, 5], 1.5, "a middle row as long as g"),
    "short g": (ARCH, "target.g.scale", [0.1, 0.03, 0.01], None, "a middle row as long as g"),
    "border": (ARCH, "pattern.flap", [1, 2, 4], 0.5, "the flap panels are not convex"),
    "thick": (SOLID, "panel.thickness", [0.5, 1, 2], 0.01, "more of a panel than set-backs may"),
    "stage": (FREE, "pattern.stage_deg", [150, 170, 179], 100, "beyond the end of the motion"),
    "unfolded": (FREE, "pattern.stage_deg", [1e-7, 1e-8, 1e-9], 1e-5, "creases unfolded"),
}
CLASHES: dict[str, Ladder] = {
    "flaps": (RING, "pattern.flap", [0.9, 1.6, 4], None, "opposite flaps"),
    "depth": (WAVE, "pattern.depth", [0.48, 0.485, 0.49], None, "reaches its target"),
    "stage": (FREE, "pattern.stage_deg", [6.3, 10, 50], 6, "reaches its stage"),
}


def asked(design: Tables, key: str, value: float) -> DesignFile:
    """The design with another value at a key."""
    return check_design(with_values(design, {key: value}), Path("shell.toml"))


def proved(file: DesignFile) -> tuple[Design, Lock]:
    return ended(file, designed(file), Work())


def check(ladder: Ladder, make: Callable[[DesignFile], object], steps: int, nearly: float) -> None:
    design, key, values, good, said = ladder

    def excess(value: float) -> float:
        with pytest.raises(DesignError) as refused:
            make(asked(design, key, value))
        assert said in str(refused.value)
        assert refused.value.excess is not None
        return refused.value.excess

    found = [excess(value) for value in values]
    assert np.isfinite(found).all()
    assert found[0] > 0
    assert (np.diff(found) > 0).all()
    if good is None:
        return
    bad = values[0]
    for _ in range(steps):
        middle = (good * bad) ** 0.5
        try:
            make(asked(design, key, middle))
        except DesignError:
            bad = middle
        else:
            good = middle
    assert 0 <= excess(bad) < nearly


@thorough
@pytest.mark.parametrize("ladder", LADDERS.values(), ids=LADDERS)
def test_more_the_farther_from_the_limit(ladder: Ladder) -> None:
    check(ladder, designed, 16, 2e-3)


@pytest.mark.parametrize("clash", led_by(CLASHES, 2))
def test_more_the_earlier_panels_meet(clash: str) -> None:
    check(CLASHES[clash], proved, 4, 5e-3)


def test_a_shell_that_is_to_be_opened_from_a_pack() -> None:
    """1 where it does not close beyond its target at all; hinges that close so far are enough."""
    pack = WAVE | {"deployment": {"from": "pack"}, "motion": {"frames": 3}}
    mechanism = designed(check_design(pack, Path("shell.toml"))).mechanism
    needed = np.rad2deg(float(largest_fold(mechanism, np.array([mechanism.target_drive]))[0]))

    def close(more: float) -> None:
        require_pack(*proved(asked(pack, "deployment.largest_fold_deg", needed + more)))

    found = []
    for more in (1e-9, 0.005, 0.01, 0.02, 0.0378):
        with pytest.raises(DesignError, match="cannot be opened from a pack") as refused:
            close(more)
        assert refused.value.excess is not None
        found.append(refused.value.excess)
    assert found[0] == pytest.approx(1, abs=1e-4)
    assert (np.diff(found) < 0).all()
    assert found[-1] < 0.01
    close(0.04)
