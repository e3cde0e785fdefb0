"""Panels thick enough to carry all load cases: tried, through the whole design."""

from __future__ import annotations

import time
from collections.abc import Callable

from orishell.conventions.errors import DesignError, InputError
from orishell.conventions.formatting import rounded
from orishell.conventions.progress import Progress
from orishell.design_file import DesignFile
from orishell.shell.remedies import SECONDS
from orishell.structure.case import CaseResult
from orishell.structure.results import Analysis
from orishell.structure.verdict import LARGE, LEAST_BUCKLING

SOFT = 3.0
"""A shell that gives way is tried with panels so many times as thick, as nothing is known of it."""
STEPS = (1.0, 1.3)
"""Tried are these multiples of the thickness that its figures ask for."""

Analyse = Callable[[DesignFile, Progress], Analysis | None]


def find_stronger(
    file: DesignFile, analysis: Analysis, analysed: Analyse, progress: Progress
) -> dict[str, float]:
    """The thickness, by its key, with which a shell that fails carries all cases; or nothing.

    analysed: Makes the shell of a file, and analyses it.
    """
    if analysis.model.structure.nonlinear:
        return {}  # to follow all cases again would take minutes
    if any(case.motion is not None and not case.motion.soft for case in analysis.cases):
        return {}  # thickness holds nothing
    key = "structure.thickness" if file.panel is None else "panel.thickness"
    wanted = analysis.model.thickness * max(_times(case) for case in analysis.cases)
    until = time.thread_time() + SECONDS

    def watch(share: float = 0.0, what: str = "") -> None:
        progress(share, "looking for panels that carry the loads")
        if time.thread_time() > until:
            raise TimeoutError

    for step in STEPS:
        thickness = rounded(step * wanted, 2)
        try:
            found = analysed(file.changed({key: thickness}), watch)
        except (DesignError, InputError):  # boards so thick cannot be made
            continue
        except TimeoutError:
            return {}
        if found is not None and found.sign != "fails":
            return {key: thickness}
    return {}


def _times(case: CaseResult) -> float:
    """By what thickness is to grow: moments are borne by its square, stiffness is its cube."""
    found = case.equilibrium
    if found is None:
        return SOFT
    bears, buckles = found.utilisation.panels or 0.0, found.utilisation.buckling or 0.0
    stiff: float = max(found.displacement.share / LARGE, LEAST_BUCKLING * buckles)
    return float(max(1.0, bears**0.5, stiff ** (1 / 3)))
