"""Followed motions against closed forms, degrees of freedom against counts by hand."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from creased import of_mechanism, star
from mechanisms import CLOSED, SAMPLES, flat_foldable, miura_net
from orishell.conventions.errors import DesignError, InputError
from orishell.motion import Mechanism
from orishell.motion.crease_pattern import CreasePattern
from orishell.motion.following import dofs, follow
from orishell.motion.following.dofs import find_freedom
from orishell.motion.following.path import follow_path, states_at
from orishell.motion.following.placing import Placing
from orishell.motion.following.rigid import find_rigid, why_still
from orishell.motion.following.start import find_start
from orishell.motion.following.system import Closure
from orishell.motion.layout import edge_folds
from patterns import SAMPLES as SHEETS
from patterns import jittered, of_loops
from samples import examples, thorough

QUICK = (
    "parallel, oblique",
    "orthodiagonal, leaning",
    "longitudinal, 4 x 3 from S",
    "longitudinal, sine from S",
    "flat-foldable, mixed",
    "flat-foldable, flaps",
)


def followed_apart(mechanism: Mechanism) -> float:
    """By how much a motion that is followed from the letters leaves the closed form (radians)."""
    pattern = of_mechanism(mechanism)
    closure = Closure.of(pattern)
    start = find_start(closure, pattern.signs[closure.edges])
    assert start.found
    drives = np.linspace(0, mechanism.target_drive, 12)
    exact = np.array([edge_folds(mechanism, each)[closure.edges] for each in drives])
    path = follow_path(closure, start.folds)
    assert path.end == "closed"
    found, residuals = states_at(closure, path, np.abs(exact).max(axis=1))
    assert residuals.max() < 1e-12
    return float(np.abs(found - exact).max())


@pytest.mark.parametrize("name", QUICK)
def test_closed_forms(name: str) -> None:
    """From the flat sheet and its letters alone; at most 1e-12 was seen."""
    assert followed_apart(SAMPLES[name].make()) < 2e-11


@thorough
@pytest.mark.parametrize("name", [name for name in CLOSED if name not in QUICK])
def test_closed_forms_of_all(name: str) -> None:
    assert followed_apart(SAMPLES[name].make()) < 2e-11


@thorough
def test_closed_form_of_a_large_sheet() -> None:
    """30 x 30 inner vertices: 3e-14 was seen, in 1 s."""
    assert followed_apart(flat_foldable(miura_net(30, 30))) < 1e-12


@pytest.mark.parametrize("count", [4, 5, 6, 9])
def test_freedom_of_a_vertex(count: int) -> None:
    """n creases and three equations: n - 3 degrees of freedom in folded states."""
    degrees = np.linspace(0, 360, count, endpoint=False) + np.tile([0.0, 7.0, 3.0], 3)[:count]
    assert follow(star(degrees.tolist()), largest=1.0).degrees_of_freedom == count - 3


@pytest.mark.parametrize("name", ["Huffman's grid", "waterbomb", "Yoshimura", "Resch"])
def test_freedom_of_patterns(name: str) -> None:
    """As counted by hand, in three states on the way: with one degree of freedom or with many."""
    sample = SHEETS[name]
    found = follow(sample.make(), largest=1.5, states=2)
    assert found.degrees_of_freedom == sample.freedom
    assert found.residuals.max() < 1e-13


def test_freedom_of_many_creases(monkeypatch: pytest.MonkeyPatch) -> None:
    """What inverse iteration finds of a large sheet is what all singular values say."""
    pattern = SHEETS["Yoshimura"].make()
    closure = Closure.of(pattern)
    folds = find_start(closure, pattern.signs[closure.edges]).folds
    whole = find_freedom(closure, folds)
    monkeypatch.setattr(dofs, "DENSE", 0)
    some = find_freedom(closure, folds)
    assert whole.count == some.count == 2 * (5 + 6) - 3
    np.testing.assert_allclose(some.least_other, whole.least_other, rtol=1e-6)


def test_symmetry_stays() -> None:
    """Six creases, every other one a mountain: the motion that is followed keeps the threefold
    symmetry of sheet and letters, to what rounding does near the flat state (1e-5 was seen). Its
    valleys rise from the plane across the axis by b, its mountains by a, 60 degrees of azimuth and
    60 degrees of sector apart: so cos a cos b / 2 + sin a sin b = 1/2."""
    found = follow(star(range(0, 360, 60), "MV"), largest=2.0)
    folds = found.folds[-1][found.pattern.crease]
    assert np.ptp(folds[0::2]) < 1e-4
    assert np.ptp(folds[1::2]) < 1e-4
    points, play = found.placed(24)
    assert play < 1e-14
    tips = points[1:] - points[0]
    axis = np.cross(tips[2] - tips[0], tips[4] - tips[0])
    a, b = np.arcsin(tips @ axis / np.linalg.norm(axis)).reshape(3, 2).T
    np.testing.assert_allclose(np.cos(a) * np.cos(b) / 2 + np.sin(a) * np.sin(b), 0.5, atol=1e-4)


def test_missing_letters_are_found() -> None:
    """A Miura sheet without letters: the ones that are found fold, with one degree of freedom."""
    known = of_mechanism(SAMPLES["toy"].make())
    pattern = replace(known, letters=np.where(known.crease, "U", "B"))
    found = follow(pattern)
    assert found.found == pattern.crease.sum()
    assert set(found.letters[pattern.crease].tolist()) == {"M", "V"}
    assert found.degrees_of_freedom == 1
    again = follow(replace(pattern, letters=found.letters))
    assert again.found == 0
    assert again.end == found.end == "closed"


def test_given_letters_stay() -> None:
    """Some letters missing: those that are there are kept."""
    known = of_mechanism(SAMPLES["flat-foldable"].make())
    some = np.arange(len(known.edges)) % 3 == 0
    found = follow(replace(known, letters=np.where(some & known.crease, "U", known.letters)))
    assert (found.letters[~some] == known.letters[~some]).all()
    assert found.found == (some & known.crease).sum()


@pytest.mark.parametrize("largest", [0.01, 0.05, 1.0, np.pi])
def test_asked_angle(largest: float) -> None:
    """States at equal steps of the largest fold angle, from flat to the one asked for, exactly."""
    found = follow(
        of_mechanism(SAMPLES["orthodiagonal, g straight"].make()), largest=largest, states=7
    )
    assert found.end == ("closed" if largest == np.pi else "asked")
    np.testing.assert_allclose(found.drives, np.linspace(0, largest, 7), rtol=1e-12)
    np.testing.assert_allclose(np.abs(found.folds).max(axis=1), found.drives, atol=1e-12)
    assert found.residuals.max() < 1e-13


def test_a_crease_across_a_panel_folds_freely() -> None:
    """Two triangles: no inner vertex, one degree of freedom, and 90 degrees lift the tip by its
    distance from the crease."""
    square = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    triangles = of_loops(square, [[0, 1, 2], [0, 2, 3]], lambda a, b: "U")
    found = follow(triangles, largest=np.pi / 2)
    assert found.degrees_of_freedom == 1
    points, play = found.placed(24)
    assert play < 1e-15
    np.testing.assert_allclose(np.ptp(points[:, 2]), np.sqrt(0.5), rtol=1e-14)


def test_play_of_a_state_that_does_not_close() -> None:
    """One crease of four folded by 0.1: at whichever crease the way round the vertex ends, a panel
    is turned by 0.1 about the folded one, so that the tip of that crease is moved by 2 sin(0.05)
    times its distance from there."""
    degrees = np.array([0, 70, 200, 280])
    pattern = star(degrees.tolist())
    plays = []
    for tip in range(4):
        only = [0.1 if set(ends) == {0, 1 + tip} else 0.0 for ends in pattern.edges.tolist()]
        plays.append(Placing(pattern).placed(np.array(only))[1])
        aside = 2 * np.sin(0.05) * np.abs(np.sin(np.deg2rad(degrees - degrees[tip])))
        assert np.abs(aside - plays[-1]).min() < 1e-15
    assert max(plays) > 0.09


def fault(pattern: CreasePattern) -> str:
    with pytest.raises((DesignError, InputError)) as caught:
        follow(pattern)
    return str(caught.value)


def test_what_does_not_fold() -> None:
    """Three creases, four within half a turn, and all to one side: all proved."""
    assert "does not fold at all: proved" in fault(star([0, 120, 240]))
    fan = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [-1, 1], [0, -1.0]])
    loops = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5, 1]]
    assert "does not fold at all: proved" in fault(of_loops(fan, loops, lambda a, b: "U"))
    assert "all creases at vertex 0 have one letter" in fault(star([0, 70, 180, 260], "V"))
    assert "nothing to fold" in fault(star([0, 70, 180, 260], "F"))


def test_letters_that_do_not_fold() -> None:
    """Sectors 60, 120, 60, 120: two lines that cross, of which only one can fold, at a time."""
    for turn in (0, 45, 77):
        says = fault(star([each + turn for each in (0, 60, 180, 240)], "VVVM"))
        assert "as its letters ask: proved: two straight lines cross at vertex 0" in says


def test_what_is_beside_a_rigid_vertex_is_rigid() -> None:
    """A degree-3 vertex holds its creases; the degree-4 vertex at the end of one of them is left
    with three, all within half a turn, and holds these."""
    pattern = of_loops(
        np.array([[0, 0], [2, 0], [-1, 1.5], [-1, -1.5], [3, 1.5], [3, -1.5], [4, 0]]),
        [[0, 1, 4, 2], [0, 3, 5, 1], [0, 2, 3], [1, 5, 6], [1, 6, 4]],
        lambda a, b: "U",
    )
    assert find_rigid(pattern).flat.sum() == pattern.crease.sum() == 6
    freed = replace(pattern, letters=np.where(pattern.edges.max(axis=1) == 3, "C", pattern.letters))
    assert not find_rigid(freed).flat[pattern.edges.max(axis=1) > 3].any()


@pytest.mark.parametrize("name", ["Huffman's grid", "graded Miura"])
def test_what_folds_to_a_tolerance(name: str) -> None:
    """Of coordinates off by a share of an edge, what states miss is in proportion to it."""
    sheet = SHEETS[name].make()
    missed = [
        follow(jittered(sheet, size), largest=2.0, states=4).residuals.max()
        for size in (1e-9, 1e-7)
    ]
    np.testing.assert_allclose(missed[1] / missed[0], 100, rtol=0.1)
    assert missed[0] < 1e-8


@pytest.mark.parametrize("seed", range(examples(80)))
def test_letters_at_a_vertex_are_proved_wrong_or_fold(seed: int) -> None:
    """What is proved not to fold is not found by any of forty starts; of four creases all else is.

    Sectors are random, but for every third vertex, two of whose creases are in line.
    """
    rng = np.random.default_rng(seed)
    degree = int(rng.choice([4, 4, 5, 6]))
    sectors = rng.uniform(0.5, 1.5, degree)
    turn = [180.0, 180.0] if seed % 3 == 0 else [360.0]
    parts = np.array_split(sectors, len(turn))
    around = [each * part / part.sum() for each, part in zip(turn, parts, strict=True)]
    degrees = np.cumsum(np.concatenate(around))
    pattern = star(degrees.tolist(), "".join(rng.choice(["M", "V"], degree)))
    proved = why_still(pattern)
    try:
        follow(pattern, largest=0.1, states=2)
        found = True
    except DesignError:
        found = False
    assert not (found and proved)
    if degree == 4:
        assert found or proved


def test_letters_that_pull_to_one_side() -> None:
    """A line folded through two layers: letters of its parts differ; and a letter that changes."""
    assert "the letters at vertex 0" in why_still(star([0, 60, 180, 300], "VVVM"))
    assert "the letters at vertex 0" in why_still(star([0, 90, 180, 270], "VFMF"))
    assert why_still(star([0, 90, 180, 270], "VFVF")) == ""
    assert why_still(star([0, 60, 180, 300], "MVVV")) == ""
