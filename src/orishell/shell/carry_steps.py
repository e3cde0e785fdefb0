"""What a builder tries, step by step, to have a shell carry its loads: changes of its design file.

Every step looks at the file as changed so far and at what was found of it, and proposes changes of
its own kind, none where it has nothing to add. Strengths come from tables with their sources or
from the file: where neither has one, no step makes one up.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from orishell.conventions.formatting import rounded
from orishell.conventions.quantities import Quantities, conversion
from orishell.design.stiffeners import Stiffeners
from orishell.design_file import DesignFile
from orishell.design_file.tables import value_at
from orishell.shell.carry_change import Change, Step
from orishell.shell.carry_feet import anchored, base_rail, clamped, held_edges, more_ballast
from orishell.shell.load_trials import STANDING_CELLS
from orishell.structure.case import CaseResult
from orishell.structure.hinge_lines import DIRECTIONS, hinge_lines
from orishell.structure.materials import Material, materials
from orishell.structure.results import Analysis
from orishell.structure.verdict import LARGE_DISPLACEMENT, LEAST_BUCKLING

NOT_WHOLE = (
    "panel.membrane", "panel.membrane_density", "panel.gap", "stiffeners",
    "structure.membrane_modulus", "structure.membrane_strength",
)  # fmt: skip
"""What goes with panels that have their hinges in creases, and not with whole boards."""
SOFT = 3.0
"""A shell that gives way is tried with panels so many times as thick, as nothing is known of it."""
MARGIN = 1.02
"""Panels are tried by so much thicker than the figures of the last trial ask for."""
DEEPER = 1.5
"""The zigzag and the waves of g become so many times as deep at a time."""
FEW = 4
"""Gussets are tried first in every column that is so many apart, then in twice as many."""
AREAL = "workshop.areal_density"
COLUMNS = {"all": "every column", 1: "every column", 2: "every second column"}
Rows = Literal["valleys", "crests", "all"] | tuple[int, ...]
FOLDS = {"deployment.ties": "folds"}


def stronger_lines(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """Crease lines of a kind that bears more in a direction, and of which all is known."""
    assert file.structure is not None
    asked = file.structure.filled(file.unit).line_strength
    for name, made in hinge_lines().items():
        known = [getattr(made, each) for each in DIRECTIONS]
        has = [None if asked is None else getattr(asked, each) for each in DIRECTIONS]
        if None not in known and None in has:
            yield Change(
                {"structure.line_strength": {"kind": name}}, {"lines": f"a {name} in every crease"}
            )


def ties_across_folds(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """Ties between feet, and across the folds of every inner vertex."""
    if file.deployment.ties in ("none", "feet"):
        yield Change(FOLDS, {"ties": 'ties across the folds (ties = "folds")'})


def fewer_ties(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """Ties across the folds of fewer rows: every second one, then every third; feet alone."""
    if file.deployment.ties != "folds" or file.tolerance is not None:
        return
    rows = range(1, file.pattern.rows + 1)
    yield Change({"deployment.ties": "feet"}, {"ties": 'ties between feet (ties = "feet")'})
    for each in (3, 2):
        chosen = list(rows[each // 2 :: each])
        if chosen:
            yield Change(
                {"deployment.ties": {"folds": chosen}},
                {"ties": f"ties across the folds of rows {', '.join(map(str, chosen))}"},
            )


def flaps(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """Flaps as wide as they may be, where there are none."""
    if getattr(file.pattern, "flap", None) == 0:
        yield Change({"pattern.flap": "auto"}, {"flaps": 'flaps (flap = "auto")'})


def thicker(file: DesignFile, found: Analysis) -> Iterator[Change]:
    """Panels as thick as figures ask for."""
    times = max(_times(case) for case in found.cases)
    thickness = rounded(MARGIN * times * found.model.thickness, 2)
    if thickness > found.model.thickness:
        yield _thickness(file, thickness)


def thinner(file: DesignFile, found: Analysis) -> Iterator[Change]:
    """Panels as thin as they may be if stress is as the square of thickness, buckling as its cube.

    Only where both are known: of crease lines thickness says little.
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
    thickness = rounded(MARGIN * times * found.model.thickness, 2)
    if thickness < 0.95 * found.model.thickness:
        yield _thickness(file, thickness)


def _thickness(file: DesignFile, thickness: float) -> Change:
    """Panels of a thickness, and as much heavier where the file says what they weigh by area."""
    key = "structure.thickness" if file.panel is None else "panel.thickness"
    said = f"panels {Quantities(file.unit).displacement(thickness)} thick"
    values = {key: thickness}
    areal = value_at(file.tables, AREAL)
    if areal:
        values[AREAL] = rounded(areal * thickness / value_at(file.tables, key), 4)
    return Change(values, {"thickness": said})


def other_materials(file: DesignFile, found: Analysis) -> Iterator[Change]:
    """Panels as heavy of a material that bends less."""
    asked = file.structure
    assert asked is not None
    named = value_at(file.tables, "structure") or {}
    if asked.material is None or {"modulus", "strength", "sandwich"} & named.keys():
        return
    metres, present = conversion(file.unit, "m"), materials()[asked.material]
    thick = found.model.thickness * metres
    weighs = value_at(file.tables, AREAL)
    areal = weighs or present.density_of(thick) * thick
    keys = ("structure.grain", "panel.density")
    dropped = {key: None for key in keys if value_at(file.tables, key) is not None}
    for name, made in materials().items():
        other = _thickness_of(made, areal)
        if _bending(made, other) > _bending(present, thick):
            change = _thickness(file, rounded(other / metres, 2))
            said = {"material": name, **change.said}
            values = {"structure.material": name, **change.values, **dropped}
            yield Change({**values, AREAL: weighs} if weighs else values, said)


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


def gussets(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """Gussets in few columns, of folds that look down or of all; then in more of them."""
    assert file.structure is not None
    if file.panel is not None and file.panel.construction == "hinged":
        return
    finer = {} if file.structure.cells >= STANDING_CELLS else {"structure.cells": STANDING_CELLS}
    for rows, columns in _more_gussets(file.stiffeners):
        placed = {
            "stiffeners.kind": "gussets",
            "stiffeners.rows": rows if isinstance(rows, str) else list(rows),
            "stiffeners.columns": columns,
        }
        said = COLUMNS.get(columns, f"columns {columns} apart")
        said += f" of {rows}" if rows in ("valleys", "crests") else ""
        yield Change({**placed, **finer}, {"gussets": f"gussets in {said}"})


def _more_gussets(there: Stiffeners | None) -> Iterator[tuple[Rows, Literal["all"] | int]]:
    """Rows and columns of gussets where there are more than there were."""
    if there is None:
        yield "valleys", FEW
        yield "all", FEW
    elif isinstance(there.columns, int) and there.columns > 1:
        yield there.rows, there.columns // 2
    elif there.columns not in ("all", 1):
        yield there.rows, "all"
    elif there.rows != "all":
        yield "all", "all"


def whole_boards(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """Whole boards on hinges beside them."""
    if file.panel is not None and file.panel.construction != "hinged":
        dropped = {key: None for key in NOT_WHOLE if value_at(file.tables, key) is not None}
        values = {"panel.construction": "hinged", **dropped}
        yield Change(values, {"boards": 'whole boards (construction = "hinged")'})


def more_rows(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """Two rows more: as they are odd, or even."""
    if file.tolerance is None and file.drawing is None:
        rows = file.pattern.rows + 2
        yield Change({"pattern.rows": rows}, {"rows": f"{rows} rows"})


def deeper_waves(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """The waves of g deeper, so that panels stand steeper to each other: its y is enlarged."""
    if value_at(file.tables, "target.g") is None or file.fit is not None:
        return
    scale = value_at(file.tables, "target.g.scale") or 1.0
    x, y = scale if isinstance(scale, list) else (scale, scale)
    deeper = rounded(DEEPER * y, 3)
    yield Change({"target.g.scale": [x, deeper]}, {"waves": f"g {deeper:g} times as deep"})


def deeper_folds(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """A deeper zigzag about f."""
    depth = getattr(file.pattern, "depth", None)
    if isinstance(depth, float):
        deeper = rounded(DEEPER * depth, 2)
        yield Change({"pattern.depth": deeper}, {"folds": f"folds {deeper:g} {file.unit} deep"})


def locked_creases(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """Every crease locked once the shell stands."""
    assert file.structure is not None
    if file.structure.crease_stiffness[0] != float("inf"):
        yield Change({"structure.crease_stiffness": "rigid"}, {"locks": "every crease locked"})


BUILDER: tuple[Step, ...] = (
    held_edges, base_rail, more_ballast, more_ballast, anchored, clamped, stronger_lines,
    ties_across_folds, flaps, thicker, thicker, other_materials, gussets, gussets, gussets,
    whole_boards, more_rows, deeper_waves, deeper_waves, deeper_folds, locked_creases,
)  # fmt: skip
"""In the order in which somebody would who has the sheet already."""
DESIGNER: tuple[Step, ...] = (
    held_edges, anchored, stronger_lines, deeper_waves, deeper_waves, deeper_folds, more_rows,
    ties_across_folds, clamped, thicker, thicker, gussets, gussets, locked_creases,
)  # fmt: skip
"""In the order of somebody who may choose its shape first."""
LIGHTER: tuple[Step, ...] = (thinner, fewer_ties, thinner)
"""What is taken away again where a shell carries."""


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
