"""Flaps stop as little short of folding flat as their boards allow."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from orishell.conventions.errors import DesignError, Value
from orishell.curves import curve_from_formulas, curve_from_points, parse_formula
from orishell.design import PanelSpec, Setback
from orishell.design_file import DesignFile, read_design_file
from orishell.families.parallel_repeating import ParallelRepeatingPattern, design_parallel_repeating
from orishell.motion import Mechanism
from orishell.motion.quads import lengths
from orishell.shell.make import Shell, make_shell
from orishell.shell.steps import MEASURES
from orishell.solids import find_stop, find_thickness_limit
from samples import examples, led_by, thorough
from strategies import Request, orthodiagonal_requests, requests

EXAMPLES = Path(__file__).parents[2] / "examples"
HUNDREDTH = np.deg2rad(0.01)


def taken(mechanism: Mechanism, build: PanelSpec) -> tuple[float, float]:
    """The largest share that set-backs of row creases take of a flap, and the longest of them.

    Panel by panel: a flap's panel has a closing crease at its top, at its bottom, or one of each
    on either face. It is as wide as its corners are from the opposite edge's line.
    """
    flat, grid = mechanism.positions(0.0), mechanism.grid
    fold = mechanism.fold_angles(mechanism.target_drive).row
    share, longest = 0.0, 0.0
    for column in mechanism.flap_columns:
        for row in range(grid.rows - 1):
            creases = [fold[k, column] for k in (row - 1, row) if 0 <= k < grid.rows - 2]
            for side in (1, -1):
                backs = [
                    max(build.height * np.tan(abs(f) / 2) if f * side > 0 else 0.0, build.gap / 2)
                    for f in creases
                ]
                share = max(share, sum(backs) / width(flat[row : row + 2, column : column + 2]))
                longest = max(longest, *backs)
    return share, longest


def width(panel: np.ndarray) -> float:
    """The shortest way from the upper to the lower edge of a panel (2, 2, 3)."""
    (a, b), (c, d) = panel
    ways = []
    for (start, end), others in (((a, b), (c, d)), ((c, d), (a, b))):
        way = (end - start) / np.linalg.norm(end - start)
        ways.append(min(float(lengths(np.cross(way, each - start))) for each in others))
    return min(ways)


@settings(max_examples=examples(30))
@given(
    st.one_of(requests(), orthodiagonal_requests()),
    st.floats(1e-4, 0.02),
    st.floats(0.2, 0.8),
    st.booleans(),
    st.floats(0.0, 3.0),
)
def test_a_stop_that_is_found_is_the_least_that_works(
    request: Request, size: float, share: float, limited: bool, gap: float
) -> None:
    mechanism = request.feasible().mechanism
    edge = float(np.median(lengths(np.diff(mechanism.positions(0.0), axis=0))))
    build = PanelSpec().replace_unchecked(
        thickness=size * edge,
        membrane=0.1 * size * edge,
        gap=gap * size * edge,
        largest_setback=Setback(share=share, length=0.1 * edge if limited else None),
    )
    try:
        stop = find_stop(mechanism, build)
    except DesignError:
        return
    if not mechanism.flap_columns:
        assert stop == 0
        return
    steps = stop / HUNDREDTH
    assert steps == pytest.approx(round(steps), abs=1e-9)
    assert steps >= 1
    took, longest = taken(mechanism.with_stop(stop), build)
    assert took <= share * (1 + 1e-12)
    assert longest <= build.setback * (1 + 1e-12)
    if steps > 1.5:
        took, longest = taken(mechanism.with_stop(stop - HUNDREDTH), build)
        assert took > share or longest > build.setback


def test_sheets_without_flaps_need_no_stop() -> None:
    file = read_design_file(EXAMPLES / "figure1.toml")
    mechanism = file.pattern.design(file.f, file.g).mechanism
    assert find_stop(mechanism.without_flaps(), PanelSpec(thickness=0.01, membrane=1e-3)) == 0


@pytest.mark.parametrize("gap", [0.0, 1e-4])
def test_flaps_beside_a_column_that_all_but_folds_flat_have_no_room(gap: float) -> None:
    # g's end is within 0.05 degrees of f's plane: flaps may stop by half of 0.004 degrees.
    f = curve_from_formulas(None, parse_formula("x"), 0, 1)
    end = np.deg2rad(-79.95)
    points = np.array([[0, 0], [1, 0], [1 + np.cos(end), np.sin(end)]])
    design = design_parallel_repeating(
        f,
        curve_from_points(points, smooth=False),
        ParallelRepeatingPattern(
            rows=1, columns=2, xi_deg=10, plane_deg=40, theta_deg=np.rad2deg(0.3), flap=0.1
        ),
    )
    with pytest.raises(DesignError, match="no thickness is small enough") as refused:
        find_stop(design.mechanism, PanelSpec(thickness=1e-3, membrane=1e-4, gap=gap))
    assert refused.value.excess is None


def example(figure: int) -> DesignFile:
    """A figure of the paper; the first with half its panels each way."""
    file = read_design_file(EXAMPLES / f"figure{figure}.toml")
    return file.changed({"pattern.rows": 5, "pattern.columns": 7}) if figure == 1 else file


def shell(figure: int, panel: PanelSpec, *, clipped: bool = False) -> Shell:
    file = example(figure)
    changes: dict[str, Value | None] = {
        "panel.thickness": panel.thickness,
        "panel.membrane": panel.membrane,
        "panel.gap": panel.gap,
        "panel.stop_deg": "auto" if panel.stop is None else float(np.rad2deg(panel.stop)),
        "deployment.flap_attachment": "clipped" if clipped else "folded",
    }
    return make_shell(file.changed(changes), skip=(*MEASURES, "stock"))


@pytest.mark.parametrize("figure", led_by([1, 2]))
@pytest.mark.parametrize("clipped", [False, True])
def test_shells_with_boards_on_their_flaps(figure: int, clipped: bool) -> None:
    """The target is met as without a thickness; folded flaps end the motion there."""
    panel = PanelSpec(thickness=0.01, membrane=2e-4)
    made = shell(figure, panel, clipped=clipped)
    file = example(figure)
    design = made.design
    flapped = design.clipped or design.mechanism
    stop = find_stop(flapped.with_stop(0.0), panel)
    assert design.parameters["stop_deg"] == pytest.approx(np.rad2deg(stop), rel=1e-12)
    assert taken(flapped, panel)[0] <= 0.5
    at_target = design.mechanism.positions(design.mechanism.target_drive)
    paper = file.pattern.design(file.f, file.g).mechanism
    there = paper.positions(paper.target_drive)[:, paper.inner_columns]
    found = at_target[:, design.mechanism.inner_columns]
    assert np.abs(found - there).max() < 1e-12
    assert made.report.residuals is not None
    assert made.report.residuals.panel_length < 1e-14
    assert made.report.residuals.fold_angle_rad < 1e-12
    if clipped:
        assert made.lock.cause != "flaps"
        return
    contact = made.lock.first_contact
    assert contact is not None
    assert (made.lock.cause, contact.kind) == ("flaps", "flap on flap")
    assert made.lock.drive == made.lock.target_drive == design.mechanism.target_drive
    assert design.mechanism.target_drive < design.mechanism.end_drive
    # The crease that is named folds most of those of the flaps.
    fold = np.abs(design.mechanism.fold_angles(made.lock.target_drive).row)
    (row, column), _ = contact.panels
    assert fold[row, column] == fold[:, list(design.mechanism.flap_columns)].max()
    assert fold[row, column] == pytest.approx(np.pi - 2 * stop, abs=1e-14)


def refusal(figure: int, panel: PanelSpec) -> DesignError:
    with pytest.raises(DesignError) as refused:
        shell(figure, panel)
    return refused.value


def offered(error: DesignError) -> dict[str, Any]:
    return {key: value for each in error.remedies for key, value in each.changes.items()}


@thorough
def test_a_stop_that_is_too_early_for_the_boards_is_refused() -> None:
    """Set-backs would be 0.005/tan(0.05 degrees) = 5.7: the crease of the flap is named."""
    error = refusal(2, PanelSpec(thickness=0.01, membrane=2e-4, stop_deg=0.05))
    assert "at the crease of row 5 between columns 0 and 1" in error.place
    assert error.remedies[0].changes == {"panel.stop_deg": "auto"}


@thorough
def test_a_stop_that_no_flap_can_have_is_refused() -> None:
    """Flaps of Figure 1 can stop short by less than half of its xi of 50 degrees."""
    error = refusal(1, PanelSpec(thickness=0.01, membrane=2e-4, stop_deg=30.0))
    assert error.keys == ("panel.stop_deg",)
    assert "the limit is 25, half" in error.size
    works = offered(error)["panel.stop_deg"]
    assert 0 < works < 25
    assert shell(1, PanelSpec(thickness=0.01, membrane=2e-4, stop_deg=works)).lock.cause == "flaps"


@pytest.mark.parametrize("figure", led_by([1, 2]))
def test_boards_too_thick_for_any_stop_are_refused(figure: int) -> None:
    """What is offered is the largest, but for a share of 0.99, that works in the whole design."""
    error = refusal(figure, PanelSpec(thickness=2.0, membrane=0.002))
    works = offered(error)["panel.thickness"]
    made = shell(figure, PanelSpec(thickness=works, membrane=0.002))
    assert made.lock.cause == "flaps"
    assert (
        find_thickness_limit(
            made.design.mechanism, PanelSpec().replace_unchecked(thickness=works)
        ).thickness
        >= works
    )


def test_panels_thinner_than_their_membrane_are_offered_with_a_thinner_one() -> None:
    """The membrane alone, a quarter of them, is thicker than panels of Figure 1 may be."""
    works = offered(refusal(1, PanelSpec(thickness=2.0, membrane=0.5)))
    assert works["panel.membrane"] == pytest.approx(0.25 * works["panel.thickness"], rel=1e-3)
    build = PanelSpec(thickness=works["panel.thickness"], membrane=works["panel.membrane"])
    assert shell(1, build).lock.cause == "flaps"


def test_a_gap_that_takes_too_much_is_named() -> None:
    error = refusal(1, PanelSpec(thickness=0.01, membrane=2e-4, gap=0.4))
    assert error.keys == ("panel.gap",)
    assert offered(error)["panel.gap"] < 0.4
