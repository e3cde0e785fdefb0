"""All states of the shell for ParaView, VTU files and the PVD that lists them; its structure."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from orishell.conventions.quantities import MILLIMETRES
from orishell.document import Document
from orishell.document.loaded import LoadedShell
from orishell.io.format import Format, Settings
from orishell.numerics.arrays import Array, Integers

SERIES = ".pvd"

NOWHERE = -2
"""The row and column of panels that are in none of the sheet; -1 are those of flaps beside it."""
_GRID = b"<UnstructuredGrid>\n"


def write_vtk(path: Path, document: Document, settings: Settings) -> None:
    """Write one VTU file for each state and the PVD file that makes a series of them.

    For ``shell.vtu`` these are ``shell-0000.vtu``, ``shell-0001.vtu`` ... and ``shell.pvd``; the
    state that the settings choose is ``shell.vtu`` itself. For ``shell.pvd`` there is no single
    file. The time of a state is its drive angle in degrees, or its number if not all states have
    rising drive angles. A shell that was analysed as a structure is in ``shell-structure.vtu``.

    The z axis is up. Cells are the panels, with their number and, in a grid, their row and
    column. Panels of other parts that are there, as boards clipped on, gussets and box girders,
    come behind those of the sheet: a field that is called as one is, "box 4 upper 3", has its
    number, and its row and column are -2. Coordinates are in the document's unit, in double
    precision. VTU has no place for a unit: a comment names it, and the field ``metres_per_unit``
    has its length; the field ``drive_deg`` has the drive angle.
    """
    chosen = document.state(settings.state)
    single = path.suffix.lower() != SERIES
    if single:
        _write_state(path, document, settings.state)
    files, drives = [], []
    for number, state in enumerate(document.states or [chosen]):
        files.append(f"{path.stem}-{number:04d}.vtu")
        drives.append(np.nan if state.drive_deg is None else float(state.drive_deg))
        _write_state(path.with_name(files[-1]), document, number)
    series = path.with_suffix(SERIES) if single else path
    series.write_text(_collection(files, drives, document.unit), encoding="utf-8", newline="\n")
    if document.loaded is not None:
        _write_structure(path.with_name(f"{path.stem}-structure.vtu"), document, document.loaded)


def _write_state(path: Path, document: Document, which: int | str) -> None:
    (sheet, state), *others = document.parts_in(which)
    panels, points = [sheet.mesh.faces], [state.positions]
    numbers: dict[str, int] = {}
    for part, own in others:
        first = sum(map(len, panels))
        numbers |= {name: first + k for k, name in enumerate(part.names)}
        panels.append(part.mesh.faces + sum(map(len, points)))
        points.append(own.positions)
    faces = np.concatenate(panels)
    cell_data = {"panel": [np.arange(len(faces), dtype=np.int32)]}
    if document.rows_and_columns is not None:
        beside = np.full(len(faces) - len(sheet.mesh.faces), NOWHERE)
        rows, columns = (
            np.concatenate([each, beside]).astype(np.int32) for each in document.rows_and_columns
        )
        cell_data |= {"row": [rows], "column": [columns]}
    facts = _facts(document, state.drive_deg, numbers)
    _write_mesh(
        path, document.in_world(np.concatenate(points)), ("quad", faces), facts, cell_data=cell_data
    )


def _write_structure(path: Path, document: Document, shell: LoadedShell) -> None:
    """Write the meshed shell with what loads, deflects, stresses and buckles it in every case.

    Displacements of a case that nothing holds are those of its free motion, and it has no stresses.
    What stiffens the sheet is among the panels, by numbers behind theirs, which fields name.
    """
    from xml.sax.saxutils import escape

    point_data: dict[str, Array] = {}
    cell_data: dict[str, list[Any]] = {"panel": [shell.all_panels.astype(np.int32)]}
    for case in shell.cases:
        moved = "displacement" if case.balanced else "free motion"
        name = escape(case.name, {'"': "&quot;"})  # meshio writes names as they are
        point_data |= {f"{moved}: {name}": case.displacements, f"load: {name}": case.forces}
        for factor, mode in case.buckling:
            point_data[f"buckles under {factor:.4g} times: {name}"] = mode
        if case.balanced:
            cell_data[f"von Mises: {name}"] = [case.stresses]
    cells, parts = ("triangle", shell.all_triangles), shell.parts
    numbers = {} if parts is None else parts.numbers
    points, facts = (
        document.in_world(shell.points),
        _facts(document, document.shell.drive_deg, numbers),
    )
    _write_mesh(path, points, cells, facts, point_data=point_data, cell_data=cell_data)


def _write_mesh(
    path: Path, points: Array, cells: tuple[str, Integers], facts: bytes, **data: Any
) -> None:
    import meshio

    kind, nodes = cells
    mesh = meshio.Mesh(points, [(kind, nodes.astype(np.int32))], **data)
    meshio.write(path, mesh, file_format="vtu")
    path.write_bytes(path.read_bytes().replace(_GRID, _GRID + facts, 1))


def _facts(document: Document, drive_deg: float | None, numbers: Mapping[str, int]) -> bytes:
    """What is known of a whole state, for which meshio has no place.

    numbers: Those of panels that are none of the sheet's, by what they are called.
    """
    from xml.sax.saxutils import quoteattr

    fields: dict[str, tuple[str, float]] = {}
    if document.unit in MILLIMETRES:
        fields["metres_per_unit"] = "Float64", MILLIMETRES[document.unit] / MILLIMETRES["m"]
    if drive_deg is not None:
        fields["drive_deg"] = "Float64", float(drive_deg)
    fields |= {name: ("Int32", number) for name, number in numbers.items()}
    lines = [f"<!--Unit: {document.unit}. Up: z.-->"]
    if fields:
        lines += [
            "<FieldData>",
            *(
                f'<DataArray type="{kind}" Name={quoteattr(name)} NumberOfTuples="1" '
                f'format="ascii">{value!r}</DataArray>'
                for name, (kind, value) in fields.items()
            ),
            "</FieldData>",
        ]
    return "".join(f"{line}\n" for line in lines).encode()


def _collection(files: list[str], drives: list[float], unit: str) -> str:
    from xml.sax.saxutils import quoteattr

    rising = bool(np.all(np.isfinite(drives)) and np.all(np.diff(drives) > 0))
    times = drives if rising else [float(number) for number in range(len(files))]
    meaning = "drive angle in degrees" if rising else "number of the state"
    lines = [
        '<?xml version="1.0"?>',
        f"<!--Unit: {unit}. Up: z. Time: {meaning}.-->",
        '<VTKFile type="Collection" version="0.1" byte_order="LittleEndian">',
        "<Collection>",
        *(
            f'<DataSet timestep="{time!r}" part="0" file={quoteattr(file)}/>'
            for time, file in zip(times, files, strict=True)
        ),
        "</Collection>",
        "</VTKFile>",
    ]
    return "".join(f"{line}\n" for line in lines)


FORMAT = Format(
    "vtu", "shell.vtu", (".vtu", SERIES), "states for ParaView", write_vtk, task="analysis"
)
