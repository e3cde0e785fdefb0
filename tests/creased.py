"""Crease patterns by their panels, and those of mechanisms whose motion is known."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from orishell.motion import Mechanism
from orishell.motion.crease_pattern import CreasePattern
from orishell.motion.layout import edge_signs, mesh_of, points_of


def creased(
    vertices: Sequence[Sequence[float]] | np.ndarray,
    faces: Sequence[Sequence[int]],
    letter: Callable[[int, int], str] = lambda first, second: "U",
) -> CreasePattern:
    """A pattern of panels, counter-clockwise; creases have the letter of their ends."""
    edges: dict[tuple[int, int], list[int]] = {}
    for number, face in enumerate(faces):
        for first, second in zip(face, [*face[1:], face[0]], strict=True):
            if (second, first) in edges:
                edges[second, first][1] = number
            else:
                edges[first, second] = [number, -1]
    longest = max(map(len, faces))
    return CreasePattern(
        vertices=np.asarray(vertices, dtype=np.float64),
        edges=np.array(list(edges)),
        letters=np.array([letter(*e) if min(beside) >= 0 else "B" for e, beside in edges.items()]),
        faces=np.array([[*face, *[-1] * (longest - len(face))] for face in faces]),
        edge_faces=np.array(list(edges.values())),
    )


def star(degrees: Sequence[float], letters: str = "U") -> CreasePattern:
    """One vertex with creases of length 1 in these directions, letters repeated round it."""
    angles = np.deg2rad(degrees)
    count = len(angles)
    tips = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    faces = [[0, 1 + k, 1 + (k + 1) % count] for k in range(count)]
    return creased(
        np.vstack([[0.0, 0.0], tips]), faces, lambda a, b: letters[(max(a, b) - 1) % len(letters)]
    )


def yoshimura(rows: int, columns: int) -> CreasePattern:
    """Triangles of side 1: level creases are valleys, others mountains."""
    points = [
        (j + 0.5 * (i % 2), -i * np.sqrt(3) / 2)
        for i in range(rows + 1)
        for j in range(columns + 1)
    ]
    faces = []
    for i in range(rows):
        for j in range(columns):
            a, b = i * (columns + 1) + j, (i + 1) * (columns + 1) + j
            odd = i % 2
            faces += [[a, b, b + 1] if odd else [a, b, a + 1]]
            faces += [[a, b + 1, a + 1] if odd else [a + 1, b, b + 1]]
    return creased(points, faces, lambda a, b: "V" if points[a][1] == points[b][1] else "M")


def of_mechanism(mechanism: Mechanism) -> CreasePattern:
    """The flat sheet of a mechanism, with its edges in their order."""
    mesh = mesh_of(mechanism)
    signs = edge_signs(mechanism)
    return CreasePattern(
        vertices=points_of(mechanism, 0.0)[:, :2],
        edges=mesh.edges,
        letters=np.where(mesh.crease, np.array(["M", "F", "V"])[signs + 1], "B"),
        faces=mesh.loops,
        edge_faces=mesh.edge_faces,
    )
