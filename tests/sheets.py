"""FOLD files as other programs might write them: a Miura sheet, strips, and shuffled copies."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from orishell.io import read_fold
from orishell.verification import Inspection, inspect_fold

Fold = dict[str, Any]

A, B, GAMMA = 1.2, 1.0, np.deg2rad(65)
"""Edge lengths and sector angle of the Miura sheet."""


def miura_positions(theta: float, rows: int = 5, columns: int = 6) -> np.ndarray:
    """Vertices (rows * columns, 3) of a Miura sheet whose panels are inclined by theta.

    The textbook's formulas of the unit cell (Schenk and Guest, PNAS 110 (2013) 3276, eq. 1-4).
    """
    run = np.cos(theta) * np.tan(GAMMA)
    height = A * np.sin(theta) * np.sin(GAMMA)
    width = B * run / np.sqrt(1 + run**2)
    length = A * np.sqrt(1 - (np.sin(theta) * np.sin(GAMMA)) ** 2)
    shift = B / np.sqrt(1 + run**2)
    i, j = np.indices((rows, columns))
    x, y, z = j * width, -i * length + (j % 2) * shift, (i % 2) * height
    return np.stack([x, y, z], axis=-1).reshape(-1, 3)


def miura(thetas: list[float], rows: int = 5, columns: int = 6) -> Fold:
    """A Miura sheet in the key frame, flat, and complete frames without inheritance.

    Row creases fold by 2 theta, alternately valleys and mountains from row to row; column
    creases by 2 atan(cos(gamma) tan(theta)) (the relation of flat-foldable vertices), alternately
    along each column and from column to column.
    """
    number = np.arange(rows * columns).reshape(rows, columns)
    faces = np.stack([number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]], axis=-1)
    edges, senses, is_row = [], [], []
    for i in range(rows):
        for j in range(columns):
            if j + 1 < columns:
                edges.append([i * columns + j, i * columns + j + 1])
                senses.append(0 if i in {0, rows - 1} else (-1 if i % 2 else 1))
                is_row.append(True)
            if i + 1 < rows:
                edges.append([i * columns + j, (i + 1) * columns + j])
                senses.append(0 if j in {0, columns - 1} else (-1 if (i + j) % 2 else 1))
                is_row.append(False)
    mesh = {
        "edges_vertices": edges,
        "edges_assignment": [{0: "B", 1: "V", -1: "M"}[sense] for sense in senses],
        "faces_vertices": faces.reshape(-1, 4).tolist(),
    }
    frames = []
    for theta in thetas:
        column = 2 * np.arctan(np.cos(GAMMA) * np.tan(theta))
        size = np.rad2deg(np.where(is_row, 2 * theta, column))
        angles = (np.array(senses) * size).tolist()
        coords = miura_positions(theta, rows, columns).tolist()
        frames.append({**mesh, "vertices_coords": coords, "edges_foldAngle": angles})
    flat = miura_positions(0.0, rows, columns)[:, :2].tolist()
    return {**mesh, "file_spec": 1.1, "vertices_coords": flat, "file_frames": frames}


def strip(*profiles: list[list[float]]) -> Fold:
    """Panels side by side, in frames given by their profiles (K, 2) in the x-z plane."""
    count = len(profiles[0])
    faces = [[k, count + k, count + k + 1, k + 1] for k in range(count - 1)]
    frames: list[Fold] = [
        {"vertices_coords": [[x, y, z] for y in (1, 0) for x, z in profile]} for profile in profiles
    ]
    for frame in frames[1:]:
        frame |= {"frame_parent": 0, "frame_inherit": True}
    return {**frames[0], "faces_vertices": faces, "file_frames": frames[1:]}


def shuffled(fold: Fold, seed: int) -> Fold:
    """The same sheet with vertices, edges and faces in another order, faces either way round."""
    rng = np.random.default_rng(seed)
    vertices = rng.permutation(len(fold["vertices_coords"]))
    edges = rng.permutation(len(fold["edges_vertices"]))
    faces = rng.permutation(len(fold["faces_vertices"]))
    rank = np.argsort(vertices)
    turns = rng.integers(0, 4, len(faces))
    ways = np.where(rng.random(len(faces)) < 0.3, -1, 1)

    def mixed(frame: Fold) -> Fold:
        frame = dict(frame)
        for key, order in (
            ("vertices_coords", vertices),
            ("edges_vertices", edges),
            ("edges_assignment", edges),
            ("edges_foldAngle", edges),
            ("faces_vertices", faces),
        ):
            if key in frame:
                frame[key] = [frame[key][k] for k in order]
        for key in ("edges_vertices", "faces_vertices"):
            if key in frame:
                frame[key] = [rank[entry].tolist() for entry in frame[key]]
        if "faces_vertices" in frame:
            frame["faces_vertices"] = [
                (face[turn:] + face[:turn])[::way]
                for face, turn, way in zip(frame["faces_vertices"], turns, ways, strict=True)
            ]
        frame.pop("faces_edges", None)
        return frame

    result = mixed(fold)
    result["file_frames"] = [mixed(frame) for frame in fold["file_frames"]]
    return result


def write(fold: Fold, directory: Path) -> Path:
    path = directory / "sheet.fold"
    path.write_text(json.dumps(fold))
    return path


def inspect(fold: Fold, directory: Path, **options: Any) -> Inspection:
    return inspect_fold(read_fold(write(fold, directory)), **options)


def failed(inspection: Inspection) -> set[str]:
    """Names of the tests that failed."""
    return {check.name for check in inspection.checks if not check.passed}


def facts(inspection: Inspection, name: str) -> dict[str, Any]:
    """What one test found."""
    return next(check.as_dict() for check in inspection.checks if check.name == name)
