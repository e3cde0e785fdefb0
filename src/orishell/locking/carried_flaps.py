"""What a sheet carries beside flaps that are clipped on: whether they meet at the target."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from orishell.clash.bodies import Bodies
from orishell.clash.separation import corners_of, overlaps
from orishell.clash.state import deepest_between, near_panels
from orishell.design import Design
from orishell.design.carried import CarriedPart
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.boards import Boards, join_boards
from orishell.motion.grid import Panel
from orishell.motion.layout import Layout, points_of
from orishell.solids import BuiltPanels

Called = tuple[str, Panel]
"""What a panel is called; and the panel of the sheet that it is, or hangs on."""


def called(part: CarriedPart) -> list[Called]:
    """All panels of a part."""
    return [*zip(part.names, part.hung_on, strict=True)]


def flap_contact(
    design: Design, built: BuiltPanels | None, carried: Sequence[CarriedPart], tolerance: float
) -> tuple[Called, Called] | None:
    """A flap that is clipped on and what it meets at the target; None if nothing.

    built: The sheet and its flaps as they are built; None if panels have no thickness.
    tolerance: By how much they may reach into each other (length).
    """
    flapped = design.clipped
    if flapped is None:
        return None
    layout, target = Layout.of(flapped), flapped.target_drive
    flaps, points = layout.faces[layout.flaps], points_of(flapped, target)
    left = flapped.inner_columns.start  # columns of flaps before the sheet's
    places = [(row, column - left) for row, column in layout.names[layout.flaps].tolist()]
    every = [(f"flap {[*each]}", each) for each in places]
    every += [each for part in carried for each in called(part)]
    faces, vertices = [flaps], [points]
    lying = [panels_laid_flat(flapped)[layout.flaps]]
    boards = [] if built is None else [_of_flaps(built, layout)]
    for part in carried:
        begin, behind = sum(map(len, vertices)), sum(map(len, faces))
        faces.append(part.strips.grid.faces_vertices() + begin)
        vertices.append(points_of(part.strips, target))
        lying.append(panels_laid_flat(part.strips))
        if part.boards is not None:
            boards.append(replace(part.boards, panels=part.boards.panels + behind))
    whole, there = np.concatenate(faces), np.concatenate(vertices)
    if boards:
        bodies = Bodies(join_boards(boards), whole, np.concatenate(lying))
        groups = (bodies.panels >= len(flaps)).astype(np.int64)
        met = deepest_between(bodies, there, tolerance, groups)
        pair = None if met is None else bodies.carriers(met[0])
    else:
        first, second = near_panels(there, whole, tolerance)
        chosen = (first < len(flaps)) & (second >= len(flaps))
        first, second = first[chosen], second[chosen]
        depth = overlaps(corners_of(there, whole[first]), corners_of(there, whole[second]))
        deep = np.flatnonzero(depth > tolerance)
        pair = (int(first[deep[0]]), int(second[deep[0]])) if len(deep) else None
    if pair is None:
        return None
    return every[pair[0]], every[pair[1]]


def _of_flaps(built: BuiltPanels, layout: Layout) -> Boards:
    """Boards of flaps that are clipped on, as panels of the flaps alone."""
    assert built.flaps is not None
    number = np.cumsum(layout.flaps) - 1
    return replace(built.flaps, panels=number[built.flaps.panels])
