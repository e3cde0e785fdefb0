"""How a shell is deployed and held, in the report."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from orishell.conventions.formatting import in_one_line, tidy_degrees
from orishell.deployment import Attachment, Deployment, Start
from orishell.design import Design
from orishell.locking import Cause, Lock


@dataclass(frozen=True, slots=True)
class DeploymentReport:
    """How a shell is deployed, and what holds it at its target.

    Parameters
    ----------
    start
        What it is folded up or opened from.
    flap_attachment
        Whether flaps are part of the folding sheet; None if there are none.
    largest_fold_deg
        How far its hinges close.
    end_drive_deg
        As far as it closes, proved if its path was examined.
    closing, opening
        What keeps it from closing, and from opening, beyond its target; None if nothing does.
    """

    start: Start
    flap_attachment: Attachment | None
    largest_fold_deg: float
    end_drive_deg: float
    closing: Cause | Literal["clipped flaps"] | None
    opening: Literal["ties"] | None

    __repr__ = in_one_line


def describe_deployment(design: Design, deployment: Deployment, lock: Lock) -> DeploymentReport:
    """How a shell is deployed, and what holds it at its target."""
    clipped, folded = design.boards is not None, bool(design.mechanism.flap_columns)
    stopped = lock.pack <= lock.target
    return DeploymentReport(
        start=deployment.start,
        flap_attachment="clipped" if clipped else "folded" if folded else None,
        largest_fold_deg=tidy_degrees(design.largest_fold),
        end_drive_deg=tidy_degrees(lock.pack),
        closing="clipped flaps" if clipped else lock.cause if stopped else None,
        opening=None,
    )
