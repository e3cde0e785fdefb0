"""The layout: the whole sheet on one page, or split into parts that are laid on sheets of stock."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import Any, Generic, Self, TypeVar

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.record import record
from orishell.document import Document
from orishell.numerics.arrays import Array, Integers
from orishell.workshop.assembly import laid_flat
from orishell.workshop.boards import (
    SIDES,
    Side,
    cut_of_sheet,
    has_membrane,
    has_sheet,
    seen_from_outside,
)
from orishell.workshop.cut_parts import CutPart, Joint, make_parts, named_sheet, whole_sheet
from orishell.workshop.fitting import CutSheet, OversizeError, find_too_large, find_turns
from orishell.workshop.nesting import nest_parts
from orishell.workshop.placing import Placement
from orishell.workshop.settings import Joint as JointKind
from orishell.workshop.settings import Workshop
from orishell.workshop.splitting import split_sheet
from orishell.workshop.tabs import choose_joint_width

KEPT = 4
"""Number of layouts that are kept: formats and the bill ask for the same one."""


T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class Known(Generic[T]):
    """A key of what is kept: equal to others with the same arrays."""

    digest: bytes
    content: T = field(compare=False)

    @classmethod
    def by(cls, arrays: Iterable[NDArray[Any]], content: T) -> Self:
        """The key of a ``content`` that is known by ``arrays``."""
        digest = hashlib.sha256()
        for array in arrays:
            digest.update(repr(array.shape).encode())
            digest.update(array.tobytes())
        return cls(digest.digest(), content)


@record
class Layout:
    """The parts of a sheet, and where they lie on the stock."""

    parts: tuple[CutPart, ...]  # the whole sheet, or its parts and then the strips
    # where each lies within the margins; None without stock
    placements: tuple[Placement, ...] | None
    joints: tuple[Joint, ...] = ()

    @property
    def sheets(self) -> int:
        """Number of sheets that are cut."""
        return 1 if self.placements is None else 1 + max(p.sheet for p in self.placements)


def lay_out(document: Document, workshop: Workshop) -> Layout:
    """Split the sheet as the stock asks for, and lay the parts on it: those of `laid_flat`.

    Parts that have neither sheet nor membrane are left out.
    """
    large = _sheet_too_large(document, workshop)
    if large is not None:
        raise large
    document = cut_of_sheet(document)
    workshop = on_its_roll(document, workshop)
    if workshop.stock is None:
        return Layout((whole_sheet(laid_flat(document)),), None)
    bare = replace(
        document, states=(), curves={}, surface=None, distances=None, report={}, measures=None
    )
    sheet = Known.by(_what_is_cut(document), bare)
    joint = workshop.joint, choose_joint_width(laid_flat(document), workshop)
    return _lay_on_stock(sheet, workshop.usable_stock, workshop.spacing, joint)


def on_its_roll(document: Document, workshop: Workshop) -> Workshop:
    """The settings by which the flat sheet is laid out: rolls are the stock of a membrane."""
    return workshop.for_membrane() if has_membrane(document) else workshop


def require_stock(document: Document, workshop: Workshop, *, final: bool = True) -> None:
    """Refuse stock and rolls that panels or boards do not fit, before any layout is made.

    final: Whether boards stay as large as they are. Else they refuse nothing by themselves.

    Raises OversizeError, of all that are too small, with sizes that would do.
    """
    sheet = _sheet_too_large(document, workshop)
    boards = _boards_too_large(document, workshop) if final or sheet is not None else None
    found = [each for each in (sheet, boards) if each is not None]
    if found:
        raise OversizeError.joined(found)


def _boards_too_large(document: Document, workshop: Workshop) -> OversizeError | None:
    """The refusal of stock that boards do not fit, where their panels do not say it already."""
    own_roll = on_its_roll(document, workshop) is not workshop
    # On a membrane of the same stock boards are no larger than their panels.
    on_membrane = all(map(has_sheet, document.parts)) and not own_roll
    if workshop.stock is None or document.boards is None or on_membrane:
        return None
    everything = laid_flat(document)
    outlines = np.concatenate([_board_outlines(everything, side) for side in SIDES])
    sheet = CutSheet.apart(outlines, *workshop.usable_stock)
    return find_too_large(everything, sheet, workshop.margin)


def _sheet_too_large(document: Document, workshop: Workshop) -> OversizeError | None:
    """The refusal of stock, or a roll, that panels of the flat sheet do not fit."""
    laid = on_its_roll(document, workshop)
    if laid.stock is None or not has_sheet(document):
        return None
    everything = laid_flat(cut_of_sheet(document))
    width, height = laid.usable_stock
    if len(find_turns(np.concatenate(whole_sheet(everything).outlines), width, height)):
        return None
    tabs = choose_joint_width(everything, workshop) if workshop.joint == "tabs" else 0.0
    key = "workshop.stock" if laid is workshop else "workshop.roll"
    sheet = CutSheet.of(everything, width, height, tabs)
    return find_too_large(everything, sheet, workshop.margin, key)


def _board_outlines(document: Document, side: Side) -> Array:
    """Outlines (F, K, 2) of the boards of a side; a point for a panel without one."""
    seen = seen_from_outside(document, side)
    outlines = np.zeros((len(document.mesh.faces), *seen.outlines.shape[1:]))
    outlines[seen.panels] = seen.outlines
    return outlines


def find_oversize(document: Document, workshop: Workshop) -> float:
    """How much larger than its stock, as a factor, a part is; 1 where all fit, with their tabs."""
    try:
        require_stock(document, workshop)
    except OversizeError as error:
        return error.factor
    return 1.0


def _what_is_cut(document: Document) -> Iterator[NDArray[Any]]:
    """Panels and creases of all parts, at their places."""
    for piece in document.parts:
        mesh = piece.mesh
        yield from (np.array(piece.grid_shape or ()), piece.require_flat(), mesh.faces)
        yield from (mesh.edges, mesh.edge_faces, mesh.crease)


@lru_cache(KEPT)
def _lay_on_stock(
    sheet: Known[Document],
    stock: tuple[float, float],
    spacing: float,
    joint: tuple[JointKind, float],
) -> Layout:
    """The layout with joints of a kind and a width; kept, because splitting takes long."""
    (width, height), (kind, joint_width) = stock, joint
    document = laid_flat(sheet.content)
    whole = named_sheet(document)
    points = np.concatenate(whole.outlines)
    turns = find_turns(points, width, height)
    if len(turns) and len(sheet.content.parts) == 1:
        turned = Placement(0, float(turns[0]), np.zeros(2))
        shift = -turned.move(points).min(axis=0)
        return Layout((whole,), (replace(turned, shift=shift),))
    allowance = joint_width if kind == "tabs" else 0.0
    split: list[Integers] = []
    first = 0
    for piece in sheet.content.parts:
        split += [first + panels for panels in split_sheet(piece, width, height, allowance)]
        first += len(piece.mesh.faces)
    parts, strips, joints = make_parts(document, split, kind, joint_width)
    outlines = [part.outlines[0] for part in (*parts, *strips)]
    return Layout((*parts, *strips), nest_parts(outlines, width, height, spacing), joints)
