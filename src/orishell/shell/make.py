"""From a design file to a verified shell and its report."""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.arguments import checked
from orishell.conventions.errors import DesignError, InputError, Remedy
from orishell.conventions.formatting import tidy_degrees
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.record import record
from orishell.deployment import Site
from orishell.design import Design
from orishell.design_file import DesignFile, read_design_file
from orishell.deviation import Deviation
from orishell.document import Document, FirstContact
from orishell.document.measures import BoxReport, Measures, SheetReport
from orishell.locking import Lock
from orishell.locking.report import describe_panels
from orishell.motion import FoldingMotion, area_of
from orishell.motion.as_made import sheet_sides
from orishell.motion.layout import Layout
from orishell.numerics.arrays import Array
from orishell.shell.candidate import Candidate
from orishell.shell.facts import Facts, measure, with_structure
from orishell.shell.fit.built_size import triangles_of
from orishell.shell.foreseen import require_room_for_panels
from orishell.shell.more_panels import with_more_panels
from orishell.shell.notes import all_notes
from orishell.shell.one_motion import find_joining
from orishell.shell.open_questions import find_candidate
from orishell.shell.remedies import with_remedies
from orishell.shell.report import Report, describe_assignment
from orishell.shell.size_trials import Choice
from orishell.shell.steps import ClashPolicy, Step, Work, require_steps
from orishell.shell.strength_remedy import find_known
from orishell.shell.thickness_remedy import find_stronger
from orishell.shell.two_thicknesses import find_two_thicknesses
from orishell.shell.verdict import find_verdict
from orishell.structure.results import Analysis
from orishell.workshop.fitting import OversizeError


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

    def positions(self, drives: ArrayLike) -> Array:
        """Vertices of the sheet in any states, where files have them: exact, in closed form.

        Parameters
        ----------
        drives
            Drives (...) (radians): 0 is the flat sheet, ``lock.target_drive`` the target.

        Returns
        -------
        Array
            Positions (..., rows, columns, 3) in the world, in the unit of the design.
        """
        return np.asarray(self.design.mechanism.positions(drives) + self.design.origin)

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
        If panels collide: refuse, allow, or do not check.
    """
    return make_shell(read_design_file(path), progress, clash=clash)


def make_shell(
    file: DesignFile,
    progress: Progress = no_progress,
    *,
    clash: ClashPolicy = "refused",
    skip: Collection[Step] = (),
    told: Callable[[Shell], None] | None = None,
) -> Shell:
    """Design a shell, verify its states and prove how its motion ends.

    Parameters
    ----------
    clash
        If panels collide: refuse, allow, or do not check.
    skip
        What is not found out of it; its report says so where a reader might think it was.
    told
        Is given what is known of it so far, before its structure is analysed, and before what would
        have it carry is looked for: both may take minutes.

    Raises
    ------
    InputError
        If a curve is not usable, a setting does not fit the sheet, or there is no such part.
    DesignError
        If the family cannot reach the target, or panels meet before the shell locks.
    VerificationError
        If the result is not rigid: a fault of the program.
    """
    if not isinstance(file, DesignFile):
        raise TypeError("make_shell takes a DesignFile; design_shell reads one from its path")
    require_steps(skip)
    work = Work(progress, clash, skip)
    try:
        if work.asks("stock"):
            require_room_for_panels(file)
        return _made(find_candidate(file, work), work, told)
    except InputError as error:
        if isinstance(error, OversizeError) and work.asks("remedies"):
            error = with_more_panels(file, error, progress)
        raise error.in_file(file.path) from None
    except DesignError as error:
        if clash == "unexamined" or not work.asks("remedies"):
            raise
        raise with_remedies(file, error, progress, work.clock.since_begun) from None


@record
class _Mended:
    """What was tried and mends a shell, or None where nothing was found, or looked for."""

    stronger: Remedy | None = None  # has it carry its loads, or makes known whether it does
    joining: Remedy | None = None  # leaves its sheet one motion


def _made(found: Candidate, work: Work, told: Callable[[Shell], None] | None) -> Shell:
    """The shell of a file that leaves nothing open, and that was proved."""
    clock, progress, mended = work.clock, work.progress, work.asks("remedies")
    proved = work.clash != "unexamined"
    so_far = replace(work, skip=(*work.skip, "remedies"))
    file, facts = found.file, measure(found, work)
    if told is not None and file.structure is not None and work.asks("structure"):
        told(_shell(facts, so_far))
    facts = with_structure(facts, work)
    analysis, stronger = facts.analysis, None
    judged = analysis is not None and analysis.sign in ("fails", "warns")
    if told is not None and judged and mended:
        told(_shell(facts, so_far))
    if analysis is not None and analysis.sign == "fails" and mended:
        stronger = find_stronger(file, analysis, progress)
        clock.lap("remedies")
    elif analysis is not None and analysis.sign == "warns" and mended:
        stronger = find_known(file, analysis, progress)
        clock.lap("remedies")
    joining = None
    if not found.freedom.one_motion and proved and mended:
        joining = find_joining(file, progress)
        clock.lap("remedies")
    return _shell(facts, work, _Mended(stronger, joining))


def _shell(facts: Facts, work: Work, by: _Mended | None = None) -> Shell:
    """The shell, with report and document, of what was found."""
    found, analysis, by = facts.found, facts.analysis, by or _Mended()
    file, design, lock = found.file, found.design, found.lock
    mended = work.clash != "unexamined" and work.asks("remedies")
    two = find_two_thicknesses(file, work.progress, mended=mended)
    report = _report(facts, work)
    verdict = find_verdict(report, by.stronger, file.workshop.stock, by.joining, two)
    report = replace(report, verdict=verdict)
    document = replace(
        facts.drawn,
        ground=report.deployment.ground,
        loaded=None if analysis is None else analysis.loaded(),
        contact=_first_contact(design, lock),
        report=report.as_dict(),
        measures=_measures(report),
    )
    return Shell(
        file=file,
        design=design,
        lock=lock,
        site=found.site,
        motion=found.motion,
        deviation=None if found.deviation is None else found.deviation.surface,
        choice=found.answers.choice,
        document=document,
        report=report,
        seconds=work.clock.seconds,
    )


def _report(facts: Facts, work: Work) -> Report:
    """What ``report.json`` says of a shell, but for the verdict."""
    found, analysis, answers = facts.found, facts.analysis, facts.found.answers
    file, design, lock = found.file, found.design, found.lock
    width, height, strips = sheet_sides(design.mechanism)
    opened = _box(facts.drawn.sheet)
    return Report(
        family=file.family,
        unit=file.unit,
        rows=file.pattern.rows,
        columns=file.pattern.columns,
        parameters=design.parameters,
        families=answers.families,
        by_curves=design.by_curves,
        turned=answers.turned,
        chosen=answers.choice,
        fitted=answers.fitted,
        feasible=None if work.clash == "unexamined" else lock.reaches_target,
        degrees_of_freedom=found.freedom.count,
        freedom=found.freedom,
        warnings=all_notes(facts, work),
        residuals=facts.residuals,
        assignment=describe_assignment(design, facts.assignment),
        lock=lock,
        not_checked=facts.not_checked,
        stands=found.feet,
        deviation=found.deviation,
        end_walls=design.end_walls,
        sheet=SheetReport(width, height, area_of(design.mechanism), strips),
        deployed=opened,
        outside=_box(facts.drawn) if facts.drawn.attached else opened,
        deployment=facts.deployment,
        cutting=facts.cutting,
        panel=describe_panels(design, lock),
        structure=analysis,
        quantities=facts.quantities,
    )


def _measures(report: Report) -> Measures:
    """What a document needs to know of a shell beside its drawing."""
    held, stands = report.deployment, report.stands
    packs = held.pieces or tuple(each for each in (held.packed,) if each is not None)
    return Measures(
        unit=report.unit,
        columns=report.columns,
        starts_packed=held.start == "pack",
        shuts=held.closing == "flaps",
        deployed=report.deployed,
        outside=report.outside,
        packs=tuple((each.length, each.width, each.height) for each in packs),
        layers=max((each.layers for each in packs), default=0),
        mass=report.quantities.mass,
        feet=None if stands is None else stands.rows,
        points=() if stands is None else stands.points,
        freedom=report.freedom,
        strings=tuple(each for wall in report.end_walls for each in wall.lengths.tolist()),
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
