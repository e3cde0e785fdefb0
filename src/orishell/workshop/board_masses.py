"""What boards weigh, each by what its part is made of."""

from __future__ import annotations

import numpy as np

from orishell.conventions.quantities import conversion
from orishell.document import Part
from orishell.numerics.arrays import Array, Integers
from orishell.workshop.assembly import laid_flat


def densities_of_boards(document: Part) -> Array:
    """Density (B,) of all boards of :func:`~orishell.workshop.assembly.laid_flat`; 0 if unknown."""
    found = [
        np.full(len(part.boards), part.panel.density)
        for part in document.parts
        if part.boards is not None and part.panel is not None
    ]
    return np.concatenate([np.zeros(0), *found])


def mass_of_boards(document: Part, numbers: Integers | None = None) -> float | None:
    """Mass of all boards, or of some, arms left out (kg); None if a density is not known.

    Parameters
    ----------
    numbers
        Which of :func:`~orishell.workshop.assembly.laid_flat`; all if None.
    """
    boards, densities = laid_flat(document).boards, densities_of_boards(document)
    assert boards is not None
    chosen = (
        ~boards.arms if numbers is None else ~boards.arms & np.isin(range(len(boards)), numbers)
    )
    volumes, own = boards.volumes()[chosen], densities[chosen]
    cubic = conversion(document.unit, "m") ** 3
    each = [cubic * float(volumes[own == one].sum()) * one for one in np.unique(own).tolist()]
    return (sum(each) or None) if all(each) else None
