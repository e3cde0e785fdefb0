"""Lines of drawings as paths of a PDF."""

from __future__ import annotations

from typing import TYPE_CHECKING

from orishell.numerics.arrays import Array

if TYPE_CHECKING:
    from reportlab.pdfgen.pathobject import PDFPathObject


def add_line(path: PDFPathObject, points: Array, *, closed: bool) -> None:
    """Add a polyline (k, 2) to a path (points)."""
    first, *others = points.tolist()
    path.moveTo(*first)
    for point in others:
        path.lineTo(*point)
    if closed:
        path.close()
