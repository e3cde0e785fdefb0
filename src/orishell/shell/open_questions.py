"""What a design file may leave open: each question is closed by a step of its own, in one order.

A step turns the file into one that leaves less open, and says what was found; what follows it is
made of closed files only, and asks nothing. A family and sizes are known by a proof only, and the
shell that has it is kept. So is the width of flaps, whatever else is open:
``candidate.ended`` finds it in the proof of every shell.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial

from orishell.conventions.progress import Progress
from orishell.conventions.record import record
from orishell.deployment.short_ties import require_slack
from orishell.design_file import DesignFile
from orishell.families.registry import AUTO
from orishell.shell.answers import Answers
from orishell.shell.board_limits import require_boards
from orishell.shell.candidate import Candidate, prove
from orishell.shell.families import choose_family
from orishell.shell.family_choice import FamilyTrial
from orishell.shell.fit.proved import fit_size
from orishell.shell.steps import Work
from orishell.shell.tolerance import meet_tolerance
from orishell.shell.turn_search import choose_turn


@record
class Closed:
    """A design file with less left open, and what was found for that."""

    file: DesignFile
    answers: Answers = Answers()
    proved: Candidate | None = None  # the shell whose proof an answer took


@record
class Question:
    """Something that a design file may leave open."""

    part: str  # of the work, whose time is told
    is_open: Callable[[DesignFile], bool]
    close: Callable[[Closed, Work], Closed]


def find_candidate(file: DesignFile, work: Work) -> Candidate:
    """The shell of a file, with all that it leaves open closed, and proved.

    Raises InputError or DesignError as :func:`orishell.shell.make_shell` does.
    """
    closed = Closed(file)
    for question in QUESTIONS:
        if question.is_open(closed.file):
            closed = question.close(closed, work)
            work.clock.lap(question.part)
    found = closed.proved or prove(closed.file, work)
    if closed.answers.choice is not None:
        require_boards(closed.answers.choice.limits, found.design, found.lock)
    if closed.file.deployment.start == "pack":
        design, limit = found.design, found.lock.closes_to
        require_slack(design.mechanism, found.deployment.ties, limit, design.hinges)
    return replace(found, answers=closed.answers)


def compare_families(
    file: DesignFile, progress: Progress, tell: Callable[[FamilyTrial], None] | None = None
) -> Candidate:
    """The shell of the best family: see :func:`~orishell.shell.families.choose_family`."""

    def proved(file: DesignFile, progress: Progress) -> Candidate:
        return find_candidate(file, Work(progress))

    return choose_family(file, progress, proved, tell)


def _close_family(closed: Closed, work: Work) -> Closed:
    found = compare_families(closed.file, work.progress)
    return Closed(found.file, found.answers, found)


def _close_turn(closed: Closed, work: Work) -> Closed:
    file, turned = choose_turn(closed.file, work.progress)
    return Closed(file, replace(closed.answers, turned=turned))


def _close_sizes(closed: Closed, work: Work) -> Closed:
    """Sizes, and with them rows and columns: these are chosen for the target as it is scaled."""
    found, choice, fitted = fit_size(closed.file, partial(prove, work=work), work.progress)
    return Closed(found.file, replace(closed.answers, choice=choice, fitted=fitted), found)


def _close_tolerance(closed: Closed, work: Work) -> Closed:
    assert closed.file.tolerance is not None
    file, choice = meet_tolerance(closed.file, closed.file.tolerance, work.progress)
    return Closed(file, replace(closed.answers, choice=choice))


QUESTIONS = (
    Question("family", lambda file: file.family == AUTO, _close_family),
    Question("turn", lambda file: bool(file.turns), _close_turn),
    Question("sizes", lambda file: file.fit is not None, _close_sizes),
    Question("choose", lambda file: file.tolerance is not None, _close_tolerance),
)
"""In the order in which they are closed: what each asks of the rest is known after it."""
