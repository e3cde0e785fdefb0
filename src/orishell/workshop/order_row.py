"""One line of an order, and how the verdict says it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.conventions.row import Row


@record
class OrderRow:
    """One line of the order; lengths and areas in the document's unit, None where not known."""

    item: str  # what it is for: "boards", "membrane", "sheet", "arms", "ties", "base rail", a hinge
    what: str  # in words, with its thickness
    count: int | None  # how many sheets, rolls, bars or coils; None if nobody says how it is sold
    least: int | None  # how few would do at least, where it is proved that fewer cannot
    size: tuple[float, ...]  # of one: width and height, or length; empty if nobody says
    unit: str  # of what is used: "m2" for areas, "m" for lengths
    used: float  # area or length of all parts
    waste: float | None  # share of what is ordered that is not used
    mass_kg: float | None  # of the parts
    price: float | None  # of all that is ordered

    def in_words(self) -> str:
        """What is ordered, for one line; empty if nobody says how it is sold."""
        if self.count is None or self.waste is None:
            return ""
        sides = " x ".join(plain(side, 3) for side in self.size)
        length = self.unit.removesuffix("2")
        lost = f"{plain(100 * self.waste, 2)} % waste{self._bound()}"
        return f"{self.count} {self.what} of {sides} {length} for {self.item} ({lost})"

    def _bound(self) -> str:
        """How few would do at least, for one line; nothing of one."""
        if self.count is None or self.count < 2 or self.least is None:
            return ""
        pieces = "parts of these areas" if self.unit.endswith("2") else "pieces of these lengths"
        few = "no fewer" if self.least == self.count else f"at least {self.least}"
        return f"; {pieces} take {few}"


def order_in_words(order: Sequence[OrderRow]) -> Iterator[Row]:
    """A row of the verdict that says what to order, where it is known how it is sold."""
    rows = [text for row in order if (text := row.in_words())]
    if rows:
        yield Row("says", "order", "; ".join(rows))
