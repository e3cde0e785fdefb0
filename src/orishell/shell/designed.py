"""The design that a file asks for, before its path is examined for contact."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.conventions.errors import DesignError, Remedy, Value
from orishell.conventions.formatting import in_degrees, rounded
from orishell.conventions.progress import Progress, no_progress
from orishell.deployment.feet import find_feet
from orishell.deployment.pieces import choose_pieces
from orishell.design import Design, PanelSpec
from orishell.design.panel import HINGED_ONLY
from orishell.design_file import DesignFile
from orishell.families.pattern import Pattern
from orishell.motion import Mechanism, drive_at_fold, largest_fold
from orishell.motion.convex import require_convex
from orishell.motion.hinges import FreeLengths, Hinges, Straightened
from orishell.motion.layout import has_flaps
from orishell.motion.mechanism import is_flat_at_first
from orishell.solids import (
    drive_for_height,
    find_stop,
    find_thickness_limit,
    limit_in_words,
    thinner,
    wide_gap,
)
from orishell.solids.hinged import find_hinges, meet_target

FOLD_ANGLE_ROUNDING = 1e-9
"""By so much a fold angle at the target may exceed what hinges allow (radians)."""
LEAST_FOLDED = 1e-3
"""A sheet without a target is folded this share of the way at least, or refused."""
UP = 5e-4
"""A fold angle that is offered is so much above what is needed (degrees)."""


def designed(file: DesignFile, progress: Progress = no_progress) -> Design:
    """The design that a file asks for, whose rows and columns are known.

    Raises DesignError if the family cannot make it, or hinges or boards do not close as far as its
    target asks, also where flaps with boards stop short of folding flat.
    """
    return completed(file, design_of(file, file.pattern, progress))


def completed(file: DesignFile, design: Design) -> Design:
    """What a family made of a file, with panels, flaps and hinges as the file asks for them.

    Raises DesignError as :func:`designed` does.
    """
    opening = file.deployment.start == "pack"
    design = replace(design, largest_fold=file.deployment.largest_fold, opens_from_pack=opening)
    if file.panel is not None:
        design = _with_panels(design, file.panel, file.pattern.closing)
    if file.deployment.flap_attachment == "clipped":
        design = design.with_clipped_flaps()
    design = _as_far_as_it_goes(design)
    _require_hinges(design, opening)
    _require_thickness(design)
    return design


def design_of(file: DesignFile, pattern: Pattern, progress: Progress = no_progress) -> Design:
    """What a family makes of a pattern and a file's target, or of the pattern alone."""
    if file.surface is not None and file.before is not None:
        return pattern.design_near(file.surface, file.before, progress)
    if file.surface is not None:
        return pattern.design_on(file.surface, progress)
    if file.drawing is not None:
        return pattern.design_drawn(file.drawing)
    if file.target is None:
        return pattern.design_without_target()
    return pattern.design(*file.target)


def _as_far_as_it_goes(design: Design) -> Design:
    """The design, ended where hinges or boards let it go no further, if nothing else ends it."""
    if design.ending_at is None:
        return design
    mechanism, build = design.mechanism, design.set_back
    end = drive_at_fold(mechanism, design.largest_fold)
    if build is not None:
        end = drive_for_height(mechanism, build, end)
    target = mechanism.target_drive
    return design if end >= target else design.ended_at(max(end, LEAST_FOLDED * target))


def _require_hinges(design: Design, from_pack: bool) -> None:
    """Refuse hinges that do not close as far as the target asks; a pack asks for more."""
    mechanism, limit = design.mechanism, design.largest_fold
    if limit >= np.pi:
        return
    needed = float(largest_fold(mechanism, np.array([mechanism.target_drive]))[0])
    if needed <= limit + FOLD_ANGLE_ROUNDING:
        return
    flaps = has_flaps(mechanism)
    clipped = [Remedy({"deployment.flap_attachment": "clipped"})] if flaps else []
    asked = 180.0 if from_pack else rounded(float(np.rad2deg(needed)) + UP, 6)
    raise DesignError(
        "hinges do not close as far as the target asks",
        keys=("deployment.largest_fold_deg",),
        size=f"a crease folds by {in_degrees(needed)} degrees there, hinges by at most "
        f"{in_degrees(limit)}",
        candidates=[*clipped, Remedy({"deployment.largest_fold_deg": min(asked, 180.0)})],
        excess=(needed - limit) / np.pi,
    )


def _with_panels(design: Design, panel: PanelSpec, closing: Remedy | None) -> Design:
    """The design with panels of a thickness: its flaps stop where their boards meet."""
    require_convex(design.mechanism)
    if panel.construction == "hinged":
        return _with_whole_boards(design, panel, closing)
    stop = panel.stop if has_flaps(design.mechanism) else 0.0
    if stop is None:
        stop = find_stop(design.mechanism, panel)
    return replace(design.with_stop(stop), panel=panel)


def _require_one_sheet(mechanism: Mechanism, panel: PanelSpec) -> None:
    """Refuse whole boards on panels that are made in strips: their vertices are no linkages."""
    if not is_flat_at_first(mechanism):
        raise DesignError(
            "whole boards on hinges move only where the sheet folds flat both ways, and this one, "
            "made in strips, is flat in no state",
            keys=("panel.construction", "shell.family"),
            candidates=[on_membrane(panel)],
        )


def _with_whole_boards(design: Design, panel: PanelSpec, closing: Remedy | None) -> Design:
    """The design with whole boards on hinges, its columns as straight as these need them.

    Where there is a target, its boards meet it instead of the sheet.

    closing: What makes a sheet of its family fold flat.
    """
    mechanism = design.mechanism
    _require_one_sheet(mechanism, panel)
    if has_flaps(mechanism):
        raise DesignError(
            "whole boards on hinges cannot have flaps: a flap folds flat before the sheet does",
            keys=("pattern.flap", "panel.construction"),
            candidates=[Remedy({"pattern.flap": 0.0}), on_membrane(panel)],
        )
    if isinstance(mechanism, Straightened):
        mechanism = mechanism.straightened()
    try:
        if panel.pieces == "auto":
            end = drive_at_fold(mechanism, design.largest_fold)
            panel = panel.replace_unchecked(pieces=choose_pieces(mechanism, panel, end))
        hinges = find_hinges(mechanism, panel)
    except DesignError as error:
        if error.keys == ("panel.construction",):
            other = on_membrane(panel)
            error.candidates = [other] if closing is None else [closing, other]
        raise
    design = replace(design, mechanism=mechanism, panel=panel, grounded=None)
    if design.swept is None:
        return replace(design, hinges=hinges)
    return _with_boards_at_target(design, hinges)


def _with_boards_at_target(design: Design, hinges: Hinges) -> Design:
    """The design whose boards are where its panels are at the target, as nearly as they can be.

    Level feet of sweeps stay level. Fitted sheets touch the ground with flat rims: a dome of 6 m
    whose feet were 54 mm uneven became even by moving them 490 mm along it.
    """
    sheet = design.mechanism
    feet = find_feet(design) if design.targets else None
    level = feet.vertices(sheet) if feet is not None and feet.level else None
    mechanism, hinges = meet_target(sheet, hinges, feet=level)
    described = mechanism.described_lengths() if isinstance(mechanism, FreeLengths) else {}
    return replace(
        design,
        mechanism=mechanism,
        hinges=hinges,
        meant=sheet.positions(sheet.target_drive),
        parameters={**design.parameters, **described},
    )


MEMBRANE = 0.1
"""Thickness of a membrane that is offered, in thicknesses of panels."""


def on_membrane(panel: PanelSpec) -> Remedy:
    """The change from other panels to boards on a membrane, cut square.

    Parameters
    ----------
    panel
        What panels are made of.
    """
    changes: dict[str, Value | None] = {
        "panel.construction": "sandwich",
        "panel.membrane": rounded(MEMBRANE * panel.thickness),
    }
    for key in HINGED_ONLY:
        if key in panel.model_fields_set:
            changes[f"panel.{key}"] = None
    return Remedy(changes)


def _require_thickness(design: Design) -> None:
    """Refuse boards so thick that they take too much of a panel at the target."""
    build = design.set_back
    if build is None:
        return
    sheet = design.flapped
    limit = find_thickness_limit(sheet, build)
    if build.thickness <= limit.thickness:
        return
    place = f"at the target, {limit.crease}"
    if (
        not limit.thickness
        and find_thickness_limit(sheet, build.replace_unchecked(gap=0.0)).thickness
    ):
        raise wide_gap(build, place, lambda other: find_thickness_limit(sheet, other).thickness)
    earlier = [Remedy({"panel.stop_deg": "auto"})] if limit.on_flap else []
    raise DesignError(
        "boards would take more of a panel than set-backs may",
        place=place,
        keys=("panel.thickness",),
        size=limit_in_words(build, limit.thickness),
        candidates=[*earlier, *thinner(build, limit.thickness)],
        excess=build.thickness / limit.thickness - 1 if limit.thickness else None,
    )
