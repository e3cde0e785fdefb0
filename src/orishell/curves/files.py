"""Curves from files: points in a CSV."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from orishell.curves.jets import Array
from orishell.errors import CurveError, InputError

MAX_BYTES = 20_000_000


def read_points(path: Path) -> Array:
    """Points (N, 2) from the first two columns of a text file.

    Columns are separated by commas, semicolons, tabs or blanks. A header line without numbers,
    empty lines and lines that begin with ``#`` are passed over.

    Raises
    ------
    InputError
        If the file is missing, empty, not text, or a line is not two numbers; with the line.
    """
    where = str(path)
    try:
        if path.exists() and not path.is_file():
            raise InputError("this is not a file", where=where)
        if path.stat().st_size > MAX_BYTES:
            raise InputError(
                "the file of points is too large",
                where=where,
                expected=f"at most {MAX_BYTES} bytes",
            )
        text = path.read_text(encoding="utf-8-sig")
    except FileNotFoundError:
        raise InputError(
            "the file of points does not exist",
            where=where,
            remedy="the path is read relative to the design file",
        ) from None
    except (OSError, ValueError) as error:
        raise InputError("the file of points cannot be read", where=where, got=str(error)) from None

    points: list[tuple[float, float]] = []
    header_allowed = True
    for number, line in enumerate(text.splitlines(), start=1):
        content = line.strip()
        if not content or content.startswith("#"):
            continue
        fields = _split(content)
        try:
            pair = float(fields[0]), float(fields[1])
        except (ValueError, IndexError):
            if header_allowed and not any(_is_number(field) for field in fields):
                header_allowed = False
                continue
            raise InputError(
                "this line is not a point",
                where=f"{where} line {number}",
                got=repr(content[:60]),
                expected="two numbers, x and y",
            ) from None
        header_allowed = False
        if not np.isfinite(pair).all():
            raise InputError(
                "this point is not finite", where=f"{where} line {number}", got=repr(content[:60])
            )
        points.append(pair)
    if len(points) < 2:
        raise CurveError(
            "too few points for a curve",
            where=where,
            got=str(len(points)),
            expected="at least 2, one a line",
        )
    return np.array(points)


def _split(line: str) -> list[str]:
    for separator in (";", ",", "\t"):
        if separator in line:
            return [field.strip().strip('"') for field in line.split(separator)]
    return line.split()


def _is_number(field: str) -> bool:
    try:
        float(field)
    except ValueError:
        return False
    return True
