"""Combinations of load cases, EN 1990: 6.4.3.2 and 6.5.3, factors of annex A1.

Permanent cases are in all of them, each with its larger or with its smaller factor. A variable
action is absent or has one of its alternatives: snow that of one case and one arrangement, wind
that of one direction. Each that is present leads once. Maintenance is never beside snow or wind.

Loads that a code arranges in several ways make several cases, each by itself.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import chain, product
from typing import Annotated, Literal, NamedTuple

from pydantic import Field

from orishell.conventions.errors import InputError
from orishell.conventions.table import Number, Pair, Table, entries
from orishell.structure.load_settings import LOADS, Action, LoadCase, Snow, Wind

Alternatives = tuple[tuple[str, LoadCase], ...]
"""A case in its arrangements, each with its name in words; a single one has none."""


def alternatives(case: LoadCase) -> Alternatives:
    """A case of its own loads in each arrangement of its snow and of the pressure inside."""
    snows = [("", None)] if case.snow is None else _snows(case.snow)
    winds = [("", None)] if case.wind is None else _winds(case.wind)
    found = []
    for (snowing, snow), (blowing, wind) in product(snows, winds):
        words = [each for each in (snowing, blowing) if each]
        name = ", ".join([case.name, *words])
        found.append((" ".join(words), case.replace_unchecked(name=name, snow=snow, wind=wind)))
    return tuple(found)


def _snows(asked: Snow) -> list[tuple[str, Snow]]:
    found = asked.arrangements
    if len(found) == 1:
        return [("", asked)]
    return [(each.arrangement or "", each) for each in found]


def _winds(asked: Wind) -> list[tuple[str, Wind]]:
    found = asked.arrangements
    if len(found) == 1:
        return [("", asked)]
    sizes = [each.internal[0] for each in found]
    words = [f"{'suction' if size < 0 else 'pressure'} {abs(size):g} inside" for size in sizes]
    return list(zip(words, found, strict=True))


def arranged(cases: Sequence[LoadCase]) -> tuple[LoadCase, ...]:
    """All cases, those of several arrangements in each of them; combinations of all those."""
    known = {case.name: alternatives(case) for case in cases if not case.combine}
    found: list[LoadCase] = []
    for case in cases:
        if not case.combine:
            found.extend(each for _, each in known[case.name])
            continue
        for parts in product(*(known[name] for name in case.combine)):
            words = [each for each, _ in parts if each]
            factors = zip((each.name for _, each in parts), case.combine.values(), strict=True)
            name = ", ".join([case.name, *words])
            found.append(case.replace_unchecked(name=name, combine=dict(factors)))
    return tuple(found)


LimitState = Literal["ULS", "EQU", "SLS"]
"""Strength and buckling; equilibrium: sliding, lifting off, tipping; displacements."""
STRENGTH: tuple[LimitState | None, ...] = (None, "ULS")
"""Cases that are judged by strength and buckling: those of no code, and ULS."""
Expression = Literal["6.10", "6.10a/b"]
"""Of strength: one expression, or the two that together ask for less."""
DIGITS = 12
"""Decimals of factors: products such as 1.5 times 0.6 are what they are on paper."""
Factor = Annotated[Number, Field(ge=0, le=10)]
Psi = Annotated[tuple[Factor, Factor, Factor], entries(3)]
"""psi_0 of combinations, psi_1 of frequent ones, psi_2 of quasi-permanent ones."""


class Factors(Table):
    """Factors of EN 1990, as annex A1 recommends them; national annexes have others."""

    permanent: Pair[Factor] = (1.35, 1.0)  # gamma_G,sup and gamma_G,inf, table A1.2(B)
    permanent_equ: Pair[Factor] = (1.1, 0.9)  # the same of EQU, table A1.2(A)
    variable: Factor = 1.5  # gamma_Q where it is unfavourable; 0 where it is not
    reduction: Factor = 0.85  # xi of 6.10b
    snow: Psi = (0.5, 0.2, 0.0)  # table A1.1, up to 1000 m above the sea
    wind: Psi = (0.6, 0.2, 0.0)
    imposed: Psi = (0.7, 0.5, 0.3)  # of categories A and B
    maintenance: Psi = (0.0, 0.0, 0.0)  # of category H


class Combination(LoadCase):
    """A combination that a code makes."""

    limit_state: LimitState


class Part(NamedTuple):
    """A case in one of its arrangements."""

    name: str  # of the case that is combined
    words: str  # as names of combinations have it


class Variable(NamedTuple):
    """A variable action, of which one alternative acts at a time."""

    psi: tuple[float, float, float]
    parts: tuple[Part, ...]
    action: Action


def action_of(case: LoadCase) -> Action:
    """What a case is to EN 1990, by its loads or as it says.

    Raises InputError: If that is not clear.
    """
    loads = [name for name in LOADS if getattr(case, name)]
    kinds = {LOADS[name].action for name in loads}
    (kind,) = kinds if len(kinds) == 1 else (None,)
    if len(kinds) > 1 or (case.action is not None and kind not in {None, case.action}):
        raise InputError(
            "EN 1990 combines cases of one action each",
            where=f'[[load_case]] "{case.name}"',
            keys=("load_case",),
            got=", ".join(loads) + (f", {case.action}" if case.action else ""),
            remedy="give each of these loads a case of its own",
        )
    if kind is None and case.action in {None, "snow", "wind"}:
        raise InputError(
            "EN 1990 has to know what this case is",
            where=f'[[load_case]] "{case.name}" action',
            keys=("load_case",),
            got=", ".join(loads),
            expected='action = "permanent", "imposed" or "maintenance"',
        )
    return kind or case.action or "imposed"


def combine(
    cases: Sequence[LoadCase], factors: Factors, expression: Expression
) -> tuple[Combination, ...]:
    """All combinations of cases, those that would be the same only once.

    Raises InputError: If it is not clear what a case is.
    """
    permanent, variables = _actions(cases, factors)
    found: dict[tuple[LimitState, frozenset[tuple[Part, float]]], list[str]] = {}
    for state, kind, factor_of in _expressions(permanent, variables, factors, expression):
        rounded = {part: round(factor, DIGITS) for part, factor in factor_of.items()}
        asked = frozenset((part, factor) for part, factor in rounded.items() if factor)
        if asked:
            kinds = found.setdefault((state, asked), [])
            if kind not in kinds:
                kinds.append(kind)
    order = [*permanent, *chain.from_iterable(each.parts for each in variables)]
    return tuple(
        _combination(state, kinds, dict(asked), order) for (state, asked), kinds in found.items()
    )


def _combination(
    state: LimitState, kinds: list[str], asked: Mapping[Part, float], order: Sequence[Part]
) -> Combination:
    """With a name such as "ULS 1.35 dead + 1.5 snow drifted left + 0.9 wind across"."""
    parts = [part for part in order if part in asked]
    words = [
        part.words if asked[part] == 1 else f"{asked[part]:.5g} {part.words}" for part in parts
    ]
    named = " ".join([state, ", ".join(filter(None, kinds)), " + ".join(words)])
    return Combination.model_construct(
        name=" ".join(named.split()),
        combine={part.name: asked[part] for part in parts},
        limit_state=state,
    )


def _actions(
    cases: Sequence[LoadCase], factors: Factors
) -> tuple[tuple[Part, ...], tuple[Variable, ...]]:
    """Permanent cases, and variable actions with their alternatives."""
    permanent: list[Part] = []
    variable: dict[str, tuple[tuple[float, float, float], list[Part], Action]] = {}
    for case in cases:
        if case.combine:
            continue
        action = action_of(case)
        parts = [
            Part(each.name, f"{case.name} {words}".strip()) for words, each in alternatives(case)
        ]
        if action == "permanent":
            permanent.extend(parts)
            continue
        # imposed loads are independent of each other, snow cases and directions of wind are not
        key = case.name if action == "imposed" else action
        new: tuple[tuple[float, float, float], list[Part], Action]
        new = getattr(factors, action), [], action
        variable.setdefault(f"{action} {key}", new)[1].extend(parts)
    found = (Variable(psi, tuple(parts), action) for psi, parts, action in variable.values())
    return tuple(permanent), tuple(found)


def _expressions(
    permanent: tuple[Part, ...],
    variables: tuple[Variable, ...],
    factors: Factors,
    expression: Expression,
) -> Iterator[tuple[LimitState, str, dict[Part, float]]]:
    """Limit state, kind in words, and factors of every combination, some of them twice."""
    strength, equilibrium, most = factors.permanent, factors.permanent_equ, factors.variable
    reduced = (factors.reduction * strength[0], strength[1])
    both = list(_presences(variables))

    def make(
        gammas: tuple[float, ...], leads: Sequence[dict[Part, float]], gamma: float
    ) -> Iterator[dict[Part, float]]:
        for own in product(dict.fromkeys(gammas), repeat=len(permanent)):
            for each in leads:
                yield {
                    **dict(zip(permanent, own, strict=True)),
                    **{part: gamma * factor for part, factor in each.items()},
                }

    leading = [each for present in both for each in _leading(present, first=None, rest=0)]
    reduced_all = [{part: psi[0] for psi, part in present} for present in both]
    if expression == "6.10":
        ultimate = [make(strength, leading, most)]
    else:
        ultimate = [make(strength, reduced_all, most), make(reduced, leading, most)]
    yield from (("ULS", "", each) for each in chain.from_iterable(ultimate))
    yield from (("EQU", "", each) for each in make(equilibrium, leading, most))
    frequent = [each for present in both for each in _leading(present, first=1, rest=2)]
    lasting = [{part: psi[2] for psi, part in present} for present in both]
    for kind, leads in (
        ("characteristic", leading),
        ("frequent", frequent),
        ("quasi-permanent", lasting),
    ):
        yield from (("SLS", kind, each) for each in make((1.0,), leads, 1.0))


Present = tuple[tuple[tuple[float, float, float], Part], ...]
"""The variable actions that act, by one alternative each, with their psi."""


def _presences(variables: tuple[Variable, ...]) -> Iterator[Present]:
    """All choices of what acts: of every action nothing, or one of its alternatives.

    Nobody works on a roof under snow or in a storm: EN 1991-1-1, 3.3.2 (1).
    """
    choices = ((None, *((each, part) for part in each.parts)) for each in variables)
    for chosen in product(*choices):
        acting = [each for each in chosen if each is not None]
        actions = {each.action for each, _ in acting}
        if "maintenance" not in actions or not actions & {"snow", "wind"}:
            yield tuple((each.psi, part) for each, part in acting)


def _leading(present: Present, *, first: int | None, rest: int) -> Iterator[dict[Part, float]]:
    """Factors with each action leading once: by psi ``first``, None for 1; others by ``rest``."""
    for leads in range(len(present)) or (None,):
        yield {
            part: (1.0 if first is None else psi[first]) if number == leads else psi[rest]
            for number, (psi, part) in enumerate(present)
        }
