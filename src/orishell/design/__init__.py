"""What a family hands over when a design succeeds, and the surface that it approaches."""

from orishell.design.asked import AskedSurface, PiecedSurface
from orishell.design.design import (
    Approached,
    Design,
    FlapSide,
    Parameter,
    warn_of_no_lock,
)
from orishell.design.end_walls import BuiltEndWall, Door, EndWall, Opening
from orishell.design.formula_surface import FormulaSurface
from orishell.design.mesh_surface import MeshSurface
from orishell.design.panel import Construction, HingeSpec, PanelSpec, Setback, Sides
from orishell.design.path import Path
from orishell.design.piece import Facets, Foot, Piece
from orishell.design.plan_rectangle import PlanRectangle
from orishell.design.rails import Rail, Sliding, Turning
from orishell.design.surface import Lattice, Surface

__all__ = [
    "Approached",
    "AskedSurface",
    "BuiltEndWall",
    "Construction",
    "Design",
    "Door",
    "EndWall",
    "Facets",
    "FlapSide",
    "Foot",
    "FormulaSurface",
    "HingeSpec",
    "Lattice",
    "MeshSurface",
    "Opening",
    "PanelSpec",
    "Parameter",
    "Path",
    "Piece",
    "PiecedSurface",
    "PlanRectangle",
    "Rail",
    "Setback",
    "Sides",
    "Sliding",
    "Surface",
    "Turning",
    "warn_of_no_lock",
]
