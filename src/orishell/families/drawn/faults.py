"""Where a drawn sheet does not fold, vertex by vertex, for pictures of it (not in the paper)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from orishell.conventions.errors import DesignError
from orishell.conventions.formatting import in_degrees
from orishell.families.drawn.conditions import Conditions
from orishell.families.drawn.sheet import drawn_sheet, vertices_amiss
from orishell.families.drawn.signs import ROUNDED
from orishell.motion.crease_pattern import Mark
from orishell.motion.drawing import Drawing
from orishell.motion.following.rigid import find_rigid

SEEN = 1e-6
"""Fold angles that disagree by less are not marked (radians)."""
MOST = 20
"""Of panels round which fold angles disagree so many are marked, those with most."""


def find_faults(drawing: Drawing) -> tuple[Mark, ...]:
    """Where a sheet does not fold, and why; those of the first kind that there are.

    Parameters
    ----------
    drawing
        The sheet.
    """
    for kind in (_of_letters(drawing), _of_sectors(drawing), _of_angles(drawing)):
        found = tuple(kind)
        if found:
            return found
    return ()


def _of_letters(drawing: Drawing) -> Iterator[Mark]:
    """Vertices whose mountains and valleys cannot be as they are; lines that fold in part."""
    signs, inner = drawing.signs, drawing.flat[1:-1, 1:-1]
    for line in (signs.row, signs.column.T):
        before, after = line[:, :-1], line[:, 1:]
        part = (before == 0) != (after == 0)
        part &= ~(np.isnan(before) | np.isnan(after))
        at = inner if line is signs.row else inner.swapaxes(0, 1)
        for x, y in at[part].tolist():
            yield Mark(x, y, "of two opposite creases one folds and one stays flat")
    for what, amiss in vertices_amiss(np.moveaxis(drawing.flat, -1, 0)[..., None], signs):
        for x, y in inner[amiss].tolist():
            yield Mark(x, y, what)


def _of_sectors(drawing: Drawing) -> Iterator[Mark]:
    """What single vertices prove not to fold."""
    pattern = drawing.pattern
    rigid = find_rigid(pattern, ROUNDED * pattern.diagonal / drawing.shortest)
    still = rigid.flat & (np.abs(pattern.signs) == 1)
    for x, y in pattern.vertices[pattern.edges[still]].mean(axis=1).tolist():
        yield Mark(x, y, "sectors beside this crease do not let it fold")
    for found, what in (
        (rigid.one_sided, "all creases have one letter, and one at least must have another"),
        (rigid.crossing, "two straight lines cross, and only one of them folds"),
        (rigid.against, "the letters do not let the creases fold together from flat"),
    ):
        for x, y in pattern.vertices[found].tolist():
            yield Mark(x, y, what)


def _of_angles(drawing: Drawing) -> Iterator[Mark]:
    """Panels round which fold angles disagree, the worst first."""
    signs = drawing.signs
    if np.isnan(signs.row).any() or np.isnan(signs.column).any():
        return
    try:
        drive = drawn_sheet(drawing.flat, signs, np.pi).drive
    except DesignError:
        return
    places = np.moveaxis(drawing.flat, -1, 0)
    own = places.swapaxes(1, 2)[::-1] if drive.across else places
    with np.errstate(all="ignore"):
        conditions = Conditions.of(own, drive)
        count = conditions.heights.size
        apart = np.abs(conditions.misses(own)[:count]).reshape(conditions.heights.shape)
    apart = np.where(np.isfinite(apart), apart, np.pi).max(axis=1)
    rows, columns = conditions.corners
    middles = own[:, 1 + rows, 1 + columns].mean(axis=(1, 2))
    x, y = middles[::-1] if drive.across else middles
    for panel in np.argsort(-apart, kind="stable")[:MOST].tolist():
        if apart[panel] > SEEN:
            size = in_degrees(float(apart[panel]))
            what = f"fold angles round this panel disagree by {size} degrees"
            yield Mark(float(x[panel]), float(y[panel]), what)
