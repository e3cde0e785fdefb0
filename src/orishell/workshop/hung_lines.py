"""Lines on panels along which other parts hang on the sheet: as they are drawn, with their names.

On a board a line ends where the board does. Words keep to the larger part of a board, beside it.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.document import Document, Part
from orishell.motion.quads import signed_areas
from orishell.numerics.arrays import Array, Integers
from orishell.workshop.creases import mean_edge
from orishell.workshop.fitted_words import label_edges
from orishell.workshop.palettes import Line, Text

LETTERS = {1: " T", -1: " B"}
"""What follows a name on what is seen from one side only."""
LARGEST = 0.06
"""Height of names at most, as a share of the mean edge."""
ROOM = 1.5
"""Heights of a name that it takes beside its line."""


@record
class Hung:
    """Lines on outlines (N, K, 2) that are cut, convex and counter-clockwise."""

    lines: tuple[tuple[Line, ...], ...]  # on each
    texts: tuple[tuple[Text, ...], ...]
    clear: Array  # the largest part (N, C, 2) of what other words keep to, beside lines
    taken: Array  # the width (N,) that names take along the sides of that

    @classmethod
    def on(
        cls,
        document: Document,
        outlines: Array,
        panels: Integers,
        side: int | None = None,
        words: Array | None = None,
    ) -> Hung:
        """Lines on outlines that are of panels (N,).

        side: The face that is drawn, mirrored about the y axis if that is -1; None for those of
            both faces, seen from above.
        words: What other words keep to (N, K, 2), as outlines are; None for these.
        """
        lines: list[tuple[Line, ...]] = [()] * len(outlines)
        texts: list[tuple[Text, ...]] = [()] * len(outlines)
        room, taken = outlines if words is None else words, np.zeros(len(outlines))
        found = document.hung
        of, at = _meeting(document, panels, side)
        if found is None or not len(of):
            return cls(tuple(lines), tuple(texts), room, taken)
        clear, parts, drawn = [*room], [], []
        for board, line in zip(at.tolist(), found.ends[of] * _mirror(side), strict=True):
            parts.append(_larger_part(outlines[board], line))
            clear[board] = _larger_part(clear[board], line)
            drawn.append(_clipped(outlines[board], line))
            lines[board] += (Line("ENGRAVE", drawn[-1]),)
        called = [found.names[k] for k in of.tolist()]
        if side is None:
            called = [name + LETTERS[k] for name, k in zip(called, found.sides[of], strict=True)]
        most = LARGEST * mean_edge(document)
        ends = np.stack(drawn)
        names = label_edges(tuple(called), _padded(parts), ends, tall=ROOM, most=most, usual=100)
        np.maximum.at(taken, at, ROOM * names.heights)
        shown = names.heights > 0
        for board, text in zip(at[shown].tolist(), names.of(shown), strict=True):
            texts[board] += (text,)
        return cls(tuple(lines), tuple(texts), _padded(clear), taken)


def said_of_lines(document: Part) -> tuple[str, ...]:
    """What a title block says of them; nothing where there are none."""
    return () if document.hung is None else ("Lines with a name: what it names is hinged there",)


def hung_lines(document: Part, panels: Integers, side: int) -> tuple[Line, ...]:
    """Lines of a face of the sheet from edge to edge of its panels (P,)."""
    if document.hung is None:
        return ()
    of, _ = _meeting(document, panels, side)
    return tuple(Line("ENGRAVE", each) for each in document.hung.ends[of] * _mirror(side))


def _meeting(document: Part, panels: Integers, side: int | None) -> tuple[Integers, Integers]:
    """Lines (L,) of a face that are on panels (P,), and the places (L,) of these."""
    found, none = document.hung, np.zeros(0, np.int64)
    if found is None:
        return none, none
    place = np.full(len(document.mesh.faces), -1)
    place[panels] = np.arange(len(panels))
    there = place[found.panels] >= 0
    if side is not None:
        there &= found.sides == side
    of = np.flatnonzero(there)
    return of, place[found.panels[of]]


def _mirror(side: int | None) -> Array:
    return np.array([-1.0 if side == -1 else 1.0, 1.0])


def _away(outline: Array, line: Array) -> Array:
    """How far (K,) corners are to the left of a line, by its length."""
    along, to = line[1] - line[0], outline - line[0]
    return np.asarray(along[0] * to[:, 1] - along[1] * to[:, 0])


def _larger_part(outline: Array, line: Array) -> Array:
    """The larger part (k, 2) of a convex outline (K, 2) beside a line that runs through it."""
    away = _away(outline, line)
    first, second = _left_of(outline, away), _left_of(outline, -away)
    return first if signed_areas(first) >= signed_areas(second) else second


def _left_of(outline: Array, away: Array) -> Array:
    """What (k, 2) of a convex outline (K, 2) is left of a line, its corners being so far ``away``.

    One point of it where that is nothing.
    """
    kept = []
    for k in range(len(outline)):
        before, here = away[k - 1], away[k]
        if (before < 0) != (here < 0):
            kept.append(outline[k - 1] + before / (before - here) * (outline[k] - outline[k - 1]))
        if here >= 0:
            kept.append(outline[k])
    return np.array(kept or [outline[0]])


def _clipped(outline: Array, line: Array) -> Array:
    """The ends (2, 2) of what of a line is within a convex outline (K, 2)."""
    side = np.roll(outline, -1, axis=0) - outline
    along = line[1] - line[0]
    rate = side[:, 0] * along[1] - side[:, 1] * along[0]
    at = line[0] - outline
    inside = side[:, 0] * at[:, 1] - side[:, 1] * at[:, 0]
    enters = -inside[rate > 0] / rate[rate > 0]
    leaves = -inside[rate < 0] / rate[rate < 0]
    first, last = enters.max(initial=0.0), leaves.min(initial=1.0)
    return np.asarray(line[0] + np.array([[first], [max(first, last)]]) * along)


def _padded(outlines: list[Array]) -> Array:
    """Outlines as one array, the last corner of those with fewer corners repeated."""
    most = max(map(len, outlines))
    return np.stack(
        [np.pad(each, ((0, most - len(each)), (0, 0)), mode="edge") for each in outlines]
    )
