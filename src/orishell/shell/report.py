"""The report of a shell: what ``report.json`` says, field by field.

Lengths and areas are in the design's unit, angles in degrees where a name ends in ``_deg`` and in
radians where it ends in ``_rad``. Panels are pairs of row and column, from 0.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict

import numpy as np

from orishell.conventions.record import record
from orishell.deployment.feet import Feet
from orishell.design import Design, Parameter
from orishell.deviation.report import DeviationReport
from orishell.families.pattern import Tolerance
from orishell.locking.report import LockReport, PanelReport
from orishell.motion import find_assignment
from orishell.shell.deployment_report import DeploymentReport
from orishell.shell.size_trials import Choice, Trial
from orishell.shell.verdict import Row
from orishell.structure.report import StructureReport
from orishell.verification.residuals import AssignmentCheck, Residuals
from orishell.workshop.quantities import Quantities


@record
class AssignmentReport:
    """How many creases are mountains and valleys, and whether they stay so.

    Parameters
    ----------
    mountain, valley, unfolded
        Numbers of creases.
    constant
        Whether no crease changes from one to the other in the whole motion; None if that was not
        measured.
    maekawa
        Whether Maekawa's condition holds at every inner vertex; None if that was not measured.
    """

    mountain: int
    valley: int
    unfolded: int
    constant: bool | None
    maekawa: bool | None


@record
class StandsReport:
    """What the shell stands on.

    Parameters
    ----------
    rows
        The rows of vertices that are its feet.
    z
        Height of the lowest of their vertices.
    uneven
        By how much the highest lies above it.
    level
        Whether all are at one height.
    """

    rows: tuple[int, int]
    z: float
    uneven: float
    level: bool


@record
class ChosenReport:
    """How rows and columns were chosen.

    Parameters
    ----------
    tolerance, panel_min, panel_max
        What was asked for; ``panel_max`` is None if edges may have any length.
    rows, columns, panels, error, shortest, longest
        The design that was chosen, see :class:`~orishell.shell.size_trials.Trial`.
    designs_tried
        Number of designs measured.
    tradeoff
        Designs that no other beats in both error and number of panels.
    """

    tolerance: float
    panel_min: float
    panel_max: float | None
    rows: int
    columns: int
    panels: int
    error: float
    shortest: float
    longest: float
    designs_tried: int
    tradeoff: tuple[Trial, ...]


@record
class SheetReport:
    """Size of the flat sheet.

    Parameters
    ----------
    width, height
        Its bounding box.
    area
        Area of all panels.
    """

    width: float
    height: float
    area: float


@record
class BoxReport:
    """Bounding box of a state.

    Parameters
    ----------
    width, depth, height
        Along x, y and z.
    """

    width: float
    depth: float
    height: float


@record
class Report:
    """All that ``report.json`` says of a shell.

    Parameters
    ----------
    family, unit, rows, columns
        What was designed.
    parameters
        What the family used and found.
    chosen
        How rows and columns were chosen, if there was a tolerance.
    feasible
        Whether it reaches its target without contact; None if that was not examined.
    warnings
        Sentences a user should read.
    residuals, assignment
        How exactly it folds; None if that was not measured.
    lock
        How the motion ends.
    not_checked
        What was left out on request.
    stands
        What it stands on; None if it cannot stand.
    deviation
        How close it is to its target; None without one.
    sheet, deployed
        Sizes of the flat sheet and of the shell.
    deployment
        How it is deployed and held, and how small it packs.
    panel
        Panels as they are built; None if they have no thickness.
    structure
        The shell as a structure; None if it was not analysed.
    quantities
        Bill of quantities.
    verdict
        The findings, worst first.
    """

    family: str
    unit: str
    rows: int
    columns: int
    parameters: Mapping[str, Parameter]
    chosen: ChosenReport | None
    feasible: bool | None
    warnings: tuple[str, ...]
    residuals: Residuals | None
    assignment: AssignmentReport
    lock: LockReport
    not_checked: tuple[str, ...]
    stands: StandsReport | None
    deviation: DeviationReport | None
    sheet: SheetReport
    deployed: BoxReport
    deployment: DeploymentReport
    panel: PanelReport | None
    structure: StructureReport | None
    quantities: Quantities
    verdict: tuple[Row, ...] = ()

    def __repr__(self) -> str:
        size = f"{self.rows} x {self.columns} inner vertices"
        said = f"feasible: {self.feasible}, warnings: {len(self.warnings)}"
        return f"{type(self).__name__}({self.family}, {size}; {said})"

    def as_dict(self) -> dict[str, object]:
        """The report as nested tables for JSON, without ``chosen`` if there was no tolerance."""
        tables = asdict(self)
        if self.chosen is None:
            del tables["chosen"]
        return tables


def describe_assignment(design: Design, check: AssignmentCheck | None) -> AssignmentReport:
    """Mountains and valleys."""
    signs = find_assignment(design.mechanism)
    creases = np.concatenate([signs.row.ravel(), signs.column.ravel()])
    return AssignmentReport(
        mountain=int((creases < 0).sum()),
        valley=int((creases > 0).sum()),
        unfolded=int((creases == 0).sum()),
        constant=None if check is None else check.constant,
        maekawa=None if check is None else check.maekawa,
    )


def describe_feet(design: Design, feet: Feet | None) -> StandsReport | None:
    """What the shell stands on; None if it cannot stand."""
    if feet is None:
        return None
    return StandsReport(
        rows=feet.rows,
        z=float(feet.lowest + design.origin[2]),
        uneven=0.0 if feet.level else feet.uneven,
        level=feet.level,
    )


def describe_choice(choice: Choice, tolerance: Tolerance) -> ChosenReport:
    """What rows and columns were chosen from."""
    trial = choice.trial
    return ChosenReport(
        tolerance=tolerance.surface,
        panel_min=tolerance.panel_min,
        panel_max=tolerance.panel_max if math.isfinite(tolerance.panel_max) else None,
        rows=trial.rows,
        columns=trial.columns,
        panels=trial.panels,
        error=trial.error,
        shortest=trial.shortest,
        longest=trial.longest,
        designs_tried=choice.tried,
        tradeoff=choice.tradeoff,
    )
