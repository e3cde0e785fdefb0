"""A search on the open design: what is found is told while it goes on."""

from __future__ import annotations

import time
from collections import Counter
from importlib.util import find_spec
from pathlib import Path

from orishell.conventions.errors import InputError
from orishell.conventions.progress import Progress
from orishell.design_file.search import Search
from orishell.search import Front, Outcome, Problem, alone, journal_in_memory, search_designs
from orishell.search.evaluate import reasons, violation
from orishell.search.figures import BEARS, NAMES, figure
from orishell.search.front import costs, front_of
from orishell.search.problem import parse_problem
from orishell.search.space import key_of
from orishell.studio.api import SearchedDesign, SearchState, Tables
from orishell.studio.info import SearchInfo
from orishell.studio.processes import Send, require_small

EVERY = 0.2
"""Seconds after which the page is told again."""
COMMONEST = 4
"""Reasons that are told."""


def describe_search() -> SearchInfo:
    """What a search can be for, and what is still to be installed for it."""
    figures = map(figure, NAMES)
    return {
        "figures": [
            {
                "name": each.name,
                "words": each.name.replace("_", " "),
                "unit": each.unit,
                "of_structure": each.part == "structure",
                "most": BEARS[each.name].most if each.name in BEARS else None,
            }
            for each in figures
        ],
        "evaluations": Search.model_fields["evaluations"].default,
        "install": "" if find_spec("pymoo") else "pip install orishell[search]",
    }


def search_variants(tables: Tables, path: Path, progress: Progress, send: Send) -> SearchState:
    """Search the variants of a design, and tell what is found as it is.

    Raises InputError if there is nothing to search for, or what it needs is not installed.
    Raises DesignError if no design keeps all limits.
    """
    install = describe_search()["install"]
    if install:
        raise InputError("pymoo must be installed to search", remedy=install)
    problem = parse_problem(tables, path, files=False)
    watch = _Watch(problem, send)
    with alone() as pool:
        search_designs(
            problem,
            pool,
            journal_in_memory(),
            progress,
            seen=watch.seen,
            files=False,
            require=require_small,
        )
    return watch.state()


class _Watch:
    """What a search has found, and what of that was not told yet."""

    def __init__(self, problem: Problem, send: Send) -> None:
        self._problem, self._send = problem, send
        self._told = time.perf_counter()
        self._baseline: Outcome | None = None
        self._front: Front | None = None
        self._new: list[Outcome] = []
        self._numbers: dict[str, int] = {}
        self._made = 0
        self._refused: Counter[str] = Counter()

    def seen(self, outcome: Outcome) -> None:
        """Another design was made; the first is the one that was opened."""
        if self._baseline is None:
            self._baseline = outcome
        else:
            self._made += 1
            if key_of(outcome.values) in self._numbers:
                return
            if violation(self._problem, outcome) == 0.0:
                self._numbers[key_of(outcome.values)] = len(self._numbers)
                self._new.append(outcome)
            else:
                self._refused.update(dict(reasons(self._problem, [outcome])))
        if time.perf_counter() > self._told + EVERY:
            self._send(self.state())
            self._told = time.perf_counter()

    def state(self) -> SearchState:
        """How far it has come; designs that this has told of are not told again."""
        problem, new = self._problem, self._new
        self._new = []
        # What an earlier front beat is beaten still.
        kept = self._front.members if self._front else ()
        self._front = front = front_of(problem, [*kept, *new])
        baseline = self._baseline
        return {
            "objectives": [
                {"name": each.name, "label": each.label(problem.unit)}
                for each in problem.objectives
            ],
            "baseline": _told(baseline) if baseline and baseline.figures else None,
            "designs": [_told(each) for each in new],
            "front": [
                {
                    "number": self._numbers[key_of(each.values)],
                    "costs": ""
                    if place == front.knee
                    else costs(problem, front.members[front.knee], each),
                }
                for place, each in enumerate(front.members)
            ]
            if front
            else [],
            "knee": front.knee if front else -1,
            "made": self._made,
            "total": int(min(problem.search.evaluations, problem.space.count)),
            "refused": self._refused.most_common(COMMONEST),
        }


def _told(outcome: Outcome) -> SearchedDesign:
    return {"values": outcome.values, "figures": outcome.figures}
