"""Sector angles and the lengths of a row and a column, with no target: what they fold, and when
lengths make no sheet, that what is offered makes one."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from orishell.conventions.errors import DesignError, InputError
from orishell.conventions.record import as_table
from orishell.design import Design
from orishell.deviation import measure_deviation
from orishell.document.from_design import document_of_motion
from orishell.families.longitudinal_linear_repeating import (
    LongitudinalPattern,
    Sectors,
    design_longitudinal_linear_repeating,
    find_solutions,
)
from orishell.locking import end_motion, find_lock
from orishell.motion import FoldingMotion
from orishell.shell.pictures import lay_surface
from orishell.verification.residuals import measure_residuals
from samples import examples, led_by, thorough
from strategies import graph

PAPER = Sectors.from_degrees([85, 80, 95, 100])
ROW = [1.4, 0.23, 1.0, 1.9] * 2
"""geometry.md section 5: over 5 x 9, with equal lengths down column 1, the radius is 0.6-fold."""


def design(**options: Any) -> Design:
    asked: dict[str, Any] = {"rows": 5, "columns": 9, "sector_deg": PAPER.degrees, **options}
    return design_longitudinal_linear_repeating(None, None, LongitudinalPattern(**asked))


def paper(**options: Any) -> Design:
    return design(row_lengths=ROW, column_lengths=[1.0] * 6, **options)


def refusal(**options: Any) -> DesignError:
    with pytest.raises(DesignError) as caught:
        design(**options)
    return caught.value


def require_rigid(made: Design, frames: int = 9) -> None:
    motion = FoldingMotion(made.mechanism, frames)
    residuals, assignment = measure_residuals(motion, motion.flat)
    assert residuals.panel_length <= 1e-12
    assert residuals.planarity <= 1e-12
    assert residuals.sector_sum_rad <= 1e-9
    assert residuals.fold_angle_rad <= 1e-9
    assert assignment.constant
    assert assignment.maekawa


def test_the_papers_angles_and_lengths() -> None:
    made = paper()
    require_rigid(made)
    flat = made.mechanism.positions(0.0)
    row = np.linalg.norm(np.diff(flat[3, 1:-1], axis=0), axis=-1)
    np.testing.assert_allclose(row, ROW, rtol=1e-12)  # lengths, not ratios
    column = np.linalg.norm(np.diff(flat[:, 1], axis=0), axis=-1)
    np.testing.assert_allclose(column, 1, rtol=1e-12)
    assert made.parameters["motion_end_deg"] == pytest.approx(119.7471, abs=1e-4)
    design_, lock = end_motion(made)
    # Figure 3(b): the radius goes from r to 1.67 r.
    assert design_.parameters["radius_growth"] == pytest.approx(1 / 1.67, abs=0.01)
    assert lock.cause == "clash"


def test_the_last_frame_is_where_panels_first_touch() -> None:
    made = paper()
    found = find_lock(made)
    assert found.first_contact is not None
    ended, lock = end_motion(made)
    assert not lock.early
    assert lock.target_drive == ended.mechanism.target_drive == found.first_contact.clear_until
    step = found.first_contact.drive - lock.target_drive
    assert 0 < step < 1e-9
    assert as_table((lock.path, lock.first_contact)) == as_table((found.path, found.first_contact))
    assert ended.parameters["stage_deg"] == pytest.approx(np.rad2deg(lock.target_drive), abs=1e-9)
    require_rigid(ended)


@pytest.mark.parametrize(
    ("size", "first_row"),
    led_by(
        [
            *[((1, 2), "F"), ((1, 7), "S"), ((2, 4), "F"), ((4, 3), "S"), ((5, 9), "F")],
            *[((1, 2), "S"), ((1, 7), "F"), ((2, 4), "S"), ((4, 3), "F"), ((5, 9), "S")],
        ],
        5,
    ),
)
def test_stands_as_an_arch_along_x(size: tuple[int, int], first_row: str) -> None:
    ended, _ = end_motion(design(rows=size[0], columns=size[1], first_row=first_row))
    shell = ended.mechanism.positions(ended.mechanism.target_drive)
    middle = len(shell) // 2
    np.testing.assert_allclose(shell[middle, 1:-1].mean(axis=0), 0, atol=1e-12)
    along = shell[middle, -2] - shell[middle, 1]
    np.testing.assert_allclose(along[1:], 0, atol=1e-12)
    assert along[0] > 0
    down = (shell[middle + 1] - shell[middle - 1])[1:-1].mean(axis=0)
    assert down[2] == pytest.approx(0, abs=1e-12)
    beside = shell[[middle - 1, middle + 1], 1:-1].mean(axis=0) - shell[middle, 1:-1]
    assert beside[:, 2].mean() < 1e-12
    assert np.ptp(ended.mechanism.positions(0.0)[..., 2]) < 1e-12


def test_both_lengths_auto_have_a_mean_column_crease_of_1() -> None:
    made = design()
    flat = made.mechanism.positions(0.0)
    inner = np.linalg.norm(np.diff(flat[1:-1, 1:-1], axis=0), axis=-1)
    assert inner.mean() == pytest.approx(1, rel=1e-12)


@pytest.mark.parametrize("given", [{"row_lengths": ROW}, {"column_lengths": [2.0] * 6}])
def test_one_length_given(given: dict[str, list[float]]) -> None:
    made = design(**given)
    require_rigid(made)
    for key, lengths in given.items():
        found = np.asarray(made.parameters[key], float)
        np.testing.assert_allclose(found, lengths, rtol=1e-12)


@pytest.mark.parametrize("first_row", ["F", "S"])
@pytest.mark.parametrize("size", [(1, 3), (2, 2), pytest.param((3, 3), marks=thorough)])
def test_the_sine_version_of_the_papers_angles(first_row: str, size: tuple[int, int]) -> None:
    made = design(rows=size[0], columns=size[1], solution=1, first_row=first_row)
    assert made.parameters["version"] == "sine"
    assert "radius" not in made.parameters
    ended, _ = end_motion(made)
    require_rigid(ended)


@settings(max_examples=examples(25))
@given(
    st.lists(st.floats(75, 105).map(lambda x: round(x, 2)), min_size=4, max_size=4),
    st.sampled_from(["F", "S"]),
    st.sampled_from([(1, 2), (2, 3), (3, 4)]),
)
def test_any_listed_solution(degrees: list[float], first_row: str, size: tuple[int, int]) -> None:
    sectors = Sectors.from_degrees(degrees)
    for number in range(len(find_solutions(sectors))):
        asked = {"rows": size[0], "columns": size[1], "first_row": first_row}
        try:
            made = design(sector_deg=sectors.degrees, solution=number, **asked)
        except DesignError:
            continue
        ended, lock = end_motion(made)
        assert not lock.early
        require_rigid(ended, 4)


def test_a_given_stage() -> None:
    made = paper(stage_deg=5)
    ended, lock = end_motion(made)
    assert ended is made
    assert made.parameters["stage_deg"] == 5
    assert lock.drive is not None
    assert lock.drive > lock.target_drive == made.mechanism.target_drive


def test_panels_that_meet_before_a_given_stage() -> None:
    with pytest.raises(DesignError, match="meet before the shell reaches its stage") as caught:
        end_motion(paper(stage_deg=20))
    stage = float(values(caught.value, "stage_deg")[0])
    works = paper(stage_deg=stage)
    assert not end_motion(works)[1].early
    farther = paper(stage_deg=1.002 * stage)
    assert end_motion(farther, allow_clash=True)[1].early


def test_a_stage_beyond_the_end_of_the_motion() -> None:
    with pytest.raises(DesignError, match="beyond the end") as caught:
        paper(stage_deg=np.rad2deg(2.2))
    made_end = float(str(paper().parameters["motion_end_deg"]))
    *near, auto = values(caught.value, "stage_deg")
    assert auto == "auto"
    assert max(near) < made_end


def values(error: DesignError, key: str) -> list[Any]:
    """Values that a refusal's candidates have at a key."""
    changes = (each.changes for each in error.candidates)
    return [each[f"pattern.{key}"] for each in changes if f"pattern.{key}" in each]


def test_the_smallest_stages() -> None:
    for stage in (1e-9, 1e-12, 1e-300):
        with pytest.raises(DesignError, match="leaves creases unfolded") as caught:
            paper(stage_deg=np.rad2deg(stage))
        offered = values(caught.value, "stage_deg")[0]
        require_rigid(paper(stage_deg=offered), 2)


def test_lengths_that_make_no_sheet() -> None:
    long = [8 * each for each in ROW]
    error = refusal(row_lengths=long, column_lengths=[1.0] * 6)
    assert "the shortest crease would be -" in error.size
    fits = values(error, "row_lengths")[0]
    np.testing.assert_allclose(np.array(fits) / fits[0], np.array(long) / long[0], rtol=1e-7)
    require_rigid(design(row_lengths=fits, column_lengths=[1.0] * 6))


@pytest.mark.parametrize(
    "given",
    [
        {"row_lengths": [*ROW[:-1], 500.0]},
        {"column_lengths": [1.0, 1e4, 1.0, 1.0, 1.0, 1.0]},
        {"row_lengths": [*ROW[:-1], 500.0], "column_lengths": [1.0] * 6},
        {"row_lengths": [*ROW[:-1], 5e3], "column_lengths": [1.0, 1e4, 1.0, 1.0, 1.0, 1.0]},
    ],
)
def test_offers_make_a_sheet(given: dict[str, list[float]]) -> None:
    error = refusal(**given)
    assert "make no sheet" in error.condition
    works = []
    for remedy in error.candidates:
        changes = {key.removeprefix("pattern."): value for key, value in remedy.changes.items()}
        try:
            works.append(design(**{**given, **changes}))
        except DesignError:
            continue
    assert works
    require_rigid(works[0])


def test_half_a_target() -> None:
    with pytest.raises(InputError, match="belong together"):
        design_longitudinal_linear_repeating(
            graph("-x**2", -1, 1),
            None,
            LongitudinalPattern(rows=3, columns=3, sector_deg=PAPER.degrees),
        )


def test_there_is_nothing_to_compare_it_with() -> None:
    made = paper()
    with pytest.raises(InputError, match="without a target has no surface"):
        measure_deviation(made)
    assert (made.swept, made.targets, made.closeness) == (None, {}, {})
    document = document_of_motion(FoldingMotion(made.mechanism, 3), "m")
    assert lay_surface(document, made) is document


def test_sector_angles_auto_and_couplings() -> None:
    require_rigid(design(rows=9, columns=12, sector_deg="auto"))
    require_rigid(design(couplings=["parallel", "solve"] * 4))


def test_a_small_stage_takes_no_more_states_to_examine() -> None:
    # The sheet turns by as much on the way to a small stage: beyond it, that would be many turns.
    lengths = [1.79, 1.21, 1.48, 0.55]
    sectors = Sectors.from_degrees([93.05, 93.24, 90.47, 92.92])
    for stage in (1e-4, 1e-1):
        asked = {"rows": 3, "columns": 5, "sector_deg": sectors.degrees, "first_row": "S"}
        proof = find_lock(design(row_lengths=lengths, stage_deg=np.rad2deg(stage), **asked)).path
        assert proof is not None
        assert proof.states < 100


def test_panels_too_slender_for_rounding() -> None:
    # The sum of alpha and beta settles x = gamma_1 + delta_2, and alpha_2 = x - beta_1: so that it
    # comes as near to 180 degrees as one likes. `orishell solve` lists it all the same.
    degrees = np.array([108.1, 54.6, 127.9651, 46.4214])
    given = find_solutions(Sectors.from_degrees(degrees))[0].second.degrees[0]

    def sectors(alpha_2: float) -> Sectors:
        return Sectors.from_degrees(degrees + (alpha_2 - given) * np.array([1, -1, 0, 0]))

    near = find_solutions(sectors(180 - 1e-7))[0].second.degrees[0]
    assert near == pytest.approx(180 - 1e-7, abs=1e-12)
    assert "slender" in refusal(rows=2, columns=3, sector_deg=sectors(180 - 1e-7).degrees).condition
    require_rigid(design(rows=2, columns=3, sector_deg=sectors(179).degrees))


@pytest.mark.parametrize("flap", [1e30, 1e200, 1e-30])
def test_flaps_beyond_what_numbers_hold_are_refused_without_a_warning(flap: float) -> None:
    assert "not convex" in refusal(rows=3, columns=3, flap=flap).condition
