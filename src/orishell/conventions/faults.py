"""What pydantic finds wrong with values, in the words of our messages."""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable
from itertools import islice
from typing import Any

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from orishell.conventions.errors import InputError

MOST_FAULTS = 20
"""So many faults are said, the others counted."""
NUMBER = re.compile(r"[+-]?\d{1,20}(?:[.,]\d{0,20})?")
NUMBERS = ("int_type", "float_type")
Location = tuple[str | int, ...]
"""Keys and indices from the outermost table to the value."""


def first_fault(
    raw: dict[str, Any],
    error: ValidationError,
    spell: Callable[[Location], str],
    keys: Callable[[Location], list[str]],
    inside: tuple[str, ...] = (),
) -> InputError:
    """One message for the first fault; the others follow, a line each.

    ``spell`` says where a location is, ``keys`` which keys may stand beside its last one.
    ``inside`` are the keys of the table that pydantic looked at.
    """
    found = [
        (_key_path(raw, (*inside, *details["loc"]), details["type"]), details)
        for details in error.errors()
        if details["type"] != "default_factory_not_called"  # what it lacks is a fault itself
    ]
    places = {location for location, _ in found}
    faults: dict[Location, list[ErrorDetails]] = {}
    for location, details in found:
        # A value that fits none of several types has a fault, and others within it: they are one.
        whole = next(location[:k] for k in range(len(location) + 1) if location[:k] in places)
        faults.setdefault(whole, []).append(details)
    first, *others = [
        _fault(location, group, spell, keys)
        for location, group in islice(faults.items(), MOST_FAULTS)
    ]
    more = len(faults) - MOST_FAULTS
    lines = [*map(str, others), *([f"and {more} more"] if more > 0 else [])]
    first.detail = "\n".join(lines)
    return first


def _key_path(raw: dict[str, Any], location: Location, kind: str) -> Location:
    """The part of a location that is in the file, and what is missing there.

    What else a location has names alternatives of a type.
    """
    value: Any = raw
    found: list[str | int] = []
    for key in location:
        try:
            value = value[key]
        except (KeyError, IndexError, TypeError):
            continue
        found.append(key)
    return (*found, location[-1]) if kind == "missing" else tuple(found)


def _fault(
    location: Location,
    group: list[ErrorDetails],
    spell: Callable[[Location], str],
    keys: Callable[[Location], list[str]],
) -> InputError:
    details = group[0]
    context = details.get("ctx", {})
    if "key" in context:
        location = (*location, str(context["key"]))
    where = spell(location)
    kind = details["type"]
    if kind == "missing":
        return InputError("this key is missing", where=where)
    if kind == "extra_forbidden":
        close = difflib.get_close_matches(str(location[-1]), keys(location), n=1)
        return InputError(
            "unknown key",
            where=where,
            expected="one of " + ", ".join(keys(location)),
            remedy=f"write {close[0]}, if that is what was meant" if close else "remove it",
        )
    if kind == "source":
        return InputError(details["msg"], where=where, got=str(context.get("found", "")))
    got = context.get("got", details["input"])
    expected = " or ".join(dict.fromkeys(_expected(each) for each in group))
    return InputError(
        "this value does not fit",
        where=where,
        got=_shown(got),
        expected=expected,
        remedy=_remedy(kind, got),
    )


def _remedy(kind: str, got: Any) -> str:
    """What to write, where a number is a text or has a decimal comma, or a list is one table."""
    if kind in ("list_type", "tuple_type") and isinstance(got, dict):
        return "write the table's name in double brackets, [[...]]: there may be several of it"
    if isinstance(got, str) and kind in NUMBERS and NUMBER.fullmatch(got):
        return f"write {got.replace(',', '.')} without quotes"
    if kind == "too_long" and isinstance(got, list) and all(type(each) is int for each in got):
        return "numbers have a decimal point, as in 0.5: a comma separates entries"
    return ""


_EXPECTED = {
    "int_type": "a whole number",
    "int_from_float": "a whole number",
    "float_type": "a number",
    "finite_number": "a finite number",
    "string_type": "a text",
    "bool_type": "true or false",
    "list_type": "a list, in brackets",
    "tuple_type": "a list, in brackets",
    "dict_type": "a table",
    "model_type": "a table",
    "model_attributes_type": "a table",
    "greater_than": "a value greater than {gt:g}",
    "greater_than_equal": "a value of at least {ge:g}",
    "less_than": "a value less than {lt:g}",
    "less_than_equal": "a value of at most {le:g}",
    "too_short": "{min_length} entries",
    "too_long": "{max_length} entries",
    "literal_error": "{expected}",
    "dataclass_exact_type": "a {class_name}",
    "is_instance_of": "a {class}",
    "sequence_str": "a list, in brackets",
    "callable_type": "a function",
    "path_type": "a path",
}


def _expected(details: ErrorDetails) -> str:
    text = _EXPECTED.get(details["type"])
    return text.format(**details.get("ctx", {})) if text else details["msg"]


def _shown(value: Any) -> str:
    text = repr(list(value) if isinstance(value, tuple) else value)
    return text if len(text) <= 60 else text[:57] + "..."
