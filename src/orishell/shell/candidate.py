"""The part of the work by which families are compared: a design, proved, and how near it comes."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from typing import Literal

from orishell.conventions.progress import Progress
from orishell.conventions.record import record
from orishell.deployment import Site, find_site
from orishell.deployment.feet import Feet, find_feet, stand
from orishell.deployment.report import DeploymentReport, describe_deployment
from orishell.deployment.short_ties import require_slack
from orishell.design import Design
from orishell.design_file import DesignFile
from orishell.deviation.report import DeviationReport, describe_deviation
from orishell.document.from_design import document_of_design
from orishell.locking import Lock, lock_without_clash, require_pack
from orishell.motion import FoldingMotion
from orishell.motion.freedom import FreedomOfSheet, find_freedom_of_sheet
from orishell.shell.board_limits import require_boards
from orishell.shell.designed import designed, ended
from orishell.shell.fit.proved import fit_size
from orishell.shell.fit.report import FittedSize
from orishell.shell.size_trials import Choice
from orishell.shell.steps import Clock, Step
from orishell.shell.tolerance import meet_tolerance
from orishell.shell.turn_search import TurnChoice, choose_turn
from orishell.workshop.masses import mass_of_hinges

ClashPolicy = Literal["refused", "allowed", "unexamined"]
"""If panels collide before the target: refuse the shell, allow it and say so, or do not check, for
sheets of hundreds of thousands of panels."""


@record
class Candidate:
    """A shell whose states are not verified yet, nor measured otherwise than for its target."""

    file: DesignFile  # with a family, rows and columns
    turned: TurnChoice | None  # how its rectangle was turned, if that was left open
    choice: Choice | None  # how rows and columns were chosen, if there was a tolerance
    fitted: FittedSize | None  # how its target was scaled, if sizes were asked for
    design: Design  # what the family made of it
    freedom: FreedomOfSheet  # how many motions it has
    lock: Lock  # how its motion ends
    motion: FoldingMotion  # its states
    feet: Feet | None  # what it stands on; None if it cannot stand
    site: Site  # where it stands, what ties it, and what it weighs
    # how close it is to what was asked for; None without a target
    deviation: DeviationReport | None
    deployment: DeploymentReport  # how it is held; pack and weight are not measured yet


def find_candidate(
    file: DesignFile,
    progress: Progress,
    clash: ClashPolicy = "refused",
    skip: Collection[Step] = (),
    clock: Clock | None = None,
) -> Candidate:
    """The shell of a file with a family, proved unless nobody is to look.

    Raises InputError or DesignError as :func:`orishell.shell.make_shell` does.
    """
    clock = clock or Clock()
    file, turned = choose_turn(file, progress)
    if turned is not None:
        clock.lap("turn")
    choice = fitted = None
    if file.fit is not None:
        found, choice, fitted = fit_size(
            file, lambda scaled: _proved(scaled, progress, clash, skip, clock), progress
        )
    else:
        if file.tolerance is not None:
            file, choice = meet_tolerance(file, file.tolerance, progress)
            clock.lap("choose")
        found = _proved(file, progress, clash, skip, clock)
    if choice is not None:
        require_boards(choice.limits, found.design, found.lock)
    if file.deployment.start == "pack":
        design, limit = found.design, found.lock.closes_to
        require_slack(design.mechanism, found.deployment.ties, limit, design.hinges)
    return replace(found, turned=turned, choice=choice, fitted=fitted)


def _proved(
    file: DesignFile,
    progress: Progress,
    clash: ClashPolicy,
    skip: Collection[Step],
    clock: Clock,
) -> Candidate:
    """The shell of a file whose target, rows and columns are known."""
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
    site = find_site(
        design,
        feet,
        file.deployment,
        lock.built,
        unit=file.unit,
        areal_density=file.workshop.areal_density,
        hinges_kg=_in_creases(file, design, lock),
    )
    deviation = describe_deviation(design, measured="deviation" not in skip)
    clock.lap("deviation")
    freedom = find_freedom_of_sheet(design.mechanism, design.hinges)
    clock.lap("freedom")
    end = None if file.deployment.start == "flat" else lock.closes_to
    return Candidate(
        file=file,
        turned=None,
        choice=None,
        fitted=None,
        design=design,
        freedom=freedom,
        lock=lock,
        motion=FoldingMotion(design.mechanism, file.frames, end),
        feet=feet,
        site=site,
        deviation=deviation,
        deployment=describe_deployment(design, lock, site, file.deployment.start, freedom),
    )


def _in_creases(file: DesignFile, design: Design, lock: Lock) -> float:
    """Mass of the hinges in the creases of what folds; 0 if nobody says how heavy they are (kg)."""
    if not file.workshop.hinge_linear_density:
        return 0.0
    boards = None if lock.built is None else lock.built.boards
    sheet = document_of_design(replace(design, clipped=None), file.unit, boards=boards)
    return mass_of_hinges(sheet, file.workshop) or 0.0


def _ended(
    file: DesignFile, design: Design, clash: ClashPolicy, progress: Progress
) -> tuple[Design, Lock]:
    if clash == "unexamined":
        return design, lock_without_clash(design)
    return ended(file, design, allow_clash=clash == "allowed", progress=progress)
