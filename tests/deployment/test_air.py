"""Air in box girders: volumes by another program, pressures by virtual work."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from mechanisms import complex_of, flat_foldable, parallel, random_net
from orishell.deployment.air import FAN, Air
from orishell.deployment.weight import Body
from orishell.design_file import check_design
from orishell.motion import Mechanism
from orishell.motion.complex import Complex
from orishell.motion.sleeves import Q, R, Sleeve, W
from orishell.shell.make import Shell, make_shell

FACES = ((0, 1, 2, 3), (7, 6, 5, 4), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0))
"""Sides of a part of a box between two columns, by its corners x, q, w and r at one, then at the
other."""


@pytest.mark.parametrize("sheet", [parallel(), flat_foldable(random_net(6, 5, 2))], ids=repr)
def test_volumes_are_those_of_solids(sheet: Mechanism) -> None:
    """manifold3d's, of the eight corners of every part of a box."""
    import manifold3d

    whole = complex_of(sheet)
    points = sheet.positions(0.6 * sheet.target_drive)
    for sleeve in whole.strips[::2]:
        found = sleeve.cells[0].volumes(points)
        assert isinstance(sleeve, Sleeve)
        lines, x = sleeve.carried(points), points[sleeve.row, sleeve.columns]
        ring = np.stack([x, lines[Q], lines[W], lines[R]])
        for column, volume in enumerate(found.tolist()):
            corners = np.concatenate([ring[:, column], ring[:, column + 1]])
            triangles = [t for a, b, c, d in FACES for t in ((a, b, c), (a, c, d))]
            mesh = manifold3d.Mesh64(corners, np.array(triangles, dtype=np.uint64))
            solid = manifold3d.Manifold(mesh)
            assert abs(solid.volume()) == pytest.approx(volume, rel=1e-9)


@pytest.fixture(scope="module")
def shell() -> Shell:
    page = Path("docs/guide/boxes.md").read_text(encoding="utf-8")
    import tomllib

    tables = tomllib.loads(page.split("```toml\n")[1].split("```")[0])
    tables["deployment"] = {"from": "pack"}
    return make_shell(check_design(tables, Path("boxes.toml")))


def air_of(shell: Shell) -> Air:
    air = shell.report.deployment.air
    assert air is not None
    return air


def test_pressure_balances_own_weight(shell: Shell) -> None:
    """p dV = dU between two drives near each other, with volume and energy of those alone."""
    air, whole = air_of(shell), shell.design.moving
    assert isinstance(whole, Complex)
    feet = shell.report.stands
    assert feet is not None
    site = shell.report.deployment.weight
    assert site is not None
    areal = site.total / Body.of(whole, feet.rows, 1.0, feet.columns(whole.sheet)).shares.sum()
    body = Body.of(whole, feet.rows, float(areal), feet.columns(whole.sheet))
    looked = 0
    for drive, pressure in zip(air.drives[5:-5:9], air.pressures[5:-5:9], strict=True):
        ends = drive - 1e-4, drive + 1e-4
        lifted = np.diff([body.at(each)[0] for each in ends])[0]
        grown = np.diff(
            [
                sum(
                    strips.cells[0].volumes(whole.sheet.positions(each)).sum()
                    for strips in whole.strips
                )
                for each in ends
            ]
        )[0]
        if pressure is None or abs(grown) < 1e-6 * max(air.volumes):
            continue
        assert pressure == pytest.approx(lifted / grown, rel=0.05)
        looked += 1
    assert looked >= 3


def test_air_rests_where_boxes_hold_most(shell: Shell) -> None:
    air = air_of(shell)
    assert air.volumes[air.drives.index(air.rest)] == max(air.volumes)
    assert min(air.volumes) >= 0
    assert air.fan_to is not None
    assert shell.lock.target_drive <= air.fan_to <= air.drives[-1]
    lifted = [
        pressure
        for drive, pressure in zip(air.drives, air.pressures, strict=True)
        if drive >= air.fan_to and drive < air.drives[-1] and pressure is not None
    ]
    assert max(lifted, default=0.0) <= FAN
