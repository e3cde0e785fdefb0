"""Pieces of whole boards where they are joined, at the target."""

from __future__ import annotations

import numpy as np

from orishell.clash.near_pairs import opposite_panels
from orishell.clash.state import deepest_between
from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import rounded
from orishell.design import Design
from orishell.locking.boards import Corners, Met, cut_corners
from orishell.locking.sheet import Sheet
from orishell.motion.layout import points_of
from orishell.solids import BuiltPanels
from orishell.solids.hinged.pieces import piece_numbers


def join_pieces(design: Design, built: BuiltPanels, tolerance: float) -> BuiltPanels:
    """Boards of pieces, corners at joints cut off so that they are apart where all are joined.

    built: The boards, proved to be apart in each piece: smaller ones are, too.
    tolerance: Distance at which boards touch (length).

    Raises DesignError if boards of two pieces reach into each other there.
    """
    hinges = built.boards.hinges
    if hinges is None or hinges.joints is None:
        return built
    sheet = Sheet.of(design)
    mechanism, points = sheet.mechanism, sheet.points_at_target()
    elsewhere = np.ones((len(hinges.heights.row), hinges.levels.shape[1] - 1), np.bool_)
    elsewhere[list(hinges.joints.rows)] = False
    opposite, vertices = opposite_panels(sheet.layout, elsewhere)
    flat = points_of(mechanism, 0.0)
    corners = Corners(
        mechanism,
        slice(None),
        opposite,
        vertices,
        [sheet.target],
        flat,
        lambda each: each.boards,
    )

    def look(built: BuiltPanels) -> Met:
        bodies = corners.bodies(built)
        found = deepest_between(bodies, points, tolerance, piece_numbers(built.boards))
        return Met.of(found, sheet.target, bodies)

    built, met = cut_corners(design, built, tolerance, look, lambda _: corners)
    if met.contact is not None and met.depth > tolerance:
        names = sheet.contact_of_boards(met.contact, built.boards).names
        raise _refused(built, names, met.depth)
    return built


WIDER = (1.1, 2.0)
"""By how much of what boards reach into each other the gap is made wider in what is offered."""


def _refused(built: BuiltPanels, names: tuple[str, str], depth: float) -> DesignError:
    gap = built.build.gap
    return DesignError(
        f"{names[0]} and {names[1]} reach into each other where their pieces are joined",
        place="at the target",
        keys=("panel.pieces",),
        size=f"by {depth:.4g}",
        candidates=[Remedy({"panel.gap": rounded(gap + share * depth)}) for share in WIDER],
        excess=depth / built.build.thickness,
    )
