"""What the report says of what was measured."""

from dataclasses import replace
from pathlib import Path

from orishell.design_file import read_design_file
from orishell.locking import find_lock
from orishell.motion import diagonal
from orishell.shell import make_shell
from orishell.shell.lock_report import describe_lock
from orishell.workshop import Workshop
from planted import clear


def test_what_the_report_says_of_a_lock() -> None:
    design = clear()
    said = describe_lock(find_lock(design))
    assert (said.drive_deg, said.cause, said.target_drive_deg) == (180, "flaps", 180)
    assert said.first_contact is not None
    assert said.first_contact.panels == ((0, 0), (1, 0))
    path = said.path
    assert path is not None
    assert path.states > 10
    assert path.ranges >= path.states - 1
    assert path.tests > design.mechanism.grid.panel_count
    assert 0 < path.smallest_step_deg <= path.largest_step_deg <= 180 / 8
    assert path.contact_tolerance == 1e-9 * diagonal(design.mechanism.positions(0.0))
    assert "acceleration" in path.bound


def test_the_report_says_what_was_left_out() -> None:
    file = read_design_file(Path(__file__).parents[2] / "examples" / "figure1.toml")
    file = replace(file, workshop=Workshop(stock=(6.0, 5.0)))
    report = make_shell(file, clash="unexamined", measured=False, nested=False).report
    assert (report.feasible, report.lock.path) == (None, None)
    assert report.deviation is not None
    assert (report.deviation.surface, report.quantities.stock) == (None, None)
    assert report.not_checked == (
        "contact between panels on the way",
        "distance from the surface",
        "the layout on the stock",
    )
