"""Polylines and meshes as Rhino has them."""

from __future__ import annotations

from typing import Any, Final

from orishell.numerics.arrays import Array, Integers

UNIT_SYSTEMS: Final = {
    "mm": "Millimeters",
    "cm": "Centimeters",
    "m": "Meters",
    "in": "Inches",
    "ft": "Feet",
}
"""What Rhino calls units of length."""


def rhino3dm() -> Any:
    """The module without its type stubs, which say that nothing can be set or added."""
    import rhino3dm as module

    return module


def polyline_curve(points: Array) -> Any:
    """A polyline through points (N, 3).

    Parameters
    ----------
    points
        Its corners; a closed one ends where it begins.
    """
    rhino = rhino3dm()
    corners = [rhino.Point3d(*point) for point in points.tolist()]
    return rhino.Polyline(corners).ToPolylineCurve()


def mesh_of_faces(positions: Array, faces: Integers) -> Any:
    """A mesh in double precision, with normals.

    Parameters
    ----------
    positions
        Vertices (V, 3).
    faces
        Corners (F, 3) or (F, 4) of its faces.
    """
    mesh = rhino3dm().Mesh()
    mesh.Vertices.UseDoublePrecisionVertices = True
    add_vertex, add_face = mesh.Vertices.AddPoint3d, mesh.Faces.AddFace
    for point in positions.tolist():
        add_vertex(*point)
    for face in faces.tolist():
        add_face(*face)
    mesh.Normals.ComputeNormals()
    return mesh
