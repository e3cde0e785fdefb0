"""One curve from an SVG file: what is drawn, where it is drawn, in a unit of length."""

from __future__ import annotations

import difflib
from pathlib import Path

import numpy as np

from orishell.conventions.errors import CurveError, InputError
from orishell.conventions.quantities import conversion
from orishell.curves.files import name_parts
from orishell.curves.joining import Chain, join_pieces
from orishell.curves.pieces import MAX_PIECES, Affine, Piece
from orishell.curves.svg.shapes import draw_shape
from orishell.curves.svg.styles import is_painted, read_styled
from orishell.curves.svg.tree import Element
from orishell.curves.svg.walk import DRAWN, Context, Walk, name_of
from orishell.numerics.arrays import Array

UPWARDS = Affine.of(1, 0, 0, -1, 0, 0)
LISTED = 8


def read_svg(path: Path, *, into: str, id: str | None = None, unit: str | None = None) -> Chain:  # noqa: A002 - as the attribute is called
    """The curve that an SVG file draws, y upwards.

    Lengths are those of the printed page: 96 pixels are an inch, unless the file's width and
    height say what its user units are. The origin is where the file's coordinates are 0: where a
    viewBox begins only moves the page.

    Parameters
    ----------
    into
        Unit of length of the result.
    id
        The shape that is read, or the group, whose shapes make one curve together. Otherwise
        everything that is visible: what has a stroke, or else what is filled.
    unit
        The unit that one user unit of the file's viewBox is, whatever its width says.

    Raises
    ------
    InputError
        If the file cannot be read, has no such element, or its shapes make no curve with two
        ends; with the file and the place.
    """
    where = str(path) if id is None else f"{path} #{id}"
    try:
        with np.errstate(over="ignore", invalid="ignore"):  # what overflows is refused when joined
            reader = _Reader(read_styled(path), id)
            pieces = reader.read(whole=unit is not None)
            try:
                chain = join_pieces(pieces, lambda point: _place(point, unit or "mm"))
            except CurveError as error:
                raise reader.naming(error) from None
    except InputError as error:
        raise error.located(f"{where}:") from None
    return chain.scaled(conversion(unit or "mm", into))


class _Reader:
    """Collects the pieces that a file's elements draw."""

    def __init__(self, root: Element, chosen: str | None) -> None:
        self.walk = Walk(root, chosen)
        self.pieces: list[Piece] = []
        # what messages call each element that draws, and which pieces belong to it
        self.drawn: list[tuple[str, slice]] = []

    def read(self, *, whole: bool) -> list[Piece]:
        """The pieces in millimetres, or in user units of the viewBox; y upwards."""
        if self.walk.chosen is not None and self.walk.chosen not in self.walk.by_id:
            raise self._unknown(self.walk.chosen)
        for element, context in self._seen(whole):
            try:
                self._draw(element, context)
            except InputError as error:
                raise error.located(name_of(element)) from None
        return [piece.transformed(UPWARDS) for piece in self.pieces]

    def _seen(self, whole: bool) -> list[tuple[Element, Context]]:
        """What is chosen; or else all with a stroke; if none has one, what is filled."""
        shapes = list(self.walk.shapes(whole=whole))
        if self.walk.chosen is not None:
            return shapes
        painted = (
            [
                (element, context)
                for element, context in shapes
                if is_painted(kind, (*context.parents, element))
            ]
            for kind in ("stroke", "fill")
        )
        return next(filter(None, painted), [])

    def naming(self, error: CurveError) -> CurveError:
        """The error about all pieces, with the elements they are of and the ids to choose from."""
        parts = [(name, self.pieces[which]) for name, which in self.drawn]
        shapes = [name for name, each in self.walk.by_id.items() if each.tag in DRAWN]
        return name_parts(
            error,
            parts,
            ((f'id = "{name}"', _pieces_of(self.walk.root, name)) for name in reversed(shapes)),
            "give the element that is meant an id in the drawing and choose it with id, or remove "
            "the others",
        )

    def _draw(self, element: Element, context: Context) -> None:
        drawn = draw_shape(element, context.view)
        self.pieces += [piece.transformed(context.affine) for piece in drawn]
        if drawn:
            last = len(self.pieces)
            self.drawn.append((name_of(element), slice(last - len(drawn), last)))
        if len(self.pieces) > MAX_PIECES:
            raise InputError("the drawing has too many pieces", expected=f"at most {MAX_PIECES}")

    def _unknown(self, wanted: str) -> InputError:
        known = list(self.walk.by_id)
        close = difflib.get_close_matches(wanted, known[:5000], n=LISTED, cutoff=0.4)
        shapes = [name for name in known if self.walk.by_id[name].tag in DRAWN]
        listed = close or shapes[:LISTED] or known[:LISTED]
        return InputError(
            "there is no element with this id",
            got=repr(wanted[:60]),
            expected="one of " + ", ".join(name[:60] for name in listed) if listed else "",
            remedy="" if listed else "leave id out: no element of the file has one",
        )


def _pieces_of(root: Element, name: str) -> list[Piece]:
    """What an element draws by itself; nothing where it cannot be read."""
    try:
        return _Reader(root, name).read(whole=True)
    except InputError:
        return []


def _place(point: Array, unit: str) -> str:
    """A point as the file has it, y downwards."""
    x, y = float(point[0]), 0.0 - float(point[1])
    return f"({x:.6g}, {y:.6g}) {unit}, y downwards"
