"""The names of the formats that are written, and the module of each.

A format is added by one module, which ends with its entry (``FORMAT``, a
:class:`~orishell.io.format.Format`), and one line here. Nothing is imported for the names: the
command line's help lists them, and does not wait for NumPy.
"""

from __future__ import annotations

MODULES = {
    "fold": "orishell.io.fold",
    "dxf": "orishell.io.formats.dxf",
    "svg": "orishell.io.formats.svg",
    "pdf": "orishell.io.formats.pdf",
    "origami-simulator": "orishell.io.formats.origami_simulator",
    "obj": "orishell.io.formats.obj",
    "stl": "orishell.io.formats.stl",
    "ply": "orishell.io.formats.ply",
    "glb": "orishell.io.formats.gltf",
    "3dm": "orishell.io.formats.rhino",
    "step": "orishell.io.formats.step",
    "3mf": "orishell.io.formats.threemf",
    "vtu": "orishell.io.formats.vtk",
    "inp": "orishell.io.formats.calculix",
    "csv": "orishell.io.formats.tables",
    "html": "orishell.io.formats.html",
}
"""By name, in the order in which they are listed."""

ALL = "all"
"""Stands for every format."""
