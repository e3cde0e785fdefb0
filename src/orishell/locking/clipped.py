"""Curves that cross themselves: their shells run through themselves, however they fold.

They are no part of the folding sheet, so they are looked at in the one state in which they are
there. Panels without a thickness may touch in it, as those of flaps that fold flat do, but not pass
through each other. Boards are apart, but for those about a common crease, which meet there.

Limit: clipped flaps, and their boards, are examined at the target only. How they are brought to
their place is not.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import product

import numpy as np

from orishell.clash import PathContact, find_contacts, overlap_depths
from orishell.clash.bodies import opposite_panels
from orishell.clash.broad_phase import selected
from orishell.clash.state import deepest_contact
from orishell.conventions.errors import ClashError, DesignError, Remedy
from orishell.design import Design
from orishell.locking.boards import Corners, Met, cut_corners
from orishell.locking.result import Contact
from orishell.locking.sheet import Sheet
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.convex import require_convex
from orishell.numerics.equals import first_largest
from orishell.solids import BuiltPanels, settled_vertices


def require_uncrossed(design: Design) -> None:
    """Refuse a shell that runs through itself at its target because f does.

    Columns are affine images of f's staircase, so one of them shows it. It is seen here at once,
    where looking for the first contact on the way takes long: all over the sheet panels meet.

    Raises DesignError if a column crosses itself.
    """
    import shapely

    if "f" not in design.targets:
        return
    mechanism = design.mechanism
    column = mechanism.positions(mechanism.target_drive)[:, mechanism.inner_columns.start]
    centred = column - column.mean(axis=0)
    flat = centred @ np.linalg.svd(centred, full_matrices=False)[2][:2].T
    pieces = np.asarray(shapely.linestrings(np.stack([flat[:-1], flat[1:]], axis=1)))
    first, second = shapely.STRtree(pieces).query(pieces, predicate="crosses")
    if not len(first):
        return
    one = int(first.argmin())
    rows = [sorted(pair) for pair in zip(first.tolist(), second.tolist(), strict=True)]
    above, below = rows[one]
    places = len({tuple(pair) for pair in rows})
    raise DesignError(
        "f crosses itself, so that the shell would run through itself",
        place=f"panels of row {above} pass through those of row {below}",
        size=f"it does so in {places} place{'s' * (places > 1)}",
    )


SIDES = ("start", "end")
"""Where the flaps on the left and on the right may fold to."""


def find_crossing(sheet: Sheet, tolerance: float) -> Contact | None:
    """Return the panels, one of a flap, that pass farthest through each other at the target.

    sheet: The sheet with its flaps.
    tolerance: By so much panels may reach into each other, as they may come near each other
        (length).

    Raises DesignError if a panel is concave.
    """
    require_convex(sheet.mechanism, "clipped flaps")
    faces, points = sheet.layout.faces, sheet.points_at_target()
    pairs = find_contacts(points, faces, tolerance)
    pairs = pairs[sheet.flapped((pairs[:, 0], pairs[:, 1]))]
    depths = overlap_depths(points, faces, pairs)
    if not (depths > tolerance).any():
        return None
    deepest = first_largest(depths)
    first, second = pairs[deepest].tolist()
    found = sheet.contact(PathContact(sheet.target, sheet.target, (first, second)))
    return replace(found, overlap=float(depths[deepest]))


def clip_boards(
    design: Design, sheet: Sheet, built: BuiltPanels, tolerance: float
) -> tuple[BuiltPanels, Contact | None]:
    """Return boards, their corners cut off so that those of flaps are apart, and what still meets.

    sheet: The sheet with its flaps.
    built: Its boards, those of the sheet proved to be apart: smaller ones are, too.
    tolerance: Distance at which boards touch (length).
    """
    mechanism, layout = sheet.mechanism, sheet.layout
    settled = settled_vertices(mechanism.fold_angles(sheet.target))
    opposite, vertices = opposite_panels(layout, settled)
    flapped = sheet.flapped(opposite)
    corners = Corners(
        mechanism,
        mechanism.inner_columns,
        selected(opposite, flapped),
        vertices[flapped],
        [sheet.target],
        panels_laid_flat(mechanism),
        lambda each: each.with_flaps(mechanism),
    )
    apart = layout.grid.vertices()[1:-1, 1:-1][settled]
    points = sheet.points_at_target()

    def look(built: BuiltPanels) -> Met:
        bodies = corners.bodies(built)
        found = deepest_contact(
            bodies, points, tolerance, only=layout.flaps, settled=apart, hinged=layout.hinges
        )
        return Met.of(found, sheet.target, bodies)

    built, met = cut_corners(design, built, tolerance, look, lambda _: corners)
    if met.contact is None:
        return built, None
    found = sheet.contact_of_boards(met.contact, built.with_flaps(mechanism))
    return built, replace(found, overlap=met.depth)


def refuse_clipped(design: Design, contact: Contact) -> ClashError:
    """Return the error for clipped flaps that have no room at the target.

    contact: What one of them reaches into.
    """
    assert contact.overlap is not None
    first, second = contact.names
    error = ClashError(
        f"{first} and {second} meet when flaps are clipped on ({contact.kind})",
        place="at the target",
        size=f"one reaches {contact.overlap:.4g} into the other",
        excess=contact.overlap / design.flap,
        flap=design.flap,
        thick=contact.sides is not None,
    )
    error.candidates = _other_sides(design)
    return error


def _other_sides(design: Design) -> Iterator[Remedy]:
    """Flaps turned to other ends of f."""
    if not design.flap_sides:
        return
    for sides in product(SIDES, SIDES):
        if sides != design.flap_sides:
            same = sides[0] == sides[1]
            yield Remedy({"pattern.flap_side": sides[0] if same else list(sides)})
