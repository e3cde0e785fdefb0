"""From a design file with a tolerance to the pattern with the fewest panels that meets it."""

from __future__ import annotations

import numpy as np

from orishell.conventions.progress import Progress, stretch, unwatched
from orishell.design import Design
from orishell.design_file import DesignFile, require_memory
from orishell.deviation import SAMPLES as CAREFUL
from orishell.deviation import find_excess, measure_deviation
from orishell.errors import DesignError
from orishell.families.pattern import Pattern as FamilyPattern
from orishell.families.pattern import Tolerance
from orishell.sheet.quads import lengths
from orishell.shell.choice import Choice, Measured
from orishell.shell.size_search import choose

QUICK = 1_000
"""Samples each way during the search; the result is measured with as many as for the report."""
NOTHING_ALLOWED = Tolerance(0.0)


def meet_tolerance(
    file: DesignFile, tolerance: Tolerance, progress: Progress = unwatched
) -> tuple[FamilyPattern, Choice]:
    """Choose rows, columns and what else a design file leaves open.

    Returns
    -------
    tuple
        The pattern, and what it was chosen from.

    Raises
    ------
    DesignError
        If no pattern meets the tolerance; says what can be met.
    InputError
        If the pattern would be too large for its frames.
    """
    found: list[tuple[FamilyPattern, Choice]] = []
    refusals: list[DesignError] = []
    variants = file.pattern.variants(tolerance)
    for number, variant in enumerate(variants):

        def make(rows: int, columns: int, variant: FamilyPattern = variant) -> Design:
            return variant.sized(rows, columns).design(file.f, file.g)

        def measured(design: Design, careful: bool) -> Measured:
            return measure(design, careful, tolerance)

        part = stretch(progress, number / len(variants), (number + 1) / len(variants))
        try:
            choice = choose(make, measured, tolerance, part, most=variant.most)
        except DesignError as error:
            refusals.append(error)
            continue
        found.append((variant.sized(choice.trial.rows, choice.trial.columns), choice))
    if not found:
        raise refusals[0]
    pattern, choice = min(found, key=lambda each: each[1].trial.panels)
    require_memory(file.path, pattern, file.frames)
    return pattern, choice


def measure(design: Design, careful: bool, tolerance: Tolerance = NOTHING_ALLOWED) -> Measured:
    """Distance of a design from its surface, and the edges of its panels, flaps left out."""
    mechanism = design.mechanism
    flat = mechanism.positions(0.0)[:, mechanism.inner_columns]
    edges = [lengths(np.diff(flat, axis=axis)) for axis in (0, 1)]
    shortest = float(min(each.min() for each in edges))
    longest = float(max(each.max() for each in edges))
    if careful:
        error = measure_deviation(design, samples=CAREFUL).max
    else:
        fits = tolerance.panel_min <= shortest and longest <= tolerance.panel_max
        error = find_excess(design, tolerance.surface if fits else 0.0, samples=QUICK)
    return Measured(error, shortest, longest)
