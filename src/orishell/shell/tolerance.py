"""From a design file with a tolerance to the pattern with the fewest panels that meets it."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from functools import cache
from typing import Any

from orishell.conventions.errors import DesignError
from orishell.conventions.memory import MEMORY, key_of
from orishell.conventions.progress import Progress, no_progress
from orishell.design_file import DesignFile
from orishell.families.pattern import Pattern as FamilyPattern
from orishell.families.tolerance import Tolerance, Variants
from orishell.shell.board_limits import (
    NO_BOARDS,
    BoardFit,
    as_cut,
    fit_boards,
    looks_at_boards,
    on_stock,
)
from orishell.shell.designed import completed, designed
from orishell.shell.size_search import choose
from orishell.shell.size_trials import Choice, Sizes, Trial, measure
from orishell.shell.surface_search import SurfaceSearch
from orishell.workshop.fitting import SLACK, OversizeError
from orishell.workshop.layout import require_stock

SIZE_KEYS = frozenset({"pattern.rows", "pattern.columns"})
"""What may not be given beside a tolerance, so that no remedy names it."""
UNSIZED = frozenset({"motion", "search"})
"""Tables that have no say in it."""


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
        if file.surface is None:
            pattern, choice = choose(_sizes(file, limits), limits, progress)
        else:
            pattern, choice = file.pattern, _choose_on_surface(file, limits, progress)
    except DesignError as refusal:
        if on_stock(file):
            return _with_any_stock(file, tolerance, progress)
        refusal.candidates = (
            each for each in refusal.candidates if not each.changes.keys() & SIZE_KEYS
        )
        raise
    pattern = pattern.sized(choice.trial.rows, choice.trial.columns)
    table = pattern.model_dump(exclude_unset=True)
    sized = file.changed({"tolerance": None, "pattern": table})
    return sized, replace(choice, limits=tolerance)


def _choose_on_surface(file: DesignFile, limits: Tolerance, progress: Progress) -> Choice:
    """The size where the target is a surface, which sheets of every size are fitted to."""
    surface = file.surface
    assert surface is not None

    def measured(rows: int, columns: int, told: Progress) -> tuple[Trial, BoardFit]:
        design = file.pattern.sized(rows, columns).design_on(surface, told)
        trial = measure(design, True, limits)
        trial = replace(trial, rows=rows, columns=columns)
        if not looks_at_boards(file):
            return trial, NO_BOARDS
        return trial, fit_boards(file, completed(file, design), limits)

    return SurfaceSearch(measured, surface.piece.extents, limits, progress).run()


def _with_any_stock(
    file: DesignFile, tolerance: Tolerance, progress: Progress
) -> tuple[DesignFile, Choice]:
    """What meets a tolerance if stock is as large as needed: it is refused for that, or at all."""
    free = file.changed({"workshop.stock": None, "workshop.roll": None})
    anywhere, choice = meet_tolerance(free, tolerance, progress)
    try:
        require_stock(as_cut(file, designed(anywhere)), file.workshop)
    except OversizeError as error:
        nearer = "another distance in [tolerance]: no sheet was found that comes within "
        nearer += f"{tolerance.surface:g} of the surface and whose panels fit"
        larger = file.changed({key: list(sides) for key, sides in error.needed.items()})
        if _meets(larger, tolerance):
            error.remedy = f"{error.larger}, or {nearer}"
        else:
            error.expected, error.remedy = "room for its panels", f"much larger stock, or {nearer}"
        raise
    return anywhere.changed({"workshop": file.tables["workshop"]}), choice


def _meets(file: DesignFile, tolerance: Tolerance) -> bool:
    """Whether a file with other stock meets a tolerance, which a message is to offer."""
    try:
        _searched(file, tolerance, no_progress)
    except (DesignError, OversizeError):
        return False
    return True


def _limits(file: DesignFile, tolerance: Tolerance) -> Tolerance:
    """The tolerance, and no edge longer than the diagonal of what the sheet is cut from.

    Boards are shorter than the edges of their panels, by as much as they are set back.
    """
    panel, workshop = file.panel, file.workshop
    if panel is not None and panel.is_solid:
        return tolerance
    if panel is not None and workshop.roll is not None:
        workshop = workshop.replace_unchecked(stock=workshop.roll)
    if workshop.stock is None:
        return tolerance
    longest = (1 + SLACK) * math.hypot(*workshop.usable_stock)
    return tolerance.replace_unchecked(panel_max=min(tolerance.panel_max, longest))


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

    def boards(variant: FamilyPattern, columns: int) -> BoardFit:
        if not looks_at_boards(file):
            return NO_BOARDS
        sized = replace(file, pattern=variant.sized(variant.rows, columns))
        return fit_boards(sized, designed(sized), limits)

    return Sizes(
        variants=in_rows,
        distance_from_f=lambda variant: variant.distance_from_f(file.f),
        distance_from_g=distance_from_g,
        measure=measured,
        boards=boards,
        most=own.most,
        step=own.row_step,
        ripple=own.ripple,
        orderly=own.orderly,
    )
