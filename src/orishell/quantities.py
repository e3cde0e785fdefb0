"""Bill of quantities: how much sheet, cut and crease a shell needs, and what it weighs."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from orishell.document import Document
from orishell.units import conversion
from orishell.workshop import Workshop
from orishell.workshop.sheets import Waste, measure_waste


@dataclass(frozen=True, slots=True)
class Quantities:
    """Totals; lengths and areas in the document's unit.

    Parameters
    ----------
    panels
        Number of panels.
    area
        Area of all panels.
    mountain, valley, unfolded
        Length of the creases by their assignment.
    outline
        Length of the sheet's outline and of cuts in it.
    waste
        Sheets of stock, and what of them is not used.
    mass_kg
        Mass of the panels; None if the areal density is not known.
    """

    panels: int
    area: float
    mountain: float
    valley: float
    unfolded: float
    outline: float
    waste: Waste
    mass_kg: float | None


def measure_quantities(document: Document, workshop: Workshop) -> Quantities:
    """The totals of a document for a workshop.

    Parameters
    ----------
    document
        The sheet.
    workshop
        On what and how it is cut.

    Raises
    ------
    InputError
        If only folded states are known, or a panel is larger than the stock.
    """
    flat, edges = document.require_flat(), document.mesh.edges
    length = np.linalg.norm(flat[edges[:, 1]] - flat[edges[:, 0]], axis=1)
    letters = np.array(document.assignment)

    def total(*which: str) -> float:
        return float(length[np.isin(letters, which)].sum())

    area = float(document.areas().sum())
    in_metres = conversion(document.unit, "m")
    return Quantities(
        panels=len(document.mesh.faces),
        area=area,
        mountain=total("M"),
        valley=total("V"),
        unfolded=total("F", "U", "J"),
        outline=total("B", "C"),
        waste=measure_waste(document, workshop),
        mass_kg=area * in_metres**2 * workshop.areal_density or None,
    )


def describe_quantities(quantities: Quantities) -> dict[str, Any]:
    """The field ``quantities`` of the report.

    Parameters
    ----------
    quantities
        What was measured.
    """
    return {
        "panels": quantities.panels,
        "area": quantities.area,
        "crease_length": {
            "mountain": quantities.mountain,
            "valley": quantities.valley,
            "unfolded": quantities.unfolded,
        },
        "outline_length": quantities.outline,
        "stock": asdict(quantities.waste),
        "mass_kg": quantities.mass_kg,
    }
