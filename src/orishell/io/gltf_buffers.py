"""The binary part of a glTF file: arrays of numbers, and the tables that say where they lie."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from orishell.numerics.arrays import Array, Booleans, Integers

Singles = NDArray[np.float32]

VERTICES: Final = 34962
INDICES: Final = 34963
"""What a view is for: attributes of vertices, or numbers of vertices."""
NEGLIGIBLE_SHARE: Final = 1e-12
"""Numbers below this share of the largest are written as 0: they are rounding, which processors do
in several ways, and far below what single precision has beside the largest."""
_FLOAT, _SHORT = 5126, 5123


def singles(values: Array) -> Singles:
    """Numbers of one kind (any shape) in single precision.

    What is less than 1e-12 of the largest is 0: it is there because of rounding, which no two
    processors do alike.
    """
    none = np.abs(values) <= NEGLIGIBLE_SHARE * np.abs(values).max(initial=0.0)
    return np.where(none, 0.0, values).astype(np.float32)


@dataclass(slots=True)
class Buffers:
    """The binary part of the file and the tables that say what lies where in it."""

    parts: list[bytes] = field(default_factory=list)
    views: list[dict[str, Any]] = field(default_factory=list)
    accessors: list[dict[str, Any]] = field(default_factory=list)

    def add(self, array: NDArray[Any], kind: str, **view: int) -> int:
        """Store arrays (K, count) or (K, count, width), one accessor each, in one view.

        Returns the number of the first accessor.
        """
        data = array.tobytes()
        begin = sum(len(part) for part in self.parts)
        self.parts.append(data + bytes(-len(data) % 4))
        component = _FLOAT if array.dtype == np.float32 else _SHORT
        first, size = len(self.accessors), len(data) // len(array)
        self.accessors += [
            {
                "bufferView": len(self.views),
                "byteOffset": number * size,
                "componentType": component,
                "count": array.shape[1],
                "type": kind,
            }
            for number in range(len(array))
        ]
        self.views.append({"buffer": 0, "byteOffset": begin, "byteLength": len(data), **view})
        return first

    def add_bounded(self, array: Singles, kind: str, **view: int) -> int:
        """As :meth:`add`, with the smallest and largest value, as positions and times must."""
        first = self.add(array, kind, **view)
        for accessor, low, high in zip(
            self.accessors[first:], array.min(axis=1), array.max(axis=1), strict=True
        ):
            accessor["min"], accessor["max"] = np.atleast_1d(low), np.atleast_1d(high)
        return first

    def described(self) -> dict[str, Any]:
        """The tables, as the JSON part has them."""
        size = sum(len(part) for part in self.parts)
        return {
            "accessors": self.accessors,
            "bufferViews": self.views,
            "buffers": [{"byteLength": size}],
        }

    def add_solids(self, triangles: Array, present: Booleans) -> Integers:
        """Store solids with flat faces; return the accessors (K, 2) of corners and normals.

        triangles: Corners (K, T, 3, 3) of their triangles.
        present: Which triangles (K, T) are there.
        """
        counts = present.sum(axis=1)
        accessors = np.empty((len(triangles), 2), np.int64)
        for count in np.unique(counts).tolist():
            alike = counts == count
            corners = triangles[alike][present[alike]].reshape(-1, count, 3, 3)
            normals = np.cross(
                corners[:, :, 1] - corners[:, :, 0], corners[:, :, 2] - corners[:, :, 0]
            )
            normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
            shape = (-1, 3 * count, 3)
            first = self.add_bounded(
                singles(corners.reshape(shape)), "VEC3", target=VERTICES, byteStride=12
            )
            upright = singles(np.repeat(normals, 3, axis=1))
            other = self.add(upright, "VEC3", target=VERTICES, byteStride=12)
            accessors[alike] = np.arange(alike.sum())[:, None] + [first, other]
        return accessors
