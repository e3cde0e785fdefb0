"""Warnings about the way from pack to shell, and about what holds the shell at its target."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from orishell.conventions.errors import Remedy
from orishell.conventions.formatting import in_degrees
from orishell.conventions.progress import Progress
from orishell.conventions.quantities import plain
from orishell.conventions.row import Note
from orishell.deployment import OwnWeight, Pack, find_pack
from orishell.deployment.report import DeploymentReport
from orishell.design import Design
from orishell.design_file import DesignFile
from orishell.document.measures import is_hand_sized
from orishell.locking import Lock
from orishell.motion.layout import points_of
from orishell.shell.facts import Facts
from orishell.shell.instead import first_that_does, trying

PLANE = 0.01
"""A pack whose height is below this share of its length is a bundle of panels on each other."""
SMALLER = 0.5
"""A change that packs the shell into less than this share of the box is worth a word."""

PANELS = 1_500
"""Of a shell of more panels no such change is tried: it would cost as much as the shell."""


def warn_of_deployment(
    file: DesignFile,
    design: Design,
    lock: Lock,
    report: DeploymentReport,
    progress: Progress,
    *,
    mended: bool = True,
    one: bool = True,
) -> list[str]:
    """Warnings of a pack that is no bundle, and of what nothing holds.

    mended: Whether changes that would mend them are tried.
    one: Whether the sheet has one motion only, whose weight is said.
    """
    return [
        *_of_pack(file, design, lock, report, progress if mended else None),
        *_of_ties(report),
        *(_of_weight(file.unit, design, report, report.weight) if report.weight and one else ()),
    ]


def _of_pack(
    file: DesignFile, design: Design, lock: Lock, report: DeploymentReport, mended: Progress | None
) -> Iterator[str]:
    packed = report.packed
    if report.start == "flat" or packed is None or packed.height < PLANE * packed.length:
        return
    if design.has_whole_boards and lock.cause == "crease":
        return  # it is as flat a bundle as its boards are thick
    box = (
        f"{plain(packed.length, 3)} x {plain(packed.width, 3)} x {plain(packed.height, 3)} "
        f"{file.unit}"
    )
    why = "its panel columns close one after another, not together"
    if lock.cause == "clash" and lock.first_contact is not None:
        first, second = (list(panel) for panel in lock.first_contact.panels)
        why = f"panels {first} and {second} meet at drive {in_degrees(lock.closes_to)} degrees"
    elif lock.cause == "unproved":
        why = f"nothing is proved of its motion beyond drive {in_degrees(lock.closes_to)} degrees"
    elif lock.cause == "boards" and design.panel is not None:
        why = f"boards {design.panel.thickness:g} {file.unit} thick close no further than that"
    elif lock.cause == "hinges":
        why = f"its hinges close no further than {in_degrees(design.largest_fold)} degrees"
    better = None if mended is None else _closes_better(file, packed, mended)
    remedy = f"; with {better} it does" if better is not None else ""
    yield f"the pack, {box}, is no flat bundle: {why}{remedy}"


def _closes_better(file: DesignFile, packed: Pack, progress: Progress) -> Remedy | None:
    """A change with which the shell is tried and found to close into a flat bundle."""
    remedy = file.pattern.closing
    if remedy is None or file.deployment.largest_fold < np.pi or file.panel:
        return None

    def closes(made: Facts) -> bool:
        box = find_pack(made.found.design.moving, made.found.lock.closes_to, 1).box
        flat = box.height < PLANE * box.length
        return flat and SMALLER * box.length * box.width < packed.length * packed.width

    work = trying(progress, "looking for a flat bundle")
    return first_that_does(file, [remedy], closes, work, panels=PANELS)


def _of_ties(report: DeploymentReport) -> Iterator[str]:
    failing = [tie for tie in report.ties if tie.slack is False]
    if failing and failing[0].fails_at is not None:
        (row, column), (other, _) = failing[0].ends
        yield Note(
            f"{len(failing)} of {len(report.ties)} ties are not proved slack all the way from the "
            f"pack, for example the one of rows {row} and {other} in column {column}, about drive "
            f"{np.rad2deg(failing[0].fails_at):.4g} degrees: tie other vertices of the column",
            "taut",
        )


def _of_weight(
    length: str, design: Design, report: DeploymentReport, weight: OwnWeight
) -> Iterator[str]:
    unit = "N" if weight.force_unit == "N" else "times its weight"
    force = f"{plain(abs(weight.at_feet), 3)} {unit} at each line of feet"
    if weight.at_feet > 0 and report.opening is None:
        points = points_of(design.mechanism, design.mechanism.target_drive)
        threads = " with threads" if is_hand_sized(points, length) else ""
        yield Note(
            f"the shell opens under its own weight with {force}, and nothing but its supports "
            f'holds it: tie its feet together{threads} (ties = "feet" in [deployment])',
            "opens",
        )
    if weight.at_feet < 0 and report.closing is None:
        beside = design.hinges.beside
        remedy = "block a hinge, for all fold together" if beside else "give it flaps"
        yield Note(
            f"the shell closes under its own weight with {force}, and nothing but its supports "
            f"holds it: {remedy}",
            None if beside else "closes",
        )
