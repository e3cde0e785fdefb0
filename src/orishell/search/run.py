"""A search: variants chosen, made, written down, and the best of them.

Limit: a search proves nothing to be best unless it made all variants.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

from orishell.conventions.errors import DesignError, InputError
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.record import record
from orishell.design_file.tables import Values
from orishell.numerics.equals import smallest_of
from orishell.search.evaluate import (
    LACKING,
    Job,
    Outcome,
    Require,
    died,
    evaluate,
    job_of,
    reasons,
    said_of,
    violation,
)
from orishell.search.front import Front, chooser, front_of
from orishell.search.journal import Journal
from orishell.search.problem import Problem
from orishell.search.worker_pool import WorkerPool

SEARCHING = "searching"
COMMONEST = 3
"""Reasons that are said where no design is feasible."""


@record
class SearchResult:
    """What a search found."""

    # all designs that were made, in the order in which they were chosen
    outcomes: tuple[Outcome, ...]
    front: Front  # those that no other beats
    baseline: Outcome  # the design as its file has it
    whole: bool  # whether the search came to its end


def search_designs(
    problem: Problem,
    pool: WorkerPool,
    journal: Journal,
    progress: Progress = no_progress,
    *,
    stop: threading.Event | None = None,
    seen: Callable[[Outcome], None] = lambda _: None,
    files: bool = True,
    require: Require | None = None,
) -> SearchResult:
    """Search the variants of a design for those that no other beats.

    The result depends on the problem only: not on the pool, nor on what the journal has already.

    Parameters
    ----------
    journal
        What was made before; what is made is added to it.
    stop
        Set where the search is to end with what there is.
    seen
        Told of each design, the one that the file has first, as they are ready.
    files
        Whether curves may come from files.
    require
        Raises InputError for a variant that is not to be made.

    Raises
    ------
    InputError
        If the report of the design lacks a figure that is asked for.
    DesignError
        If no design keeps all limits; says why.
    """
    job = job_of(problem, files=files, require=require)
    stop = stop or threading.Event()
    return _Run(problem, pool, journal, progress, stop, seen, job).found()


@dataclass(slots=True)
class _Run:
    problem: Problem
    pool: WorkerPool
    journal: Journal
    progress: Progress
    stop: threading.Event
    seen: Callable[[Outcome], None]
    job: Job

    def found(self) -> SearchResult:
        chosen = chooser(self.problem)
        batch = next(chosen, None)
        baseline = self._baseline(batch or [])
        self.seen(baseline)
        outcomes: list[Outcome] = []
        whole = False
        while batch is not None:
            made = self._made(batch, len(outcomes))
            if made is None:
                break
            outcomes += made
            try:
                batch = chosen.send(made)
            except StopIteration:
                batch = None
        else:
            whole = True
            self.progress(1.0, SEARCHING)
        if not whole:  # what is there of the last batch counts too
            known = map(self.journal.find, batch or [])
            outcomes += [each for each in known if each is not None]
        front = front_of(self.problem, outcomes)
        if front is None:
            raise _nothing(self.problem, outcomes or [baseline], whole=whole)
        return SearchResult(tuple(outcomes), front, baseline, whole)

    def _baseline(self, batch: Sequence[Values]) -> Outcome:
        """The design as its file has it; raises InputError if a figure is not in the reports."""
        known = self.journal.find({})
        if known is not None:
            return known
        outcome = self._first({})
        if outcome.reason == LACKING and self._first(batch[0]).reason:  # nor does a variant say it
            raise InputError(
                outcome.said,
                file=self.problem.path,
                keys=("search",),
                remedy="ask for other figures, or give what these need: mass an areal_density or "
                "densities, deflection and forces a table [structure], deviation a [target]",
            )
        self.journal.add([outcome])
        return outcome

    def _first(self, values: Values) -> Outcome:
        """A variant by itself, before all others."""
        for _, done in self.pool.work(partial(evaluate, self.job), [values], self.stop):
            found: Outcome = died(values) if done is None else done[0]
            return found
        raise DesignError("the search was stopped before the first design was made")

    def _made(self, variants: list[Values], before: int) -> list[Outcome] | None:
        """What becomes of variants, in their order; None if it was to stop before all were made."""
        left = [each for each in variants if self.journal.find(each) is None]
        self._tell(before, len(variants) - len(left))
        for known in filter(None, map(self.journal.find, variants)):
            self.seen(known)
        count = len(variants) - len(left)
        for chunk, done in self.pool.work(partial(evaluate, self.job), left, self.stop):
            outcomes = [died(values) for values in chunk] if done is None else done
            self.journal.add(outcomes)
            count += len(outcomes)
            self._tell(before, count)
            for each in outcomes:
                self.seen(each)
        found = [self.journal.find(each) for each in variants]
        made = [each for each in found if each is not None]
        return made if len(made) == len(variants) else None

    def _tell(self, before: int, count: int) -> None:
        total = min(self.problem.search.evaluations, self.problem.space.count)
        self.progress(min((before + count) / total, 1.0), SEARCHING)


def _nothing(problem: Problem, outcomes: list[Outcome], *, whole: bool) -> DesignError:
    """That no design keeps all limits: the commonest reasons, and the nearest design."""
    counted = reasons(problem, outcomes)[:COMMONEST]
    common = "; ".join(f"{count} of {len(outcomes)}: {reason}" for reason, count in counted)
    near = smallest_of(outcomes, lambda each: violation(problem, each))
    values = ", ".join(f"{key} = {value}" for key, value in near.values.items())
    stopped = "" if whole else ", before the search was stopped; the same command goes on"
    return DesignError(
        f"no design was found that can be made and keeps all limits{stopped}",
        keys=tuple(problem.space.axes),
        size=f"{common}. The nearest, with {values or 'the values of the file'}: "
        f"{said_of(problem, near).rstrip('.')}",
        excess=violation(problem, near),
    )
