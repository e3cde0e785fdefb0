"""Where boards of the sheet first meet, and how little of their corners must go.

Boards of neighbours never meet. Where those that are opposite each other at a vertex would, corners
are cut off there, as little as will do; any other contact ends the motion.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Protocol, TypeVar

import numpy as np

from orishell.clash import PathContact, PathResult
from orishell.clash.bodies import Apartness, Bodies, opposite_panels
from orishell.clash.body_path import find_first_body_contact
from orishell.clash.broad_phase import Pairs
from orishell.conventions.errors import DesignError
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.record import record
from orishell.design import Design
from orishell.locking.in_pieces import first_hinged_contact
from orishell.motion import Mechanism
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.boards import Boards
from orishell.motion.layout import Layout, points_of
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.solids import BuiltPanels, build_panels

STATES = 17
"""States in which boards at a vertex are compared to see how far corners must be cut off."""
LARGEST_CUTS = (0.5, 0.25, 0.125)
"""Corners are cut off at most this far, relative to the shortest edge at their vertex: as far as
leaves something of all boards."""
FINE = 0.05
"""Corners are cut off by this share more than is needed."""
CLEARANCE = 1e-3
"""Cut corners keep this share of the height of boards between them, and do not touch."""
HALVINGS = 12
TRIES = 4


class Looked(Protocol):
    """What was found of boards: their first contact, or None."""

    @property
    def contact(self) -> PathContact | None:
        """The contact."""


Found = TypeVar("Found", bound=Looked)


@record
class Met:
    """Boards that meet at the target, and how far one reaches into the other."""

    contact: PathContact | None
    depth: float

    @classmethod
    def of(cls, deepest: tuple[tuple[int, int], float] | None, drive: float, bodies: Bodies) -> Met:
        """Of the pair of bodies that reach deepest into each other in a state, if any do."""
        if deepest is None:
            return cls(None, 0.0)
        pair, depth = deepest
        return cls(PathContact(drive, drive, bodies.carriers(pair), pair), depth)


@record
class Corners:
    """Boards that are opposite each other at vertices, and where they are compared.

    mechanism: The sheet that carries them, with its flaps or without.
    columns: The columns of its vertices at which corners may be cut off: those of the sheet.
    opposite, vertices: Panels (P,) opposite each other, and the vertex (P,) that they share.
    drives: States in which their boards are compared (radians).
    lying: Corners (F, 4, 2) of panels as they lie flat, in which boards are described.
    boards: All boards on it.
    """

    mechanism: Mechanism
    columns: slice
    opposite: Pairs
    vertices: Integers
    drives: Sequence[float]
    lying: Array
    boards: Callable[[BuiltPanels], Boards]

    def bodies(self, built: BuiltPanels) -> Bodies:
        """Its boards as bodies."""
        faces = Layout.of(self.mechanism).faces
        return Bodies(self.boards(built), faces, self.lying)


def prove_boards(
    design: Design,
    end: float,
    tolerance: float,
    progress: Progress = no_progress,
    *,
    only: Booleans | None = None,
) -> tuple[BuiltPanels, PathResult]:
    """Return the boards of a design, corners cut off where need be, and their first contact.

    Flaps that are clipped on are looked at later (:mod:`~orishell.locking.clipped`).

    end: The drive up to which boards are set back and the path is examined (radians).
    tolerance: Distance at which boards touch (length).
    only: Panels (F,): pairs of boards with none of theirs are left out. All panels if None.

    Raises DesignError if nothing is left of a panel.
    """
    mechanism, lying = design.mechanism.least_turning, panels_laid_flat(design.mechanism)
    built = build_panels(design, end)
    settled, hinges = built.settled(), built.boards.hinges
    # Boards of two pieces are looked at where they are joined.
    settled[list(hinges.joint_rows)] = True
    opposite, vertices = opposite_panels(Layout.of(mechanism), settled)

    def corners(drive: float) -> Corners:
        # Whole boards meet at their vertices in the flat sheet, and lie on each other in the pack,
        # where no cut helps.
        others = [0.0] if hinges.beside else np.linspace(0.0, built.limit, STATES)
        drives = np.unique([*others, drive]).tolist()
        return Corners(
            mechanism, slice(None), opposite, vertices, drives, lying, lambda each: each.bodies
        )

    def first_contact(built: BuiltPanels) -> PathResult:
        if hinges.beside:
            return first_hinged_contact(mechanism, built.boards, end, tolerance, progress)
        return find_first_body_contact(
            mechanism,
            end,
            tolerance,
            corners(end).bodies(built),
            settled=settled,
            only=only,
            progress=progress,
        )

    return cut_corners(design, built, tolerance, first_contact, corners)


def cut_corners(
    design: Design,
    built: BuiltPanels,
    tolerance: float,
    look: Callable[[BuiltPanels], Found],
    corners: Callable[[float], Corners],
) -> tuple[BuiltPanels, Found]:
    """Return boards with as little of their corners cut off as helps, and what is found of them.

    built: The boards to begin with.
    tolerance: Distance at which boards touch (length).
    look: Where boards meet.
    corners: What is compared to see how far corners must be cut off, if boards opposite each other
        at a vertex meet at a drive (radians).
    """
    result = look(built)
    for attempt in range(TRIES):
        contact = result.contact
        if contact is None:
            break
        there = corners(contact.drive)
        if not _share_vertex(there.mechanism, contact.panels):
            break
        reliefs = _relieve(design, built, there, tolerance, FINE * 2.0**attempt)
        if reliefs is None:
            break
        built = build_panels(design, built.limit, reliefs)
        result = look(built)
    return built, result


def _share_vertex(mechanism: Mechanism, panels: tuple[int, int]) -> bool:
    first, second = Layout.of(mechanism).faces[list(panels)]
    return bool(np.isin(first, second).any())


def _relieve(
    design: Design, built: BuiltPanels, corners: Corners, tolerance: float, more: float
) -> Array | None:
    """How far corners are cut off (rows, columns) so that opposite boards are apart.

    None if that does not help.
    """
    mechanism, grid = corners.mechanism, corners.mechanism.grid
    shortest = _shortest_edges(mechanism)[:, corners.columns]
    clearance = tolerance + CLEARANCE * built.build.height
    bodies = corners.bodies(built)
    pairs, which = bodies.pairs_of(corners.opposite)
    vertex = corners.vertices[which]

    def gaps(bodies: Bodies, drive: float, some: Integers) -> Array:
        state = bodies.carried(points_of(mechanism, drive))
        found = Apartness.of((state, state), (pairs[0][some], pairs[1][some]))
        return np.asarray(found.gaps[0])

    # Smaller boards are apart wherever larger ones are: only these states and pairs count.
    everything = np.arange(len(vertex))
    meeting = [(at, everything[gaps(bodies, at, everything) <= clearance]) for at in corners.drives]

    def not_apart(reliefs: Array) -> Booleans:
        """Vertices (rows, columns) at which opposite boards meet in one of the states."""
        found = np.zeros(grid.vertex_count, np.bool_)
        now = corners.bodies(build_panels(design, built.limit, reliefs))
        for at, some in meeting:
            if len(some):
                found[vertex[some[gaps(now, at, some) <= clearance]]] = True
        return found.reshape(grid.rows, grid.columns)[:, corners.columns]

    there = not_apart(built.reliefs)
    for share in LARGEST_CUTS:
        enough = np.where(there, np.maximum(share * shortest, built.reliefs), built.reliefs)
        if _can_be_built(design, built.limit, enough):
            break
    else:
        return None
    room = enough
    if not there.any() or not_apart(room).any():
        return None
    short = np.where(there, built.reliefs, 0.0)
    for _ in range(HALVINGS):
        middle = np.where(there, 0.5 * (short + enough), built.reliefs)
        bad = not_apart(middle)
        short, enough = np.where(there & bad, middle, short), np.where(there & ~bad, middle, enough)
    return np.where(there, np.minimum((1 + more) * enough, room), built.reliefs)


def _can_be_built(design: Design, limit: float, reliefs: Array) -> bool:
    """Whether something is left of all boards."""
    try:
        build_panels(design, limit, reliefs)
    except DesignError:
        return False
    return True


def _shortest_edges(mechanism: Mechanism) -> Array:
    """Length (rows, columns) of the shortest edge at every vertex."""
    layout, flat = Layout.of(mechanism), points_of(mechanism, 0.0)
    ends, _ = layout.edges
    length = np.linalg.norm(flat[ends[:, 1]] - flat[ends[:, 0]], axis=-1)
    shortest = np.full(len(flat), np.inf)
    np.minimum.at(shortest, ends, length[:, None])
    return shortest[: layout.grid.vertex_count].reshape(layout.grid.rows, layout.grid.columns)
