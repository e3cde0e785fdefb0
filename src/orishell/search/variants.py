"""A page of variants: a slider for each variable, and the shell of the nearest design made."""

from __future__ import annotations

import json
import threading
from collections.abc import Sequence
from pathlib import Path
from typing import Any, TypedDict

import numpy as np

from orishell.conventions.formatting import rounded
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.table import knobs_of
from orishell.families.registry import FAMILIES
from orishell.io.formats.html import read_viewer
from orishell.io.html_pages import program_page
from orishell.numerics.arrays import Array
from orishell.numerics.equals import first_largest
from orishell.search.evaluate import Outcome, said_of, violation
from orishell.search.page import MOST_SHELLS, Drawn, draw, packed
from orishell.search.problem import Problem
from orishell.search.run import SearchResult
from orishell.search.space import Choices, Interval, key_of
from orishell.search.worker_pool import WorkerPool

NAME = "variants.html"
"""The page, in the directory of a search."""
MOST_BYTES = 4_000_000
"""Bytes of the shells in a page, at most."""
MOST_VARIANTS = 2000
"""Designs that a page knows of, at most: the front, and those that were made first."""


class Variable(TypedDict):
    """A key of the design file that has a slider."""

    label: str  # its name in words
    unit: str  # of its values; empty where they have none
    values: list[object]  # those that were tried, in the order of the slider
    shares: list[float]  # where each lies on the slider, from 0 to 1


class Variant(TypedDict):
    """A design that was tried."""

    at: list[int]  # number of its value, for each variable
    figures: list[float]  # its figures; none if it cannot be made or breaks a limit
    view: str | None  # the view of its shell, deflated, in base64; null if there is none
    missing: str  # why there is none


class VariantsPage(TypedDict):
    """What a page of variants shows."""

    title: str  # the name of the design
    said: str  # how many designs were tried, and of how many there is a shell
    variables: list[Variable]
    figures: list[str]  # names of the figures
    variants: list[Variant]
    first: int  # number of the one that is shown first


def write_variants(
    path: Path,
    problem: Problem,
    found: SearchResult,
    pool: WorkerPool,
    progress: Progress = no_progress,
    *,
    stop: threading.Event | None = None,
) -> None:
    """Write a page that needs no other file; no shell is drawn once it is to stop.

    Shells are drawn of designs that keep all limits: the file's own or the knee first, then always
    the one farthest from those before it, until the page is full.
    """
    page = program_page(
        read_viewer(),
        title=problem.path.stem,
        what="the shell",
        name="orishell-variants",
        data=variants_data(problem, found, pool, progress, stop=stop),
    )
    path.write_text(page, encoding="utf-8", newline="\n")


def variants_data(
    problem: Problem,
    found: SearchResult,
    pool: WorkerPool,
    progress: Progress = no_progress,
    *,
    stop: threading.Event | None = None,
) -> str:
    """What a page of variants is told, a :class:`VariantsPage` as JSON."""
    every, front = found.outcomes, {key_of(each.values) for each in found.front.members}
    order = sorted(range(len(every)), key=lambda k: key_of(every[k].values) not in front)
    tried = [every[k] for k in sorted(order[:MOST_VARIANTS])]
    points = np.array([_shares(problem, each) for each in tried])
    good = np.array([violation(problem, each) == 0.0 for each in tried])
    first = _first(problem, found, tried, good)
    chosen = _spread(points, np.flatnonzero(good), first)[:MOST_SHELLS]
    drawn = draw(
        problem,
        {k: tried[k].values for k in chosen},
        pool,
        progress,
        stop or threading.Event(),
        public=True,
    )
    views = _kept(chosen, drawn)
    variables = [_variable(problem, key, tried) for key in problem.space.axes]
    shown = sum(view is not None for view in views.values())
    page: VariantsPage = {
        "title": problem.path.stem,
        "said": f"{len(every)} designs were tried; "
        + (f"of {len(tried)} that are here, " if len(tried) < len(every) else "")
        + f"{int(good.sum())} fold and keep all limits"
        + (f", and {shown} of them are drawn here." if shown < good.sum() else "."),
        "variables": variables,
        "figures": [each.label(problem.unit) for each in problem.figures.values()],
        "variants": [
            {
                "at": [
                    variable["values"].index(each.values[key])
                    for key, variable in zip(problem.space.axes, variables, strict=True)
                ],
                "figures": [rounded(each.figures[name]) for name in problem.figures]
                if good[k]
                else [],
                "view": views.get(k),
                "missing": _missing(problem, each, drawn.get(k), good=bool(good[k])),
            }
            for k, each in enumerate(tried)
        ],
        "first": first,
    }
    return json.dumps(page, ensure_ascii=False, allow_nan=False, separators=(",", ":"))


def _shares(problem: Problem, outcome: Outcome) -> list[float]:
    """Where the values of a design lie, each from 0 to 1."""
    axes = problem.space.axes.items()
    return [_share(axis, outcome.values[key]) for key, axis in axes]


def _share(axis: Interval | Choices, value: Any) -> float:
    share = axis.share(value)
    return 0.5 if share is None else share


def _first(
    problem: Problem, found: SearchResult, tried: Sequence[Outcome], good: np.ndarray
) -> int:
    """The design of the file, if it is among those that keep all limits; else the knee."""
    point = problem.space.point(problem.tables)
    keys = [key_of(each.values) for each in tried]
    wanted = found.front.members[found.front.knee].values
    if point is not None:
        own = key_of(problem.space.values(point))
        if own in keys and good[keys.index(own)]:
            return keys.index(own)
    return keys.index(key_of(wanted))


def _spread(points: Array, among: np.ndarray, first: int) -> list[int]:
    """Numbers of points, each the farthest from those before it."""
    order, far = [first], np.full(len(points), -1.0)
    far[among] = np.inf
    for _ in range(min(len(among), MOST_SHELLS) - 1):
        far = np.minimum(far, ((points - points[order[-1]]) ** 2).sum(axis=1))
        far[order[-1]] = -1.0
        order.append(first_largest(far))
    return order


def _kept(chosen: list[int], drawn: dict[int, Drawn]) -> dict[int, str | None]:
    """The views of shells, packed, as many of the first ones as a page holds."""
    views: dict[int, str | None] = {}
    size = 0
    for number in chosen:
        view = packed(drawn[number][1])
        size += len(view or "")
        views[number] = view if size <= MOST_BYTES else None
    return views


def _missing(problem: Problem, outcome: Outcome, drawn: Drawn | None, *, good: bool) -> str:
    if not good:
        return said_of(problem, outcome)
    return drawn[2] if drawn is not None and drawn[2] else ""


def _variable(problem: Problem, key: str, tried: Sequence[Outcome]) -> Variable:
    axis = problem.space.axes[key]
    distinct = {json.dumps(each.values[key]): each.values[key] for each in tried}
    values = sorted(distinct.values(), key=lambda value: _share(axis, value))
    label, unit = _words(problem, key)
    shares = [_share(axis, value) for value in values]
    return {"label": label, "unit": unit, "values": values, "shares": shares}


def _words(problem: Problem, key: str) -> tuple[str, str]:
    """The name of a key in words, and its unit, if it is known."""
    table, _, last = key.rpartition(".")
    family = FAMILIES.get(problem.tables["shell"]["family"])
    knob = knobs_of(family.pattern).get(last) if family and table == "pattern" else None
    if knob is None:
        of = table.removeprefix("target.").replace(".", " ")
        return f"{last.capitalize()} of {of}".replace("_", " "), ""
    return knob.label, {"deg": "\u00b0", "length": problem.unit}.get(knob.unit, "")
