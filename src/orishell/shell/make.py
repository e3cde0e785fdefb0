"""From a design file to a verified shell and its report."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from pathlib import Path

import numpy as np

from orishell.conventions.arguments import checked
from orishell.conventions.errors import DesignError, InputError, printable
from orishell.conventions.formatting import tidy_degrees
from orishell.conventions.progress import Progress, followed, no_progress
from orishell.conventions.record import record
from orishell.deployment import Site
from orishell.deployment.report import with_ground, with_measures
from orishell.design import Design
from orishell.design_file import DesignFile, read_design_file
from orishell.deviation import Deviation
from orishell.document import Document, DocumentTie, FirstContact
from orishell.document.from_design import document_of_motion
from orishell.document.sizes import BoxReport, SheetReport
from orishell.families.registry import AUTO
from orishell.locking import Lock
from orishell.locking.report import describe_panels
from orishell.motion import FoldingMotion, area_of, extents
from orishell.motion.layout import LaidOut, Layout, points_of
from orishell.shell.build_warnings import warn_of_building
from orishell.shell.candidate import ClashPolicy, find_candidate
from orishell.shell.cutting import asks_for_cutting, find_cutting, warn_of_cutting
from orishell.shell.deployment_warnings import warn_of_deployment
from orishell.shell.families import choose_family
from orishell.shell.fit.built_size import triangles_of
from orishell.shell.one_motion import find_joining, warn_of_freedom
from orishell.shell.piece_warnings import warn_of_joints
from orishell.shell.remedies import with_remedies
from orishell.shell.report import Report, describe_assignment
from orishell.shell.size_trials import Choice
from orishell.shell.steps import MEASURES, Clock, Step, require_steps
from orishell.shell.thickness_remedy import Stronger, find_stronger
from orishell.shell.two_thicknesses import find_two_thicknesses
from orishell.shell.verdict import CONTACT, CUTTING, STOCK, STRUCTURE, find_verdict
from orishell.structure.analyse import analyse
from orishell.structure.anchors import with_anchors
from orishell.structure.results import Analysis
from orishell.verification.residuals import (
    AssignmentCheck,
    Residuals,
    measure_residuals,
    measure_with_flaps,
    require_verified,
)
from orishell.workshop.quantities import measure_quantities


@record
class Shell:
    """A designed and verified shell."""

    file: DesignFile  # the design file
    design: Design  # what the family made of it
    lock: Lock  # how its motion ends
    site: Site  # where it stands, what ties it, and what it weighs
    motion: FoldingMotion  # its states
    # how close the locked shell is to the surface asked for; None if that was not measured, or
    # there is no target
    deviation: Deviation | None
    choice: Choice | None  # how rows and columns were chosen, if there was a tolerance
    document: Document  # what its files are written from
    report: Report  # what ``report.json`` says
    seconds: dict[str, float]  # time spent by step; printed, but not part of any file

    @property
    def analysis(self) -> Analysis | None:
        """What was found of it as a structure; None if it was not analysed."""
        return self.report.structure

    def __repr__(self) -> str:
        file = self.file
        size = f"{file.pattern.rows} x {file.pattern.columns} inner vertices"
        return f"{type(self).__name__}({file.path.stem!r}, {file.family}, {size}; {self.lock!r})"


@checked()
def design_shell(
    path: str | Path, progress: Progress = no_progress, *, clash: ClashPolicy = "refused"
) -> Shell:
    """Read a design file and make its shell: see :func:`make_shell`.

    Parameters
    ----------
    path
        The design file.
    clash
        What becomes of a shell whose panels meet.
    """
    return make_shell(read_design_file(path), progress, clash=clash)


def make_shell(
    file: DesignFile,
    progress: Progress = no_progress,
    *,
    clash: ClashPolicy = "refused",
    skip: Collection[Step] = (),
) -> Shell:
    """Design a shell, verify its states and prove how its motion ends.

    Parameters
    ----------
    clash
        What becomes of a shell whose panels meet.
    skip
        What is not found out of it; its report says so where a reader might think it was.

    Raises
    ------
    InputError
        If a curve is not usable, a setting does not fit the sheet, or there is no such part.
    DesignError
        If the family cannot reach the target, or panels meet before the shell locks.
    VerificationError
        If the result is not rigid: a fault of the program.
    """
    require_steps(skip)
    try:
        return _made(file, progress, clash, skip)
    except DesignError as error:
        if clash == "unexamined" or "remedies" in skip:
            raise
        raise with_remedies(file, error, _tried, progress) from None


def _tried(file: DesignFile, progress: Progress) -> Shell:
    """The shell of a file that is tried: what cannot refuse it is left out."""
    return _made(file, progress, "refused", ("remedies", "deviation"))


def _analysed(file: DesignFile, progress: Progress, quick: bool) -> tuple[Analysis | None, bool]:
    """The structure of a file that is tried, and whether all its ties are proved slack on the way.

    quick: Whether it is left open if its boards reach its target.
    """
    policy: ClashPolicy = "unexamined" if quick else "refused"
    shell = _made(file, progress, policy, (*MEASURES, "remedies", "stock", "verification"))
    return shell.analysis, all(tie.slack is not False for tie in shell.report.deployment.ties)


def _joined(file: DesignFile, progress: Progress) -> bool:
    """Whether the shell of a file that is tried has one motion and reaches its target."""
    skip: tuple[Step, ...] = (*MEASURES, "remedies", "stock", "structure", "verification")
    return _made(file, progress, "refused", skip).report.freedom.one_motion


def _reached(file: DesignFile, progress: Progress) -> bool:
    """Whether the shell of a file that is tried is proved to reach its target."""
    skip: tuple[Step, ...] = (*MEASURES, "remedies", "stock", "structure", "verification")
    return _made(file, progress, "refused", skip).report.feasible is True


def _made(
    file: DesignFile, progress: Progress, clash: ClashPolicy, skip: Collection[Step]
) -> Shell:
    """The shell of a file, which is refused without remedies."""
    try:
        return _step_by_step(file, progress, clash, skip)
    except InputError as error:
        raise error.in_file(file.path) from None


def _step_by_step(
    file: DesignFile, progress: Progress, clash: ClashPolicy, skip: Collection[Step]
) -> Shell:
    clock = Clock()
    families = None
    if file.family == AUTO:
        found, families = choose_family(file, progress)
        clock.lap("family")
    else:
        found = find_candidate(file, progress, clash, skip, clock)
    file, design, lock, motion = found.file, found.design, found.lock, found.motion
    feet, site, deviation = found.feet, found.site, found.deviation
    residuals, assignment = _verified(motion, progress, "verification" not in skip)
    clock.lap("fold")
    deployment = with_measures(
        found.deployment,
        design,
        lock,
        site,
        packed="pack" not in skip,
        weighed="weight" not in skip,
    )
    document = _document(file, design, lock, motion)
    deployment = with_ground(deployment, design, lock, site, document)
    ties = tuple(DocumentTie(tie.ends, tie.length, tie.slack is True) for tie in deployment.ties)
    document = replace(document, ties=ties, ground=deployment.ground)
    quantities = measure_quantities(document, file.workshop, nested="stock" not in skip)
    cutting = None
    if "cutting" not in skip:
        cutting = find_cutting(design, file.workshop, feet, progress)
    analysis = None
    if "structure" not in skip and file.structure is not None:
        analysis = analyse(design, file.structure, site, progress, built=lock.built)
        document = replace(document, loaded=analysis.loaded())
        deployment = with_anchors(deployment, analysis.anchors)
        document = replace(document, ground=deployment.ground)
        clock.lap("structure")
    unknown = {
        "whether panels stay rigid": residuals is None,
        CONTACT: clash == "unexamined",
        "how clipped flaps are brought to their place": design.clipped is not None,
        "the ground that is needed on the way": deployment.lacks_ground,
        "distance from the surface": deviation is not None and deviation.surface is None,
        CUTTING: cutting is None and asks_for_cutting(file.workshop),
        STOCK: quantities.stock is None,
        STRUCTURE: analysis is None and file.structure is not None,
    }
    width, height, _ = extents(points_of(design.mechanism, 0.0))
    opened = _box(replace(document, clipped=()))
    report = Report(
        family=file.family,
        unit=file.unit,
        rows=file.pattern.rows,
        columns=file.pattern.columns,
        parameters=design.parameters,
        families=families,
        by_curves=design.by_curves,
        turned=found.turned,
        chosen=found.choice,
        fitted=found.fitted,
        feasible=None if clash == "unexamined" else lock.reaches_target,
        degrees_of_freedom=found.freedom.count,
        freedom=found.freedom,
        warnings=(
            *file.notes,
            *design.warnings,
            *lock.warnings,
            *warn_of_freedom(found.freedom),
            *warn_of_building(design, lock, feet, file.unit, file.workshop),
            *warn_of_joints(design, lock, file.unit),
            *warn_of_deployment(
                file,
                design,
                lock,
                deployment,
                mended="remedies" not in skip,
                one=found.freedom.one_motion,
            ),
            *warn_of_cutting(design, cutting, file.unit),
            *(() if analysis is None else analysis.warnings),
        ),
        residuals=residuals,
        assignment=describe_assignment(design, assignment),
        lock=lock,
        not_checked=tuple(words for words, missing in unknown.items() if missing),
        stands=feet,
        deviation=deviation,
        sheet=SheetReport(width, height, area_of(design.mechanism)),
        deployed=opened,
        outside=_box(document) if document.clipped else opened,
        deployment=deployment,
        cutting=cutting,
        panel=describe_panels(design, lock),
        structure=analysis,
        quantities=quantities,
    )
    stronger = Stronger()
    if analysis is not None and analysis.sign == "fails" and "remedies" not in skip:
        stronger = find_stronger(file, analysis, _analysed, progress)
        clock.lap("remedies")
    joining = None
    if not found.freedom.one_motion and clash != "unexamined" and "remedies" not in skip:
        joining = find_joining(file, _joined, progress)
        clock.lap("remedies")
    trial = None if clash == "unexamined" or "remedies" in skip else _reached
    two = find_two_thicknesses(file, trial, progress)
    verdict = find_verdict(report, stronger, file.workshop.stock, joining, two)
    report = replace(report, verdict=verdict)
    document = replace(document, report=report.as_dict(), contact=_first_contact(design, lock))
    return Shell(
        file=file,
        design=design,
        lock=lock,
        site=site,
        motion=motion,
        deviation=None if deviation is None else deviation.surface,
        choice=found.choice,
        document=document,
        report=report,
        seconds=clock.seconds,
    )


def _verified(
    motion: FoldingMotion, progress: Progress, asked: bool
) -> tuple[Residuals | None, AssignmentCheck | None]:
    """How exactly all states fold, if that is asked for; refused if that is wrong."""
    if not asked:
        return None, None
    if isinstance(motion.mechanism, LaidOut):
        drives = followed(motion.drives, len(motion), progress, "verifying")
        residuals, assignment = measure_with_flaps(motion.mechanism, drives)
    else:
        states = followed(motion, len(motion), progress, "verifying")
        residuals, assignment = measure_residuals(states, motion.flat)
    require_verified(residuals, assignment)
    return residuals, assignment


def _document(file: DesignFile, design: Design, lock: Lock, motion: FoldingMotion) -> Document:
    size, built = f"{file.pattern.rows} x {file.pattern.columns}", lock.built
    return document_of_motion(
        motion,
        file.unit,
        title=f"{printable(file.path.stem)}: {file.family}, {size} inner vertices",
        curves=design.targets,
        origin=design.origin,
        clipped=design.clipped,
        panel=design.panel,
        boards=None if built is None else built.boards,
        flaps=None if built is None else built.flaps,
    )


def _box(document: Document) -> BoxReport:
    """The box around all that is built, as it stands."""
    return BoxReport(*np.ptp(triangles_of(document).reshape(-1, 3), axis=0).tolist())


def _first_contact(design: Design, lock: Lock) -> FirstContact | None:
    contact = lock.first_contact
    if contact is None or contact.apart is not None:
        return None
    layout = Layout.of(design.mechanism)
    first, second = (layout.name(row, column) for row, column in contact.panels)
    return FirstContact(tidy_degrees(contact.drive), (first, second))
