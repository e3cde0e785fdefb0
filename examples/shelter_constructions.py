"""What the shelter carries in three constructions: boards on a membrane, bevelled, on hinges.

Run it with ``python examples/shelter_constructions.py``: it takes some minutes. The shelter is that
of ``shelter_hinged.toml`` beside it, of 10 mm of birch plywood, pinned along the edges at its feet.
Creases are locked, or turn freely. Loads are its own weight and snow on a cylinder (EN 1991-1-3),
undrifted and drifted, without factors of a code.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from math import inf
from pathlib import Path
from typing import Any

from orishell import Shell, analyse_structure
from orishell.design_file.file import check_design
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES
from orishell.structure.load_settings import LoadCase, Snow

FILE = Path(__file__).parent / "shelter_hinged.toml"
PLYWOOD = {"thickness": 0.010, "density": 680}
FABRIC = {"membrane": 0.001, "membrane_density": 1200, "gap": 0.004}
STEEL = {"arm_modulus": 210e9, "arm_strength": 235e6}
HINGED = {
    **PLYWOOD,
    "construction": "hinged",
    "gap": 0.001,
    "arm_density": 7850,
    "hinge": {"linear_density": 0.4},
}
CONSTRUCTIONS: Mapping[str, tuple[Mapping[str, Any], Mapping[str, Any]]] = {
    "sandwich": (
        {**PLYWOOD, **FABRIC},
        # coated polyester fabric, a tenth of 1.2 kN/10 mm for lasting loads
        {"membrane_modulus": 1e9, "membrane_strength": 12e6},
    ),
    "bevel": ({**PLYWOOD, "construction": "bevel", "gap": 0.001}, {}),
    "hinged, arms of 1 mm": ({**HINGED, "arm_width": 0.001}, STEEL),
    "hinged, arms of 3 mm": ({**HINGED, "arm_width": 0.003}, STEEL),
    "in three pieces": ({**HINGED, "pieces": 4}, STEEL),
}
"""Tables [panel], and what [structure] has beside the material."""
SNOW, FACTOR = 500.0, 3.0
"""Snow on the ground (N/m2), and the buckling factor from which on linear theory holds."""
TURNS, CLOSE = 4, 0.02
"""Analyses in search of the snow that is carried, and how near its share is to 1."""


@dataclass(frozen=True)
class Borne:
    """The worst of all arrangements of snow.

    Parameters
    ----------
    used
        Shares of strength, by part.
    buckling
        Least factor of the loads under which it buckles.
    """

    used: Mapping[str, float]
    buckling: float

    @property
    def share(self) -> float:
        """The share of what is borne: above 1 it does not carry its loads."""
        return max(*self.used.values(), FACTOR / self.buckling)


def design(name: str) -> Shell:
    """The shelter in a construction, without the proof that no boards meet."""
    panel, more = CONSTRUCTIONS[name]
    support = {"at": "feet", "kind": "pinned", "edges": True}
    tables = {
        **tomllib.loads(FILE.read_text(encoding="utf-8")),
        "panel": dict(panel),
        "structure": {"material": "birch plywood", "supports": [support], **more},
    }
    file = check_design(tables, FILE)
    return make_shell(file, clash="unexamined", skip=(*MEASURES, "stock", "structure"))


def load(shell: Shell, ground: float, creases: float = inf, cells: int = 4) -> Borne:
    """What the shelter does under its own weight and snow on the ground (N/m2).

    Parameters
    ----------
    creases
        Their stiffness: 0 for free hinges, infinite for locked ones.
    """
    assert shell.file.structure is not None
    snow = Snow(ground=ground, shape="cylinder") if ground else None
    asked = shell.file.structure.replace_unchecked(
        cases=(LoadCase(name="winter", self_weight=True).replace_unchecked(snow=snow),),
        crease_stiffness=(creases, creases),
        cells=cells,
    )
    found = analyse_structure(shell, asked)
    held = [case.equilibrium for case in found.cases if case.equilibrium is not None]
    if len(held) < len(found.cases):
        return Borne({"moves": inf}, 1.0)
    used: dict[str, float] = {}
    for each in held:
        for part, share in each.utilisation.shares.items():
            if share and part != "buckling":
                used[part] = max(used.get(part, 0.0), share)
    return Borne(used, min(inf if each.buckling is None else each.buckling for each in held))


def carried(shell: Shell, creases: float, bare: Borne, snowed: Borne) -> float:
    """Snow on the ground that it carries (N/m2), by secants; 0 if not even its own weight.

    Parameters
    ----------
    bare, snowed
        What it does under its own weight, and under snow beside.
    """
    near, far, before, share = 0.0, SNOW, bare.share, snowed.share
    if before > 1:
        return 0.0
    for _ in range(TURNS):
        if abs(share - 1) < CLOSE:
            break
        near, far, before = far, far + (1 - share) * (far - near) / (share - before), share
        share = load(shell, far, creases).share
    return far


def main() -> None:
    """Print the table."""
    print(f"{'':22}{'creases':>8}{'snow':>6}{'strength used':>40}{'buckles':>9}")
    for name in CONSTRUCTIONS:
        shell = design(name)
        for words, creases in (("locked", inf), ("free", 0.0)):
            both = [load(shell, ground, creases) for ground in (0.0, SNOW)]
            for ground, found in zip((0.0, SNOW), both, strict=True):
                used = ", ".join(f"{part} {100 * each:.0f} %" for part, each in found.used.items())
                print(f"{name:22}{words:>8}{ground:6.0f}{used:>40}{found.buckling:9.2f}")
            print(
                f"{name:22}{words:>8} carries {carried(shell, creases, *both):.0f} N/m2", flush=True
            )


if __name__ == "__main__":
    main()
