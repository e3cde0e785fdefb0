"""To which sides flaps fold, and where they end: cut off with the columns, if they still lock.

At lock a flap lies in the plane of its column, moved along the bisectors of the column's zigzag.
Towards the end of f to which it folds these run outwards, below the feet of an arch. A corner that
is moved back along its row crease stays in its panels' planes, so a cut changes nothing in the
motion but the flap's outline.

Only the first and the last column matter, and what is beside them: points of f's plane, in complex
numbers whose imaginary part goes upwards. All sides are tried together.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from orishell.conventions.record import record
from orishell.design import FlapSide
from orishell.families.orthodiagonal.headings import HeadingConditions
from orishell.families.orthodiagonal.profile import End, EndPlanes
from orishell.numerics.arrays import Array, Booleans, Complex
from orishell.numerics.equals import first_smallest
from orishell.polylines import Zigzag, alternating

FLAP_SHARE = 0.5
"""An "auto" flap takes at most this share of the width that there is room for."""
MUCH_NARROWER = 0.5
"""Flaps that become narrower by this do not change sides to stay above the feet."""
SMALLEST_KEPT = 0.1
"""A cut flap keeps this share of every row crease: panels that meet along less lock nothing."""
SHORTEST = 0.2
"""Its end edges keep this share of the column's."""
BEYOND = 1e-9
"""Flaps that reach below the feet by less than this share of the height count as level."""
LEFT, FIRST, LAST, RIGHT = range(4)
"""The columns that are looked at: the flaps' edges, and the columns that these are beside."""


@record
class Flaps:
    """The flaps of a shell, and the ends of its columns."""

    width: float  # in the flat sheet
    sides: tuple[FlapSide, FlapSide]
    ends: list[End]  # the planes in which the shell ends
    trims: tuple[float, float]  # growth by K of the first and of the last edge of a column
    kept: Array  # shares (2, m+2) of their widths that the left and the right flap keep
    depth: float  # how far they reach below the first and the last column at lock

    @property
    def footing(self) -> float:
        """A score of how well a shell stands: on level ends, on straight ones, not on its flaps."""
        value = {"level": 1.0, "square": 0.6, "untrimmed": 0.0}
        return sum(value[end] for end in self.ends) - (1.0 if self.depth else 0.0)


def choose_flaps(
    planes: EndPlanes,
    zigzag: Zigzag,
    headings: HeadingConditions,
    heading: float,
    flap: float | None,
) -> Flaps:
    """The flaps of a width, or as wide as there is room, that reach least far below the feet.

    Of sides that are left open those where there is more room are taken, unless the flaps would
    reach below the feet there, and less so at others without being much narrower. Where flaps
    cannot be cut, or would reach less far below the feet without a cut, the ends are trimmed so
    that flaps need none.
    """
    sides = headings.side_choices(heading)
    room = np.array([replace(headings, sides=each).room(heading) for each in sides])
    widths = np.minimum(zigzag.lengths.mean(), FLAP_SHARE * room)
    if flap is not None:
        widths = np.full(len(sides), flap)
    tried = (widths < room) & (widths >= MUCH_NARROWER * widths[0])
    tried[0] = True

    inner = headings.shifts(heading)
    signs = np.array([[1.0 if side == "end" else -1.0 for side in each] for each in sides])
    shifts = np.empty((len(sides), 4))
    shifts[:, FIRST], shifts[:, LAST] = inner[0], inner[-1]
    shifts[:, LEFT] = shifts[:, FIRST] + signs[:, 0] * widths
    shifts[:, RIGHT] = shifts[:, LAST] + signs[:, 1] * widths

    cut_at = planes.trimmed(inner)
    cut = _locked(zigzag, shifts, np.array([cut_at.trims]))
    kept, whole = np.ones((len(sides), 2, len(zigzag.vertices))), np.ones(len(sides), np.bool_)
    if widths[0]:
        kept, whole = _kept(cut, cut_at.normals)
        for number, (edge, near) in enumerate(((LEFT, FIRST), (RIGHT, LAST))):
            reach = cut[..., edge] - cut[..., near]
            cut[..., edge] = cut[..., near] + kept[:, number] * reach
    depth = np.where(whole, _below_feet(cut), np.inf)
    ends = [cut_at] * len(sides)
    if depth[0]:
        others = [planes.trimmed(np.append(inner, each)) for each in shifts]
        uncut = _below_feet(_locked(zigzag, shifts, np.array([each.trims for each in others])))
        for k in np.flatnonzero(uncut < depth).tolist():
            ends[k], kept[k], depth[k] = others[k], 1.0, uncut[k]
    best = first_smallest(np.where(tried, depth, np.inf))
    chosen = ends[best]
    return Flaps(
        width=float(widths[best]),
        sides=sides[best],
        ends=chosen.ends,
        trims=chosen.trims,
        kept=kept[best],
        depth=float(depth[best]),
    )


def _locked(zigzag: Zigzag, shifts: Array, trims: Array) -> Complex:
    """Vertices (S, m+2, 4) at lock of columns at shifts K (S, 4), with trims (S, 2) or (1, 2)."""
    points = zigzag.vertices @ np.array([1, 1j])
    direction = np.diff(points) / zigzag.lengths
    turning = -zigzag.first * alternating(len(zigzag.angles))
    spread = np.empty((len(trims), len(points)), np.complex128)
    spread[:, 1:-1] = direction[1:] * (np.tan(zigzag.angles / 2) - 1j * turning)
    spread[:, 0] = spread[:, 1] - trims[:, 0] * direction[0]
    spread[:, -1] = spread[:, -2] + trims[:, 1] * direction[-1]
    return np.asarray(points[:, None] + spread[..., None] * shifts[:, None])


def _below_feet(plane: Complex) -> Array:
    """How far (S,) flaps reach below the first and the last column (length)."""
    inner = plane[..., FIRST : LAST + 1].imag
    lowest = inner.min(axis=(1, 2))
    below = lowest - plane.imag.min(axis=(1, 2))
    return np.where(below > BEYOND * (inner.max(axis=(1, 2)) - lowest), below, 0.0)


def _kept(plane: Complex, normals: Sequence[complex | None]) -> tuple[Array, Booleans]:
    """Shares (S, 2, m+2) of their width that flaps keep at all rows; whether (S,) that will do.

    normals: For both ends of f that of the plane in which columns end, or None.
    """
    kept = np.ones((len(plane), 2, plane.shape[1]))
    enough = np.ones(len(plane), np.bool_)
    for flap, (edge, near) in enumerate(((LEFT, FIRST), (RIGHT, LAST))):
        for end, normal in zip((0, -1), normals, strict=True):
            if normal is not None:
                share, good = _share(plane[0, :, near], plane[..., edge], normal, end)
                kept[:, flap] = np.minimum(kept[:, flap], share)
                enough &= good
    return kept, enough


def _share(column: Complex, whole: Complex, normal: complex, end: int) -> tuple[Array, Booleans]:
    """Shares (S, m+2) that flaps cut by a plane keep at all rows; whether (S,) that will do.

    The plane goes through the vertex ``end`` (0 or -1) of the column (m+2,); ``whole`` are the
    flaps' edges (S, m+2).
    """
    rows = len(column)
    side = np.arange(rows) < rows // 2 if end == 0 else np.arange(rows) > rows // 2
    side[end] = False
    beside = 1 if end == 0 else -2
    inwards = ((column[rows // 2] - column[end]) * normal.conjugate()).real
    normal = -normal / abs(normal) * np.sign(inwards)  # outwards
    room = ((column[end] - column) * normal.conjugate()).real
    reach = ((whole - column) * normal.conjugate()).real
    beyond = side & (reach > room)
    # A crease that begins beyond the plane keeps nothing.
    share = np.divide(room, reach, out=1.0 - beyond, where=beyond & (room > 0))
    # The end's own corner lies in the plane; beside a crease that ends there, half as far out.
    slanted = beyond[:, beside]
    share[:, end] = np.where(slanted, 0.5 * share[:, beside], 1.0)
    edge = (whole[:, end] - whole[:, beside]) / (column[end] - column[beside])
    enough = (share[:, side] >= SMALLEST_KEPT).all(axis=1)
    return share, enough & (slanted | (edge.real >= SHORTEST))
