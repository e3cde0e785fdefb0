"""What the verdict says of walls that close the ends of a shell."""

from __future__ import annotations

from collections.abc import Iterator

from orishell.conventions.quantities import box, plain, size
from orishell.conventions.row import Row
from orishell.design.end_walls import BuiltEndWall
from orishell.shell.report import Report

OPEN = 0.05
"""A wall that is farther from a vertex of its border than this share of its height leaves a slit
that one sees, and that rain finds."""


def end_wall_rows(report: Report) -> Iterator[Row]:
    """How each end wall closes its end."""
    return (_row(each, report.unit) for each in report.end_walls)


def _row(wall: BuiltEndWall, unit: str) -> Row:
    strips = f"{wall.panels} strip{'s' * (wall.panels > 1)}"
    door = ""
    if wall.door is not None:
        door = f", with a door of {box((wall.door.width, wall.door.height), unit)}"
    low, high = (size(each, unit) for each in (wall.shortest_string, wall.longest_string))
    strings = f"strings of {low}" if low == high else f"strings of {low} to {high}"
    text = (
        f"the {wall.at} end, by a wall of {strips}, {box((wall.width, wall.height), unit)}{door}: "
        f"it stands on the ground, {size(wall.clearance, unit)} off the shell at the target, tied "
        f"to {wall.strings} vertices by {strings}, and bears nothing of its loads"
    )
    if wall.farthest > OPEN * wall.height:
        share = plain(100 * wall.farthest / wall.height, 2)
        return Row(
            "warns",
            "closed",
            f"{text}; between it and its border up to {size(wall.farthest, unit)} stay open, "
            f"{share} % of its height",
        )
    return Row("holds", "closed", text)
