"""How a rectangle is turned that the design file leaves open."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from orishell.conventions.errors import InputError
from orishell.design_file import DesignFile
from orishell.design_file.file import check_design
from orishell.shell.make import make_shell
from orishell.shell.steps import Step
from samples import thorough

BARREL = "sqrt(9 - (x*cos(pi/6) + y*sin(pi/6))**2)"
"""A cylinder whose rulings run 120 degrees from x."""
SKIPPED: tuple[Step, ...] = (
    "remedies",
    "verification",
    "deviation",
    "pack",
    "weight",
    "stock",
    "structure",
)


def file_of(family: str, pattern: dict[str, Any], **surface: Any) -> DesignFile:
    shell = {"family": family, "unit": "m"}
    target = {"surface": {"formula": BARREL, "turn_deg": "auto", **surface}}
    return check_design({"shell": shell, "target": target, "pattern": pattern}, Path("x.toml"))


@thorough
def test_the_rectangle_is_turned_to_where_the_shell_comes_nearest_and_the_report_says_so() -> None:
    """A cylinder is swept exactly over a rectangle along its rulings, and over no other."""
    file = file_of("orthodiagonal", {"rows": 11, "columns": 7}, size=[4, 2])
    shell = make_shell(file, clash="unexamined", skip=SKIPPED)
    turned = shell.report.turned
    assert turned is not None
    assert turned.turn_deg in (30, 120)
    assert shell.file.tables["target"]["surface"]["turn_deg"] == turned.turn_deg
    distances = {each.turn_deg: each.distance for each in turned.tried}
    assert list(distances) == [0, 30, 60, 90, 120, 150]
    assert min(distances, key=lambda each: distances[each] or 9e9) == turned.turn_deg
    written: dict[str, Any] = shell.report.as_dict()
    assert written["turned"]["turn_deg"] == turned.turn_deg
    said = [row.finding for row in shell.report.verdict if row.subject == "turn"]
    assert said[0].startswith(f"rectangle turned by {turned.turn_deg:g} degrees")


def test_where_no_turn_gives_a_shell_the_first_refusal_is_the_answer() -> None:
    file = file_of("orthodiagonal", {"rows": 11, "columns": 7}, size=[4, 2])
    with pytest.raises(InputError, match="not finite"):
        file.changed({"target.surface.size": [9, 9]})
