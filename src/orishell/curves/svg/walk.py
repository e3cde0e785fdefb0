"""The shapes that an SVG file draws, where they are drawn."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from orishell.conventions.errors import InputError
from orishell.curves.pieces import Affine
from orishell.curves.svg.shapes import SHAPES, length_of
from orishell.curves.svg.tree import (
    IDENTITY,
    MAX_ELEMENTS,
    MILLIMETRES,
    NUMBER,
    PIXEL_MM,
    Element,
    View,
    fit_view_box,
    parse_length,
    parse_transform,
    parse_view_box,
)

MAX_USES = 20
"""How deep elements may be reused within each other."""
UNLINK = "turn symbols and clones into copies (Edit > Clone > Unlink Clone in Inkscape)"
SIDES = {"left": "0%", "top": "0%", "center": "50%", "right": "100%", "bottom": "100%"}
"""Words for places along the viewport."""
_PHYSICAL = re.compile(rf"{NUMBER}\s*(mm|cm|in|pt|pc|q)", re.IGNORECASE)
DRAWN = {*SHAPES, "g", "a", "svg", "switch", "use", "symbol"}


@dataclass(frozen=True, slots=True)
class Context:
    """What an element inherits."""

    affine: Affine  # From its user units to those of the result, y still downwards
    view: View  # What percentages refer to
    wanted: bool  # Whether it is drawn: it is chosen, or in what is chosen, and visible
    hidden: bool = False  # Whether it is not displayed
    unseen: bool = False  # Whether it is not visible; what is in it may be
    uses: int = 0  # How many elements ``use`` it is inside of
    parents: tuple[Element, ...] = ()  # What it is in, outermost first


class Walk:
    """Walks through a file's elements.

    Parameters
    ----------
    root
        The outermost element.
    chosen
        The ``id`` of the element whose shapes are wanted; None for all that are visible.
    most
        How many elements may be met, those that are reused every time;
        None for :data:`~orishell.curves.svg.tree.MAX_ELEMENTS`.
    """

    def __init__(self, root: Element, chosen: str | None, most: int | None = None) -> None:
        self.root = root
        self.chosen = chosen
        self.most = MAX_ELEMENTS if most is None else most
        self.visited = 0
        self.by_id: dict[str, Element] = {}
        for element in root.all():
            self.by_id.setdefault(element.attributes.get("id", ""), element)
        self.by_id.pop("", None)

    def shapes(self, *, whole: bool) -> Iterator[tuple[Element, Context]]:
        """Every shape with its place: in millimetres, or in user units of the viewBox if whole.

        Raises InputError: If the page, a transform or a size cannot be read.
        """
        try:
            page = _page(self.root, whole=whole)
        except InputError as error:
            raise error.located("<svg>") from None
        context = Context(*page, self.chosen is None, parents=(self.root,))
        context = self._inside(self.root, context)
        for child in self.root.children:
            yield from self._element(child, context)

    def _inside(self, element: Element, context: Context) -> Context:
        """The context, given the element's own visibility and whether it is chosen."""
        if element.attributes.get("id") == self.chosen is not None and not context.uses:
            return replace(context, wanted=True, hidden=False, unseen=False)
        if element.style("display") == "none":
            context = replace(context, hidden=True)
        visibility = element.style("visibility")
        if visibility not in {"", "inherit"}:
            context = replace(context, unseen=visibility != "visible")
        return context

    def _element(self, element: Element, context: Context) -> Iterator[tuple[Element, Context]]:
        self.visited += 1
        if self.visited > self.most:
            raise InputError(
                "elements are reused too often",
                expected=f"at most {self.most} in all",
                remedy=UNLINK,
            )
        inside = self._inside(element, context)
        seen = element.tag in DRAWN and (element.tag != "symbol" or context.uses > 0)
        if context.wanted and not seen:
            return  # definitions, clip paths, texts: drawn only if chosen, or used
        try:
            inside = self._placed(element, inside)
        except InputError as error:
            raise error.located(name_of(element)) from None
        drawn = inside.wanted and not inside.hidden
        if element.tag in SHAPES:
            if drawn and not inside.unseen:
                yield element, inside
        elif element.tag == "use":
            if drawn:
                yield from self._use(element, inside)
        else:
            inside = replace(inside, parents=(*inside.parents, element))
            for child in element.children:
                yield from self._element(child, inside)

    def _placed(self, element: Element, context: Context) -> Context:
        """The context inside an element that moves or scales its content."""
        if element.tag in SHAPES and not {"transform", "style"} & element.attributes.keys():
            return context
        if element.style("transform") != element.attributes.get("transform", "").strip():
            raise InputError(
                "transform in a style is not read",
                remedy='write it as an attribute of its own, transform="...", in a text editor',
            )
        affine = context.affine.after(_transform(element, context.view))
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

    def _use(self, element: Element, context: Context) -> Iterator[tuple[Element, Context]]:
        target = self.by_id.get(element.attributes.get("href", "").removeprefix("#"))
        if target is None:
            return
        if context.uses >= MAX_USES:
            raise InputError(
                "elements reuse each other without end",
                where=f"<use> of #{target.attributes['id']}",
                expected=f"at most {MAX_USES} levels",
                remedy=UNLINK,
            )
        if target.tag in {"symbol", "svg"}:  # its size is that of the use, if that has one
            own = {k: v for k, v in element.attributes.items() if k in {"width", "height"}}
            target = Element(target.tag, {**target.attributes, **own}, target.children)
        inside = replace(context, uses=context.uses + 1, parents=(*context.parents, element))
        yield from self._element(target, inside)


def _transform(element: Element, view: View) -> Affine:
    """The map that an element's transform asks for, about its origin."""
    affine = parse_transform(element.attributes.get("transform", ""))
    words = element.style("transform-origin").split()
    if affine is IDENTITY or not words:
        return affine
    box = element.style("transform-box")
    sides = View(1.0, 1.0) if box not in {"", "view-box"} else view
    x, y = (
        parse_length(SIDES.get(word, word), sides.along(axis))
        for word, axis in zip([*words, "center"], "xy", strict=False)
    )
    if sides is not view and (x or y):
        raise InputError(
            "this transform-box is not read",
            got=box[:40],
            expected="view-box, or none",
            remedy="apply the transform to the points of the path, and save it again",
        )
    there, back = (Affine.of(1, 0, 0, 1, sign * x, sign * y) for sign in (1, -1))
    return there.after(affine).after(back)


def name_of(element: Element) -> str:
    """What messages call an element."""
    name = element.attributes.get("id")
    return f'<{element.tag} id="{name[:60]}">' if name else f"<{element.tag}>"


def has_physical_size(root: Element) -> bool:
    """Whether the page has a width or height in a unit of length; pixels are none.

    root: The outermost element.
    """
    sides = (root.attributes.get(side, "").strip() for side in ("width", "height"))
    return any(_PHYSICAL.fullmatch(side) for side in sides)


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
        raise InputError(
            "the page has no size",
            where=name,
            got=text[:40],
            expected="a length above 0",
            remedy=f"give the page a {name} in the drawing program",
        )
    return size
