"""What to order of base rails: bars as long as from foot to foot."""

from __future__ import annotations

import numpy as np

from orishell.structure.model import Model
from orishell.structure.rail import mass_by_length
from orishell.workshop.order_row import OrderRow


def rail_order(model: Model) -> tuple[OrderRow, ...]:
    """The line of the order for base rails; none without them."""
    asked, unit = model.structure.rail, model.site.unit
    if asked is None:
        return ()
    lengths = np.concatenate([rail.lengths for rail in model.rails])
    used = float(lengths.sum())
    row = OrderRow(
        item="base rail",
        what=f"{len(lengths)} bars, {asked.in_words(unit)}",
        count=None,
        least=None,
        size=(),
        unit=unit,
        used=used,
        waste=None,
        mass_kg=used * mass_by_length(asked, unit),
        price=None,
    )
    return (row,)
