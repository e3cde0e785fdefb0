"""What a family hands over when a design succeeds, and the surface that it approaches."""

from orishell.design.design import (
    Approached,
    Construction,
    Design,
    FlapSide,
    PanelBuild,
    Parameter,
    warn_of_no_lock,
)
from orishell.design.path import Path
from orishell.design.rails import Rail, Sliding, Turning
from orishell.design.surface import Lattice, Surface

__all__ = [
    "Approached",
    "Construction",
    "Design",
    "FlapSide",
    "Lattice",
    "PanelBuild",
    "Parameter",
    "Path",
    "Rail",
    "Sliding",
    "Surface",
    "Turning",
    "warn_of_no_lock",
]
