"""What the elements of a drawing draw, as straight lines."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.curves.pieces import Arc, Piece
from orishell.io.patterns.line_styles import AUXILIARY
from orishell.io.patterns.lines import Lines
from orishell.motion.crease_pattern import SENSE
from orishell.numerics.arrays import Array

STRAIGHT = 1e-9
"""How far a Bezier curve may leave its chord and be a straight line, relative to its length."""


@record
class Stroke:
    """An element of a drawing."""

    name: str  # what messages call it
    ends: Array  # both ends (N, 2, 2) of its lines
    letter: str | None  # the letter that its look stands for; None if it stands for none
    angle: float = np.nan  # the fold angle that it asks for (radians); NaN if for none


def straight_ends(pieces: Sequence[Piece]) -> Array:
    """Both ends (N, 2, 2) of pieces that are straight lines; without sides of no length.

    Raises InputError: If one is not.
    """
    ends = []
    for piece in pieces:
        if isinstance(piece, Arc):
            raise _curved("an arc")
        if len(piece.control) > 2:
            points = piece.control[:, :2] / piece.control[:, 2:]
            way, apart = points[-1] - points[0], points - points[0]
            off = np.abs(apart[:, 0] * way[1] - apart[:, 1] * way[0])
            if not off.max() <= STRAIGHT * (way @ way):
                raise _curved(f"from ({points[0, 0]:.6g}, {points[0, 1]:.6g})")
        ends += [piece.control[0], piece.control[-1]]
    found = np.array(ends).reshape(-1, 2, 3)
    found = found[..., :2] / found[..., 2:]
    long = (found[:, 0] != found[:, 1]).any(axis=-1) | (len(pieces) == 1)
    return np.asarray(found[long])


def _curved(got: str) -> InputError:
    return InputError(
        "this line is curved",
        got=got,
        expected="straight creases and borders",
        remedy="draw it as straight lines, or remove it",
    )


def lines_of(strokes: list[Stroke], *, downwards: bool = False) -> tuple[Lines, list[str]]:
    """All lines of a drawing, and what was assumed of them, in sentences.

    Parameters
    ----------
    downwards
        Whether y goes downwards in the file.
    """
    auxiliary = sum(stroke.letter == AUXILIARY for stroke in strokes)
    strokes = [stroke for stroke in strokes if stroke.letter != AUXILIARY]
    count = np.array([len(stroke.ends) for stroke in strokes], dtype=np.int64)
    owners = np.repeat(np.arange(len(strokes)), count)
    letters = np.array([stroke.letter or "U" for stroke in strokes], dtype=np.str_)
    angles = np.array([stroke.angle for stroke in strokes], dtype=np.float64)
    if not np.isnan(angles).all():  # where some are half opaque the others are opaque: flat folded
        full = np.pi * np.array([SENSE.get(letter, np.nan) for letter in letters.tolist()])
        angles = np.where(np.isnan(angles), full, angles)
    ends = np.concatenate([np.zeros((0, 2, 2)), *(stroke.ends for stroke in strokes)])
    unknown = [stroke.name for stroke in strokes if stroke.letter is None]
    notes = []
    if unknown:
        notes.append(
            f"the look of {len(unknown)} of {len(strokes)} shapes has no known meaning, as of "
            f"{unknown[0]}: not assigned"
        )
    if auxiliary:
        notes.append(f"auxiliary lines are no creases: {auxiliary} left out")
    names = tuple(stroke.name for stroke in strokes)
    return Lines(ends, letters[owners], angles[owners], owners, names, downwards), notes
