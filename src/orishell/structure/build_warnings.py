"""Words for what an analysis found: how a shell moves, what to be warned of, what is left out."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from orishell.conventions.quantities import plain
from orishell.structure.case_report import CaseReport, StandingReport
from orishell.structure.results import FreeMotion, Hold
from orishell.structure.settings import LoadCase, Structure

LARGE = 0.05
"""Displacements above this share of the shell's height are too large for linear theory: the thrust
of an arch is a moment of its loads over its height, so it is wrong by about as much."""
COARSE = 0.1
"""Displacements that change by more than this share with cells half as large are not near."""
LEAST_BUCKLING = 3.0
"""Below this factor a shell may well buckle: imperfect ones do before linear theory says so."""
HOLDS: dict[Hold, str] = {"ties": "ties between its feet", "pinned": "pinned supports"}
NOT_COVERED = (
    "imperfections of shape and fit, and play of hinges",
    "large displacements: all is linear, from the shape as it was designed",
    "buckling of single webs and faces of boards between their webs",
    "boards that are stiffer or stronger in one direction than in the other",
    "glue, seams and holes, and what tears at the corners of panels",
    "creep, fatigue, heat and moisture",
    "anchors, and the ground under the feet",
    "wind and snow on flaps: only their weight counts",
    "wind inside, and gusts that shake the shell",
    "snow that drifts, or that a corrugation keeps from sliding off steep panels",
    "the way from the pack to the target",
)
"""What the analysis says nothing of."""


def motion_in_words(motion: FreeMotion) -> str:
    """How a shell moves under its loads, what does not hold it, and what would."""
    if motion.soft:
        words = "gives way under its loads, by more than its own size: it is far too soft for them"
    elif not motion.folding:
        words = "slides or tips as a whole under its loads: its supports do not hold it"
    elif motion.opens:
        words = "opens under its loads: nothing holds the feet together"
    else:
        words = "closes under its loads: nothing holds the feet apart"
    if motion.soft and not motion.holds:
        return words
    if not motion.holds:
        return f"{words}; neither ties between its feet nor pinned supports would"
    return f"{words}; {' or '.join(HOLDS[each] for each in motion.holds)} would"


def name_of(case: CaseReport, cases: Sequence[CaseReport]) -> str:
    """What a case is called, the stiffness of creases said where there are several.

    Parameters
    ----------
    case
        The case.
    cases
        All cases.
    """
    if len({each.creases for each in cases}) < 2:
        return case.name
    creases = case.creases
    return f"{case.name}, " + (
        f"{creases} creases" if isinstance(creases, str) else f"creases of {creases:g} N"
    )


def warn_of_structure(
    structure: Structure, cases: Sequence[CaseReport], change: float
) -> Iterator[str]:
    """Warnings of what moves, of what bears too much, and of where the analysis ends.

    Parameters
    ----------
    structure
        What was asked.
    cases
        What was found.
    change
        By what share displacements changed when cells were halved for the last time.
    """
    if change > COARSE:
        yield (
            f"displacements changed by {plain(100 * change, 3)} % when cells were halved: "
            "finer ones "
            f"(cells, or refine, in [structure]) come nearer"
        )
    for case in cases:
        found = [f"the shell {case.moves}"] if case.moves is not None else []
        if case.stands is not None:
            found += _of_standing(case.stands)
        yield from (f"load case {name_of(case, cases)}: {text}" for text in found)
    named = {case.name: case for case in structure.cases}
    for asked in structure.analysed:
        parts = [asked, *(named[name] for name in asked.combine)]
        yield from (f"load case {asked.name}: {text}" for text in _of_loads(parts))


def _of_standing(found: StandingReport) -> Iterator[str]:
    share, factor, used = found.displacement.share, found.buckling, found.utilisation
    if share > LARGE:
        yield (
            f"the shell is displaced by {plain(100 * share, 3)} % of its height, more than the "
            f"{100 * LARGE:g} % to which linear theory holds: forces are wrong by about as much"
        )
    if factor is not None and factor < LEAST_BUCKLING:
        yield (
            f"the shell buckles under {plain(factor, 3)} times its loads by linear theory, "
            "and earlier "
            f"with imperfections: less than {LEAST_BUCKLING:g} times is too little"
        )
    if found.friction is not None and found.friction > 1:
        yield (
            f"a foot needs {plain(found.friction, 3)} times the friction that it has: it "
            "slips until "
            "others bear more, which is left out"
        )
    for name, limit, part in (
        ("panels", "stress", used.panels),
        ("creases", "moment", used.creases),
        ("ties", "force", used.ties),
    ):
        if part is not None and part > 1:
            yield f"{name} bear {plain(part, 3)} times the {limit} that they can"


def _of_loads(parts: Sequence[LoadCase]) -> Iterator[str]:
    if not any(part.self_weight for part in parts):
        yield "own weight is left out (self_weight = true)"
    if any(part.wind is not None and part.wind.is_of_no_code for part in parts):
        yield "pressure coefficients of wind are of no code: give those of yours"
