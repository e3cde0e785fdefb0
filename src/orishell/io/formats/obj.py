"""One state of the shell as Wavefront OBJ."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from orishell.document import Document
from orishell.io.format import Format, Settings
from orishell.io.solids import mesh_of, solids_in, y_up
from orishell.numerics.arrays import Array, Integers


def write_obj(path: Path, document: Document, settings: Settings) -> None:
    """Write the panels of one state as quadrilaterals.

    The y axis is up, as readers of OBJ expect: a point (x, y, z) is written as (x, z, -y).
    Coordinates are in the document's unit, which a comment names (OBJ has no place for it), and
    have all their digits. A grid has one group for each row of panels, any other sheet one group.
    Other parts that are there, as boards clipped on at the target, are groups after the sheet.

    Where panels have a thickness each of their boards is a group of triangles, a closed surface
    called by panel and side, as in "3,12_top".
    Without smoothing (``s off``) creases stay sharp.
    """
    write = _sheet if document.boards is None else _solids
    content = "".join(write(document, settings.state))
    with path.open("w", encoding="utf-8", newline="\n") as file:
        file.write(f"# {' '.join(document.title.split())}\n# Unit: {document.unit}. Up: y.\n")
        file.write(content)


def _sheet(document: Document, which: int | str) -> Iterator[str]:
    """Panels of the sheet, and of the other parts that are there in a state."""
    (_, state), *others = document.parts_in(which)
    positions, faces = state.positions, document.mesh.faces
    yield from _vertices(document.in_world(positions))
    yield "s off\n"
    row = len(faces) if document.whole_grid is None else document.whole_grid[1] - 1
    for number, begin in enumerate(range(0, len(faces), row)):
        yield "g panels\n" if document.whole_grid is None else f"g row_{number}\n"
        yield from _faces(faces[begin : begin + row] + 1)
    first = 1 + len(positions)
    for number, (part, state) in enumerate(others, 1):
        yield from _vertices(document.in_world(state.positions))
        yield f"g board_{number}\n"
        yield from _faces(part.mesh.faces + first)
        first += part.mesh.vertex_count


def _solids(document: Document, which: int | str) -> Iterator[str]:
    """Boards as closed surfaces."""
    mesh = mesh_of(solids_in(document, which))
    yield from _vertices(document.in_world(mesh.vertices))
    yield "s off\n"
    ends = mesh.first_triangle.tolist()
    for name, begin, end in zip(mesh.names, ends, ends[1:], strict=False):
        yield f"g {name.replace(' ', '_')}\n"
        yield from _faces(mesh.triangles[begin:end] + 1)


def _vertices(positions: Array) -> Iterator[str]:
    """Lines for points (V, 3), y up."""
    return (f"v {x!r} {y!r} {z!r}\n" for x, y, z in y_up(positions).tolist())


def _faces(faces: Integers) -> Iterator[str]:
    return (f"f {' '.join(map(str, corners))}\n" for corners in faces.tolist())


FORMAT = Format("obj", "shell.obj", (".obj",), "one state (Wavefront OBJ)", write_obj, task="cad")
