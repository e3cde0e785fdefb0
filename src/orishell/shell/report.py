"""The report of a shell: what ``report.json`` says, field by field.

Lengths and areas are in the design's unit, angles in degrees where a name ends in ``_deg`` and in
radians where it ends in ``_rad``. Panels are pairs of row and column, from 0.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from orishell.conventions.record import as_table, record
from orishell.conventions.row import Row
from orishell.deployment.cutting import CuttingReport
from orishell.deployment.feet import Feet
from orishell.deployment.report import DeploymentReport
from orishell.design import Design, Parameter
from orishell.design.end_walls import BuiltEndWall
from orishell.deviation.report import DeviationReport
from orishell.document.measures import BoxReport, SheetReport
from orishell.locking import Lock
from orishell.locking.report import PanelReport
from orishell.motion import find_assignment
from orishell.motion.freedom import FreedomOfSheet
from orishell.shell.family_choice import FamilyChoice
from orishell.shell.fit.report import FittedSize
from orishell.shell.size_trials import Choice
from orishell.shell.turn_search import TurnChoice
from orishell.structure.results import Analysis
from orishell.verification.residuals import AssignmentCheck, Residuals
from orishell.workshop.quantities import Quantities


@record
class AssignmentReport:
    """How many creases are mountains and valleys, and whether they stay so."""

    # numbers of creases
    mountain: int
    valley: int
    unfolded: int
    # whether no crease changes from one to the other in the whole motion; None if that was not
    # measured
    constant: bool | None
    # whether Maekawa's condition holds at every inner vertex; None if that was not measured
    maekawa: bool | None


@record
class Report:
    """All that ``report.json`` says of a shell."""

    # what was designed
    family: str
    unit: str
    rows: int
    columns: int
    parameters: Mapping[str, Parameter]  # what the family used and found
    # what all families make of the target, if the file leaves the family open
    families: FamilyChoice | None
    # with which values of its keys the design file asks for the same shell by f and g, where these
    # were fitted to a surface
    by_curves: Mapping[str, Any]
    # how the rectangle of its surface is turned, if the file leaves that open
    turned: TurnChoice | None
    chosen: Choice | None  # how rows and columns were chosen, if there was a tolerance
    fitted: FittedSize | None  # how its target was scaled, if sizes were asked for
    # whether it reaches its target without contact; None if that was not examined, or not proved
    feasible: bool | None
    # how many motions its sheet has, of a sheet in pieces that of the piece that has most; None if
    # that is not known
    degrees_of_freedom: int | None
    freedom: FreedomOfSheet  # what tells them, and what folds by itself
    warnings: tuple[str, ...]  # sentences a user should read
    # how exactly it folds; None if that was not measured
    residuals: Residuals | None
    assignment: AssignmentReport
    lock: Lock  # how the motion ends
    not_checked: tuple[str, ...]  # what was left out on request
    stands: Feet | None  # what it stands on; None if it cannot stand
    deviation: DeviationReport | None  # how close it is to its target; None without one
    end_walls: tuple[BuiltEndWall, ...]  # what closes its ends
    sheet: SheetReport  # size of the flat sheet
    # the box around what folds, its boards where panels have a thickness; and around all that is
    # built, with flaps that are clipped on
    deployed: BoxReport
    outside: BoxReport
    deployment: DeploymentReport  # how it is deployed and held, and how small it packs
    # what follows if it is cut with errors; None if the file gives none
    cutting: CuttingReport | None
    panel: PanelReport | None  # panels as they are built; None if they have no thickness
    structure: Analysis | None  # the shell as a structure; None if it was not analysed
    quantities: Quantities  # bill of quantities
    verdict: tuple[Row, ...] = ()  # the findings, worst first

    def __repr__(self) -> str:
        size = f"{self.rows} x {self.columns} inner vertices"
        said = f"feasible: {self.feasible}, warnings: {len(self.warnings)}"
        return f"{type(self).__name__}({self.family}, {size}; {said})"

    def as_dict(self) -> dict[str, object]:
        """The report as nested tables for JSON, without what was not asked for."""
        tables: dict[str, object] = as_table(self)
        for key in ("families", "by_curves", "turned", "chosen", "fitted", "end_walls", "cutting"):
            if not getattr(self, key):
                del tables[key]
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
