"""Reading TOML: tables of values, limited in size and depth but not checked otherwise."""

from __future__ import annotations

import re
import tomllib
from codecs import BOM_UTF16_BE, BOM_UTF16_LE
from pathlib import Path
from typing import Any

from orishell.conventions.errors import InputError
from orishell.conventions.source_file import read_source_file
from orishell.conventions.toml_faults import no_toml

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


def read_toml(path: Path, what: str = "design file", remedy: str = "") -> dict[str, Any]:
    """The tables of a TOML file, or an InputError that says what it should be.

    ``remedy`` is what to do if it does not exist.
    """
    try:
        data = read_source_file(path, what, MAX_BYTES, remedy)
    except InputError as error:
        raise error.located(str(path)) from None
    try:
        return parse_toml(_text(data, what))
    except InputError as error:
        raise error.located(f"{path}:") from None


def parse_toml(text: str) -> dict[str, Any]:
    """The tables of a TOML text, or an InputError: of nesting and whole numbers, too."""
    _require_depth(text)
    try:
        tables = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise no_toml(text, str(error)) from None
    except ValueError:  # Python reads no more digits than these
        raise _too_large("more than 4300 digits") from None
    _require_numbers(tables)
    return tables


def _text(data: bytes, what: str) -> str:
    """The text of a file: UTF-8, or UTF-16 that says so at its beginning, as Notepad writes it."""
    if data.startswith((BOM_UTF16_LE, BOM_UTF16_BE)):
        return data.decode("utf-16", "replace")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        byte = data[error.start : error.start + 1]
        likely = byte.decode("cp1252", "replace")
        binary = b"\0" in data
        raise InputError(
            f"the {what} cannot be read" if binary else f"the {what} is not in UTF-8",
            where="" if binary else f"line {line}",
            got="what is no text" if binary else f"a byte {byte.hex()}, in Latin 1 {likely}",
            remedy=""
            if binary
            else "save it with the encoding UTF-8 (in Notepad: Save as, Encoding)",
        ) from None


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
