"""Cases whose loads a code arranges in several ways: each as a case of its own."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product

from orishell.structure.load_settings import LoadCase, Snow, Wind

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
