"""All boards as 3MF, for printers."""

from __future__ import annotations

import locale
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from orishell.conventions.quantities import conversion
from orishell.document import FLAT, Document
from orishell.io.format import Format, Settings, numbered_ids
from orishell.io.solids import mesh_of, solids_in, solids_lying
from orishell.numerics.arrays import Array, Integers


def write_3mf(path: Path, document: Document, settings: Settings) -> None:
    """Write every board as an object, called by panel and side, ready to be printed.

    Lengths are in millimetres, times ``[workshop] model_scale``. Every object is closed and
    oriented. They stand beside each other as in the chosen state, moved so that all coordinates
    are positive and the lowest are 0, as printers expect; z is up. In the flat state they lie as in
    the flat sheet, and boards that are clipped on lie beside it. Coordinates are in single
    precision.
    """
    FORMAT.require_ready()
    state = settings.print_state
    mesh = mesh_of(solids_lying(document) if state == FLAT else solids_in(document, state))
    scale = conversion(document.require_unit(), "mm") * settings.workshop.model_scale
    lowest = mesh.vertices.min(axis=0, initial=np.inf)
    model = _Model(document.title)
    for name, vertices, triangles in mesh.each():
        model.add(name, scale * (vertices - lowest), triangles)
    model.write(path)


class _Model:
    """A model in millimetres."""

    def __init__(self, title: str) -> None:
        import lib3mf

        self._wrapper: Any = lib3mf.get_wrapper()
        self._model = self._wrapper.CreateModel()
        self._model.SetUnit(lib3mf.ModelUnit.MilliMeter)
        self._model.GetMetaDataGroup().AddMetaData("", "Title", title, "xs:string", True)
        self._model.GetMetaDataGroup().AddMetaData("", "Application", "orishell", "xs:string", True)
        self._ids = map(str, numbered_ids())
        self._model.SetBuildUUID(next(self._ids))

    def add(self, name: str, vertices: Array, triangles: Integers) -> None:
        """Add an object with vertices (N, 3) and triangles (T, 3)."""
        import lib3mf

        made = self._model.AddMeshObject()
        made.SetName(name)
        made.SetUUID(next(self._ids))
        points = (lib3mf.Position * len(vertices)).from_buffer_copy(
            vertices.astype(np.float32).tobytes()
        )
        corners = (lib3mf.Triangle * len(triangles)).from_buffer_copy(
            triangles.astype(np.uint32).tobytes()
        )
        made.SetGeometry(points, corners)
        item = self._model.AddBuildItem(made, self._wrapper.GetIdentityTransform())
        item.SetUUID(next(self._ids))

    def write(self, path: Path) -> None:
        """Write all of it. The library leaves the whole process in the locale "C"."""
        before = locale.setlocale(locale.LC_ALL)
        try:
            self._model.QueryWriter("3mf").WriteToFile(str(path))
        finally:
            locale.setlocale(locale.LC_ALL, before)


FORMAT = Format(
    "3mf",
    "shell.3mf",
    (".3mf",),
    "boards to be printed, in millimetres (3MF)",
    write_3mf,
    ready=lambda: find_spec("lib3mf") is not None,
    missing="3MF needs the library lib3mf, which is not installed",
    remedy='pip install "orishell[print]"',
    solid=True,
)
