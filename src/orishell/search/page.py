"""The page of a search: its front, and the shells of its members."""

from __future__ import annotations

import base64
import json
import threading
import warnings
import zlib
from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any, TypedDict

import numpy as np

from orishell.conventions.errors import OrishellError
from orishell.conventions.formatting import rounded
from orishell.conventions.progress import Progress
from orishell.design_file.search import Limit
from orishell.design_file.tables import Values
from orishell.io.html_pages import place_of, program_page, read_program
from orishell.io.view import dump_view
from orishell.search.evaluate import Job, asked_of_loads, job_of, shell_of, violation
from orishell.search.front import beaten, costs, scores
from orishell.search.problem import Problem
from orishell.search.run import SearchResult
from orishell.search.worker_pool import WorkerPool
from orishell.shell.steps import STEPS

PROGRAM = place_of("front.js")
"""The page's program, once it is built."""
NOT_BUILT = "the page of a search has not been built"
DRAWING = "drawing shells"
STATES = 13
"""States of a shell's motion; panels stay rigid between them."""
MOST_SHELLS = 60
"""Members that are drawn; a shelter's shell is 60 kB, packed."""
PUBLIC = tuple(step for step in STEPS if step not in {"verification", "pack"})
"""What is not looked at in shells for the public."""
MOST_DOTS = 4000
"""Designs that others beat which are drawn; of more every k-th."""

Drawn = tuple[int, bytes | None, str]
"""Number of a member, the view of its shell, and why it has none."""


class PageFigure(TypedDict):
    """A figure that designs are compared by."""

    name: str  # its name, with its unit if that is known
    note: str  # its limits, in words; empty if it has none
    minimised: bool  # Whether it was to be as small as can be. These come first.


class Step(TypedDict):
    """What it gains and costs to take a neighbour on the front instead."""

    to: int  # number of the neighbour
    words: str  # what it gains and costs


class PageMember(TypedDict):
    """A design that no other beats."""

    file: str  # its design file
    values: list[object]  # values of its variables
    figures: list[float]  # its figures
    steps: list[Step]  # to its neighbours, by the first objective
    view: str | None  # the view of its shell, deflated, in base64; null if it is not drawn
    missing: str  # why it is not drawn


class FrontPage(TypedDict):
    """What the page of a search shows."""

    title: str  # the name of the design
    said: str  # how many designs were made, and what became of them
    variables: list[str]  # keys of the design file
    figures: list[PageFigure]
    members: list[PageMember]  # by their first objective
    knee: int  # number of the member at the knee
    beaten: list[list[float]]  # objectives of designs that keep all limits and are not on the front
    # objectives of the design that the file has; null if it cannot be made
    baseline: list[float] | None


def require_page() -> None:
    """Refuse to begin what would end because the page has not been built."""
    read_program(PROGRAM, NOT_BUILT)


def write_page(
    path: Path,
    problem: Problem,
    found: SearchResult,
    pool: WorkerPool,
    progress: Progress,
    *,
    stop: threading.Event | None = None,
) -> None:
    """Write ``front.html``, which needs no other file; no shell is drawn once it is to stop."""
    program = read_program(PROGRAM, NOT_BUILT)
    members = found.front.members
    chosen = {k: members[k].values for k in _chosen(len(members), found.front.knee)}
    drawn = draw(problem, chosen, pool, progress, stop or threading.Event())
    shown = _page(problem, found, drawn)
    page = program_page(
        program,
        title=f"{shown['title']}: the front of a search",
        what="the front of a search",
        name="orishell-front",
        data=json.dumps(shown, ensure_ascii=False, allow_nan=False, separators=(",", ":")),
    )
    path.write_text(page, encoding="utf-8", newline="\n")


def draw_shells(
    job: Job, numbered: Sequence[tuple[int, Values]], *, public: bool = False
) -> list[Drawn]:
    """The views of shells, as they were when they were evaluated, by numbers of designs.

    Those for the ``public`` have their pack measured; without the target's curves they are half as
    large.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)
        return [_drawn(job, number, values, public=public) for number, values in numbered]


def _drawn(job: Job, number: int, values: Values, *, public: bool) -> Drawn:
    try:
        document = shell_of(job, values, STATES, PUBLIC if public else STEPS).document
        return number, dump_view(replace(document, curves={}) if public else document), ""
    except OrishellError as error:
        return number, None, str(error)
    except Exception as error:  # the front is worth more than one of its shells
        return number, None, f"{type(error).__name__}: {error}"


def draw(
    problem: Problem,
    chosen: dict[int, Values],
    pool: WorkerPool,
    progress: Progress,
    stop: threading.Event,
    *,
    public: bool = False,
) -> dict[int, Drawn]:
    """The shells of designs, by number; a process that dies leaves its own out."""
    drawn: dict[int, Drawn] = {}
    count = 0
    progress(0.0, DRAWING)
    task = partial(draw_shells, job_of(problem), public=public)
    work = pool.work(task, list(chosen.items()), stop)
    for chunk, done in work:
        drawn |= {each[0]: each for each in done or ()}
        count += len(chunk)
        progress(count / len(chosen), DRAWING)
    missing = "it was stopped" if stop.is_set() else "the process that drew it died"
    return {number: drawn.get(number, (number, None, missing)) for number in chosen}


def packed(view: bytes | None) -> str | None:
    """A view as pages carry it: deflated, in base64."""
    return None if view is None else base64.b64encode(zlib.compress(view, 9)).decode("ascii")


def _chosen(count: int, knee: int) -> list[int]:
    """The ends, the knee, and as many others as are drawn, spread along the front."""
    spread = np.rint(np.linspace(0, count - 1, min(count, MOST_SHELLS))).astype(int)
    return sorted({*spread.tolist(), knee})


def _page(problem: Problem, found: SearchResult, drawn: dict[int, Drawn]) -> FrontPage:
    front = found.front
    others = beaten(problem, found.outcomes, front)
    dots = [[rounded(each) for each in scores(problem, outcome)] for outcome in others]
    distinct = [list(dot) for dot in dict.fromkeys(map(tuple, dots))]
    baseline = found.baseline
    limits = {figure.name: limit for figure, limit in problem.limits}
    return {
        "title": problem.path.stem,
        "said": _said(problem, found),
        "variables": list(problem.space.axes),
        "figures": [
            {
                "name": figure.label(problem.unit),
                "note": _limits(limits.get(name)),
                "minimised": name in problem.search.minimise,
            }
            for name, figure in problem.figures.items()
        ],
        "members": [_member(problem, found, number, drawn) for number in range(len(front.members))],
        "knee": front.knee,
        "beaten": distinct[:: -(-len(distinct) // MOST_DOTS) or 1],
        "baseline": list(scores(problem, baseline)) if baseline.figures else None,
    }


def _member(
    problem: Problem, found: SearchResult, number: int, drawn: dict[int, Drawn]
) -> PageMember:
    members = found.front.members
    member, file = members[number], f"{found.front.name(number)}.toml"
    _, view, why = drawn.get(number, (number, None, f"only {MOST_SHELLS} of the front are drawn"))
    neighbours = [to for to in (number - 1, number + 1) if 0 <= to < len(members)]
    values: list[Any] = [member.values[key] for key in problem.space.axes]
    return {
        "file": file,
        "values": values,
        "figures": [member.figures[name] for name in problem.figures],
        "steps": [{"to": to, "words": costs(problem, member, members[to])} for to in neighbours],
        "view": packed(view),
        "missing": why
        and f"{why[:1].upper()}{why[1:].rstrip('.')}. The shell is made by: "
        f"orishell design {file} --out DIRECTORY",
    }


def _said(problem: Problem, found: SearchResult) -> str:
    made, front = len(found.outcomes), len(found.front.members)
    feasible = sum(violation(problem, each) == 0.0 for each in found.outcomes)
    stopped = "" if found.whole else " The search was stopped before its end."
    designs = "design" if front == 1 else "designs"
    loads = asked_of_loads(problem)
    return (
        f"{front} {designs} that no other beats, of {made} that were tried; {feasible} fold and "
        f"keep all limits.{stopped} {loads[:1].upper()}{loads[1:]}."
    )


def _limits(limit: Limit | None) -> str:
    if limit is None:
        return ""
    ends = ("at least", limit.least), ("at most", limit.most)
    return ", ".join(f"{words} {end:g}" for words, end in ends if end is not None)
