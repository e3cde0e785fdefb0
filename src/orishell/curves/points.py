"""Points of a curve in a text file: a table as spreadsheets and surveyors write it."""

from __future__ import annotations

import csv
import re
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from itertools import takewhile
from pathlib import Path
from typing import Final

import numpy as np

from orishell.conventions.errors import CurveError, InputError
from orishell.conventions.quantities import conversion
from orishell.curves.files import read_source
from orishell.numerics.arrays import Array

UNIT_NAMES: Final = {
    "mm": ("mm", "millimetre", "millimeter", "millimetres", "millimeters"),
    "cm": ("cm", "centimetre", "centimeter", "centimetres", "centimeters"),
    "m": ("m", "metre", "meter", "metres", "meters"),
    "in": ("in", "inch", "inches"),
    "ft": ("ft", "foot", "feet"),
}
_NAMED: Final = {name: unit for unit, names in UNIT_NAMES.items() for name in names}
SEMICOLONS: Final = "write decimals with a point, or separate columns by semicolons"
UNGROUPED: Final = "write numbers with nothing between their thousands"
NO_POINT: Final = "remove the line, or begin it with #"
WHICH: Final = "it is not known which columns are x and y"
TITLES: Final = "call two columns x and y in a first line, and no third one z"
MOST_UNNAMED = 3
"""Of so many columns without a name one may be the one that is constant; more are too many."""
_BRACKETS = re.compile(r"\[([^\]]*)\]$")
_DECIMAL_COMMA = re.compile(r"\d,\d")
_LAST_WORD = re.compile(r"[\s_/(]\s*([^\W_]+)\s*\)?$")
_OPENING, _CLOSING = frozenset("{("), frozenset("})")
_SEPARATOR = re.compile(r'"?sep=(.)"?', re.IGNORECASE)
_COORDINATE = re.compile(r"(?<![^\W_])([xyz])(?![^\W_])")
_THOUSANDS = re.compile(r"\d[.\s']\d{3}(,\d|\b)")
_RUNNING = re.compile(r"(nr|no|num|number|nummer|id|index|point|punkt|pt)\b|#", re.IGNORECASE)
CONSTANT = 1e-9
"""A column that varies by no more than this share of the one that varies most is constant."""


@dataclass(frozen=True)
class _Row:
    """A line of the table.

    Parameters
    ----------
    values
        Numbers in its fields, None where there is none.
    """

    number: int
    content: str
    fields: list[str]
    values: list[float | None]

    @property
    def has_numbers(self) -> bool:
        """Whether any of its fields is a number."""
        return any(value is not None for value in self.values)

    def fault(self, what: str, expected: str = "", remedy: str = "") -> InputError:
        """What is wrong with it; the error does not name the file."""
        where, got = f"line {self.number}", repr(self.content[:60])
        return InputError(what, where=where, got=got, expected=expected, remedy=remedy)


def read_points(path: str | Path, *, into: str | None = None, unit: str | None = None) -> Array:
    """Points (N, 2) from two columns of a text file, in the order of its lines.

    Columns are separated by commas, semicolons, tabs or blanks, or by what a first line `sep=;`
    says; with semicolons or tabs, or in quotation marks, numbers may have decimal commas. Brackets
    around a line, a header line without numbers, empty rows and lines that begin with ``#`` are
    passed over. The header may state the unit, as in
    "x [mm], y [mm]" or "x_mm;y_mm".

    The columns are those that the header calls x, y and z, else those side by side that hold
    numbers, but for a running number that is called so ("Nr", "point"). Of three the one that is
    constant is left out, so that two are left: the plane of the curve. Text is in UTF-8, in UTF-16
    with its mark, or in Windows' code page 1252.

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
        If the file is missing, empty, not text, a line is not two numbers, or it is not known which
        columns are meant; with the line.
    CurveError
        If there are fewer than two points.
    """
    where = str(path)
    try:
        text = _decoded(read_source(path, "file of points"))
    except InputError as error:
        raise error.located(f"{where}:") from None
    try:
        points, header, columns = _points(list(_rows(text)))
    except InputError as error:
        raise error.located(where) from None
    if len(points) < 2:
        raise CurveError(
            "too few points for a curve",
            where=where,
            got=str(len(points)),
            expected="at least 2, one a line",
            remedy="write x and y of each point in a line of its own",
        )
    if into is None:
        return points
    if unit is None and header is not None:
        named = [header.fields[each] for each in columns if each < len(header.fields)]
        unit = _header_unit(named, f"{where} line {header.number}")
    return points * conversion(unit or into, into)


def _decoded(data: bytes) -> str:
    """The text of a file, as programs for tables write it on any system."""
    wide = data.startswith((b"\xff\xfe", b"\xfe\xff"))
    tried = ["utf-16"] if wide else ["utf-8-sig", "cp1252"]
    for encoding in tried:
        try:
            text = data.decode(encoding)
        except ValueError:
            continue
        if "\0" not in text:
            return text
    raise InputError(
        "the file of points cannot be read",
        got="what is not text",
        expected="text in UTF-8",
        remedy="save the table as CSV UTF-8",
    )


def _rows(text: str) -> Iterator[_Row]:
    """Lines that hold something."""
    separator = None
    for number, line in enumerate(text.splitlines(), start=1):
        content = line.strip()
        if content[:1] in _OPENING and content[-1:] in _CLOSING:
            content = content[1:-1].strip()
        if number == 1 and (said := _SEPARATOR.fullmatch(content)):
            separator = said[1]
            continue
        if not content or content.startswith("#"):
            continue
        fields = _split(line.strip(" \r\n") if "\t" in line else content, separator)
        if any(fields):
            yield _Row(number, content, fields, [_number(field) for field in fields])


def _points(rows: list[_Row]) -> tuple[Array, _Row | None, list[int]]:
    """Points (N, 2) of a table, its header, and the columns that they were taken from."""
    header = rows.pop(0) if rows and not rows[0].has_numbers else None
    if not rows:
        return np.empty((0, 2)), header, []
    columns = _coordinates(header, rows[0])
    table = np.empty((len(rows), len(columns)))
    for row, numbers in zip(rows, table, strict=True):
        _require_width(row, header or rows[0])
        found = [row.values[each] if each < len(row.values) else None for each in columns]
        if None in found:
            raise row.fault("this line is not a point", "two numbers, x and y", _mended(row))
        numbers[:] = found
        if not np.isfinite(numbers).all():
            raise row.fault("this point is not finite", "numbers", NO_POINT)
    plane = _plane(table, rows[0])
    return table[:, plane], header, [columns[each] for each in plane]


def _mended(row: _Row) -> str:
    """What makes a line a point, or none that is read."""
    if any(each.isalpha() for each in row.content):
        return NO_POINT
    if _THOUSANDS.search(row.content):
        return UNGROUPED
    return SEMICOLONS if _DECIMAL_COMMA.search(row.content) else NO_POINT


def _require_width(row: _Row, first: _Row) -> None:
    """Refuse a line of more numbers than the first one has columns: commas may be decimal ones."""
    count, width = len(row.fields), len(first.fields)
    if count > width > 1 and "," in row.content and None not in row.values:
        many = "twice as many columns as" if count == 2 * width else "more columns than"
        raise row.fault(f"this line has {many} the first one", f"{width}", SEMICOLONS)


def _coordinates(header: _Row | None, first: _Row) -> list[int]:
    """Columns that hold coordinates, by their names or else by what the first row has there."""
    names = [] if header is None else [field.strip().lower() for field in header.fields]
    called = [
        (found[1], at) for at, name in enumerate(names) if (found := _COORDINATE.search(name))
    ]
    letters = {letter for letter, _ in called}
    if 1 < len(letters) == len(called):
        return [at for _, at in sorted(called)]
    begin = next((at for at, value in enumerate(first.values) if value is not None), 0)
    rest = takewhile(lambda at: first.values[at] is not None, range(begin, len(first.values)))
    numbers = list(rest)
    if len(numbers) > 2 and numbers[0] < len(names) and _RUNNING.match(names[numbers[0]]):
        del numbers[0]
    if len(numbers) > MOST_UNNAMED:
        commas = len(numbers) == 4 and "," in first.content and "." not in first.content
        remedy = SEMICOLONS if commas else TITLES
        raise first.fault(WHICH, f"at most {MOST_UNNAMED} columns of numbers", remedy)
    return numbers if len(numbers) > 1 else [0, 1]


def _plane(table: Array, first: _Row) -> list[int]:
    """The two columns of a table that a curve in a plane of coordinates varies in."""
    if table.shape[1] == 2:
        return [0, 1]
    spread = np.ptp(table / 2, axis=0)  # halves, which do not overflow
    varying = np.flatnonzero(spread > CONSTANT * spread.max()).tolist()
    if len(varying) > 2:
        raise first.fault(WHICH, "two columns, or of three one that is constant", TITLES)
    # A straight line along a coordinate has another beside it.
    return varying if len(varying) == 2 else [0, max([1, *varying])]


def _split(line: str, separator: str | None) -> list[str]:
    """The fields of a line. Of those with a comma between them only quoted ones have commas."""
    likely = (";", "\t") if ";" in line or "," not in line else ("\t", ",")
    for each in likely if separator is None else (separator,):
        if each in line:
            fields = line.split(each)
            if '"' in line:
                with suppress(csv.Error):
                    fields = next(csv.reader([line], delimiter=each, skipinitialspace=True))
            return [field.strip().strip('"') for field in fields]
    return line.split()


def _number(field: str) -> float | None:
    if field.count(",") == 1 and "." not in field:
        field = field.replace(",", ".")
    try:
        return float(field)
    except ValueError:
        return None


def _header_unit(fields: list[str], where: str) -> str | None:
    """The unit that the names of the two columns state; None if they state none."""
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
                remedy="name one of them, or give unit in the design file, which counts more",
            )
        found = bracket[1].strip() if bracket is not None else word[1] if word else ""
        if found in _NAMED:
            units[field] = _NAMED[found]
    if len(set(units.values())) > 1:
        raise InputError(
            "the columns have different units",
            where=where,
            got=" and ".join(fields)[:80],
            remedy="give both in one, or give unit in the design file, which counts more",
        )
    return next(iter(units.values()), None)
