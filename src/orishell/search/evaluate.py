"""Variants made and measured, and whether they keep all limits."""

from __future__ import annotations

import math
import re
import warnings
from collections import Counter
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from orishell.conventions.errors import DesignError, InputError
from orishell.conventions.quantities import plain
from orishell.design_file import DesignFile, check_design
from orishell.design_file.search import Limit
from orishell.design_file.tables import Values
from orishell.search.figures import figure
from orishell.search.problem import Problem
from orishell.shell.make import Shell, make_shell
from orishell.shell.report import Report
from orishell.shell.steps import STEPS, Step

Require = Callable[[DesignFile], None]
STATES = 3
"""States of a motion, of which nothing is asked here: the fewest."""
FAULT, LACKING = "a fault of the program", "the report lacks a figure"
"""Reasons that the search itself looks for."""
NOT_KNOWN = "it is not known whether it carries its loads"
"""Why a design is refused that bears something whose strength nobody gave."""
_NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w.])")
_VALUE = re.compile(f" = {_NUMBER.pattern}")


@dataclass(frozen=True, slots=True)
class Outcome:
    """What became of a variant."""

    values: Values  # what its keys have
    figures: dict[str, float]  # its figures by name; empty if it cannot be made
    # why it cannot be made, in the words that many refusals share; empty if it can
    reason: str = ""
    said: str = ""  # the whole message of the refusal
    # by how much it misses its nearest limit, relative to that; None if that is not known
    excess: float | None = None


@dataclass(frozen=True, slots=True)
class Job:
    """What a process needs to make variants of a design."""

    path: Path  # the design file; curves from files are found beside it
    tables: dict[str, Any]
    figures: tuple[str, ...]  # what is read off the report
    files: bool = True  # whether curves may come from files
    require: Require | None = None  # raises InputError for a variant that is not to be made


def job_of(problem: Problem, *, files: bool = True, require: Require | None = None) -> Job:
    """What a process needs to make variants for a search."""
    return Job(problem.path, problem.tables, tuple(problem.figures), files, require)


def evaluate(job: Job, variants: Sequence[Values]) -> list[Outcome]:
    """Make variants of a design, one after the other."""
    with warnings.catch_warnings():
        # Numbers beyond all measure are refused by what they lead to.
        warnings.simplefilter("ignore", RuntimeWarning)
        return [_outcome(job, values) for values in variants]


def died(values: Values) -> Outcome:
    """What becomes of a variant with which processes die, or with others beside it."""
    return Outcome(values, {}, FAULT, "the process that made it, or designs beside it, died")


def report_of(job: Job, values: Values) -> Report:
    """The report of a variant, without what no figure asks for."""
    needed = {figure(name).part for name in job.figures}
    left_out = [part for part in STEPS if part not in needed]
    return shell_of(job, values, STATES, left_out).report


def shell_of(job: Job, values: Values, states: int, skip: Collection[Step]) -> Shell:
    """The shell of a variant; raises InputError or DesignError if it cannot be made."""
    design = check_design(job.tables, job.path, files=job.files)
    file = design.changed({**values, "motion.frames": states})
    if job.require is not None:
        job.require(file)
    return make_shell(file, skip=skip)


def _outcome(job: Job, values: Values) -> Outcome:
    try:
        return _read(job, values, report_of(job, values))
    except DesignError as error:
        excess = error.excess if error.excess is not None and math.isfinite(error.excess) else None
        return Outcome(values, {}, _common(error.condition), str(error), excess)
    except InputError as error:
        return Outcome(values, {}, _common(error.what), str(error))
    except Exception as error:  # one variant of thousands must not end the search
        return Outcome(values, {}, FAULT, f"{type(error).__name__}: {error}")


def _common(condition: str) -> str:
    """A condition without its numbers, so that all designs that fail it count as one."""
    return _NUMBER.sub("...", _VALUE.sub("", condition))


def _read(job: Job, values: Values, report: Report) -> Outcome:
    """The figures of a design, if it has all that are asked for."""
    moving = _moving(report)
    if moving:
        return Outcome(values, {}, "nothing holds the shell under its loads", moving)
    structure = report.structure
    if structure is not None and structure.used is None and "utilisation" in job.figures:
        return Outcome(values, {}, NOT_KNOWN, structure.in_words())
    found = {name: figure(name).read(report) for name in job.figures}
    figures = {
        key: value for key, value in found.items() if value is not None and math.isfinite(value)
    }
    if len(figures) < len(found):
        lacking = ", ".join(name for name in found if name not in figures)
        return Outcome(values, {}, LACKING, f"the report does not say {lacking}")
    return Outcome(values, figures)


def _moving(report: Report) -> str:
    """How it moves under a load case that nothing holds it in; empty if there is none."""
    cases = () if report.structure is None else report.structure.cases
    return next(
        (f"under {each.name!r}: {each.in_words()}" for each in cases if each.equilibrium is None),
        "",
    )


def violation(problem: Problem, outcome: Outcome) -> float:
    """How far a variant is from keeping all limits, 0 if it does.

    Up to 1 if it can be made, its figures relative to their limits; up to 2 if a refusal says by
    how much it fails, and 3 where nothing is known.
    """
    if outcome.reason:
        return 3.0 if outcome.excess is None else 1.0 + _squeezed(outcome.excess)
    broken = sum(_beyond(limit, outcome.figures[each.name]) for each, limit in problem.limits)
    return _squeezed(broken)


def reasons(problem: Problem, outcomes: Sequence[Outcome]) -> list[tuple[str, int]]:
    """Why designs are not feasible, the commonest first, and how many it applies to."""
    counted: Counter[str] = Counter()
    for each in outcomes:
        if each.reason:
            counted[each.reason] += 1
        else:
            counted.update(words for _, words in _broken(problem, each))
    return sorted(counted.items(), key=lambda each: (-each[1], each[0]))


def asked_of_loads(problem: Problem) -> str:
    """What designs that keep all limits do under loads: no more than was looked at."""
    limit = _limit_of_loads(problem)
    if limit is None:
        return "loads were not looked at: the design file has no [structure]"
    if limit.most is None or limit.most > 1:
        return (
            "utilisation may be above 1, as the design file asks: such a shell buckles or breaks, "
            "or is not known to carry its loads"
        )
    return (
        f"under loads a utilisation of at most {limit.most:g}, of the strengths in the design file "
        "and of buckling, by linear analysis"
    )


def _limit_of_loads(problem: Problem) -> Limit | None:
    return next((limit for figure, limit in problem.limits if figure.name == "utilisation"), None)


def said_of(problem: Problem, outcome: Outcome) -> str:
    """Why a design is not feasible."""
    return outcome.said or "; ".join(
        f"{words}: {plain(outcome.figures[name])}" for name, words in _broken(problem, outcome)
    )


def _broken(problem: Problem, outcome: Outcome) -> list[tuple[str, str]]:
    """The figures whose limits a design breaks, and these in words."""
    return [
        (figure.name, f"{figure.name} is {'above' if above else 'below'} {end:g}")
        for figure, limit in problem.limits
        for above, end in ((True, limit.most), (False, limit.least))
        if end is not None
        and (outcome.figures[figure.name] > end if above else outcome.figures[figure.name] < end)
    ]


def _beyond(limit: Limit, value: float) -> float:
    over = 0.0 if limit.most is None else (value - limit.most) / (abs(limit.most) or 1.0)
    under = 0.0 if limit.least is None else (limit.least - value) / (abs(limit.least) or 1.0)
    return max(over, under, 0.0)


def _squeezed(size: float) -> float:
    return 1.0 if math.isinf(size) else size / (1.0 + size)
