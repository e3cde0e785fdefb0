"""CalculiX runs our decks and finds what the analysis finds: shells with rigid creases.

CalculiX has 5 x 5 quadratic cells on every panel, the analysis as many of two triangles as come
about as near to the limit, which stand beside each shell. Pinned corners and vertices of rigid
creases are singular, so that both still give way with finer cells: on the shelter by about a tenth.
Plates of 10 mm: thicker ones buckle later in CalculiX, whose creases are rigid over the thickness.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from calculix_tool import Answers, run_calculix
from documents import EXAMPLES
from orishell import Shell, design_shell
from orishell.io.formats.calculix import write_calculix
from orishell.io.settings import DEFAULT_SETTINGS
from orishell.numerics.arrays import Array
from orishell.structure.results import CaseResult

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
) -> tuple[Shell, CaseResult]:
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
    return shell, case


def asked_of_calculix(shell: Shell, path: Path) -> Answers:
    write_calculix(path, shell.document, DEFAULT_SETTINGS)
    return run_calculix(path)


def largest(displacements: Array) -> float:
    return float(np.linalg.norm(displacements, axis=1).max())


@pytest.mark.slow
@pytest.mark.parametrize(("name", "cells"), [("figure2", 5), ("shelter", 8)])
def test_calculix_agrees(name: str, cells: int, tmp_path: Path) -> None:
    """Largest displacement, three frequencies and buckling factor within 3 %."""
    shell, _ = rigid_shell(name, 5, tmp_path)
    theirs = asked_of_calculix(shell, tmp_path / "shell.inp")
    _, ours = rigid_shell(name, cells, tmp_path)
    (displacements,), (buckling,) = theirs.displacements, theirs.buckling
    assert ours.buckling is not None
    assert largest(ours.displacements) == pytest.approx(largest(displacements), rel=0.03)
    assert ours.frequencies == pytest.approx(theirs.frequencies[:3], rel=0.03)
    assert ours.buckling[0] == pytest.approx(buckling, rel=0.03)


@pytest.mark.slow
def test_ties_hold_feet_that_slide(tmp_path: Path) -> None:
    """All ties together, the one that pulls most, and how far the crown sinks: within 3 %."""
    ties = '\n[deployment]\nties = "feet"\n'
    shell, ours = rigid_shell("figure2", 3, tmp_path, "sliding", ties)
    loaded = shell.document.loaded
    assert loaded is not None
    assert ours.tie_forces.min() > 0
    (theirs,) = asked_of_calculix(shell, tmp_path / "shell.inp").displacements
    ends = loaded.points[loaded.ties]
    along = ends[:, 1] - ends[:, 0]
    length = np.linalg.norm(along, axis=1)

    def forces(displacements: Array) -> Array:
        moved = displacements[loaded.ties]
        stretch = np.einsum("ki,ki->k", moved[:, 1] - moved[:, 0], along) / length
        return np.asarray(2e5 * stretch / length)

    assert forces(ours.displacements) == pytest.approx(ours.tie_forces, rel=1e-6)
    assert forces(theirs).sum() == pytest.approx(ours.tie_forces.sum(), rel=0.03)
    assert forces(theirs).max() == pytest.approx(ours.tie_forces.max(), rel=0.03)
    assert theirs[:, 2].min() == pytest.approx(ours.displacements[:, 2].min(), rel=0.03)
