"""How near fitted sheets come to surfaces, and how long fits take: a table for documentation.

Run ``python benchmarks/flat_foldable_fits.py 16`` for 16 x 16 panels; with ``--meshes`` sheets are
fitted to meshes of 20,000 triangles of the same surfaces.
"""

from __future__ import annotations

import runpy
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np

from orishell.design import MeshSurface, PiecedSurface
from orishell.design_file.surface import SurfaceTable
from orishell.families.flat_foldable.fit.conditions import Conditions
from orishell.families.flat_foldable.fit.initial_guesses import Task, fit_sheet

EXAMPLES = Path(__file__).parents[1] / "examples"
SURFACES: dict[str, dict[str, Any]] = runpy.run_path(str(EXAMPLES / "surfaces.py"))["SURFACES"]
CELLS = 100
"""Along each side of a mesh: twice the square of it are its triangles."""


def surface_of(table: dict[str, Any], *, as_mesh: bool) -> PiecedSurface:
    """The surface of a table [target.surface], or a mesh of it."""
    surface = SurfaceTable.model_validate(table).surface(None, "m")
    if not as_mesh:
        return surface
    (_, first, second) = table.values()
    right, up = (np.linspace(each[0], each[1], CELLS + 1) for each in (first, second))
    points = surface.points(up[:, None], right[None, :])
    number = np.arange((CELLS + 1) ** 2).reshape(CELLS + 1, CELLS + 1)
    a, b, c, d = number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]
    triangles = np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)
    return MeshSurface.of(points.reshape(-1, 3), triangles)


def main() -> None:
    """Print the table."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 16
    as_mesh = "--meshes" in sys.argv
    chosen = [each for each in sys.argv[2:] if each in SURFACES] or list(SURFACES)
    print("| surface | time | vertices rms, max | shell, back | half depth | edges | turned |")
    print("|---|---|---|---|---|---|---|")
    for name in chosen:
        piece = surface_of(SURFACES[name], as_mesh=as_mesh).piece
        start = time.process_time()
        fit = fit_sheet(Task(piece, count - 1, count - 1, Conditions(10.0)))
        seconds = time.process_time() - start
        if fit is None:
            print(f"| {name} | {seconds:.1f} s | none |")
            continue
        found = fit.reached
        flat = fit.fitted.placed.flat
        edges = np.concatenate(
            [np.linalg.norm(np.diff(flat, axis=axis), axis=0).ravel() for axis in (1, 2)]
        )
        shares = [100 * each for each in (found.rms, found.vertices, found.shell, found.back)]
        rms, most, shell, back = shares
        print(
            f"| {name} | {seconds:.1f} s | {rms:.2f}, {most:.2f} | {shell:.2f}, {back:.2f} | "
            f"{100 * found.offset:.2f} | {edges.max() / edges.min():.1f} | "
            f"{fit.start.direction} |",
            flush=True,
        )


if __name__ == "__main__":
    main()
