"""CalculiX runs our decks and finds what the analysis finds: shells with rigid creases.

CalculiX is not converged with cells that take a minute: its quadratic cells, whose creases are
bodies that are rigid over the thickness, come from the stiff side. So it is asked with two meshes,
and compared where it goes to as cells shrink, by an error that goes with the square of their size
(Richardson). Our cells are narrower at creases; the finer of two meshes is nearly there. Plates of
10 mm: in thicker ones those rigid bodies are larger, in thinner ones waves are finer.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from calculix_tool import Answers, run_calculix
from documents import EXAMPLES
from orishell import Shell, design_shell
from orishell.document import LoadedShell
from orishell.io.format import DEFAULT_SETTINGS
from orishell.io.formats.calculix import write_calculix
from orishell.numerics.arrays import Array
from orishell.structure.equilibrium import Equilibrium
from samples import thorough

TABLES = """
[structure]
modulus = 8e9
thickness = 0.01
supports = [{{ at = "feet", kind = "{kind}" }}]
tie_stiffness = 2e5
crease_stiffness = "rigid"
cells = {cells}
"""
WEIGHT = "\n[workshop]\nareal_density = 6\n"


def rigid_shell(
    name: str, cells: int, directory: Path, kind: str = "pinned", tables: str = ""
) -> tuple[Shell, Equilibrium]:
    """An example without flaps, its creases rigid and on its feet, under its own weight."""
    text = (EXAMPLES / f"{name}.toml").read_text()
    text += TABLES.format(cells=cells, kind=kind) + tables
    text, count = re.subn(r"^flap = \S+", "flap = 0", text, flags=re.MULTILINE)
    assert count == 1
    file = directory / f"{name}-{cells}.toml"
    file.write_text(text if "[workshop]" in text else text + WEIGHT)
    shell = design_shell(file, clash="unexamined")
    assert shell.analysis is not None
    (case,) = shell.analysis.cases
    assert case.equilibrium is not None
    return shell, case.equilibrium


def asked_of_calculix(shell: Shell, path: Path, *, static: bool = False) -> Answers:
    """All of the deck, or only its first case, which takes a fifth of the time."""
    write_calculix(path, shell.document, DEFAULT_SETTINGS)
    if static:
        first, end, _ = path.read_text().partition("*END STEP\n")
        path.write_text(first + end)
    return run_calculix(path)


def largest(displacements: Array) -> float:
    return float(np.linalg.norm(displacements, axis=1).max())


def pulls(loaded: LoadedShell, displacements: Array) -> Array:
    """Forces (K,) of ties of 2e5 N, by the displacements of their ends."""
    ends, moved = loaded.points[loaded.ties], displacements[loaded.ties]
    along = ends[:, 1] - ends[:, 0]
    longer = np.einsum("ki,ki->k", moved[:, 1] - moved[:, 0], along)
    return np.asarray(2e5 * longer / np.einsum("ki,ki->k", along, along))


def limit(found: list[list[float]], cells: tuple[int, int]) -> Array:
    """Where figures go to from two meshes with so many cells along the side of a panel."""
    share = (cells[0] / cells[1]) ** 2
    coarse, fine = np.array(found)
    return np.asarray((fine - share * coarse) / (1 - share))


@pytest.mark.slow
@thorough
@pytest.mark.parametrize(("name", "cells"), [("figure2", (3, 5)), ("shelter", (4, 6))])
def test_calculix_agrees(name: str, cells: tuple[int, int], tmp_path: Path) -> None:
    """Largest displacement and three frequencies within 3 %, buckling factors within 7 %.

    These shells stand on points, into which forces grow without limit, and factors do not settle:
    figure 2's is 99.1, 101.4 and 102.9 with 5, 12 and 16 cells, and CalculiX' 98.5 and 96.8 with 4
    and 5. On the shelter's it is CalculiX that is 6 to 7 % high: a p-version shell of ours has 278
    to 279, and we find 281, 282, 280.7 with 6, 12, 24 cells.
    """
    theirs: list[list[float]] = []
    for each in cells:
        shell, case = rigid_shell(name, each, tmp_path)
        answers = asked_of_calculix(shell, tmp_path / "shell.inp")
        theirs.append(
            [largest(answers.displacements[0]), *answers.frequencies[:3], answers.buckling[0]]
        )
    assert case.buckling is not None
    wanted = limit(theirs, cells)
    found = [largest(case.displacements), *case.frequencies[:3]]
    np.testing.assert_allclose(found, wanted[:-1], rtol=0.03)
    assert case.buckling == pytest.approx(wanted[-1], rel=0.07)


@thorough
def test_ties_hold_feet_that_slide(tmp_path: Path) -> None:
    """All ties together, the one that pulls most, and how far the crown sinks: within 3 %."""
    ties, cells = '\n[deployment]\nties = "feet"\n', (3, 5)
    ours: list[list[float]] = []
    theirs: list[list[float]] = []
    for each in cells:
        shell, case = rigid_shell("figure2", each, tmp_path, "sliding", ties)
        loaded = shell.document.loaded
        assert loaded is not None
        assert case.tie_forces.min() > 0
        (found,) = asked_of_calculix(shell, tmp_path / "shell.inp", static=True).displacements
        assert pulls(loaded, case.displacements) == pytest.approx(case.tie_forces, rel=1e-6)
        for displacements, into in ((case.displacements, ours), (found, theirs)):
            forces = pulls(loaded, displacements)
            into.append([forces.sum(), forces.max(), displacements[:, 2].min()])
    np.testing.assert_allclose(ours[-1], limit(theirs, cells), rtol=0.03)
