"""The layout: the whole sheet on one page, or its parts on sheets of stock.

A sheet larger than the stock is split into parts (:mod:`~orishell.workshop.splitting`), which get
tabs or strips (:mod:`~orishell.workshop.cut_parts`) and are laid on the stock
(:mod:`~orishell.workshop.nesting`).
"""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, field, replace
from functools import lru_cache

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.document import Document
from orishell.numerics.arrays import Array, Integers
from orishell.workshop.assembly import with_clipped
from orishell.workshop.boards import has_sheet, seen_from_outside
from orishell.workshop.cut_parts import CutPart, Joint, make_parts, whole_sheet
from orishell.workshop.fitting import CutSheet, OversizeError, find_turns, require_panels_fit
from orishell.workshop.nesting import nest_parts
from orishell.workshop.placing import Placement
from orishell.workshop.settings import Workshop
from orishell.workshop.splitting import split_sheet
from orishell.workshop.tabs import choose_joint_width

KEPT = 4
"""Number of layouts that are kept: formats and quantities ask for the same one."""


@record
class Layout:
    """The parts of a sheet, and where they lie on the stock.

    parts: The whole sheet, or its parts and then the strips.
    placements: Where each lies within the margins; None without stock.
    joints: How parts are joined.
    """

    parts: tuple[CutPart, ...]
    placements: tuple[Placement, ...] | None
    joints: tuple[Joint, ...] = ()

    @property
    def sheets(self) -> int:
        """Number of sheets that are cut."""
        return 1 if self.placements is None else 1 + max(p.sheet for p in self.placements)


def lay_out(document: Document, workshop: Workshop) -> Layout:
    """Split the sheet as the stock asks for, and lay the parts on it.

    Splitting takes long. The last layouts are kept: who asks for the same flat sheet on the same
    stock again, whatever its states are, gets the same one. The numbers of panels and creases are
    those of :func:`~orishell.workshop.assembly.with_clipped`.

    Raises InputError if there is no flat sheet, or a panel does not fit the stock.
    """
    if workshop.stock is None:
        return Layout((whole_sheet(with_clipped(document)),), None)
    asked = Workshop(
        stock=workshop.stock,
        margin=workshop.margin,
        spacing=workshop.spacing,
        joint=workshop.joint,
        joint_width=workshop.joint_width,
    )
    return _lay_on_stock(_FlatSheet.of(document), asked)


def require_stock(document: Document, workshop: Workshop) -> None:
    """Refuse stock that a panel does not fit, before any layout is made.

    Raises InputError: As :func:`lay_out` does.
    """
    width, height = usable_stock(workshop)
    everything = with_clipped(document)
    if not has_sheet(document):
        require_panels_fit(everything, CutSheet.apart(_solid_outlines(everything), width, height))
    elif not len(find_turns(np.concatenate(whole_sheet(everything).outlines), width, height)):
        tabs = choose_joint_width(everything, workshop) if workshop.joint == "tabs" else 0.0
        require_panels_fit(everything, CutSheet.of(everything, width, height, tabs))


def _solid_outlines(document: Document) -> Array:
    """Outlines (F, K, 2) of solid panels; a panel without one has its own corners."""
    seen = seen_from_outside(document, 0)
    corners = document.require_flat()[document.mesh.faces]
    outlines = np.pad(corners, ((0, 0), (0, seen.outlines.shape[1] - 4), (0, 0)), mode="edge")
    outlines[seen.panels] = seen.outlines
    return outlines


def find_oversize(document: Document, workshop: Workshop) -> float:
    """How much larger than the stock, as a factor, a panel is; 1 where all fit, with their tabs.

    Raises InputError if the margins leave nothing of the stock.
    """
    try:
        require_stock(document, workshop)
    except OversizeError as error:
        return error.factor
    return 1.0


@dataclass(frozen=True, slots=True)
class _FlatSheet:
    """A flat sheet, equal to another with the same panels and creases at the same places."""

    digest: bytes
    document: Document = field(compare=False)

    @classmethod
    def of(cls, document: Document) -> _FlatSheet:
        flat, mesh = document.require_flat(), document.mesh
        digest = hashlib.sha256(repr((document.grid_shape, len(flat), mesh.faces.shape)).encode())
        for array in (flat, mesh.faces, mesh.edges, mesh.edge_faces, mesh.crease):
            digest.update(array.tobytes())
        for board in document.clipped:
            digest.update(cls.of(board).digest)
        bare = replace(document, states=(), curves={}, surface=None, distances=None, report={})
        return cls(digest.digest(), bare)


@lru_cache(KEPT)
def _lay_on_stock(sheet: _FlatSheet, workshop: Workshop) -> Layout:
    document = with_clipped(sheet.document)
    whole = whole_sheet(document)
    width, height = usable_stock(workshop)
    points = np.concatenate(whole.outlines)
    turns = find_turns(points, width, height)
    if len(turns) and not sheet.document.clipped:
        turned = Placement(0, float(turns[0]), np.zeros(2))
        shift = -turned.move(points).min(axis=0)
        return Layout((whole,), (replace(turned, shift=shift),))
    joint = choose_joint_width(document, workshop)
    allowance = joint if workshop.joint == "tabs" else 0.0
    split: list[Integers] = []
    first = 0
    for piece in (sheet.document, *sheet.document.clipped):
        split += [first + panels for panels in split_sheet(piece, width, height, allowance)]
        first += len(piece.mesh.faces)
    parts, strips, joints = make_parts(document, split, workshop.joint, joint)
    outlines = [part.outlines[0] for part in (*parts, *strips)]
    return Layout((*parts, *strips), nest_parts(outlines, width, height, workshop.spacing), joints)


def usable_stock(workshop: Workshop) -> tuple[float, float]:
    """Width and height of the stock without its margins.

    Raises InputError if the margins leave nothing.
    """
    if workshop.stock is None:
        raise AssertionError("only stock has a margin")
    width, height = (side - 2 * workshop.margin for side in workshop.stock)
    if min(width, height) <= 0:
        raise InputError(
            "the margins leave nothing of the stock",
            keys=("workshop.margin",),
            got=f"{workshop.margin:g}",
            expected=f"less than {min(workshop.stock) / 2:g}",
        )
    return width, height
