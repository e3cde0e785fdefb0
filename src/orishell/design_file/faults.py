"""What is wrong with a design file, and where in it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from orishell.conventions.faults import Location, first_fault
from orishell.errors import InputError


def explain(
    path: Path,
    raw: dict[str, Any],
    error: ValidationError,
    keys: Callable[[Location], list[str]],
    inside: tuple[str, ...] = (),
) -> InputError:
    """One message for the first fault; the others follow, a line each."""
    return first_fault(raw, error, lambda location: f"{path}: {_spell(location)}", keys, inside)


def _spell(location: Location) -> str:
    """("target", "f", "range", 0) as "[target.f] range[0]"."""
    names = [part[:60] for part in location if isinstance(part, str)]
    index = "".join(f"[{part}]" for part in location if isinstance(part, int))
    if len(names) == 1:
        return f"[{names[0]}]"
    table = names[:2] if names[0] == "target" and len(names) > 2 else names[:1]
    rest = names[len(table) :]
    if names[0] == "target" and len(names) == 2:
        return f"[{'.'.join(names)}]"
    return f"[{'.'.join(table)}] {' '.join(rest)}{index}"
