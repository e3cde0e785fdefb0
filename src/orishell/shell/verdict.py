"""The verdict on a shell: independent findings, worst first, for terminal, report and pages."""

from __future__ import annotations

from collections.abc import Iterator

from orishell.conventions.errors import Remedy
from orishell.conventions.quantities import box, plain
from orishell.conventions.row import ORDER, Note, Row, Sign
from orishell.deployment.report import DeploymentReport
from orishell.deployment.verdict import air_rows, feet_rows, ground_rows, weight_rows
from orishell.design.design import Fixing
from orishell.deviation.report import surface_rows
from orishell.document.sizes import size_rows
from orishell.locking import Contact
from orishell.shell.board_rows import board_rows, hinge_rows
from orishell.shell.carried_rows import carried_rows
from orishell.shell.drives import degrees_below
from orishell.shell.end_wall_rows import end_wall_rows
from orishell.shell.not_proved import not_proved
from orishell.shell.one_motion import folds_rows, held_of_several, of_one_motion
from orishell.shell.report import Report
from orishell.shell.steps import (
    CONTACT,
    END_WALLS_PLACED,
    FLAPS_PLACED,
    GUSSETS_PLACED,
    PLATES_PLACED,
    STOCK,
    STRUCTURE,
)
from orishell.shell.two_thicknesses import TwoThicknesses, thickness_rows
from orishell.workshop.order_row import order_in_words

SAID = {
    CONTACT,
    STOCK,
    STRUCTURE,
    FLAPS_PLACED,
    GUSSETS_PLACED,
    PLATES_PLACED,
    END_WALLS_PLACED,
}
"""What other rows say, or the booklet."""
SAME = 1e-6
"""Drives that differ by less than this share are the same."""
SLIM = 0.03
"""A pack less high than this share of its length is a bundle, whose layers count."""
CLOSING = {
    "flaps": "its flaps stop it closing",
    "clipped flaps": "flaps clipped on stop it closing",
    "gussets": "gussets stop it closing",
    "plates": "plates in its box girders stop it closing",
    "crease": "a crease folded flat stops it closing",
    "clash": "panels that meet stop it closing",
    "hinges": "its hinges stop it closing",
    "boards": "the thickness of its boards stops it closing",
    "unproved": "only its supports stop it closing",
    None: "only its supports stop it closing",
}


def find_verdict(
    report: Report,
    stronger: Remedy | None = None,
    stock: tuple[float, float] | None = None,
    joining: Remedy | None = None,
    two: TwoThicknesses | None = None,
) -> tuple[Row, ...]:
    """The findings of a report, worst first.

    stronger: What has it carry its loads, or makes known whether it does, which has been tried.
    stock: Size of the sheets that it is cut from, where they are known.
    joining: What leaves a sheet one motion that has several, which has been tried.
    two: The thickness that only its structure has.
    """
    rows = [
        *_stands(report, stronger or Remedy({})),
        *_deep(report),
        *folds_rows(report, _way(report), joining),
        *carried_rows(report),
        *_locks(report),
        *_packs(report, said=two is not None),
        *_fits(report, stock),
        *order_in_words(report.quantities.order),
        *_unchecked(report),
        *of_one_motion(report, board_rows(report)),
        *thickness_rows(report, two),
        *of_one_motion(report, hinge_rows(report)),
        *end_wall_rows(report),
        *(
            ()
            if report.deviation is None
            else feet_rows(report.stands, report.unit, on_f=report.deviation.f is not None)
        ),
        *surface_rows(report.deviation, report.unit),
        *(() if report.families is None else report.families.rows(report.unit)),
        *(() if report.turned is None else report.turned.rows(report.unit)),
        *(() if report.fitted is None else report.fitted.rows(report.unit)),
        *_sizes(report),
        *of_one_motion(report, weight_rows(report.deployment)),
        *of_one_motion(report, air_rows(report.deployment)),
        *of_one_motion(report, () if report.cutting is None else report.cutting.rows(report.unit)),
        *of_one_motion(
            report, ground_rows(report.deployment, report.quantities.carried_by, report.unit)
        ),
    ]
    return tuple(sorted(rows, key=lambda row: ORDER.index(row.sign)))


def _stands(report: Report, stronger: Remedy) -> Iterator[Row]:
    """Whether the shell carries its load cases, and what codes ask beyond these."""
    structure = report.structure
    if structure is not None:
        yield Row(structure.sign, "stands", structure.in_words(), str(stronger), stronger.changes)
        yield Row("says", "codes", structure.asks_in_words())
    elif STRUCTURE in report.not_checked:
        yield Row("warns", "stands", "not known: the structure was not analysed", known=False)


def _deep(report: Report) -> Iterator[Row]:
    """Folds that are deep in a shell of its height: what its note says, before all that holds."""
    for note in report.warnings:
        if isinstance(note, Note) and note.about == "depth":
            yield Row("warns", "depth", str(note))


def _way(report: Report) -> Iterator[Row]:
    """Whether panels meet before the shell stands at its target, and what is proved beyond."""
    lock, aim = report.lock, "stage" if report.deviation is None else "target"
    contact = lock.first_contact
    proved = "" if lock.path is None else f" (proved between {lock.path.states} states)"
    if contact is not None and contact.apart is not None:
        angles = (
            degrees_below(contact.clear_until, lock.target_drive),
            degrees_below(lock.target_drive),
        )
        said = not_proved(lock, contact, angles, (_panels_of(contact), aim), report.unit)
        yield Row("warns", "folds", f"{said}{proved}")
        return
    if report.feasible is None:
        said = "not known: nobody looked whether panels meet on the way"
        yield Row("warns", "folds", said, known=False)
        return
    if contact is not None and lock.cause in ("clash", "boards"):
        angle = degrees_below(contact.drive, lock.target_drive)
        meets = f"{_panels_of(contact)} meet at {angle} ({contact.kind})"
        if contact.drive < lock.target_drive:
            short = f"short of the {aim} at {degrees_below(lock.target_drive, contact.drive)}"
            yield Row("fails", "folds", f"no: {meets}, {short}")
        else:
            there = contact.drive <= lock.target_drive * (1 + SAME)
            beyond = "" if there else f", beyond the {aim}"
            yield Row("holds", "folds", f"nothing touches before {meets}{beyond}{proved}")
    elif lock.path is not None:
        end = degrees_below(report.deployment.end_drive)
        begin = "open" if report.sheet.strips else "flat"
        yield Row("holds", "folds", f"nothing touches from {begin} to {end}{proved}")
    else:
        yield Row("holds", "folds", "no contact to look for")


def _panels_of(contact: Contact) -> str:
    if contact.called is not None:
        return " and ".join(contact.called)
    sides = contact.sides or ("", "")
    first, second = (
        f"{list(panel)}{f' {side}' if side in {'top', 'bottom'} else ''}"
        for panel, side in zip(contact.panels, sides, strict=True)
    )
    return f"panels {first} and {second}"


def _locks(report: Report) -> Iterator[Row]:
    """What keeps the shell at its target."""
    if report.feasible is False:
        return
    held, lock = report.deployment, report.lock
    where = f"at {degrees_below(lock.target_drive)}"
    if lock.clipped_contact is not None:
        panels = _panels_of(lock.clipped_contact)
        yield Row("fails", "locks", f"no: {panels} meet when flaps are clipped on {where}")
        return
    if held.fixed_by is not None:
        yield Row("holds", "locks", f"{where}: {_fixed(held, held.fixed_by)}")
        return
    slack = sum(tie.slack is True for tie in held.ties)
    known = "all" if slack == len(held.ties) else str(slack)
    before = f"{known} proved slack from the pack to there"
    if held.ties and all(tie.slack is None for tie in held.ties):
        before = "fixed when its pieces are joined"
    opening = (
        f"{len(held.ties)} ties stop it opening ({before})"
        if held.opening == "ties"
        else "only its supports stop it opening"
    )
    # Half a lock is none: what own weight keeps from moving is held until wind lifts it.
    sign: Sign = "warns" if held.left_to_supports else "holds"
    if any(tie.slack is False for tie in held.ties):
        sign = "warns"  # what is not proved slack may stop it short, or hold nothing
    text = f"{CLOSING[held.closing]}; {opening}"
    if not report.freedom.one_motion:
        yield Row("warns", "locks", f"{where}: {held_of_several(report, CLOSING)}")
        return
    if held.closing is None and held.opening is None:
        text = "only its supports stop it closing and opening"
    subject = "held" if held.closing is None and held.opening is not None else "locks"
    yield Row(sign, subject, f"{where}: {text}")


def _fixed(held: DeploymentReport, by: Fixing) -> str:
    """What gussets, or plates in box girders, do that keep the whole shell still."""
    count, what = (held.gussets, "gusset") if held.gussets else (held.plates, "plate")
    if count == 1:
        return f"a {what} stops it closing and opening"
    each = "each of them by itself" if by == "any" else "all of them together"
    return f"{count} {what}s stop it closing and opening, {each}"


def _packs(report: Report, *, said: bool) -> Iterator[Row]:
    """How small it is before it opens, where it opens from a pack.

    said: Whether it is only said, as panels are thicker under loads than they are there.
    """
    deployment, unit = report.deployment, report.unit
    packed = deployment.packed
    if deployment.start != "pack" or report.feasible is False:
        return
    if packed is None:
        yield Row("warns", "packs", "not known: its pack was not measured", known=False)
        return
    # Of panels without thickness a flat pack has no height: its layers count.
    flat = packed.height < SLIM * packed.length
    sides = (packed.length, packed.width, packed.height)
    least = box(sides[: 2 if flat else 3], unit)
    if deployment.pieces:
        volume = sum(each.box.volume for each in deployment.pieces)
        total = f"{len(deployment.pieces)} pieces, {plain(volume, 3)} {unit}3 together"
        least = f"{total}, the largest {least}"
    deep = f", {packed.layers} panels deep" if flat else ""
    if report.panel is None:
        deep += ", without their thickness" if flat else ", of panels without a thickness"
    sign: Sign = "says" if said or report.feasible is None else "holds"
    yield Row(sign, "packs", f"{least} at {degrees_below(packed.drive)}{deep}")


def _fits(report: Report, stock: tuple[float, float] | None) -> Iterator[Row]:
    """On how much stock it is cut: panels that are larger were refused before."""
    built, used = report.quantities.built, report.quantities.stock
    if stock is None:
        return
    sheet = box(stock, report.unit)
    if used is None:
        unknown = f"not known: it was not laid out on stock of {sheet}"
        yield Row("warns", "fits", unknown, known=False)
        return
    sheets = used.sheets if built is None or built.stock_sheets is None else built.stock_sheets
    what = "sheet" if sheets == 1 else "sheets"
    yield Row("holds", "fits", f"on {sheets} {what} of {sheet}")


def _unchecked(report: Report) -> Iterator[Row]:
    others = [each for each in report.not_checked if each not in SAID]
    if others:
        yield Row("warns", "unchecked", "; ".join(others), known=False)


def _sizes(report: Report) -> Iterator[Row]:
    clipped = report.deployment.flap_attachment == "clipped"
    return size_rows(
        report.sheet,
        report.deployed,
        report.outside if clipped else None,
        report.unit,
        boards=report.panel is not None,
    )
