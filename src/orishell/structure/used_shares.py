"""Which shares of what they bear parts of a loaded shell use, and of which nobody knows."""

from __future__ import annotations

from typing import TYPE_CHECKING

from orishell.conventions.quantities import conversion
from orishell.structure.plates import used_of_plates
from orishell.structure.rail import used_rail
from orishell.structure.utilisation import BY_DIRECTION, LEAST_LINE, Limiting, Utilisation, share_of

if TYPE_CHECKING:
    from orishell.structure.equilibrium import Equilibrium


def utilisation_of(found: Equilibrium) -> Utilisation:
    """Shares of what is borne, by what can be borne."""
    asked, film, line = found.model.structure, found.membrane, found.used_line
    box_lines, plate_edges = (
        None if each is None or each.used is None else each.used.size
        for each in (found.box_lines, found.plate_edges)
    )
    grain, inside = found.by_grain, found.sandwich
    core = None if asked.sandwich is None else asked.sandwich.core_shear_strength
    creases = 0.0 if found.crease is None else found.crease.moment
    stiffeners = used_of_plates(
        found.model.stiffened.of_plates, found.in_plates, found.duration, found.model.site.unit
    )
    return Utilisation(
        panels=share_of(found.in_panels[0], found.strength) if grain is None else grain.panels,
        panel_shear=None if grain is None else grain.panel_shear,
        rolling_shear=None if grain is None else grain.rolling_shear,
        core_shear=None if inside is None else share_of(inside.core_shear, core),
        wrinkling=None if inside is None else inside.pressure / inside.wrinkling,
        membrane=None if film is None else share_of(film.size, asked.membrane_strength),
        creases=share_of(creases, asked.crease_strength),
        lines=None if line is None else line.size,
        arms=None if found.arms is None else share_of(found.arms.size, asked.arm_strength),
        gussets=None if found.gussets is None else stiffeners,
        boxes=None if found.boxes is None else stiffeners,
        box_lines=box_lines,
        plate_edges=plate_edges,
        ties=share_of(found.ties[0].force if found.ties else 0.0, asked.tie_strength),
        rail=used_rail(found.rail, asked, found.duration, found.model.site.unit),
        buckling=None if found.buckling is None else 1 / found.buckling,
    )


def loaded_unknown(found: Equilibrium) -> tuple[Limiting, ...]:
    """Loaded parts without a given strength."""
    least = LEAST_LINE * conversion(found.model.site.unit, "m")
    box_lines, plate_edges = found.box_lines, found.plate_edges
    bears: dict[Limiting, bool] = {
        "panels": True,
        "core_shear": found.sandwich is not None,
        "membrane": found.membrane is not None and found.membrane.size > 0,
        "creases": found.crease is not None,
        "lines": found.unknown_line.size > least,
        "arms": found.arms is not None and found.arms.size > 0,
        "gussets": found.gussets is not None and found.gussets.size > 0,
        "boxes": found.boxes is not None and found.boxes.size > 0,
        "box_lines": box_lines is not None and box_lines.unknown.size > least,
        "plate_edges": plate_edges is not None and plate_edges.unknown.size > 0,
        "ties": bool(found.tie_forces.any()),
    }
    shares = found.utilisation.shares
    return tuple(
        part
        for part, any_ in bears.items()
        if any_ and (shares[part] is None or part in BY_DIRECTION)
    )
