"""What governs each limit state, among all cases that are combined for it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from orishell.conventions.record import record
from orishell.numerics.equals import SOLVED, largest_of
from orishell.structure.case import CaseResult
from orishell.structure.combinations import LimitState
from orishell.structure.stiffness import Stiffness
from orishell.structure.utilisation import Limiting

MANY = 12
"""With more cases than these, only those that govern are told in full."""


@record
class Governing:
    """What is nearest to the end of what it bears, of all cases."""

    part: Limiting  # what it is
    # the load case, and the stiffness of its creases
    case: str
    creases: Stiffness
    utilisation: float  # the share of what it bears


@record
class Envelope:
    """What governs one limit state.

    That is a case under which the shell moves. If there is none, it is for ULS the largest share of
    what can be borne, for EQU of friction or of what ballast holds, for SLS the largest
    displacement.
    """

    limit_state: LimitState  # which
    cases: int  # number of its cases
    moves: int  # number of those under which the shell moves, with any stiffness of creases
    # the case that governs, and the stiffness of its creases
    case: str
    creases: Stiffness
    # what is largest there: "panels", "creases", "ties" or "buckling"; "displacement"; "friction"
    # or "ballast"; null if the shell moves, or nothing is known of it
    part: str | None
    # its share of what can be borne, of the shell's height, or of the friction that there is
    share: float | None


def envelopes(cases: Sequence[CaseResult]) -> Iterator[Envelope]:
    """Of every limit state that has cases."""
    states: tuple[LimitState, ...] = ("ULS", "EQU", "SLS")
    for state in states:
        own = [case for case in cases if case.limit_state == state]
        if own:
            moving = [case for case in own if case.equilibrium is None]
            worst = moving[0] if moving else largest_of(own, _share, SOLVED)
            part, share = (None, None) if moving else _largest(worst)
            count = len({case.name for case in own})
            moves = len({case.name for case in moving})
            yield Envelope(state, count, moves, worst.name, worst.creases, part, share)


def _largest(case: CaseResult) -> tuple[str | None, float | None]:
    """What its limit state asks, where it is largest, and how large it is."""
    found = case.equilibrium
    assert found is not None
    if case.limit_state == "SLS":
        return "displacement", found.displacement.share
    if case.limit_state == "EQU":
        shares = {
            "friction": found.friction,
            "ballast": None if case.ballast is None else case.ballast.used,
        }
        known = [(share, part) for part, share in shares.items() if share is not None]
        share, part = max(known, default=(None, None))
        return part, share
    used = found.utilisation
    return (None, None) if used.governs is None else (used.governs, used.shares[used.governs])


def _share(case: CaseResult) -> float:
    return _largest(case)[1] or 0.0


def reported_cases(
    cases: tuple[CaseResult, ...], found: Sequence[Envelope], governs: Governing | None
) -> tuple[CaseResult, ...]:
    """Of many cases those that govern, and those of no code; all cases if they are few."""
    if len({case.name for case in cases}) <= MANY:
        return cases
    kept = {each.case for each in found if each.moves or each.part is not None}
    if governs is not None:
        kept.add(governs.case)
    return tuple(case for case in cases if not case.limit_state or case.name in kept)


NAMED = 6
"""A sentence names so many cases at most; it counts the rest."""


def few(names: Sequence[str]) -> str:
    """Names of cases as a sentence lists them."""
    if len(names) <= NAMED:
        return "; ".join(names)
    return f"{'; '.join(names[: NAMED - 1])}; and {len(names) - NAMED + 1} more"
