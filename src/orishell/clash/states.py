"""The states of a path that are looked at: positions, and what encloses panels and bodies there."""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import dataclass

from orishell.clash.bodies import Bodies, BodyState
from orishell.clash.body_phase import Slabs
from orishell.clash.broad_phase import Extents, PanelTree
from orishell.clash.ranges import TICKS
from orishell.motion import Mechanism
from orishell.numerics.arrays import Array

KEPT = 16


@dataclass(slots=True, eq=False)
class _State:
    points: Array
    extents: Extents | None = None
    slabs: Slabs | None = None
    bodies: BodyState | None = None


class States:
    """The states at ticks of a path; the last few are kept.

    Parameters
    ----------
    mechanism
        The folding sheet.
    end
        The path goes from the flat sheet to this drive (radians).
    tree
        The tree over its panels.
    bodies
        The bodies on its panels, if these are looked at.
    """

    def __init__(
        self, mechanism: Mechanism, end: float, tree: PanelTree, bodies: Bodies | None
    ) -> None:
        self.mechanism, self.end, self.tree, self.bodies = mechanism, end, tree, bodies
        self.kept: OrderedDict[int, _State] = OrderedDict()
        self.made = 0

    def drive(self, tick: int) -> float:
        """The drive at a tick (radians)."""
        return self.end * (tick / TICKS)

    def points(self, tick: int) -> Array:
        """Vertices (V, 3) of a state."""
        return self._at(tick).points

    def extents(self, tick: int) -> Extents:
        """What the nodes of the tree span in a state, with the height of bodies."""
        state = self._at(tick)
        if state.extents is None:
            over = None
            if self.bodies is not None:
                over = self.bodies.height * self.slabs(tick).normals.T
            state.extents = self.tree.extents(state.points, over)
        return state.extents

    def slabs(self, tick: int) -> Slabs:
        """Panels as thick as their bodies in a state."""
        state = self._at(tick)
        if state.slabs is None:
            height = 0.0 if self.bodies is None else self.bodies.height
            state.slabs = Slabs.of(state.points, self.tree.faces, height)
        return state.slabs

    def bodies_of(self, bodies: Bodies, tick: int) -> BodyState:
        """The bodies in a state."""
        state = self._at(tick)
        if state.bodies is None:
            state.bodies = bodies.carried(state.points)
        return state.bodies

    def _at(self, tick: int) -> _State:
        state = self.kept.get(tick)
        if state is None:
            self.made += 1
            state = _State(self.mechanism.positions(self.drive(tick)).reshape(-1, 3))
            self.kept[tick] = state
            if len(self.kept) > KEPT:
                self.kept.popitem(last=False)
        self.kept.move_to_end(tick)
        return state
