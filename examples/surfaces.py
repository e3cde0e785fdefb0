"""Every surface by every family: how near they come, what they take, whether they pack flat.

Run it with ``python examples/surfaces.py 15 surfaces.png`` for sheets of 15 x 15 inner vertices:
it prints a table in Markdown and draws the nearest shell of each surface.
"""

from __future__ import annotations

import math
import sys
import time
from pathlib import Path
from typing import Any

from orishell import Shell
from orishell.conventions.errors import OrishellError
from orishell.design_file import check_design
from orishell.families.registry import FAMILIES
from orishell.shell.families import in_family, packs_flat
from orishell.shell.make import make_shell
from orishell.shell.steps import Step

WITHOUT: tuple[Step, ...] = ("remedies",)
ONE, SMALL = [-1.0, 1.0], [-0.5, 0.5]
ARC = [-math.radians(40), math.radians(40)]
SURFACES: dict[str, dict[str, Any]] = {
    "cap": {"formula": "sqrt(1 - x**2 - y**2)", "x": SMALL, "y": SMALL},
    "ellipsoid": {
        "formula": "0.8*sqrt(1 - x**2/2.25 - y**2)",
        "x": [-0.825, 0.825],
        "y": [-0.55, 0.55],
    },
    "saddle .5": {"formula": "0.25*(x**2 - y**2)", "x": ONE, "y": ONE},
    "hypar .5": {"formula": "0.5*x*y", "x": ONE, "y": ONE},
    "saddle 1": {"formula": "0.5*(x**2 - y**2)", "x": ONE, "y": ONE},
    "monkey": {"formula": "0.2*(x**3 - 3*x*y**2)", "x": ONE, "y": ONE},
    "free-form": {"formula": "0.25*sin(pi*x)*cos(pi*y/2)", "x": ONE, "y": ONE},
    "barrel": {"formula": "sqrt(1.5625 - y**2)", "x": ONE, "y": ONE},
    "half cylinder": {
        "formula": ["u", "-cos(v)", "sin(v)"],
        "u": [0.0, 3.0],
        "v": [0.0, math.pi],
    },
    "torus": {
        "formula": ["(2 + cos(v))*sin(u)", "sin(v)", "(2 + cos(v))*cos(u)"],
        "u": ARC,
        "v": ARC,
    },
}
"""Those on which the program is measured; lengths in any unit."""


def trial(surface: str, family: str, size: int) -> tuple[Shell | None, str, float]:
    """The shell of a family on a surface, or why there is none, and the time it took."""
    tables = {
        "shell": {"family": "flat-foldable", "unit": "m"},
        "target": {"surface": SURFACES[surface]},
        "pattern": {"rows": size, "columns": size},
        "motion": {"frames": 9},
    }
    start = time.process_time()
    try:
        file = in_family(check_design(tables, Path("surface.toml")), family)
        shell = make_shell(file, skip=WITHOUT)
    except OrishellError as error:
        why_not = str(error).removeprefix("surface.toml: ").splitlines()[0]
        return None, why_not, time.process_time() - start
    return shell, "", time.process_time() - start


def line(surface: str, family: str, found: tuple[Shell | None, str, float]) -> str:
    """The line of the table."""
    shell, why_not, seconds = found
    if shell is None or shell.deviation is None or shell.design.swept is None:
        return f"| {surface} | {family} | none: {why_not} | | | | {seconds:.0f} s |"
    diagonal = math.dist(*_box(shell))
    return (
        f"| {surface} | {family} | {100 * shell.deviation.max / diagonal:.2f} % "
        f"| {shell.design.mechanism.grid.panel_count} "
        f"| {shell.report.sheet.area / shell.design.swept.area():.2f} "
        f"| {'yes' if packs_flat(shell.design.mechanism, shell.lock.closes_to) else 'no'} "
        f"| {seconds:.0f} s |"
    )


def _box(shell: Shell) -> tuple[list[float], list[float]]:
    """Opposite corners of the box of the surface."""
    assert shell.design.swept is not None
    points = shell.design.swept.lattice(shell.design.swept.size() / 60).points.reshape(-1, 3)
    return points.min(axis=0).tolist(), points.max(axis=0).tolist()


def main() -> None:
    """Print the table, draw the shells."""
    size = int(sys.argv[1]) if len(sys.argv) > 1 else 15
    print("| surface | family | distance by diagonal | panels | sheet by surface | packs | time |")
    print("|---|---|---|---|---|---|---|")
    nearest: dict[str, Shell] = {}
    for surface in SURFACES:
        for family in FAMILIES:
            found = trial(surface, family, size)
            print(line(surface, family, found), flush=True)
            shell, best = found[0], nearest.get(surface)
            if shell is not None and (best is None or _far(shell) < _far(best)):
                nearest[surface] = shell
    if len(sys.argv) > 2:
        draw(Path(sys.argv[2]), nearest)


def _far(shell: Shell) -> float:
    assert shell.deviation is not None
    return shell.deviation.max


def draw(path: Path, shells: dict[str, Shell]) -> None:
    """A picture of them all."""
    import matplotlib.pyplot as plt
    import numpy as np
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection  # type: ignore[import-untyped]

    figure = plt.figure(figsize=(12, 6), layout="constrained")
    for number, (name, shell) in enumerate(shells.items()):
        axes: Any = figure.add_subplot(2, -(-len(shells) // 2), number + 1, projection="3d")
        points = shell.motion.target.positions.reshape(-1, 3)
        corners = points[shell.design.mechanism.grid.faces_vertices()]
        axes.add_collection3d(
            Poly3DCollection(
                corners, facecolors="#e8e4d8", edgecolors="#333", linewidths=0.3, shade=True
            )
        )
        low, high = points.min(axis=0), points.max(axis=0)
        axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
        axes.set_box_aspect(np.maximum(high - low, 1e-3), zoom=1.1)
        axes.view_init(32, -60)
        axes.set_axis_off()
        axes.set_title(f"{name}: {shell.file.family}", fontsize=9)
    figure.savefig(path, dpi=150)
    plt.close(figure)


if __name__ == "__main__":
    main()
