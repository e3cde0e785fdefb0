"""Rows and columns with which panels fit the stock and the roll, where those of a file do not.

They are tried as far as the offer says: the sheet is made, and all that is cut of it held against
what it is cut from. Its motion is not examined, which for a sheet that is fitted to a surface takes
longer than the fit.
"""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping
from math import ceil

from orishell.conventions.errors import DesignError, InputError, Remedy
from orishell.conventions.progress import Progress
from orishell.design_file import DesignFile
from orishell.families.registry import AUTO
from orishell.shell.board_limits import as_cut
from orishell.shell.designed import designed
from orishell.workshop.fitting import OversizeError
from orishell.workshop.layout import find_oversize

SECONDS = 40.0
"""Work after which no more are tried (s): a sheet of 16 x 16 panels is fitted in 8 to 20."""
TRIALS = 6
"""Sizes that are tried one after the other, at most."""
EVENER = 0.75
"""Panels of a fitted sheet become more alike as there are more of them, so that the largest shrinks
faster: where they are 1.7 times too large, 1.7 ** 0.75 times as many along each side did."""
LEAST_GROWTH = 1.1
"""At least so many times as many panels are tried next."""
HELPS = 0.3
"""Panels of so many times as many columns are as many times shorter, or to this power at least."""
MOST_PANELS = 20_000
"""No larger sheet is tried."""
LOOKING = "looking for rows and columns whose panels fit"


class _OutOfTimeError(Exception):
    """The time for looking is over."""


def with_more_panels(file: DesignFile, error: OversizeError, progress: Progress) -> OversizeError:
    """The refusal of stock, with rows and columns whose panels fit it, if any are found.

    Where rows or columns are still to be chosen, or the target to be scaled, none are looked for.
    """
    if file.family == AUTO or file.tolerance is not None or file.fit is not None or file.turns:
        return error
    until = time.thread_time() + SECONDS

    def watch(share: float, _: str) -> None:
        progress(share, LOOKING)
        if time.thread_time() > until:
            raise _OutOfTimeError

    try:
        factor = _oversize(file, {}, watch)
        # Else it is a part that is put on the sheet which is too large.
        changes = next(_found(file, factor, watch), None) if factor > 1 else None
    except _OutOfTimeError:
        return error
    if changes is not None:
        error.changes = dict(changes)
        error.remedy = (
            f"{error.larger}, or {Remedy(changes)}: all panels of that sheet fit, its motion was "
            "not examined"
        )
    return error


def _found(file: DesignFile, factor: float, progress: Progress) -> Iterator[dict[str, int]]:
    """Rows and columns whose panels fit: more columns, more rows, or more of both.

    Of a sheet that is fitted to a surface both are more at once, as each trial takes long.
    """
    fitted = file.surface is not None
    for wider, higher in [(True, True)] if fitted else [(True, False), (False, True), (True, True)]:
        rows, columns, larger = file.pattern.rows, file.pattern.columns, factor
        for number in range(TRIALS):
            growth = max(LEAST_GROWTH, larger**EVENER if fitted else larger)
            rows = _more(rows, growth) if higher else rows
            columns = _more(columns, growth) if wider else columns
            if (rows + 1) * (columns + 1) > MOST_PANELS:
                break
            progress(number / TRIALS, "")
            changes = {"pattern.rows": rows, "pattern.columns": columns}
            before, larger = larger, _oversize(file, changes, progress)
            if larger <= 1:
                yield changes
            if larger > before / growth**HELPS:  # panels are too long the other way
                break


def _more(count: int, growth: float) -> int:
    """Rows, or columns, of so many times as many panels; odd if they were odd."""
    return count + 2 * ceil(0.5 * (growth - 1) * (count + 1))


def _oversize(file: DesignFile, changes: Mapping[str, int], progress: Progress) -> float:
    """How much larger than what it is cut from a part of a changed file's sheet is; 1 if all fit.

    As large as one likes where there is no such sheet.
    """
    try:
        changed = file.tried(changes)
        return find_oversize(as_cut(changed, designed(changed, progress)), changed.workshop)
    except (DesignError, InputError):
        return float("inf")
