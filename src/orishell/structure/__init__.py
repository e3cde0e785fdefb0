"""Does it carry its loads: a shell of flat triangles, its hinges, supports and loads.

Derived in docs/theory/structure.md.
"""

from typing import TYPE_CHECKING

from orishell.conventions.imports import import_on_demand

if TYPE_CHECKING:
    from orishell.structure.case import CaseResult
    from orishell.structure.equilibrium import Equilibrium
    from orishell.structure.free_motion import FreeMotion
    from orishell.structure.load_settings import LoadCase, Person, PointLoad, Snow, Wind, Zone
    from orishell.structure.results import Analysis
    from orishell.structure.settings import Structure, Support

__all__ = [
    "Analysis",
    "CaseResult",
    "Equilibrium",
    "FreeMotion",
    "LoadCase",
    "Person",
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
        "orishell.structure.case": ("CaseResult",),
        "orishell.structure.free_motion": ("FreeMotion",),
        "orishell.structure.results": ("Analysis",),
        "orishell.structure.load_settings": (
            "LoadCase",
            "Person",
            "PointLoad",
            "Snow",
            "Wind",
            "Zone",
        ),
        "orishell.structure.settings": ("Structure", "Support"),
    },
)
