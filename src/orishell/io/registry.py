"""All formats that are written, in one list."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path

from orishell.document import Document
from orishell.errors import InputError
from orishell.io.fold import write_fold
from orishell.io.formats.dxf import write_dxf
from orishell.io.formats.gltf import write_gltf
from orishell.io.formats.html import viewer_is_built, write_html
from orishell.io.formats.obj import write_obj
from orishell.io.formats.origami_simulator import write_origami_simulator
from orishell.io.formats.pdf import write_pdf
from orishell.io.formats.ply import write_ply
from orishell.io.formats.rhino import write_rhino
from orishell.io.formats.stl import write_stl
from orishell.io.formats.svg import write_svg
from orishell.io.formats.tables import write_tables
from orishell.io.formats.vtk import write_vtk
from orishell.io.settings import Settings

ALL = "all"
"""Stands for every format."""


@dataclass(frozen=True, slots=True)
class Format:
    """A format.

    Parameters
    ----------
    name
        What the command line calls it.
    file
        The file that is written for a designed shell; others may be written beside it.
    endings
        Endings of file names that mean this format.
    what
        What is in it, in a few words.
    write
        Writes a document to a path, and whatever belongs to it beside the path.
    lays_surface
        Whether it shows the surface that the shell follows, if the document has it.
    ready
        Whether what it needs is there.
    """

    name: str
    file: str
    endings: tuple[str, ...]
    what: str
    write: Callable[[Path, Document, Settings], None]
    lays_surface: bool = False
    ready: Callable[[], bool] = lambda: True


FOLD = Format("fold", "shell.fold", (".fold",), "pattern and motion (FOLD 1.2)", write_fold)

FORMATS: tuple[Format, ...] = (
    FOLD,
    Format("dxf", "pattern.dxf", (".dxf",), "flat pattern for the workshop", write_dxf),
    Format("svg", "pattern.svg", (".svg",), "flat pattern for the workshop", write_svg),
    Format("pdf", "pattern.pdf", (".pdf",), "paper model, tiled over pages", write_pdf),
    Format(
        "origami-simulator",
        "pattern.origami-simulator.svg",
        (".origami-simulator.svg",),
        "flat pattern for Origami Simulator",
        write_origami_simulator,
    ),
    Format("obj", "shell.obj", (".obj",), "one state (Wavefront OBJ)", write_obj),
    Format("stl", "shell.stl", (".stl",), "one state (STL)", write_stl),
    Format("ply", "shell.ply", (".ply",), "one state (PLY)", write_ply),
    Format("glb", "shell.glb", (".glb",), "the motion of rigid panels (glTF)", write_gltf),
    Format("3dm", "shell.3dm", (".3dm",), "pattern, shell and curves (Rhino)", write_rhino),
    Format("vtu", "shell.vtu", (".vtu", ".pvd"), "states for ParaView", write_vtk),
    Format("csv", "panels.csv", (".csv",), "tables of panels and creases", write_tables),
    Format(
        "html",
        "viewer.html",
        (".html",),
        "a page that shows the motion, in one file",
        write_html,
        lays_surface=True,
        ready=viewer_is_built,
    ),
)


def find_formats(names: Iterable[str]) -> tuple[Format, ...]:
    """Formats by their names, in the order of the list, each once; "all" stands for all ready ones.

    Parameters
    ----------
    names
        Names of formats, in any order.

    Raises
    ------
    InputError
        If a name is unknown.
    """
    asked = {name.strip().lower() for name in names}
    unknown = sorted(asked - {format_.name for format_ in FORMATS} - {ALL})
    if unknown:
        raise InputError(
            "there is no such format",
            got=", ".join(map(repr, unknown)),
            expected="some of " + ", ".join(format_.name for format_ in FORMATS) + f"; or {ALL}",
        )
    return tuple(
        format_
        for format_ in FORMATS
        if format_.name in asked or (ALL in asked and format_.ready())
    )


def format_of(path: Path) -> Format:
    """The format that a file's name asks for by its ending, the longest that fits.

    Parameters
    ----------
    path
        The file to write.

    Raises
    ------
    InputError
        If no format has that ending.
    """
    name = path.name.lower()
    fitting = [
        (len(ending), format_)
        for format_ in FORMATS
        for ending in format_.endings
        if name.endswith(ending) and len(name) > len(ending)
    ]
    if not fitting:
        raise InputError(
            "no format has this ending",
            where=str(path),
            got=path.suffix or "none",
            expected="one of "
            + ", ".join(ending for format_ in FORMATS for ending in format_.endings),
        )
    return max(fitting, key=lambda found: found[0])[1]
