"""Whole shells: reactions against loads, symmetry, superposition, and what moves."""

from __future__ import annotations

import itertools
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial import cKDTree

from orishell.deployment import Site, feet_ties
from orishell.deployment.feet import find_feet
from orishell.design import Design
from orishell.design_file import read_design_file
from orishell.structure.analyse import analyse
from orishell.structure.load_settings import LoadCase, PointLoad, Snow, Wind
from orishell.structure.results import Analysis
from orishell.structure.settings import Structure, Support
from samples import led_by, thorough

EXAMPLES = Path(__file__).parents[2] / "examples"
SMOOTH = Support(at="feet", kind="pinned").replace_unchecked(kind="friction")
"""Ground that only pushes."""
NOTHING = LoadCase(name="none", self_weight=True).replace_unchecked(self_weight=False)
LIGHT = 1e-3
"""Share of usual loads, so that no case buckles soon: then it would be followed, not linear."""
WIND = Wind(
    speed=10 * LIGHT**0.5,
    terrain="II",
    direction_deg=17.0,
    coefficients=((0.0, 0.8), (90.0, -0.6), (180.0, -0.4)),
)
CASES = (
    LoadCase(name="dead", self_weight=True),
    LoadCase(name="snow", snow=Snow(ground=500.0 * LIGHT, arrangement="undrifted")),
    LoadCase(name="wind", wind=WIND),
    LoadCase(
        name="point",
        self_weight=True,
        points=(PointLoad(at=(2, 2), force=(3 * LIGHT, -2 * LIGHT, -5 * LIGHT)),),
    ),
)
MODULUS, THICKNESS = 270e6, 0.01
STRUCTURE = Structure(
    modulus=MODULUS,
    poisson=0.3,
    supports=(Support(at="feet", kind="pinned"),),
    cases=CASES,
    thickness=THICKNESS,
    cells=2,
)


PINNED, ENDS = Support(at="feet", kind="pinned"), Support(at="ends", kind="fixed")
SUPPORTS = (
    *(PINNED, SMOOTH, ENDS),
    *(Support(at="feet", kind=kind) for kind in ("fixed", "sliding")),
)
FIRST, SECOND = ("figure1", 3, 4), ("figure2", 5, 6)
FREE_AND_RIGID, SPRUNG = (0.0, np.inf), (20.0, 20.0)
CHOICES = (FIRST, SECOND), (FREE_AND_RIGID, SPRUNG), (False, True)
PAIRS = [
    (CHOICES[0][(k + crease) % 2], CHOICES[1][crease], support, CHOICES[2][(crease + (k > 1)) % 2])
    for k, support in enumerate(SUPPORTS)
    for crease in range(2)
]
"""Each two of shells, creases, supports and ties are in one of them."""
ALL = [*itertools.product((FIRST, SECOND), (FREE_AND_RIGID, SPRUNG), SUPPORTS, (False, True))]


@cache
def designed(name: str, rows: int, columns: int) -> Design:
    file = read_design_file(EXAMPLES / f"{name}.toml")
    pattern = file.pattern.sized(rows, columns)
    return pattern.design(file.f, file.g)


def analysed(
    structure: Structure, shell: tuple[str, int, int] = ("figure2", 7, 9), *, tied: bool = False
) -> Analysis:
    design = designed(*shell)
    feet = find_feet(design)
    assert feet is not None
    inner = design.mechanism.inner_columns
    ends = range(inner.start, inner.stop)
    ties = tuple(((feet.rows[0], each), (feet.rows[1], each)) for each in ends) if tied else ()
    return analyse(design, structure, Site("m", feet, ties, 1.9 * LIGHT))


@pytest.mark.parametrize(
    ("shell", "stiffness", "support", "tied"),
    [pytest.param(*each, marks=[] if each in PAIRS else thorough) for each in ALL],
)
def test_reactions_balance_loads(
    shell: tuple[str, int, int], stiffness: tuple[float, float], support: Support, tied: bool
) -> None:
    """To 1e-12 of them; found on four kernels of OpenBLAS: 1e-15."""
    structure = STRUCTURE.replace_unchecked(
        supports=(support,), crease_stiffness=stiffness, cells=1
    )
    found = analysed(structure, shell, tied=tied)
    for case in found.cases:
        if case.equilibrium is not None:
            assert case.equilibrium.path is None
            assert case.equilibrium.residual < 1e-12, case.name
            np.testing.assert_allclose(
                case.equilibrium.reaction,
                -case.forces.sum(axis=0),
                atol=1e-12 * np.abs(case.forces).sum(),
            )
            least = -1e-7 * np.abs(case.forces).sum()
            assert (case.equilibrium.tie_forces >= least).all()
            assert (case.equilibrium.flap_forces >= least).all()
        elif support.kind in ("pinned", "fixed"):
            pytest.fail(f"{case.name} moves on feet that are held")
        else:
            assert case.motion is not None
            assert case.forces.ravel() @ case.motion.displacements.ravel() > 0


def test_wind_pushes_aside_what_nothing_holds() -> None:
    sliding = (Support(at="feet", kind="sliding"),)
    found = analysed(STRUCTURE.replace_unchecked(supports=sliding, cases=(CASES[2],), cells=1))
    motion = {case.name: case.motion for case in found.cases}["wind"]
    assert motion is not None
    assert not motion.folding


def test_a_case_without_loads_is_one() -> None:
    cases = (NOTHING, LoadCase(name="dead", self_weight=True))
    found = analysed(STRUCTURE.replace_unchecked(cases=cases, cells=1))
    nothing = found.cases[0].equilibrium
    assert nothing is not None
    assert nothing.buckling is None
    assert np.abs(nothing.displacements).max() == 0


@pytest.mark.parametrize("support", led_by([SMOOTH, Support(at="feet", kind="pinned")]))
def test_a_symmetric_shell_is_displaced_symmetrically(support: Support) -> None:
    """The shelter about the middle of its length, under its own weight and snow."""
    file = read_design_file(EXAMPLES / "shelter.toml")
    design = file.pattern.design(file.f, file.g).with_clipped_flaps()
    feet = find_feet(design)
    assert feet is not None
    ties = tuple(feet_ties(design.mechanism, feet.rows))
    cases = (
        LoadCase(
            name="all", self_weight=True, snow=Snow(ground=500.0 * LIGHT, arrangement="undrifted")
        ),
    )
    structure = STRUCTURE.replace_unchecked(supports=(support,), cases=cases, tie_stiffness=1e6)
    found = analyse(design, structure, Site("m", feet, ties, 1.9 * LIGHT))
    points = found.model.mesh.facets.points
    middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
    mirror = np.array([-1, 1, 1])
    away, other = cKDTree(points).query(np.asarray(middle + (points - middle) * mirror))
    unlike = np.max(away) / np.ptp(points)
    assert unlike < 1e-14  # 2e-15 seen
    assert len(found.balanced) == len(found.cases)
    for stands, case in found.balanced:
        moved = stands.displacements
        difference = np.abs(moved[other] - moved * mirror).max()
        # What a matrix whose entries differ by so much may do: its stiffest node, where some six
        # triangles of E t meet, against the shape that it is bent into. A ninth of it is seen.
        softest = np.sum(case.forces * moved) / np.sum(moved**2)
        stiffest = 20 * MODULUS * THICKNESS
        assert difference < unlike * stiffest / softest * np.abs(moved).max()
        assert stands.residual < 1e-12


def test_forces_of_a_shell_without_conditions_are_superposed() -> None:
    """Pinned, without flaps and ties, all is linear: twice one case and half another."""
    file = read_design_file(EXAMPLES / "figure2.toml")
    pattern = file.pattern.sized(7, 9).model_copy(update={"flap": 0})
    both = LoadCase(name="both", combine={"dead": 2.0, "wind": 0.5})
    feet = find_feet(pattern.design(file.f, file.g))
    assert feet is not None

    def moved(*cases: LoadCase) -> np.ndarray:
        structure = STRUCTURE.replace_unchecked(cases=cases, crease_stiffness=(20.0, 20.0))
        site = Site("m", feet, (), 1.9 * LIGHT)
        found = analyse(pattern.design(file.f, file.g), structure, site)
        return np.stack([stands.displacements for stands, _ in found.balanced])

    dead, wind = CASES[0], CASES[2]
    alone = moved(dead, wind)
    (together,) = moved(dead, wind, both)
    expected = 2.0 * alone[0] + 0.5 * alone[1]
    np.testing.assert_allclose(together, expected, atol=1e-9 * np.abs(expected).max())
