"""Declarations of CSS: a property, its value, and whether it is important."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import Any, NamedTuple

from orishell.conventions.errors import InputError

Declarations = Mapping[str, "Declared"]
"""By property."""


class Declared(NamedTuple):
    """What a property is declared to be."""

    important: bool
    value: str


@lru_cache(maxsize=4096)
def inline(text: str) -> Declarations:
    """What an attribute ``style`` declares."""
    return declarations(text)


def declarations(content: str | Iterable[Any]) -> Declarations:
    """What the content of a rule declares, as text or parsed.

    Raises InputError: If brackets are nested too deeply.
    """
    import tinycss2

    try:
        return cascaded(
            {each.lower_name: Declared(each.important, tinycss2.serialize(each.value).strip())}
            for each in tinycss2.parse_blocks_contents(content, True, True)
            if each.type == "declaration"
        )
    except RecursionError:
        raise nested() from None


def nested() -> InputError:
    """The error for brackets within each other that are too many to be read."""
    return InputError(
        "brackets of a style are nested too deeply",
        remedy="save it with presentation attributes in place of styles",
    )


def cascaded(ascending: Iterable[Declarations]) -> Declarations:
    """What counts of several, of which the last one counts most."""
    found: dict[str, Declared] = {}
    for each in ascending:
        for name, declared in each.items():
            if name not in found or declared.important >= found[name].important:
                found[name] = declared
    return found
