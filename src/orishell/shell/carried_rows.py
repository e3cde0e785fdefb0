"""What the verdict says of what the sheet carries: box girders, or a second skin."""

from __future__ import annotations

from collections.abc import Iterator

from orishell.conventions.formatting import rounded_down
from orishell.conventions.quantities import plain, size
from orishell.conventions.row import Row
from orishell.locking.result import BoxMotion, CarriedMotion, SkinMotion
from orishell.shell.drives import degrees_below
from orishell.shell.report import Report

MEANT = 1 + 1e-9
"""Lengths that are short of another by no more than rounding are as long."""


def carried_rows(report: Report) -> Iterator[Row]:
    """How far the shell moves with what its sheet carries."""
    boxes, skin = report.lock.boxes, report.lock.skin
    if boxes is not None:
        yield _row(report, boxes, "girders", _girders(boxes))
    if skin is not None:
        yield _row(report, skin, "skin", _skin(skin, report))


def _row(report: Report, found: CarriedMotion, subject: str, said: str) -> Row:
    late = found.joined_from > 0
    joined = said + (f", joined at {degrees_below(found.joined_from)}" if late else "")
    if not found.proofs:
        return Row("warns", subject, f"{joined}: nobody looked whether panels meet on the way")
    end = degrees_below(report.deployment.end_drive)
    states = sum(each.states for each in found.proofs)
    begin = "there" if late else "0"
    proved = f"nothing touches from {begin} to {end} (proved between {states} states)"
    why = ", as there is no room when it is flat" if late else ""
    return Row("holds", subject, f"{joined}{why}: {proved}")


def _girders(found: BoxMotion) -> str:
    rows = ", ".join(map(str, found.rows))
    return f"over row{'s' * (len(found.rows) > 1)} {rows}"


def _skin(found: SkinMotion, report: Report) -> str:
    unit, walls, clear = report.unit, len(found.walls), ""
    if report.panel is not None:
        between = size(rounded_down(MEANT * (found.gap - report.panel.thickness), 3), unit)
        clear = f", {between} between boards"
    cells = f" and {found.cells} cells of {plain(found.volume, 3)} {unit}3" if found.cells else ""
    return (
        f"{size(rounded_down(MEANT * found.gap, 3), unit)} from the sheet at the least{clear}, on "
        f"{walls} wall{'s' * (walls > 1)}{cells}"
    )
