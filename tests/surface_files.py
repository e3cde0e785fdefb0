"""Files of meshes for tests."""

from __future__ import annotations

import numpy as np


def obj(holes: int = 0) -> str:
    """A saddle over a square of 2 m in quadrilaterals, some left out within."""
    at = np.linspace(-1, 1, 9)
    lines = [f"v {x:.6f} {y:.6f} {0.25 * (x * x - y * y):.6f}" for y in at for x in at]
    faces = [[9 * i + j + k + 1 for k in (0, 1, 10, 9)] for i in range(8) for j in range(8)]
    del faces[27 : 27 + holes]
    return "\n".join([*lines, *("f " + " ".join(map(str, face)) for face in faces), ""])
