"""Loads of a case as forces on the nodes of the mesh, and where each comes from.

The load on a triangle goes to its corners in equal shares, so that nothing of it is lost. A new
load is a field of :class:`~orishell.structure.load_settings.LoadCase`, and a function of the same
name in a module here.
"""

from orishell.structure.loads import person, points, snow, weight, wind
from orishell.structure.loads.cases import KINDS, Load, case_loads, sum_forces
from orishell.structure.loads.exposure import Exposure, Vector, vector
from orishell.structure.loads.wind import gusts, peak_pressure

__all__ = [
    "KINDS",
    "Exposure",
    "Load",
    "Vector",
    "case_loads",
    "gusts",
    "peak_pressure",
    "person",
    "points",
    "snow",
    "sum_forces",
    "vector",
    "weight",
    "wind",
]
