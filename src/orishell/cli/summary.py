"""The summary that ``orishell design`` prints."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from orishell.cli.files import shortened
from orishell.cli.structure import brief_structure
from orishell.conventions.quantities import plain

if TYPE_CHECKING:
    from orishell.deviation.report import DeviationReport
    from orishell.locking.report import PanelReport
    from orishell.shell.deployment_report import DeploymentReport
    from orishell.shell.make import Shell
    from orishell.shell.report import Report


def summarize(shell: Shell, written: list[Path], removed: list[Path]) -> Iterator[str]:
    """Lines that say what was designed, and which files were written and removed."""
    report, unit = shell.report, shell.report.unit
    sheet, deployed, residuals = report.sheet, report.deployed, report.residuals
    grid = shell.motion.mechanism.grid
    yield (
        f"{report.family}: {report.rows} x {report.columns} inner vertices, "
        f"{grid.panel_count} panels"
    )
    if report.chosen is not None:
        yield (
            f"chosen    for {report.chosen.tolerance:g} {unit} from the surface, with the fewest "
            f"panels of {report.chosen.designs_tried} designs tried{_on_stock(shell)}"
        )
    yield (
        f"sheet     {plain(sheet.width)} x {plain(sheet.height)} {unit}, area "
        f"{plain(sheet.area)} {unit}2"
    )
    yield (
        f"deployed  {plain(deployed.width)} x {plain(deployed.depth)} x "
        f"{plain(deployed.height)} {unit}"
    )
    if report.deviation is None:
        yield "no target: nothing to compare the shell with"
    else:
        yield _standing(report)
        yield from _deviation(report.deviation, unit)
    if residuals is not None:
        yield (
            f"rigid     panel lengths to {residuals.panel_length:.1e}, fold angles to "
            f"{residuals.fold_angle_rad:.1e} rad over {len(shell.motion)} states"
        )
    yield from _held(shell)
    if report.structure is not None:
        yield from brief_structure(report.structure, unit)
    yield from (f"wrote     {text}" for text in shortened(written))
    yield from (f"removed   {text}, from an earlier run" for text in shortened(removed))


def _on_stock(shell: Shell) -> str:
    """That panels were chosen to fit the stock, without its margins."""
    from orishell.workshop.layout import usable_stock

    workshop = shell.file.workshop
    if workshop.stock is None:
        return ""
    wide, high = usable_stock(workshop)
    unit = shell.report.unit
    return f" whose panels fit {wide:g} x {high:g} {unit}, the stock without its margins"


def _standing(report: Report) -> str:
    stands = report.stands
    if stands is None:
        return (
            "stands    nowhere: f's ends are not its lowest part, so g is left in the plane z = 0"
        )
    on = "rows {} and {}".format(*stands.rows)
    if stands.level:
        return f"stands    level on z = {plain(stands.z)} on {on}"
    unit = report.unit
    return (
        f"stands    on {on}, from z = {plain(stands.z)} up to {plain(stands.uneven)} {unit} above"
    )


def _deviation(deviation: DeviationReport, unit: str) -> Iterator[str]:
    surface, approached = deviation.surface, deviation.approached
    yield f"deviation f {plain(deviation.f.max)} {unit}, g {plain(deviation.g.max)} {unit}"
    if surface is not None:
        yield (
            f"surface   max {plain(surface.max)} {unit} (known to "
            f"{plain(surface.sample_spacing, 1)}), rms {plain(surface.rms)} {unit}"
        )
    if deviation.tilted:
        yield f"tilted    in the surface that this is measured from {deviation.tilted}"
    if approached is not None:
        size = approached.max
        found = "" if size is None else f"; max {plain(size)} {unit} from that"
        yield f"approach  {approached.what}{found}"


def _held(shell: Shell) -> Iterator[str]:
    """What the motion is proved to do, and what holds the shell at its target."""
    from orishell.conventions.formatting import in_degrees

    lock, contact = shell.lock, shell.lock.first_contact
    aim = "target" if shell.design.swept is not None else "stage"
    if lock.proof is not None:
        proved = f"proved over the whole path by bounds between {lock.proof.states} states"
        if lock.cause in {"clash", "boards"} and contact is not None:
            sides = contact.sides or ("", "")
            first, second = (
                f"{list(panel)}{f' {side}' if side in {'top', 'bottom'} else ''}"
                for panel, side in zip(contact.panels, sides, strict=True)
            )
            beyond = contact is not lock.obstacle and shell.design.ending_at is None
            met = f", beyond the {aim} at {in_degrees(lock.target)} deg" if beyond else ""
            yield (
                f"path      panels {first} and {second} meet at {in_degrees(contact.drive)} deg"
                f"{met} ({contact.kind}), none before: {proved}"
            )
        else:
            yield f"path      clear from flat to {in_degrees(lock.pack)} deg: {proved}"
    if shell.report.panel is not None:
        yield from _panels(shell.report.panel, shell.report.unit)
    yield from _deployment(shell.report.deployment, shell.report.unit)
    if shell.report.not_checked:
        yield "not checked: " + "; ".join(shell.report.not_checked)
    held = shell.report.deployment
    if not lock.early:
        yield (
            f"held      at {in_degrees(lock.target)} deg: from closing by {HOLDING[held.closing]}, "
            f"from opening by {HOLDING[held.opening]}"
        )


def _panels(report: PanelReport, unit: str) -> Iterator[str]:
    """What panels with a thickness are made of, and what keeps their boards apart."""
    cut = report.corners_cut
    corners = f", corners cut off at {cut} vertices" if cut else ""
    proved = "" if report.path is None else "; that none meet on the way is proved as for panels"
    yield (
        f"boards    {report.boards}, {plain(report.thickness)} {unit} thick panels, set back "
        f"by up to {plain(report.largest_setback, 3)} {unit}{corners}{proved}"
    )


def _deployment(report: DeploymentReport, unit: str) -> Iterator[str]:
    """How the shell travels, and what its own weight does."""
    packed, weight = report.packed, report.weight
    if packed is not None and report.start == "pack":
        box = f"{plain(packed.length)} x {plain(packed.width)} x {plain(packed.height, 2)} {unit}"
        deep = f", {packed.layers} panels deep" if packed.height < SLIM * packed.length else ""
        yield f"pack      {box} at {packed.drive_deg:.5g} deg{deep}"
    if weight is not None:
        does = "opens" if weight.at_feet > 0 else "closes"
        size, unit = abs(weight.at_feet), weight.force_unit
        force = (
            f"{plain(size, 3)} N of {plain(weight.total)} N"
            if unit == "N"
            else f"{plain(size, 3)} of it"
        )
        raising = weight.raise_from_pack if report.start == "pack" else weight.raise_from_flat
        work = (
            f"{plain(raising, 3)} J" if unit == "N" else f"its weight times {plain(raising, 3)} m"
        )
        raises = f"raising it takes {work}" if raising > 0 else "it comes down to it by itself"
        yield f"weight    {does} it at the target, with {force} at the feet; {raises}"
    if report.ties:
        slack = sum(tie.slack is True for tie in report.ties)
        yield (
            f"ties      {len(report.ties)}, {slack} of them proved to be slack from the pack to "
            "the target and taut there"
        )


SLIM = 0.03
"""A pack less high than this share of its length is a bundle, whose layers count."""
HOLDING = {
    "flaps": "its flaps",
    "clipped flaps": "flaps clipped on",
    "crease": "a crease folded flat",
    "clash": "panels that meet",
    "hinges": "its hinges",
    "boards": "the thickness of its boards",
    "ties": "its ties",
    None: "its supports only",
}
"""Words for what holds a shell at its target."""
