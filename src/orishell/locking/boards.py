"""Where boards first meet, and how little of their corners must go so that they do not.

Boards of neighbours never meet. Where those that are opposite each other at a vertex would, corners
are cut off there, as little as will do; any other contact ends the motion.
"""

from __future__ import annotations

import numpy as np

from orishell.clash import PathResult
from orishell.clash.bodies import Apartness, Bodies
from orishell.clash.body_path import find_first_body_contact
from orishell.clash.opposite import opposite_panels
from orishell.conventions.progress import Progress, unwatched
from orishell.design import Design
from orishell.errors import DesignError
from orishell.motion import Mechanism
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.solids import Built, build_panels

STATES = 17
"""States in which boards at a vertex are compared to see how far corners must be cut off."""
LARGEST = (0.5, 0.25, 0.125)
"""Corners are cut off at most this far, relative to the shortest edge at their vertex: as far as
leaves something of all boards."""
FINE = 0.05
"""Corners are cut off by this share more than is needed."""
CLEARANCE = 1e-3
"""Cut corners keep this share of the height of boards between them, and do not touch."""
HALVINGS = 12
TRIES = 4


def prove_boards(
    design: Design, end: float, tolerance: float, progress: Progress = unwatched
) -> tuple[Built, PathResult]:
    """Return the boards of a design, corners cut off where need be, and their first contact.

    Parameters
    ----------
    end
        The drive up to which boards are set back and the path is examined (radians).
    tolerance
        Distance at which boards touch (length).

    Raises
    ------
    DesignError
        If nothing is left of a panel.
    """
    mechanism = design.mechanism.still

    def first_contact(built: Built) -> PathResult:
        return find_first_body_contact(
            mechanism,
            end,
            tolerance,
            _bodies(design, built),
            settled=built.settled(),
            progress=progress,
        )

    built = build_panels(design, end)
    result = first_contact(built)
    for attempt in range(TRIES):
        contact = result.contact
        if contact is None or not _share_vertex(mechanism, contact.panels):
            break
        reliefs = _relieve(design, built, contact.drive, tolerance, FINE * 2.0**attempt)
        if reliefs is None:
            break
        built = build_panels(design, end, reliefs)
        result = first_contact(built)
    return built, result


def _bodies(design: Design, built: Built) -> Bodies:
    flat = design.mechanism.positions(0.0).reshape(-1, 3)
    return Bodies(built.boards, design.mechanism.grid.faces_vertices(), flat)


def _share_vertex(mechanism: Mechanism, panels: tuple[int, int]) -> bool:
    first, second = mechanism.grid.faces_vertices()[list(panels)]
    return bool(np.isin(first, second).any())


def _relieve(
    design: Design, built: Built, drive: float, tolerance: float, more: float
) -> Array | None:
    """How far corners are cut off (rows, columns) so that opposite boards are apart.

    None if that does not help.
    """
    mechanism = design.mechanism.still
    grid = mechanism.grid
    shortest = _shortest_edges(mechanism)
    clearance = tolerance + CLEARANCE * built.build.height
    bodies = _bodies(design, built)
    panels, vertices = opposite_panels(grid, built.settled())
    pairs, which = bodies.pairs_of(panels)
    vertex = vertices[which]

    def gaps(bodies: Bodies, drive: float, some: Integers) -> Array:
        state = bodies.carried(mechanism.positions(drive).reshape(-1, 3))
        found = Apartness.of((state, state), (pairs[0][some], pairs[1][some]))
        return np.asarray(found.gaps[0])

    # Smaller boards are apart wherever larger ones are: only these states and pairs count.
    everything = np.arange(len(vertex))
    meeting = [
        (at, everything[gaps(bodies, at, everything) <= clearance])
        for at in np.unique([*np.linspace(0.0, built.limit, STATES), drive]).tolist()
    ]

    def not_apart(reliefs: Array) -> Booleans:
        """Vertices (rows, columns) at which opposite boards meet in one of the states."""
        found = np.zeros(grid.vertex_count, np.bool_)
        now = _bodies(design, build_panels(design, built.limit, reliefs))
        for at, some in meeting:
            if len(some):
                found[vertex[some[gaps(now, at, some) <= clearance]]] = True
        return found.reshape(grid.rows, grid.columns)

    there = not_apart(built.reliefs)
    for share in LARGEST:
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
    flat = mechanism.positions(0.0)
    along, down = (np.linalg.norm(np.diff(flat, axis=axis), axis=-1) for axis in (1, 0))
    shortest = np.full(flat.shape[:2], np.inf)
    for part, length in (
        (np.s_[:, :-1], along),
        (np.s_[:, 1:], along),
        (np.s_[:-1], down),
        (np.s_[1:], down),
    ):
        shortest[part] = np.minimum(shortest[part], length)
    return shortest
