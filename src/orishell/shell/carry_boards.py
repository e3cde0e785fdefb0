"""What a builder tries with the boards of a shell: other thicknesses, and other materials.

Only what is on the market: boards of a material by name are as thick as they are sold. Where the
file has its own values, nobody knows what is sold; what is too thick for a plate is left out.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence

import numpy as np

from orishell.conventions.formatting import rounded
from orishell.conventions.quantities import Quantities, conversion
from orishell.conventions.record import record
from orishell.design_file import DesignFile
from orishell.design_file.tables import value_at
from orishell.shell.carry_change import Change
from orishell.structure.case import CaseResult
from orishell.structure.materials import Material, materials
from orishell.structure.model import Model
from orishell.structure.plausibility import panel_widths
from orishell.structure.results import Analysis
from orishell.structure.verdict import LARGE_DISPLACEMENT, LEAST_BUCKLING

SOFT = 3.0
"""A shell that gives way is tried with panels so many times as thick, as nothing is known of it."""
MARGIN = 1.02
"""Panels are tried by so much thicker than the figures of the last trial ask for."""
THINNER = 0.95
"""Panels become thinner at least to this share of what they are."""
PLATE = 0.1
"""Panels thicker than this share of their width are no thin plates, as they are analysed."""
AREAL = "workshop.areal_density"
MATERIAL = "structure.material"


@record
class Offer:
    """Thicknesses that panels may have (length)."""

    sold: Sequence[float]  # rising; empty where nobody knows, and any up to the largest will do
    most: float  # the largest
    end: str  # why there is none beyond it

    def at_least(self, thickness: float) -> float:
        """The thinnest that is as thick, or the thickest that there is."""
        if not self.sold:
            return min(rounded(thickness, 2), self.most)
        return self.sold[min(bisect_left(self.sold, thickness), len(self.sold) - 1)]

    def at_most(self, thickness: float) -> float | None:
        """The thickest that is no thicker; None if there is none."""
        if not self.sold:
            return min(thickness, self.most)
        thinner = bisect_right(self.sold, thickness)
        return self.sold[thinner - 1] if thinner else None


def offer(file: DesignFile, model: Model, material: str | None = None) -> Offer:
    """How thick the panels of a file may be, of its own material or of another one.

    model: Of its shell, or of one with panels as wide.
    """
    said, name = Quantities(file.unit), material or named_material(file)
    if name is None:
        width = float(np.median(panel_widths(model)))
        end = f"more than a tenth of a panel's width of {said.displacement(width)} makes no plate"
        return Offer((), rounded(PLATE * width, 2), end)
    boards = [each / conversion(file.unit, "m") for each in materials()[name].sold]
    end = f"no thicker board of {name} is on the market ({said.displacement(boards[-1])})"
    membrane = 0.0
    if file.panel is not None and not file.panel.is_solid:
        # A board on each of its faces.
        boards, membrane = [2 * each for each in boards], file.panel.membrane
    sold = tuple(rounded(each + membrane, 6) for each in boards)
    return Offer(sold, sold[-1], end)


def named_material(file: DesignFile) -> str | None:
    """The material of the panels of a file, as it is sold; None if the file has its own make."""
    assert file.structure is not None
    own = value_at(file.tables, "structure.sandwich") is not None
    return None if own else file.structure.material


def thicker(file: DesignFile, found: Analysis) -> Iterator[Change]:
    """Panels as thick as figures ask for; where that is not to be had, the thickest, and why."""
    times = max(_times(case) for case in found.cases)
    needed, offered = MARGIN * times * found.model.thickness, offer(file, found.model)
    thickness = offered.at_least(needed)
    if thickness > found.model.thickness:
        yield as_thick(file, thickness)
    if times > 1 and needed > offered.most:
        beyond = as_thick(file, rounded(needed, 2))
        yield Change(beyond.values, beyond.said, offered.end)


def thinner(file: DesignFile, found: Analysis) -> Iterator[Change]:
    """Panels as thin as they may be if stress is as the square of thickness, buckling as its cube.

    That is on the safe side: the next thinner board on the market is tried, too. Only where both
    are known: of crease lines thickness says little.
    """
    shares = [case.equilibrium.utilisation for case in found.cases if case.equilibrium is not None]
    panels = max((each.panels or 0.0) for each in shares) ** 0.5
    buckles = (LEAST_BUCKLING * max((each.buckling or 0.0) for each in shares)) ** (1 / 3)
    moved = max(
        case.equilibrium.displacement.share / LARGE_DISPLACEMENT
        for case in found.cases
        if case.equilibrium is not None
    ) ** (1 / 3)
    times = max(panels, buckles, moved, 0.5)
    offered, most = offer(file, found.model), THINNER * found.model.thickness
    thinnest = offered.at_least(MARGIN * times * found.model.thickness)
    following = offered.at_most(most) if offered.sold else None
    for thickness in sorted({thinnest, following or thinnest}):
        if thickness <= most:
            yield as_thick(file, thickness)


def as_thick(file: DesignFile, thickness: float) -> Change:
    """Panels of a thickness, and as much heavier where the file says what they weigh by area."""
    key = thickness_key(file)
    said = f"panels {Quantities(file.unit).displacement(thickness)} thick"
    values = {key: thickness}
    areal = value_at(file.tables, AREAL)
    if areal:
        values[AREAL] = rounded(areal * thickness / value_at(file.tables, key), 4)
    return Change(values, {"thickness": said})


def as_sold(file: DesignFile, offered: Offer, change: Change) -> Change | None:
    """A change of a file whose panels are as thick as is sold, and no thicker than it has them.

    What a refusal offers is a number of its own: the next thinner board is bought. None without.
    """
    key = thickness_key(file)
    if key not in change.values:
        return change
    thickness = offered.at_most(change.values[key])
    if thickness is None:
        return None
    made = as_thick(file, thickness)
    return change | (Change({key: thickness}, made.said) if MATERIAL in change.values else made)


def thickness_key(file: DesignFile) -> str:
    """Where a file says how thick its panels are."""
    return "structure.thickness" if file.panel is None else "panel.thickness"


def other_materials(file: DesignFile, found: Analysis) -> Iterator[Change]:
    """Panels of a material that bends less: as stiff as figures ask for, but no heavier.

    Where none so light are sold, the lightest.
    """
    asked = file.structure
    assert asked is not None
    given = value_at(file.tables, "structure") or {}
    if asked.material is None or {"modulus", "strength", "sandwich"} & given.keys():
        return
    metres, present = conversion(file.unit, "m"), materials()[asked.material]
    thick = found.model.thickness * metres
    weighs = value_at(file.tables, AREAL)
    areal = weighs or present.density_of(thick) * thick
    times = max(_times(case) for case in found.cases)
    needed = (MARGIN * times) ** 3 * _bending(present, thick)
    keys = ("structure.grain", "panel.density")
    dropped = {key: None for key in keys if value_at(file.tables, key) is not None}
    for name, made in materials().items():
        if name == asked.material:
            continue
        offered = offer(file, found.model, name)
        heaviest = offered.at_most(_thickness_of(made, areal) / metres) or offered.sold[0]
        stiff = (each for each in offered.sold if _bending(made, each * metres) >= needed)
        other = min(next(stiff, heaviest), heaviest)
        if _bending(made, other * metres) > _bending(present, thick):
            change = as_thick(file, other)
            values: dict[str, object] = {MATERIAL: name, **change.values, **dropped}
            if weighs:
                heavier = made.density_of(other * metres) * other * metres
                values[AREAL] = max(weighs, rounded(heavier, 4))
            yield Change(values, {"material": f"made of {name}", **change.said})


def _thickness_of(made: Material, areal: float) -> float:
    """How thick (m) boards of a material are that weigh so much by their area (kg/m2)."""
    if made.sandwich is None:
        return areal / made.density
    faces, core = 2 * made.sandwich.face * made.sandwich.face_density, made.sandwich.core_density
    return 2 * made.sandwich.face + max(0.0, areal - faces) / core


def _bending(made: Material, thickness: float) -> float:
    """Bending stiffness (N m), of a sandwich that of its faces."""
    if made.sandwich is None:
        return made.modulus * thickness**3 / 12
    face = made.sandwich.face
    return made.modulus * face * (thickness - face) ** 2 / 2


def stiffer(case: CaseResult) -> float:
    """How many times stiffer a shell in equilibrium should be."""
    found = case.equilibrium
    assert found is not None
    buckles = found.utilisation.buckling or 0.0
    return float(max(found.displacement.share / LARGE_DISPLACEMENT, LEAST_BUCKLING * buckles))


def _times(case: CaseResult) -> float:
    """By what thickness is to grow: moments are borne by its square, stiffness is its cube."""
    found = case.equilibrium
    if found is None:
        return SOFT
    bears = found.utilisation.panels or 0.0
    return float(max(1.0, bears**0.5, stiffer(case) ** (1 / 3)))
