"""What lies flat in no state, but is made in strips that do: T-hedral shells, by their vertices."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import counted
from orishell.conventions.record import record
from orishell.families.t_hedral import KnownTHedron, recognise_t_hedron
from orishell.motion.crease_pattern import CreasePattern, FoldedPattern
from orishell.motion.following.dofs import Freedom, find_freedom
from orishell.motion.following.system import Closure
from orishell.motion.gridding import find_grid
from orishell.motion.mesh import folds_between
from orishell.motion.quads import unit_normals
from orishell.numerics.arrays import Array, Integers


@record
class Strips:
    """A T-hedron in a file."""

    known: KnownTHedron  # its numbers are those of the file's vertices
    pattern: FoldedPattern  # panels and edges as the file numbers them
    diagonal: float  # of the state in which it was recognised

    @property
    def sheet(self) -> str:
        """What it is cut from, in words."""
        strips = counted(self.known.strips, "strip")
        return f"no flat sheet: made in {strips}, each of which lies flat, that are joined"

    @property
    def family(self) -> str:
        """Its family, in words."""
        return f"t-hedral: vertices to {self.known.miss / self.diagonal:.1g} of the diagonal"

    def places(self, drive: float) -> Array:
        """Vertices (V, 3) in a state of its closed form.

        Parameters
        ----------
        drive
            The drive (radians).
        """
        found = np.zeros_like(self.pattern.points)
        found[self.known.numbers] = self.known.mechanism.positions(drive)
        return found

    def freedom_at(self, places: Array) -> Freedom:
        """Degrees of freedom in a state.

        Parameters
        ----------
        places
            Vertices (V, 3).
        """
        pattern, closure = self.pattern, Closure.of(self.pattern)
        normals = unit_normals(places[pattern.faces])
        folds = folds_between(normals, pattern.edges, pattern.edge_faces, pattern.crease, places)
        return find_freedom(closure, folds[closure.edges])


def find_strips(
    states: Iterable[Array],
    loops: Integers,
    edges: Integers,
    edge_faces: Integers,
    tolerance: float,
) -> Strips | None:
    """The T-hedron that panels make in the first state in which they are seen to; None if in none.

    Parameters
    ----------
    states
        Vertices (V, 3) in every state.
    loops, edges, edge_faces
        Panels and edges as :class:`~orishell.motion.crease_pattern.CreasePattern` has them.
    tolerance
        Allowed error of lengths, as a share of the diagonal.
    """
    letters, numbers = np.where((edge_faces >= 0).all(axis=1), "U", "B"), None
    for places in states:
        if numbers is None:
            # Which panel is beside which is asked; where a vertex is seen does not matter.
            seen = CreasePattern(places[:, :2], edges, letters, loops, edge_faces)
            try:
                numbers = find_grid(seen)
            except InputError:
                return None
        diagonal = float(np.linalg.norm(np.ptp(places[numbers.ravel()], axis=0)))
        known = recognise_t_hedron(places[numbers], tolerance * diagonal)
        if known is None:
            continue
        known = replace(known, numbers=numbers.ravel()[known.numbers])
        rows, columns = known.numbers.shape
        drawn = np.zeros((len(places), 2))
        drawn[known.numbers] = np.stack(
            np.broadcast_arrays(np.arange(columns), -np.arange(rows)[:, None]), axis=-1
        )
        pattern = FoldedPattern(drawn, edges, letters, loops[:, :4], edge_faces, places)
        return Strips(known, pattern, diagonal)
    return None
