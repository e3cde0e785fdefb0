"""The section that shows the surfaces beside the one asked for."""

from __future__ import annotations

import numpy as np

from orishell.design.piece import Piece
from orishell.plot import find_offset_section


def test_the_lines_of_a_sphere_are_circles() -> None:
    """Over a sphere of radius 1, exact to third order in its triangles (see design/piece)."""
    x, y = np.meshgrid(np.linspace(-0.4, 0.4, 41), np.linspace(0.4, -0.4, 41))
    points = np.stack([x, y, np.sqrt(1 - x**2 - y**2)], axis=-1)
    angle = np.linspace(-0.35, 0.35, 9)
    radius = 1 + 0.05 * (-1) ** np.arange(9)
    column = np.stack([0 * angle, radius * np.sin(angle), radius * np.cos(angle)], axis=-1)
    found = find_offset_section(column, Piece.of_lattice(points, points), -0.05)
    # The centre is straight below the middle of the chord, by the cosine of half the angle.
    centre = np.array([np.sin(0.35), -np.cos(0.35)])
    for line, expected in ((found.surface, 1), (found.above, 1.05), (found.below, 0.95)):
        away = np.linalg.norm(line - centre, axis=-1)
        assert np.abs(away - expected).max() < 1e-3
    assert np.abs(np.linalg.norm(found.shell - centre, axis=-1) - radius).max() < 1e-3
    assert found.offset == 0.05
