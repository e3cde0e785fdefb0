"""What claims rest on is asked for: sheets and ties of which more was said than held."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from command_line import orishell
from concave_sheets import panels_through
from orishell.clash import PathContact
from orishell.clash.body_path import BodySearch
from orishell.conventions.errors import ClashError, DesignError, InputError
from orishell.deployment.ties import Tie, find_ties
from orishell.design_file import check_design, read_design_file
from orishell.io import read_pattern
from orishell.locking import find_lock
from orishell.locking.clipped import find_crossing
from orishell.locking.sheet import Sheet
from orishell.motion.layout import Layout
from orishell.shell import make_shell
from orishell.shell.designed import designed
from orishell.shell.open_questions import find_candidate
from orishell.shell.report import Report
from orishell.shell.steps import Step, Work
from orishell.shell.verdict import find_verdict
from orishell.structure.negligible import borne_by
from orishell.verification.pattern import FoldingMotion, judge_pattern
from orishell.verification.pattern.rows import Judged, said_of_motion
from samples import thorough

HERE = Path(__file__).parent / "preconditions"
EXAMPLES = Path(__file__).parents[2] / "examples"
Array = np.ndarray


def test_a_concave_panel_passes_through_none_that_is_opposite() -> None:
    """Panels 0 and 4 share a vertex, where 0 leaves its sector: they meet at 128.6 degrees."""
    file = HERE / "concave_pattern.toml"
    sheet = designed(read_design_file(file)).mechanism.least_turning
    flat, faces = sheet.positions(0.0).reshape(-1, 3), Layout.of(sheet).faces
    low, high = 0.0, np.deg2rad(140)
    for _ in range(30):  # the tests' own intersection
        middle = 0.5 * (low + high)
        met = panels_through(sheet.positions(middle).reshape(-1, 3), flat, faces)
        low, high = (low, middle) if len(met) else (middle, high)
    assert panels_through(sheet.positions(high).reshape(-1, 3), flat, faces).tolist() == [[0, 4]]
    assert np.rad2deg(high) == pytest.approx(128.609, abs=0.01)

    with pytest.raises(ClashError, match=r"panels \[0, 0\] and \[1, 1\] meet before") as refused:
        find_candidate(read_design_file(file), Work())
    assert "at drive 128.60" in refused.value.place
    offered = next(iter(refused.value.candidates)).changes["pattern.fold_deg"]
    assert isinstance(offered, float)
    assert offered < np.rad2deg(high)
    verdict = judge_pattern(read_pattern(HERE / "concave_pattern.fold"))
    said = next(row.finding for row in verdict.rows if row.subject == "reaches")
    assert said.startswith("128.6088 degrees: panels 0 and 4 meet there")
    assert said.endswith("nothing meets up to 128.6088 degrees (proved)")


@thorough
def test_what_is_offered_for_a_concave_panel_works(tmp_path: Path) -> None:
    done = orishell("design", HERE / "concave_pattern.toml", "--out", tmp_path / "out")
    assert done.returncode == 1
    offered = float(done.stderr.split("Nearest found that works: fold_deg = ")[1].split(". ")[0])
    assert 128 < offered < 128.609


def test_boards_on_a_concave_panel_are_refused_by_name(tmp_path: Path) -> None:
    done = orishell("design", HERE / "concave_boards.toml", "--out", tmp_path / "out")
    assert done.returncode == 1
    assert "panels with a thickness need a sheet of convex panels" in done.stderr
    assert "panel [0, 0] is concave" in done.stderr
    assert "its corner at vertex 0, 1 has 236.3 degrees" in done.stderr
    assert "Nearest" not in done.stderr
    hinged = read_design_file(HERE / "concave_boards.toml").changed(
        {"panel.construction": "hinged", "panel.membrane": None, "panel.membrane_density": None}
    )
    with pytest.raises(DesignError, match="need a sheet of convex panels"):
        designed(hinged)


def test_every_proof_of_bodies_asks_for_convex_panels() -> None:
    """The search itself, whoever calls it, and that of clipped flaps."""
    design = designed(read_design_file(HERE / "concave_pattern.toml"))
    unasked: Any = None  # bodies, of which there are none of a sheet that is refused
    with pytest.raises(DesignError, match="panels with a thickness need a sheet of convex panels"):
        BodySearch(design.mechanism, 1.0, 1e-9, unasked)
    with pytest.raises(DesignError, match="clipped flaps need a sheet of convex panels"):
        find_crossing(Sheet.of(design), 1e-9)


def test_panels_that_lie_on_each_other_in_the_flat_sheet_are_refused(tmp_path: Path) -> None:
    """Neighbours are never compared: that they lie beside each other is asked when read."""
    pattern = json.loads((HERE / "concave_pattern.fold").read_text())
    pattern["vertices_coords"][2] = [1.2, 0.3]
    (tmp_path / "lap.fold").write_text(json.dumps(pattern))
    tables = {
        "shell": {"family": "pattern", "unit": "m"},
        "target": {"pattern": "lap.fold"},
        "pattern": {"fold_deg": 90},
    }
    with pytest.raises(InputError, match="panels 0 and 1 lie on each other"):
        check_design(tables, tmp_path / "lap.toml")


def test_a_design_that_nothing_meets_in_is_not_ended_by_a_contact() -> None:
    lock = find_lock(designed(read_design_file(HERE / "false_alarm.toml")))
    assert (lock.cause, lock.early) == ("crease", False)
    assert lock.drive is not None
    assert np.rad2deg(lock.drive) == pytest.approx(180, abs=1e-3)


def test_a_pack_a_tenth_of_a_degree_away_says_so(tmp_path: Path) -> None:
    done = orishell("design", HERE / "fold_179_9.toml", "--out", tmp_path / "out")
    assert done.returncode == 1
    assert "the shell hardly closes beyond its target" in done.stderr
    assert "it closes from 179.9 to 180 degrees" in done.stderr
    assert "there panel [0, 0] and panel [1, 0] are folded onto each other" in done.stderr
    assert "meet there" not in done.stderr


def test_ties_that_stop_a_shell_short_are_refused_and_others_offered() -> None:
    """The feet are up to 2.532 apart on the way, and the ties 2.4906 long: own states say so."""
    file = read_design_file(HERE / "short_ties.toml")
    with pytest.raises(DesignError, match="11 of 11 ties are too short") as refused:
        find_candidate(file, Work())
    error = refused.value
    assert "rows 0 and 10 in column 0" in error.place
    assert "its ends are 2.532 apart there, and it is 2.4906 long" in error.size
    first = next(iter(error.candidates)).changes["deployment.ties"]
    assert first == [[[1, column], [9, column]] for column in range(11)]


@thorough
def test_ties_that_are_offered_are_slack_in_two_hundred_states() -> None:
    """Along the motion that was designed; of this sheet, which has nine, that is no proof."""
    file = read_design_file(HERE / "short_ties.toml")
    ties = [[[1, column], [9, column]] for column in range(11)]
    found = find_candidate(file.changed({"deployment.ties": ties}), Work())
    assert [tie.slack for tie in found.deployment.ties] == [None] * 11
    assert found.freedom.count == 9
    mechanism, limit = found.design.mechanism, found.lock.closes_to
    states = mechanism.positions(np.linspace(mechanism.target_drive, limit, 200))
    for tie in find_ties(mechanism, [((1, column), (9, column)) for column in range(11)], limit):
        assert tie.slack
        one, other = (states[:, row, column] for row, column in tie.ends)
        apart = np.linalg.norm(one - other, axis=-1)
        assert (np.diff(apart[:20]) < 0).all()
        assert (apart[1:] < tie.length).all()
    assert not find_ties(mechanism, [((0, 0), (10, 0))], limit)[0].slack


@pytest.fixture(scope="module")
def report() -> Report:
    skip: tuple[Step, ...] = ("remedies", "deviation", "stock", "verification", "pack")
    return make_shell(read_design_file(EXAMPLES / "figure1.toml"), skip=skip).report


@pytest.mark.parametrize(("slack", "sign"), [(True, "holds"), (False, "warns"), (None, "holds")])
def test_ties_that_are_not_proved_slack_are_no_pass(
    report: Report, slack: bool | None, sign: str
) -> None:
    tie = Tie(((0, 1), (10, 1)), 2.0, 2.2, 1.0, slack=slack)
    held = replace(
        report.deployment,
        ties=(tie, replace(tie, slack=slack or slack is not False)),
        opening="ties",
    )
    found = {row.subject: row for row in find_verdict(replace(report, deployment=held))}
    assert found["locks"].sign == sign


@pytest.mark.parametrize("beyond", [False, True])
def test_the_row_says_not_proved_and_how_far_apart(report: Report, beyond: bool) -> None:
    contact = report.lock.first_contact
    assert contact is not None
    drive = report.lock.target_drive * (1.01 if beyond else 0.5)
    near = replace(contact, drive=drive, clear_until=drive, apart=0.0123)
    lock = replace(report.lock, cause="unproved", first_contact=near)
    assert lock.early is not beyond
    assert lock.reaches_target is (True if beyond else None)
    changed = replace(report, lock=lock, feasible=lock.reaches_target)
    row = next(row for row in find_verdict(changed) if row.subject == "folds")
    assert row.sign == "warns"
    upto = "181.8" if beyond else "90"
    assert f"not proved beyond {upto} degrees" in row.finding
    assert "are 12.3 mm apart there and may meet" in row.finding
    assert ("beyond the target" in row.finding) is beyond
    assert ("short of the target at 180 degrees" in row.finding) is not beyond
    said = replace(report, lock=lock).as_dict()["lock"]
    assert isinstance(said, dict)
    assert (said["cause"], said["first_contact"]["apart"]) == ("unproved", 0.0123)


def test_a_check_says_not_proved_and_how_far_apart() -> None:
    findings = judge_pattern(read_pattern(HERE / "concave_pattern.fold")).findings
    assert findings is not None
    motion = findings.motion
    assert isinstance(motion, FoldingMotion)
    assert motion.proof is not None
    near = PathContact(1.5, 1.5, (3, 8), apart=0.0123)
    changed = replace(motion, proof=replace(motion.proof, contact=near))
    found = findings.pattern, "m", findings.conditions, findings.recognised, changed, 1e-6, 1e-9
    row = next(row for row in Judged(*found).rows() if row.subject == "reaches")
    assert row.sign == "warns"
    assert "not proved beyond 85.9437 degrees: panels 3 and 8" in row.finding
    assert "apart there and may meet; nothing meets up to 85.9437 degrees (proved)" in row.finding
    said = said_of_motion(changed)
    assert (said["first_contact"], said["contact_deg"]) == ([], None)
    assert said["not_proved"] == {"panels": [3, 8], "apart": 0.0123}


def test_panels_that_are_nothing_are_refused() -> None:
    tables = {
        "shell": {"family": "flat-foldable", "unit": "m"},
        "pattern": {"rows": 3, "columns": 3, "sheet": "miura", "growth": 1e-9, "fold_deg": 90},
    }
    with pytest.raises(DesignError, match="rounding of coordinates would bend it") as refused:
        designed(check_design(tables, Path("shell.toml")))
    assert [each.changes for each in refused.value.candidates] == [{"pattern.growth": 1.0}]


def test_forces_that_are_rounding_are_none() -> None:
    forces = np.array([2.6e-11, -3e-12, 0.5, 2e-6])
    np.testing.assert_array_equal(borne_by(forces, 1000.0), [0, 0, 0.5, 2e-6])
