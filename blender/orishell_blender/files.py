"""What orishell writes, as arrays: a FOLD file with its states, and the boards of a glTF file."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .design import Refusal

METRES = {"mm": 0.001, "cm": 0.01, "m": 1.0, "in": 0.0254, "ft": 0.3048}
"""Units of length in metres, which are Blender's; a file without a unit is taken as metres."""


@dataclass
class Folding:
    """A sheet and its states."""

    title: str
    states: NDArray[Any]  # positions (S, V, 3) of its vertices (metres)
    faces: list[list[int]]  # vertices around its panels
    edges: NDArray[Any]  # ends (E, 2)
    letters: list[str]  # assignments (E,)
    columns: int  # of vertices, where they are a grid's; else 0
    names: dict[str, int]  # named states: pack, target, flat


def read_fold(path: Path) -> Folding:
    """Read a FOLD file: its folded states, or its one state if it has no others.

    Raises Refusal naming the file and what is wrong.
    """
    try:
        content = json.loads(path.read_text(encoding="utf-8-sig"))
        key = content["vertices_coords"]
        frames = [content, *content.get("file_frames", [])]
        folded = [each for each in frames if _is_state(each)] or [{"vertices_coords": key}]
        points = [np.array(each["vertices_coords"], dtype=float) for each in folded]
        states = np.array([np.pad(each, ((0, 0), (0, 3 - each.shape[1]))) for each in points])
        faces, edges = content["faces_vertices"], np.array(content["edges_vertices"])
        states[:, [*{each for face in faces for each in face}, *edges.ravel()]]  # they are there
        letters = content.get("edges_assignment", ["U"] * len(edges))
    except OSError as error:
        raise Refusal(f"{path}: {error.strerror}. Choose another file") from None
    except (ValueError, TypeError, AttributeError, IndexError, KeyError) as error:
        raise Refusal(
            f"{path}: this is no FOLD file of panels that are the same in all frames "
            f"({type(error).__name__}: {error}). orishell check says more of it"
        ) from None
    return Folding(
        title=content.get("file_title") or path.stem,
        states=states * METRES.get(content.get("frame_unit", "m"), 1.0),
        faces=faces,
        edges=edges,
        letters=letters,
        columns=content.get("orishell:grid_shape", [0, 0])[1],
        names={each["frame_title"]: k for k, each in enumerate(folded) if "frame_title" in each},
    )


def _is_state(frame: dict[str, Any]) -> bool:
    """Whether a frame is a folded state of the sheet, with coordinates of its own."""
    return (
        "creasePattern" not in frame.get("frame_classes", [])
        and "nonManifold" not in frame.get("frame_attributes", [])
        and "vertices_coords" in frame
    )


def read_boards(path: Path) -> NDArray[Any]:
    """Corners (S, 3 T, 3) of all triangles of boards, in every state of our glTF file (metres)."""
    data = path.read_bytes()
    length = int.from_bytes(data[12:16], "little")
    content, binary = json.loads(data[20 : 20 + length]), data[28 + length :]

    def array(number: int) -> NDArray[Any]:
        accessor = content["accessors"][number]
        view = content["bufferViews"][accessor["bufferView"]]
        kind = {5126: "<f4", 5125: "<u4", 5123: "<u2"}[accessor["componentType"]]
        width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[accessor["type"]]
        begin = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        found = np.frombuffer(binary, kind, accessor["count"] * width, begin)
        return found.reshape(-1, width)

    (motion,) = content["animations"]
    moved = {
        (channel["target"]["node"], channel["target"]["path"]): array(
            motion["samplers"][channel["sampler"]]["output"]
        ).astype(float)[:, None]
        for channel in motion["channels"]
    }
    root, *panels = content["nodes"]
    made = []
    for number, node in enumerate(panels, start=1):
        axis, w = np.split(moved[number, "rotation"], [3], axis=-1)
        for part in content["meshes"][node["mesh"]]["primitives"]:
            if part.get("mode", 4) == 4:  # triangles
                own = array(part["attributes"]["POSITION"]).astype(float)
                own = own[array(part["indices"])[:, 0]] if "indices" in part else own
                own = own * moved.get((number, "scale"), 1.0)
                twice = 2 * np.cross(axis, own)
                made.append(own + w * twice + np.cross(axis, twice) + moved[number, "translation"])
    y_up = np.concatenate(made, axis=1) + root.get("translation", [0.0, 0.0, 0.0])
    return np.stack([y_up[..., 0], -y_up[..., 2], y_up[..., 1]], axis=-1)
