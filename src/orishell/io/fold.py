"""FOLD 1.2: the flat crease pattern as key frame, the motion as further frames."""

from __future__ import annotations

from collections.abc import Iterable
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from orishell.motion import FoldedState, FoldingMotion, find_assignment
from orishell.pattern import CreaseValues, edges_assignment
from orishell.quoting import tidy_degrees

Array = NDArray[np.float64]


def write_fold(path: Path, motion: FoldingMotion, unit: str, states: Iterable[FoldedState]) -> None:
    """Write ``shell.fold`` (the contract's page says what is in it).

    Parameters
    ----------
    path
        The file.
    motion
        The motion whose flat sheet is the key frame.
    unit
        Unit of length of the coordinates.
    states
        The motion's states, from flat to locked; taken one by one, so that a progress bar can
        watch them and only one need be in memory.
    """
    import orjson

    def dump(value: Any) -> bytes:
        return orjson.dumps(value, option=orjson.OPT_SERIALIZE_NUMPY)

    with path.open("wb") as file:
        key = dump(_key_frame(motion, unit))
        file.write(key[:-1] + b',\n"file_frames":[\n')
        for number, state in enumerate(states):
            file.write(b",\n" if number else b"")
            file.write(dump(_folded_frame(state)))
        file.write(b"\n]}\n")


def _key_frame(motion: FoldingMotion, unit: str) -> dict[str, Any]:
    grid = motion.mechanism.grid
    return {
        "file_spec": 1.2,
        "file_creator": f"orishell {version('orishell')}",
        "file_classes": ["singleModel", "animation"],
        "frame_classes": ["creasePattern"],
        "frame_attributes": ["2D"],
        "frame_unit": unit,
        "vertices_coords": _clean(motion.flat.positions[..., :2].reshape(-1, 2)),
        "edges_vertices": grid.edges_vertices(),
        "edges_assignment": edges_assignment(find_assignment(motion.mechanism)),
        "edges_foldAngle": _degrees(motion.locked.fold_angles),
        "faces_vertices": grid.faces_vertices(),
        "faces_edges": grid.faces_edges(),
        "orishell:grid_shape": [grid.rows, grid.columns],
    }


def _folded_frame(state: FoldedState) -> dict[str, Any]:
    return {
        "frame_classes": ["foldedForm"],
        "frame_attributes": ["3D"],
        "frame_parent": 0,
        "frame_inherit": True,
        "vertices_coords": _clean(state.positions.reshape(-1, 3)),
        "edges_foldAngle": _degrees(state.fold_angles),
        "orishell:drive_deg": tidy_degrees(state.drive),
    }


def _degrees(angles: CreaseValues) -> Array:
    return _clean(np.rad2deg(angles.on_edges()))


def _clean(array: Array) -> Array:
    """Contiguous, and without negative zeros."""
    return np.ascontiguousarray(array + 0.0)
