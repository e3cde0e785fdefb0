"""Does it carry its loads: a shell of flat triangles, its hinges, supports and loads.

Derived in docs/theory/structure.md.
"""

from typing import TYPE_CHECKING

from orishell.conventions.imports import import_on_demand

if TYPE_CHECKING:
    from orishell.structure.equilibrium import Equilibrium
    from orishell.structure.load_settings import LoadCase, PointLoad, Snow, Wind, Zone
    from orishell.structure.results import Analysis, CaseResult, FreeMotion
    from orishell.structure.settings import Structure, Support

__all__ = [
    "Analysis",
    "CaseResult",
    "Equilibrium",
    "FreeMotion",
    "LoadCase",
    "PointLoad",
    "Snow",
    "Structure",
    "Support",
    "Wind",
    "Zone",
]

__getattr__, __dir__ = import_on_demand(
    __name__,
    {
        "orishell.structure.equilibrium": ("Equilibrium",),
        "orishell.structure.results": ("Analysis", "CaseResult", "FreeMotion"),
        "orishell.structure.load_settings": ("LoadCase", "PointLoad", "Snow", "Wind", "Zone"),
        "orishell.structure.settings": ("Structure", "Support"),
    },
)
