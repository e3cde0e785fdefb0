"""A second skin under a sheet on a lattice, and walls between both.

Any staircase along both directions of the lattice is carried by the sheet as its own panels are:
its own, moved by (-d, d) in coordinates of the lattice, or that of another curve. If it is below,
two places, one on each, differ by a d > 0 or more in one of both coordinates: so panels of both
skins are nowhere nearer than parallel panels of d between them are, as far as what is between the
planes of columns goes. A wall goes from the middle of what faces of two parallel panels, along the
other direction of the lattice. All that is joined here are segments of a lattice, which have no
place in common but where they are joined; its directions are never parallel before a crease is
shut. So nothing meets between two columns, nor with what is on the other side of one.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.conventions.record import record
from orishell.motion.carried import Carried, Hanging, Lines
from orishell.motion.lattice import FALLING, RISING, Lattice, OnLattice
from orishell.motion.mechanism import Mechanism
from orishell.motion.second_skin import HALF, INNER, OUTER, ROOM, SLIVER, Wall
from orishell.numerics.arrays import Array, Integers

JOINED_AT = 0.5
"""It is joined to the sheet at this share of the target's drive: flat, one lies on the other."""


@record
class Skin:
    """The staircase of a second skin on the lattice of a sheet."""

    sheet: Mechanism
    lattice: Lattice
    columns: slice  # of vertices of the sheet
    # by how much places on it and on the sheet's differ in one coordinate at least, as far as it is
    # below that; by less than nothing where it is not (length)
    shift: float
    places: Array  # of its lines (K, 2); fewer than two where there is no room for any
    parallel: Integers  # rows (K-1,) of panels of the sheet that its strips are parallel to
    # whether its staircase is that of the sheet, moved: walls are between rows and strips that were
    # one then
    moved: bool = True

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
        return cls(sheet, lattice, columns, shift, *_between_ends(lattice, places, parallel, shift))

    @classmethod
    def along(cls, sheet: Mechanism, columns: slice, places: Array) -> Skin:
        """The skin whose staircase has places (K, 2) on the lattice of a sheet.

        It ends as one does that is moved.

        Parameters
        ----------
        sheet
            One on a lattice.
        """
        assert isinstance(sheet, OnLattice)
        lattice = sheet.lattice()
        kinds, middles = lattice.kinds, 0.5 * (lattice.places[1:] + lattice.places[:-1])
        own = 0.5 * (places[1:] + places[:-1])
        away = np.abs(own[:, None] - middles).sum(axis=-1)
        other = np.diff(places, axis=0).argmax(axis=1)[:, None] != kinds
        parallel = np.where(other, np.inf, away).argmin(axis=1)
        slack = 0.5 * float(lattice.lengths.mean())
        places, parallel = _between_ends(lattice, places, parallel, slack)
        apart = _apart(lattice.places, places)
        return cls(sheet, lattice, columns, apart, places, parallel, moved=False)

    @property
    def names(self) -> Integers:
        """Numbers that its strips (K-1,) are called by: of the sheet's rows, if it is moved."""
        return self.parallel if self.moved else np.arange(len(self.parallel))

    @property
    def joined_at(self) -> float:
        """The share of the target's drive from which on there is room for it."""
        return JOINED_AT

    @property
    def too_far(self) -> str:
        """How far it is from the sheet against how far it may be, in words."""
        return f"it is {self.shift:.4g} along edges of {self.lattice.lengths.max():.4g} at the most"

    def walls(self) -> tuple[Wall, ...]:
        """Where walls may stand, in the order of rows of panels; none crosses another one."""
        found: list[Wall] = []
        for row in range(len(self.lattice.lengths)):
            wall = self._wall_of(row)
            if wall is not None and not any(_cross(wall, each) for each in found):
                found.append(wall)
        return tuple(found)

    def _wall_of(self, row: int) -> Wall | None:
        """Between a row of panels and the strip that it faces most; None if it faces none enough.

        Both cross the line from its middle along the other direction nowhere else.
        """
        kind = int(self.lattice.kinds[row])
        alike = self.parallel == row if self.moved else self.lattice.kinds[self.parallel] == kind
        mine = np.flatnonzero(alike)
        if not len(mine):
            return None
        outer, inner = self.lattice.places[row : row + 2], self.places
        low = np.maximum(outer[0, kind], inner[mine, kind])
        high = np.minimum(outer[1, kind], inner[mine + 1, kind])
        most = int(np.argmax(high - low))
        if (high - low)[most] < ROOM * self.lattice.lengths[row]:
            return None
        strip = int(mine[most])
        ends = outer[0].copy(), inner[strip].copy()
        for each in ends:
            each[kind] = 0.5 * (low[most] + high[most])
        return Wall(row, strip, *ends)

    def distances(self) -> tuple[float, float]:
        """How far panels of both are apart at the target at least, and those at walls at most."""
        points = self.sheet.positions(self.sheet.target_drive)[:, self.columns]
        found = self.lattice.distances(points)
        most = [_length(wall) * found[:, 1 - self.lattice.kinds[wall.row]] for wall in self.walls()]
        least = self.shift * float(found.min())
        return least, float(np.max(most, initial=least))

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
        down = np.array([_length(wall) / self.lattice.lengths[parallel]])
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


def _length(wall: Wall) -> float:
    """How long a wall is along the lattice (length)."""
    return float(np.abs(wall.outer - wall.inner).max())


def _turned(places: Array, of: Array) -> Array:
    """Places seen from the other end of a staircase, from there on."""
    return np.asarray((of[-1] - places)[::-1, ::-1])


def _cross(first: Wall, second: Wall) -> bool:
    """Whether two walls have a place in common."""
    low = [np.minimum(each.outer, each.inner) for each in (first, second)]
    high = [np.maximum(each.outer, each.inner) for each in (first, second)]
    return bool((np.maximum(*low) <= np.minimum(*high)).all())


def _apart(outer: Array, inner: Array) -> float:
    """By how much places on two staircases (R, 2) and (K, 2) differ in one coordinate at least.

    As far as the second is below the first; not above nothing where it is not.
    """
    first = outer[:-1, None, RISING] - inner[1:, RISING]
    second = inner[:-1, FALLING] - outer[1:, None, FALLING]
    return float(np.maximum(first, second).min(initial=np.inf))


def _between_ends(
    lattice: Lattice, places: Array, parallel: Integers, shift: float
) -> tuple[Array, Integers]:
    """A staircase (K, 2) that is cut off beyond both ends of a sheet's: see :func:`_begun`."""
    sheet = lattice.places
    places, parallel = _begun(sheet, places, parallel, shift)
    # Seen from the other end both coordinates change places.
    other = _turned(sheet, sheet)
    places, parallel = _begun(other, _turned(places, sheet), parallel[::-1], shift)
    return _turned(places, other), parallel[::-1]


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
