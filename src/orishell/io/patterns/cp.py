"""The lines of a crease pattern as ORIPA, Orihime and Oriedita save it (.cp): five numbers a line.

The kind of a line, then both ends: x and y of one, x and y of the other; y goes downwards.
"""

from __future__ import annotations

from math import isfinite
from pathlib import Path
from typing import Final

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.source_file import read_source_file
from orishell.io.patterns.line_styles import AUXILIARY
from orishell.io.patterns.lines import Lines
from orishell.io.patterns.strokes import Stroke, lines_of
from orishell.numerics.arrays import Array

MOST_BYTES = 200_000_000
KINDS: Final[dict[float, str]] = {0: AUXILIARY, 1: "B", 2: "M", 3: "V", 4: AUXILIARY}
"""Auxiliary lines are 0 in ORIPA and 4 in Oriedita."""
SAVE_AGAIN = "save it again as CP or FOLD, in ORIPA or Oriedita"


def read_cp_lines(path: Path) -> tuple[Lines, list[str]]:
    """What a file draws, without a unit, and what was assumed of it.

    Raises InputError: If a line is not five numbers, of which the first is a kind; with its number.
    """
    try:
        text = read_source_file(path, "file", MOST_BYTES).decode("utf-8-sig")
    except ValueError:
        raise InputError(
            "the file is not text", expected="five numbers a line", remedy=SAVE_AGAIN
        ) from None
    strokes = []
    for number, line in enumerate(text.splitlines(), start=1):
        words = line.split()
        if not words:
            continue
        name = f"line {number}"
        kind, ends = _numbers(words, name, line)
        letter = KINDS.get(kind)
        if letter is None:
            raise InputError(
                "this kind of line is not known",
                where=name,
                got=words[0][:20],
                expected="0 and 4 auxiliary, 1 border, 2 mountain, 3 valley",
            )
        strokes.append(Stroke(name, ends * [1.0, -1.0], letter))
    return lines_of(strokes, downwards=True)


def _numbers(words: list[str], name: str, line: str) -> tuple[float, Array]:
    """The kind of a line, and its ends (1, 2, 2)."""
    try:
        kind, *ends = map(float, words)
    except ValueError:
        ends = []
    if len(ends) != 4 or not all(map(isfinite, ends)):
        raise InputError(
            "this line is not one of a crease pattern",
            where=name,
            got=repr(line.strip()[:60]),
            expected="five numbers: kind, x and y of one end, x and y of the other",
            remedy=SAVE_AGAIN,
        )
    return kind, np.array(ends).reshape(1, 2, 2)
