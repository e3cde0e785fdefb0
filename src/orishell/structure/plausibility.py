"""Inputs that are likely to be in another unit than the design's."""

from __future__ import annotations

from collections.abc import Iterator
from math import isfinite
from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.quantities import GRAVITY, conversion, plain
from orishell.design import PanelSpec
from orishell.numerics.arrays import Array
from orishell.structure.hinge_lines import DIRECTIONS, LineStrength
from orishell.structure.load_settings import LOADS
from orishell.structure.loads import DOUBTS, Scale
from orishell.structure.settings import Structure
from orishell.structure.utilisation import LEAST_LINE

if TYPE_CHECKING:
    from orishell.structure.model import Model

Range = tuple[float, float]
MODULI: Range = (1e5, 1e13)
"""From rubber foam to more than diamond (N/m2)."""
STRENGTHS: Range = (1e3, 1e11)
"""From foam to more than any fibre (N/m2)."""
DENSITIES: Range = (5.0, 25e3)
"""From the lightest foam to the heaviest metals (kg/m3)."""
AREAL: Range = (0.01, 1e3)
"""From tissue to steel of 130 mm (kg/m2)."""
YIELDS: Range = (1e-5, 0.1)
"""Strains at which what panels are made of fails: chalk bears more than the first, nothing as much
as the second."""
STRETCHY, TIES = 0.5, (10.0, 1e7)
"""No rope stretches by half before it breaks; a thread bears 10 N, a bundle of strands 1e7."""
LINES: Range = (LEAST_LINE, 1e8)
"""From masking tape to a weld of steel 0.4 m thick (N/m)."""
BENT = 10.0
"""A crease that bears so many times the moment of the panels beside it is stronger than they."""
THIN = 2e-5
"""Foil for the kitchen (m)."""
THICK = 0.2
"""Panels thicker than this share of their width are blocks, and no plates."""
PONDING = np.arctan(0.25 / 12)
"""Less steep panels may pond (radians): a quarter of an inch per foot, ASCE 7-16, 8.4."""
RESTRAINED_SHARE = 0.1
"""Supports that hold more than this share of the panels hold the shell itself."""


def doubts(
    structure: Structure, unit: str, panel: PanelSpec | None, weight: float = 0.0
) -> Iterator[str]:
    """Sentences about values that can hardly be meant.

    unit: The design's unit of length, which areas are in.
    panel: What panels are made of; None if they have no thickness of their own.
    weight: Of all panels (N); 0 if it is not known.
    """
    area = conversion(unit, "m") ** 2
    yield from _materials(structure, area, unit, panel)
    yield from _parts(structure, unit, panel)
    for case in structure.cases:
        for name in LOADS:
            asked = getattr(case, name)
            if asked and (said := DOUBTS[name](asked, Scale(area, weight))):
                yield f"load case {case.name}: {said}"


def doubts_of_shell(model: Model) -> Iterator[str]:
    """Sentences about values that can hardly be meant, or hardly fit the shell."""
    unit, areal = model.site.unit, model.site.areal_density
    yield from doubts(model.structure, unit, model.design.panel, model.mass * GRAVITY)
    if areal and not AREAL[0] <= areal <= AREAL[1]:
        yield f"panels weigh {plain(areal)} kg per square metre: paper weighs 0.1, steel of 1 mm 8"
    widths = panel_widths(model)
    if (thin := widths * THICK < model.thickness).any():
        panel = int(thin.argmax())
        every = "every panel" if thin.all() else f"panel {list(model.panel_at(panel))}"
        yield (
            f"panels are {plain(model.thickness)} {unit} thick, more than a fifth of the width of "
            f"{every} ({plain(float(widths[panel]), 3)} {unit}): blocks, no plates. Thickness is "
            f"in {unit}"
        )
    if model.supports.share > RESTRAINED_SHARE:
        yield (
            f"supports hold {plain(100 * model.supports.share, 2)} % of the panels, which nothing "
            f"displaces then: patch is in {unit}"
        )
    slopes = _slopes(model)
    if (level := slopes < PONDING).any():
        panel = int(slopes.argmin())
        yield (
            f"{int(level.sum())} panels are nearly level, panel {list(model.panel_at(panel))} at "
            f"{plain(float(np.rad2deg(slopes[panel])), 2)} degrees: water stands on them, more "
            "of it the further they sag, and that is not analysed"
        )


def _slopes(model: Model) -> Array:
    """Angles (F,) of panels with the horizontal (radians)."""
    facets, count = model.mesh.facets, len(model.mesh.nodes)
    normals = np.zeros((count, 3))
    np.add.at(normals, model.mesh.panels, facets.areas()[:, None] * facets.axes()[:, 2])
    return np.arctan2(np.hypot(normals[:, 0], normals[:, 1]), np.abs(normals[:, 2]))


def panel_widths(model: Model) -> Array:
    """Widths (F,) of panels, area by longest edge."""
    seats = model.mesh.seats[:, [0, -1, -1, 0], [0, 0, -1, -1]]
    corners = model.mesh.facets.points[seats]
    edges = np.linalg.norm(corners - np.roll(corners, -1, axis=1), axis=-1)
    across = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    return np.asarray(0.5 * np.linalg.norm(across, axis=-1) / edges.max(axis=1))


def _materials(
    structure: Structure, area: float, unit: str, panel: PanelSpec | None
) -> Iterator[str]:
    for key, (least, most) in (
        ("modulus", MODULI),
        ("membrane_modulus", MODULI),
        ("arm_modulus", MODULI),
        ("strength", STRENGTHS),
        ("membrane_strength", STRENGTHS),
        ("arm_strength", STRENGTHS),
    ):
        value = getattr(structure, key)
        if value and not least <= value / area <= most:
            yield (
                f"{key} = {value:g} is {plain(value / area)} N/m2 ({plain(value / area / 1e9)} "
                f"GPa): forces per area are in newtons per square {unit}; 1 GPa is "
                f"{plain(1e9 * area)} here"
            )
    for strong, stiff in (("strength", "modulus"), ("arm_strength", "arm_modulus")):
        strength, modulus = getattr(structure, strong), getattr(structure, stiff)
        if strength is None or modulus is None:
            continue
        share = 100 * strength / modulus
        if not YIELDS[0] <= strength / modulus <= YIELDS[1]:
            yield (
                f"{strong} = {strength:g} is {plain(share, 3)} % of {stiff} = {modulus:g}: "
                "panels would stretch by as much before they fail"
            )
    densities = {} if panel is None else {"density": panel.density}
    if panel is not None and panel.construction == "sandwich":
        densities["membrane_density"] = panel.membrane_density
    if panel is not None and panel.construction == "hinged":
        densities["arm_density"] = panel.arm_density
    for key, density in densities.items():
        if density and not DENSITIES[0] <= density <= DENSITIES[1]:
            yield f"{key} = {density:g} in [panel] is in kilograms per cubic metre: water has 1000"


def _lines(key: str, bears: LineStrength | None, unit: str) -> Iterator[str]:
    """Of what lines bear."""
    metres = conversion(unit, "m")
    for name in DIRECTIONS if bears is not None and bears.kind is None else ():
        line = getattr(bears, name)
        if line is None or LINES[0] <= line / metres <= LINES[1]:
            continue
        yield (
            f"{key} = {line:g} is {plain(line / metres)} N/m: forces per length are in "
            f"newtons per {unit}; 1 kN/m is {plain(1e3 * metres)} here"
        )
        break


def _parts(structure: Structure, unit: str, panel: PanelSpec | None) -> Iterator[str]:
    """Of creases, ties, and the thickness."""
    metres = conversion(unit, "m")
    thickness = structure.thickness if panel is None else panel.thickness
    if thickness and thickness * metres < THIN:
        yield f"panels are {plain(1e3 * thickness * metres)} mm thick: thickness is in {unit}"
    crease = structure.crease_strength
    for key in ("line_strength", "edge_strength"):
        yield from _lines(key, getattr(structure, key), unit)
    if crease and thickness and structure.strength:
        bears = structure.strength * thickness**2 / 4
        if crease > BENT * bears:
            yield (
                f"crease_strength = {crease:g} N is {plain(crease / bears, 3)} times what the "
                f"panels beside creases bear when they are bent, {plain(bears, 3)} N m/m: they "
                "fail first"
            )
    tie, stiff = structure.tie_strength, structure.tie_stiffness
    if tie and not TIES[0] <= tie <= TIES[1]:
        yield f"tie_strength = {tie:g} is in newtons: a thread bears 10, a rope of 8 mm 10 000"
    if tie and isfinite(stiff) and tie > STRETCHY * stiff:
        yield (
            f"tie_strength = {tie:g} is {plain(100 * tie / stiff, 3)} % of tie_stiffness = "
            f"{stiff:g}: ties would stretch by as much before they break"
        )
