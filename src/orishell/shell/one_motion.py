"""Sheets of more motions than one: what is said of them, and changes that leave one, tried.

Limit: along a straight g without flaps in the sheet every row folds by itself. The shell is made,
its degrees of freedom are counted, and what is proved is proved of the one motion in which all of
it folds together.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

from orishell.conventions.errors import DesignError, InputError, Remedy, VerificationError
from orishell.conventions.formatting import rounded
from orishell.conventions.progress import Progress
from orishell.conventions.quantities import size
from orishell.conventions.record import record
from orishell.conventions.row import Row, Sign
from orishell.design_file import DesignFile
from orishell.design_file.tables import value_at
from orishell.motion.freedom import FreedomOfSheet

if TYPE_CHECKING:
    from orishell.shell.report import Report

PANELS = 6_000
"""Changes are tried until the shells made have so many panels together."""
LOOKING = "looking for what leaves one motion"
RISES = (0.05, 0.1)
"""How high g is bent over its length: the shares that are tried."""

Joins = Callable[[DesignFile, Progress], bool]
"""Makes the shell of a file, and says whether it has one motion."""


@record
class Joining:
    """A change that leaves a sheet one motion, tried through the whole design."""

    words: str  # what is done
    change: Remedy


def warn_of_freedom(freedom: FreedomOfSheet) -> list[str]:
    """What a user should know of a sheet that has more motions than one."""
    if freedom.one_motion:
        return []
    return [
        f"{freedom.in_words()}; what is said of its way (contact, ties, weight, ground, play) is "
        "true only where all of it folds together as designed, and its supports must hold the rest"
    ]


def find_joining(file: DesignFile, joins: Joins, progress: Progress) -> Joining | None:
    """The first of the changes that leave one motion, tried; None if none does.

    joins: Makes the shell of a file, and says whether it has one motion.
    """
    tried = 0
    for each in _candidates(file):
        try:
            changed = file.tried(each.change.changes)
            tried += changed.panel_count
            if tried > PANELS:
                return None
            if joins(changed, lambda share, _what: progress(share, LOOKING)):
                return each
        except (DesignError, InputError, VerificationError):
            continue
    return None


def _candidates(file: DesignFile) -> Iterator[Joining]:
    """Flaps in the sheet, a zigzag row, a curved g: what is least of a change first."""
    pattern, flat = file.pattern, file.deployment.start == "flat"
    if flat and file.deployment.flap_attachment == "clipped":
        yield Joining("flaps folded on", Remedy({"deployment.flap_attachment": "folded"}))
    if flat and getattr(pattern, "flap", None) == 0:
        yield Joining("flaps folded on", Remedy({"pattern.flap": "auto"}))
    if getattr(pattern, "row", "zigzag") != "zigzag":
        yield Joining("a zigzag row", Remedy({"pattern.row": "zigzag"}))
    formula = value_at(file.tables, "target.g.formula")
    if isinstance(formula, str) and not value_at(file.tables, "target.g.scale"):
        g = file.g
        for share in RISES:
            low, high = g.drawn_part(g.start, g.stop)
            rise = rounded(share * (high - low))
            over = rounded(4 * rise / (high - low) ** 2)
            bent = f"{formula} + {over:g}*(x - {low:g})*({high:g} - x)".replace("- -", "+ ")
            yield Joining(
                f"g bent by {size(rise, file.unit)} at its middle",
                Remedy({"target.g.formula": bent}),
            )
    if not flat and "flap" in type(pattern).model_fields:
        yield Joining(
            "flaps folded on, folded up from flat",
            Remedy({"deployment.from": "flat", "deployment.ties": "none"}),
        )


def of_one_motion(report: Report, rows: Iterable[Row]) -> Iterator[Row]:
    """Rows that rest on one motion; where there are several, they speak of one of them only."""
    for row in rows:
        if report.freedom.one_motion:
            yield row
        else:
            sign: Sign = "says" if row.sign == "holds" else row.sign
            yield replace(row, sign=sign, finding=f"along one of its motions: {row.finding}")


def folds_rows(report: Report, way: Iterable[Row], joining: Joining | None) -> Iterator[Row]:
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
            words = f"with {joining.words}: one motion (tried)"
            found = replace(found, remedy=words, changes=joining.change.changes)
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
