"""Hinges of whole boards as parts: where their leaves, holes and arms are in the flat sheet.

A hinge takes the middle of its crease. A leaf lies on the face of its board, or, where the hinge
stands off the board, on an arm. That is a sheet bent square: a fin, from the face to the hinge, and
a foot on the face, as wide as a leaf. Both are screwed through a row of holes in their middle, and
so is the leaf to the fin.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import rounded_down
from orishell.conventions.record import record
from orishell.design.panel import PanelSpec
from orishell.motion.boards import EDGES
from orishell.motion.grid import CreaseValues
from orishell.motion.hinges import Hinges
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.numerics.equals import classes, first_smallest

TRIMMED = 0.2
"""Share of a crease that hinges and fins leave out at either end: room for other boards at the
vertices, and for leaves along other edges."""
SHORT = 1e-6
"""A hinge that is nearer to a face than this share of the thickness needs no fin."""
ALIKE = 1e-3
"""Lengths that differ by less than this share of the thickness are one: 10 um for 10 mm."""
LARGEST_LEAF, USUAL_LEAF = 0.5, 0.2
"""Share of the way across its panel that a leaf may take, so that opposite ones never meet, and
that one takes at most whose width is "auto"."""
NARROW = 2.0
"""Diameters of a hole below which a leaf or a fin is too narrow for it."""


@record
class ArmKind:
    """Arms of one size, as they are cut."""

    name: str  # as in "A1"
    count: int
    length: float  # along the crease (length)
    height: float  # of the fin (length)
    foot: float  # how wide the foot is; 0 for a block (length)
    # distances of holes from the middle (n,), in the fin from its upper edge and in the foot from
    # the bend; None where there is no room for holes
    along: Array
    in_fin: float | None
    in_foot: float | None

    @property
    def area(self) -> float:
        """Of the sheet that it is bent of (length squared)."""
        return self.length * (self.height + self.foot)


@record
class Fittings:
    """All hinges (H,) of whole boards, those of rows first."""

    edges: Integers  # numbers (H,) of their edges in the grid
    # panels (H, 2) beside them, above and below or left and right, and their edges (H, 2), in EDGES
    panels: Integers
    at: Integers
    sides: Integers  # the face (H,) that they are on: 1 top, -1 bottom
    ends: Array  # of the hinges on their creases (H, 2, 2); the first panel is on the left
    leaves: Array  # widths (H,) of leaves (length)
    away: float  # of leaves from the crease (length)
    fins: Array  # heights (H, 2) of fins, 0 where the leaf lies on the face (length)
    feet: Array  # widths (H,) of the feet of arms, 0 for blocks (length)
    counts: Integers  # holes (H,) in a leaf, 0 where there is no room
    steps: Array  # from hole to hole (H,) (length)
    hole: float  # diameter (length)
    of_kind: Integers  # the kind (H, 2) of arms on the two boards, -1 where there is none
    arms: tuple[ArmKind, ...]

    @property
    def lengths(self) -> Array:
        """Of the hinges (H,) (length)."""
        return np.asarray(np.hypot(*(self.ends[:, 1] - self.ends[:, 0]).T))

    @property
    def on_arms(self) -> Booleans:
        """Which (H,) stand on an arm on either board."""
        return np.asarray((self.fins > 0).any(axis=1))

    @property
    def screws(self) -> int:
        """Number of holes, in boards, and in fins that have some."""
        in_fins = sum(len(arm.along) * arm.count for arm in self.arms if arm.in_fin is not None)
        return 2 * int(self.counts.sum()) + in_fins

    def arm_mass(self, build: PanelSpec) -> float:
        """Of all arms (kg, in a unit of a metre); 0 where their density is not known."""
        area = sum(arm.count * arm.area for arm in self.arms)
        return area * build.fin * build.arm_density

    def hinge_mass(self, build: PanelSpec) -> float:
        """Of all hinges (kg, in a unit of a metre); 0 where it is not known."""
        return float(self.lengths.sum()) * build.hinge.linear_density

    def holes(self) -> tuple[Array, Integers, Integers]:
        """Middles (N, 2) of all holes in boards, and the hinge (N,) and panel (N,) of each."""
        run = self.ends[:, 1] - self.ends[:, 0]
        along = run / np.hypot(*run.T)[:, None]
        inward = np.stack([-along[:, 1], along[:, 0]], axis=-1)
        number = np.arange(int(self.counts.max(initial=0)))
        there = number < self.counts[:, None]
        off = (number - 0.5 * (self.counts[:, None] - 1)) * self.steps[:, None]
        on_crease = self.ends.mean(axis=1)[:, None] + off[..., None] * along[:, None]
        beside = (self.away + 0.5 * self.leaves)[:, None] * inward
        both = np.stack([on_crease + beside[:, None], on_crease - beside[:, None]], axis=1)
        chosen = np.repeat(there[:, None], 2, axis=1)
        hinge, side, _ = np.nonzero(chosen)
        return both[chosen], hinge, self.panels[hinge, side]


def fit_hinges(panels: Array, hinges: Hinges, build: PanelSpec) -> Fittings:
    """The hinges of whole boards as parts.

    Parameters
    ----------
    panels
        Corners (F, 4, 2) of the panels in the flat sheet, counter-clockwise, top left first.

    Raises
    ------
    DesignError
        If a leaf is wider than a panel has room for, or holes are farther apart than a hinge is
        long.
    """
    edges, pair, sides, arms = _folding(hinges)
    corners = panels[pair[:, 0]]
    # Seen from the first panel: its lower edge, or its right one.
    row = (edges < hinges.grid.rows * (hinges.grid.columns - 1)).astype(np.int64)
    first, second = np.where(row, 1, 2), np.where(row, 3, 0)
    places = np.arange(len(edges))
    start, end = corners[places, first], corners[places, (first + 1) % 4]
    trim = TRIMMED * (end - start)
    ends = np.stack([start + trim, end - trim], axis=1)
    away, thickness, at = 0.5 * build.gap, build.thickness, np.stack([first, second], axis=1)
    depths = np.stack([_depths(panels[pair[:, k]], at[:, k]) for k in (0, 1)], axis=1) - away
    leaves = _leaf_widths(depths, pair, at, hinges, build)
    length = np.hypot(*(ends[:, 1] - ends[:, 0]).T)
    counts, steps = _holes_along(length, leaves, build)
    fins = np.where(arms - hinges.knuckle > SHORT * thickness, arms - hinges.knuckle, 0.0)
    hole = build.hinge.hole_in(thickness)
    feet = np.where(build.fin < leaves, leaves, 0.0)
    of_kind, kinds = _kinds(length, fins, (leaves, feet), (counts, steps), build)
    return Fittings(
        edges, pair, at, sides, ends, leaves, away, fins, feet, counts, steps, hole, of_kind, kinds
    )


def _folding(hinges: Hinges) -> tuple[Integers, Integers, Integers, Array]:
    """Edges (H,), panels (H, 2), sides (H,) and arms (H, 2) of all hinges that fold."""
    number = np.arange(hinges.levels.size, dtype=np.float64).reshape(hinges.levels.shape)
    (above, below), (left, right) = hinges.arms
    signs = hinges.sides.on_edges()
    edges = np.flatnonzero(signs)
    panels, arms = (
        np.stack([CreaseValues(*each).on_edges()[edges] for each in both], axis=-1)
        for both in (
            ((number[:-1], number[:, :-1]), (number[1:], number[:, 1:])),
            ((above, left), (below, right)),
        )
    )
    return edges, panels.astype(np.int64), signs[edges].astype(np.int64), arms


def _depths(panels: Array, edge: Integers) -> Array:
    """How far (H,) hinges along edges (H,) of panels (H, 4, 2) may reach into these."""
    places = np.arange(len(panels))
    start, end = panels[places, edge], panels[places, (edge + 1) % 4]
    run = end - start
    inward = np.stack([-run[:, 1], run[:, 0]], axis=-1) / np.hypot(*run.T)[:, None]
    from_ends = np.stack([start + TRIMMED * run, end - TRIMMED * run], axis=1)
    sides = np.roll(panels, -1, axis=1) - panels
    normal = np.stack([-sides[..., 1], sides[..., 0]], axis=-1)
    above = ((from_ends[:, :, None] - panels[:, None]) * normal[:, None]).sum(axis=-1)
    falling = -(inward[:, None] * normal).sum(axis=-1)[:, None]
    reach = np.where(falling > 0, above / np.where(falling > 0, falling, 1.0), np.inf)
    return np.asarray(reach.min(axis=(1, 2)))


def _leaf_widths(
    depths: Array,
    pair: Integers,
    at: Integers,
    hinges: Hinges,
    build: PanelSpec,
) -> Array:
    """Widths (H,) of leaves, the same on both boards, where panels are so deep (H, 2)."""
    width = build.hinge.leaf_on(build.thickness)
    if build.hinge.leaf == "auto":
        return np.asarray(np.minimum(width, USUAL_LEAF * depths.min(axis=1)))
    room = LARGEST_LEAF * depths
    if room.size and width > room.min():
        hinge, side = np.unravel_index(first_smallest(room), room.shape)
        panel = list(divmod(int(pair[hinge, side]), hinges.levels.shape[1]))
        most = max(float(room.min()), 0.0)
        raise DesignError(
            "the leaf of a hinge is wider than its panel has room for",
            place=f"at the {EDGES[int(at[hinge, side])]} edge of panel {panel}",
            keys=("panel.hinge.leaf",),
            size=f"it is {width:.4g} wide, and may be {most:.4g}",
            candidates=[Remedy({"panel.hinge.leaf": rounded_down(most)})] if most > 0 else [],
            excess=width / most - 1 if most > 0 else None,
        )
    return np.full(len(depths), width)


def _holes_along(length: Array, leaves: Array, build: PanelSpec) -> tuple[Integers, Array]:
    """Numbers (H,) of holes in leaves, and how far they are apart (H,).

    The last ones are half a leaf from its ends, or more.
    """
    spacing, hole = build.hinge.spacing_on(build.thickness), build.hinge.hole_in(build.thickness)
    room = np.maximum(length - leaves, 0.5 * length)
    if build.hinge.screw_spacing != "auto" and room.size and spacing > room.min():
        most = float(room.min())
        raise DesignError(
            "holes of a hinge would be farther apart than it is long",
            keys=("panel.hinge.screw_spacing",),
            size=f"two of them are {most:.4g} apart at most, where hinges are {length.min():.4g} "
            "long",
            candidates=[Remedy({"panel.hinge.screw_spacing": rounded_down(most)})],
            excess=spacing / most - 1,
        )
    # Two at least, as far apart as there is room.
    more = np.floor(room / spacing * (1 + SHORT)).astype(np.int64)
    counts = np.where(leaves >= NARROW * hole, np.maximum(more, 1) + 1, 0)
    return counts, np.where(more > 0, spacing, room)


def _kinds(
    length: Array,
    fins: Array,
    widths: tuple[Array, Array],
    holes: tuple[Integers, Array],
    build: PanelSpec,
) -> tuple[Integers, tuple[ArmKind, ...]]:
    """The kind (H, 2) of every arm, and the kinds, lowest fins first.

    widths: Of leaves and of feet (H,).
    holes: Their numbers (H,) in leaves, and how far they are apart (H,).
    """
    (leaves, feet), (counts, steps) = widths, holes
    near, hole = ALIKE * build.thickness, build.hinge.hole_in(build.thickness)
    hinge, side = np.nonzero(fins > 0)
    of_kind = np.full(fins.shape, -1)
    sizes = np.column_stack(
        [classes(each, near, 1.0) for each in (fins[hinge, side], length[hinge], leaves[hinge])]
    )
    _, first, kind, many = np.unique(
        sizes, axis=0, return_index=True, return_inverse=True, return_counts=True
    )
    of_kind[hinge, side] = kind.ravel()
    made = []
    for number, (place, count) in enumerate(zip(first.tolist(), many.tolist(), strict=True), 1):
        one, height = int(hinge[place]), float(fins[hinge[place], side[place]])
        screwed, foot = int(counts[one]), float(feet[one])
        in_fin = 0.5 * min(float(leaves[one]), height)
        made.append(
            ArmKind(
                name=f"A{number}",
                count=count,
                length=float(length[one]),
                height=height,
                foot=foot,
                along=(np.arange(screwed) - 0.5 * (screwed - 1)) * steps[one],
                in_fin=in_fin if screwed and 2 * in_fin >= NARROW * hole else None,
                in_foot=0.5 * foot if screwed and foot else None,
            )
        )
    return of_kind, tuple(made)
