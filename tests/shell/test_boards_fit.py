"""Panels that fit: of a sheet with stock all parts nest, or a size is offered that is enough."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from command_line import orishell
from design_tables import Tables, formula
from orishell.conventions.errors import DesignError
from orishell.design_file import DesignFile, check_design
from orishell.shell.make import Shell, make_shell
from orishell.shell.steps import Step
from orishell.workshop.fitting import OversizeError
from samples import THOROUGH, led_by

SKIPPED: tuple[Step, ...] = (
    "verification", "pack", "weight", "deviation", "structure", "remedies",
)  # fmt: skip
NUMBERS = range(1, 1000) if THOROUGH else (9, 11, 14, 20)
DRAWN = 30 if THOROUGH else 4
"""Random designs that are made or refused for their stock; four have a kind of panels each."""
SANDWICH = {"thickness": 0.006, "membrane": 0.001, "density": 500, "membrane_density": 900}
PANELS: list[Tables | None] = [
    SANDWICH,
    {"construction": "bevel", "thickness": 0.006, "gap": 0.002},
    {"construction": "hinged", "thickness": 0.006, "gap": 0.002},
    None,
]


def drawn(number: int, *, tolerance: bool) -> DesignFile:
    """An arch of 2 to 4 m, of panels with and without a thickness, on stock that may be small."""
    random = np.random.default_rng(number)

    def between(low: float, high: float) -> float:
        return float(f"{random.uniform(low, high):.3g}")

    panel = PANELS[number % len(PANELS)]
    hinged = panel is not None and panel.get("construction") == "hinged"
    pattern: Tables = {"flap": 0} | ({"plane": "bisector"} if hinged else {})
    tables: Tables = {
        "shell": {"family": "parallel-repeating", "unit": "m"},
        "target": {
            "f": formula(f"-{between(0.5, 1)}*x**2", -1, 1),
            "g": formula(f"{between(0.2, 0.5)}*sin(pi*x/2)", 0, between(3, 5)),
        },
        "pattern": pattern,
        "workshop": {
            "stock": [between(0.6, 3), between(0.5, 1.5)],
            "margin": between(0.005, 0.02),
            "spacing": 0.005,
        },
        "motion": {"frames": 3},
    }
    if tolerance:
        tables["tolerance"] = {"surface": between(0.1, 0.3)}
    else:
        pattern |= {"rows": int(random.choice([3, 5, 7])), "columns": int(random.choice([4, 6, 9]))}
    if panel is not None:
        tables["panel"] = dict(panel)
        if panel is SANDWICH and number % 8 == 0:
            tables["workshop"]["roll"] = [between(0.6, 1.2), 20]
    if hinged:
        tables["deployment"] = {"from": "pack"}
    return check_design(tables, Path("shell.toml"))


def made(file: DesignFile) -> Shell:
    return make_shell(file, clash="unexamined", skip=SKIPPED)


def oversize(file: DesignFile) -> tuple[Shell | None, OversizeError | None]:
    """The shell, or the refusal of its stock."""
    try:
        return made(file), None
    except OversizeError as refusal:
        return None, refusal


def with_offers(file: DesignFile, refusal: OversizeError | None) -> Shell | None:
    """The shell with what a refusal offers; None if it says that nothing was found."""
    shell, typed = None, set[str]()
    while refusal is not None:
        if "expected room for its panels" in str(refusal):
            return None
        assert refusal.keys == tuple(refusal.needed)
        for high, low in refusal.needed.values():
            assert f"at least {high:g} x {low:g}" in str(refusal)
        assert not typed & refusal.needed.keys()  # what is offered is enough
        typed |= refusal.needed.keys()
        file = file.changed({key: list(sides) for key, sides in refusal.needed.items()})
        shell, refusal = oversize(file)
    return shell


def examine(numbers: Iterable[int], count: int, *, tolerance: bool) -> dict[str, int]:
    """Designs by numbers until so many were made or refused for their stock: how many of each."""
    seen = {"nested": 0, "refused": 0}
    for number in numbers:
        if sum(seen.values()) == count:
            break
        file = drawn(number, tolerance=tolerance)
        try:
            shell, refusal = oversize(file)
            seen["nested" if refusal is None else "refused"] += 1
            shell = shell or with_offers(file, refusal)
        except DesignError:
            continue
        rows = [] if shell is None else shell.report.quantities.order
        cut = [row for row in rows if row.unit == "m2" and row.item != "arms"]
        assert all(row.count and row.waste is not None for row in cut)
    return seen


def test_all_parts_nest_or_the_size_that_is_offered_works() -> None:
    """The offer stands in the message and is typed in; margins are in it."""
    seen = examine(NUMBERS, DRAWN, tolerance=False)
    assert sum(seen.values()) == DRAWN
    assert min(seen.values()) >= 1


@pytest.mark.parametrize("number", led_by([9, *sorted({*range(1, 33)} - {9})]))
def test_so_it_is_with_a_tolerance(number: int) -> None:
    """Rows and columns are chosen for it; in half a second where few are tried."""
    examine([number], 1, tolerance=True)


BAD: list[Any] = [
    ("hinge_stock = 0.01", "[workshop] hinge_stock", "expected at least"),
    ("tie_stock = 1", "[workshop] tie_stock", "expected at least"),
    ('row_hinge = "membrane"', "[workshop] row_hinge", 'got "membrane"'),
    ('column_hinge = "tape"', "[workshop] column_hinge", 'expected "auto" or "piano hinge"'),
    ("stock = [0.2, 0.2]", "[workshop] stock", "got 0.2 x 0.2, expected at least"),
    ("stock = [2, 1]\nmargin = 0.5", "[workshop] margin", "expected less than 0.5"),
    ("roll = [1.5]", "[workshop] roll", "expected"),
    ("tie_end = -1", "[workshop] tie_end", "expected"),
    ('row_hinge = "nails"', "[workshop] row_hinge", "expected"),
    ('tie_price = "cheap"', "[workshop] tie_price", "expected"),
]


@pytest.mark.parametrize(("keys", "where", "says"), led_by(BAD, 4))
def test_bad_inputs_are_refused_in_one_message(
    keys: str, where: str, says: str, tmp_path: Path
) -> None:
    """What, where, got and expected, in one line, with exit status 2."""
    path = tmp_path / "shell.toml"
    path.write_text(
        f"""
        [shell]
        family = "orthodiagonal"
        unit = "m"
        [target.f]
        formula = ["1.5*cos(t)", "1.5*sin(t)"]
        range = [0.3, 2.8]
        [target.g]
        formula = "0.1*cos(2*pi*x)"
        range = [0, 1]
        [pattern]
        rows = 3
        columns = 3
        flap = 0
        depth = 0.2
        heading_deg = 90
        spacing = "equal"
        [panel]
        construction = "hinged"
        thickness = 0.01
        gap = 0.002
        [deployment]
        from = "pack"
        ties = "feet"
        [motion]
        frames = 3
        [workshop]
        {keys}
        """
    )
    ran = orishell("design", path, "--out", tmp_path / "out", "--no-clash-test")
    assert ran.returncode == 2
    said = ran.stderr.strip()
    assert where in said
    assert says in said
    assert len(said.splitlines()) == 1
    assert not (tmp_path / "out").exists()
