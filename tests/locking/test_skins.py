"""Second skins of random shells: manifold3d finds nothing before the proved ends of the motion."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from design_tables import made, mended
from orishell.conventions.errors import DesignError, InputError
from orishell.io.joint_tables import hung_table
from orishell.shell.make import Shell
from overlaps import NOTHING
from samples import THOROUGH
from skinned import random_tables, skinned
from stiffened import bodies, common, shell_of

QUICK, ALL = (0, 1, 2, 5, 8, 60, 62), 80


def test_random_shells_have_a_second_skin_or_a_reason() -> None:
    """So the test below sees some of each."""
    found = [skinned(number)[1] for number in QUICK]
    assert sum(isinstance(each, Shell) for each in found) >= len(QUICK) // 2


@pytest.mark.parametrize("number", range(ALL) if THOROUGH else QUICK)
def test_nothing_meets_where_the_motion_is_proved(number: int) -> None:
    """Volume that skin and walls have in common with others, in states between both ends."""
    design, shell = skinned(number)
    if isinstance(shell, DesignError):
        assert shell.place
        with pytest.raises(DesignError) as caught:
            made(design)
        for remedy in caught.value.remedies:
            assert shell_of(mended(design, remedy)).design.carried
        return
    motion, document = shell.lock.skin, shell.document
    assert motion is not None
    shut = 1e-5 if document.boards is None else -1e-9
    start, stop = motion.joined_from, shell.lock.closes_to * (1 - shut)
    looked = 0
    for state, each in enumerate(document.states):
        assert each.drive_deg is not None
        if not np.rad2deg(start) <= each.drive_deg <= np.rad2deg(stop):
            continue
        names, found = bodies(document, state)
        total = sum(body.volume() for body in found)
        for kind in ("skin", "wall"):
            assert max(common(names, found, kind).values(), default=0.0) < NOTHING * total
        looked += 1
    assert looked


def shell_with(**asked: Any) -> Shell:
    design = random_tables(0, 0)
    design["pattern"] |= {"rows": 5, "columns": 4, "flap": 0, "xi_deg": 60, "plane_deg": 90}
    design["stiffeners"] = {"kind": "skin", **asked}
    return shell_of(design)


def test_gap_cells_and_walls_are_reported() -> None:
    shell = shell_with(gap=0.05)
    skin = shell.report.lock.skin
    assert skin is not None
    assert skin.gap == pytest.approx(0.05, rel=1e-9)
    assert skin.largest_gap >= skin.gap
    assert skin.cells == len(skin.walls) - 1 > 0
    air = shell.report.deployment.air
    if air is not None:
        assert air.at_target == pytest.approx(skin.volume, rel=1e-12)
    (row,) = (row for row in shell.report.verdict if row.subject == "skin")
    assert row.sign == "holds"
    assert row.finding.startswith("50 mm from the sheet at the least, on ")
    few = shell_with(gap=0.05, walls=[skin.walls[1]]).report.lock.skin
    assert few is not None
    assert (few.walls, few.cells, few.volume) == (skin.walls[1:2], 0, 0.0)


def test_it_weighs_as_the_sheet_does() -> None:
    plain = shell_of({k: v for k, v in shell_tables().items() if k != "stiffeners"})
    whole = shell_of(shell_tables())
    areas = [sum(part.areas().sum() for part in s.document.parts) for s in (plain, whole)]
    masses = [s.report.quantities.mass_kg for s in (plain, whole)]
    assert masses[0] is not None
    assert masses[1] is not None
    assert masses[1] / masses[0] == pytest.approx(areas[1] / areas[0], rel=1e-9)
    assert areas[1] > 2 * areas[0]


def shell_tables() -> dict[str, Any]:
    design = random_tables(0, 0)
    design["pattern"] |= {"rows": 5, "columns": 4, "flap": 0, "xi_deg": 60, "plane_deg": 90}
    design["stiffeners"] = {"kind": "skin", "gap": 0.05}
    design["workshop"] = {"areal_density": 2.0}
    design.pop("deployment", None)
    return design


def test_both_ends_of_a_wall_are_in_the_table_of_lines() -> None:
    """On the bottom of a panel of the sheet, and on the top of the one below it, as far along."""
    shell = shell_with(gap=0.05)
    table = hung_table(shell.document)
    assert table is not None
    rows = [[*map(str, row)] for row in table[1]]
    panels = len(shell.document.sheet.mesh.faces)
    assert len(rows) == 2 * sum(
        len(part.mesh.faces) for part in shell.document.attached if part.kind == "wall"
    )
    outer = {(r[0], r[1]): r for r in rows if not r[1].startswith("skin ")}
    inner = {(r[0], r[1].removeprefix("skin ")): r for r in rows if r[1].startswith("skin ")}
    assert outer.keys() == inner.keys()
    assert len(outer) <= panels
    assert {r[2] for r in outer.values()} == {"bottom"}
    assert {r[2] for r in inner.values()} == {"top"}


def test_what_has_no_room_is_refused_with_what_has() -> None:
    with pytest.raises(DesignError, match="face each other") as caught:
        made({**shell_tables(), "stiffeners": {"kind": "skin", "gap": 1.0}})
    (remedy,) = caught.value.remedies
    assert shell_of(mended(shell_tables(), remedy)).design.carried
    with pytest.raises(InputError, match="rows of panels"):
        shell_with(walls=[77])
    with pytest.raises(InputError, match="no row is named"):
        shell_with(walls=[])
