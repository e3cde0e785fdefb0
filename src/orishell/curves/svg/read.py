"""One curve from an SVG file: what is drawn, where it is drawn, in a unit of length."""

from __future__ import annotations

import difflib
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from orishell.conventions.errors import CurveError, InputError
from orishell.conventions.quantities import conversion
from orishell.curves.files import name_parts
from orishell.curves.joining import Chain, join_pieces
from orishell.curves.pieces import MAX_PIECES, Affine, Piece
from orishell.curves.svg.shapes import SHAPES, draw_shape, length_of
from orishell.curves.svg.tree import (
    IDENTITY,
    MAX_ELEMENTS,
    MILLIMETRES,
    PIXEL_MM,
    Element,
    View,
    fit_view_box,
    parse_length,
    parse_transform,
    parse_view_box,
    read_tree,
)
from orishell.numerics.arrays import Array

UPWARDS = Affine.of(1, 0, 0, -1, 0, 0)
MAX_USES = 20
"""How deep elements may be reused within each other."""
DRAWN = {*SHAPES, "g", "a", "svg", "switch", "use", "symbol"}
LISTED = 8


@dataclass(frozen=True, slots=True)
class _Context:
    """What an element inherits."""

    affine: Affine  # From its user units to those of the result, y still downwards
    view: View  # What percentages refer to
    wanted: bool  # Whether it is drawn: it is chosen, or in what is chosen, and visible
    hidden: bool = False  # Whether it is not visible
    uses: int = 0  # How many elements ``use`` it is inside of


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
        everything that is drawn and visible.
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
            reader = _Reader(read_tree(path), id)
            pieces = reader.read(whole=unit is not None)
            try:
                chain = join_pieces(pieces, lambda point: _place(point, unit or "mm"))
            except CurveError as error:
                raise reader.naming(error) from None
    except InputError as error:
        raise error.located(f"{where}:") from None
    return chain.scaled(conversion(unit or "mm", into))


class _Reader:
    """Walks through a file's elements and collects pieces."""

    def __init__(self, root: Element, chosen: str | None) -> None:
        self.root = root
        self.chosen = chosen
        self.by_id: dict[str, Element] = {}
        self.pieces: list[Piece] = []
        # what messages call each element that draws, and which pieces belong to it
        self.drawn: list[tuple[str, slice]] = []
        self.visited = 0
        stack = [root]
        while stack:
            element = stack.pop()
            self.by_id.setdefault(element.attributes.get("id", ""), element)
            stack += element.children[::-1]
        self.by_id.pop("", None)

    def read(self, *, whole: bool) -> list[Piece]:
        """The pieces in millimetres, or in user units of the viewBox; y upwards."""
        if self.chosen is not None and self.chosen not in self.by_id:
            raise self._unknown(self.chosen)
        try:
            page = _page(self.root, whole=whole)
        except InputError as error:
            raise error.located("<svg>") from None
        context = _Context(*page, self.chosen is None)
        context = self._inside(self.root, context)
        for child in self.root.children:
            self._element(child, context)
        return [piece.transformed(UPWARDS) for piece in self.pieces]

    def naming(self, error: CurveError) -> CurveError:
        """The error about all pieces, with the elements they are of and the ids to choose from."""
        parts = [(name, self.pieces[which]) for name, which in self.drawn]
        shapes = [name for name, each in self.by_id.items() if each.tag in DRAWN]
        return name_parts(
            error,
            parts,
            ((f'id = "{name}"', _pieces_of(self.root, name)) for name in reversed(shapes)),
            "give the element that is meant an id in the drawing and choose it with id, or remove "
            "the others",
        )

    def _inside(self, element: Element, context: _Context) -> _Context:
        """The context, given the element's own visibility and whether it is chosen."""
        if element.attributes.get("id") == self.chosen is not None and not context.uses:
            return replace(context, wanted=True, hidden=False)
        visibility = element.style("visibility")
        hidden = context.hidden or element.style("display") == "none"
        return replace(context, hidden=hidden or visibility in {"hidden", "collapse"})

    def _element(self, element: Element, context: _Context) -> None:
        self.visited += 1
        if self.visited > MAX_ELEMENTS:
            raise InputError(
                "elements are reused too often", expected=f"at most {MAX_ELEMENTS} in all"
            )
        inside = self._inside(element, context)
        seen = element.tag in DRAWN and (element.tag != "symbol" or context.uses > 0)
        if context.wanted and not seen:
            return  # definitions, clip paths, texts: drawn only if chosen, or used
        try:
            inside = self._placed(element, inside)
            if inside.wanted and not inside.hidden:
                self._draw(element, inside)
        except InputError as error:
            error.located(_name_of(element))
            raise
        if element.tag == "use":
            if inside.wanted and not inside.hidden:
                self._use(element, inside)
        else:
            for child in element.children:
                self._element(child, inside)

    def _placed(self, element: Element, context: _Context) -> _Context:
        """The context inside an element that moves or scales its content."""
        if element.style("transform") != element.attributes.get("transform", "").strip():
            raise InputError(
                "transform in a style is not read", remedy="write it as an attribute of its own"
            )
        affine = context.affine.after(parse_transform(element.attributes.get("transform", "")))
        if element.tag == "use":
            x, y = (length_of(element, axis, context.view, axis) for axis in "xy")
            return replace(context, affine=affine.after(Affine.of(1, 0, 0, 1, x, y)))
        if element.tag not in {"svg", "symbol"}:
            return replace(context, affine=affine)
        view = context.view
        x, y = (length_of(element, axis, view, axis) for axis in "xy")
        width = length_of(element, "width", view, "x", "100%")
        height = length_of(element, "height", view, "y", "100%")
        affine = affine.after(Affine.of(1, 0, 0, 1, x, y))
        box = parse_view_box(element.attributes.get("viewBox", ""))
        if box is None:
            return replace(context, affine=affine, view=View(width, height))
        fit = fit_view_box(box, width, height, element.attributes.get("preserveAspectRatio", ""))
        return replace(context, affine=affine.after(fit), view=View(*box[2:]))

    def _draw(self, element: Element, context: _Context) -> None:
        drawn = draw_shape(element, context.view)
        self.pieces += [piece.transformed(context.affine) for piece in drawn]
        if drawn:
            last = len(self.pieces)
            self.drawn.append((_name_of(element), slice(last - len(drawn), last)))
        if len(self.pieces) > MAX_PIECES:
            raise InputError("the drawing has too many pieces", expected=f"at most {MAX_PIECES}")

    def _use(self, element: Element, context: _Context) -> None:
        target = self.by_id.get(element.attributes.get("href", "").removeprefix("#"))
        if target is None:
            return
        if context.uses >= MAX_USES:
            raise InputError(
                "elements reuse each other without end",
                where=f"<use> of #{target.attributes['id']}",
                expected=f"at most {MAX_USES} levels",
            )
        if target.tag in {"symbol", "svg"}:  # its size is that of the use, if that has one
            own = {k: v for k, v in element.attributes.items() if k in {"width", "height"}}
            target = Element(target.tag, {**target.attributes, **own}, target.children)
        self._element(target, replace(context, uses=context.uses + 1))

    def _unknown(self, wanted: str) -> InputError:
        known = list(self.by_id)
        close = difflib.get_close_matches(wanted, known[:5000], n=LISTED, cutoff=0.4)
        shapes = [name for name in known if self.by_id[name].tag in DRAWN]
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


def _name_of(element: Element) -> str:
    name = element.attributes.get("id")
    return f'<{element.tag} id="{name[:60]}">' if name else f"<{element.tag}>"


def _page(root: Element, *, whole: bool) -> tuple[Affine, View]:
    """From the outermost user units to millimetres (or to user units), and the viewport."""
    box = parse_view_box(root.attributes.get("viewBox", ""))
    if whole:
        return IDENTITY, View(*(box[2:] if box else (0.0, 0.0)))
    width, height = (_size(root, name) for name in ("width", "height"))
    if box is None:
        return (
            Affine.of(PIXEL_MM, 0, 0, PIXEL_MM, 0, 0),
            View((width or 0.0) / PIXEL_MM, (height or 0.0) / PIXEL_MM),
        )
    if width is None:
        width = box[2] * PIXEL_MM if height is None else height * box[2] / box[3]
    if height is None:
        height = width * box[3] / box[2]
    fit = fit_view_box(box, width, height, root.attributes.get("preserveAspectRatio", ""))
    return Affine(fit.matrix, np.zeros(2)), View(*box[2:])


def _size(root: Element, name: str) -> float | None:
    """The page's width or height in millimetres; None if the file leaves it open."""
    text = root.attributes.get(name, "").strip()
    if text.endswith("%") or text in {"", "auto"}:
        return None
    size = parse_length(text, 0.0, MILLIMETRES)
    if not size > 0:
        raise InputError("the page has no size", where=name, got=text[:40])
    return size


def _place(point: Array, unit: str) -> str:
    """A point as the file has it, y downwards."""
    x, y = float(point[0]), 0.0 - float(point[1])
    return f"({x:.6g}, {y:.6g}) {unit}, y downwards"
