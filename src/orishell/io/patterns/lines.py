"""The straight lines of a drawing, and points that are one within a tolerance."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.document import LARGEST_COORDINATE
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.numerics.components import find_components

WELD = 1e-5
"""Points nearer to each other than this share of the drawing's diagonal are one. Drawing programs
round coordinates to a hundredth of a pixel of some thousand."""
MOST_LINES = 1_000_000
MOST_PAIRS, PAIRS_EACH = 1_000_000, 16
"""Pairs of lines, or of points, that may lie near each other: so many, or so many for each if that
is more. Sheets have a few for each; 700 lines across 700 others have half of it."""


def most_pairs(count: int) -> int:
    """Pairs of so many lines or points that may lie near each other."""
    return max(MOST_PAIRS, PAIRS_EACH * count)


@record
class Lines:
    """Straight lines, each with the letter that its look stands for."""

    ends: Array  # both ends (S, 2, 2)
    letters: NDArray[np.str_]  # (S,) as in FOLD
    angles: (
        Array  # fold angles (S,) that the drawing asks for (radians); NaN where it asks for none
    )
    owners: Integers  # which of ``names`` (S,) they are of
    names: tuple[str, ...]  # what messages call the elements of the drawing
    downwards: bool = False  # whether y goes downwards in the file, which messages tell

    @property
    def diagonal(self) -> float:
        """Of the smallest box with sides along the axes."""
        return float(np.hypot(*np.ptp(self.ends.reshape(-1, 2), axis=0)))

    def name(self, line: int) -> str:
        """What messages call the element that a line is of."""
        return self.names[int(self.owners[line])]

    def at(self, point: Array) -> str:
        """A point as the file has it."""
        x, y = (float(each) for each in point)
        return f"({x:.6g}, {0.0 - y:.6g}), y downwards" if self.downwards else f"({x:.6g}, {y:.6g})"

    def chosen(self, kept: Booleans) -> Lines:
        """Some of them."""
        return replace(
            self,
            ends=self.ends[kept],
            letters=self.letters[kept],
            angles=self.angles[kept],
            owners=self.owners[kept],
        )


def require_lines(lines: Lines) -> None:
    """Refuse a drawing without lines, with too many, or with coordinates that are none."""
    if not len(lines.ends):
        raise InputError(
            "the drawing has no lines",
            expected="creases and the sheet's border",
            remedy="give them a stroke, and show the layer that they are on",
        )
    if len(lines.ends) > MOST_LINES:
        raise InputError(
            "the drawing has too many lines",
            got=str(len(lines.ends)),
            expected=f"at most {MOST_LINES}",
        )
    bad = ~(np.abs(lines.ends) <= LARGEST_COORDINATE).all(axis=(1, 2))
    if bad.any():
        raise InputError(
            "a coordinate is too large",
            where=lines.name(int(np.argmax(bad))),
            expected=f"numbers up to {LARGEST_COORDINATE:g}",
        )


def weld_points(points: Array, tolerance: float) -> Integers:
    """For each point (N, 2) the number of the first point that it is one with.

    Raises InputError: If points that follow each other within the tolerance lead far away.
    """
    from scipy.spatial import KDTree

    different, first, places = np.unique(points, axis=0, return_index=True, return_inverse=True)
    places = places.ravel()
    tree = KDTree(different)
    count, most = len(different), most_pairs(len(different))
    if tree.count_neighbors(tree, tolerance) - count > 2 * most:  # each pair from both sides
        raise InputError(
            "too many points lie within the tolerance that welds them",
            got=f"{tolerance:.3g}",
            expected=f"at most {most} pairs of points so near to each other",
            remedy="a smaller weld",
        )
    group = find_components(tree.query_pairs(tolerance, output_type="ndarray"), count)
    leader = np.full(int(group.max()) + 1, len(points))
    np.minimum.at(leader, group, first)
    far = np.abs(different - points[leader[group]]).max(axis=1) > 3 * tolerance
    if far.any():
        raise InputError(
            "points lie in a line, each within the tolerance of the next",
            where=f"({different[np.argmax(far)][0]:.6g}, {different[np.argmax(far)][1]:.6g})",
            got=f"weld = {tolerance:.3g}",
            remedy="a smaller weld",
        )
    return np.asarray(leader[group][places])
