"""What to say of a drawing that makes no one curve: what its parts are, and which of them do."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import islice

from orishell.conventions.errors import CurveError
from orishell.curves.joining import CHOOSE, Chain, join_pieces
from orishell.curves.pieces import Piece

LISTED = 6
"""Parts and choices that a message names; of more it says how many."""
TRIED = 40
"""Choices that are tried at most."""


def name_parts(
    error: CurveError,
    parts: Sequence[tuple[str, Sequence[Piece]]],
    choices: Iterable[tuple[str, Sequence[Piece]]],
    otherwise: str,
) -> CurveError:
    """Say in an error which part of the drawing is what, and by which choice one makes a curve.

    Parameters
    ----------
    error
        Why all that is drawn makes no curve.
    parts
        What is drawn: names of elements, and the pieces of each.
    choices
        What may be written in the design file, and the pieces that it leaves; they are tried, and
        of those that leave the same the first is named.
    otherwise
        What to do if none of them leaves a curve.
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
