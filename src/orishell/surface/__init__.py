"""The surface that a shell is to approach: f carried along g."""

from orishell.surface.path import Path
from orishell.surface.rails import Rail, Sliding, Turning
from orishell.surface.surface import Lattice, Surface

__all__ = ["Lattice", "Path", "Rail", "Sliding", "Surface", "Turning"]
