"""Sheets of more motions than one: what is said of them, and changes that leave one, tried.

Limit: along a straight g without flaps in the sheet every row folds by itself. The shell is made,
its degrees of freedom are counted, and what is proved is proved of the one motion in which all of
it folds together.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

from orishell.conventions.errors import Remedy
from orishell.conventions.formatting import rounded
from orishell.conventions.progress import Progress
from orishell.conventions.quantities import size
from orishell.conventions.row import Row, Sign
from orishell.design_file import DesignFile
from orishell.design_file.tables import value_at
from orishell.motion.freedom import FreedomOfSheet, find_freedom_of_sheet
from orishell.shell.designed import designed
from orishell.shell.instead import first_that_does, trying

if TYPE_CHECKING:
    from orishell.shell.report import Report

PANELS = 1_500
"""Changes are tried until the shells made have so many panels together."""
FOLDED_ON = "flaps folded on"
RISES = (0.05, 0.1)
"""How high g is bent over its length: the shares that are tried."""


def warn_of_freedom(freedom: FreedomOfSheet) -> list[str]:
    """What a user should know of a sheet that has more motions than one."""
    if freedom.one_motion:
        return []
    return [
        f"{freedom.in_words()}; what is said of its way (contact, ties, weight, ground, play) is "
        "true only where all of it folds together as designed, and its supports must hold the rest"
    ]


def find_joining(file: DesignFile, progress: Progress) -> Remedy | None:
    """The first of the changes that leave one motion, tried; None if none does."""
    work = trying(progress, "looking for what leaves one motion")

    def may(changed: DesignFile) -> bool:
        design = designed(changed)  # flaps of another width are counted as these are
        return find_freedom_of_sheet(design.mechanism, design.hinges).one_motion

    return first_that_does(
        file,
        _candidates(file),
        lambda made: made.found.freedom.one_motion,
        work,
        panels=PANELS,
        may=may,
    )


def _candidates(file: DesignFile) -> Iterator[Remedy]:
    """Flaps in the sheet, a zigzag row, a curved g: what is least of a change first."""
    pattern, flat = file.pattern, file.deployment.start == "flat"
    if flat and file.deployment.flap_attachment == "clipped":
        yield Remedy({"deployment.flap_attachment": "folded"}, FOLDED_ON)
    if flat and getattr(pattern, "flap", None) == 0:
        yield Remedy({"pattern.flap": "auto"}, FOLDED_ON)
    if getattr(pattern, "row", "zigzag") != "zigzag":
        yield Remedy({"pattern.row": "zigzag"}, "a zigzag row")
    formula = value_at(file.tables, "target.g.formula")
    if isinstance(formula, str) and not value_at(file.tables, "target.g.scale"):
        g = file.g
        for share in RISES:
            low, high = g.drawn_part(g.start, g.stop)
            rise = rounded(share * (high - low))
            over = rounded(4 * rise / (high - low) ** 2)
            bent = f"{formula} + {over:g}*(x - {low:g})*({high:g} - x)".replace("- -", "+ ")
            words = f"g bent by {size(rise, file.unit)} at its middle"
            yield Remedy({"target.g.formula": bent}, words)
    if not flat and "flap" in type(pattern).model_fields:
        folded_up = {"deployment.from": "flat", "deployment.ties": "none"}
        yield Remedy(folded_up, f"{FOLDED_ON}, folded up from flat")


def of_one_motion(report: Report, rows: Iterable[Row]) -> Iterator[Row]:
    """Rows that rest on one motion; where there are several, they speak of one of them only."""
    for row in rows:
        if report.freedom.one_motion:
            yield row
        else:
            sign: Sign = "says" if row.sign == "holds" else row.sign
            yield replace(row, sign=sign, finding=f"along one of its motions: {row.finding}")


def folds_rows(report: Report, way: Iterable[Row], joining: Remedy | None) -> Iterator[Row]:
    """Whether it folds in one motion, and what becomes of it on the way of that."""
    for row in way:
        if row.sign == "fails":
            yield row
            continue
        if report.freedom.one_motion:
            pieces = len(report.deployment.pieces) > 1
            one = "each piece in one motion: " if pieces else "in one motion: "
            known = "" if report.feasible is None else one
            yield replace(row, finding=f"{known}{row.finding}")
            continue
        said = f"{report.freedom.in_words()}; along one of its motions: {row.finding}"
        found = Row("warns", "folds", said)
        if joining is not None:
            words = f"with {joining}: one motion (tried)"
            found = replace(found, remedy=words, changes=joining.changes)
        yield found


def held_of_several(report: Report, stops: Mapping[str | None, str]) -> str:
    """What keeps a shell that has more motions than one at its target.

    stops: What is said of each cause that stops it closing.
    """
    held = report.deployment
    several = "all of its motions"
    if report.degrees_of_freedom is not None and report.degrees_of_freedom > 1:
        several = f"all {report.degrees_of_freedom} of its motions"
    closing = "only its supports stop them closing"
    if report.lock.closes_to <= report.lock.target_drive or held.flap_attachment == "clipped":
        closing = f"not known whether anything stops {several} closing"
    if held.closing is not None:
        closing = f"{stops[held.closing]}, in {several}"
    opening = "only its supports stop them opening"
    if held.ties:
        many = len(held.ties)
        opening = f"not known whether {many} ties stop them opening, and are slack before"
    return f"{closing}; {opening}"
