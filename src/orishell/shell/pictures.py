"""The surface that a shell follows, and the distances of its vertices, added to its document."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from orishell.conventions.formatting import tidy_degrees
from orishell.conventions.quantities import plain
from orishell.deployment import FROM_FLAT
from orishell.deployment.report import DeploymentReport
from orishell.design import Design, PiecedSurface
from orishell.design_file import DesignFile
from orishell.deviation import Deviation, drawn_shell, measure_points, measure_signed
from orishell.document import Document
from orishell.document.sizes import sheet_in_words, sides_in_words
from orishell.families.registry import FAMILIES
from orishell.locking import Lock
from orishell.motion import FoldingMotion
from orishell.motion.quads import grid_corners
from orishell.numerics.arrays import Array
from orishell.plot import (
    DrawnContact,
    DrawnWeight,
    OffsetSection,
    find_hinge_section,
    find_offset_section,
    plot_deviation,
    plot_overview,
    plot_tradeoff,
    plot_weight,
)
from orishell.shell.report import Report
from orishell.shell.size_trials import Choice, Trial

CELLS = 40
"""Cells of the lattice along the surface's longer side, about."""
FLAT = 200
"""Cells leave the surface by about their size divided by this."""
MOST_CELLS = 40_000
"""Cells of the lattice at most."""


def lay_surface(document: Document, design: Design, *, measured: bool = True) -> Document:
    """The document with the surface of its design added, unchanged if there is none."""
    if design.swept is None:
        return document
    surface = design.surface
    step = surface.size() / CELLS
    lattice = surface.lattice(step, step / FLAT, most=MOST_CELLS)
    document = replace(document, surface=lattice.points)
    if not measured:
        return document
    grid, inner = design.mechanism.grid, design.mechanism.inner_columns
    points = document.shell.positions
    distances = np.full(len(points), np.nan)
    own = distances[: grid.vertex_count].reshape(grid.rows, grid.columns)
    own[:, inner] = measure_points(drawn_shell(design), surface)
    return replace(document, distances=distances)


DRAWN_SAMPLES, DRAWN_PANELS = 6_000, 70
"""Points of the shell, and rows or columns of panels, in the picture of its deviation."""


def draw_pictures(
    directory: Path,
    file: DesignFile,
    design: Design,
    motion: FoldingMotion,
    document: Document,
    *,
    lock: Lock,
    deviation: Deviation | None,
    choice: Choice | None,
    report: Report,
) -> None:
    """Write ``overview.png`` and what applies of ``deviation``, ``tradeoff`` and ``weight.png``.

    Own weight is drawn where the design file says how the shell is deployed: from the flat sheet
    until its flaps stop it, the report's few numbers are enough.
    """
    hinge = None
    if document.boards is not None and document.panel is not None:
        hinge = find_hinge_section(motion, document.boards, document.panel)
    plot_overview(
        directory / "overview.png",
        motion,
        design.targets,
        title=_title(file),
        last=_last_state(design, lock) + _carried(design),
        unit=file.unit,
        contact=_drawn(lock),
        hinge=hinge,
        beside=_offset_section(design),
        hinges=document.hinges,
        others=lambda drive: _others(design, drive),
        sizes=_sizes(report),
    )
    if deviation is not None:
        _plot_deviation(directory / "deviation.png", design, deviation, file.unit)
    if choice is not None:
        plot_tradeoff(
            directory / "tradeoff.png",
            [_point(trial) for trial in choice.tradeoff],
            _point(choice.trial),
            choice.tolerance,
            file.unit,
        )
    weight = weight_of(report.deployment, lock)
    if weight is not None and file.deployment != FROM_FLAT:
        plot_weight(directory / "weight.png", weight)


def _sizes(report: Report) -> tuple[str, str]:
    """Sizes of the flat sheet and of the shell, as all of its rows have them."""
    deployed = sides_in_words(report.deployed, report.unit)
    of = "" if report.panel is None else " of its boards"
    return sheet_in_words(report.sheet, report.unit), f"{deployed}{of}"


def weight_of(deployment: DeploymentReport, lock: Lock) -> DrawnWeight | None:
    """A shell's own weight, as it is drawn; None if it was not measured, or does not stand."""
    weight = deployment.weight
    if weight is None:
        return None
    in_newtons = weight.force_unit == "N"
    marked = {"target": tidy_degrees(lock.target_drive)}
    if deployment.start == "pack":
        marked["pack"] = tidy_degrees(deployment.end_drive)
    return DrawnWeight(
        tuple(map(tidy_degrees, weight.drives)),
        weight.forces,
        unit="N" if in_newtons else "share of its weight",
        largest=max(weight.total if in_newtons else 1.0, weight.largest_from_pack),
        marked_deg=marked,
        tipping_deg=tuple(map(tidy_degrees, weight.tipping)),
    )


def _point(trial: Trial) -> tuple[int, float, str]:
    return trial.panels, trial.error, f"{trial.rows} × {trial.columns}"


def _plot_deviation(path: Path, design: Design, deviation: Deviation, unit: str) -> None:
    largest, rms = f"{plain(deviation.max, 3)} {unit}", f"{plain(deviation.rms, 3)} {unit}"
    signed = measure_signed(drawn_shell(design), design.surface, DRAWN_SAMPLES, DRAWN_PANELS)
    note = "Shell at its target, flaps left out, coloured by its distance from "
    note += "f swept along g" if design.targets else _beside(design, unit)
    if design.tilted:
        note += f"; {design.tilted}"
    if signed.strides != (1, 1):
        note += "; every {}th row, every {}th column drawn".format(*signed.strides)
    plot_deviation(
        path,
        signed.points,
        signed.distances,
        signed.creases,
        design.targets,
        title=f"Deviation, both ways: max {largest}, rms {rms}",
        note=note,
        unit=unit,
    )


def _beside(design: Design, unit: str) -> str:
    """The surface asked for, and how far crests and valleys should lie from it."""
    if design.offset is None:
        return "the surface asked for"
    away = f"{plain(abs(design.offset), 3)} {unit}"
    return f"the surface asked for; crests and valleys should lie {away} above and below it"


def _offset_section(design: Design) -> OffsetSection | None:
    """The middle column over the surface; None where crests and valleys follow none beside it."""
    offset, surface = design.offset, design.swept
    if offset is None or not isinstance(surface, PiecedSurface):
        return None
    mechanism = design.mechanism
    sheet = design.hinges.vertices(mechanism.positions(mechanism.target_drive))
    return find_offset_section(sheet[:, sheet.shape[1] // 2], surface.piece, offset)


def _drawn(lock: Lock) -> DrawnContact | None:
    """The first contact, if it comes before the target and so is to be drawn."""
    contact = lock.obstacle
    if contact is None or contact is lock.clipped_contact or contact.apart is not None:
        return None
    return DrawnContact(contact.drive, contact.panels)


def _others(design: Design, drive: float) -> list[Array]:
    """Corners (K, 4, 3) of panels that are carried, where they are joined; plates at the target."""
    found = [
        grid_corners(part.strips.positions(drive)).reshape(-1, 4, 3)
        for part in design.carried
        if drive >= part.joined_from
    ]
    if drive == design.mechanism.target_drive:
        found += [part.shell.positions[part.mesh.faces] for part in design.attached]
    return found


def _carried(design: Design) -> str:
    """What the sheet carries, by the first of its parts, as it is drawn."""
    kinds = [part.kind for part in design.carried]
    return f", {kinds[0]}{'s' * (kinds.count(kinds[0]) > 1)} drawn" if kinds else ""


def _last_state(design: Design, lock: Lock) -> str:
    if design.ending_at is not None:
        last = {"clash": "Where panels first touch", "unproved": "As far as it is proved to fold"}
        return last.get(lock.cause or "", "As far as it folds")
    aim = "target" if design.swept is not None else "stage"
    if lock.reaches_target is None:
        return f"The {aim}, which it is not proved to reach"
    if lock.early and lock.clipped_contact is None:
        return f"The {aim}, which it does not reach"
    if lock.cause == "flaps":
        return "Locked"
    if design.clipped is not None:
        return "At its target, flaps not drawn"
    return "Folded until it meets the target" if aim == "target" else "Folded to the stage"


def _title(file: DesignFile) -> str:
    pattern = file.pattern
    return f"{FAMILIES[file.family].label}, {pattern.rows} × {pattern.columns} inner vertices"
