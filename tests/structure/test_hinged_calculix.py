"""Free hinges, tapered boards, large displacements and an imperfection against CalculiX.

Decks are those of ``hinged_decks``: every panel has nodes of its own, and sections cell by cell.
Shells of CalculiX shear, ours do not, and cells differ: so figures of the same mesh are compared.
"""

from __future__ import annotations

import tomllib
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from followed_shells import linear
from hinged_decks import Deck, run_deck
from orishell.design_file import check_design
from orishell.shell.make import make_shell
from orishell.structure.case import CaseResult
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.results import Analysis
from samples import thorough

from .test_verdicts import FILES, SKIP, arch

OWN: list[dict[str, Any]] = [{"name": "own", "self_weight": True}]
BOARDS = {"construction": "bevel", "thickness": 0.01, "gap": 0.002}


@cache
def followed(cells: int) -> Analysis:
    """An arch of chamfered boards of 10 mm on free hinges, which buckles at 2 times its weight.

    So it is followed, off its shape by 8.4 mm.
    """
    keys = {"cells": cells, "thickness": 0.01, "line_strength": 1e6}
    return arch(keys, OWN, BOARDS)


def found_of(analysis: Analysis) -> tuple[CaseResult, Equilibrium]:
    (case,) = analysis.cases
    assert case.equilibrium is not None
    assert case.equilibrium.path is not None
    return case, case.equilibrium


def largest(displacements: np.ndarray[Any, Any]) -> float:
    return float(np.linalg.norm(displacements, axis=1).max())


@pytest.mark.parametrize(
    ("cells", "factor"), [(2, 0.07), *(pytest.param(each, 0.05, marks=thorough) for each in (3, 4))]
)
def test_tapered_boards_on_free_hinges(tmp_path: Path, cells: int, factor: float) -> None:
    """Displacement within 3 %, buckling factor within 5 %, but with 2 cells, where it is 6 % off.

    108.2, 118.9 and 121.2 mm there, 106.3, 116.5 and 119.8 here; factors of 2.158, 2.002 and 1.995
    there, 2.287, 2.010 and 2.009 here.
    """
    analysis = followed(cells)
    case, stands = found_of(analysis)
    path = stands.path
    assert path is not None
    deck = Deck(analysis.model, case)
    assert len(np.unique(deck.sections()[0].round(9))) > 10
    deck.write(tmp_path / "arch.inp", "*BUCKLE")
    theirs = run_deck(tmp_path / "arch.inp", deck)
    assert path.linear_displacement == pytest.approx(largest(theirs.displacements[0]), rel=0.03)
    assert path.linear_buckling == pytest.approx(theirs.factors[0], rel=factor)


@thorough
@pytest.mark.parametrize("cells", [2, 3])
def test_an_imperfect_arch_is_followed_as_far(tmp_path: Path, cells: int) -> None:
    """NLGEOM from the same shape off that designed: within 3 %."""
    analysis = followed(cells)
    case, stands = found_of(analysis)
    assert stands.path is not None
    first = linear(analysis)
    mode = first.buckling_modes[0]
    way = float(np.sign((mode * first.displacements).sum()))
    deck = Deck(analysis.model, case)
    off = way * stands.path.imperfection * mode
    deck.write(tmp_path / "arch.inp", "*STATIC,NLGEOM", off=off)
    theirs = run_deck(tmp_path / "arch.inp", deck).displacements[-1]
    assert stands.displacement.size == pytest.approx(largest(theirs), rel=0.03)


@thorough
def test_a_shelter_whose_ties_and_flaps_act(tmp_path: Path) -> None:
    """Panels of 23 mm and 1.5 GPa, not chamfered: 2.94 there with 4 cells, 3.08 here with 8.

    Both come from above: 2.89 there with 6 cells, 3.00 here with 12. Within 5 %; with springs in
    place of equations there were modes of 0.94 and less (``test_springs_in_calculix``).
    """
    tables = tomllib.loads((FILES / "BEST_shelter.toml").read_text())
    del tables["panel"], tables["structure"]["material"]
    tables["workshop"] = {"areal_density": 260 * 0.023}
    tables["structure"] |= {"modulus": 1.5e9, "thickness": 0.023}
    found: list[Analysis] = []
    for cells in (4, 8):
        tables["structure"]["cells"] = cells
        shell = make_shell(check_design(tables, Path("x.toml")), clash="unexamined", skip=SKIP)
        assert shell.analysis is not None
        found.append(shell.analysis)
    coarse, fine = (next(case for case in each.cases if case.name == "snow l") for each in found)
    deck = Deck(found[0].model, coarse)
    assert deck.springs()
    deck.write(tmp_path / "shelter.inp", "*BUCKLE")
    theirs = run_deck(tmp_path / "shelter.inp", deck).factors
    assert fine.equilibrium is not None
    assert min(theirs) == theirs[0]
    assert fine.equilibrium.buckling == pytest.approx(theirs[0], rel=0.05)
