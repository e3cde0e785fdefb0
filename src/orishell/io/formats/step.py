"""All boards as solids in STEP, for programs of computer-aided design."""

from __future__ import annotations

import re
from collections.abc import Iterator
from importlib.util import find_spec
from itertools import count
from pathlib import Path
from typing import Any, Final

import numpy as np

from orishell.conventions.quantities import conversion
from orishell.document import FLAT, SHELL, Document
from orishell.io.format import Format, Settings
from orishell.io.solids import Solids, solids_in, solids_lying
from orishell.numerics.arrays import Array, Integers

TIME: Final = "1970-01-01T00:00:00"
"""The time that files name: the same input gives the same bytes."""
_PART: Final = re.compile(r"(NEXT_ASSEMBLY_USAGE_OCCURRENCE\()'\d+'([^;]*;)")


def write_step(path: Path, document: Document, settings: Settings) -> None:
    """Write every board as a solid with plane faces: the target to ``path``, the others beside it.

    Beside ``shell-target.step`` are ``shell-flat.step`` and, where there is a pack,
    ``shell-pack.step``; beside any other ``NAME.step`` they are ``NAME-flat.step`` and so on.
    Boards are called by panel and side, as in "3,12 top", and have the holes of their bolts. At the
    target those that are clipped on come last; in the flat state, the flat sheet with z up, they
    lie beside the sheet.

    Lengths are in millimetres, as the file says. Coordinates are about the document's origin or,
    far from it, about a point beside the shell, which the file's name for all boards says.
    """
    FORMAT.require_ready()
    stem = path.stem.removesuffix(f"-{SHELL}")
    for name in (SHELL, FLAT, "pack"):
        if name in document.named or name in {SHELL, FLAT}:
            file = path if name == SHELL else path.with_name(f"{stem}-{name}{path.suffix}")
            if name == FLAT:
                _write(file, document, solids_lying(document), np.zeros(3), "")
            else:
                nearby = document.nearby
                point = conversion(document.require_unit(), "mm") * nearby + 0.0
                about = " about ({:g}, {:g}, {:g}) mm".format(*point) if nearby.any() else ""
                _write(file, document, solids_in(document, name), document.origin - nearby, about)


def _write(
    file: Path, document: Document, solids: tuple[Solids, ...], moved: Array, about: str
) -> None:
    """Write boards that are moved (3,), in millimetres; ``about`` is added to the title."""
    from build123d import Compound, export_step

    scale = conversion(document.require_unit(), "mm")
    title = f"{' '.join(document.title.split())}{about}".encode("ascii", "replace").decode()
    made = [board for each in solids for board in _boards(each, scale, moved)]
    export_step(Compound(label=title, children=made), file, write_pcurves=False, timestamp=TIME)
    _renumber(file)


def _boards(solids: Solids, scale: float, moved: Array) -> Iterator[Any]:
    """Boards with their holes, moved (3,), then enlarged."""
    corners, axes = scale * (solids.corners + moved), scale * (solids.axes + moved)
    each = zip(solids.names, corners, solids.boards.places(), strict=True)
    for number, (name, outlines, places) in enumerate(each):
        board = _solid(outlines.reshape(-1, 3), _polygons(places, len(outlines)), name)
        mine = solids.drilled == number
        yield _drilled(board, axes[mine], 0.5 * scale * solids.diameters[mine])


def _renumber(file: Path) -> None:
    """Number the parts of the assembly from 1: the library goes on where its last file ended."""
    numbers = count(1)

    def numbered(found: re.Match[str]) -> str:
        rest = re.sub("\n *", "", found[2])  # lines end elsewhere after longer numbers
        return f"{found[1]}'{next(numbers)}'{rest}"

    text = _PART.sub(numbered, file.read_text(encoding="ascii"))
    file.write_text(text, encoding="ascii", newline="\n")


def _polygons(places: Integers, heights: int) -> list[list[int]]:
    """Corners of a board's faces, counter-clockwise seen from outside, each of them once."""
    rings = places.reshape(heights, -1)
    low, high = rings[:-1], rings[1:]
    around = np.stack([low, np.roll(low, -1, axis=1), np.roll(high, -1, axis=1), high], axis=-1)
    faces = [rings[0, ::-1].tolist(), rings[-1].tolist(), *around.reshape(-1, 4).tolist()]
    once = [list(dict.fromkeys(face)) for face in faces]
    return [face for face in once if len(face) > 2]


def _solid(points: Array, polygons: list[list[int]], name: str) -> Any:
    """The solid between plane polygons."""
    from build123d import Face, Shell, Solid, Wire

    place = [tuple(point) for point in points.tolist()]
    faces = [Face(Wire.make_polygon([place[corner] for corner in face])) for face in polygons]
    return Solid(Shell(faces), label=name)


def _drilled(board: Any, axes: Array, radii: Array) -> Any:
    """A board with holes (N,) through it, whose axes (N, 2, 3) end on its faces."""
    from build123d import Plane, Solid

    if not len(radii):
        return board
    drills = []
    for (start, end), radius in zip(axes, radii.tolist(), strict=True):
        # From as far before the board to as far behind it as it is thick.
        way = end - start
        plane = Plane(tuple((start - way).tolist()), z_dir=tuple(way.tolist()))
        drills.append(Solid.make_cylinder(radius, 3 * float(np.linalg.norm(way)), plane))
    (found,) = board.cut(*drills).solids()
    found.label = board.label
    return found


FORMAT = Format(
    "step",
    "shell-target.step",
    (".step", ".stp"),
    "solid boards in every state (STEP)",
    write_step,
    ready=lambda: find_spec("build123d") is not None,
    missing="STEP needs the library build123d, which is not installed",
    remedy='pip install "orishell[cad]"',
    solid=True,
    task="cad",
)
