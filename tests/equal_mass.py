"""Shells of one mass, as the tables on gussets and box girders have them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from documents import EXAMPLES
from orishell.deployment import Site
from orishell.deployment.feet import find_feet
from orishell.design import Design
from orishell.design_file import read_design_file
from orishell.motion import area_of
from orishell.numerics.arrays import Array
from orishell.shell.designed import designed
from orishell.structure.load_settings import LoadCase
from orishell.structure.model import Model
from orishell.structure.settings import Structure, Support
from orishell.structure.solve.active_set import respond

MADE_OF = {  # density, modulus, Poisson's ratio, other keys
    "shelter": (190.0, 273e6, 0.4, {"pattern.flap": 0.0}),
    "dome": (500.0, 4.5e9, 0.3, {}),
}


def example(name: str) -> Design:
    """The shell of an example, of panels without a thickness of their own."""
    keys = MADE_OF[name][3]
    return replace(designed(read_design_file(EXAMPLES / f"{name}.toml").changed(keys)), panel=None)


def area_with_all(design: Design) -> float:
    """Area of the sheet, and of what stiffens it."""
    area = area_of(design.mechanism) + sum(float(part.areas().sum()) for part in design.attached)
    return area + sum(area_of(each.sleeve) for each in design.boxes)


def sinks(
    design: Design, name: str, mass: float, cells: int, *, locked: bool = False
) -> tuple[float, float]:
    """The largest displacement (mm) under the whole load, and under half of it.

    Under 400 N per square metre of plan, on all of it or on the half beyond the middle vertex.
    Panels, and what stiffens them, are as thick as the mass (kg) allows.
    """
    density, modulus, poisson, _ = MADE_OF[name]
    thickness = mass / (density * area_with_all(design))
    structure = Structure(
        modulus=modulus,
        poisson=poisson,
        thickness=thickness,
        supports=(Support(at="feet", kind="pinned"),),
        cases=(LoadCase(name="dead", self_weight=True),),
        cells=cells,
    )
    site = Site("m", find_feet(design), (), density * thickness)
    model = Model(design, structure, site, cells)
    np.testing.assert_allclose(model.mass, mass, rtol=1e-9)
    factorised = model.factorised(np.inf if locked else 0.0)
    facets = model.mesh.facets
    corners = facets.points[facets.triangles]
    sides = corners[:, 1:, :2] - corners[:, :1, :2]
    plan = 0.5 * np.abs(sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0])
    beyond = corners[..., 1].mean(axis=1) > np.median(model.stiffened.sheet.facets.points[:, 1])
    found = []
    for loaded in (plan, plan * beyond):
        forces: Array = np.zeros_like(facets.points)
        np.add.at(forces[:, 2], facets.triangles, -400 / 3 * loaded[:, None])
        response = respond(factorised, factorised.free_loads(forces))
        found.append(1e3 * factorised.furthest(response.displacements))
    return found[0], found[1]
