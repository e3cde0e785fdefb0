"""What boards are cut from: sheets of one thickness and one material for each kind of them."""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.design import PanelSpec
from orishell.document import Part
from orishell.numerics.arrays import Integers


@record
class BoardStock:
    """Boards of one thickness and one material, which are cut from the same sheets."""

    kind: str  # of the parts that have it alone; "" for that of the sheet
    build: PanelSpec  # what its panels are made of
    material: str  # as of their parts
    boards: Integers  # their numbers in :func:`~orishell.workshop.assembly.laid_flat`

    @property
    def thickness(self) -> float:
        """Of each board (length)."""
        return self.build.board

    @property
    def of(self) -> str:
        """Of what, for one line: " of steel"; empty where nobody says."""
        return f" of {self.material}" if self.material else ""


def stocks_of_boards(document: Part) -> tuple[BoardStock, ...]:
    """The stocks of all boards, that of the sheet first; none without boards."""
    firsts: dict[tuple[float, str], tuple[str, PanelSpec]] = {}
    numbers: dict[tuple[float, str], list[Integers]] = {}
    count = 0
    for number, part in enumerate(document.parts):
        if part.boards is None or part.panel is None:
            continue
        key = part.panel.board, part.material
        firsts.setdefault(key, (part.kind if number else "", part.panel))
        numbers.setdefault(key, []).append(count + np.arange(len(part.boards)))
        count += len(part.boards)
    return tuple(
        BoardStock(kind, build, key[1], np.concatenate(numbers[key]))
        for key, (kind, build) in firsts.items()
    )


def stock_of_part(document: Part, part: Part) -> BoardStock | None:
    """The stock of its own that a part's boards are cut from; None if it has none."""
    if part.boards is None or part.panel is None:
        return None
    own = part.panel.board, part.material
    others = stocks_of_boards(document)[1:]
    return next((each for each in others if (each.thickness, each.material) == own), None)
