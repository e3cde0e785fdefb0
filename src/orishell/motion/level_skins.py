"""A second skin straight below a sheet whose rows stay level, and upright walls between both.

Whatever is moved straight down by a height that stays is rigid as it was. A level line across a row
of panels, and the same line so far below, are the sides of upright rectangles: a wall, which only
turns about upright lines. So nothing is asked of slopes, and all of it is there in every state, the
open one among them. If edges go on along their axis, the second skin is below the sheet as long as
no panel is upright, and two walls of one column are side by side: nothing meets between two
columns, nor with what is on the other side of one's upright plane.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.record import record
from orishell.motion.carried import Carried, Hanging, Lines
from orishell.motion.grid import CreaseValues
from orishell.motion.mechanism import Mechanism, panel_normals
from orishell.motion.second_skin import HALF, INNER, OUTER, ROOM, SLIVER, Wall
from orishell.numerics.arrays import Array, Integers


@record
class LevelSkin:
    """The image of a sheet, straight below it.

    Places along columns are numbers of rows of vertices, with shares of the edges in between.
    """

    sheet: Mechanism
    columns: slice  # of vertices of the sheet
    shift: float  # how far below the sheet it is (length)
    places: Array  # of its lines (K,); fewer than two where there is no room for any

    @classmethod
    def under(cls, sheet: Mechanism, columns: slice, gap: float | None) -> LevelSkin:
        """The skin that is at its target nowhere nearer to a sheet than a gap (length).

        Without one it is moved by half of the shortest edge of its first column. Where the sheet
        rises from an end the skin ends at the height of that end at the target; else it ends where
        the sheet does.

        Parameters
        ----------
        sheet
            One whose rows stay level, as high in every column.
        """
        points = sheet.positions(sheet.target_drive)[:, columns]
        edges = np.diff(points[:, 0], axis=0)
        shift = HALF * float(np.linalg.norm(edges, axis=-1).min())
        if gap is not None:
            shift = gap / float(_uprightness(points).min())
        return cls(sheet, columns, shift, _between_ends(points[:, 0, 2], shift))

    @property
    def parallel(self) -> Integers:
        """Rows (K-1,) of panels of the sheet that its strips are parallel to."""
        return np.floor(0.5 * (self.places[1:] + self.places[:-1])).astype(np.int64)

    @property
    def names(self) -> Integers:
        """Numbers that its strips (K-1,) are called by: of the sheet's rows."""
        return self.parallel

    @property
    def moved(self) -> bool:
        """Always: it is the sheet's own image."""
        return True

    @property
    def joined_at(self) -> float:
        """From the beginning: there is room for it in every state."""
        return 0.0

    @property
    def too_far(self) -> str:
        """How far it is from the sheet against how far it may be, in words."""
        heights = self._heights()
        rise = float(heights.max() - max(heights[0], heights[-1]))
        return f"it is {self.shift:.4g} below a shell that rises by {rise:.4g} from its feet"

    def walls(self) -> tuple[Wall, ...]:
        """Where walls may stand: in the middle of what is there of both panels."""
        found = []
        for strip, row in enumerate(self.parallel.tolist()):
            low, high = self.places[strip : strip + 2]
            if high - low >= ROOM:
                at = np.array([0.5 * (low + high)])
                found.append(Wall(row, strip, at, at))
        return tuple(found)

    def distances(self) -> tuple[float, float]:
        """How far panels of both are apart at the target at least, and those at walls at most."""
        points = self.sheet.positions(self.sheet.target_drive)[:, self.columns]
        apart = self.shift * _uprightness(points)
        rows = [wall.row for wall in self.walls()]
        least = float(apart.min())
        return least, float(apart[rows].max(initial=least))

    def carried(self, walls: Sequence[Wall]) -> tuple[Carried, ...]:
        """The second skin, and its walls."""
        below = self._lines(self.places, -self.shift)
        rows = self.parallel
        skin = Carried(
            sheet=self.sheet,
            lines=below,
            parallel=rows,
            down=self._everywhere(np.diff(self.places)),
            widths=self._widths(below),
            between=np.stack([rows, rows + 1], axis=-1),
            hung=(),
            cells=(),
        )
        before: list[Wall | None] = [None, *walls]
        return skin, *map(self._wall, walls, before)

    def _wall(self, wall: Wall, before: Wall | None) -> UprightStrip:
        """A wall, from the sheet down, with the cell between it and the one before."""
        lines = Lines.joined([self._lines(wall.outer, 0.0), self._lines(wall.inner, -self.shift)])
        first, last = self.places[wall.strip : wall.strip + 2]
        shares = wall.outer - wall.row, (wall.inner - first) / (last - first)
        on_sheet, on_skin = (self._everywhere(each)[0] for each in shares)
        return UprightStrip(
            sheet=self.sheet,
            lines=lines,
            parallel=np.array([wall.row]),
            down=self._everywhere(np.zeros(1)),
            widths=self._widths(lines),
            between=np.array([[wall.row, wall.row + 1]]),
            hung=(
                Hanging(0, OUTER, wall.row, wall.row, on_sheet),
                Hanging(1, INNER, wall.strip, wall.row, on_skin),
            ),
            cells=() if before is None else (self._cell(before, wall),),
        )

    def _cell(self, before: Wall, wall: Wall) -> Lines:
        """Lines around the cavity between two walls."""
        above = np.arange(before.row + 1, wall.row + 1)
        places = np.concatenate([before.outer, above, wall.outer])
        lines = self._lines(places, 0.0), self._lines(places[::-1], -self.shift)
        return Lines.joined([*lines])

    def _lines(self, places: Array, up: float) -> Lines:
        """Lines of vertices at places (K,), so far above the sheet."""
        rows = np.minimum(np.floor(places).astype(np.int64), self.sheet.grid.rows - 2)
        shares = self._everywhere(places - rows)
        return Lines(self.columns, rows, rows[None], shares[None], np.full(len(rows), up))

    def _everywhere(self, values: Array) -> Array:
        """Values (K,) in all columns (K, n)."""
        return np.repeat(values[:, None], self.columns.stop - self.columns.start, axis=1)

    def _widths(self, lines: Lines) -> Array:
        """Lengths (K, n-1) of edges along lines, by the longest of the sheet between columns."""
        points = self.sheet.positions(0.0)
        longest = np.linalg.norm(np.diff(points[:, self.columns], axis=1), axis=-1).max(axis=0)
        own = np.linalg.norm(np.diff(lines.carried(points), axis=1), axis=-1)
        return np.asarray(own / longest)

    def _heights(self) -> Array:
        """Heights (R,) of the sheet's rows at the target."""
        return self.sheet.positions(self.sheet.target_drive)[:, self.columns.start, 2]


@record
class UprightStrip(Carried):
    """A row of upright rectangles between two level lines, the first above the second."""

    def fold_angles(self, drive: ArrayLike) -> CreaseValues:
        """Fold angles of its creases: by how much it turns about upright lines."""
        along = np.diff(self.positions(drive)[..., 0, :, :2], axis=-2)
        before, after = along[..., :-1, :], along[..., 1:, :]
        turn = np.arctan2(
            before[..., 1] * after[..., 0] - before[..., 0] * after[..., 1],
            (before * after).sum(axis=-1),
        )[..., None, :]
        return CreaseValues(np.zeros((*turn.shape[:-2], 0, self.grid.columns - 1)), turn)

    def hung_folds(self, hanging: Hanging, drive: ArrayLike) -> Array:
        """Angles (..., n-1) between its panels and those of the row that they hang on."""
        sheet = self.sheet.positions(drive)[..., hanging.parallel : hanging.parallel + 2, :, :]
        normals = panel_normals(sheet[..., self.columns, :])[..., 0, :, :]
        own = panel_normals(self.positions(drive))[..., 0, :, :]
        return np.asarray(np.arccos((normals * own).sum(axis=-1)))


def _uprightness(points: Array) -> Array:
    """What panels (R-1, n-1) between vertices (R, n, 3) are apart from their image 1 below."""
    return np.abs(panel_normals(points)[..., 2])


def _between_ends(heights: Array, shift: float) -> Array:
    """Places (K,) of lines of an image that is cut off at the heights of both ends of a sheet."""
    last = len(heights) - 1
    begin, end = _begun(heights, shift), last - _begun(heights[::-1], shift)
    if begin >= end:
        return np.zeros(0)
    inner = np.arange(np.floor(begin) + 1, np.ceil(end))
    return np.concatenate([[begin], inner, [end]])


def _begun(heights: Array, shift: float) -> float:
    """Where an image of rows at these heights (R,), so far below them, begins.

    No lower than the first row, if the others rise from there to the highest one without going down
    by as much as both are apart.
    """
    rises = heights - heights[0]
    crown = int(np.argmax(rises))
    if rises[: crown + 1].min() <= -shift or not crown:
        return 0.0
    low = np.flatnonzero(rises[: crown + 1] < shift)
    last = int(low[-1])
    if last == crown:
        return float(len(heights) - 1)
    share = float((shift - rises[last]) / (rises[last + 1] - rises[last]))
    return last + 1 if share > 1 - SLIVER else last + share
