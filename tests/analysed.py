"""A tent as a structure, with results that are made up, for tests of what is written of them."""

from __future__ import annotations

from dataclasses import replace
from types import MappingProxyType, SimpleNamespace
from typing import Any, cast

import numpy as np

from orishell.deployment import Site
from orishell.deployment.feet import Feet
from orishell.motion.grid import Grid
from orishell.structure.case import CaseResult
from orishell.structure.changes import Changes
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.free_motion import FreeMotion
from orishell.structure.hinge_lines import LineStrength
from orishell.structure.load_settings import LoadCase, PointLoad, Snow, Wind
from orishell.structure.loads import Exposure, case_loads, sum_forces, vector
from orishell.structure.mesh.edge_forces import EdgeForces, OnPanels
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.sheet import mesh_sheet
from orishell.structure.mesh.stresses import PanelStresses
from orishell.structure.model import Model
from orishell.structure.results import Analysis
from orishell.structure.settings import Structure, Support

SPAN, LENGTH, RISE, THICKNESS = 4.0, 3.0, 2.0, 0.01
STRUCTURE = Structure(
    modulus=270e6,
    poisson=0.3,
    supports=(
        Support(at="feet", kind="sliding"),
        Support(at=((0, 1), (2, 1)), kind="friction", friction=0.5),
    ),
    cases=(
        LoadCase(name="dead", self_weight=True),
        LoadCase(
            name="snow",
            snow=Snow(ground=500, shape="cylinder", arrangement="undrifted"),
            points=(PointLoad(at=(1, 1), force=(0, 0, -80)),),
        ),
        LoadCase(name="both", combine={"dead": 1.35, "snow": 1.5}),
        LoadCase(
            name="wind",
            pressure=10,
            wind=Wind(
                speed=26,
                terrain="II",
                direction_deg=90.0,
                coefficients=((0, 0.8), (180.0, -0.4)),
            ),
        ),
    ),
    thickness=THICKNESS,
    strength=5.5e6,
    crease_strength=20.0,
    line_strength=LineStrength.alike(2000.0),
    tie_stiffness=1.2e6,
    tie_strength=5000.0,
)


def tent() -> Exposure:
    """Two panels of 2 x 3 m in plan at 45 degrees, the ridge along y, between folded flaps."""
    positions = np.empty((3, 2, 3))
    x, y = [-SPAN / 2, 0, SPAN / 2], [0, LENGTH]
    positions[..., 0], positions[..., 1] = np.meshgrid(x, y, indexing="ij")
    positions[..., 2] = RISE - np.abs(positions[..., 0])
    grid = Grid(3, 2)
    mesh = mesh_sheet(positions, grid, 2)
    mass = np.full(len(mesh.places), 1.9)
    hung = np.zeros(len(mesh.facets.points))
    return Exposure(mesh.facets, mesh.panels, grid, 1, mass, hung, "m", 0.0, SPAN, (0, 2))


class Tent(Model):
    """The tent, as if a design had it."""

    grid: Any = Grid(3, 2)
    before: Any = 1
    exposure: Any = tent()
    mesh: Any = mesh_sheet(exposure.mesh.points[:6].reshape(3, 2, 3), grid, 2)
    section: Any = Section.solid(STRUCTURE.modulus, THICKNESS, STRUCTURE.poisson)
    supported: Any = ((0, 1), (2, 1))
    grounded: Any = MappingProxyType({})
    supports: Any = SimpleNamespace(
        lost=(),
        share=0.0,
        ballast=np.zeros(2),
        rubs=np.zeros(2),
        restrained=np.zeros((0, 2), np.int64),
        ground=np.array([0, 4]),
    )
    rails: Any = ()
    flaps: Any = (((0, 0), (1, 0)), ((1, 0), (2, 0)))
    mass: Any = 32.2
    positions: Any = exposure.mesh.points[:6].reshape(3, 2, 3)


def analysed(structure: Structure = STRUCTURE) -> Analysis:
    """Cases "both" and "wind" with free and with rigid creases; "both" moves where they are free.

    The node in the middle of panel [0, 1] goes 0.15 down; of the ties the second pulls 4 kN; the
    upper face of the last triangle bears 2 MPa; the crease between both panels 5 N; it buckles
    under 2.5 times its loads.
    """
    ties = (((0, 1), (2, 1)), ((0, 2), (2, 2)), ((1, 1), (2, 1)))
    design = cast(
        "Any",
        SimpleNamespace(panel=None, attached=(), plates=(), boxes=(), carried=(), end_walls=()),
    )
    model = Tent(
        design,
        structure,
        Site("m", Feet((0, 2), 0.0, 0.0, RISE), ties, 1.9),
        2,
        change=Changes(0.02, 0.05, 0.01),
    )
    count, triangles = model.nodes, model.triangles
    displacements = np.zeros((count, 3))
    displacements[model.mesh.nodes[0, 1, 1]] = [0, 0, -0.15]
    stresses = np.full((triangles, 2), 1e5)
    stresses[-1, 1] = 2e6
    crease = int(np.intersect1d(*model.grid.faces_edges())[0])
    moments = np.zeros(len(model.grid.edges_vertices()))
    moments[crease] = -5.0
    per_length = np.zeros((2, 4, 4, 4))
    per_length[0, 1, 1], per_length[1, 3, 2] = [600.0, 30.0, -20.0, -5.0], [-90.0, 30.0, 7.0, -5.0]
    still = np.zeros((2, 6))
    corners = model.mesh.facets.points[model.grid.faces_vertices()]
    on_panels = OnPanels(corners, still, still, np.zeros((2, 4, 3)))
    edges = EdgeForces(per_length, np.zeros((2, 4, 6)), np.zeros((2, 4, 6)), 0.0, on_panels)

    def case(name: str, stiffness: float) -> CaseResult:
        asked = next((each for each in structure.cases if each.name == name), STRUCTURE.cases[0])
        loads = case_loads(model.exposure, asked, structure.cases)
        forces = sum_forces(model.exposure, loads)
        total = forces.sum(axis=0)
        stands = Equilibrium(
            model=model,
            stiffness=stiffness,
            displacements=displacements,
            support_forces=np.array([-total / 2, -total / 2]),
            reaction=vector(-total),
            residual=1e-12,
            panel_residual=1e-13,
            feet=(),
            tie_forces=np.array([1000.0, 4000.0, 0.0]),
            flap_forces=np.array([0.0, 30.0]),
            edges=edges,
            held_plates=(),
            crease_moments=moments,
            stresses=stresses,
            principal=np.stack([stresses[:, 1], -stresses[:, 0]], axis=1),
            in_patches=PanelStresses(
                np.zeros(triangles, np.int64),
                np.zeros(1, np.int64),
                np.zeros((1, 3)),
                np.zeros((1, 3)),
                np.zeros((1, 2)),
            ),
            buckling_factors=(2.5,),
            buckling_modes=displacements[None],
            buckling_at_points=(0.1,),
            frequencies=(3.0, 4.0, 7.0),
            modes=np.zeros((3, count, 3)),
            in_plates=(),
        )
        return CaseResult(name, stiffness, loads, forces, None, stands)

    opens = FreeMotion(displacements / 0.15, folding=True, opens=True)
    cases = (
        replace(case("both", 0.0), motion=opens, equilibrium=None),
        case("wind", 0.0),
        case("both", np.inf),
        case("wind", np.inf),
    )
    return Analysis(model, cases)
