"""Feet in plan, and the ground that shells need, against states that are placed otherwise."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely
from scipy.spatial.transform import Rotation

from orishell.deployment.feet import find_feet
from orishell.deployment.occupied import Occupied
from orishell.deployment.standing import Standing
from orishell.deployment.swept import find_sweep
from orishell.design_file import read_design_file
from orishell.motion.hinges import Hinges
from orishell.motion.layout import points_of
from orishell.numerics.arrays import Array
from orishell.shell.make import Shell, make_shell
from orishell.shell.steps import Step
from samples import led_by, thorough

ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "examples"
STARTERS = {
    path.parent.name: path
    for path in sorted((ROOT / "src" / "orishell" / "families").rglob("starter.toml"))
}
ROUNDING = 1e-9
WASTE = 0.02
"""The outline may be larger than the hull of the samples by this share of the area."""
PACK: dict[str, Any] = {"deployment.from": "pack"}
SANDWICH: dict[str, Any] = {
    "panel.thickness": 0.03,
    "panel.construction": "sandwich",
    "panel.membrane": 0.002,
}
CASES: list[tuple[str, dict[str, Any]]] = [
    ("parallel_repeating", {}),
    ("flat_foldable", PACK),
    *((name, start) for name in STARTERS for start in ({}, PACK)),
    *(
        ("parallel_repeating", {"pattern.rows": rows, "pattern.columns": columns, **start})
        for rows, columns in ((5, 7), (7, 16), (13, 9), (21, 13))
        for start in ({}, PACK)
    ),
    *(
        ("orthodiagonal", {"pattern.rows": rows, "pattern.columns": columns, **start})
        for rows, columns in ((5, 7), (7, 10), (11, 9), (15, 19))
        for start in ({}, PACK)
    ),
    *(
        (name, {**SANDWICH, **start, "deployment.flap_attachment": "clipped"})
        for name in ("parallel_repeating", "orthodiagonal", "longitudinal_linear_repeating")
        for start in ({}, PACK)
    ),
    *(("flat_foldable", {**SANDWICH, "deployment.from": "flat", "panel.thickness": t})
      for t in (0.01, 0.02)),
    *(("shelter", {"pattern.columns": columns}) for columns in (7, 9, 13, 17)),
    *(("flat_foldable", {"panel.thickness": 0.01, "panel.construction": "hinged", **start})
      for start in ({}, PACK)),
    *(("shelter_boards", {"panel.thickness": t}) for t in (0.005, 0.015, 0.03)),
    *((name, {}) for name in ("tunnel", "vault", "figure2", "figure3", "dome", "arch_pattern")),
    *(("drawn", {"panel.thickness": t, "panel.construction": "hinged"}) for t in (0.01, 0.012)),
]  # fmt: skip
SKIPPED: tuple[Step, ...] = ("remedies", "verification", "deviation", "pack", "stock", "structure")


@cache
def _made(name: str, changes: tuple[tuple[str, Any], ...]) -> Shell:
    path = STARTERS.get(name, EXAMPLES / f"{name}.toml")
    file = read_design_file(path).changed(dict(changes))
    return make_shell(file, skip=SKIPPED, clash="allowed")


def made(name: str, changes: dict[str, Any]) -> Shell:
    return _made(name, tuple(changes.items()))


def bodies(shell: Shell, drive: float) -> Array:
    """All corners (N, 3) of panels, or of boards, in a state, those at the target with flaps."""
    document, mechanism = shell.document, shell.design.mechanism
    points = points_of(mechanism, drive)
    if document.boards is not None:
        boards = document.boards.carried(document.mesh.faces, document.require_flat(), points)
        points = boards.reshape(-1, 3)
    if drive != mechanism.target_drive:
        return points
    beside = [
        flap.shell.positions if flap.boards is None else flap.boards_in(flap.shell).reshape(-1, 3)
        for flap in document.attached
    ]
    return np.concatenate([points, *beside])


def feet_at(shell: Shell, drive: float) -> Array:
    """Feet (P, 2, 3) of both rows in a state, one by one."""
    mechanism, feet = shell.design.mechanism, shell.site.feet
    assert feet is not None
    positions = mechanism.positions(drive)
    hinges, found = shell.design.hinges, []
    boards = hinges.boards(positions) if isinstance(hinges, Hinges) else None
    for column in feet.columns(mechanism).tolist():
        pair = []
        for row, other in (feet.rows, feet.rows[::-1]):
            if boards is None:
                pair.append(positions[row, column])
                continue
            above, last = row < other, column == mechanism.grid.columns - 1
            corner = {(True, False): 0, (False, False): 1, (False, True): 2, (True, True): 3}
            at = boards[row if above else row - 1, column - last, corner[above, last]]
            pair.append(at)
        found.append(pair)
    return np.array(found)


def placed(shell: Shell, drive: float, points: Array | None = None) -> Array:
    """All corners, or points (N, 3), on the ground, from the plan's corner: turned, then moved."""
    target = shell.design.mechanism.target_drive
    plan = shell.report.deployment.ground
    assert plan is not None
    now, then = feet_at(shell, drive), feet_at(shell, target)
    line, aim = ((feet[:, 1] - feet[:, 0]).mean(axis=0) for feet in (now, then))

    def heading(vector: Array) -> float:
        return float(np.arctan2(vector[1], vector[0]))

    def rise(vector: Array) -> float:
        return float(np.arctan2(vector[2], np.hypot(vector[0], vector[1])))

    about = Rotation.from_euler("z", heading(aim) - heading(line))
    across = np.array([np.sin(heading(aim)), -np.cos(heading(aim)), 0.0])
    lift = Rotation.from_rotvec((rise(aim) - rise(line)) * across)
    away = (bodies(shell, drive) if points is None else points) - now.mean(axis=(0, 1))
    moved = (lift * about).apply(away)
    corner = np.array([*plan.corner, 0.0]) - shell.design.origin * [1, 1, 0]
    return np.asarray(moved + then.mean(axis=(0, 1)) * [1, 1, 0] - corner)


def drives_of(shell: Shell, count: int = 200) -> Array:
    """Drives of the way, the target among them, crowded at the end."""
    target = shell.design.mechanism.target_drive
    end = 0.0
    if shell.file.deployment.start == "pack":
        end = max(shell.lock.closes_to, target)
    shares = np.linspace(0, 1, count)
    shares = np.sort(np.concatenate([shares[::2], shares[1::2] ** 4]))
    return np.append(end + (target - end) * shares[:-1], target)


@pytest.mark.parametrize(("name", "changes"), led_by(CASES, 2))
def test_nothing_is_ever_outside_of_the_ground_and_little_of_it_is_wasted(
    name: str, changes: dict[str, Any]
) -> None:
    shell = made(name, changes)
    plan = shell.report.deployment.ground
    assert (plan is None) == (shell.report.stands is None)
    if plan is None:
        return
    swept = plan.swept
    assert swept is not None
    count = 200 if len(bodies(shell, 0.0)) < 20_000 else 60
    states = [placed(shell, float(drive)) for drive in drives_of(shell, count)]
    every = np.concatenate(states)
    outline, hull = shapely.Polygon(swept.outline), shapely.MultiPoint(every[:, :2]).convex_hull
    assert outline.buffer(ROUNDING).covers(hull)
    assert outline.area < (1 + WASTE) * hull.area
    highest = max(float(np.ptp(state[:, 2])) for state in states)
    assert highest <= swept.height + ROUNDING
    assert swept.height < highest + 2 * swept.margin + 0.01 * max(highest, swept.width)
    lowest = -float(every[:, 2].min())
    assert lowest <= swept.below + ROUNDING or lowest <= ROUNDING
    size = np.ptp(np.array(swept.outline), axis=0)
    np.testing.assert_allclose((swept.width, swept.depth), size)
    shown = shapely.Polygon(plan.outline)
    assert outline.buffer(ROUNDING).covers(shown)
    assert shown.buffer(ROUNDING).covers(shapely.MultiPoint(states[-1][:, :2]))


@pytest.mark.parametrize("name", ["shelter", pytest.param("dome", marks=thorough), "tunnel"])
def test_feet_have_the_coordinates_of_the_shell(name: str) -> None:
    shell = made(name, {})
    plan, feet = shell.report.deployment.ground, find_feet(shell.design)
    assert plan is not None
    assert feet is not None
    target = shell.design.mechanism.positions(shell.design.mechanism.target_drive)
    world = shell.document.in_world(target)
    at = np.array([foot.at for foot in plan.feet])
    here = np.array([(foot.x, foot.y) for foot in plan.feet])
    np.testing.assert_array_equal(at, feet.vertices(shell.design.mechanism))
    if not shell.design.hinges.beside:
        there = world[at[:, 0], at[:, 1]]
        np.testing.assert_allclose(here + plan.corner, there[:, :2], rtol=0, atol=ROUNDING)
        heights = [foot.z for foot in plan.feet]
        np.testing.assert_allclose(heights, there[:, 2] - there[:, 2].min(), atol=ROUNDING)
    np.testing.assert_allclose(here.min(axis=0), 0, atol=ROUNDING)
    assert [foot.number for foot in plan.feet] == list(range(1, len(plan.feet) + 1))


def test_forces_of_stages_are_differences_of_energy_by_way() -> None:
    shell = made("shelter", {})
    raising, weight = shell.report.deployment.raising, shell.report.deployment.weight
    assert raising is not None
    assert weight is not None
    mechanism = shell.design.mechanism
    shares = np.zeros(mechanism.grid.rows * mechanism.grid.columns)
    faces = mechanism.grid.faces_vertices()
    flat = points_of(mechanism, 0.0)
    for triangle in ([0, 1, 2], [0, 2, 3]):
        p, q, r = (flat[faces[:, k]] for k in triangle)
        np.add.at(shares, faces[:, triangle], np.cross(q - p, r - p)[:, 2:] / 6)
    shares /= shares.sum()

    def state(drive: float) -> tuple[float, float, float]:
        """Energy, distance of the feet, and height of the row that is lifted."""
        feet = feet_at(shell, drive)
        energy = weight.total * float(
            shares @ placed(shell, drive, points_of(mechanism, drive))[:, 2]
        )
        row = mechanism.positions(drive)[raising.row, mechanism.inner_columns]
        height = float(placed(shell, drive, row)[:, 2].mean())
        return energy, float(np.linalg.norm(feet[:, 1] - feet[:, 0], axis=-1).mean()), height

    step = 1e-4
    for stage in raising.stages[1:-1]:
        before, after = np.array(state(stage.drive + step)), np.array(state(stage.drive - step))
        energy, span, row = after - before
        assert stage.force == pytest.approx(energy / span, rel=1e-5)
        assert stage.lift == pytest.approx(energy / row, rel=1e-5)
        assert stage.people == int(np.ceil(abs(energy / span) / raising.person))
    assert [stage.work for stage in raising.stages] == sorted(s.work for s in raising.stages)
    assert raising.stages[-1].work == pytest.approx(weight.raise_from_pack, rel=1e-3)


def test_from_flat_no_force_at_the_feet_begins_but_a_lift_does() -> None:
    raising = made("parallel_repeating", {}).report.deployment.raising
    assert raising is not None
    first, *others = raising.stages
    assert first.force is None
    assert first.lift is not None
    assert first.lift > 0
    assert all(stage.force is not None and stage.force > 0 for stage in others)
    assert first.people is None  # its mass is not known


def test_a_shell_that_cannot_stand_has_no_plan() -> None:
    shell = made("parallel_repeating", {"target.f.formula": "x**2"})
    assert shell.report.stands is None
    assert shell.report.deployment.ground is None
    assert shell.report.deployment.raising is None
    assert shell.document.ground is None


def test_pieces_are_no_one_motion() -> None:
    shell = made("shelter_hinged", {"pattern.columns": 5})
    plan = shell.report.deployment.ground
    assert plan is not None
    assert plan.swept is None
    assert "the ground that is needed on the way" in shell.report.not_checked
    assert shell.report.deployment.raising is None


def test_ground_is_not_known_where_accelerations_have_no_bound_on_the_way(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """At the very end of a motion they may have none; elsewhere nothing is said."""
    design = made("parallel_repeating", {}).design
    feet = find_feet(design)
    assert feet is not None
    standing = Standing.of(design.mechanism, feet.rows, feet.columns(design.mechanism))
    occupied, bounded = Occupied.by(design.mechanism, None), Occupied.accelerations
    target = design.mechanism.target_drive

    def lost(at: float) -> None:
        def unbounded(self: Occupied, start: Array, stop: Array) -> Array:
            there = (start <= at) & (at <= stop)
            return np.where(there, np.inf, bounded(self, start, stop))

        monkeypatch.setattr(Occupied, "accelerations", unbounded)

    lost(0.0)
    assert find_sweep(standing, occupied, 0.0) is not None
    lost(0.3 * target)
    assert find_sweep(standing, occupied, 0.0) is None
