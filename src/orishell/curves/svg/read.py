"""One curve from an SVG file: what is drawn, where it is drawn, in a unit of length."""

from __future__ import annotations

import difflib
from dataclasses import replace
from itertools import islice
from pathlib import Path

import numpy as np

from orishell.conventions.errors import CurveError, InputError
from orishell.conventions.quantities import conversion
from orishell.curves.files import TRIED, name_parts
from orishell.curves.joining import Chain, join_pieces
from orishell.curves.pieces import MAX_PIECES, SIMPLIFY, Affine, Piece
from orishell.curves.svg.parsed import SAVE_AGAIN
from orishell.curves.svg.shapes import SHAPES, draw_shape
from orishell.curves.svg.styles import is_painted, read_styled
from orishell.curves.svg.tree import Element
from orishell.curves.svg.walk import DRAWN, Context, Walk, has_physical_size, name_of
from orishell.numerics.arrays import Array

PIXELS = (
    "the page has no size in millimetres or inches: 96 of its units were read as an inch "
    "(Illustrator means 72: scale = 1.33333)"
)
NAMED = "its name in Illustrator, Affinity and Figma, its object properties in Inkscape"
APART = "Path > Break Apart in Inkscape, Object > Compound Path > Release in Illustrator"
UPWARDS = Affine.of(1, 0, 0, -1, 0, 0)
LISTED = 8


def read_svg(
    path: Path,
    *,
    into: str,
    id: str | None = None,  # noqa: A002 - as the attribute is called
    unit: str | None = None,
    join: float | None = None,
) -> Chain:
    """The curve that an SVG file draws, y upwards.

    Lengths are those of the printed page: 96 pixels are an inch, unless the file's width and
    height say what its user units are; where they do not, its notes say so. The origin is where
    the file's coordinates are 0: where a viewBox begins only moves the page.

    Parameters
    ----------
    into
        Unit of length of the result.
    id
        The shape that is read, or the group, whose shapes make one curve together. Otherwise
        everything that is visible: what has a stroke, or else what is filled.
    unit
        The unit that one user unit of the file's viewBox is, whatever its width says.
    join
        How far apart loose ends may be, in ``unit``, else in millimetres.

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
            said = unit or "mm"
            try:
                chain = join_pieces(pieces, lambda point: _place(point, said), join, said)
            except CurveError as error:
                raise reader.naming(error, join) from None
    except InputError as error:
        raise error.located(f"{where}:") from None
    if unit is None and not has_physical_size(reader.walk.root):
        chain = replace(chain, notes=(PIXELS, *chain.notes))
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
        pieces = self.drawn_pieces(whole=whole)
        if not pieces:
            raise self._nothing()
        return pieces

    def drawn_pieces(self, *, whole: bool) -> list[Piece]:
        """The pieces in millimetres, or in user units of the viewBox; none if nothing is drawn."""
        try:
            for element, context in self._seen(whole):
                try:
                    self._draw(element, context)
                except InputError as error:
                    raise error.located(name_of(element)) from None
        except InputError as error:
            error.remedy = error.remedy or SAVE_AGAIN
            raise
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

    def naming(self, error: CurveError, join: float | None) -> CurveError:
        """The error about all pieces, with the elements they are of and the ids to choose from."""
        parts = [(name, self.pieces[which]) for name, which in self.drawn]
        shapes = [name for name, each in self.walk.by_id.items() if each.tag in DRAWN]
        return name_parts(
            error,
            parts,
            ((f'id = "{name}"', _pieces_of(self.walk.root, name)) for name in reversed(shapes)),
            otherwise=f"give the element that is meant an id ({NAMED}) and choose it with id, or "
            "remove the others",
            alone=f"break it apart ({APART}) and choose the part that is meant with its id",
            join=join,
        )

    def _draw(self, element: Element, context: Context) -> None:
        drawn = draw_shape(element, context.view)
        self.pieces += [piece.transformed(context.affine) for piece in drawn]
        if drawn:
            last = len(self.pieces)
            self.drawn.append((name_of(element), slice(last - len(drawn), last)))
        if len(self.pieces) > MAX_PIECES:
            raise InputError(
                "the drawing has too many pieces", expected=f"at most {MAX_PIECES}", remedy=SIMPLIFY
            )

    def _nothing(self) -> InputError:
        """What there is where no shape is seen, or chosen."""
        root, chosen = self.walk.root, self.walk.chosen
        shapes = sum(each.tag in SHAPES for each in root.all())
        images = sum(each.tag == "image" for each in root.all())
        got, remedy = "", "draw a line, an arc or a path"
        if shapes:
            names = (name for name, each in self.walk.by_id.items() if each.tag in DRAWN)
            drawing = (name for name in islice(names, TRIED) if _pieces_of(root, name))
            ids = " or ".join(f'id = "{name}"' for name in islice(drawing, LISTED))
            got = f"shapes that are not seen: {shapes}"
            remedy = f"choose one with {ids}" if ids else "show them, or give them a stroke"
        elif images:
            got = f"images: {images}"
            remedy = "trace the image (Path > Trace Bitmap in Inkscape, Image Trace in Illustrator)"
        return InputError(
            "nothing is drawn here",
            got=got if chosen is None else name_of(self.walk.by_id[chosen]),
            expected="lines, paths, polylines, rectangles or ellipses",
            remedy=remedy,
        )

    def _unknown(self, wanted: str) -> InputError:
        known = list(self.walk.by_id)
        close = difflib.get_close_matches(wanted, known[:5000], n=LISTED, cutoff=0.4)
        shapes = [name for name in known if self.walk.by_id[name].tag in DRAWN]
        listed = close or shapes[:LISTED] or known[:LISTED]
        return InputError(
            "there is no element with this id",
            got=repr(wanted[:60]),
            expected="one of " + ", ".join(name[:60] for name in listed) if listed else "",
            remedy="choose one of these, or leave id out"
            if listed
            else "leave id out: no element of the file has one",
        )


def _pieces_of(root: Element, name: str) -> list[Piece]:
    """What an element draws by itself; nothing where it cannot be read."""
    try:
        return _Reader(root, name).drawn_pieces(whole=True)
    except InputError:
        return []


def _place(point: Array, unit: str) -> str:
    """A point as the file has it, y downwards."""
    x, y = float(point[0]), 0.0 - float(point[1])
    return f"({x:.15g}, {y:.15g}) {unit}, y downwards"
