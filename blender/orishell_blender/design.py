"""A design file: its tables, the values in them that may be changed, and its text."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

Tables = dict[str, Any]
Value = bool | int | float | str


class Refusal(Exception):  # noqa: N818 # what is refused is no fault of the program
    """What cannot be done, where, and what helps."""


def read_design(path: Path) -> Tables:
    """The tables of a file; refuses one that is no TOML."""
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise Refusal(f"{path}: {error.strerror}. Choose another file") from None
    except UnicodeDecodeError:
        raise Refusal(f"{path}: this is no text. Choose a design file (TOML)") from None
    except tomllib.TOMLDecodeError as error:
        raise Refusal(f"{path}: this is not TOML: {error}. Mend it and open it again") from None


def write_design(path: Path, tables: Tables) -> None:
    """Write tables as a design file, without the comments that it once had."""
    whole = [f"{key} = {_written(it)}" for key, it in tables.items() if not isinstance(it, dict)]
    for name, table in tables.items():
        if isinstance(table, dict):
            whole += ["", f"[{name}]", *(f"{key} = {_written(it)}" for key, it in table.items())]
    try:
        path.write_text("\n".join(whole) + "\n", encoding="utf-8")
    except OSError as error:
        raise Refusal(f"{path}: {error.strerror}. Save the design file elsewhere") from None


def _written(value: Any) -> str:
    if isinstance(value, dict):
        return f"{{ {', '.join(f'{json.dumps(key)} = {_written(value[key])}' for key in value)} }}"
    if isinstance(value, list):
        return f"[{', '.join(map(_written, value))}]"
    return json.dumps(value, ensure_ascii=False)


def values_of(tables: Tables) -> dict[str, Value]:
    """Numbers, switches and words of all tables, by dotted key."""
    return {
        f"{name}.{key}": value
        for name, table in tables.items()
        if isinstance(table, dict)
        for key, value in table.items()
        if isinstance(value, Value)
    }


def with_values(tables: Tables, values: Mapping[str, Value]) -> Tables:
    """The tables with other values at dotted keys; a word that is a number is meant as one."""
    made = {name: dict(it) if isinstance(it, dict) else it for name, it in tables.items()}
    for dotted, value in values.items():
        name, key = dotted.split(".", 1)
        made.setdefault(name, {})[key] = _meant(value) if isinstance(value, str) else value
    return made


def _meant(word: str) -> Value:
    try:
        return int(word) if word.isdecimal() else float(word)
    except ValueError:
        return word
