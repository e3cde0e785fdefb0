"""What a refusal offers has been made whole: typed in, it is refused by nothing."""

from __future__ import annotations

from collections.abc import Callable, Collection
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from design_tables import Tables, formula, mended, tables
from orishell.conventions.errors import DesignError, InputError
from orishell.design_file import check_design
from orishell.design_file.tables import with_values
from orishell.shell import remedies
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES, Step
from samples import thorough

PARALLEL, ORTHO, LONG = (
    "parallel-repeating",
    "orthodiagonal",
    "longitudinal-linear-repeating",
)
REFUSALS = 120
"""Random designs are drawn until so many are refused."""


class Draw:
    """Random values, the same for the same number."""

    def __init__(self, number: int) -> None:
        self.random = np.random.default_rng(number)

    def number(self, low: float, high: float) -> float:
        return float(f"{self.random.uniform(low, high):.3g}")

    def one(self, *values: Any) -> Any:
        return values[int(self.random.integers(len(values)))]

    def chance(self, share: float) -> bool:
        return bool(self.random.random() < share)


def curve(draw: Draw) -> Tables:
    """An arch, a wave, an ellipse."""
    a, b = draw.number(0.2, 2.5), draw.number(0.5, 3)
    drawn: Tables = draw.one(
        formula(f"-{a}*x**2", -draw.number(0.3, 1.5), draw.number(0.3, 1.5)),
        formula([f"{a}*cos(t)", f"{b}*sin(t)"], draw.number(0, 0.6), draw.number(1.5, 3.2)),
        formula(f"{a}*sin(x)", 0, draw.number(1, 7)),
    )
    return drawn


def pattern(draw: Draw, family: str) -> Tables:
    """A family's table; angles, depths and flaps are often more than can be."""
    keys: Tables = {
        "rows": draw.one(1, 3, 5, 7),
        "columns": draw.one(3, 5, 7, 9),
        "flap": draw.one("auto", 0, draw.number(0.05, 0.5), draw.number(0.5, 3)),
    }
    match family:
        case "parallel-repeating":
            keys["xi_deg"] = draw.one("auto", draw.number(30, 175), draw.number(30, 120))
            keys["plane_deg"] = draw.one(90, 90, draw.number(30, 150))
        case "orthodiagonal":
            keys["depth"] = draw.one("auto", draw.number(0.05, 0.8))
            keys["heading_deg"] = draw.one("auto", draw.number(20, 160))
        case _:
            keys["flap"] = "auto"
            keys["sector_deg"] = draw.one("auto", [draw.number(70, 110) for _ in range(4)])
    return keys


def design(number: int) -> Tables:
    """A design that asks for much: thick boards, small stock, ties, loads, a tolerance."""
    draw = Draw(number)
    family = draw.one(PARALLEL, PARALLEL, ORTHO, ORTHO, LONG)
    g = formula("0*x", 0, draw.number(0.5, 6)) if family == LONG else curve(draw)
    g |= {"scale": draw.number(0.3, 3)}
    asked = tables(family, curve(draw), g, **pattern(draw, family))
    if family == LONG and draw.chance(0.3):
        del asked["target"]
        asked["pattern"] |= {"sector_deg": [draw.number(70, 110) for _ in range(4)]}
        asked["pattern"] |= {"stage_deg": draw.one("auto", draw.number(10, 170))}
    elif draw.chance(0.15):
        asked["tolerance"] = {"surface": draw.number(0.05, 0.5)}
        del asked["pattern"]["rows"], asked["pattern"]["columns"]
    return asked | building(draw)


def building(draw: Draw) -> Tables:
    """Boards, stock, ties, hinges, a pack and loads: each of them in some designs."""
    wanted: Tables = {"deployment": {}}
    if draw.chance(0.6):
        thickness = draw.one(draw.number(0.005, 0.03), draw.number(0.03, 0.4))
        sandwich = {"membrane": 0.001, "membrane_density": 1000}
        made = draw.one(sandwich, {"construction": "bevel", "gap": 0.002})
        wanted["panel"] = {"thickness": thickness, "density": 200} | made
        if draw.chance(0.4):
            support = {"at": draw.one("feet", "ends"), "kind": "pinned"}
            wanted["structure"] = {"modulus": 9e9, "supports": [support]}
            wanted["load_case"] = [{"name": "dead", "self_weight": True}]
    if draw.chance(0.4):
        wanted["workshop"] = {"stock": [draw.number(0.3, 3), draw.number(0.3, 2)]}
    for key, value, share in (
        ("ties", "feet", 0.3),
        ("flap_attachment", "clipped", 0.3),
        ("from", "pack", 0.2),
        ("largest_fold_deg", draw.number(90, 180), 0.2),
    ):
        if draw.chance(share):
            wanted["deployment"][key] = value
    return wanted | {"motion": {"frames": 3}}


def refusal(asked: Tables, skip: Collection[Step] = ()) -> DesignError | None:
    """Why a design is refused for what it is; None if it is made, or for other reasons not."""
    try:
        make_shell(check_design(asked, Path("shell.toml")), skip=skip)
    except DesignError as error:
        return error
    except InputError:
        return None
    return None


@thorough
def test_every_offer_typed_in_is_made(record_property: Callable[[str, object], None]) -> None:
    refused = offered = number = 0
    while refused < REFUSALS:
        asked = design(number)
        error = refusal(asked)
        number += 1
        if error is None:
            continue
        refused += 1
        offered += len(error.remedies)
        assert error.remedies or error.limit
        for remedy in error.remedies:
            shell = make_shell(check_design(mended(asked, remedy), Path("shell.toml")))
            assert shell.report.feasible, (number - 1, str(error))
    record_property("offers", f"{offered} for {refused} refusals among {number} designs")
    assert offered >= refused / 2  # a search that finds nothing would pass all else


STEEP = tables(
    PARALLEL,
    formula("-x**2", -1, 1),
    formula("5*sin(pi*x/10)", 0, 8),
    rows=5,
    columns=5,
    flap=0.3,
    xi_deg=80,
)


@pytest.mark.parametrize(
    ("key", "value", "said"),
    [
        ("workshop.stock", [0.1, 0.1], "panels do not fit the stock"),
        ("deployment.ties", [[[0, 2], [99, 2]]], "a tie ends beyond the rows"),
    ],
)
def test_what_ends_the_command_after_the_proof_is_no_offer(key: str, value: Any, said: str) -> None:
    """Without stock and ties an angle is offered; with these, no angle helps."""
    offered = refusal(STEEP, MEASURES)
    assert offered is not None
    assert "pattern.xi_deg" in offered.remedies[0].changes
    error = refusal(with_values(STEEP, {key: value}), MEASURES)
    assert error is not None
    assert not error.remedies
    assert said in error.limit


def test_a_shell_that_takes_long_is_looked_at_for_longer(monkeypatch: pytest.MonkeyPatch) -> None:
    """As a fitted sheet: the trial of what works takes as long as the refusal did."""
    monkeypatch.setattr(remedies, "SECONDS", 0.0)
    monkeypatch.setattr(remedies, "LONGER", 1e6)
    error = refusal(STEEP, MEASURES)
    assert error is not None
    assert error.remedies


def test_looking_ends_when_its_time_is_over(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(remedies, "SECONDS", 0.0)
    monkeypatch.setattr(remedies, "LONGER", 0.0)
    error = refusal(STEEP, MEASURES)
    assert error is not None
    assert not error.remedies
    assert "looking ended after 0 s of work" in error.limit


def test_an_offer_comes_near_to_what_was_asked_for() -> None:
    """A value 2 % of the way nearer to the refused one is refused too, or was not worth a trial."""
    error = refusal(STEEP, MEASURES)
    assert error is not None
    offered = error.remedies[0].changes["pattern.xi_deg"]
    assert isinstance(offered, float)
    nearer = {"pattern.xi_deg": offered + 0.02 * (80 - offered)}
    assert refusal(with_values(STEEP, nearer), MEASURES)
