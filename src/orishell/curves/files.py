"""Curves in files, and messages about drawings that do not make one curve."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import islice
from pathlib import Path

from orishell.conventions.errors import CurveError, InputError
from orishell.conventions.source_file import read_source_file
from orishell.curves.joining import CHOOSE, Chain, join_pieces
from orishell.curves.pieces import Piece

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


def read_source(path: str | Path, kind: str, most: int = MAX_BYTES) -> bytes:
    """The bytes of a file that messages call ``kind``; an InputError does not name it."""
    try:
        path = Path(path)
    except TypeError as error:
        raise InputError(f"the {kind} cannot be read", got=str(error)) from None
    return read_source_file(path, kind, most, "the path is read relative to the design file")
