"""Tables of comma-separated values, as a spreadsheet may open them."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Sequence
from itertools import chain
from math import isnan
from pathlib import Path

import numpy as np

from orishell.conventions.quantities import conversion
from orishell.design.fittings import Fittings
from orishell.document import Document
from orishell.io.format import Format, Settings
from orishell.io.joint_tables import hung_table, order_table, schedule_table, ties_table
from orishell.motion.boards import SIDES, Boards
from orishell.motion.grid import CreaseValues
from orishell.motion.hinges import Hinges, piece_numbers
from orishell.workshop import Workshop
from orishell.workshop.assembly import laid_flat
from orishell.workshop.board_masses import densities_of_boards
from orishell.workshop.board_sheets import board_parts, nest_boards
from orishell.workshop.ground_plan import ground_beside
from orishell.workshop.hinge_parts import fittings_of, hinge_names

FORMULA = ("=", "+", "-", "@", "\t", "\n")
"""A spreadsheet takes a cell that begins with one of these for a formula, and computes it."""


def write_csv(path: Path, heads: Sequence[str], rows: Iterable[Sequence[object]]) -> None:
    """Write a table: a line of names, and a line for each row.

    A text that a spreadsheet would compute has a quote (``'``) in front; texts that are numbers
    have none. A carriage return becomes a blank.

    Parameters
    ----------
    heads, rows
        Names of the columns.
    """
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerows([_safe(cell) for cell in row] for row in chain([heads], rows))


def _safe(cell: object) -> object:
    if not isinstance(cell, str):
        return cell
    cell = cell.replace("\r", " ")  # which the csv module may leave without quotes
    if not cell.startswith(FORMULA):
        return cell
    try:
        float(cell)
    except ValueError:
        return f"'{cell}"
    return cell


def write_tables(path: Path, document: Document, settings: Settings) -> None:
    """Write the panels to ``path`` and the creases beside it.

    The creases go to ``creases.csv`` beside ``panels.csv``, and to ``NAME-creases.csv`` beside any
    other ``NAME.csv``; what joins panels along them to ``schedule.csv``, what to order to
    ``order.csv``, ties to ``ties.csv`` and lines along which parts hang on the sheet to
    ``lines.csv``, likewise. So do boards, where panels have a thickness,
    to ``boards.csv``, hinges of whole boards to ``hinges.csv``, the kinds of their arms to
    ``arms.csv``, joints of pieces to ``joints.csv``; feet, from one corner, go to ``ground.csv``.
    The first line names the columns and their units; panels are numbered from 0, and by row and
    column where the sheet is a grid; numbers have all their digits.
    """

    def beside(name: str) -> Path:
        return path.with_name(f"{name}.csv" if path.stem == "panels" else f"{path.stem}-{name}.csv")

    write_csv(path, *_panels(document))
    write_csv(beside("creases"), *_creases(document))
    write_csv(beside("schedule"), *schedule_table(document, settings.workshop))
    write_csv(beside("order"), *order_table(document, settings.workshop))
    if document.ties:
        write_csv(beside("ties"), *ties_table(document, settings.workshop))
    hung = hung_table(document)
    if hung is not None:
        write_csv(beside("lines"), *hung)
    if document.boards is not None:
        write_csv(beside("boards"), *_boards(document, settings.workshop))
    if document.ground is not None:
        write_csv(ground_beside(path), *document.ground.table(document.unit))
    fittings = fittings_of(document)
    if fittings is not None:
        write_csv(beside("hinges"), *_hinges(document, fittings))
        write_csv(beside("arms"), *_arms(document, fittings))
    if document.hinges.joint_rows:
        write_csv(beside("joints"), *_joints(document))


def _panels(document: Document) -> tuple[list[str], Iterable[Sequence[object]]]:
    unit = document.unit
    corners = document.require_flat()[document.mesh.faces]
    perimeter = np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=-1).sum(axis=1)
    heads = [
        "panel",
        "row",
        "column",
        *(f"{axis}{corner}_{unit}" for corner in (1, 2, 3, 4) for axis in "xy"),
        f"area_{unit}2",
        f"perimeter_{unit}",
    ]
    count = len(corners)
    rows: Iterable[object] = [""] * count
    columns = rows
    if document.rows_and_columns is not None:
        rows, columns = document.rows_and_columns
    numbers = np.column_stack([corners.reshape(count, 8), document.areas(), perimeter]).tolist()
    return heads, (
        [panel, row, column, *values]
        for panel, (row, column, values) in enumerate(zip(rows, columns, numbers, strict=True))
    )


def _creases(document: Document) -> tuple[list[str], Iterable[Sequence[object]]]:
    unit, mesh, lengths = document.unit, document.mesh, document.edge_lengths()
    heads = [
        "crease",
        "panel_1",
        "panel_2",
        "vertex_1",
        "vertex_2",
        f"length_{unit}",
        "fold_angle_at_lock_deg",
        "assignment",
    ]
    numbers = np.flatnonzero(mesh.crease)
    angles = document.fold_angles_deg[numbers].tolist()
    return heads, (
        [
            number,
            *panels,
            *vertices,
            size,
            "" if isnan(angle) else angle,
            document.assignment[number],
        ]
        for number, panels, vertices, size, angle in zip(
            numbers.tolist(),
            mesh.edge_faces[numbers].tolist(),
            mesh.edges[numbers].tolist(),
            lengths[numbers].tolist(),
            angles,
            strict=True,
        )
    )


def _boards(document: Document, workshop: Workshop) -> tuple[list[str], Iterable[Sequence[object]]]:
    """Boards in the order in which they are drawn, those that are clipped on included."""
    unit, everything = document.unit, laid_flat(document)
    boards = everything.boards
    assert boards is not None
    heads = ["part", "panel", "side", f"area_{unit}2", f"volume_{unit}3", "mass_kg", "sheet"]
    pieces = _pieces(boards)
    if pieces:
        heads.append("piece")
    areas, volumes = boards.areas().tolist(), boards.volumes()
    densities = densities_of_boards(document)
    masses = (volumes * conversion(unit, "m") ** 3 * densities).tolist()
    parts = board_parts(document)
    sheets: Iterable[object] = [""] * len(parts)
    if workshop.stock is not None:
        sheets = [1 + placement.sheet for placement in nest_boards(document, workshop)]
    return heads, (
        [
            part.name,
            everything.panel_name(part.panel),
            SIDES[part.side],
            areas[part.number],
            float(volumes[part.number]),
            masses[part.number] if densities[part.number] else "",
            sheet,
            *(pieces[part.number : part.number + 1]),
        ]
        for part, sheet in zip(parts, sheets, strict=True)
    )


def _pieces(boards: Boards) -> list[int]:
    """The piece (B,) that every board belongs to, from 1; nothing where the sheet is whole."""
    if not boards.hinges.joint_rows:
        return []
    numbers: list[int] = (1 + piece_numbers(boards)).tolist()
    return numbers


def _hinges(document: Document, fittings: Fittings) -> tuple[list[str], Iterable[Sequence[object]]]:
    """Hinges of whole boards: their boards, on which face or arms, and what screws them on."""
    assert document.panel is not None
    hinges, unit = document.hinges, document.unit
    assert isinstance(hinges, Hinges)
    (above, below), (left, right) = hinges.arms
    numbers = fittings.edges
    first, second = (
        CreaseValues(row, column).on_edges()[numbers].tolist()
        for row, column in ((above, left), (below, right))
    )
    density = document.panel.hinge.linear_density * conversion(unit, "m")
    heads = [
        *("hinge", "crease", "panel_1", "panel_2", "side", "stands_on"),
        *(f"{name}_{unit}" for name in ("length", "height", "arm_1", "arm_2")),
        *("kind_1", "kind_2", f"leaf_{unit}", "holes", "mass_kg"),
    ]
    kinds = ["", *(arm.name for arm in fittings.arms)]
    kinds_1, kinds_2 = ([kinds[k + 1] for k in each.tolist()] for each in fittings.of_kind.T)
    return heads, zip(
        hinge_names(fittings),
        numbers.tolist(),
        *fittings.panels.T.tolist(),
        (SIDES[side] for side in fittings.sides.tolist()),
        ("arms" if on_arms else "face" for on_arms in fittings.on_arms.tolist()),
        fittings.lengths.tolist(),
        hinges.heights.on_edges()[numbers].tolist(),
        first,
        second,
        kinds_1,
        kinds_2,
        fittings.leaves.tolist(),
        fittings.counts.tolist(),
        (length * density or "" for length in fittings.lengths.tolist()),
        strict=True,
    )


def _joints(document: Document) -> tuple[list[str], Iterable[Sequence[object]]]:
    """Joints of pieces: on which face boards meet, and how far they are cut back."""
    unit, lengths, hinges = document.unit, document.edge_lengths(), document.hinges
    assert isinstance(hinges, Hinges)
    assert hinges.joints is not None
    across, signs = hinges.grid.columns - 1, hinges.signs.row
    heads = [
        "crease",
        "panel_1",
        "panel_2",
        "piece_1",
        "piece_2",
        "side",
        f"length_{unit}",
        f"cut_1_{unit}",
        f"cut_2_{unit}",
    ]
    return heads, (
        [
            number,
            *_beside(number, hinges.grid.rows * across, across),
            joint + 1,
            joint + 2,
            SIDES[int(signs[row, column])],
            lengths[number],
            *hinges.joints.cuts[:, joint, column].tolist(),
        ]
        for joint, row in enumerate(hinges.joints.rows)
        for column, number in enumerate(range((row + 1) * across, (row + 2) * across))
    )


def _beside(edge: int, row_edges: int, across: int) -> tuple[int, int]:
    """The panels above and below an edge of a row of the grid, or left and right of a column's."""
    if edge < row_edges:
        return edge - across, edge
    row, column = divmod(edge - row_edges, across + 1)
    return row * across + column - 1, row * across + column


def _arms(document: Document, fittings: Fittings) -> tuple[list[str], Iterable[Sequence[object]]]:
    """Kinds of arms: how many there are, and what each is bent of."""
    build, unit = document.panel, document.unit
    assert build is not None
    density = build.arm_density * build.fin * conversion(unit, "m") ** 3
    heads = [
        *("kind", "count"),
        *(f"{name}_{unit}" for name in ("length", "fin", "foot", "thickness")),
        *("holes_in_fin", "holes_in_foot", "mass_kg"),
    ]
    return heads, (
        [
            *(arm.name, arm.count, arm.length, arm.height, arm.foot, build.fin),
            0 if arm.in_fin is None else len(arm.along),
            0 if arm.in_foot is None else len(arm.along),
            density * arm.area or "",
        ]
        for arm in fittings.arms
    )


FORMAT = Format(
    "csv", "panels.csv", (".csv",), "tables of panels and creases", write_tables, task="analysis"
)
