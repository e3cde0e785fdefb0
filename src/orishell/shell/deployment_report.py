"""How a shell is deployed and held, in the report."""

from __future__ import annotations

from collections.abc import Collection
from typing import Literal

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.formatting import tidy_degrees
from orishell.conventions.quantities import GRAVITY, conversion
from orishell.conventions.record import record
from orishell.deployment import (
    Attachment,
    Deployment,
    Start,
    Tie,
    feet_ties,
    find_pack,
    find_ties,
    measure_weight,
)
from orishell.deployment.feet import Feet
from orishell.design import Design, PanelSpec
from orishell.design_file import DesignFile
from orishell.locking import Cause, Lock
from orishell.motion import sheet_area
from orishell.motion.grid import VertexPair
from orishell.shell.steps import Step
from orishell.solids import BuiltPanels, largest_thickness

PACKS = 9
"""States from the target on of which the one that packs smallest is taken."""


@record
class PackedReport:
    """The state that packs smallest, from the target to where the motion ends."""

    drive_deg: float  # its drive angle
    # its smallest box, turned as it may be, of panels with their thickness
    length: float
    width: float
    height: float
    layers: int  # how many panels lie on top of each other: boards make it that many times as thick


@record
class TieReport:
    """A tie between two vertices."""

    ends: VertexPair  # its vertices by row and column
    # their distance at the target, in the flat sheet, and at the end of the motion
    length: float
    flat: float
    packed: float
    # whether it is proved that its vertices move apart all the way from the end of the motion to
    # the flat sheet; None if the family does not say
    grows: bool | None
    slack: bool | None  # whether it is proved to be slack from the end of the motion to the target
    fails_at_deg: float | None  # where its vertices do not move apart, nearest to the target


@record
class WeightReport:
    """The shell under its own weight; flaps that are clipped on are left out."""

    force_unit: Literal["N", "weight"]  # Newtons, or the shell's weight if its mass is not known
    total: float  # its weight
    # force at the target by which the feet, all of one side together, push outwards: positive where
    # own weight opens the shell and ties carry it, negative where flaps do
    at_feet: float
    # the largest force at the feet on the way from the end of the motion to the target
    largest_from_pack: float
    tipping_deg: tuple[float, ...]  # drives at which the shell would fall to either side
    # what raising it takes: work, in the unit of force times metres
    raise_from_flat: float
    raise_from_pack: float
    # the force at the feet along the motion; None where none raises or holds it
    drives_deg: tuple[float, ...]
    forces: tuple[float | None, ...]


@record
class DeploymentReport:
    """How a shell is deployed, and what holds it at its target."""

    start: Start  # what it is folded up or opened from
    # whether flaps are part of the folding sheet; None if there are none
    flap_attachment: Attachment | None
    largest_fold_deg: float  # how far its hinges close
    # thickness of its panels, 0 for none, and the largest with which set-backs take no more of any
    # than they may; None if it is not limited
    thickness: float
    largest_thickness: float | None
    end_drive_deg: float  # as far as it closes, proved if its path was examined
    # what keeps it from closing, and from opening, beyond its target; None if nothing does
    closing: Cause | Literal["clipped flaps"] | None
    opening: Literal["ties"] | None
    packed: PackedReport | None  # the state that packs smallest; None if that was not asked for
    ties: tuple[TieReport, ...]  # its ties
    # what its own weight does; None if it does not stand, or that was not asked for
    weight: WeightReport | None


def describe_deployment(
    file: DesignFile,
    design: Design,
    lock: Lock,
    feet: Feet | None,
    skip: Collection[Step] = (),
) -> DeploymentReport:
    """How a shell is deployed, and what holds it at its target.

    skip: What is not asked for: of pack and own weight.

    Raises InputError if ties do not fit the sheet.
    """
    mechanism = design.mechanism
    clipped, folded = design.clipped is not None, bool(mechanism.flap_columns)
    ties = find_ties(mechanism, pairs_of_ties(design, file.deployment, feet), lock.closes_to)
    packed = most = weight = None
    if "pack" not in skip:
        packed, most = _packed(design, lock), _largest_thickness(design)
    if "weight" not in skip and feet is not None:
        metres = conversion(file.unit, "m")
        density = areal_density(file, design, lock.built)
        weight = _weight(design, feet, lock, metres, density)
    return DeploymentReport(
        start=file.deployment.start,
        flap_attachment="clipped" if clipped else "folded" if folded else None,
        largest_fold_deg=tidy_degrees(design.largest_fold),
        thickness=_thickness(design),
        largest_thickness=most,
        end_drive_deg=tidy_degrees(lock.closes_to),
        closing="clipped flaps"
        if clipped
        else lock.cause
        if lock.closes_to <= lock.target
        else None,
        opening="ties" if ties else None,
        packed=packed,
        ties=tuple(map(_tie, ties)),
        weight=weight,
    )


def pairs_of_ties(design: Design, deployment: Deployment, feet: Feet | None) -> list[VertexPair]:
    """Ends of the ties that are asked for, rows and columns of the folding sheet.

    Raises InputError if there are no feet to tie.
    """
    if isinstance(deployment.ties, tuple):
        return list(deployment.ties)
    if deployment.ties == "none":
        return []
    if feet is None:
        raise InputError(
            "there are no feet to tie",
            keys=("deployment.ties",),
            got='"feet"',
            expected="a shell that stands on the two ends of f",
            remedy="name pairs of vertices, [[row, column], [row, column]], or leave ties out",
        )
    return feet_ties(design.mechanism, feet.rows)


def _thickness(design: Design) -> float:
    return 0.0 if design.panel is None else design.panel.thickness


def _largest_thickness(design: Design) -> float | None:
    flapped, build = design.clipped or design.mechanism, design.panel or PanelSpec(thickness=0.0)
    most = largest_thickness(flapped, build)
    return most if np.isfinite(most) else None


def _packed(design: Design, lock: Lock) -> PackedReport:
    found = find_pack(design.mechanism, max(lock.closes_to, lock.target), PACKS, _thickness(design))
    box = found.box
    return PackedReport(tidy_degrees(found.drive), box.length, box.width, box.height, found.layers)


def _tie(tie: Tie) -> TieReport:
    fails = None if tie.fails_at is None else tidy_degrees(tie.fails_at)
    return TieReport(tie.ends, tie.length, tie.flat, tie.packed, tie.grows, tie.slack, fails)


def areal_density(file: DesignFile, design: Design, built: BuiltPanels | None) -> float:
    """Mass of the panels per area of the sheet (kg/m^2); 0 where that of a part is not known."""
    if file.workshop.areal_density or built is None:
        return file.workshop.areal_density or 0.0
    build, area = built.build, sheet_area(design.mechanism.positions(0.0))
    boards = build.density * float(built.boards.volumes().sum())
    membrane = build.membrane_density * build.membrane * area
    known = build.density and (build.membrane_density or not build.membrane)
    return conversion(file.unit, "m") * (boards + membrane) / area if known else 0.0


def _weight(
    design: Design, feet: Feet, lock: Lock, metres: float, areal_density: float
) -> WeightReport:
    known = areal_density > 0
    found = measure_weight(
        design.mechanism,
        feet.rows,
        GRAVITY * areal_density * metres**2 if known else 1.0,
        pack=max(lock.closes_to, lock.target),
    )
    unit = 1.0 if known else found.total
    return WeightReport(
        force_unit="N" if known else "weight",
        total=found.total / unit,
        at_feet=found.target_thrust / unit,
        largest_from_pack=found.largest_force / unit,
        tipping_deg=tuple(map(tidy_degrees, found.tipping)),
        raise_from_flat=found.work_from_flat * metres / unit,
        raise_from_pack=found.work_from_pack * metres / unit,
        drives_deg=tuple(map(tidy_degrees, found.drives.tolist())),
        forces=tuple(None if np.isnan(force) else force / unit for force in found.thrust.tolist()),
    )
