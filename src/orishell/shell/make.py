"""From a design file to a verified shell and its report."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from pathlib import Path
from typing import Literal

from orishell.conventions.arguments import checked
from orishell.conventions.errors import DesignError, InputError, printable
from orishell.conventions.formatting import tidy_degrees
from orishell.conventions.progress import Progress, followed, no_progress
from orishell.conventions.record import record
from orishell.deployment import Site, find_site
from orishell.deployment.feet import find_feet, stand
from orishell.deployment.report import describe_deployment
from orishell.design import Design
from orishell.design_file import DesignFile, read_design_file
from orishell.deviation import Deviation
from orishell.deviation.report import describe_deviation
from orishell.document import Document, FirstContact
from orishell.document.from_design import document_of_motion
from orishell.families.registry import AUTO
from orishell.locking import Lock, lock_without_clash, require_pack
from orishell.locking.report import describe_panels
from orishell.motion import FoldingMotion, extents, sheet_area
from orishell.shell.build_warnings import warn_of_building
from orishell.shell.deployment_warnings import warn_of_deployment
from orishell.shell.designed import designed, ended
from orishell.shell.families import FamilyChoice, choose_family
from orishell.shell.remedies import with_remedies
from orishell.shell.report import (
    BoxReport,
    Report,
    SheetReport,
    describe_assignment,
)
from orishell.shell.size_trials import Choice
from orishell.shell.steps import MEASURES, Clock, Step, require_steps
from orishell.shell.stronger import find_stronger
from orishell.shell.tolerance import meet_tolerance
from orishell.shell.turn_search import choose_turn
from orishell.shell.verdict import find_verdict
from orishell.structure.analyse import analyse
from orishell.structure.results import Analysis
from orishell.verification.residuals import (
    AssignmentCheck,
    Residuals,
    measure_residuals,
    require_verified,
)
from orishell.workshop.quantities import measure_quantities

ClashPolicy = Literal["refused", "allowed", "unexamined"]
"""What becomes of a shell whose panels meet before its target: it is refused, or made and said to
clash; or nobody looks, for sheets of hundreds of thousands of panels."""


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


def _analysed(file: DesignFile, progress: Progress) -> Analysis | None:
    """The structure of a file that is tried, whose boards must reach its target."""
    return _made(file, progress, "refused", (*MEASURES, "remedies", "stock")).analysis


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
    file, families = _in_family(file, progress)
    if families is not None:
        clock.lap("family")
    file, turned = choose_turn(file, progress)
    if turned is not None:
        clock.lap("turn")
    file, choice = _sized(file, progress)
    if choice is not None:
        clock.lap("choose")
    design = designed(file, progress)
    clock.lap("design")
    design, lock = _ended(file, design, clash, progress)
    if clash != "unexamined":
        clock.lap("clash")
    if file.deployment.start == "pack":
        require_pack(design, lock)
    feet = find_feet(design)
    if file.ground == "z0":
        design, feet = stand(design, feet)
    motion = FoldingMotion(
        design.mechanism, file.frames, None if file.deployment.start == "flat" else lock.closes_to
    )
    residuals, assignment = _verified(motion, progress, "verification" not in skip)
    clock.lap("fold")
    deviation = describe_deviation(design, measured="deviation" not in skip)
    clock.lap("deviation")
    site = find_site(
        design,
        feet,
        file.deployment,
        lock.built,
        unit=file.unit,
        areal_density=file.workshop.areal_density,
    )
    deployment = describe_deployment(
        design,
        lock,
        site,
        file.deployment.start,
        packed="pack" not in skip,
        weighed="weight" not in skip,
    )
    document = _document(file, design, lock, motion)
    quantities = measure_quantities(document, file.workshop, nested="stock" not in skip)
    analysis = None
    if "structure" not in skip and file.structure is not None:
        analysis = analyse(design, file.structure, site, progress, built=lock.built)
        document = replace(document, loaded=analysis.loaded())
        clock.lap("structure")
    unknown = {
        "whether panels stay rigid": residuals is None,
        "contact between panels on the way": clash == "unexamined",
        "how clipped flaps are brought to their place": design.clipped is not None,
        "distance from the surface": deviation is not None and deviation.surface is None,
        "the layout on the stock": quantities.stock is None,
        "the structure": analysis is None and file.structure is not None,
    }
    width, height, _ = extents(motion.flat.positions)
    report = Report(
        family=file.family,
        unit=file.unit,
        rows=file.pattern.rows,
        columns=file.pattern.columns,
        parameters=design.parameters,
        families=families,
        by_curves=design.by_curves,
        turned=turned,
        chosen=choice,
        feasible=None if clash == "unexamined" else not lock.early,
        warnings=(
            *design.warnings,
            *lock.warnings,
            *warn_of_building(design, lock, feet, file.unit, file.workshop),
            *warn_of_deployment(file, design, lock, deployment, mended="remedies" not in skip),
            *(() if analysis is None else analysis.warnings),
        ),
        residuals=residuals,
        assignment=describe_assignment(design, assignment),
        lock=lock,
        not_checked=tuple(words for words, missing in unknown.items() if missing),
        stands=feet,
        deviation=deviation,
        sheet=SheetReport(width, height, sheet_area(motion.flat.positions)),
        deployed=BoxReport(*extents(motion.target.positions)),
        deployment=deployment,
        panel=describe_panels(design, lock),
        structure=analysis,
        quantities=quantities,
    )
    stronger = ""
    if analysis is not None and analysis.sign == "fails" and "remedies" not in skip:
        stronger = find_stronger(file, analysis, _analysed, progress)
        clock.lap("remedies")
    report = replace(report, verdict=find_verdict(report, stronger))
    document = replace(document, report=report.as_dict(), contact=_first_contact(design, lock))
    return Shell(
        file=file,
        design=design,
        lock=lock,
        site=site,
        motion=motion,
        deviation=None if deviation is None else deviation.surface,
        choice=choice,
        document=document,
        report=report,
        seconds=clock.seconds,
    )


def _in_family(file: DesignFile, progress: Progress) -> tuple[DesignFile, FamilyChoice | None]:
    """The file with a family, and what all of them make of it if that is left open."""
    if file.family != AUTO:
        return file, None
    return choose_family(file, _compared, progress)


def _compared(file: DesignFile, progress: Progress) -> Shell:
    """The shell of a file in one of the families, as far as these are compared."""
    skip: tuple[Step, ...] = ("remedies", "verification", "pack", "weight", "stock", "structure")
    return _made(file, progress, "refused", skip)


def _sized(file: DesignFile, progress: Progress) -> tuple[DesignFile, Choice | None]:
    """The file with rows and columns, and what they were chosen from if it has a tolerance."""
    if file.tolerance is None:
        return file, None
    return meet_tolerance(file, file.tolerance, progress)


def _ended(
    file: DesignFile, design: Design, clash: ClashPolicy, progress: Progress
) -> tuple[Design, Lock]:
    if clash == "unexamined":
        return design, lock_without_clash(design)
    return ended(file, design, allow_clash=clash == "allowed", progress=progress)


def _verified(
    motion: FoldingMotion, progress: Progress, asked: bool
) -> tuple[Residuals | None, AssignmentCheck | None]:
    """How exactly all states fold, if that is asked for; refused if that is wrong."""
    if not asked:
        return None, None
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


def _first_contact(design: Design, lock: Lock) -> FirstContact | None:
    contact = lock.first_contact
    if contact is None:
        return None
    across = design.mechanism.grid.columns - 1
    first, second = (row * across + column for row, column in contact.panels)
    return FirstContact(tidy_degrees(contact.drive), (first, second))
