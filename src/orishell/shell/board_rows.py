"""What the verdict says of panels with a thickness: their boards, and the hinges of whole ones."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from orishell.conventions.quantities import plain, size
from orishell.conventions.row import About, Note, Row, Sign
from orishell.locking.report import HingedReport
from orishell.shell.board_warnings import SAW
from orishell.shell.report import Report


def board_rows(report: Report) -> Iterator[Row]:
    """What panels with a thickness are made of, and whether their boards meet."""
    panel = report.panel
    if panel is None:
        return
    corners = f", corners cut off at {panel.corners_cut} vertices" if panel.corners_cut else ""
    proved = "" if panel.path is None else "; none meet on the way (proved)"
    unit = report.unit
    thick = size(panel.thickness, unit)
    if panel.hinged is not None:
        arm = size(panel.hinged.longest_arm, unit, bound=True)
        text = f"{panel.boards}, whole, {thick} thick, on hinges up to {arm} off them"
        text += _in_pieces(panel.hinged, unit)
    else:
        back = size(panel.largest_setback, unit, bound=True)
        one = "" if panel.sides == "both" else f" on the {panel.sides} of a membrane"
        text = f"{panel.boards}{one}, of panels {thick} thick, set back by up to {back}"
    sign: Sign = "says" if panel.path is None else "holds"
    steep = ""
    if panel.steepest_chamfer is not None and is_noted(report, "chamfers"):
        sign = "warns"
        leans = plain(float(np.rad2deg(panel.steepest_chamfer)), 3)
        steep = (
            f"; chamfers lean by up to {leans} degrees, and saws tilt to {SAW}: boards on a "
            "membrane are cut square, and printed panels have any chamfer"
        )
    yield Row(sign, "boards", f"{text}{corners}{proved}{steep}")


def is_noted(report: Report, about: About) -> bool:
    """Whether a note of the report is about something."""
    return any(isinstance(note, Note) and note.about == about for note in report.warnings)


def _in_pieces(hinged: HingedReport, unit: str) -> str:
    """In how many pieces boards are, and how these meet."""
    joints = hinged.joints
    if joints is None:
        return ""
    cut, apart = size(joints.largest_cut, unit, bound=True), size(joints.open_max, unit, bound=True)
    return (
        f"; in {len(hinged.pieces)} pieces, cut back by up to {cut} along joints and up to "
        f"{apart} apart there at the target"
    )


def hinge_rows(report: Report) -> Iterator[Row]:
    """How many hinges whole boards have, and how exactly they must be in their places."""
    built, panel = report.quantities.built, report.panel
    if built is None or built.hinges is None or panel is None or panel.hinged is None:
        return
    bill, play = built.hinges, panel.hinged.play
    arms = ""
    if bill.arms:
        kinds = "one kind" if bill.arm_kinds == 1 else f"{bill.arm_kinds} kinds"
        arms = f"; {bill.on_arms} of them stand on {bill.arms} arms of {kinds}"
    length = size(bill.length, report.unit)
    yield Row("says", "hinges", f"{bill.count}, {length} in all, with {bill.screws} screws{arms}")
    end = "" if play.end.loop == play.target.loop else f", {plain(play.end.loop, 2)} mm in the pack"
    yield Row(
        "says",
        "play",
        "1 mm (rms) of hinge error opens up to "
        f"{plain(play.target.loop, 2)} mm at a vertex at the target{end}",
    )
