"""A design file with other values at some keys: its comments are kept where they can be."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping, Sequence
from typing import Any

from orishell.design_file.tables import with_values


def rewritten(
    text: str, tables: Any, values: Mapping[str, Any], *, without: Sequence[str] = ()
) -> str:
    """The text of a design file as it is with other values.

    Parameters
    ----------
    text
        As it is.
    tables
        What it says, without the tables that are left out.
    values
        Values by dotted key, in lists a number from 0; None removes a key.
    without
        Tables that are left out.
    """
    import tomlkit

    tables = with_values(tables, values)
    try:
        document = tomlkit.parse(text)
        for name in without:
            document.pop(name, None)
        for key, value in values.items():
            _set(document, key.split("."), value)
        written = tomlkit.dumps(document)
    except tomlkit.exceptions.TOMLKitError:  # its comments cannot be kept
        written = ""
    return written if written and tomllib.loads(written) == tables else tomlkit.dumps(tables)


def _set(document: Any, keys: list[str], value: Any) -> None:
    *outer, last = keys
    for key in outer:
        document = (
            document[int(key)] if isinstance(document, list) else document.setdefault(key, {})
        )
    if value is None:
        document.pop(last, None)
    else:
        document[int(last) if isinstance(document, list) else last] = value
