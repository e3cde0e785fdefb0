"""Parts that a sheet carries all the way: strips of panels, the boards on them, and their names."""

from __future__ import annotations

from orishell.conventions.record import record
from orishell.design.hung import HungLines
from orishell.motion.boards import Boards
from orishell.motion.carried import Carried
from orishell.motion.grid import Panel
from orishell.numerics.arrays import Integers


@record
class CarriedPart:
    """Strips that move with the sheet, made as one piece."""

    strips: Carried
    title: str  # one line that says what it is
    kind: str  # what the booklet calls parts of its kind
    names: tuple[str, ...]  # of its panels, row by row
    # row and column of the panel of the sheet that each of its panels hangs on, or is beside
    hung_on: tuple[Panel, ...]
    borne_at: Integers  # rows and columns (K, 2) of the sheet's vertices that bear it
    hung: HungLines | None  # where it hangs on the sheet; None if it does not
    bears: HungLines | None = None  # where others hang on its own panels; None if none do
    boards: Boards | None = None  # as panels of its strips; None if panels have no thickness
    joined_from: float = 0.0  # the drive from which on it is joined to the sheet (radians)
