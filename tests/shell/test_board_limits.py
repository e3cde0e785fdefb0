"""Shells whose boards cover enough of their panels, and whose chamfers a saw can make."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest

from design_tables import Tables, formula
from orishell.conventions.errors import DesignError, InputError
from orishell.design_file import DesignFile, check_design
from orishell.families.tolerance import Tolerance
from orishell.shell.board_limits import require_boards
from orishell.shell.make import Shell, make_shell
from orishell.shell.steps import Step
from samples import led_by, thorough

SKIPPED: tuple[Step, ...] = ("verification", "pack", "weight", "deviation", "structure")
SANDWICH: Tables = {"thickness": 0.03, "membrane": 0.001}
BEVEL: Tables = {"construction": "bevel", "thickness": 0.02, "gap": 0.002}
HINGED: Tables = {"construction": "hinged", "thickness": 0.006, "gap": 0.004}


def arch(panel: Tables, limits: Tables, **others: Tables) -> DesignFile:
    """An arch of 4 m whose panels are of some construction, if any, with limits of boards."""
    pattern: Tables = {"flap": 0}
    if panel is HINGED:
        pattern |= {"plane": "bisector"}
        others = {"deployment": {"from": "pack"}, **others}
    tables: Tables = {
        "shell": {"family": "parallel-repeating", "unit": "m"},
        "target": {
            "f": formula("-0.8*x**2", -1, 1),
            "g": formula("0.4*sin(pi*x/2)", 0, 4),
        },
        "pattern": pattern,
        "tolerance": {"surface": 0.2, **limits},
        "motion": {"frames": 3},
        "panel": panel,
        **others,
    }
    return check_design(tables, Path("shell.toml"))


def require_met(shell: Shell) -> None:
    """The limits hold of the report, which has boards as they are built in the end."""
    assert shell.report.chosen is not None
    limits, panel = shell.report.chosen.limits, shell.report.panel
    assert panel is not None
    assert panel.least_share >= limits.least_share
    if limits.steepest_chamfer_deg is not None:
        assert panel.steepest_chamfer is not None
        assert np.rad2deg(panel.steepest_chamfer) <= limits.steepest_chamfer_deg


def made(panel: Tables, limits: Tables) -> Shell:
    return make_shell(arch(panel, limits), clash="unexamined", skip=SKIPPED)


MET: list[tuple[Tables, Tables]] = [
    (SANDWICH, {"surface": 0.7, "least_share": 0.9}),
    (BEVEL, {"surface": 0.72, "steepest_chamfer_deg": 58.0}),
    (HINGED, {"surface": 0.5, "least_share": 0.98}),
    (BEVEL, {"surface": 0.3, "least_share": 0.9, "steepest_chamfer_deg": 57.0}),
    (SANDWICH, {"surface": 0.6, "panel_max": 0.7, "least_share": 0.85}),
]


@pytest.mark.parametrize(("panel", "limits"), led_by(MET, 2))
def test_a_shell_is_found_whose_boards_are_as_asked(panel: Tables, limits: Tables) -> None:
    require_met(made(panel, limits))


def test_without_limits_boards_are_worse() -> None:
    """So that the limits of the first two above are not idle."""
    share, chamfer = (free(number).report.panel for number in range(2))
    assert share is not None
    assert chamfer is not None
    assert share.least_share < 0.9
    assert chamfer.steepest_chamfer is not None
    assert np.rad2deg(chamfer.steepest_chamfer) > 58


FREE: list[tuple[Tables, Tables]] = [(SANDWICH, {"surface": 0.7}), (BEVEL, {"surface": 0.72})]


@cache
def free(number: int) -> Shell:
    return made(*FREE[number])


@pytest.mark.slow
@pytest.mark.parametrize(
    ("panel", "limits"),
    led_by(
        [
            (SANDWICH, {"least_share": 0.97, "surface": 0.7}),
            (BEVEL, {"steepest_chamfer_deg": 45.0}),
        ],
        1,
    ),
)
def test_what_is_offered_works(panel: Tables, limits: Tables) -> None:
    """The message has the value that was found; typed in, the whole shell is made and proved."""
    pattern: Tables = {"flap": 0, "xi_deg": 60, "spacing": "equal", "placement": "balanced"}
    file = arch(panel, limits, pattern=pattern).changed({"target.g.range": [0, 2]})
    with pytest.raises(DesignError, match="Nearest found that works") as refused:
        make_shell(file, skip=SKIPPED)
    offered = refused.value.remedies[0]
    ((key, value),) = offered.changes.items()
    assert key == f"tolerance.{next(iter(limits))}"
    assert f"{value:g}" in refused.value.size
    shell = make_shell(file.changed(offered.changes), skip=SKIPPED)
    require_met(shell)


def test_a_proved_shell_is_looked_at_again() -> None:
    """Boards that are cut back after the choice are not what was asked for."""
    shell = free(0)
    assert shell.report.panel is not None
    share = shell.report.panel.least_share
    require_boards(Tolerance(surface=1.0, least_share=share), shell.design, shell.lock)
    more = Tolerance(surface=1.0, least_share=1.001 * share)
    with pytest.raises(DesignError, match="once its motion was proved") as refused:
        require_boards(more, shell.design, shell.lock)
    (offer,) = refused.value.candidates
    assert offer.changes["tolerance.least_share"] == pytest.approx(share, rel=1e-3)


@thorough
@pytest.mark.parametrize("number", range(12))
def test_random_arches_are_as_asked_or_the_offer_works(number: int) -> None:
    """Curves, thicknesses and limits are drawn; an offer that was found is typed in."""
    random = np.random.default_rng(number)
    panel = dict([SANDWICH, BEVEL][number % 2])
    panel["thickness"] = float(f"{random.uniform(0.01, 0.05):.3g}")
    limits: Tables = {
        "surface": float(f"{random.uniform(0.1, 0.3):.3g}"),
        "least_share": float(f"{random.uniform(0.5, 0.95):.3g}"),
    }
    if number % 2:
        limits["steepest_chamfer_deg"] = float(f"{random.uniform(45, 60):.3g}")
    start: Tables = {"from": "pack" if number % 3 else "flat"}
    file = arch(panel, limits, deployment=start)
    try:
        require_met(make_shell(file, skip=SKIPPED))
    except DesignError as refused:
        for offered in refused.remedies:
            require_met(make_shell(file.changed(offered.changes), skip=SKIPPED))


BAD: list[tuple[Tables, Tables, str]] = [
    ({}, {"least_share": 0.5}, r"\[tolerance\] least_share: panels without a thickness"),
    (SANDWICH, {"steepest_chamfer_deg": 45}, r"steepest_chamfer_deg: there are no chamfers"),
    (HINGED, {"steepest_chamfer_deg": 45}, 'expected .* construction = "bevel"'),
    (SANDWICH, {"least_share": 1}, "least_share: .*less than 1"),
    (SANDWICH, {"least_share": -0.1}, "least_share: .*at least 0"),
    (BEVEL, {"steepest_chamfer_deg": 0}, "steepest_chamfer_deg: .*greater than 0"),
    (BEVEL, {"steepest_chamfer_deg": 90}, "steepest_chamfer_deg: .*less than 90"),
]


@pytest.mark.parametrize(("panel", "limits", "says"), BAD)
def test_limits_that_do_not_go_with_the_panels(panel: Tables, limits: Tables, says: str) -> None:
    with pytest.raises(InputError, match=says):
        arch(panel, limits)
