"""Does the shelter stand: under own weight, snow and wind, of boards and of other panels.

Run it with ``python examples/shelter_structure.py``; the design is in ``shelter_structure.toml``
beside it.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import inf, sqrt
from pathlib import Path

from orishell import Shell, analyse_structure
from orishell.design_file import read_design_file
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES, Step
from orishell.structure.load_settings import LoadCase
from orishell.structure.results import Analysis
from orishell.structure.settings import Support

SHARE, FACTOR = 0.05, 3.0
"""Displacements up to this share of the height, buckling from this factor on: linear theory."""


@dataclass(frozen=True)
class Panel:
    """A panel that is the same everywhere.

    Parameters
    ----------
    name
        What it is.
    modulus, strength
        Of its section as a whole (N/m2).
    thickness
        In metres.
    areal_density
        In kg/m2.
    """

    name: str
    modulus: float
    strength: float
    thickness: float
    areal_density: float


def sandwich(name: str, modulus: float, strength: float, face: float, core: float) -> Panel:
    """The solid panel that stretches and bends as two faces on foam do.

    Its stress is the faces' by 2 f/t where it is stretched, by more where it is bent; strength is
    taken by the former, on the safe side. Foam does not shear.

    Parameters
    ----------
    modulus, strength
        Of the faces (N/m2).
    face, core
        Thickness of a face and of the foam, of 60 kg/m3 (m); faces have 1600.
    """
    thickness = sqrt(3) * (core + face)
    share = 2 * face / thickness
    density = 2 * face * 1600 + core * 60
    return Panel(name, share * modulus, share * strength, thickness, density)


# Sources: makers' sheets for polypropylene, handbooks of plywood and of laminates, rounded down.
# Plywood has the modulus of its weaker direction, and half of its characteristic strength.
PANELS = (
    Panel("twin-wall, 20 mm", 273e6, 5.24e6, 0.0205, 4.3),
    Panel("birch plywood, 12 mm", 6.7e9, 16e6, 0.012, 8.2),
    Panel("birch plywood, 15 mm", 7e9, 16e6, 0.015, 10.2),
    sandwich("glass fibre on foam, 23 mm", 12e9, 60e6, 0.0015, 0.020),
)
PLYWOOD = PANELS[2]


def design(panel: Panel | None = None) -> Shell:
    """The shelter of boards or of other panels, without the proof that none meet."""
    file = read_design_file(Path(__file__).with_suffix(".toml"))
    if panel is not None:
        workshop = file.workshop.replace_unchecked(areal_density=panel.areal_density)
        assert file.structure is not None
        structure = file.structure.replace_unchecked(
            modulus=panel.modulus,
            strength=panel.strength,
            thickness=panel.thickness,
            poisson=0.3,
        )
        file = replace(file, panel=None, workshop=workshop, structure=structure)
    unloaded: tuple[Step, ...] = () if panel is None else ("structure",)
    return make_shell(file, clash="unexamined", skip=(*MEASURES, "stock", *unloaded))


def with_creases(shell: Shell, stiffness: float = inf, cells: int = 4) -> Analysis:
    """A shell with creases of one stiffness (N m per metre and radian)."""
    assert shell.file.structure is not None
    structure = shell.file.structure.replace_unchecked(
        crease_stiffness=(stiffness,) * 2, cells=cells
    )
    return analyse_structure(shell, structure)


def on_the_ground(shell: Shell, friction: float) -> Analysis:
    """A shell that is not anchored, with rigid creases: under snow, or in a storm."""
    assert shell.file.structure is not None
    snow = LoadCase(name="snow", combine={"dead": 1.35, "snowed": 1.5})
    loads = [
        case.replace_unchecked(
            name="snowed", snow=case.snow.replace_unchecked(arrangement="undrifted")
        )
        if case.snow
        else case
        for case in shell.file.structure.cases
    ]
    structure = shell.file.structure.replace_unchecked(
        cases=(*(case for case in loads if case.name != "winter"), snow),
        crease_stiffness=(inf, inf),
        supports=(
            Support(at="feet", kind="friction", friction=1.0).replace_unchecked(friction=friction),
        ),
    )
    return analyse_structure(shell, structure)


@dataclass(frozen=True)
class Verdict:
    """The worst of all load cases.

    Parameters
    ----------
    mass
        Of all panels (kg).
    displaced
        Largest displacement as a share of the height.
    buckling
        Least buckling factor.
    used
        Largest share of the strength.
    """

    mass: float
    displaced: float
    buckling: float
    used: float

    @property
    def carries(self) -> bool:
        """Whether the shell carries its loads, by linear theory."""
        return self.displaced < SHARE and self.buckling > FACTOR and self.used < 1


def judge(shell: Shell, analysis: Analysis) -> Verdict:
    """The worst of all load cases; infinite displacements, and no more, where it moves."""
    assert shell.file.structure is not None
    strength = shell.file.structure.strength
    assert strength is not None
    mass, found = (
        analysis.model.mass,
        [case.equilibrium for case in analysis.cases if case.equilibrium],
    )
    if len(found) < len(analysis.cases):
        return Verdict(mass, inf, 0.0, inf)
    moved = max(each.displacement.share for each in found)
    factor = min(inf if each.buckling is None else each.buckling for each in found)
    used = max(each.stress.size for each in found) / strength
    return Verdict(mass, moved, factor, used)


def row(name: str, found: Verdict) -> str:
    """A line of a table."""
    moved = "moves" if found.displaced == inf else f"{100 * found.displaced:.1f} %"
    used = "" if found.displaced == inf else f"{100 * found.used:.0f} %"
    answer = "carries" if found.carries else "does not"
    return f"{name:28}{found.mass:6.0f} kg{moved:>9}{found.buckling:8.2f}{used:>7}  {answer}"


HEAD = f"{'rigid creases':28}{'mass':>9}{'moved':>9}{'buckles':>8}{'used':>7}"


def main() -> None:
    """Print what carries the loads."""
    boards = design()
    print(HEAD)
    print(row("twin-wall, 10 mm, the kit", judge(boards, with_creases(boards))))
    for panel in PANELS:
        shell = design(panel)
        print(row(panel.name, judge(shell, with_creases(shell))))


if __name__ == "__main__":
    main()
