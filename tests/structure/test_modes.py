"""What moves freely, and what vibrates, against closed forms."""

from __future__ import annotations

import itertools
from pathlib import Path

import numpy as np
import pytest
from scipy.sparse import csr_array, diags_array

from fitted_shells import fitted
from orishell.deployment import Site, feet_ties
from orishell.deployment.feet import find_feet
from orishell.design import Design
from orishell.design_file import read_design_file
from orishell.motion import Mechanism
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array
from orishell.structure.mesh.sections import Section
from orishell.structure.mesh.sheet import mesh_sheet
from orishell.structure.model import Model
from orishell.structure.settings import Structure, Support
from orishell.structure.solve.conditions import joined, on_ground
from orishell.structure.solve.factorise import factorise
from orishell.structure.solve.stability import (
    Inverse,
    find_frequencies,
    largest_values,
)
from samples import led_by

EXAMPLES = Path(__file__).parents[2] / "examples"
NOTHING = joined([on_ground(np.zeros(0, np.int64), np.zeros(0))])

PINNED = Support(at="feet", kind="pinned")


def designed(name: str, rows: int, columns: int) -> Design:
    file = read_design_file(EXAMPLES / f"{name}.toml")
    pattern = file.pattern.sized(rows, columns)
    if name == "figure3":
        pattern = pattern.model_copy(update={"column_lengths": "auto"})
    return pattern.design(file.f, file.g)


SHARES = [0.2, 0.35, 0.5, 0.65, 0.8]


@pytest.mark.parametrize("share", led_by([0.5, *sorted({*SHARES} - {0.5})]))
@pytest.mark.parametrize(
    ("name", "rows", "columns"), [("figure1", 3, 4), ("figure2", 5, 6), ("figure3", 2, 4)]
)
def test_hinged_panels_have_one_motion_of_their_own(
    name: str, rows: int, columns: int, share: float
) -> None:
    require_one_motion(designed(name, rows, columns).mechanism.without_flaps(), share)


@pytest.mark.parametrize(
    ("surface", "share"),
    led_by(
        sorted(
            itertools.product(["cap", "saddle .5", "roof"], SHARES),
            key=lambda each: each not in {("cap", 0.2), ("saddle .5", 0.5), ("roof", 0.8)},
        ),
        3,
    ),
)
def test_fitted_shells_have_one_motion_of_their_own(surface: str, share: float) -> None:
    """The seventh mode was 1e-17 of the stiffest, the eighth 1e-8 and more."""
    require_one_motion(fitted(surface, 5).mechanism, share)


def require_one_motion(mechanism: Mechanism, share: float) -> None:
    """Seven modes without energy, and the derivative of the closed form is among them."""
    size = float(np.ptp(mechanism.positions(0.0), axis=(0, 1)).max())
    drive = share * mechanism.target_drive
    mesh = mesh_sheet(mechanism.positions(drive), mechanism.grid, 2)
    section = Section.solid(1.0, 0.05 * size, 0.3)
    stiffness = mesh.elements(section).assembled().toarray()
    scale = np.ones(mesh.count)
    scale[3 * len(mesh.facets.points) :] = 10 / size  # rotations as lengths
    values, modes = np.linalg.eigh(stiffness * scale[:, None] * scale)
    assert np.abs(values[:7]).max() < 1e-14 * values[-1]
    assert values[7] > 10 * np.abs(values[:7]).max()
    step = 1e-5
    moved = mechanism.positions(drive + step) - mechanism.positions(drive - step)
    velocity = moved.ravel() / (2 * step)
    free = modes[: velocity.size, :7]
    rest = velocity - free @ np.linalg.lstsq(free, velocity, rcond=None)[0]
    assert np.linalg.norm(rest) < 1e-6 * np.linalg.norm(velocity)


@pytest.mark.parametrize("name", ["figure1", "figure2"])
def test_flaps_and_ties_leave_only_the_motions_of_the_whole(name: str) -> None:
    """Free hinges, no supports, at the target: 7 motions; 6 with flaps in contact and ties taut."""
    design = designed(name, 5, 6).with_clipped_flaps()
    feet = find_feet(design)
    assert feet is not None
    ties = tuple(feet_ties(design.mechanism, feet.rows))
    structure = Structure(
        modulus=1e9,
        poisson=0.3,
        supports=(PINNED,),
        cases=(),
        thickness=0.01,
    ).replace_unchecked(supports=(PINNED.replace_unchecked(kind="friction"),))
    model = Model(design, structure, Site("m", feet, ties, 1.0), 2)
    sprung = model.factorised(0.0)
    count = len(ties) + len(model.flaps)
    assert count > len(ties)
    nobody = np.zeros(len(sprung.springs), dtype=bool)
    assert sprung.motions(nobody).shape[1] == 7
    for those in (slice(0, len(ties)), slice(len(ties), count), slice(0, count)):
        active = nobody.copy()
        active[those] = True
        assert sprung.motions(active).shape[1] == 6


SIDE, PLATE = 2.0, Section.solid(70e9, 0.01, 0.3)
BENDING = 70e9 * 0.01**3 / 12 / (1 - 0.3**2)


def square() -> Array:
    x, y = np.meshgrid([0.0, SIDE], [SIDE, 0.0])
    return np.stack([x, y, 0 * x], axis=-1)


def plate(cells: int) -> tuple[Inverse, Array, int]:
    """A panel whose sides are held up, and which stays plane: also areas of nodes and dofs."""
    mesh = mesh_sheet(square(), Grid(2, 2), cells)
    facets, own = mesh.facets, mesh.translations()
    rim = (np.abs(facets.points[:, :2] - 0.5 * SIDE) == 0.5 * SIDE).any(axis=1)
    supported = [own[rim][:, 2], own[:, :2].ravel(), mesh.rotations()[..., 2].ravel()]
    elements = [mesh.elements(PLATE)]
    held = factorise(elements, mesh, np.unique(np.concatenate(supported)), NOTHING, Grid(2, 2))
    area = np.zeros(len(facets.points))
    np.add.at(area, facets.triangles, facets.areas()[:, None] / 3)
    nobody = np.zeros(len(held.springs), dtype=bool)
    return Inverse.of(held, nobody, np.zeros((len(held.free), 0))), area, mesh.count


def test_frequencies_of_a_plate() -> None:
    """pi/2 (m^2 + n^2)/a^2 sqrt(D/mass per area), simply supported: 2, 5 and 5 of them."""
    inverse, area, count = plate(16)
    mass = np.zeros(count)
    mass[: 3 * len(area)] = np.repeat(27.0 * area, 3)
    heavy = csr_array(diags_array(mass[inverse.structure.free]))
    found, _ = find_frequencies(inverse, heavy, 3)
    one = 0.5 * np.pi / SIDE**2 * np.sqrt(BENDING / 27.0)
    np.testing.assert_allclose(found, one * np.array([2, 5, 5]), rtol=0.01)


def test_a_start_of_exact_vectors_does_not_hide_larger_ones() -> None:
    """K is 1 and A diagonal, so its vectors are axes; the start has the second to the fourth."""
    values = np.linspace(10.0, 1.0, 40)
    start = np.concatenate(
        [np.eye(40)[:, 1:4], np.random.default_rng(1).standard_normal((40, 2))], axis=1
    )
    found, _, _ = largest_values(
        lambda loads: loads,
        lambda moved: moved,
        lambda moved: values[:, None] * moved,
        start,
        3,
        blocks=80,
    )
    np.testing.assert_allclose(found, values[:3], rtol=1e-6)
