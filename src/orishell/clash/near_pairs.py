"""Bodies whose panels have a vertex in common: they are near each other all the way."""

from __future__ import annotations

import numpy as np

from orishell.clash.bodies import Bodies
from orishell.clash.broad_phase import Pairs, selected
from orishell.conventions.record import record
from orishell.motion.layout import Layout
from orishell.numerics.arrays import Array, Booleans, Integers


@record
class NearPairs:
    """Pairs of bodies (P,) whose panels have a vertex in common."""

    bodies: Pairs
    vertices: Integers  # (P,), that their panels share
    # Heights (2, P) over each panel from which its corners are seen: those of hinges beside it.
    bases: Array
    # the panel (P,) between the two, and how far the hinges at its sides are apart in height (P,)
    between: Integers
    steps: Array

    @classmethod
    def opposite(
        cls, bodies: Bodies, layout: Layout, settled: Booleans, only: Booleans | None
    ) -> NearPairs:
        """Those that are opposite each other at a vertex, with hinges in the creases.

        Inner vertices (rows-2, columns-2) about which they are known to be apart are settled.
        Pairs with no panel of ``only`` (F,) are left out.
        """
        panels, vertex = opposite_panels(layout, settled)
        if only is not None:
            wanted = only[panels[0]] | only[panels[1]]
            panels, vertex = selected(panels, wanted), vertex[wanted]
        pairs, which = bodies.pairs_of(panels)
        none = np.zeros(len(which))
        return cls(pairs, vertex[which], np.stack([none, none]), bodies.panels[pairs[0]], none)


def opposite_panels(layout: Layout, settled: Booleans) -> tuple[Pairs, Integers]:
    """Panels opposite each other at the inner vertices that are not settled, and these (P,).

    Flaps beside the grid make inner vertices of the border's, which are never settled.
    """
    grid = layout.grid
    panel = np.arange(grid.panel_count).reshape(grid.rows - 1, grid.columns - 1)
    there = ~settled
    vertex = grid.vertices()[1:-1, 1:-1][there]
    upper, lower = layout.pairs.T
    # Hinges are listed by flaps.
    above, below = (layout.hinges[each - grid.panel_count, 1] for each in (upper, lower))
    faces = layout.faces[upper]
    on_border = faces[faces < grid.vertex_count]
    first = np.concatenate([panel[:-1, :-1][there], panel[:-1, 1:][there], upper, lower])
    second = np.concatenate([panel[1:, 1:][there], panel[1:, :-1][there], below, above])
    return (first, second), np.concatenate([vertex, vertex, on_border, on_border])
