"""What fewer panels cost: how near sheets of a range of sizes come to their surface."""

from __future__ import annotations

import math
from itertools import product
from typing import Any

from orishell.conventions.errors import DesignError, OrishellError
from orishell.conventions.formatting import rounded
from orishell.conventions.progress import Progress, followed, no_progress, stretch
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.design_file import DesignFile
from orishell.families.tolerance import Tolerance
from orishell.shell.size_search import size_ladder
from orishell.shell.size_trials import Trial, measure, unbeaten

MOST_PANELS = 1_000
"""Panels of the sheets that are tried, at most, but twice those of the present sheet."""
GAIN = 0.99
"""Share of the error of a sheet with fewer panels that one with more must stay below."""
TRYING, MEASURING = "trying rows and columns", "measuring the nearest carefully"
TRIED = 0.6
"""Share of the work that is the trials; the rest is careful measuring."""


@record
class Tradeoff:
    """Sheets of many sizes, and the best of them."""

    tried: tuple[Trial, ...]  # all sheets that were made, measured quickly, by panels
    # those that no other beats, or nearly so, in both error and number of panels, with edges as
    # long as the design's tolerance allows, measured carefully
    best: tuple[Trial, ...]
    refused: int  # number of sizes that the family refuses
    # keys of the pattern, besides rows and columns, that the design leaves open, with the values
    # that all trials have
    settled: dict[str, Any]


def find_tradeoff(
    file: DesignFile, progress: Progress = no_progress, *, size: tuple[int, int] | None = None
) -> Tradeoff:
    """Design sheets of many sizes, and measure how near they come to the surface.

    The sizes are those of the search that meets a tolerance, each number of rows with each number
    of columns, and ``size``, which is the pattern's own if it is not given. Of the file's tolerance
    only the limits of edges count.

    Raises DesignError if the family refuses all sizes, or no sheet has edges as long as they may
    be.
    """
    limits = file.tolerance or Tolerance.model_construct(surface=math.inf)
    free = limits.replace_unchecked(surface=math.inf)
    own = file.pattern if size is None else file.pattern.sized(*size)
    pattern = own.variants(file.f, free).telling[0]
    left_open = pattern.model_fields_set - file.pattern.model_fields_set
    settled = {key: getattr(pattern, key) for key in sorted(left_open)}

    def trial(size: tuple[int, int], *, careful: bool) -> Trial:
        return measure(pattern.sized(*size).design(file.f, file.g), careful)

    sizes = _sizes(pattern.most, (pattern.rows, pattern.columns))
    tried: list[Trial] = []
    refusal: OrishellError | None = None
    for each in followed(sizes, len(sizes), stretch(progress, 0.0, TRIED), TRYING):
        try:
            tried.append(trial(each, careful=False))
        except OrishellError as error:  # lists of lengths fit their own size only
            refusal = refusal or error
    if refusal is not None and not tried:
        raise refusal
    fitting = [each for each in tried if limits.allows(each.shortest, each.longest)]
    if not fitting:
        raise _no_such_edges(tried, limits)
    quick = unbeaten(fitting)
    careful = [
        trial((each.rows, each.columns), careful=True)
        for each in followed(quick, len(quick), stretch(progress, TRIED, 1.0), MEASURING)
    ]
    tried.sort(key=lambda trial: (trial.panels, rounded(trial.error, 9)))
    return Tradeoff(tuple(tried), unbeaten(careful, GAIN), len(sizes) - len(tried), settled)


def _sizes(most: int, now: tuple[int, int]) -> list[tuple[int, int]]:
    """Rows and columns that are tried, the fewest panels first."""
    panels = max(MOST_PANELS, 2 * _panels(now))
    rows, columns = size_ladder(most)
    sizes = {size for size in product(rows, [2, *columns]) if _panels(size) <= panels}
    return sorted(sizes | {now}, key=lambda size: (_panels(size), size))


def _panels(size: tuple[int, int]) -> int:
    return (size[0] + 1) * (size[1] - 1)


def _no_such_edges(tried: list[Trial], limits: Tolerance) -> DesignError:
    shortest, longest = (min(t.shortest for t in tried), max(t.longest for t in tried))
    return DesignError(
        f"no sheet has panel edges from {limits.panel_min:g} to {limits.panel_max:g}",
        place=f"in {len(tried)} sizes that were tried",
        size=f"their edges are from {plain(shortest)} to {plain(longest)} long",
        keys=("tolerance.panel_min", "tolerance.panel_max"),
        excess=min(
            max(limits.panel_min / t.shortest, t.longest / limits.panel_max) - 1 for t in tried
        ),
    )
