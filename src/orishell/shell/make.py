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
from orishell.deployment.feet import find_feet, stand
from orishell.design import Design
from orishell.design_file import DesignFile, read_design_file
from orishell.deviation import (
    Deviation,
    measure_approach,
    measure_deviation,
)
from orishell.deviation.report import describe_deviation
from orishell.document import Document, FirstContact
from orishell.document.from_design import document_of_motion
from orishell.locking import (
    Lock,
    lock_without_clash,
    require_pack,
)
from orishell.locking.report import describe_lock, describe_panels
from orishell.motion import FoldingMotion, extents, sheet_area
from orishell.shell.caveats import find_caveats, warn_of_lock
from orishell.shell.deployment_report import describe_deployment
from orishell.shell.designed import designed, ended
from orishell.shell.holding import warn_of_deployment
from orishell.shell.remedies import with_remedies
from orishell.shell.report import (
    BoxReport,
    Report,
    SheetReport,
    describe_assignment,
    describe_choice,
    describe_feet,
)
from orishell.shell.size_trials import Choice
from orishell.shell.steps import Clock, Question, Step, not_checked, require_steps
from orishell.shell.structure import load_shell
from orishell.shell.tolerance import meet_tolerance
from orishell.shell.verdict import find_verdict
from orishell.structure.results import Analysis
from orishell.verification.residuals import measure_residuals, require_verified
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
    motion: FoldingMotion  # its states
    # how close the locked shell is to the surface asked for; None if that was not measured, or
    # there is no target
    deviation: Deviation | None
    choice: Choice | None  # how rows and columns were chosen, if there was a tolerance
    document: Document  # what its files are written from
    report: Report  # what ``report.json`` says
    seconds: dict[str, float]  # time spent by step; printed, but not part of any file
    # what was found of it as a structure; None if it was not analysed
    analysis: Analysis | None = None

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


def _made(
    file: DesignFile, progress: Progress, clash: ClashPolicy, skip: Collection[Step]
) -> Shell:
    """The shell of a file, which is refused without remedies."""
    clock = Clock()
    file, design, lock, choice = _designed(file, progress, clash, clock)
    feet = find_feet(design)
    if file.ground == "z0":
        design = stand(design, feet)
    motion = _motion(file, design, lock)
    flat = motion.flat
    residuals = assignment = None
    if "verification" not in skip:
        residuals, assignment = measure_residuals(
            followed(motion, len(motion), progress, "verifying"), flat
        )
        require_verified(residuals, assignment)
    clock.lap("fold")

    deviation = approach = None
    if design.swept is not None and "deviation" not in skip:
        deviation, approach = measure_deviation(design), measure_approach(design)
    clock.lap("deviation")

    document = _document(file, design, lock, motion)
    try:
        deployment = describe_deployment(file, design, lock, feet, skip)
        quantities = measure_quantities(document, file.workshop, nested="stock" not in skip)
        structure = analysis = None
        if "structure" not in skip and file.structure is not None:
            found = load_shell(file, design, lock, file.structure, progress)
            analysis, structure = found.analysis, found.report
            document = replace(document, loaded=found.drawn)
            clock.lap("structure")
    except InputError as error:
        raise error.in_file(file.path) from None
    width, height, _ = extents(flat.positions)
    found_out: dict[Question, bool] = {
        "verification": residuals is not None,
        "clash": clash != "unexamined",
        "clipping": design.clipped is None,
        "deviation": deviation is not None or design.swept is None,
        "stock": quantities.stock is not None,
        "structure": structure is not None or file.structure is None,
    }
    report = Report(
        family=file.family,
        unit=file.unit,
        rows=file.pattern.rows,
        columns=file.pattern.columns,
        parameters=design.parameters,
        chosen=None if choice is None else describe_choice(choice),
        feasible=None if clash == "unexamined" else not lock.early,
        warnings=(
            *design.warnings,
            *warn_of_lock(lock),
            *find_caveats(design, lock, feet, file.unit, file.workshop),
            *warn_of_deployment(file, design, lock, deployment, skip),
            *([] if structure is None else structure.warnings),
        ),
        residuals=residuals,
        assignment=describe_assignment(design, assignment),
        lock=describe_lock(lock),
        not_checked=not_checked(found_out),
        stands=describe_feet(design, feet),
        deviation=describe_deviation(design, deviation, approach)
        if design.swept is not None
        else None,
        sheet=SheetReport(width, height, sheet_area(flat.positions)),
        deployed=BoxReport(*extents(motion.target.positions)),
        deployment=deployment,
        panel=describe_panels(design, lock),
        structure=structure,
        quantities=quantities,
    )
    report = replace(report, verdict=find_verdict(report))
    document = replace(document, report=report.as_dict(), contact=_first_contact(design, lock))
    return Shell(
        file, design, lock, motion, deviation, choice, document, report, clock.seconds, analysis
    )


def _designed(
    file: DesignFile,
    progress: Progress,
    clash: ClashPolicy,
    clock: Clock,
) -> tuple[DesignFile, Design, Lock, Choice | None]:
    """The file with rows and columns, its design, how its motion ends, and the choice made."""
    choice: Choice | None = None
    try:
        if file.tolerance is not None:
            file, choice = meet_tolerance(file, file.tolerance, progress)
            clock.lap("choose")
        design = designed(file)
        clock.lap("design")
        if clash == "unexamined":
            lock = lock_without_clash(design)
        else:
            design, lock = ended(file, design, allow_clash=clash == "allowed", progress=progress)
            clock.lap("clash")
        if file.deployment.start == "pack":
            require_pack(design, lock)
    except InputError as error:
        raise error.in_file(file.path) from None
    return file, design, lock, choice


def _motion(file: DesignFile, design: Design, lock: Lock) -> FoldingMotion:
    if file.deployment.start == "flat":
        return FoldingMotion(design.mechanism, file.frames)
    return FoldingMotion(design.mechanism, file.frames, lock.closes_to)


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
