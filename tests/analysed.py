"""A tent as a structure, with results that are made up, for tests of what is written of them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array
from orishell.structure.loads import case_forces
from orishell.structure.results import Analysis, Balance, CaseResult, Exposure, FreeMotion
from orishell.structure.sections import Section
from orishell.structure.settings import LoadCase, PointLoad, Snow, Structure, Support, Wind
from orishell.structure.sheet import mesh_sheet

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
            snow=Snow(ground=500, shape="cylinder"),
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
    return Exposure(mesh.facets, mesh.panels, grid, 1, mass, hung, "m", 0.0, SPAN)


def analysed() -> Analysis:
    """Cases "both" and "wind" with free and with rigid creases; "both" moves where they are free.

    The node in the middle of panel [0, 1] goes 0.15 down; of the ties the second pulls 4 kN; the
    upper face of the last triangle bears 2 MPa; the crease between both panels 5 N; it buckles
    under 2.5 times its loads.
    """
    exposure = tent()
    mesh = mesh_sheet(exposure.mesh.points[:6].reshape(3, 2, 3), exposure.grid, 2)
    count, triangles = len(mesh.facets.points), len(mesh.places)
    displacements = np.zeros((count, 3))
    displacements[mesh.nodes[0, 1, 1]] = [0, 0, -0.15]
    stresses = np.full((triangles, 2), 1e5)
    stresses[-1, 1] = 2e6
    crease = int(np.intersect1d(*exposure.grid.faces_edges())[0])
    moments = np.zeros(len(exposure.grid.edges_vertices()))
    moments[crease] = -5.0

    def case(name: str, stiffness: float) -> CaseResult:
        asked = next(each for each in STRUCTURE.cases if each.name == name)
        loads = case_forces(exposure, asked, STRUCTURE.cases)
        total = loads.sum(axis=0)
        return CaseResult(
            name=name,
            stiffness=stiffness,
            loads=loads,
            motion=None,
            balance=Balance(total, -total, 1e-12),
            displacements=displacements,
            reactions=np.array([-total / 2, -total / 2]),
            friction=None,
            tie_forces=np.array([1000.0, 4000.0, 0.0]),
            flap_forces=np.array([0.0, 30.0]),
            crease_moments=moments,
            stresses=stresses,
            principal=np.stack([stresses[:, 1], -stresses[:, 0]], axis=1),
            buckling=(2.5, displacements),
            frequencies=np.array([3.0, 4.0, 7.0]),
            modes=np.zeros((3, count, 3)),
        )

    return Analysis(
        grid=exposure.grid,
        before=1,
        mesh=mesh,
        section=Section.solid(STRUCTURE.modulus, THICKNESS, STRUCTURE.poisson),
        supported=((0, 1), (2, 1)),
        ties=(((0, 1), (2, 1)), ((0, 2), (2, 2)), ((1, 1), (2, 1))),
        flaps=(((0, 0), (1, 0)), ((1, 0), (2, 0))),
        mass=32.2,
        cases=(
            moving(case("both", 0.0), FreeMotion(displacements / 0.15, folding=True, opens=True)),
            case("wind", 0.0),
            case("both", np.inf),
            case("wind", np.inf),
        ),
        held=np.zeros((0, 2), np.int64),
        exposure=exposure,
        change=0.02,
    )


def moving(case: CaseResult, motion: FreeMotion) -> CaseResult:
    """A case that does not stand, so that what else is found is not a number."""

    def nothing(array: Array) -> Array:
        return np.full_like(array, np.nan)

    return replace(
        case,
        motion=motion,
        balance=Balance(case.balance.load, nothing(case.balance.reaction), np.nan),
        displacements=nothing(case.displacements),
        reactions=nothing(case.reactions),
        tie_forces=nothing(case.tie_forces),
        flap_forces=nothing(case.flap_forces),
        crease_moments=nothing(case.crease_moments),
        stresses=nothing(case.stresses),
        principal=nothing(case.principal),
        buckling=None,
        frequencies=case.frequencies[:0],
        modes=case.modes[:0],
    )
