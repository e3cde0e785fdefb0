"""Stress of panels at the places where it is stated, against CalculiX (S8R).

Two stresses are stated: von Mises' over patches, at either face, and the structural stress of
forces and moments per length on quarters of creases. CalculiX's stresses in points of cells, and
its forces on nodes, give both by the same rules at the same places (``borne_in_calculix``).
"""

from __future__ import annotations

from pathlib import Path
from unittest.mock import patch

import numpy as np
import pytest

from borne_in_calculix import Borne, borne
from followed_shells import asked, linear
from hinged_decks import Deck, run_deck
from orishell.numerics.arrays import Array
from orishell.numerics.equals import SOLVED
from orishell.structure import soft_cases
from orishell.structure.case import CaseResult
from orishell.structure.crease_forces import spread_forces
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.mesh.edge_forces import ABOUT, IN_PLANE, NORMAL, EdgeForces
from orishell.structure.model import Model
from orishell.structure.results import Analysis
from samples import led_by, thorough

from .test_calculix import rigid_shell
from .test_hinged_calculix import BOARDS, OWN, followed, found_of
from .test_verdicts import arch

WITHIN = 0.10
"""How near CalculiX's stress is."""


def structural(model: Model, edges: EdgeForces) -> Array:
    """Von Mises' stress (C, 2, S) of N, V_in and M on quarters of both sides of creases, by hand.

    N/t + 6 M/t^2 and V_in/t; of chamfered boards a half is left, and its middle is t/4 off N.
    """
    size, thick = np.abs(spread_forces(model, edges)), model.thickness
    away = np.zeros(1)
    if model.design.panel is not None:
        thick, away = 0.5 * thick, np.full(1, 0.25 * thick)
    direct = size[..., NORMAL] / thick
    direct += 6 * (size[..., ABOUT] + away * size[..., NORMAL]) / thick**2
    return np.asarray(np.sqrt(direct**2 + 3 * (size[..., IN_PLANE] / thick) ** 2))


def largest_at(values: Array) -> tuple[int, ...]:
    return tuple(int(each) for each in np.unravel_index(values.argmax(), values.shape))


def check_stated(case: CaseResult, found: Equilibrium, theirs: Borne) -> None:
    """Both stresses at the places where they are stated, and the largest of CalculiX anywhere."""
    patches, edges = theirs.patches, theirs.edges
    # What CalculiX's forces on a panel leave of balance: NLGEOM ends its iterations there.
    assert edges.missing < 2e-3 * float(np.linalg.norm(case.load))
    assert found.beside is not None
    pairs = (
        (found.stresses, patches.von_mises(), found.stress.size),
        (structural(found.model, found.edges), structural(found.model, edges), found.beside.size),
    )
    for here, there, stated in pairs:
        place = largest_at(here)
        # Of places that are alike but for SOLVED the first is stated.
        assert here[place] == pytest.approx(stated, rel=SOLVED)
        assert stated == pytest.approx(there[place], rel=WITHIN)
        assert stated == pytest.approx(there.max(), rel=WITHIN)


def check_linear(path: Path, analysis: Analysis, *, locked: bool = False) -> None:
    """A case by linear theory."""
    (case,) = analysis.cases
    assert case.equilibrium is not None
    deck = Deck(analysis.model, case, stressed=True, locked=locked)
    deck.write(path, "*STATIC")
    theirs = borne(path, deck, run_deck(path, deck))
    check_stated(case, case.equilibrium, theirs)


@pytest.mark.parametrize("cells", led_by((2, 4, 8)))
def test_tapered_boards_on_free_hinges(tmp_path: Path, cells: int) -> None:
    """By patches 3.986, 4.392 and 4.416 MPa there, 3.987, 4.398 and 4.391 here.

    Beside a crease, where it ends at a vertex, 14.68, 14.67 and 14.88 MPa there, 15.43, 15.38 and
    15.64 here.
    """
    keys = {"cells": cells, "thickness": 0.01, "line_strength": 1e6}
    with patch.object(soft_cases, "SECONDS", 0.0):
        check_linear(tmp_path / "arch.inp", arch(keys, OWN, BOARDS))


@thorough
@pytest.mark.parametrize("cells", [2, 3, 4])
def test_an_imperfect_arch_that_is_followed(tmp_path: Path, cells: int) -> None:
    """NLGEOM from the same shape off that designed, places as they are moved.

    By patches 4.095, 4.202 and 4.420 MPa there, 3.984, 4.118 and 4.265 here; beside a crease 14.17,
    14.06 and 14.13 there, 14.84, 14.39 and 14.76 here.
    """
    analysis, path = followed(cells), tmp_path / "arch.inp"
    case, stands = found_of(analysis)
    assert stands.path is not None
    first = linear(analysis)
    mode = first.buckling_modes[0]
    off = np.sign((mode * first.displacements).sum()) * stands.path.imperfection * mode
    deck = Deck(analysis.model, case, stressed=True)
    deck.write(path, "*STATIC,NLGEOM", off=off)
    found = run_deck(path, deck)
    check_stated(case, stands, borne(path, deck, found, off + found.displacements[-1]))


@pytest.mark.parametrize("cells", led_by((2, 3, 4, 6)))
def test_locked_creases(tmp_path: Path, cells: int) -> None:
    """A shell of 30 panels over a parabola, as Figure 2's.

    By patches 0.1329, 0.1543, 0.1478 and 0.1589 MPa there, 0.1383, 0.1569, 0.1481 and 0.1583 here;
    beside a crease 0.2235, 0.2230, 0.2229 and 0.2249 there, 0.2374, 0.2245, 0.2250 and 0.2247 here.
    """
    analysis = asked("pinned", 6.0, cells=cells, nonlinear=False)
    check_linear(tmp_path / "shell.inp", analysis, locked=True)


@thorough
def test_figure_2_with_locked_creases(tmp_path: Path) -> None:
    """By patches 0.5623 MPa there, 0.5527 here; beside a crease 0.7699 there, 0.8191 here.

    Here that is 0.8185, 0.8273 and 0.8278 with 6, 8 and 12 cells. CalculiX's displacements are
    still 3 % short with 4, and comes nearer: 0.7442 and 0.7699 with 3 and 4, where it is largest
    0.7876 and 0.8066.
    """
    shell, _ = rigid_shell("figure2", 4, tmp_path)
    assert shell.analysis is not None
    check_linear(tmp_path / "shell.inp", shell.analysis, locked=True)
