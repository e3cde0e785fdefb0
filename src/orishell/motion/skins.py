"""A second skin under a sheet on a lattice, and walls between both.

The staircase of the sheet, moved by (-d, d) in coordinates of its lattice, is a staircase below it,
which the sheet carries as it does its own panels. Two places, one on each, differ by d or more in
one of both coordinates: so panels of both skins are nowhere nearer than parallel panels of d
between them are, as far as what is between the planes of columns goes. A wall goes from the middle
of what faces of two parallel panels, along the other direction of the lattice. All that is joined
here are segments of a lattice, which have no place in common but where they are joined; its
directions are never parallel before a crease is shut. So nothing meets between two columns, nor
with what is on the other side of one.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.conventions.record import record
from orishell.motion.carried import Carried, Hanging, Lines
from orishell.motion.lattice import FALLING, RISING, Lattice, OnLattice
from orishell.motion.mechanism import Mechanism
from orishell.numerics.arrays import Array, Integers

ROOM = 0.2
"""A wall stands where panels of both skins face each other over this share of one's edge."""
HALF = 0.5
"""Where nobody says how far, a skin is moved by this share of the shortest edge."""
SLIVER = 1e-6
"""What is left of an edge is nothing if it is this share of it."""
OUTER, INNER = 0, 1
"""Parts of a sheet with a second skin: its own panels, and those of the second."""


@record
class Wall:
    """Where a wall may stand: between a row of panels and the strip of the other skin below it."""

    row: int  # of panels of the sheet
    strip: int  # of the second skin
    outer: Array  # its place (2,) on the sheet
    inner: Array  # and on the other skin


@record
class Skin:
    """The staircase of a second skin on the lattice of a sheet."""

    sheet: Mechanism
    lattice: Lattice
    columns: slice  # of vertices of the sheet
    shift: float  # how far it is from the sheet's, along both directions (length)
    places: Array  # of its lines (K, 2); fewer than two where there is no room for any
    parallel: Integers  # rows (K-1,) of panels of the sheet that its strips are parallel to

    @classmethod
    def under(cls, sheet: Mechanism, columns: slice, gap: float | None) -> Skin:
        """The skin that is at its target nowhere nearer to a sheet than a gap (length).

        Without one it is moved by half of the shortest edge.

        Where the sheet rises from an end, by more than both are apart, the skin ends at the height
        of that end; else it ends where the sheet does.

        Parameters
        ----------
        sheet
            One on a lattice.
        """
        assert isinstance(sheet, OnLattice)
        lattice = sheet.lattice()
        points = sheet.positions(sheet.target_drive)[:, columns]
        shift = HALF * float(lattice.lengths.min())
        if gap is not None:
            shift = gap / float(lattice.distances(points).min())
        places = lattice.places + np.array([-shift, shift])
        parallel = np.arange(len(places) - 1)
        places, parallel = _begun(lattice.places, places, parallel, shift)
        # Seen from the other end both coordinates change places.
        other = _turned(lattice.places, lattice.places)
        places, parallel = _begun(other, _turned(places, lattice.places), parallel[::-1], shift)
        return cls(sheet, lattice, columns, shift, _turned(places, other), parallel[::-1])

    def walls(self) -> tuple[Wall, ...]:
        """Where walls may stand, in the order of rows of panels."""
        found = []
        for strip, row in enumerate(self.parallel.tolist()):
            kind = int(self.lattice.kinds[row])
            outer, inner = self.lattice.places[row : row + 2], self.places[strip : strip + 2]
            low, high = max(outer[0, kind], inner[0, kind]), min(outer[1, kind], inner[1, kind])
            if high - low < ROOM * self.lattice.lengths[row]:
                continue
            ends = outer[0].copy(), inner[0].copy()
            for each in ends:
                each[kind] = 0.5 * (low + high)
            found.append(Wall(row, strip, *ends))
        return tuple(found)

    def distances(self) -> tuple[float, float]:
        """The smallest and the largest distance of panels that face each other at the target."""
        points = self.sheet.positions(self.sheet.target_drive)[:, self.columns]
        found = self.shift * self.lattice.distances(points)
        return float(found.min()), float(found.max())

    def carried(self, walls: Sequence[Wall]) -> tuple[Carried, ...]:
        """The second skin, and its walls."""
        down = np.diff(self.places, axis=0).sum(axis=1) / self.lattice.lengths[self.parallel]
        skin = self._strips(self.places, self.parallel, down, (), ())
        before: list[Wall | None] = [None, *walls]
        return skin, *map(self._wall, walls, before)

    def _wall(self, wall: Wall, before: Wall | None) -> Carried:
        """A wall, with the cell between it and the one before."""
        row, count = wall.row, len(self.lattice.lengths)
        rising = self.lattice.kinds[row] == RISING
        # From its upper line to the lower one in the flat sheet, as panels of the sheet.
        places = np.stack([wall.outer, wall.inner] if rising else [wall.inner, wall.outer])
        parallel = row + 1 if row + 1 < count else row - 1
        hung = (
            self._hanging(wall, 0 if rising else 1, OUTER),
            self._hanging(wall, 1 if rising else 0, INNER),
        )
        down = np.array([self.shift / self.lattice.lengths[parallel]])
        cells = () if before is None else (self._cell(before, wall),)
        return self._strips(places, np.array([parallel]), down, hung, cells)

    def _hanging(self, wall: Wall, line: int, part: int) -> Hanging:
        """Where one of its lines hangs: on the sheet, or on the other skin."""
        kind, panels = self.lattice.kinds[wall.row], wall.strip if part else wall.row
        places = self.places if part else self.lattice.places
        first, last = places[panels : panels + 2, kind]
        at = ((wall.inner if part else wall.outer)[kind] - first) / (last - first)
        count = self.columns.stop - self.columns.start
        return Hanging(line, part, panels, wall.row, np.full(count, at))

    def _cell(self, before: Wall, wall: Wall) -> Lines:
        """Lines around the cavity between two walls."""
        outer = self.lattice.places[before.row + 1 : wall.row + 1]
        inner = self.places[before.strip + 1 : wall.strip + 1]
        ring = [before.outer, *outer, wall.outer, wall.inner, *inner[::-1], before.inner]
        return self.lattice.lines(self.columns, np.array(ring))

    def _strips(
        self,
        places: Array,
        parallel: Integers,
        down: Array,
        hung: tuple[Hanging, ...],
        cells: tuple[Lines, ...],
    ) -> Carried:
        """Strips between places (K, 2), whose edges are so long by those that they are parallel to.

        Their creases are given by the longest of the sheet between two columns.
        """
        lines = self.lattice.lines(self.columns, places)
        flat = self.sheet.positions(0.0)
        longest = np.linalg.norm(np.diff(flat[:, self.columns], axis=1), axis=-1).max(axis=0)
        widths = np.linalg.norm(np.diff(lines.carried(flat), axis=1), axis=-1) / longest
        count = self.columns.stop - self.columns.start
        return Carried(
            sheet=self.sheet,
            lines=lines,
            parallel=parallel,
            down=np.repeat(down[:, None], count, axis=1),
            widths=widths,
            between=self.lattice.between(places),
            hung=hung,
            cells=cells,
        )


def _turned(places: Array, of: Array) -> Array:
    """Places seen from the other end of a staircase, from there on."""
    return np.asarray((of[-1] - places)[::-1, ::-1])


def _begun(sheet: Array, places: Array, parallel: Integers, shift: float) -> tuple[Array, Integers]:
    """A staircase (K, 2) that is cut off before the beginning of another's (R, 2).

    It begins no lower than that where the other rises from there on the whole: by more than both
    are apart, and without going down as far before. None of it is left if all of it is before.

    shift: How far it is from the other, along both directions (length).
    """
    if not len(places):
        return places, parallel
    own = places - sheet[0]
    heights = sheet[:, RISING] - sheet[:, FALLING]
    middles = 0.5 * (heights[:-1] + heights[1:])
    crown, slack = int(np.argmax(middles)), 2 * shift
    least, top = own[:, RISING], len(own) - 1
    if middles[crown] - middles[0] > slack > middles[0] - middles[: crown + 1].min():
        rises = own[:, RISING] - own[:, FALLING]
        least, top = np.minimum(least, rises), int(np.argmax(rises))
    low = np.flatnonzero(least[: top + 1] < 0)
    if not len(low):
        return places, parallel
    last = int(low[-1])
    if last == top:
        return places[:0], parallel[:0]
    # The edge from there on rises.
    begin = places[last].copy()
    begin[RISING] -= least[last]
    left = places[last + 1, RISING] - begin[RISING]
    if left <= SLIVER * (places[last + 1, RISING] - places[last, RISING]):
        return places[last + 1 :], parallel[last + 1 :]
    return np.concatenate([begin[None], places[last + 1 :]]), parallel[last:]
