"""Rough ground: Coulomb's law in every state, and verdicts against other statics.

Random shells, as in `rough_shells`: three or five rows, three to six columns, with and without
flaps and ties, friction from 0.05 to 1.5, own weight, snow or wind.
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import numpy as np
import pytest

from orishell.design_file import read_design_file
from orishell.numerics.arrays import Array
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES
from orishell.structure.feet import find_feet
from orishell.structure.free_motion import describe_motion
from orishell.structure.solve import active_set, bearing
from orishell.structure.solve.active_set import Response, respond
from orishell.structure.solve.bearing import driven_motion, needed_friction, with_friction
from orishell.structure.solve.conditions import on_ground
from orishell.structure.solve.factorised import GIVE, Factorised
from orishell.structure.verdict import against_motion
from samples import led_by, thorough
from structure.rough_shells import loaded_shells, missing, rough_shell
from structure.test_one_sided import CORNERS, load, middle, slab

SHARP = 1e-8
"""Of loads, and of displacements."""
POLYGON = 1 / np.cos(np.pi / 96)
"""By so much a circle around 96 corners on it is larger than the circle inside its sides."""


def require_coulomb(held: Factorised, loads: Array, found: Response) -> None:
    """Cone and complementarity, of forces and of gaps by displacements, and equilibrium.

    Forces to 1e-8 of the sum of all loads' sizes, lengths to 1e-8 of the shell's largest
    displacement; the cone to 1e-9 of what a foot can rub, equilibrium to 1e-8 of the loads.
    """
    conditions, count = held.conditions, len(held.conditions)
    rough, force = conditions.rough, SHARP * float(np.abs(loads).sum())
    rest = loads - (found.taken + held.pulls(found.forces))[held.free]
    assert np.abs(rest).max() < force
    gaps = held.rows @ found.displacements
    length = SHARP * held.furthest(found.displacements)
    give = np.where(conditions.compliance > 0, conditions.compliance, GIVE / held.springs[:count])
    presses, parted = found.forces[:count], gaps[:count] - give * found.forces[:count]
    assert presses.min() >= 0
    assert parted.max() < length
    assert np.minimum(presses / force, -parted / length).max() < 1
    rows = slice(count, count + 2 * len(rough))
    rubs = found.forces[rows].reshape(-1, 2)
    slips = (gaps - GIVE / held.springs * found.forces)[rows].reshape(-1, 2)
    limit = conditions.friction[rough] * presses[rough]
    used = np.linalg.norm(rubs, axis=1)
    assert (used <= limit * (1 + 1e-9)).all()
    slides = np.linalg.norm(slips, axis=1)
    assert np.minimum(slides / length, (limit - used) / force).max(initial=0.0) < 1
    # What slips is rubbed along its slip, as the force of a row is on the ground.
    far = slides > length
    along = np.einsum("gi,gi->g", slips[far], rubs[far])
    assert (along > slides[far] * used[far] - slides[far] * force - used[far] * length).all()


def survey(seeds: Iterable[int]) -> dict[str, int]:
    """How random shells end, each tried for Coulomb's law and against a linear program.

    Shells move if the program misses more than 1e-6 of the loads with its polygon inside the
    circle; they do not if it misses less than 1e-5 with its polygon outside.
    """
    ends = dict.fromkeys(("holds", "slides away", "moves", "between"), 0)
    for seed, model, held, loads in loaded_shells(seeds):
        found = respond(held, loads)
        inner, outer = missing(held, loads), missing(held, loads, POLYGON)
        if found.moves is not None:
            assert loads @ found.moves > 0
            ends["slides away" if found.slides else "moves"] += 1
            assert not found.unknown, seed
            assert found.slides or inner > 1e-6, seed
            assert not found.slides or outer < 1e-5, seed
            continue
        assert outer < 1e-5, seed
        ends["between"] += inner > 1e-5
        if held.furthest(found.displacements) > model.size:
            ends["slides away"] += 1
            continue
        ends["holds"] += 1
        require_coulomb(held, loads, found)
        feet = find_feet(held, found, tuple(model.grounded))
        assert all((each.used or 0.0) <= 1 + 1e-9 for each in feet)
        assert all((each.state == "slips") == (each.slipped > 0) for each in feet)
    return ends


@pytest.mark.slow
def test_random_shells_keep_to_coulombs_law() -> None:
    """Of the first twenty all but one, which alone takes longer than the others together."""
    ends = survey(seed for seed in range(20) if seed != 11)
    assert sum(ends.values()) >= 14
    assert ends["holds"] >= 8


@thorough
@pytest.mark.parametrize("first", range(0, 400, 40))
def test_three_hundred_random_shells_keep_to_coulombs_law(first: int) -> None:
    assert survey(range(first, first + 40))["holds"] >= 10


CASES = sorted(path.stem for path in (Path(__file__).parent / "rough").glob("*.toml"))


@pytest.mark.slow
@pytest.mark.parametrize("name", led_by(CASES, 3))
def test_shells_that_had_no_answer_have_one(name: str) -> None:
    """Designs for which the sets of who acts went round in circles."""
    file = read_design_file(Path(__file__).parent / "rough" / f"{name}.toml")
    shell = make_shell(file, clash="unexamined", skip=("remedies", "verification", *MEASURES))
    assert shell.analysis is not None
    (case,) = shell.analysis.cases
    if name == "all_22":  # forces of 0.0999 could bear it, and nothing makes its feet press so
        assert case.motion is not None
        assert case.motion.ground == "slips"
        return
    assert case.equilibrium is not None
    assert case.equilibrium.residual < 1e-12
    assert case.equilibrium.friction is not None
    assert case.equilibrium.friction <= 1 + 1e-9


def test_a_shell_that_goes_far_has_a_state() -> None:
    """It goes 4e4 times as far as springs would let it: rounding is by y, not by loads."""
    assert survey(range(512, 513))["slides away"] == 1


def test_no_friction_is_needed_where_smooth_ground_does() -> None:
    """Found by 1e-4 of a coefficient, not by halving until numbers end."""
    _, held, loads = rough_shell(512).loaded()
    assert needed_friction(held, loads) == pytest.approx(0.0, abs=2e-4)


def test_a_heavier_foot_takes_what_a_lighter_one_lets_slip() -> None:
    """Two feet of a slab bear 5 and 45 N each, and are pushed by 0.8 of what all can rub.

    Pushed at the light ones, which are the nearest, these slip first.
    """
    friction = 0.4
    mesh, held = slab([on_ground(CORNERS, np.full(4, friction))])
    at = mesh.facets.points
    left = np.flatnonzero(at[CORNERS, 0] == 0)
    right = np.flatnonzero(at[CORNERS, 0] == 1)
    heavy = [(int(CORNERS[k]), (0.0, 0.0, -80.0)) for k in right]
    push = 0.8 * friction * (100.0 + 160.0)
    light = [(int(CORNERS[k]), (-push / 2, 0.0, 0.0)) for k in left]
    found = load(mesh, held, *heavy, *light)
    assert found.moves is None
    presses, rubs = found.forces[:4], found.forces[4:12].reshape(-1, 2)
    used = np.linalg.norm(rubs, axis=1) / (friction * presses)
    np.testing.assert_allclose(used[left], 1.0, atol=1e-9)
    assert (used[right] < 0.99).all()
    np.testing.assert_allclose(rubs.sum(axis=0), [-push, 0.0], atol=1e-9 * push)
    slips = np.linalg.norm(found.parted[4:12].reshape(-1, 2), axis=1)
    assert (slips[left] > 0).all()
    assert (slips[right] == 0).all()


def test_friction_that_is_needed_is_that_of_a_push() -> None:
    """100 N and 30 N aside need 0.3; and a foot at the middle's edge tips before it slips."""
    mesh, held = slab([on_ground(CORNERS, np.full(4, 0.1))])
    loads = np.zeros(mesh.count)
    own = mesh.translations()
    loads[own[:, 2]] -= 100.0 / len(own)
    loads[own[middle(mesh), 0]] += 30.0
    loads = loads[held.free]
    assert driven_motion(held, loads) is not None
    assert driven_motion(held, loads, "sticks") is None
    assert needed_friction(held, loads) == pytest.approx(0.3, rel=1e-3)
    assert respond(with_friction(held, 0.31), loads).moves is None
    lifted = loads.copy()
    lifted[own[0, 2]] += 60.0
    assert driven_motion(held, lifted, "sticks") is not None
    assert driven_motion(held, lifted, "anchored") is None
    assert needed_friction(held, lifted) is None


def test_a_linear_program_says_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where least squares prove nothing; of 7, 95 and 274 ties and flaps are opposite to rounding.

    Every motion is a proof: loads work on it more than a million times what any ray does.
    """
    shells = [
        shell for seed in (*range(8), 95, 274) for shell in loaded_shells(range(seed, seed + 1))
    ]
    expected = [driven_motion(held, loads) for *_, held, loads in shells]
    monkeypatch.setattr(bearing, "_least_squares", lambda *_: None)
    for before, (*_, held, loads) in zip(expected, shells, strict=True):
        found = driven_motion(held, loads)
        assert (found is None) == (before is None)
        for motion in (before, found):
            if motion is None:
                continue
            far = held.furthest(motion)
            rows, count = held.rows @ motion / far, len(held.conditions)
            slides = np.linalg.norm(
                rows[count:][: 2 * len(held.conditions.rough)].reshape(-1, 2), axis=1
            )
            worst = rows[:count].max()
            if len(slides):
                rough = held.conditions.rough
                worst = max(worst, (rows[rough] + held.conditions.friction[rough] * slides).max())
            assert loads @ motion / far > bearing.LIMIT * np.linalg.norm(loads) * max(worst, 0.0)


def test_what_is_told_where_no_state_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    """That no state was found is a finding, by which a case does not carry; it is no crash."""
    model, held, loads = rough_shell(1).loaded()
    assert respond(held, loads).moves is None
    monkeypatch.setattr(active_set, "find_contact", lambda *_: None)
    found = respond(held, loads)
    assert found.unknown
    assert found.moves is not None
    shape, forces = held.shape(found.moves), held.shape(loads)
    told = describe_motion(model, 0.0, shape, forces, unknown=True)
    assert told.in_words().startswith("may move under its loads: no state of sticking")
    (finding,) = against_motion(told)
    assert (finding.sign, finding.kind) == ("fails", "unknown")
