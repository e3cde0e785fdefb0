"""Bill of quantities: how much sheet, cut and crease a shell needs, and what it weighs."""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.conventions.units import conversion
from orishell.document import Document
from orishell.workshop import Workshop
from orishell.workshop.bill import PanelBill, measure_panels
from orishell.workshop.clipped import with_clipped
from orishell.workshop.layout import require_stock
from orishell.workshop.sheets import Waste, measure_waste


@record
class CreaseLength:
    """Length of all creases of a kind, in the document's unit.

    Parameters
    ----------
    mountain, valley, unfolded
        The kinds.
    """

    mountain: float
    valley: float
    unfolded: float


@record
class Quantities:
    """Totals of the sheet and its clipped boards; lengths and areas in the document's unit.

    Parameters
    ----------
    panels
        Number of panels.
    clipped
        How many of them are panels of boards that are clipped on at the target.
    area
        Area of all panels.
    crease_length
        Length of the creases by their assignment.
    outline_length
        Length of the outlines and of cuts within them.
    stock
        Sheets of stock for the sheet, or for panels that are solid, and what of them is not used;
        None if that was not asked for.
    mass_kg
        Mass of the panels; None if the areal density is not known.
    built
        Boards, membrane and hinges; None if panels have no thickness.
    """

    panels: int
    clipped: int
    area: float
    crease_length: CreaseLength
    outline_length: float
    stock: Waste | None
    mass_kg: float | None
    built: PanelBill | None = None


def measure_quantities(
    document: Document, workshop: Workshop, *, nested: bool = True
) -> Quantities:
    """The totals of a document for a workshop.

    Parameters
    ----------
    nested
        Whether the sheet is laid out on its stock, which takes most of the time.

    Raises
    ------
    InputError
        If only folded states are known, or a panel is larger than the stock.
    """
    everything = with_clipped(document)
    flat, edges = everything.require_flat(), everything.mesh.edges
    length = np.linalg.norm(flat[edges[:, 1]] - flat[edges[:, 0]], axis=1)
    letters = np.array(everything.assignment)

    def total(*which: str) -> float:
        return float(length[np.isin(letters, which)].sum())

    stock = None
    if nested or workshop.stock is None:
        stock = measure_waste(document, workshop)
    else:
        require_stock(everything, workshop)
    area = float(everything.areas().sum())
    in_metres = conversion(document.unit, "m")
    return Quantities(
        panels=len(everything.mesh.faces),
        clipped=len(everything.mesh.faces) - len(document.mesh.faces),
        area=area,
        crease_length=CreaseLength(total("M"), total("V"), total("F", "U", "J")),
        outline_length=total("B", "C"),
        stock=stock,
        mass_kg=area * in_metres**2 * workshop.areal_density or None,
        built=measure_panels(document, workshop, nested=nested),
    )
