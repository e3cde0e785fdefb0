"""What is found of a shell: everything that its report and its files are written from."""

from __future__ import annotations

from dataclasses import replace

from orishell.conventions.errors import printable
from orishell.conventions.progress import Progress, followed
from orishell.conventions.record import record
from orishell.deployment.cutting.report import CuttingReport
from orishell.deployment.report import DeploymentReport, with_ground, with_measures
from orishell.document import Document, DocumentTie
from orishell.document.from_design import document_of_motion
from orishell.motion import FoldingMotion
from orishell.motion.layout import SlitFlaps
from orishell.shell.candidate import Candidate
from orishell.shell.cutting import asks_for_cutting, find_cutting
from orishell.shell.rail_order import rail_order
from orishell.shell.steps import (
    CONTACT,
    CUTTING,
    END_WALLS_PLACED,
    FLAPS_PLACED,
    GUSSETS_PLACED,
    PLATES_PLACED,
    STOCK,
    STRUCTURE,
    Work,
)
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
from orishell.workshop.quantities import Quantities, measure_quantities


@record
class Facts:
    """What was found of a shell."""

    found: Candidate  # its design, lock and motion, and where it stands
    residuals: Residuals | None  # how exactly it folds; None if that was not asked for
    assignment: AssignmentCheck | None  # mountains and valleys in its states; None likewise
    deployment: DeploymentReport  # how it is held, packed and raised, and what the ground bears
    drawn: Document  # its shape in all states, with boards and ties
    quantities: Quantities  # what it is made of
    cutting: CuttingReport | None  # what errors of cutting do to it; None if that was not asked for
    analysis: Analysis | None  # what it bears; None if it was not analysed
    not_checked: tuple[str, ...]  # what nobody looked at, in words


def find_facts(found: Candidate, work: Work) -> Facts:
    """Measure a shell that is proved, and analyse its structure.

    Raises InputError or DesignError as :func:`orishell.shell.make_shell` does.
    """
    return with_structure(measure(found, work), work)


def measure(found: Candidate, work: Work) -> Facts:
    """Measure a shell that is proved; its structure, if the file asks for it, is not looked at.

    Raises InputError or DesignError as :func:`orishell.shell.make_shell` does.
    """
    progress, clock = work.progress, work.clock
    file, design, lock, site = found.file, found.design, found.lock, found.site
    residuals, assignment = _verified(found.motion, progress, work.asks("verification"))
    clock.lap("fold")
    deployment = with_measures(
        found.deployment,
        design,
        lock,
        site,
        packed=work.asks("pack"),
        weighed=work.asks("weight"),
    )
    drawn = _drawn(found, deployment)
    deployment = with_ground(deployment, design, lock, site, drawn)
    quantities = measure_quantities(drawn, file.workshop, nested=work.asks("stock"))
    cutting = None
    if work.asks("cutting"):
        cutting = find_cutting(design, file.workshop, found.feet, progress)
    deviation = found.deviation
    unknown = {
        "whether panels stay rigid": residuals is None,
        CONTACT: work.clash == "unexamined",
        FLAPS_PLACED: design.clipped is not None,
        GUSSETS_PLACED: bool(design.plates),
        PLATES_PLACED: any(part.kind == "plate" for part in design.attached),
        END_WALLS_PLACED: bool(design.end_walls),
        "the ground that is needed on the way": deployment.lacks_ground,
        "distance from the surface": deviation is not None and deviation.surface is None,
        CUTTING: cutting is None and asks_for_cutting(file.workshop),
        STOCK: quantities.stock is None,
        STRUCTURE: file.structure is not None,
    }
    return Facts(
        found=found,
        residuals=residuals,
        assignment=assignment,
        deployment=deployment,
        drawn=drawn,
        quantities=quantities,
        cutting=cutting,
        analysis=None,
        not_checked=tuple(words for words, missing in unknown.items() if missing),
    )


def with_structure(facts: Facts, work: Work) -> Facts:
    """What was measured, with the structure analysed if that is asked for."""
    found = facts.found
    if not work.asks("structure") or found.file.structure is None:
        return facts
    analysis = analyse(
        found.design,
        found.file.structure,
        found.site,
        work.progress,
        built=found.lock.built,
        remedies=work.asks("remedies"),
        briefly=work.briefly,
    )
    order = (*facts.quantities.order, *rail_order(analysis.model))
    work.clock.lap("structure")
    return replace(
        facts,
        deployment=with_anchors(facts.deployment, analysis.anchors),
        quantities=replace(facts.quantities, order=order),
        analysis=analysis,
        not_checked=tuple(each for each in facts.not_checked if each != STRUCTURE),
    )


def _verified(
    motion: FoldingMotion, progress: Progress, asked: bool
) -> tuple[Residuals | None, AssignmentCheck | None]:
    """How exactly all states fold, if that is asked for; refused if that is wrong."""
    if not asked:
        return None, None
    if isinstance(motion.mechanism, SlitFlaps):
        drives = followed(motion.drives, len(motion), progress, "verifying")
        residuals, assignment = measure_with_flaps(motion.mechanism, drives)
    else:
        states = followed(motion, len(motion), progress, "verifying")
        residuals, assignment = measure_residuals(states, motion.flat)
    require_verified(residuals, assignment)
    return residuals, assignment


def _drawn(found: Candidate, deployment: DeploymentReport) -> Document:
    """The shape of a shell in all its states."""
    file, design, built = found.file, found.design, found.lock.built
    size = f"{file.pattern.rows} x {file.pattern.columns}"
    return replace(
        document_of_motion(
            found.motion,
            file.unit,
            title=f"{printable(file.path.stem)}: {file.family}, {size} inner vertices",
            curves=design.targets,
            origin=design.origin,
            clipped=design.clipped,
            carried=design.carried,
            attached=design.attached,
            panel=design.panel,
            boards=None if built is None else built.boards,
            flaps=None if built is None else built.flaps,
        ),
        ties=tuple(DocumentTie(tie.ends, tie.length, tie.slack is True) for tie in deployment.ties),
    )
