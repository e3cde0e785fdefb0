"""Curves in files, and messages about drawings that do not make one curve."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from itertools import islice
from pathlib import Path
from typing import Final

import numpy as np

from orishell.conventions.errors import CurveError, InputError
from orishell.conventions.quantities import conversion
from orishell.conventions.source_file import read_source_file
from orishell.curves.joining import CHOOSE, Chain, join_pieces
from orishell.curves.pieces import Piece
from orishell.numerics.arrays import Array

LISTED, TRIED = 6, 40
"""Parts and choices that a message names at most, and choices that are tried."""


def name_parts(
    error: CurveError,
    parts: Sequence[tuple[str, Sequence[Piece]]],
    choices: Iterable[tuple[str, Sequence[Piece]]],
    otherwise: str,
) -> CurveError:
    """Add to an error the parts of the drawing, and the choices that leave one curve.

    ``parts`` are names of elements with their pieces; ``choices`` are lines of the design file with
    the pieces that they leave, and of those that leave the same the first is named. ``otherwise``
    is the remedy if none leaves a curve.
    """
    if len(parts) < 2:
        return error.located(parts[0][0]) if parts else error
    more = f" and {len(parts) - LISTED} more" if len(parts) > LISTED else ""
    named = ", ".join(f"{name} ({_shape(pieces)})" for name, pieces in parts[:LISTED]) + more
    error.got = f"{error.got}, drawn by {named}" if error.got else named
    found: dict[bytes, str] = {}
    for choice, pieces in islice(choices, TRIED):
        chain = _chain(pieces)
        if not isinstance(chain, CurveError):
            found.setdefault(chain.joints.tobytes(), choice)
    chosen = " or ".join(list(found.values())[:LISTED])
    choose = f"choose the curve with {chosen}" if chosen else otherwise
    error.remedy = error.remedy.replace(CHOOSE, choose) if CHOOSE in error.remedy else choose
    return error


def _chain(pieces: Sequence[Piece]) -> Chain | CurveError:
    try:
        return join_pieces(pieces, lambda _: "")
    except CurveError as error:
        return error


def _shape(pieces: Sequence[Piece]) -> str:
    chain = _chain(pieces)
    if isinstance(chain, CurveError):
        return chain.what.removeprefix("the curve ").removeprefix("is ")
    return "a curve with two ends"


MAX_BYTES = 20_000_000
UNIT_NAMES: Final = {
    "mm": ("mm", "millimetre", "millimeter", "millimetres", "millimeters"),
    "cm": ("cm", "centimetre", "centimeter", "centimetres", "centimeters"),
    "m": ("m", "metre", "meter", "metres", "meters"),
    "in": ("in", "inch", "inches"),
    "ft": ("ft", "foot", "feet"),
}
_NAMED: Final = {name: unit for unit, names in UNIT_NAMES.items() for name in names}
SEMICOLONS: Final = "write decimals with a point, or separate columns by semicolons"
_BRACKETS = re.compile(r"\[([^\]]*)\]$")
_DECIMAL_COMMA = re.compile(r"\d,\d")
_LAST_WORD = re.compile(r"[\s_/(]\s*([^\W_]+)\s*\)?$")


def read_source(path: str | Path, kind: str, most: int = MAX_BYTES) -> bytes:
    """The bytes of a file that messages call ``kind``; an InputError does not name it."""
    try:
        path = Path(path)
    except TypeError as error:
        raise InputError(f"the {kind} cannot be read", got=str(error)) from None
    return read_source_file(path, kind, most, "the path is read relative to the design file")


def read_points(path: str | Path, *, into: str | None = None, unit: str | None = None) -> Array:
    """Points (N, 2) from the first two columns of a text file, in the order of its lines.

    Columns are separated by commas, semicolons, tabs or blanks; with semicolons or tabs, numbers
    may have decimal commas. A header line without numbers, empty lines and lines that begin with
    ``#`` are passed over. The header may state the unit, as in "x [mm], y [mm]" or "x_mm;y_mm".

    Parameters
    ----------
    path
        The file.
    into
        Unit of length of the result; the numbers as they stand if None.
    unit
        Unit of the numbers, whatever the header says; ``into`` if neither says anything.

    Raises
    ------
    InputError
        If the file is missing, empty, not text, or a line is not two numbers; with the line.
    CurveError
        If there are fewer than two points.
    """
    where = str(path)
    try:
        text = read_source(path, "file of points").decode("utf-8-sig")
    except InputError as error:
        raise error.located(f"{where}:") from None
    except ValueError as error:
        raise InputError(
            "the file of points cannot be read",
            where=where,
            got=str(error),
            expected="text in UTF-8",
            remedy="save the table as CSV",
        ) from None

    points: list[tuple[float, float]] = []
    header: tuple[int, list[str]] | None = None
    for number, line in enumerate(text.splitlines(), start=1):
        content = line.strip()
        if not content or content.startswith("#"):
            continue
        fields, decimal_comma = _split(content)
        pair = [_number(field, decimal_comma=decimal_comma) for field in fields]
        if len(pair) < 2 or pair[0] is None or pair[1] is None:
            if not points and header is None and all(value is None for value in pair):
                header = number, fields
                continue
            raise InputError(
                "this line is not a point",
                where=f"{where} line {number}",
                got=repr(content[:60]),
                expected="two numbers, x and y",
                remedy=SEMICOLONS if _DECIMAL_COMMA.search(content) else "",
            )
        if header is not None and "," in content and len(pair) == 2 * len(header[1]) > 2:
            raise InputError(
                "this line has twice as many columns as the header",
                where=f"{where} line {number}",
                got=repr(content[:60]),
                remedy=SEMICOLONS,
            )
        if not np.isfinite([pair[0], pair[1]]).all():
            raise InputError(
                "this point is not finite", where=f"{where} line {number}", got=repr(content[:60])
            )
        points.append((pair[0], pair[1]))
    if len(points) < 2:
        raise CurveError(
            "too few points for a curve",
            where=where,
            got=str(len(points)),
            expected="at least 2, one a line",
        )
    if into is None:
        return np.array(points)
    if unit is None and header is not None:
        unit = _header_unit(header[1][:2], f"{where} line {header[0]}")
    return np.array(points) * conversion(unit or into, into)


def _split(line: str) -> tuple[list[str], bool]:
    """The fields of a line, and whether commas in them are decimal commas."""
    for separator in (";", "\t") if ";" in line or "," not in line else ("\t", ","):
        if separator in line:
            fields = [field.strip().strip('"') for field in line.split(separator)]
            return fields, separator != ","
    return line.split(), False


def _number(field: str, *, decimal_comma: bool) -> float | None:
    if decimal_comma and field.count(",") == 1 and "." not in field:
        field = field.replace(",", ".")
    try:
        return float(field)
    except ValueError:
        return None


def _header_unit(fields: list[str], where: str) -> str | None:
    """The unit that the names of the first two columns state; None if they state none."""
    units = {}
    for field in fields:
        name = field.strip().lower()[-80:]
        bracket, word = _BRACKETS.search(name), _LAST_WORD.search(name)
        if bracket is not None and bracket[1].strip() not in _NAMED:
            raise InputError(
                "the header names a unit that is not known",
                where=where,
                got=repr(field[:60]),
                expected="one of " + ", ".join(UNIT_NAMES),
                remedy="or give unit in the design file, which overrules the header",
            )
        found = bracket[1].strip() if bracket is not None else word[1] if word else ""
        if found in _NAMED:
            units[field] = _NAMED[found]
    if len(set(units.values())) > 1:
        raise InputError(
            "the columns have different units", where=where, got=" and ".join(fields)[:80]
        )
    return next(iter(units.values()), None)
