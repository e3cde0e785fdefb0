"""The motion of the shell as binary glTF: every panel a rigid node that turns and moves."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, Final

import numpy as np

from orishell.conventions.colours import MEANINGS, linear_rgb
from orishell.conventions.quantities import conversion
from orishell.document import FLAT, OPEN, Document, DocumentState, Part
from orishell.io.format import Format, Settings
from orishell.io.gltf_buffers import INDICES, VERTICES, Buffers, Singles, singles
from orishell.io.solids import TRIANGLES, find_frames, find_splits, quaternions, y_up
from orishell.motion.quads import longer_diagonals
from orishell.numerics.arrays import Array, Booleans, Integers

SECONDS: Final = 4.0
"""How long the animation takes from the first state to the last."""


def write_gltf(path: Path, document: Document, settings: Settings) -> None:
    """Write every panel as a node, and the motion through all states as an animation.

    Lengths are in metres and the y axis is up, as glTF demands: a point (x, y, z) is written as
    (x, z, -y). Nodes are called "panel ROW,COLUMN" and stand as in the chosen state. A panel's
    shape lies in its node's own plane and is the same all the time: it is that of the chosen
    state. Between two states viewers turn a node evenly, by the shorter way, and move its
    origin, the mean of the panel's corners, along a straight line. So panels stay rigid, and
    neighbours part by less than s²L/8 if their diagonals are L long and they turn by s radians
    from one state to the next: some thousandths of L with 13 states, a quarter of that with 25.
    A panel must turn by less than 180 degrees from state to state.

    Where panels have a thickness their nodes carry their boards, closed and with flat faces; the
    panel itself is the membrane between two boards, and left out where it is one solid.

    Edges are lines in the colours of mountains and valleys (``conventions.colours``), each with the
    panel on one side of it.

    Numbers are in single precision, as viewers have them: points are off by about 1e-7 of their
    distance from the origin. A shell far from it hangs on a root node that is moved there in double
    precision. Times follow the drive angle if it rises from state to state,
    otherwise states are evenly spaced. With fewer than two states there is no animation.
    Parts that are joined to the sheet on its way are points before that, of scale 0.
    """
    import orjson

    sheet, *parts = document.moving
    from_deg = _joined_from(sheet, *parts)
    document = document.with_moving(parts)
    scale, nearby = conversion(document.require_unit(), "m"), document.nearby
    state = document.state(settings.state)

    def placed(points: Array) -> Array:
        return np.ascontiguousarray(y_up(points + (document.origin - nearby)) * scale)

    rest = placed(document.panel_corners(state))
    along = longer_diagonals(rest)
    origins, axes = find_frames(rest, along)
    inks = _inks(document)
    buffers = Buffers()
    shown = np.ones(len(rest), dtype=bool)
    if document.boards is not None:
        shown[document.boards.panels[document.boards.sides == 0]] = False
    meshes = _meshes(buffers, (rest - origins[:, None]) @ axes, find_splits(rest), inks, shown)
    panels, ends, meanings = _parts_of_sides(document)
    away = placed(state.positions)[ends] - origins[panels, None]
    materials = [1 + list(inks).index(each) for each in meanings]
    _add_parts(buffers, meshes, panels, away @ axes[panels], materials)
    if document.boards is not None:
        solids, panels = document.boards_in(state), document.boards.panels
        away = placed(solids) - origins[panels, None, None]
        _add_boards(buffers, meshes, document, away @ axes[panels, None])
    content = {
        "asset": {
            "version": "2.0",
            "generator": "orishell",
            "extras": {"title": document.title, "unit": document.unit},
        },
        "scene": 0,
        "scenes": [{"name": document.title, "nodes": [0]}],
        "nodes": _nodes(document, y_up(nearby) * scale, origins, axes, _is_there(from_deg, state)),
        "meshes": meshes,
        "materials": [_material("panel-front"), *map(_material, inks)],
    }
    if len(document.states) > 1:
        content["animations"] = [_animation(buffers, document, placed, along, from_deg)]
    content |= buffers.described()
    text = orjson.dumps(content, option=orjson.OPT_SERIALIZE_NUMPY)
    chunks = _chunk(b"JSON", text, b" ") + _chunk(b"BIN\0", b"".join(buffers.parts), b"\0")
    header = b"glTF" + (2).to_bytes(4, "little") + (12 + len(chunks)).to_bytes(4, "little")
    path.write_bytes(header + chunks)


def _joined_from(*parts: Part) -> Array:
    """The drives (F,) from which on panels of all parts are there (degrees)."""
    drives = [part.joined_from_deg for part in parts]
    return np.repeat(drives, [len(part.mesh.faces) for part in parts])


def _is_there(from_deg: Array, state: DocumentState) -> Booleans:
    """Which panels (F,) are there in a state."""
    drive = np.inf if state.drive_deg is None else state.drive_deg
    return np.asarray(drive >= from_deg)


def _nodes(
    document: Document, place: Array, origins: Array, axes: Array, there: Booleans
) -> list[dict[str, Any]]:
    """The root, and a node for every panel; those that are not ``there`` (F,) are a point."""
    places, turns = singles(origins), singles(quaternions(axes))
    root = {"name": document.title, "children": list(range(1, len(origins) + 1))}
    if place.any():
        root["translation"] = place.tolist()
    return [root] + [
        {
            "name": f"panel {document.panel_name(panel)}",
            "mesh": panel,
            "translation": place,
            "rotation": turn,
            **({} if shown else {"scale": [0.0, 0.0, 0.0]}),
        }
        for panel, (place, turn, shown) in enumerate(zip(places, turns, there, strict=True))
    ]


def _material(meaning: str) -> dict[str, Any]:
    return {
        "name": meaning,
        "doubleSided": True,
        "pbrMetallicRoughness": {
            "baseColorFactor": [*linear_rgb(meaning), 1.0],
            "metallicFactor": 0.0,
            "roughnessFactor": 0.9,
        },
    }


def _inks(document: Document) -> dict[str, Integers]:
    """For every colour by its meaning, the sides (F,) it is drawn on: the sum of 1, 2, 4, 8.

    An edge between two panels is drawn with one of them, and moves with it.
    """
    mesh = document.mesh
    edges = mesh.faces_edges()
    drawn = mesh.edge_faces.max(axis=1)[edges] == np.arange(len(edges))[:, None]
    drawn &= edges >= 0  # hinges on a part of a side are drawn with what they carry
    letters = np.array(document.assignment)
    drawn &= letters[edges] != "J"  # what is joined is one panel
    meanings = np.array([MEANINGS[letter] for letter in letters.tolist()])[edges]
    found = {
        str(each): ((drawn & (meanings == each)) * [1, 2, 4, 8]).sum(axis=1)
        for each in np.unique(meanings)
    }
    parts = set(_parts_of_sides(document)[2])
    return {meaning: sides for meaning, sides in found.items() if sides.any() or meaning in parts}


def _parts_of_sides(document: Document) -> tuple[Integers, Integers, list[str]]:
    """Edges that are a part of a panel's side: the panel (N,), ends (N, 2), colour by its meaning.

    Hinges are not among them, which are drawn with what they carry.
    """
    mesh = document.mesh
    edges = mesh.loops_edges()
    whole = (edges[:, :, None] == mesh.faces_edges()[:, None]).any(axis=-1)
    drawn = mesh.edge_faces.max(axis=1)[edges] == np.arange(len(edges))[:, None]
    panels, places = np.nonzero((edges >= 0) & ~whole & drawn)
    parts = edges[panels, places]
    return panels, mesh.edges[parts], [MEANINGS[document.assignment[each]] for each in parts]


def _add_parts(
    buffers: Buffers,
    meshes: list[dict[str, Any]],
    panels: Integers,
    ends: Array,
    materials: list[int],
) -> None:
    """Give panels lines (N, 2, 3), in their own frames."""
    if not len(panels):
        return
    first = buffers.add_bounded(singles(ends), "VEC3", target=VERTICES, byteStride=12)
    for number, (panel, material) in enumerate(zip(panels.tolist(), materials, strict=True)):
        meshes[panel]["primitives"].append(
            {"attributes": {"POSITION": first + number}, "mode": 1, "material": material}
        )


def _meshes(
    buffers: Buffers, local: Array, splits: Integers, inks: dict[str, Integers], shown: Booleans
) -> list[dict[str, Any]]:
    """One mesh for each panel with corners (F, 4, 3) in its own frame: its area and its lines.

    ``shown`` (F,) says whose area is there.
    """
    corners = buffers.add_bounded(singles(local), "VEC3", target=VERTICES, byteStride=12)
    meshes: list[dict[str, Any]] = [{"primitives": []} for _ in local]
    if shown.any():
        upright = np.tile(np.array([0, 0, 1], dtype=np.float32), (1, 4, 1))
        normals = buffers.add(upright, "VEC3", target=VERTICES, byteStride=12)
        used = np.unique(splits[shown])
        triangles = TRIANGLES[used].reshape(len(used), 6).astype(np.uint16)
        first = buffers.add(triangles, "SCALAR", target=INDICES)
        indices = first + np.searchsorted(used, splits)
        for panel in np.flatnonzero(shown).tolist():
            meshes[panel]["primitives"].append(
                {
                    "attributes": {"POSITION": corners + panel, "NORMAL": normals},
                    "indices": int(indices[panel]),
                    "material": 0,
                }
            )
    sides = np.stack([np.arange(4), (np.arange(4) + 1) % 4], axis=1).astype(np.uint16)
    shared: dict[int, int] = {}
    for material, drawn in enumerate(inks.values(), start=1):
        for panel in np.flatnonzero(drawn).tolist():
            which = int(drawn[panel])
            if which not in shared:
                ends = sides[[side for side in range(4) if which >> side & 1]].reshape(1, -1)
                shared[which] = buffers.add(ends, "SCALAR", target=INDICES)
            meshes[panel]["primitives"].append(
                {
                    "attributes": {"POSITION": corners + panel},
                    "indices": shared[which],
                    "mode": 1,  # lines
                    "material": material,
                }
            )
    return meshes


def _add_boards(
    buffers: Buffers, meshes: list[dict[str, Any]], document: Document, local: Array
) -> None:
    """Give panels their boards, whose corners (B, H, K, 3) are in the panels' own frames."""
    assert document.boards is not None
    panels = document.boards.panels
    found, present = document.boards.triangles()
    places = np.arange(len(panels))[:, None, None]
    triangles = local.reshape(len(panels), -1, 3)[places, found]
    accessors = buffers.add_solids(triangles, present)
    for panel, (corners, normals) in zip(panels.tolist(), accessors.tolist(), strict=True):
        meshes[panel]["primitives"].append(
            {"attributes": {"POSITION": corners, "NORMAL": normals}, "material": 0}
        )


def _animation(
    buffers: Buffers,
    document: Document,
    placed: Callable[[Array], Array],
    along: Integers,
    from_deg: Array,
) -> dict[str, Any]:
    """Keys of all panels at all states; panels (F,) are there from drives on."""
    origins: list[Array] = []
    turns: list[Array] = []
    drives: list[float | None] = []
    there: list[Booleans] = []
    for state in document.states:
        origin, axes = find_frames(placed(document.panel_corners(state)), along)
        turn = quaternions(axes)
        if turns:  # q and -q are one rotation: the one nearer to the key before is meant
            turn = np.where((turn * turns[-1]).sum(axis=1, keepdims=True) < 0, -turn, turn)
        origins.append(origin)
        turns.append(turn)
        drives.append(state.drive_deg)
        there.append(_is_there(from_deg, state))
    times = buffers.add_bounded(_times(drives)[None], "SCALAR")
    paths = {
        "translation": buffers.add(singles(np.stack(origins, axis=1)), "VEC3"),
        "rotation": buffers.add(singles(np.stack(turns, axis=1)), "VEC4"),
    }
    panels = range(len(along))
    scaled = np.flatnonzero(from_deg > 0).tolist()
    sizes = range(0)
    if scaled:
        shown = np.stack(there, axis=1)[scaled, :, None]
        first = buffers.add(singles(np.repeat(shown, 3, axis=-1)), "VEC3")
        sizes = range(first, first + len(scaled))
    first_state = OPEN if OPEN in document.named else FLAT
    packed = "pack" in document.named
    return {
        "name": f"pack to {first_state}" if packed else f"{first_state} to target",
        "samplers": [
            {"input": times, "output": begin + panel, "interpolation": "LINEAR"}
            for begin in paths.values()
            for panel in panels
        ]
        + [{"input": times, "output": size, "interpolation": "STEP"} for size in sizes],
        "channels": [
            {"sampler": number * len(panels) + panel, "target": {"node": panel + 1, "path": name}}
            for number, name in enumerate(paths)
            for panel in panels
        ]
        + [
            {"sampler": number, "target": {"node": panel + 1, "path": "scale"}}
            for number, panel in enumerate(scaled, len(paths) * len(panels))
        ],
    }


def _times(drives: Sequence[float | None]) -> Singles:
    """When (S,) the states are reached (seconds): as their drives rise, or else evenly."""
    values = np.array(drives, dtype=np.float64)
    if np.isfinite(values).all() and np.ptp(values) > 0:
        times: Singles = ((values - values[0]) / np.ptp(values) * SECONDS).astype(np.float32)
        if (np.diff(times) > 0).all():
            return times
    return np.linspace(0.0, SECONDS, len(values)).astype(np.float32)


def _chunk(kind: bytes, data: bytes, padding: bytes) -> bytes:
    data += padding * (-len(data) % 4)
    return len(data).to_bytes(4, "little") + kind + data


FORMAT = Format("glb", "shell.glb", (".glb",), "the motion of rigid panels (glTF)", write_gltf)
