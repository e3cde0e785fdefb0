"""Supports along edges and over patches, beside points: what they hold, and what it does."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from pydantic import ValidationError

from orishell.conventions.errors import InputError
from orishell.deployment import Site
from orishell.deployment.feet import find_feet
from orishell.design import Design
from orishell.design_file import read_design_file
from orishell.structure import Analysis, LoadCase, Structure, Support
from orishell.structure.analyse import analyse
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.results import buckles_at_points
from samples import led_by, thorough

EXAMPLES = Path(__file__).parents[2] / "examples"
OWN = (LoadCase(name="own weight", self_weight=True),)
MASS = 1.9
POINTS = Support(at="feet", kind="pinned")


def designed(name: str, tmp_path: Path, **changes: str) -> Design:
    text = (EXAMPLES / f"{name}.toml").read_text()
    for old, new in changes.items():
        assert f"\n{old} = " in text
        lines = text.split("\n")
        text = "\n".join(
            f"{old} = {new}" if each.startswith(f"{old} = ") else each for each in lines
        )
    file = tmp_path / "design.toml"
    file.write_text(text.replace("range = [0, 6]", "range = [0, 2]"))
    found = read_design_file(file)
    return found.pattern.design(found.f, found.g)


@pytest.fixture
def strip(tmp_path: Path) -> Design:
    """A strip of the shelter, 5 columns, 2 m long."""
    return designed("shelter", tmp_path, columns="5", flap="0")


def analysed(design: Design, support: Support, cells: int, modulus: float = 8e9) -> Analysis:
    structure = Structure(
        modulus=modulus, poisson=0.3, supports=(support,), cases=OWN, thickness=0.01, cells=cells
    ).replace_unchecked(crease_stiffness=(np.inf, np.inf))
    return analyse(design, structure, Site("m", find_feet(design), (), MASS))


def equilibrium(found: Analysis) -> Equilibrium:
    (case,) = found.cases
    assert case.equilibrium is not None
    return case.equilibrium


def test_reactions_of_edges_and_patches_are_summed_at_feet(strip: Design) -> None:
    """All of the load, at as many vertices as there are feet, symmetric as the strip is."""
    for support in (
        Support(at="feet", kind="pinned", edges=True),
        Support(at="feet", kind="fixed", patch=0.2),
        Support(at="feet", kind="fixed", edges=True),
    ):
        found = analysed(strip, support, 4)
        case = equilibrium(found)
        assert len(case.reactions) == 10
        assert case.residual < 1e-12
        up = case.support_forces[:, 2].reshape(2, 5)
        assert up.sum() == pytest.approx(-found.cases[0].load[2], rel=1e-12)
        np.testing.assert_allclose(up, up[:, ::-1], rtol=1e-6, atol=1e-6 * up.sum())
        restrained = found.model.supports.restrained
        assert len(np.unique(restrained[:, 0])) > 10
        assert np.abs(case.displacements[restrained[:, 0]]).max() == 0.0
        assert not found.model.supports.points.size


@thorough
def test_feet_along_edges_converge(strip: Design) -> None:
    """221.4 by a p-version shell of ours: 223 where 8 and 12 cells go to, by the square of sizes.

    CalculiX has 233 to 259.
    """
    support = Support(at="feet", kind="pinned", edges=True)
    coarse, fine = (equilibrium(analysed(strip, support, cells)).buckling for cells in (8, 12))
    assert coarse is not None
    assert fine is not None
    assert fine == pytest.approx(221.4, rel=0.02)
    assert fine + (fine - coarse) / ((12 / 8) ** 2 - 1) == pytest.approx(221.4, rel=0.02)


@pytest.mark.slow
def test_a_patch_converges(strip: Design) -> None:
    """From 6 to 8 cells its factor changes by 3 %, rising; what is local there is far above."""
    support = Support(at="feet", kind="pinned", patch=0.2)
    coarse, fine = (equilibrium(analysed(strip, support, cells)) for cells in (6, 8))
    assert coarse.buckling is not None
    assert fine.buckling == pytest.approx(coarse.buckling, rel=0.04)
    assert not buckles_at_points(fine)


@pytest.mark.slow
@pytest.mark.parametrize("cells", led_by([4, 6]))
def test_points_that_spoil_buckling_are_warned_of(strip: Design, cells: int) -> None:
    """Soft enough for the factor to matter; with cells of any size, and not if edges are held."""
    soft = analysed(strip, POINTS, cells, modulus=2e8)
    assert any("buckling is local to supports held at a point" in each for each in soft.warnings)
    held = analysed(strip, Support(at="feet", kind="pinned", edges=True), cells, modulus=2e8)
    assert not any("local" in each for each in held.warnings)
    stiff = analysed(strip, POINTS, cells)
    assert not any("local" in each for each in stiff.warnings)


def test_a_patch_smaller_than_cells_is_warned_of(strip: Design) -> None:
    found = analysed(strip, Support(at="feet", kind="pinned", patch=0.01), 2)
    assert any("patch of 0.01 m is smaller than the cells" in each for each in found.warnings)


def test_edges_off_the_ground_are_refused(tmp_path: Path) -> None:
    """The vault's feet are at several heights."""
    vault = designed("vault", tmp_path)
    with pytest.raises(InputError, match="not on the ground"):
        analysed(vault, Support(at="feet", kind="pinned", edges=True), 2)


def test_edges_that_are_not_there_are_refused(strip: Design) -> None:
    lone = Support(at=((0, 0), (0, 2)), kind="pinned", edges=True)
    with pytest.raises(InputError, match="no edge of a panel joins"):
        analysed(strip, lone, 2)


@pytest.mark.parametrize(
    ("keys", "said"),
    [
        ({"kind": "pinned", "edges": True, "patch": 0.1}, "either edges or patch"),
        ({"kind": "friction", "friction": 0.4, "patch": 0.1}, "no patch where kind = friction"),
        ({"kind": "friction", "friction": 0.4, "edges": True}, "no edges where kind = friction"),
    ],
)
def test_keys_that_do_not_go_together(keys: dict[str, object], said: str) -> None:
    with pytest.raises(ValidationError, match=said):
        Support.model_validate({"at": "feet", **keys})
