"""Random small shelters, canopies and domes, as design files, most of which do not carry."""

from __future__ import annotations

import tomllib
from pathlib import Path

import numpy as np

from orishell.design_file import DesignFile, check_design

SHELTER = """
[target.f]
{f}
[target.g]
formula = "{wave:.3f}*cos(2*pi*x/{step:.3f})"
range = [0, {length:.3f}]
[pattern]
rows = {rows}
columns = {columns}
flap = {flap}
depth = {depth:.3f}
heading_deg = 90
spacing = "equal"
"""
CANOPY = """
[target.f]
formula = "{rise:.3f}*x + {bend:.3f}*x**2"
range = [-{half:.3f}, {half:.3f}]
[target.g]
formula = ["{radius:.3f}*cos(t)", "{radius:.3f}*sin(t)"]
range = [0.5, {turn:.3f}]
[pattern]
rows = {rows}
columns = {columns}
flap = {flap}
xi_deg = {xi:.1f}
"""
DOME = """
[target.surface]
formula = "sqrt({square:.3f} - x**2 - y**2)"
x = [-{half:.3f}, {half:.3f}]
y = [-{half:.3f}, {half:.3f}]
[pattern]
rows = {rows}
columns = {columns}
direction_deg = 0
fold_deg = {fold:.1f}
ground = "corners"
"""
BUILT = """
[panel]
thickness = {thickness}
{construction}
[deployment]
from = "{start}"
ties = "{ties}"
[structure]
material = "{material}"
crease_stiffness = {creases}
cells = {cells}
supports = [{{ at = "{at}", {support} }}]
{strengths}{combinations}
[[load_case]]
name = "dead"
self_weight = true
[[load_case]]
name = "snow"
{self}snow = {{ ground = {snow}, arrangement = "undrifted" }}
[[load_case]]
name = "wind"
{self}wind = {{ speed = {speed}, terrain = "II", direction_deg = {blows} }}
"""
CONSTRUCTIONS = (
    'construction = "bevel"\ngap = 0.003',
    "membrane = 0.0005\nmembrane_density = 1000",
)
SUPPORTS = (
    'kind = "pinned"',
    'kind = "pinned", edges = true',
    'kind = "friction", friction = 0.5',
    'kind = "pinned", ballast = 40, friction = 0.4',
    'kind = "sliding"',
)
MATERIALS = ("birch plywood", "twin-wall polypropylene", "aluminium")
LINES = ("", '{ kind = "bolted hinge" }', "40e3", '{ kind = "coated fabric" }')
FAMILY = {"shelter": "orthodiagonal", "canopy": "parallel-repeating", "dome": "flat-foldable"}


def failing_file(seed: int) -> DesignFile:
    """One of the random shells; not all of them can be made, and a few carry."""
    kind = ("shelter", "canopy", "shelter", "dome")[seed % 4]
    text = f'[shell]\nfamily = "{FAMILY[kind]}"\nunit = "m"\n' + _text(kind, seed)
    return check_design(tomllib.loads(text), Path(f"{kind}_{seed}.toml"))


def _text(kind: str, seed: int) -> str:
    random = np.random.default_rng(seed)
    between, one_of = random.uniform, random.choice
    flap = float(one_of([0.0, 0.0, 0.1]))
    if kind == "shelter":
        half, step = between(0.8, 2.0), between(0.6, 1.1)
        columns = int(one_of([5, 7, 9]))
        f = f'formula = "{between(0.4, 1.0):.3f}*({half:.3f} - x**2/{half:.3f})"'
        f += f"\nrange = [-{half:.3f}, {half:.3f}]"
        if random.random() < 0.4:
            f = f'formula = ["{half:.3f}*cos(t)", "{between(1.0, 1.5) * half:.3f}*sin(t)"]'
            f += "\nrange = [0, 3.14159265]"
        shape = SHELTER.format(
            f=f,
            wave=between(0.08, 0.2) * step,
            step=step,
            length=0.5 * step * (columns - 1),
            rows=one_of([5, 7, 9]),
            columns=columns,
            flap=flap,
            depth=between(0.1, 0.2) * half,
        )
    elif kind == "canopy":
        shape = CANOPY.format(
            rise=between(0.2, 0.6),
            bend=between(0.05, 0.2),
            half=between(0.8, 1.5),
            radius=between(2.5, 4.0),
            turn=between(1.6, 3.5),
            rows=one_of([4, 5, 7]),
            columns=one_of([7, 9, 11]),
            flap=flap,
            xi=between(75, 86),
        )
    else:
        half = between(1.0, 2.5)
        size = int(one_of([5, 7]))
        shape = DOME.format(
            square=(between(1.5, 2.2) * half) ** 2,
            half=half,
            rows=size,
            columns=size,
            fold=between(85, 100),
        )
    lines, combined = one_of(LINES), random.random() < 0.3
    strengths = f"line_strength = {lines}\n" if lines else ""
    if random.random() < 0.8:
        strengths += "tie_stiffness = 2e5\ntie_strength = 2000\n"
    return shape + BUILT.format(
        thickness=one_of([0.004, 0.006, 0.01]),
        construction=one_of(CONSTRUCTIONS),
        start=one_of(["pack", "flat"]),
        ties=one_of(["none", "feet"]) if kind != "canopy" else "none",
        material=one_of(MATERIALS),
        creases=one_of(['"free"', '"free"', '["free", "rigid"]', "20"]),
        cells=one_of([2, 3, 4]),
        at="feet" if kind != "canopy" else "ends",
        support=one_of(SUPPORTS),
        strengths=strengths,
        combinations='combinations = "EN 1990"\n' if combined else "",
        snow=one_of([500, 1000, 1500]),
        speed=one_of([20, 25]),
        blows=one_of([0, 90]),
        self="" if combined else "self_weight = true\n",
    )
