"""Reading TOML: tables of values, limited in size and depth but not checked otherwise."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Any

from orishell.conventions.errors import InputError
from orishell.conventions.source_file import read_source_file

MAX_BYTES = 1_000_000
DEEPEST = 8
"""Tables, lists and parts of a dotted key within each other, at most; a design has five."""
WHOLE = 2**63
"""Whole numbers are smaller than this, as TOML says."""
_TOKEN = re.compile(
    r'"""(?:[^"\\]|\\.|"(?!""))*+(?:"""|\Z)'
    r"|'''.*?(?:'''|\Z)"
    r'|"(?:[^"\\\n]|\\.)*+"?'
    r"|'[^'\n]*'?"
    r"|#[^\n]*"
    r"|[\[\]{}.,=\n]",
    re.DOTALL,
)
"""Texts and comments, which do not count, and what nests, joins and separates."""


_PLACE = re.compile(r"\(at line (\d+), column (\d+)\)")
_VALUE = re.compile(r"\s*[\w.-]+\s*=\s*([^#]*?)\s*(?:#.*)?$")
_DECIMAL_COMMA = re.compile(r"[+-]?\d+,\d+")
_WORD = re.compile(r"[A-Za-z][\w./-]*")
LONGEST = 500
"""Characters of a line that is looked at for what was meant."""
WIDTH = 80
"""Characters of a line that a message shows."""


def read_toml(path: Path, what: str = "design file", remedy: str = "") -> dict[str, Any]:
    """The tables of a TOML file, or an InputError that says what it should be.

    ``remedy`` is what to do if it does not exist.
    """
    try:
        text = read_source_file(path, what, MAX_BYTES, remedy).decode("utf-8-sig")
    except InputError as error:
        raise error.located(str(path)) from None
    except UnicodeDecodeError as error:
        raise InputError(
            f"the {what} cannot be read", where=str(path), got=str(error), expected="UTF-8"
        ) from None
    try:
        return parse_toml(text)
    except InputError as error:
        raise error.located(f"{path}:") from None


def parse_toml(text: str) -> dict[str, Any]:
    """The tables of a TOML text, or an InputError: of nesting and whole numbers, too."""
    _require_depth(text)
    try:
        tables = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise _no_toml(text, str(error)) from None
    except ValueError:  # Python reads no more digits than these
        raise _too_large("more than 4300 digits") from None
    _require_numbers(tables)
    return tables


def _no_toml(text: str, said: str) -> InputError:
    """The error about a text that is no TOML, with the line that it is about."""
    place = _PLACE.search(said)
    if place is None:
        return InputError("this is not TOML", got=said)
    line = text.split("\n")[int(place[1]) - 1].rstrip()
    column = int(place[2]) - 1
    value = _VALUE.match(line) if len(line) <= LONGEST else None
    remedy = ""
    if value is not None and _DECIMAL_COMMA.fullmatch(value[1]):
        remedy = f"numbers have a decimal point: write {value[1].replace(',', '.')}"
    elif value is not None and _WORD.fullmatch(value[1]):
        remedy = f'put texts in quotes: "{value[1]}"'
    elif text.lstrip().startswith("{"):
        remedy = "this looks like JSON: orishell check, fold and convert read FOLD files"
    begin = max(0, column - WIDTH // 2)
    shown = "".join(each if each.isprintable() else " " for each in line[begin : begin + WIDTH])
    return InputError(
        "this is not TOML",
        got=said,
        remedy=remedy,
        detail=f"    {shown}\n    {' ' * (column - begin)}^",
    )


def _require_depth(text: str) -> None:
    """Refuse deep nesting: the parser's time grows with the square of a dotted key's length."""
    depth = dots = 0
    for token in _TOKEN.finditer(text):
        match text[token.start()]:
            case "[" | "{":
                depth += 1
            case "]" | "}":
                depth -= 1
            case ".":
                dots += 1
            case "," | "=" | "\n":
                dots = 0
        if depth + dots > DEEPEST:
            line = text.count("\n", 0, token.start()) + 1
            raise InputError(
                f"tables, lists or keys are nested too deeply, at line {line}",
                expected=f"at most {DEEPEST} tables, lists or parts of a key within each other",
            )


def _require_numbers(value: Any, where: tuple[str, ...] = ()) -> None:
    if isinstance(value, int) and not -WHOLE <= value < WHOLE:
        raise _too_large(f"{value.bit_length()} bits").located(".".join(where)[:60])
    if isinstance(value, dict):
        for key, inner in value.items():
            _require_numbers(inner, (*where, key))
    elif isinstance(value, list):
        for inner in value:
            _require_numbers(inner, where)


def _too_large(got: str) -> InputError:
    return InputError("a whole number is too large", got=got, expected="at most 64 bits")
