"""How a shell is deployed and held, in the report."""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

import numpy as np

from orishell.conventions.quantities import GRAVITY
from orishell.conventions.record import Angle, record
from orishell.deployment.air import Air, find_air
from orishell.deployment.ground import plan_ground
from orishell.deployment.pack import PACKS, Pack, find_pack, find_packs
from orishell.deployment.raising import Raising, find_raising
from orishell.deployment.settings import Attachment, Start
from orishell.deployment.site import Site
from orishell.deployment.ties import Tie, find_ties
from orishell.deployment.weight import Body, OwnWeight, measure_weight
from orishell.design import Design, PanelSpec
from orishell.design.design import Fixing
from orishell.document import Document
from orishell.document.ground import GroundPlan
from orishell.locking import Cause, Lock
from orishell.motion.complex import Complex
from orishell.motion.freedom import FreedomOfSheet, held_by_flaps
from orishell.motion.layout import has_flaps
from orishell.numerics.equals import largest_of
from orishell.solids import largest_thickness


@record
class DeploymentReport:
    """How a shell is deployed, and what holds it at its target."""

    start: Start  # what it is folded up or opened from
    # whether flaps are part of the folding sheet; None if there are none
    flap_attachment: Attachment | None
    largest_fold: Angle  # how far its hinges close
    # thickness of its panels, 0 for none, and the largest with which set-backs take no more of any
    # than they may; None if it is not limited
    thickness: float
    largest_thickness: float | None
    end_drive: Angle  # as far as it closes, proved if its path was examined
    # what keeps it from closing, and from opening, beyond its target; None if nothing does, or if
    # it is not known to keep all motions of a sheet from it that has several
    closing: Cause | Literal["clipped flaps", "gussets", "plates"] | None
    opening: Literal["ties", "gussets", "plates"] | None
    # how many gussets are clipped into its folds at the target, and plates into its box girders
    gussets: int
    plates: int
    # whether any one of them alone, or all together, keep it from both, in all of its motions; None
    # if that is not known
    fixed_by: Fixing | None
    # the state that packs smallest, of the largest piece where there are pieces; None if that was
    # not asked for
    packed: Pack | None
    pieces: tuple[Pack, ...]  # of each piece, where there are pieces
    ties: tuple[Tie, ...]  # its ties
    # what its own weight does; None if it does not stand, or that was not asked for
    weight: OwnWeight | None
    # air in its box girders, or cells of its second skin; None if there are none, or that was not
    # asked for
    air: Air | None
    # its feet in plan, and the ground that it needs on its way; None likewise
    ground: GroundPlan | None
    # what it takes to raise it by hand; None likewise, or where it is opened in pieces
    raising: Raising | None

    @property
    def left_to_supports(self) -> tuple[str, ...]:
        """What nothing but its supports keeps it from beyond its target: closing, opening."""
        if self.fixed_by is not None:
            return ()
        stops = {"closing": self.closing, "opening": self.opening}
        return tuple(way for way, stop in stops.items() if stop is None)

    @property
    def lacks_ground(self) -> bool:
        """Whether it stands and nobody knows the ground that it needs on its way."""
        return self.ground is not None and self.ground.swept is None


def describe_deployment(
    design: Design, lock: Lock, site: Site, start: Start, freedom: FreedomOfSheet
) -> DeploymentReport:
    """How a shell is deployed, and what holds it at its target.

    Where its sheet has more motions than one, ties are proved slack along none of the others.

    Raises InputError if ties do not fit the sheet.
    """
    mechanism, thickness = design.mechanism, 0.0 if design.panel is None else design.panel.thickness
    clipped, folded = design.clipped is not None, has_flaps(mechanism)
    ties = find_ties(mechanism, site.ties, lock.closes_to, design.hinges)
    # Where the proof ends nothing is known to hold it.
    ends = lock.closes_to <= lock.target_drive and lock.cause != "unproved"
    caught = lock.cause if ends else None
    closing: Cause | Literal["clipped flaps", "gussets", "plates"] | None
    closing = "clipped flaps" if clipped else caught
    if not freedom.one_motion:
        ties = tuple(replace(tie, slack=None if tie.slack else tie.slack) for tie in ties)
        if design.clipped is None or not held_by_flaps(design.clipped):
            closing = None
    opening: Literal["ties", "gussets", "plates"] | None = (
        "ties" if ties and freedom.one_motion else None
    )
    if design.fixed_by is not None:
        by: Literal["gussets", "plates"] = "plates" if design.boxes else "gussets"
        closing, opening = closing or by, opening or by
    return DeploymentReport(
        start=start,
        flap_attachment="clipped" if clipped else "folded" if folded else None,
        largest_fold=design.largest_fold,
        thickness=thickness,
        largest_thickness=None,
        end_drive=lock.closes_to,
        closing=closing,
        opening=opening,
        gussets=len(design.plates),
        plates=sum(part.kind == "plate" for part in design.attached),
        fixed_by=design.fixed_by,
        packed=None,
        pieces=(),
        ties=ties,
        weight=None,
        air=None,
        ground=None,
        raising=None,
    )


def with_measures(
    report: DeploymentReport,
    design: Design,
    lock: Lock,
    site: Site,
    *,
    packed: bool,
    weighed: bool,
) -> DeploymentReport:
    """The report with what is asked for of pack with largest thickness, and of own weight."""
    end = max(lock.closes_to, lock.target_drive)
    packs = _packs(design, lock, report.thickness) if packed else ()
    weight = _weight(design, site, end) if weighed else None
    return replace(
        report,
        largest_thickness=_largest_thickness(design) if packed else None,
        packed=largest_of(packs, lambda each: each.box.volume) if packs else None,
        pieces=packs if len(packs) > 1 else (),
        weight=weight,
        air=None if weight is None else _air(design, lock, site, weight, report.start),
    )


def _packs(design: Design, lock: Lock, thickness: float) -> tuple[Pack, ...]:
    """The pack, or those of all pieces."""
    end = max(lock.closes_to, lock.target_drive)
    if lock.built is None or not design.has_whole_boards:
        return (find_pack(design.moving, end, PACKS, thickness),)
    return find_packs(design.mechanism, end, lock.built.boards)


def _largest_thickness(design: Design) -> float | None:
    if design.hinges.beside and design.panel is not None:
        arm = design.hinges.longest_arm
        most = design.panel.longest_arm * design.panel.thickness / arm if arm else np.inf
        return float(most) if np.isfinite(most) else None
    most = largest_thickness(design.flapped, design.panel or PanelSpec(thickness=0.0))
    return most if np.isfinite(most) else None


def _weight(design: Design, site: Site, pack: float) -> OwnWeight | None:
    if site.feet is None:
        return None
    return measure_weight(
        design.moving,
        site.feet.rows,
        _newtons(site),
        metres=site.metres,
        pack=pack,
        columns=site.feet.columns(design.mechanism),
        hinges=design.hinges,
    )


def _air(design: Design, lock: Lock, site: Site, weight: OwnWeight, start: Start) -> Air | None:
    """Air in what the sheet carries, from where that is joined to the pack; None if in nothing."""
    whole = design.moving
    if lock.carried is None or not isinstance(whole, Complex):
        return None
    if not any(each.cells for each in whole.strips):
        return None
    return find_air(
        whole,
        weight.drives,
        weight.energy,
        (lock.carried.joined_from, lock.closes_to),
        metres=site.metres,
        weighed=weight.force_unit == "N",
        from_pack=start == "pack",
    )


def _newtons(site: Site) -> float | None:
    """Weight per area of the sheet (N per square of the unit); None if it is not known."""
    return GRAVITY * site.areal_density * site.metres**2 or None


def with_ground(
    report: DeploymentReport, design: Design, lock: Lock, site: Site, document: Document
) -> DeploymentReport:
    """The report with plan of feet and ground, and what raising takes, if its weight is measured.

    document: The shell as files have it, with what is clipped on at the target.
    """
    weight, feet, mechanism = report.weight, site.feet, design.mechanism
    if weight is None or feet is None:
        return report
    end = 0.0 if report.start == "flat" else max(lock.closes_to, lock.target_drive)
    boards = None if lock.built is None else lock.built.boards
    raising = None
    if not design.in_pieces:
        columns, newtons = feet.columns(mechanism), _newtons(site) or 1.0
        body = Body.of(design.moving, feet.rows, newtons, columns, design.hinges)
        raising = find_raising(body, weight, end, site.metres)
    ground = plan_ground(design, feet, boards, end, document)
    return replace(report, ground=ground, raising=raising)
