"""Panels with a thickness, in the report."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from orishell.conventions.formatting import in_one_line, tidy_degrees
from orishell.design import Construction
from orishell.locking import Lock
from orishell.shell.lock_report import PathReport, describe_path
from orishell.solids import find_set_backs


@dataclass(frozen=True, slots=True)
class PanelReport:
    """Panels as they are built.

    Parameters
    ----------
    construction, thickness, membrane, gap
        What they are made of.
    set_back_for_deg
        The drive up to which boards are set back.
    largest_fold_deg
        The largest fold angle of a crease on the way there.
    largest_setback
        How far boards stand back at most.
    boards
        Their number, those of clipped flaps included.
    corners_cut, largest_cut
        Number of vertices at which corners of boards are cut off, and how far at most.
    path
        How contact of boards was looked for; None if it was not.
    """

    construction: Construction
    thickness: float
    membrane: float
    gap: float
    set_back_for_deg: float
    largest_fold_deg: float
    largest_setback: float
    boards: int
    corners_cut: int
    largest_cut: float
    path: PathReport | None

    __repr__ = in_one_line


def describe_panels(lock: Lock) -> PanelReport | None:
    """Panels as they are built; None if they have no thickness."""
    built = lock.built
    if built is None:
        return None
    build = built.build
    back = find_set_backs(built.folds, build.height, build.gap)
    longest = np.concatenate([back.top, back.bottom])
    return PanelReport(
        construction=build.construction,
        thickness=build.thickness,
        membrane=build.membrane,
        gap=build.gap,
        set_back_for_deg=tidy_degrees(built.limit),
        largest_fold_deg=tidy_degrees(float(np.abs(built.folds.on_edges()).max())),
        largest_setback=float(longest[np.isfinite(longest)].max()),
        boards=len(built.boards) + (len(built.flaps) if built.flaps is not None else 0),
        corners_cut=int((built.reliefs > 0).sum()),
        largest_cut=float(built.reliefs.max()),
        path=describe_path(lock.boards_proof),
    )
