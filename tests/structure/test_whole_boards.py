"""Whole boards on hinges beside their creases: motions, eccentricity, equilibrium."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from scipy.sparse import csr_array
from scipy.sparse.linalg import spsolve

from flat_foldables import random_sheet
from mechanisms import flat_foldable, miura_net, random_net
from orishell.conventions.errors import InputError
from orishell.deployment import Site, feet_ties
from orishell.deployment.feet import find_feet
from orishell.deployment.fixings import Fixings
from orishell.design import Design, PanelSpec
from orishell.design.fittings import TRIMMED
from orishell.design_file import read_design_file
from orishell.families.flat_foldable.net import Net
from orishell.motion import Mechanism, area_of
from orishell.motion.grid import CreaseValues, Grid
from orishell.motion.hinges import Hinges, Straightened
from orishell.numerics.arrays import Array, Integers
from orishell.solids.hinged import find_hinges
from orishell.structure.analyse import analyse
from orishell.structure.buckling import by_arms
from orishell.structure.load_settings import LoadCase, PointLoad, Snow, Wind
from orishell.structure.loads import case_loads, sum_forces
from orishell.structure.mesh.arms import arm_stress, joint_elements
from orishell.structure.mesh.boards import HingedPlates, mesh_boards
from orishell.structure.mesh.edge_forces import find_edge_forces
from orishell.structure.mesh.hinges import hinge_elements, rigid_stiffness
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.sheet import SheetMesh, crease_places, points_by_dofs
from orishell.structure.model import Model
from orishell.structure.settings import Structure, Support
from orishell.structure.solve.active_set import respond
from orishell.structure.solve.conditions import joined, on_ground
from orishell.structure.solve.factorise import factorise
from orishell.structure.whole_boards import hinged_plates
from samples import led_by

EXAMPLES = Path(__file__).parents[2] / "examples"
NOTHING = joined([on_ground(np.zeros(0, np.int64), np.zeros(0))])
NOWHERE = np.zeros(0, np.int64)
SNOW = LoadCase(name="snow", self_weight=True, snow=Snow(ground=500.0, arrangement="undrifted"))
STRUCTURE = Structure(
    modulus=6.7e9,
    poisson=0.3,
    supports=(Support(at="feet", kind="pinned", edges=True),),
    cases=(SNOW,),
    cells=4,
)


def meshed(
    sheet: Mechanism, hinges: Hinges, drive: float, cells: int = 3, gap: float = 0.1
) -> SheetMesh:
    flat, positions = sheet.positions(0.0), sheet.positions(drive)
    plates = hinged_plates(hinges, gap * hinges.thickness, flat, positions)
    return mesh_boards(plates, sheet.grid, cells)


def energies(mesh: SheetMesh, grid: Grid, thickness: float, *, locked: bool) -> tuple[Array, Array]:
    """Eigenvalues of the stiffness by the largest, and modes, rotations counted as lengths."""
    section = Section.solid(1.0, thickness, 0.3)
    stiffness = mesh.elements(section).assembled()
    if locked:
        springs = hinge_elements(mesh, grid, rigid_stiffness(mesh, section))
        stiffness = stiffness + springs.assembled()
    scale = np.ones(mesh.count)
    size = np.ptp(mesh.facets.points, axis=0).max()
    scale[3 * mesh.node_count :] = 10 / size
    values, modes = np.linalg.eigh(stiffness.toarray() * scale[:, None] * scale)
    return values / values[-1], modes


SHEETS = [0, 3, 16]
"""Parallel repeating, a net whose columns bend, parallel repeating."""


def small_sheet(seed: int) -> tuple[Mechanism, float]:
    sheet = random_sheet(seed)
    return sheet, 0.01 * float(np.ptp(sheet.positions(0.0), axis=(0, 1)).max())


@pytest.mark.parametrize(
    ("seed", "share"), led_by([(11, 0.3), (11, 1.0), (11, 0.7), (0, 0.3), (0, 0.7), (0, 1.0)], 2)
)
def test_boards_have_one_motion_of_their_own(seed: int, share: float) -> None:
    """Seven motions without energy; the derivative of the boards' closed form is among them."""
    sheet, thickness = small_sheet(seed)
    hinges = find_hinges(sheet, PanelSpec(thickness=thickness, construction="hinged"))
    drive = share * sheet.target_drive
    mesh = meshed(sheet, hinges, drive)
    values, modes = energies(mesh, sheet.grid, thickness, locked=False)
    assert np.abs(values[:7]).max() < 1e-14
    assert values[7] > 1e4 * np.abs(values[:7]).max()
    step = 1e-5
    near = [meshed(sheet, hinges, drive + way).facets.points for way in (-step, step)]
    velocity = ((near[1] - near[0]) / (2 * step))[: mesh.node_count].ravel()
    free = modes[: velocity.size, :7]
    rest = velocity - free @ np.linalg.lstsq(free, velocity, rcond=None)[0]
    assert np.linalg.norm(rest) < 1e-6 * np.linalg.norm(velocity)


@pytest.mark.parametrize("seed", led_by([11, 0]))
def test_locked_hinges_leave_the_motions_of_the_whole(seed: int) -> None:
    sheet, thickness = small_sheet(seed)
    hinges = find_hinges(sheet, PanelSpec(thickness=thickness, construction="hinged"))
    mesh = meshed(sheet, hinges, sheet.target_drive)
    values, _ = energies(mesh, sheet.grid, thickness, locked=True)
    assert np.abs(values[:6]).max() < 1e-14
    assert values[6] > 1e4 * np.abs(values[:6]).max()


@pytest.mark.parametrize("seed", led_by([11, 0]))
def test_a_hinge_at_a_wrong_height_closes_the_motion(seed: int) -> None:
    """A tenth of the thickness: six are left, the seventh takes a thousand times as much energy."""
    sheet, thickness = small_sheet(seed)
    hinges = find_hinges(sheet, PanelSpec(thickness=thickness, construction="hinged"))
    column = hinges.heights.column.copy()
    column[0, 0] += 0.1 * thickness
    wrong = replace(hinges, heights=CreaseValues(hinges.heights.row, column))
    found = [
        energies(meshed(sheet, each, sheet.target_drive), sheet.grid, thickness, locked=False)[0]
        for each in (hinges, wrong)
    ]
    assert np.abs(found[1][:6]).max() < 1e-14
    assert found[1][6] > 1e3 * np.abs(found[0][:7]).max()


@cache
def shelter(pieces: int | str = "whole") -> Design:
    file = read_design_file(EXAMPLES / "shelter_hinged.toml")
    assert file.panel is not None
    panel = file.panel.replace_unchecked(pieces=pieces, largest_arm="any")
    design = file.pattern.design(file.f, file.g)
    assert isinstance(design.mechanism, Straightened)
    mechanism = design.mechanism.straightened()
    hinges = find_hinges(mechanism, panel)
    return replace(design, mechanism=mechanism, panel=panel, hinges=hinges)


@pytest.mark.parametrize("share", led_by([0.8, 0.4, 1.0]))
def test_the_shelter_of_whole_boards_has_one_motion(share: float) -> None:
    """144 boards, arms of 110 mm: seven motions, six with locked hinges or one 1 mm wrong."""
    design = shelter()
    sheet, hinges = design.mechanism, design.hinges
    assert isinstance(hinges, Hinges)
    column = hinges.heights.column.copy()
    column[5, 5] += 1e-3
    wrong = replace(hinges, heights=CreaseValues(hinges.heights.row, column))
    drive = share * sheet.target_drive
    assert motions(sheet, hinges, drive, locked=False) == 7
    assert motions(sheet, hinges, drive, locked=True) == 6
    assert motions(sheet, wrong, drive, locked=False) == 6


def motions(sheet: Mechanism, hinges: Hinges, drive: float, *, locked: bool) -> int:
    """Motions of boards without energy, those of the whole among them."""
    section = Section.solid(6.7e9, hinges.thickness, 0.3)
    mesh = meshed(sheet, hinges, drive)
    elements = [mesh.elements(section)]
    if locked:
        springs = rigid_stiffness(mesh, section)
        elements.append(hinge_elements(mesh, sheet.grid, springs))
    held = factorise(elements, mesh, NOWHERE, NOTHING, sheet.grid)
    return int(held.motions(np.zeros(len(held.springs), dtype=bool)).shape[1])


def test_pieces_of_the_shelter_lock_each_other() -> None:
    """Joined by free hinges along the edges in which their boards meet, they have no motion left;
    joined where they would move as one they have it.
    """
    design = shelter(4)
    sheet, hinges = design.mechanism, design.hinges
    assert isinstance(hinges, Hinges)
    assert motions(sheet, hinges, sheet.target_drive, locked=False) == 6
    assert motions(sheet, replace(hinges, joints=None), sheet.target_drive, locked=False) == 7


@pytest.mark.parametrize(
    "net", led_by([random_net(3, 3, 1), miura_net(3, 3)]), ids=["bent", "miura"]
)
def test_joined_pieces_take_energy_to_move(net: Net) -> None:
    """The softest motion takes at least a hundredth of what the next one of a sheet on hinges at
    the heights of its joints does, whose one motion takes none.
    """
    sheet = flat_foldable(net)
    thickness = 0.01 * float(np.ptp(sheet.positions(0.0), axis=(0, 1)).max())
    build = PanelSpec(thickness=thickness, construction="hinged", pieces=2)
    hinges = find_hinges(sheet, build)
    found, moving = (
        energies(meshed(sheet, each, sheet.target_drive), sheet.grid, thickness, locked=False)[0]
        for each in (hinges, replace(hinges, joints=None))
    )
    assert np.abs(moving[:7]).max() < 1e-14
    assert np.abs(found[:6]).max() < 1e-14
    assert found[6] > 0.01 * moving[7]


def test_joints_are_on_the_faces_of_boards() -> None:
    """6.5 mm from the middle of edges: half of the thickness, and half of a gap of 1 mm."""
    design = shelter(4)
    hinges, sheet = design.hinges, design.mechanism
    assert isinstance(hinges, Hinges)
    assert hinges.joints is not None
    flat, positions = sheet.positions(0.0), sheet.positions(sheet.target_drive)
    mesh = mesh_boards(hinged_plates(hinges, 0.001, flat, positions), sheet.grid, 3)
    assert mesh.offsets is not None
    edges, _, _ = crease_places(sheet.grid, 3)
    count = sheet.grid.columns - 1
    joined = np.isin(edges // count, [row + 1 for row in hinges.joints.rows])
    joined &= edges < sheet.grid.rows * count
    assert joined.sum() == 2 * count
    assert not mesh.offsets.heights[joined].any()
    assert mesh.offsets.heights.max() == pytest.approx(hinges.longest_arm)
    away = np.linalg.norm(mesh.offsets.arms.reshape(2, -1, 3), axis=-1)
    assert away[:, np.repeat(joined, 2)].max() < 0.007


WIDTH, FIRST, SECOND = 0.5, 1.0, 0.7
TURN = np.deg2rad(40)
STRIP = Grid(2, 3)
MODULUS, THICK = 8e9, 0.01
BENDS = MODULUS * THICK**3 / 12 * WIDTH


def strip(
    height: float, turn: float = TURN, fins: Section | None = None
) -> tuple[SheetMesh, Array]:
    """Two boards side by side, the second turned down about a hinge over their middles.

    Also the axis of the hinge, in the plane x z. The first begins at x = 0. With fins these stand
    on the boards.
    """
    axis = np.array([FIRST, height])
    way, normal = np.array([np.cos(turn), -np.sin(turn)]), np.array([np.sin(turn), np.cos(turn)])
    begin = axis - height * normal
    sides = [np.zeros(2), np.array([FIRST, 0.0]), begin, begin + SECOND * way]

    def ends(place: Array) -> list[list[float]]:
        return [[place[0], y, place[1]] for y in (WIDTH, 0.0)]

    (a, b), (c, d), (e, f), (g, h) = map(ends, sides)
    corners = np.array([[a, b, d, c], [e, f, h, g]])
    axes = np.zeros((len(STRIP.edges_vertices()), 2, 3))
    inner = int(np.flatnonzero(np.bincount(STRIP.faces_edges().ravel()) == 2)[0])
    axes[inner] = ends(axis)
    arms = np.zeros((len(axes), 2))
    if fins is not None:
        arms[inner] = height - 0.5 * THICK
    trimmed = 0.0 if fins is None else TRIMMED
    return mesh_boards(HingedPlates(corners, axes, arms, fins, trimmed), STRIP, 8), axis


def clamped(mesh: SheetMesh, held: Integers, stiffness: float, loads: Array) -> Array:
    """Displacements of points (N, 3) of boards without Poisson's effect, some dofs held."""
    section = Section.solid(MODULUS, THICK, 0.0)
    matrix = mesh.elements(section).assembled()
    for each in joint_elements(mesh, STRIP, stiffness):
        matrix = matrix + each.assembled()
    free = np.setdiff1d(np.arange(mesh.count), held)
    moved = np.zeros(mesh.count)
    moved[free] = spsolve(csr_array(matrix)[free][:, free].tocsc(), loads[free])
    return moved


def along(mesh: SheetMesh, panel: int, column: int) -> tuple[Integers, Integers]:
    """Nodes across the strip, and all their dofs, rotations included."""
    nodes = mesh.nodes[panel, :, column]
    turns = mesh.rotations()[panel, :, column]
    return nodes, np.concatenate([mesh.translations()[nodes].ravel(), turns.ravel()])


def shared(mesh: SheetMesh, nodes: Integers) -> Array:
    """Shares of nodes across the strip in a load that is even across it."""
    y = mesh.facets.points[nodes, 1]
    order = np.argsort(y)
    step = np.diff(y[order])
    share = np.zeros(len(y))
    share[order] = 0.5 * (np.append(step, 0) + np.append(0, step))
    return share / WIDTH


LOAD = np.array([3.0, -10.0])
"""At the end of the second board, along x and z."""


def hung_up(mesh: SheetMesh, stiffness: float) -> tuple[float, Array]:
    """The work of the load, the first board clamped, and displacements and rotations (D,)."""
    nodes, _ = along(mesh, 1, -1)
    forces = np.zeros_like(mesh.facets.points)
    forces[nodes[:, None], [0, 2]] = shared(mesh, nodes)[:, None] * LOAD
    _, foot = along(mesh, 0, 0)
    moved = clamped(mesh, foot, stiffness, mesh.loads(forces))
    return float(moved @ mesh.loads(forces)), moved


def moments(*ends: Array) -> Array:
    """Moments of the load about places on the way between two (2000,); its end is the last."""
    share = (np.arange(2000) + 0.5)[:, None] / 2000
    begin, end, tip = ends
    away = tip - (begin + share * (end - begin))
    return np.asarray(away[:, 0] * LOAD[1] - away[:, 1] * LOAD[0])


def beam(axis: Array) -> tuple[Array, Array, float]:
    """End and begin of the second board, and int m^2 ds over both boards."""
    way, normal = np.array([np.cos(TURN), -np.sin(TURN)]), np.array([np.sin(TURN), np.cos(TURN)])
    begin = axis - axis[1] * normal
    tip = begin + SECOND * way
    first = moments(np.zeros(2), np.array([FIRST, 0.0]), tip)
    second = moments(begin, tip, tip)
    return tip, begin, float(FIRST * np.mean(first**2) + SECOND * np.mean(second**2))


def test_a_locked_hinge_off_the_boards_is_a_rigid_corner() -> None:
    """A cantilever of two boards with a rigid corner of 80 mm, and a spring in it.

    By virtual work, with the moment m of the load about a place, w = int m^2/(EI) ds + m^2/k.
    Boards stretch a thousandth of that.
    """
    mesh, axis = strip(0.08)
    stiffness = 2e3
    tip, _, bends = beam(axis)
    at_axis = moments(axis, axis, tip)[0]
    expected = bends / BENDS + at_axis**2 / (stiffness * WIDTH)
    assert hung_up(mesh, stiffness)[0] == pytest.approx(expected, rel=2e-3)


def test_fins_bend() -> None:
    """The same cantilever, its corner two fins of 1 mm of steel on three fifths of the width.

    They take five sixths of the work. Their stress is 6 m/w^2, m at their foot.
    """
    wide, steel = 1e-3, 210e9
    mesh, axis = strip(0.08, fins=Section.solid(steel, wide, 0.0))
    assert mesh.offsets is not None
    work, moved = hung_up(mesh, 1e9)
    tip, begin, bends = beam(axis)
    length = 0.6 * WIDTH
    on_fins, at_feet = 0.0, []
    for board in (np.array([FIRST, 0.0]), begin):
        foot = board + 0.5 * THICK / 0.08 * (axis - board)
        found = moments(foot, axis, tip)
        on_fins += (0.08 - 0.5 * THICK) * float(np.mean(found**2))
        at_feet.append(np.abs(moments(foot, foot, tip)[0]))
    expected = bends / BENDS + on_fins / (steel * wide**3 / 12 * length)
    assert work == pytest.approx(expected, rel=0.02)
    section = Section.solid(MODULUS, THICK, 0.0)
    held = mesh.elements(section).forces(moved)
    nothing = np.zeros((mesh.nodes.size, 3))
    edges = find_edge_forces(mesh, STRIP, held, None, nothing)
    assert edges.hinged is not None
    stress = arm_stress(mesh.offsets, edges.hinged, wide)
    at_axis = np.abs(moments(axis, axis, tip)[0])
    largest = [6 * max(each, at_axis) / wide**2 / length for each in at_feet]
    np.testing.assert_allclose(stress[0], largest, rtol=0.03)


@pytest.mark.slow
def test_fins_leave_one_motion() -> None:
    """Fins that give, on one side of a hinge or on both, are no part of the boards' motion."""
    sheet, thickness = small_sheet(3)
    hinges = find_hinges(sheet, PanelSpec(thickness=thickness, construction="hinged"))
    section = Section.solid(1.0, thickness, 0.3)
    fins = Section.solid(30.0, 0.1 * thickness, 0.3)
    flat, positions = sheet.positions(0.0), sheet.positions(sheet.target_drive)
    mesh = mesh_boards(hinged_plates(hinges, 0.0, flat, positions, fins), sheet.grid, 3)
    assert mesh.offsets is not None
    kinds = set((mesh.offsets.heights[mesh.offsets.on_fins] > 0).sum(axis=1).tolist())
    assert kinds == {1, 2}
    free = [mesh.elements(section), *joint_elements(mesh, sheet.grid, 0.0)]
    locked = [mesh.elements(section), *joint_elements(mesh, sheet.grid, 1.0)]
    scale = np.ones(mesh.count)
    scale[3 * mesh.node_count :] = 0.1 / thickness
    for elements, count in ((free, 7), (locked, 6)):
        matrix = sum((each.assembled() for each in elements[1:]), elements[0].assembled())
        values = np.linalg.eigvalsh(matrix.toarray() * scale[:, None] * scale)
        assert np.abs(values[:count]).max() < 1e-13 * values[-1]
        assert values[count] > 1e2 * np.abs(values[:count]).max()


def test_a_free_hinge_off_the_boards_bends_them() -> None:
    """In a row, the second on a roller and pulled: its pull N at the hinge, h off, bends the first.

    The roller bears R = N h/l_2; the first board has N h and R at its end, and rises there by
    (N h/2 + R l_1/3) l_1^2/(EI).
    """
    height, pull = 0.05, 40.0
    mesh, _ = strip(height, turn=0.0)
    nodes, _ = along(mesh, 1, -1)
    _, foot = along(mesh, 0, 0)
    roller = mesh.translations()[nodes, 2]
    forces = np.zeros_like(mesh.facets.points)
    forces[nodes, 0] = shared(mesh, nodes) * pull
    moved = clamped(mesh, np.concatenate([foot, roller]), 0.0, mesh.loads(forces))
    edge = mesh.seats[0, 1:-1, -1]
    points = (points_by_dofs(mesh) @ moved).reshape(-1, 3)
    reaction = pull * height / SECOND
    expected = (0.5 * pull * height + reaction * FIRST / 3) * FIRST**2 / BENDS
    assert np.abs(points[edge, 2]).mean() == pytest.approx(expected, rel=5e-3)


def flattened(thickness: float) -> tuple[Design, Design]:
    """Figure 2's shell without flaps, as boards with hinges in the middle of edges; and as is."""
    file = read_design_file(EXAMPLES / "figure2.toml")
    pattern = file.pattern.sized(5, 6).model_copy(update={"flap": 0})
    design = pattern.design(file.f, file.g)
    rows, columns = design.mechanism.grid.rows - 1, design.mechanism.grid.columns - 1
    none = CreaseValues(np.zeros((rows - 1, columns)), np.zeros((rows, columns - 1)))
    arms = np.zeros((2, rows - 1, columns)), np.zeros((2, rows, columns - 1))
    levels = np.full((rows, columns), -0.5 * thickness)
    panel = PanelSpec(thickness=thickness, construction="hinged")
    hinges = Hinges(none, none, levels, thickness, arms)
    return replace(design, panel=panel, hinges=hinges), design


@pytest.mark.parametrize("creases", [0.0, np.inf])
def test_hinges_in_the_middle_of_edges_are_creases(creases: float) -> None:
    """But for their ends: corners are joined there in creases, and not in hinges.

    So work of loads differs by 19 and 17 % with 4 cells (free and rigid creases), by 5.1 and 4.8 %
    with 8, 2.4 and 2.3 % with 12, 1.4 and 1.3 % with 16: it falls with the square of their size.
    """
    whole, sheet = flattened(0.02)
    feet = find_feet(sheet)
    asked = STRUCTURE.replace_unchecked(crease_stiffness=(creases, creases))

    def work(design: Design, thickness: float | None, cells: int) -> float:
        structure = asked.replace_unchecked(thickness=thickness)
        model = Model(design, structure, Site("m", feet, (), 12.0), cells)
        if isinstance(design.hinges, Hinges):  # hinges along the whole of creases
            sheet = design.mechanism
            flat, positions = sheet.positions(0.0), sheet.positions(sheet.target_drive)
            plates = replace(hinged_plates(design.hinges, 0.0, flat, positions), trimmed=0.0)
            vars(model)["mesh"] = mesh_boards(plates, sheet.grid, cells)
        held = model.factorised(creases)
        forces = sum_forces(model.exposure, case_loads(model.exposure, SNOW, (SNOW,)))
        loads = held.free_loads(forces)
        return float(loads @ respond(held, loads).displacements)

    coarse, fine = (work(whole, None, cells) / work(sheet, 0.02, cells) - 1 for cells in (4, 8))
    assert 0.15 < coarse < 0.2
    assert 0.25 < fine / coarse < 0.3


def test_loads_on_an_arm_tip_it() -> None:
    """A board that stands on its hinge with arms of a: it tips under P a = k b.

    The loads are where its arms end, straight above the hinge.
    """
    mesh, _ = strip(0.0, turn=0.0)
    offsets = mesh.offsets
    assert offsets is not None
    arm, k = 0.1, 30.0
    arms = np.zeros_like(offsets.arms)
    second = np.isin(offsets.places, np.arange(mesh.nodes[0].size, mesh.nodes.size))
    arms[second, 2] = arm
    mesh = replace(mesh, offsets=replace(offsets, arms=arms))
    loads = np.zeros_like(mesh.facets.points)
    share = offsets.lengths[0, 1:-1] / WIDTH
    loads[mesh.node_count :][second, 2] = -share
    nothing = np.zeros((len(mesh.facets.triangles), 18))
    geometric = by_arms(mesh, nothing, loads)
    tips = np.zeros(mesh.count)
    tips[mesh.rotations()[1, ..., 1]] = 1.0
    turning = hinge_elements(mesh, STRIP, k).assembled()
    released, stored = (float(tips @ (each @ tips)) for each in (geometric, turning))
    assert stored == pytest.approx(k * WIDTH)
    assert released == pytest.approx(-arm)


def strip_of_shelter() -> tuple[Design, Site]:
    """The shelter, 4 columns of boards."""
    file = read_design_file(EXAMPLES / "shelter_hinged.toml")
    pattern = file.pattern.sized(7, 5)
    design = pattern.design(file.f, file.g)
    panel = PanelSpec(thickness=0.01, construction="hinged", gap=0.001)
    assert isinstance(design.mechanism, Straightened)
    mechanism = design.mechanism.straightened()
    hinges = find_hinges(mechanism, panel)
    design = replace(design, mechanism=mechanism, panel=panel, hinges=hinges)
    feet = find_feet(design)
    assert feet is not None
    return design, Site("m", feet, tuple(feet_ties(mechanism, feet.rows)), 6.8)


SUPPORTS = (
    Support(at="feet", kind="pinned"),
    Support(at="feet", kind="pinned", edges=True),
    Support(at="feet", kind="fixed", patch=0.12),
    Support(at="ends", kind="fixed", edges=True),
    Support(at="feet", kind="friction", friction=0.6),
)
HELD = [
    (support, (None, 210e9)[(number + turn) % 2])
    for turn in range(2)
    for number, support in enumerate(SUPPORTS)
]
"""Rigid arms and elastic ones by turns, and then the other way round."""


@pytest.mark.parametrize(("support", "arms"), led_by(HELD, 2))
def test_whole_boards_balance_their_loads(support: Support, arms: float | None) -> None:
    """To 1e-12 of them; every board to 1e-8."""
    design, site = strip_of_shelter()
    wind = Wind(speed=10, terrain="II", direction_deg=17.0)
    at = PointLoad(at=(2, 2), force=(3.0, -2.0, -5.0))
    cases = (
        SNOW,
        LoadCase(name="wind", self_weight=True, wind=wind),
        LoadCase(name="point", self_weight=True, points=(at,)),
    )
    structure = STRUCTURE.replace_unchecked(
        supports=(support,), cases=cases, cells=3, arm_modulus=arms
    )
    found = analyse(design, structure, site)
    assert any("taken as rigid" in each for each in found.warnings) == (arms is None)
    held = [case for case in found.cases if case.equilibrium is not None]
    assert len(held) >= 3
    for case in held:
        assert case.equilibrium is not None
        assert case.equilibrium.residual < 1e-12
        assert case.equilibrium.panel_residual < 1e-8
        np.testing.assert_allclose(
            case.equilibrium.reaction,
            -case.forces.sum(axis=0),
            atol=1e-12 * np.abs(case.forces).sum(),
        )


def test_they_stand_where_ties_are_fixed() -> None:
    """To half of the gap of 1 mm, by which edges are off their creases."""
    design, site = strip_of_shelter()
    model = Model(design, STRUCTURE, site, 3)
    vertices = model.mesh.facets.points[model.grid.vertices()]
    rows = np.tile([0, model.grid.rows - 1], (model.grid.columns, 1))
    columns = np.arange(model.grid.columns)
    sheet = design.mechanism
    fixed = Fixings(sheet, rows, columns, design.hinges).at(sheet.target_drive)
    assert np.abs(vertices[rows, columns[:, None]] - fixed).max() < 0.000501


def test_weight_is_that_of_the_boards() -> None:
    design, site = strip_of_shelter()
    model = Model(design, STRUCTURE, site, 3)
    assert model.mass == pytest.approx(6.8 * area_of(design.mechanism))


@pytest.mark.parametrize(("key", "value"), [("cells", 2), ("nonlinear", True)])
def test_what_is_not_analysed_is_refused(key: str, value: bool | int) -> None:
    design, site = strip_of_shelter()
    with pytest.raises(InputError) as caught:
        analyse(design, STRUCTURE.replace_unchecked(**{key: value}), site)
    assert caught.value.keys == (f"structure.{key}",)
