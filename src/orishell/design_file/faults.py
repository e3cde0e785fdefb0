"""What is wrong with a design file, and where in it."""

from __future__ import annotations

from collections.abc import Callable
from itertools import takewhile
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from orishell.conventions.arguments import Location, Place, first_fault
from orishell.conventions.errors import InputError

LISTS = ("load_case",)
"""Tables of which there may be several."""


def explain(
    path: Path,
    raw: dict[str, Any],
    error: ValidationError,
    keys: Callable[[Location], list[str]],
    inside: tuple[str, ...] = (),
) -> InputError:
    """One message for the first fault; the others follow, a line each."""

    def place(location: Location) -> Place:
        table = takewhile(lambda part: isinstance(part, str), location)
        return {"file": path, "where": _spell(location), "keys": (".".join(map(str, table)),)}

    return first_fault(raw, error, place, keys, inside)


def _spell(location: Location) -> str:
    """("target", "f", "range", 0) as "[target.f] range[0]", of lists "[[table]][0] key"."""
    names = [part[:60] if isinstance(part, str) else part for part in location]
    table, *rest = names
    if table == "target" and rest:
        table, *rest = f"target.{rest[0]}", *rest[1:]
    head = f"[[{table}]]" if table in LISTS else f"[{table}]"
    return head + "".join(f"[{part}]" if isinstance(part, int) else f" {part}" for part in rest)
