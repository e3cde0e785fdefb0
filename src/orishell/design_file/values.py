"""Values at dotted keys of a design file: read, written, removed."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

Values = dict[str, Any]
"""What keys of the design file have, by key, the tables in front of it."""


def value_at(tables: Any, key: str) -> Any:
    """What tables have at a dotted key; None if they have nothing there."""
    for part in key.split("."):
        if isinstance(tables, list) and part.isdecimal() and int(part) < len(tables):
            tables = tables[int(part)]
        elif isinstance(tables, dict):
            tables = tables.get(part)
        else:
            return None
    return tables


def with_values(tables: Any, values: Mapping[str, Any]) -> Any:
    """Tables of a design file with other values at some keys; what they name need not exist.

    Parameters
    ----------
    tables
        The tables.
    values
        Values by dotted key; in lists a number, from 0, is the key. None for a key that is removed.

    Raises
    ------
    LookupError
        If a key names an entry that a list does not have, or stands in what is no table.
    """
    for key, value in values.items():
        tables = _with_value(tables, key.split("."), value)
    return tables


def _with_value(tables: Any, keys: list[str], value: Any) -> Any:
    if not keys:
        return value
    first, *rest = keys
    match tables:
        case list():
            if not (first.isascii() and first.isdecimal() and int(first) < len(tables)):
                raise LookupError(first)
            inner = _with_value(tables[int(first)], rest, value)
            return [*tables[: int(first)], inner, *tables[int(first) + 1 :]]
        case dict():
            if value is None and not rest:
                return {key: inner for key, inner in tables.items() if key != first}
            return {**tables, first: _with_value(tables.get(first, {}), rest, value)}
    raise LookupError(first)
