"""From a design file with a tolerance to the pattern with the fewest panels that meets it."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np

from orishell.conventions.errors import DesignError
from orishell.conventions.memory import MEMORY, key_of
from orishell.conventions.progress import Progress, no_progress
from orishell.design import Design
from orishell.design_file import DesignFile
from orishell.deviation import SAMPLES as CAREFUL
from orishell.deviation import find_excess, measure_deviation
from orishell.document import Document
from orishell.document.from_design import document_of_design
from orishell.families.pattern import Pattern as FamilyPattern
from orishell.families.tolerance import Tolerance, Variants
from orishell.motion.quads import lengths
from orishell.shell.designed import designed
from orishell.shell.size_search import choose
from orishell.shell.size_trials import Choice, Sizes, Trial
from orishell.shell.surface_search import SurfaceSearch
from orishell.workshop.fitting import SLACK, OversizeError
from orishell.workshop.layout import find_oversize, require_stock, usable_stock

QUICK = 1_000
"""Samples each way during the search; the result is measured with as many as for the report."""
SIZE_KEYS = frozenset({"pattern.rows", "pattern.columns"})
"""What may not be given beside a tolerance, so that no remedy names it."""
UNSIZED = frozenset({"motion", "search"})
"""Tables that have no say in it."""
NOTHING_ALLOWED = Tolerance.model_construct(surface=0.0)


def meet_tolerance(
    file: DesignFile, tolerance: Tolerance, progress: Progress = no_progress
) -> tuple[DesignFile, Choice]:
    """The file with rows, columns and what else it leaves open, and what they were chosen from.

    A file that names no other files is known by its tables, and not searched for twice: the studio
    asks for the shell of the family that it has just chosen.

    Raises DesignError if no pattern meets the tolerance; says what can be met.
    Raises InputError if the pattern would be too large for its frames.
    """
    if file.files:
        return _searched(file, tolerance, progress)
    tables = {name: each for name, each in file.tables.items() if name not in UNSIZED}
    key = key_of("sizes", json.dumps(tables, sort_keys=True, default=repr), tolerance)
    fresh: list[tuple[DesignFile, Choice]] = []

    def find() -> tuple[dict[str, Any], Choice]:
        fresh.append(_searched(file, tolerance, progress))
        sized, choice = fresh[0]
        return sized.tables["pattern"], choice

    pattern, choice = MEMORY.recall(key, find)
    if fresh:
        return fresh[0]
    return file.changed({"tolerance": None, "pattern": pattern}), choice


def _searched(
    file: DesignFile, tolerance: Tolerance, progress: Progress
) -> tuple[DesignFile, Choice]:
    """What is found by trying."""
    limits = _limits(file, tolerance)
    try:
        if file.surface is not None:
            return _sized_on_surface(file, limits, tolerance, progress)
        pattern, choice = choose(_sizes(file, limits), limits, progress)
    except DesignError as refusal:
        if file.workshop.stock is not None:
            return _with_any_stock(file, tolerance, progress)
        refusal.candidates = (
            each for each in refusal.candidates if not each.changes.keys() & SIZE_KEYS
        )
        raise
    pattern = pattern.sized(choice.trial.rows, choice.trial.columns)
    table = pattern.model_dump(exclude_unset=True)
    sized = file.changed({"tolerance": None, "pattern": table})
    return sized, replace(choice, limits=tolerance)


def _sized_on_surface(
    file: DesignFile, limits: Tolerance, tolerance: Tolerance, progress: Progress
) -> tuple[DesignFile, Choice]:
    """The same where the target is a surface, which sheets of every size are fitted to."""
    surface = file.surface
    assert surface is not None

    def measured(rows: int, columns: int, told: Progress) -> tuple[Trial, float]:
        design = file.pattern.sized(rows, columns).design_on(surface, told)
        trial = measure(design, True, limits)
        trial = replace(trial, rows=rows, columns=columns)
        if file.workshop.stock is None:
            return trial, 0.0
        document = document_of_design(design, file.unit)
        return trial, find_oversize(document, file.workshop)

    choice = SurfaceSearch(measured, surface.piece.extents, limits, progress).run()
    sized = file.pattern.sized(choice.trial.rows, choice.trial.columns)
    table = sized.model_dump(exclude_unset=True)
    return file.changed({"tolerance": None, "pattern": table}), replace(choice, limits=tolerance)


def _with_any_stock(
    file: DesignFile, tolerance: Tolerance, progress: Progress
) -> tuple[DesignFile, Choice]:
    """What meets a tolerance if stock is as large as needed: it is refused for that, or at all."""
    anywhere, choice = meet_tolerance(file.changed({"workshop.stock": None}), tolerance, progress)
    try:
        require_stock(_document(file, anywhere.pattern), file.workshop)
    except OversizeError as error:
        error.remedy = (
            "larger stock, or another distance in [tolerance]: no sheet was found that comes "
            f"within {tolerance.surface:g} of the surface and whose panels fit"
        )
        raise
    return anywhere.changed({"workshop": file.tables["workshop"]}), choice


def _document(file: DesignFile, pattern: FamilyPattern) -> Document:
    return document_of_design(designed(replace(file, pattern=pattern)), file.unit)


def _limits(file: DesignFile, tolerance: Tolerance) -> Tolerance:
    """The tolerance, and no edge longer than the stock's diagonal."""
    if file.workshop.stock is None:
        return tolerance
    longest = (1 + SLACK) * math.hypot(*usable_stock(file.workshop))
    return tolerance.having(panel_max=min(tolerance.panel_max, longest))


def _sizes(file: DesignFile, limits: Tolerance) -> Sizes[FamilyPattern]:
    """The sheets that a design file leaves to choose from."""
    own = file.pattern

    @cache
    def in_rows(rows: int) -> Variants[FamilyPattern]:
        return own.sized(rows, 2).variants(file.f, limits)

    def measured(variant: FamilyPattern, columns: int, careful: bool) -> Trial:
        design = variant.sized(variant.rows, columns).design(file.f, file.g)
        return measure(design, careful, limits)

    def distance_from_g(columns: int) -> float:
        return in_rows(1).telling[0].sized(1, columns).distance_from_g(file.g)

    def oversize(variant: FamilyPattern, columns: int) -> float:
        if file.workshop.stock is None:
            return 0.0
        document = _document(file, variant.sized(variant.rows, columns))
        return find_oversize(document, file.workshop)

    return Sizes(
        variants=in_rows,
        distance_from_f=lambda variant: variant.distance_from_f(file.f),
        distance_from_g=distance_from_g,
        measure=measured,
        oversize=oversize,
        most=own.most,
        step=own.row_step,
        ripple=own.ripple,
        orderly=own.orderly,
    )


def measure(design: Design, careful: bool, tolerance: Tolerance = NOTHING_ALLOWED) -> Trial:
    """Distance of a design from its surface, and the edges of its panels, flaps left out."""
    mechanism = design.mechanism
    flat = mechanism.positions(0.0)[:, mechanism.inner_columns]
    edges = [lengths(np.diff(flat, axis=axis)) for axis in (0, 1)]
    shortest = float(min(each.min() for each in edges))
    longest = float(max(each.max() for each in edges))
    if careful:
        error = measure_deviation(design, samples=CAREFUL).max
    else:
        fits = tolerance.allows(shortest, longest)
        error = find_excess(design, tolerance.surface if fits else 0.0, samples=QUICK)
    return Trial.of(len(flat) - 2, flat.shape[1], error, shortest, longest)
