"""Whole shells that are followed to large displacements."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from followed_shells import asked, held, linear
from orishell.deployment import Site
from orishell.deployment.feet import find_feet
from orishell.design_file import read_design_file
from orishell.structure.analyse import analyse
from orishell.structure.settings import LoadCase, Structure, Support
from samples import led_by, thorough

EXAMPLES = Path(__file__).parents[2] / "examples"


SMALL = [
    {"kind": "fixed", "crease": 50.0},
    {"kind": "sliding", "tied": True, "tie_stiffness": 2e5},
    {"kind": "sliding", "tied": True, "crease": "free", "flap": 0.03},
    {"kind": "friction", "friction": 0.4},  # some feet slip, and some lift off
    {"kind": "pinned"},
    {"kind": "pinned", "crease": "free", "flap": 0.03},
    {"kind": "sliding", "tied": True},
    {"kind": "friction", "friction": 10.0},
    {"kind": "friction", "friction": 0.5},  # some feet slip
]


@pytest.mark.parametrize("keys", led_by(SMALL, 4))
def test_small_loads_do_what_linear_theory_says(keys: dict[str, Any]) -> None:
    """To 1e-4, whatever holds the shell: a thousandth of a kilogram per square metre."""
    followed = asked(mass=1e-3, **keys)
    found, expected = held(followed), linear(followed)
    assert found.path is not None
    assert found.path.carries
    for name in ("displacements", "support_forces", "tie_forces", "flap_forces", "stresses"):
        one, other = getattr(found, name), getattr(expected, name)
        np.testing.assert_allclose(one, other, atol=1e-4 * np.abs(other).max(initial=0.0))
    assert found.path.linear_displacement == pytest.approx(expected.displacement.size, rel=1e-9)


def test_it_balances_as_it_is_moved() -> None:
    """Forces and moments about deformed places; the crown sinks further than linear theory says."""
    followed = asked("pinned", 40.0, thickness=0.003)
    found = held(followed)
    assert found.path is not None
    assert found.path.carries
    assert found.residual < 1e-8
    load = np.array(followed.cases[0].load)
    np.testing.assert_allclose(
        np.array(found.reaction), -load, atol=1e-8 * float(np.linalg.norm(load))
    )
    assert found.displacement.size > 1.05 * found.path.linear_displacement
    factors, sizes = np.array(found.path.factors), np.array(found.path.displacements)
    assert factors[0] == sizes[0] == 0
    assert factors[-1] == 1
    assert (np.diff(factors) > 0).all()


def test_ties_pull_by_their_stretch_as_they_are() -> None:
    """Force is EA times stretch of the deformed length, and balances the thrust of the feet."""
    followed = asked("sliding", 40.0, tied=True, tie_stiffness=2e5, thickness=0.004)
    found, model = held(followed), followed.model
    ends = model.nodes_of(model.site.ties)
    before = model.mesh.facets.points[ends]
    after = before + found.displacements[ends]
    length, now = (np.linalg.norm(each[:, 1] - each[:, 0], axis=1) for each in (before, after))
    pulls = np.maximum(2e5 * (now / length - 1), 0)
    np.testing.assert_allclose(found.tie_forces, pulls, rtol=1e-3, atol=1e-3 * pulls.max())
    assert found.residual < 1e-8


def test_a_shell_that_snaps_does_not_carry() -> None:
    """Linear theory buckles it at 0.961 of its loads; it is softer by then, and snaps before."""
    case = asked("pinned", 60.0, thickness=0.003).cases[0]
    found = case.equilibrium
    assert found is not None
    assert found.path is not None
    assert found.path.ending == "snaps"
    assert found.path.linear_buckling is not None
    assert 0.9 < found.path.reached / found.path.linear_buckling < 1
    assert found.buckling == found.path.reached
    assert case.carries is False
    assert "snaps" in case.in_words()
    # Also where a code asks for displacements alone: no search may take it for a shell that stands.
    assert replace(case, limit_state="SLS").used > 1
    assert found.residual < 1e-8


def test_feet_slide_and_lift_off() -> None:
    """A vault that needs 1.4 times the friction there is spreads, and some feet lose the ground.

    Friction is Coulomb's under the forces as they are, and the vault, flatter by then, thrusts more
    than linear theory knows: it slides further.
    """
    followed = asked("friction", 5.0, friction=0.4)
    found, expected = held(followed), linear(followed)
    assert found.path is not None
    assert found.path.carries
    assert found.residual < 1e-8
    assert {foot.state for foot in found.feet} == {"slips", "lifted"}
    points = followed.model.mesh.facets.points
    nodes = dict(zip(followed.model.grounded, followed.model.supports.ground, strict=True))
    for foot, other in zip(found.feet, expected.feet, strict=True):
        assert foot.state == other.state
        moved = found.displacements[nodes[foot.at]]
        if foot.state == "lifted":
            assert foot.gap == pytest.approx(moved[2])
            assert foot.gap > 0
        else:
            assert abs(moved[2]) < 1e-9
            assert foot.used == pytest.approx(1.0, rel=1e-9)
            assert foot.slip == pytest.approx(moved[:2])
            away = points[nodes[foot.at]] - points.mean(axis=0)
            if foot.slipped > 1e-4:
                assert np.dot(foot.slip, away[:2]) > 0
    furthest = max(foot.slipped for foot in found.feet)
    assert 1 < furthest / max(foot.slipped for foot in expected.feet) < 1.2


@thorough
def test_a_shell_that_buckles_and_holds() -> None:
    """Figure 2's, 3 mm thick: linear theory has 34 mm; CalculiX, NLGEOM, 52 mm. Here 50.4 mm.

    It buckles into waves at a third of its load.
    """
    file = read_design_file(EXAMPLES / "figure2.toml")
    design = file.pattern.model_copy(update={"flap": 0}).design(file.f, file.g)
    feet = find_feet(design)
    assert feet is not None
    structure = Structure(
        modulus=8e9,
        thickness=0.003,
        cells=6,
        nonlinear=True,
        imperfection=0.0,
        supports=(Support(at="feet", kind="pinned"),),
        cases=(LoadCase(name="own weight", self_weight=True),),
    ).replace_unchecked(crease_stiffness=(np.inf, np.inf))
    found = held(analyse(design, structure, Site("m", feet, (), 15.54)))
    assert found.path is not None
    assert found.path.carries
    assert found.path.linear_displacement == pytest.approx(0.034, rel=0.02)
    assert found.displacement.size == pytest.approx(0.052, rel=0.035)


def test_linear_theory_says_where_it_misleads() -> None:
    """Displaced by more than 5 % of its height, or a buckling factor below 3; not if followed."""
    soft = asked("pinned", 60.0, thickness=0.003, nonlinear=False)
    assert any("nonlinear = true" in text for text in soft.warnings)
    followed = asked("pinned", 60.0, thickness=0.003)
    assert not any("nonlinear = true" in text for text in followed.warnings)
    assert "pressure that turns" in followed.not_covered[0]
    assert "large displacements" in soft.not_covered[0]


@pytest.mark.parametrize("friction", [0.5, 1.0])
def test_feet_that_slip_leave_no_point_that_is_not_in_balance(friction: float) -> None:
    """Of so small a load 7e-4 and less are rounding: that is no balance."""
    found = held(asked("friction", mass=1e-3, friction=friction))
    assert found.path is not None
    assert found.panel_residual < 1e-6
    assert found.residual < 1e-6


@pytest.mark.parametrize("off", [0.001, 0.004])
def test_an_imperfect_shell_goes_further_the_way_it_buckles(off: float) -> None:
    """Off by a w_1 it moves by a w_1/(factor - 1) more, as columns do: Southwell's relation.

    By the component along the first buckling mode, of a shell far from buckling, within 5 %.
    """
    perfect, built = (asked("pinned", 30.0, imperfection=each) for each in (0.0, off))
    first = linear(perfect)
    assert first.buckling is not None
    assert first.buckling > 3
    mode = first.buckling_modes[0]
    way = np.sign((mode * first.displacements).sum())
    more = held(built).displacements - held(perfect).displacements
    along = way * (more * mode).sum() / (mode**2).sum()
    assert along == pytest.approx(off / (first.buckling - 1), rel=0.05)
    assert "imperfections of fit" in " ".join(built.not_covered)
    assert held(built).model is not held(perfect).model
    assert np.array_equal(built.model.mesh.facets.points, perfect.model.mesh.facets.points)


def test_an_imperfection_is_followed_or_refused() -> None:
    with pytest.raises(ValueError, match="imperfection"):
        asked("pinned", 30.0, nonlinear=False, imperfection=0.001)
