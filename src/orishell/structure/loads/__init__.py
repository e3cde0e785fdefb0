"""Loads of a case as forces on the nodes of the mesh, and where each comes from.

The load on a triangle goes to its corners in equal shares, so that nothing of it is lost. A new
load is a field of :class:`~orishell.structure.load_settings.LoadCase`, with its ``Loading``, and a
function of the same name in a module here, with ``@load``.
"""

from orishell.structure.load_settings import LOADS
from orishell.structure.loads import person, points, snow, weight, wind
from orishell.structure.loads.cases import (
    DOUBTS,
    KINDS,
    CaseLoads,
    Load,
    Scale,
    case_loads,
    require_effects,
    sum_forces,
)
from orishell.structure.loads.exposure import Exposure, Vector, vector
from orishell.structure.loads.wind import gusts, peak_pressure

require_effects(LOADS)

__all__ = [
    "DOUBTS",
    "KINDS",
    "CaseLoads",
    "Exposure",
    "Load",
    "Scale",
    "Vector",
    "case_loads",
    "gusts",
    "peak_pressure",
    "person",
    "points",
    "require_effects",
    "snow",
    "sum_forces",
    "vector",
    "weight",
    "wind",
]
