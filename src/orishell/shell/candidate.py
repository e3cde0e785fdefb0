"""The part of the work by which families are compared: a design, proved, and how near it comes."""

from __future__ import annotations

from dataclasses import replace

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.record import record
from orishell.deployment import Site, find_site
from orishell.deployment.feet import Feet, find_feet, stand
from orishell.deployment.report import DeploymentReport, describe_deployment
from orishell.design import Design
from orishell.design_file import DesignFile
from orishell.deviation.report import DeviationReport, describe_deviation
from orishell.document.from_design import document_of_design
from orishell.families.pattern import TwoStaircases
from orishell.locking import Lock, end_motion, lock_without_clash, require_pack
from orishell.locking.box_plates import with_box_plates
from orishell.locking.carry import with_carried
from orishell.locking.gussets import with_gussets
from orishell.motion import FoldingMotion
from orishell.motion.freedom import FreedomOfSheet, find_freedom_of_sheet
from orishell.motion.lattice import InnerStaircase
from orishell.motion.second_skin import Skinned
from orishell.shell.answers import Answers
from orishell.shell.board_limits import require_stock_for_panels
from orishell.shell.designed import designed
from orishell.shell.end_walls import require_doors, with_end_walls
from orishell.shell.steps import Work
from orishell.workshop.masses import mass_of_hinges


@record
class Candidate:
    """A shell whose states are not verified yet, nor measured otherwise than for its target."""

    file: DesignFile  # which leaves nothing open
    design: Design  # what the family made of it
    freedom: FreedomOfSheet  # how many motions it has
    lock: Lock  # how its motion ends
    motion: FoldingMotion  # its states
    feet: Feet | None  # what it stands on; None if it cannot stand
    site: Site  # where it stands, what ties it, and what it weighs
    # how close it is to what was asked for; None without a target
    deviation: DeviationReport | None
    deployment: DeploymentReport  # how it is held; pack and weight are not measured yet
    answers: Answers = Answers()  # to what its file left open before


def prove(file: DesignFile, work: Work) -> Candidate:
    """The shell of a file that leaves nothing open, proved unless nobody is to look.

    Raises InputError or DesignError as :func:`orishell.shell.make_shell` does.
    """
    clock = work.clock
    design = designed(file, work.progress)
    if work.asks("stock"):
        require_stock_for_panels(file, design)
    require_doors(design, file.end_walls)
    clock.lap("design")
    design, lock = ended(file, design, work)
    if work.clash != "unexamined":
        clock.lap("clash")
    design, lock = with_carried(
        design,
        lock,
        file.stiffeners,
        file.contact_tolerance,
        examined=work.clash != "unexamined",
        inner=_inner(file, design),
        progress=work.progress,
    )
    if file.deployment.start == "pack":
        require_pack(design, lock)
    feet = find_feet(design)
    if file.ground == "z0":
        design, feet = stand(design, feet)
    design = with_box_plates(design, lock, file.stiffeners, file.contact_tolerance)
    design = with_gussets(design, lock, file.stiffeners, file.contact_tolerance, file.plate_density)
    stock = None if file.workshop.stock is None else file.workshop.usable_stock
    design = with_end_walls(design, lock, feet, file.end_walls, stock)
    site = find_site(
        design,
        feet,
        file.deployment,
        lock.built,
        unit=file.unit,
        areal_density=file.workshop.areal_density,
        hinges_kg=_in_creases(file, design, lock),
    )
    deviation = describe_deviation(design, measured=work.asks("deviation"))
    clock.lap("deviation")
    freedom = find_freedom_of_sheet(design.mechanism, design.hinges)
    clock.lap("freedom")
    end = None if file.deployment.start == "flat" else lock.closes_to
    return Candidate(
        file=file,
        design=design,
        freedom=freedom,
        lock=lock,
        motion=FoldingMotion(design.mechanism, file.frames, end),
        feet=feet,
        site=site,
        deviation=deviation,
        deployment=describe_deployment(design, lock, site, file.deployment.start, freedom),
    )


def _inner(file: DesignFile, design: Design) -> InnerStaircase | None:
    """The staircase that its second skin follows; None if it is the sheet's own.

    Raises DesignError if second skins of the family follow no curve.
    """
    if file.inner is None:
        return None
    if isinstance(file.pattern, TwoStaircases):
        return file.pattern.inner_staircase(file.f, file.inner)
    if isinstance(design.mechanism, Skinned):
        raise DesignError(
            "a second skin of this family is the sheet, moved: it follows no curve of its own",
            place="at its target",
            keys=("target.inner", "shell.family"),
            candidates=[Remedy({"target.inner": None})],
        )
    return None


def ended(file: DesignFile, design: Design, work: Work) -> tuple[Design, Lock]:
    """A file's design as it can be folded, and how its motion ends: see :func:`end_motion`.

    Flaps of no given width become as wide as the proof allows.

    Raises ClashError if panels of the flat sheet touch, or, unless that is allowed, panels meet
    before the target state.
    """
    if work.clash == "unexamined":
        return design, lock_without_clash(design)

    def narrower(width: float) -> Design:
        return designed(file.changed({"pattern.flap": width}))

    open_width = file.pattern.flap == "auto" and design.flap > 0
    return end_motion(
        design,
        tolerance=file.contact_tolerance,
        narrower=narrower if open_width else None,
        allow_clash=work.clash == "allowed",
        progress=work.progress,
    )


def _in_creases(file: DesignFile, design: Design, lock: Lock) -> float:
    """Mass of the hinges in the creases of what folds; 0 if nobody says how heavy they are (kg)."""
    if not file.workshop.hinge_linear_density:
        return 0.0
    boards = None if lock.built is None else lock.built.boards
    sheet = document_of_design(replace(design, clipped=None), file.unit, boards=boards)
    return mass_of_hinges(sheet, file.workshop) or 0.0
