"""Gussets as plates of a structure: against CalculiX, and in balance.

Four panels about one vertex, a thin gusset in the valley between the upper and the lower two, all
hinged along the edges that they share. It is held as a rigid body is, so that without the gusset it
folds. Whole shells against CalculiX: ``test_gussets_in_calculix``.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.sparse.linalg import splu

from calculix_tool import run_calculix
from documents import EXAMPLES
from orishell.deployment import Site
from orishell.deployment.feet import find_feet
from orishell.design.stiffeners import Stiffeners
from orishell.design_file import read_design_file
from orishell.locking import lock_without_clash
from orishell.locking.gussets import with_gussets
from orishell.motion import area_of
from orishell.structure.analyse import analyse
from orishell.structure.load_settings import LoadCase
from orishell.structure.loaded import loaded_shell
from orishell.structure.loads import Load, case_loads, sum_forces
from orishell.structure.mesh.plane import tensors_along
from orishell.structure.mesh.stresses import PanelStresses
from orishell.structure.model import Model
from orishell.structure.plates import used_of_plates
from orishell.structure.settings import Structure, Support
from orishell.structure.solve.active_set import respond
from stiffened_cells import Cell, four_panels


def test_calculix_agrees(tmp_path: Path) -> None:
    """Displacements at both loaded vertices at two meshes, and the factor, which is the gusset's.

    Displacements are found within 1.3 % of theirs. Factors are 1.689 and 1.666 with 4 and 8 cells;
    theirs, 1.846 and 1.724, go to 1.683 as cells shrink (Richardson).
    """
    factors: list[float] = []
    for cells in (4, 8):
        cell = Cell.of(cells, four_panels())
        moved, factor = cell.solved()
        deck = tmp_path / f"cell{cells}.inp"
        cell.deck(deck)
        answers = run_calculix(deck)
        ours = cell.displaced(moved)
        theirs = answers.displacements[0]
        most = float(np.abs(theirs).max())
        np.testing.assert_allclose(ours, theirs, rtol=0, atol=0.025 * most)
        factors.append(answers.buckling[0])
    coarse, fine = factors
    assert factor == pytest.approx((4 * fine - coarse) / 3, rel=0.05)


def test_without_it_the_sheet_folds() -> None:
    """One shape of the sheet takes no force: with the gusset there is none."""
    cell = Cell.of(4, four_panels())
    count = cell.sheet.count
    bare = cell.sheet.elements(cell.section).assembled()
    both = bare + cell.plates.elements(cell.plate, count).assembled()
    own = np.unique(cell.sheet.dofs())
    loosest = []
    for matrix, dofs in ((bare, own), (both, np.arange(count))):
        free = np.setdiff1d(dofs, cell.held())
        values = np.linalg.eigvalsh(matrix[free][:, free].toarray())
        loosest.append(values[:2] / values[-1])
    assert loosest[0][0] < 1e-14
    assert min(loosest[0][1], loosest[1][0]) > 1e-11


def test_moved_as_a_whole_it_bears_nothing() -> None:
    """Six motions of the whole take no force."""
    cell = Cell.of(4, four_panels())
    sheet = cell.sheet
    middle, size = np.array([0.3, -0.2, 0.4]), 2.0
    stiffness = cell.plates.elements(cell.plate, sheet.count)
    most = float(np.abs(stiffness.matrices).max())
    for axis, unit in enumerate(np.eye(3)):
        motions = np.zeros((sheet.count, 6))
        motions[sheet.translations()[:, axis], axis] = 1.0
        away = sheet.facets.points - middle
        motions[sheet.translations(), 3 + axis] = np.cross(unit, away) / size
        motions[cell.plates.turns[:, axis], 3 + axis] = 1 / size
        for moved in (motions[:, axis], motions[:, 3 + axis]):
            assert np.abs(stiffness.total(moved)).max() < 1e-12 * most


def test_a_shell_with_gussets_is_solved_as_its_matrix_is() -> None:
    """All of a model, factorised part by part: displacements as of the whole matrix at once.

    With small loads large displacements, followed step by step, are those of linear theory.
    """
    file = read_design_file(EXAMPLES / "figure2.toml")
    pattern = file.pattern.model_copy(update={"rows": 5, "columns": 4, "flap": 0.0})
    design = pattern.design(file.f, file.g)
    asked = Stiffeners(kind="gussets", share=0.7)
    design = with_gussets(design, lock_without_clash(design), asked, 1e-9)
    structure = Structure(
        modulus=8e9,
        thickness=0.01,
        supports=(Support(at="feet", kind="pinned"),),
        cases=(LoadCase(name="dead", self_weight=True),),
        crease_stiffness=(0.0, 0.0),
        cells=3,
        nonlinear=True,
    )
    site = Site("m", find_feet(design), (), 0.01)
    model = Model(design, structure, site, 3)
    found = model.factorised(0.0)
    loads = found.free_loads(sum_forces(model.exposure, _dead(model)))
    response = respond(found, loads)
    assert response.moves is None
    matrix = sum((each.assembled() for each in found.elements[1:]), found.elements[0].assembled())
    direct = splu(matrix[found.free][:, found.free].tocsc()).solve(loads)
    np.testing.assert_allclose(
        response.displacements, direct, rtol=0, atol=1e-7 * np.abs(direct).max()
    )
    (case,) = analyse(design, structure, site).cases
    assert case.equilibrium is not None
    path = case.equilibrium.path
    assert path is not None
    assert path.carries
    assert case.equilibrium.displacement.size == pytest.approx(path.linear_displacement, rel=1e-3)
    linear = analyse(design, structure.replace_unchecked(nonlinear=False), site).cases[0]
    assert linear.equilibrium is not None
    followed, straight = case.equilibrium.gussets, linear.equilibrium.gussets
    assert followed is not None
    assert straight is not None
    assert followed.size == pytest.approx(straight.size, rel=1e-3)
    assert followed.at == straight.at
    loaded = loaded_shell(model, ())
    parts = loaded.parts
    assert parts is not None
    (plates,) = model.plates
    ends = plates.nodes.reshape(plates.own.nodes.shape)[:, [0, -1, 0], [0, 0, -1]]
    wanted = [part.shell.positions[[0, 1, 3]] for part in design.plates]
    np.testing.assert_allclose(model.mesh.facets.points[ends], wanted, rtol=0, atol=1e-9)
    corners = loaded.points[parts.triangles.reshape(len(design.plates), -1, 3)]
    normals = np.cross(corners[:, :, 1] - corners[:, :, 0], corners[:, :, 2] - corners[:, :, 0])
    areas = [part.areas().sum() for part in design.plates]
    np.testing.assert_allclose(np.linalg.norm(normals.sum(axis=1), axis=1) / 2, areas, rtol=1e-9)
    np.testing.assert_allclose(np.linalg.norm(normals, axis=2).sum(axis=1) / 2, areas, rtol=1e-9)
    mass = 0.01 * (area_of(design.mechanism) + sum(part.areas().sum() for part in design.plates))
    assert model.mass == pytest.approx(mass, rel=1e-12)


def test_plywood_uses_no_less_than_by_its_grain() -> None:
    """Random stresses of one patch, grain along its first axis, across it, or at 45 degrees."""
    structure = Structure(
        material="birch plywood",
        modulus=8e9,
        thickness=0.01,
        supports=(Support(at="feet", kind="pinned"),),
        cases=(LoadCase(name="dead", self_weight=True),),
    )
    grain = structure.grain_strength("permanent", "m")
    assert grain is not None
    random, none, one = np.random.default_rng(5), np.zeros((1, 2)), np.zeros(1, np.int64)
    for _ in range(300):
        direct, bent = random.normal(size=(2, 1, 3)) * 1e6 * random.uniform(0, 1, size=(2, 1, 1))
        used = used_of_plates(
            structure, (PanelStresses(one, one, direct, bent, none),), "permanent", "m"
        )
        assert used is not None
        for turn in (0.0, 0.25 * np.pi, 0.5 * np.pi):
            way = np.cos(turn), np.sin(turn)
            along = [tensors_along(each, *map(np.array, way)) for each in (direct, bent)]
            for solid in (True, False):
                shares = grain.of_axes(*along, solid=solid)
                assert used >= np.linalg.norm(shares, axis=-1).max() * (1 - 1e-12)


def _dead(model: Model) -> tuple[Load, ...]:
    cases = model.structure.cases
    return case_loads(model.exposure, cases[0], cases)
