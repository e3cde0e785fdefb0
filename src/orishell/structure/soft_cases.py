"""Cases that buckle soon by linear theory: followed as the shell is moved, or not known to carry.

EN 1993-1-1, 5.2.2, asks for such an analysis of frames, with imperfections, below a factor of 3.
It takes long, so it is done where the answer depends on it, the lowest factor first, and ends after
so many tangents: with the same input it ends alike on any machine.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from orishell.conventions.progress import Progress
from orishell.conventions.record import record
from orishell.numerics.equals import SOLVED, ascending
from orishell.structure.built_shape import usual_imperfection
from orishell.structure.case import CaseResult
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.held_panels import panel_loads
from orishell.structure.load_path import Unfollowed
from orishell.structure.model import Model
from orishell.structure.nonlinear import follow
from orishell.structure.settings import LoadCase
from orishell.structure.solve.active_set import Response
from orishell.structure.solve.moving import OutOfWorkError, Work
from orishell.structure.verdict import LEAST_BUCKLING

SECONDS = 60.0
"""All cases of a shell together are followed for so long, on one ordinary core as of 2020."""
TANGENT, GROWTH = 2.0, 1.2
"""Seconds for a tangent with 1e5 freedoms, and the power of the freedoms with which these grow."""


@record
class Loaded:
    """How a case was analysed by linear theory."""

    case: LoadCase
    known: Sequence[LoadCase]  # all cases, which it may combine
    response: Response  # what its loads do


def tangents(model: Model) -> float:
    """How many tangents may be found for all cases of a shell."""
    return float(SECONDS / (TANGENT * (model.mesh.count / 1e5) ** GROWTH))


def is_soft(case: CaseResult) -> bool:
    """Whether it is open if a case carries as its shell buckles soon by linear theory."""
    found = case.equilibrium
    if found is None or found.path is not None or case.sign == "fails":
        return False
    return found.buckling is not None and 1 <= found.buckling < LEAST_BUCKLING


def assumed_imperfection(linear: Equilibrium) -> float:
    """How far a shell that is followed is off its shape where nobody says so, at most (length)."""
    factor = linear.buckling
    return usual_imperfection(linear) if factor is not None and factor < LEAST_BUCKLING else 0.0


def follow_soft(
    model: Model,
    cases: Sequence[CaseResult],
    loaded: Sequence[Loaded | None],
    progress: Progress,
) -> tuple[CaseResult, ...]:
    """The cases, those that buckle soon followed, or with the reason why they are not.

    loaded: How each of those was analysed.
    """
    found = list(cases)
    work = Work(tangents(model))
    for number in _in_order(cases):
        case, how = found[number], loaded[number]
        assert case.equilibrium is not None
        assert how is not None
        progress(1.0, f"following {case.name}, large displacements")
        fails = any(each.sign == "fails" for each in found)
        followed = _followed(case.equilibrium, case, how, work, fails=fails)
        found[number] = replace(case, equilibrium=followed)
    return tuple(found)


def _in_order(cases: Sequence[CaseResult]) -> Iterator[int]:
    """Numbers of those that buckle soon, the soonest first."""
    factors = {
        number: case.equilibrium.buckling or 0.0
        for number, case in enumerate(cases)
        if case.equilibrium is not None and is_soft(case)
    }
    numbers = list(factors)
    yield from (numbers[place] for place in ascending(list(factors.values()), SOLVED).tolist())


def _followed(
    linear: Equilibrium, case: CaseResult, how: Loaded, work: Work, *, fails: bool
) -> Equilibrium:
    model = linear.model
    why: Unfollowed
    if fails:
        why = "fails"
    elif model.mesh.offsets is not None:
        why = "hinges"
    elif work.left < 1:
        why = "work"
    else:
        on_panels = panel_loads(model, how.case, how.known)
        off = usual_imperfection(linear)
        try:
            found = follow(
                linear, case.forces, on_panels, how.response, imperfection=off, work=work
            )
        except OutOfWorkError:
            why = "work"
        else:
            if found.path is not None and found.path.ending != "lost":
                return found
            why = "lost"
    return replace(linear, unfollowed=why)
