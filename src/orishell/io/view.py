"""The view of a shell: one block of bytes that the viewer and the studio draw from.

Little endian: the length N of the header (uint32), the header (JSON in UTF-8, filled up with spaces
to N bytes, N a multiple of four), then the arrays, each beginning at a multiple of four. The header
says where each array is. Coordinates are single precision, about ``origin``. Boards are given as
they lie in the flat sheet, and carried by their panels, which whole boards shift. Parts that
go with the sheet are views within the view, about the same ``origin``. A shell that was analysed
as a structure is given as it was meshed, what stiffens it behind its panels, with displacements,
stresses (in MPa) and loads on panels of every load case, the largest force along every crease (in
N/m), and the nodes that are held.
"""

from __future__ import annotations

import struct
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any, Literal, NotRequired, TypedDict

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.quantities import MILLIMETRES
from orishell.conventions.record import as_table
from orishell.conventions.row import Sign
from orishell.document import Document, DocumentState, FirstContact, Part
from orishell.document.loaded import LoadedCase, LoadedShell
from orishell.document.sizes import rows_of_panels
from orishell.numerics.arrays import Array

VERSION = 1
CODES = {"B": 0, "M": 1, "V": 2, "F": 3, "U": 3, "C": 4}
"""The number that stands for each assignment."""
MOST_COORDINATES = 4_000_000
"""Coordinates of states in a view, at most: of longer motions every k-th state is taken."""


Drawn = list[tuple[float, float]]
"""Points of a curve as it is drawn; empty if it is none."""


class Curves(TypedDict):
    """The target's curves."""

    f: Drawn
    g: Drawn


class NamedCase(TypedDict):
    """A load case: its name, whether the shell fails under it, and whether it is in balance.

    Without balance the shell moves as it is shown.
    """

    name: str
    sign: Sign
    balanced: bool
    # stress (MPa) that panels bear under loads that last as long; null if that is not known, or
    # without balance
    strength: float | None
    # the same of what stiffens the sheet, which may be of another material
    parts_strength: float | None


class CreaseLoads(TypedDict):
    """The largest force along every crease of a loaded shell: which, and under which load case."""

    what: Sequence[str]  # empty where there is none
    cases: Sequence[str]


class ArrayPlace(TypedDict):
    """Where an array of the view begins, in bytes behind the header."""

    type: Literal["float32", "uint32", "uint8"]
    shape: list[int]
    offset: int


class Header(TypedDict):
    """The header of a view: what the shell is, and where its arrays are."""

    version: int
    title: str
    unit: str
    # rows and columns of vertices; null if they are no grid's. Flaps beside it come after it.
    grid: tuple[int, int] | None
    names: NotRequired[list[str]]  # of panels, where there are others than those of the grid
    # from which drive on a part is there that moves with the sheet, if not always
    joined_from_deg: NotRequired[float]
    # was subtracted from all coordinates in space before they were rounded
    origin: tuple[float, float, float]
    drives_deg: list[float | None]  # drive of every state, in the order of the motion
    named: Mapping[str, int]  # numbers of the states that have a name: flat, target, pack
    # the fields of ``report.json``; if there is none, what the verdict says of sizes
    report: Mapping[str, object]
    contact: FirstContact | None
    arrays: dict[str, ArrayPlace]
    curves: NotRequired[Curves]  # in the studio
    cases: NotRequired[list[NamedCase]]  # load cases, where the shell was analysed as a structure
    creases: NotRequired[CreaseLoads]  # in the order of ``crease_forces``
    # numbers of what stiffens a shell that was analysed, behind those of panels, by its names
    stiffeners: NotRequired[dict[str, int]]


def dump_view(document: Document, curves: Curves | None = None) -> bytes:
    """The view of a document, with the first, the last and the named states among those taken."""
    document = document.as_cut()
    shell = document.shell.positions if len(document.states) else np.zeros((0, 3))
    origin = (shell.min(axis=0) + shell.max(axis=0)) / 2 if len(shell) else np.zeros(3)
    if not document.report:
        document = replace(document, report={"verdict": as_table(rows_of_panels(document))})
    more: dict[str, Any] = {} if curves is None else {"curves": curves}
    if document.loaded is not None:
        more["cases"] = [_named(case, _megapascals(document)) for case in document.loaded.cases]
        if document.loaded.creases is not None:
            creases = document.loaded.creases
            more["creases"] = {"what": creases.what, "cases": creases.cases}
        if document.loaded.parts is not None:
            more["stiffeners"] = document.loaded.parts.numbers
    told = {"report": dict(document.report), "contact": document.contact}
    arrays, world = _arrays_beside(document, origin), document.in_world(origin)
    return _dump_about(origin, document, world, beside=arrays, told=told, more=more)


def _named(case: LoadedCase, megapascal: float) -> NamedCase:
    """A load case of the header; ``megapascal`` is in newtons per square of the unit."""
    return {
        "name": case.name,
        "sign": case.sign,
        "balanced": case.balanced,
        "strength": None if case.strength is None else case.strength / megapascal,
        "parts_strength": (
            None if case.parts_strength is None else case.parts_strength / megapascal
        ),
    }


ALONE: Mapping[str, Any] = {"report": {}, "contact": None}
"""What is known of a part beside the sheet."""


def _dump_about(
    origin: Array,
    document: Part,
    world: Array,
    *,
    beside: Mapping[str, NDArray[Any]],
    told: Mapping[str, Any],
    more: Mapping[str, Any],
) -> bytes:
    """The view of a part, with coordinates in space from an origin (3,) in its frame.

    world: Where that is in the world (3,).
    beside: Further arrays by name, behind its own.
    told, more: Further fields of the header, before and behind those that say where arrays are.
    """
    import orjson

    count = len(document.states)
    most = max(2, MOST_COORDINATES // (3 * document.mesh.vertex_count))
    taken = np.rint(np.linspace(0, count - 1, min(count, most))).astype(int)
    numbers = sorted({*map(int, taken), *document.named.values()})
    states = [document.states[number] for number in numbers]
    arrays = {**_arrays(document, states, origin), **beside}
    places: dict[str, ArrayPlace] = {}
    offset = 0
    for name, array in arrays.items():
        kind: Any = str(array.dtype)
        places[name] = {"type": kind, "shape": list(array.shape), "offset": offset}
        offset += -(-array.nbytes // 4) * 4
    x, y, z = world.tolist()
    header: dict[str, Any] = {
        "version": VERSION,
        "title": document.title,
        "unit": document.unit,
        "grid": document.grid_shape,
        "origin": (x, y, z),
        "drives_deg": [state.drive_deg for state in states],
        "named": {name: numbers.index(number) for name, number in document.named.items()},
        **told,
        "arrays": places,
        **({"names": list(document.names)} if document.names else {}),
        **({"joined_from_deg": document.joined_from_deg} if document.joined_from_deg else {}),
        **more,
    }
    text = orjson.dumps(header)
    text += b" " * (-len(text) % 4)
    blocks = [array.tobytes() + b"\0" * (-array.nbytes % 4) for array in arrays.values()]
    return b"".join([struct.pack("<I", len(text)), text, *blocks])


def _placed(points: Array, origin: Array) -> NDArray[np.float32]:
    return np.asarray(points - origin, dtype="<f4")


def _arrays(
    document: Part, states: Sequence[DocumentState], origin: Array
) -> dict[str, NDArray[Any]]:
    """Arrays of a part by name, in the order of the file."""
    mesh = document.mesh
    flat = np.zeros((0, 2)) if document.flat is None else document.flat
    positions = [_placed(state.positions, origin) for state in states]
    letters = np.array(document.assignment)
    shown = letters != "J"  # what is joined is one panel
    arrays: dict[str, NDArray[Any]] = {
        "flat": flat.astype("<f4"),
        "positions": np.array(positions, "<f4").reshape(len(states), mesh.vertex_count, 3),
        "edges": mesh.edges[shown].astype("<u4"),
        "assignment": np.array([CODES.get(each, 3) for each in letters[shown]], dtype="u1"),
        "fold_angles_deg": document.fold_angles_deg[shown].astype("<f4"),
        "faces": mesh.faces.astype("<u4"),
    }
    if document.boards is not None:
        arrays["boards"] = document.boards.outlines.astype("<f4")
        arrays["board_panels"] = document.boards.panels.astype("<u4")
        if document.hinges.beside and len(states):
            # How far panels are moved, with their boards, in every state (S, F, 3).
            moved = [
                document.panel_corners(state)[:, 0] - state.positions[mesh.faces[:, 0]]
                for state in states
            ]
            arrays["panel_shifts"] = np.array(moved, "<f4")
    return arrays


def _arrays_beside(document: Document, origin: Array) -> dict[str, NDArray[Any]]:
    """Arrays of all that is not the sheet by name, in the order of the file."""
    arrays: dict[str, NDArray[Any]] = {
        f"curve_{name}": _placed(curve, origin) for name, curve in document.curves.items()
    }
    if document.surface is not None:
        arrays["surface"] = _placed(document.surface, origin)
    if document.distances is not None:
        arrays["distance"] = document.distances.astype("<f4")
    if document.loaded is not None:
        loaded, cases = document.loaded, document.loaded.cases
        arrays |= {
            "loaded_points": _placed(loaded.points, origin),
            "loaded_triangles": loaded.all_triangles.astype("<u4"),
            "loaded_panels": loaded.all_panels.astype("<u4"),
            "loaded_ties": loaded.ties.reshape(-1, 2).astype("<u4"),
            "displacements": np.stack([case.displacements for case in cases]).astype("<f4"),
            "stresses": (
                np.stack([case.stresses for case in cases]) / _megapascals(document)
            ).astype("<f4"),
            "panel_loads": np.stack([_on_panels(loaded, case) for case in cases]).astype("<f4"),
            "held": _held(loaded).astype("<u4"),
        }
        if loaded.creases is not None:
            metres = MILLIMETRES[document.require_unit()] / 1000
            arrays["crease_panels"] = loaded.creases.panels.astype("<u4")
            arrays["crease_forces"] = (loaded.creases.sizes / metres).astype("<f4")
    for number, part in enumerate(document.attached):
        view = _dump_about(origin, part, origin, beside={}, told=ALONE, more={})
        arrays[f"clipped_{number}"] = np.frombuffer(view, "u1")
    return arrays


def _megapascals(document: Document) -> float:
    """Newtons per square of the document's unit in a megapascal."""
    return MILLIMETRES[document.require_unit()] ** 2


def _on_panels(loaded: LoadedShell, case: LoadedCase) -> Array:
    """Loads of a case on every panel (P, 3), with its flaps those on what is meshed.

    Nodes that panels share count for each by the area of its triangles there, those of what only
    stiffens them for none.
    """
    a, b, c = np.moveaxis(loaded.points[loaded.triangles], 1, 0)
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    nodes, panels = loaded.triangles.ravel(), np.repeat(loaded.panels, 3)
    around = np.repeat(areas, 3)
    share = around / np.bincount(nodes, around)[nodes]
    axes = [np.bincount(panels, share * force) for force in case.forces[nodes].T]
    return np.stack(axes, axis=1)


def _held(loaded: LoadedShell) -> Array:
    """Supported nodes, and how each is held (S, 2): 0 held up only, 1 pinned, 2 clamped."""
    nodes = np.unique(loaded.restrained[:, 0])
    at = np.searchsorted(nodes, loaded.restrained[:, 0])
    along = np.bincount(at, weights=loaded.restrained[:, 1] < 3)
    turned = np.bincount(at, weights=loaded.restrained[:, 1] >= 3)
    return np.stack([nodes, np.where(turned > 0, 2, np.where(along > 1, 1, 0))], axis=1)
