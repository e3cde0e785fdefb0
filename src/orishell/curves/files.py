"""Curves in files, and messages about drawings that do not make one curve."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import islice
from pathlib import Path
from typing import Final

from orishell.conventions.errors import CurveError, InputError
from orishell.conventions.source_file import read_source_file
from orishell.curves.ends import CHOOSE
from orishell.curves.joining import Chain, join_pieces
from orishell.curves.pieces import Piece

LISTED, TRIED = 6, 40
"""Parts and choices that a message names at most, and choices that are tried."""


def name_parts(
    error: CurveError,
    parts: Sequence[tuple[str, Sequence[Piece]]],
    choices: Iterable[tuple[str, Sequence[Piece]]],
    *,
    otherwise: str,
    alone: str,
    join: float | None,
) -> CurveError:
    """Add to an error the parts of the drawing, and the choices that leave one curve.

    ``parts`` are names of elements with their pieces; ``choices`` are lines of the design file with
    the pieces that they leave, and of those that leave the same the first is named. ``otherwise``
    is the remedy if none leaves a curve, ``alone`` that of a drawing of one element. ``join`` is
    how far apart loose ends may be.
    """
    if len(parts) < 2:
        error.remedy = error.remedy.replace(CHOOSE, alone)
        return error.located(parts[0][0]) if parts else error
    more = f" and {len(parts) - LISTED} more" if len(parts) > LISTED else ""
    named = ", ".join(f"{name} ({_shape(pieces, join)})" for name, pieces in parts[:LISTED]) + more
    error.got = f"{error.got}, drawn by {named}" if error.got else named
    found: dict[bytes, str] = {}
    for choice, pieces in islice(choices, TRIED):
        chain = _chain(pieces, join)
        if not isinstance(chain, CurveError):
            found.setdefault(chain.joints.tobytes(), choice)
    chosen = " or ".join(list(found.values())[:LISTED])
    choose = f"choose the curve with {chosen}" if chosen else otherwise
    if CHOOSE in error.remedy:
        error.remedy = error.remedy.replace(CHOOSE, choose)
    elif chosen:
        error.remedy = f"{error.remedy}, or {choose}"
    return error


def _chain(pieces: Sequence[Piece], join: float | None) -> Chain | CurveError:
    try:
        return join_pieces(pieces, lambda _: "", join)
    except CurveError as error:
        return error


def _shape(pieces: Sequence[Piece], join: float | None) -> str:
    chain = _chain(pieces, join)
    if isinstance(chain, CurveError):
        return chain.what.removeprefix("the curve ").removeprefix("is ")
    return "a curve with two ends"


MAX_BYTES = 20_000_000
BEGINNINGS: Final = {
    b"{": "FOLD",
    b"<": "SVG",
    b"0\n": "DXF",
    b"0\r": "DXF",
    b"999": "DXF",
    b"AutoCAD Binary DXF": "DXF",
    b"AC10": "DWG",
    b"%PDF": "PDF",
    b"%!PS": "PostScript",
    b"3D Geometry": "3DM",
    b"\x89PNG": "PNG",
    b"\xff\xd8": "JPEG",
    b"\x1f\x8b": "gzip",
    b"PK": "ZIP",
}
"""How files begin, leading blanks aside."""
KEYS: Final = {"SVG": "svg", "DXF": "dxf"}
"""Keys of the design file for curves of a kind."""


def kind_of(content: bytes) -> str:
    """What a file seems to be by how it begins; empty if that is not known."""
    begin = content[:1000].removeprefix(b"\xef\xbb\xbf").lstrip()
    return next((name for start, name in BEGINNINGS.items() if begin.startswith(start)), "")


def require_kind(content: bytes, wanted: str) -> None:
    """Refuse a file that begins as those of another kind than the one that is wanted."""
    kind = kind_of(content)
    if kind in {"", wanted}:
        return
    remedy = f"save it as {wanted} in the program that it was drawn in"
    if kind in KEYS:
        remedy = f'give it as {KEYS[kind]} = "..." in place of {KEYS[wanted]}'
    raise InputError(f"this is {kind}, not {wanted}", remedy=remedy)


def read_source(path: str | Path, kind: str, most: int = MAX_BYTES) -> bytes:
    """The bytes of a file that messages call ``kind``; an InputError does not name it."""
    try:
        path = Path(path)
    except TypeError as error:
        raise InputError(f"the {kind} cannot be read", got=str(error)) from None
    return read_source_file(path, kind, most, "the path is read relative to the design file")
