"""Inputs that are likely to be in another unit than the design's."""

from __future__ import annotations

from collections.abc import Iterator

from orishell.conventions.quantities import conversion, plain
from orishell.design import PanelSpec
from orishell.structure.settings import Structure

MODULI = (1e5, 1e13)
"""From rubber foam to more than diamond (N/m2)."""
STRENGTHS = (1e3, 1e11)
"""From foam to more than any fibre (N/m2)."""
DENSITIES = (5.0, 25e3)
"""From the lightest foam to the heaviest metals (kg/m3)."""
YIELDS = 0.1
"""Nothing that panels are made of bears a strain as large as this."""
LEAST_SNOW, LEAST_WIND = 1.0, 1.0
"""A tenth of a millimetre of water (N/m2); a breath of air (m/s)."""


def doubts(structure: Structure, unit: str, panel: PanelSpec | None) -> Iterator[str]:
    """Sentences about values that can hardly be meant.

    unit: The design's unit of length, which areas are in.
    panel: What panels are made of; None if they have no thickness of their own.
    """
    area = conversion(unit, "m") ** 2
    for key, value, (least, most) in (
        ("modulus", structure.modulus, MODULI),
        ("membrane_modulus", structure.membrane_modulus, MODULI),
        ("strength", structure.strength, STRENGTHS),
    ):
        if value and not least <= value / area <= most:
            yield (
                f"{key} = {value:g} is {plain(value / area)} N/m2 ({plain(value / area / 1e9)} "
                f"GPa): forces per area are in newtons per square {unit}; 1 GPa is "
                f"{plain(1e9 * area)} here"
            )
    strength = structure.strength
    if strength is not None and strength > YIELDS * structure.modulus:
        share = 100 * strength / structure.modulus
        yield (
            f"strength = {strength:g} is {plain(share, 3)} % of modulus = {structure.modulus:g}: "
            "panels would stretch by as much before they fail"
        )
    densities = {} if panel is None else {"density": panel.density}
    if panel is not None and panel.construction == "sandwich":
        densities["membrane_density"] = panel.membrane_density
    for key, density in densities.items():
        if density and not DENSITIES[0] <= density <= DENSITIES[1]:
            yield f"{key} = {density:g} in [panel] is in kilograms per cubic metre: water has 1000"
    for case in structure.cases:
        if case.snow is not None and case.snow.ground / area < LEAST_SNOW:
            ground = case.snow.ground
            yield (
                f"load case {case.name}: snow of {ground:g} on the ground is {plain(ground / area)}"
                f" N/m2; 1 kN/m2 is {plain(1e3 * area)} here"
            )
        if case.wind is not None and case.wind.speed < LEAST_WIND:
            yield f"load case {case.name}: wind speed = {case.wind.speed:g} is in metres per second"
