"""Flaps clipped on at the target: what they would cut into is refused, and boards are apart."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from brute_force import exact_contacts, not_designed
from design_tables import Tables, formula, made, mended, refused, tables
from orishell.conventions.errors import ClashError
from orishell.io import Settings
from orishell.io.formats.obj import write_obj
from orishell.numerics.arrays import Array, Integers
from orishell.shell.make import Shell
from samples import THOROUGH, thorough

NOTHING = 1e-12
"""Common volume of two boards below which they do not overlap (unit cubed)."""
QUICK = (8, 9, 10, 7)
"""Random designs of few panels, one of each family and construction."""
CLIPPED = {"deployment": {"flap_attachment": "clipped"}}
PARABOLA = formula("-x**2", -1, 1)
FIGURE_2 = tables(
    "orthodiagonal", PARABOLA, formula("0.25*sin(pi*x/2)", 0, 4), rows=9, columns=13, depth=0.12
)
BEND = tables(
    "parallel-repeating",
    PARABOLA,
    formula(["2.2*cos(t)", "2.2*sin(t)"], 0, 5.5),
    rows=3,
    columns=10,
    xi_deg=50,
    flap=4.0,
    flap_side="start",
)


def overlaps(shell: Shell, path: Path) -> dict[tuple[str, str], float]:
    """Pairs of boards in the written OBJ that have something in common, and its volume."""
    write_obj(path / "shell.obj", shell.document, Settings(state="target"))
    names, boards = read_solids(path / "shell.obj")
    low, high = (
        np.array([end(points, axis=0) for points, _ in boards]) for end in (np.min, np.max)
    )
    near = ((low[:, None] < high) & (low < high[:, None])).all(axis=-1)
    found = {}
    solids = [manifold(*board) for board in boards]
    for a, b in np.argwhere(np.triu(near, 1)).tolist():
        volume = (solids[a] ^ solids[b]).volume()
        if volume > NOTHING:
            found[names[a], names[b]] = volume
    return found


def read_solids(path: Path) -> tuple[list[str], list[tuple[Array, Integers]]]:
    """Names of the groups of an OBJ file, and vertices and triangles of each."""
    points: list[list[float]] = []
    names: list[str] = []
    triangles: list[list[list[int]]] = []
    for line in path.read_text().splitlines():
        kind, *values = line.split()
        if kind == "v":
            points.append([float(value) for value in values])
        elif kind == "g":
            names.append(values[0])
            triangles.append([])
        elif kind == "f":
            triangles[-1].append([int(value) - 1 for value in values])
    boards = []
    for each in triangles:
        used, own = np.unique(np.array(each), return_inverse=True)
        boards.append((np.array(points)[used], own.reshape(-1, 3)))
    return names, boards


def manifold(points: Array, triangles: Integers) -> Any:
    manifold3d = pytest.importorskip("manifold3d")
    made = manifold3d.Manifold(manifold3d.Mesh64(points, triangles.astype(np.uint64)))
    assert made.status() == manifold3d.Error.NoError
    return made


def random_design(number: int) -> Tables:
    """One of two families, one of two constructions; panels from thin to too thick."""
    draw = np.random.default_rng(number)

    def some(low: float, high: float) -> float:
        return round(float(draw.uniform(low, high)), 3)

    height, bend, turn = some(0.5, 1.5), some(0.1, 0.3), some(1.0, 1.7)
    f = [
        formula(f"-{height}*x**2", -1, 1),
        formula(["cos(t)", f"{height}*sin(t)"], some(0.2, 0.5), some(2.64, 2.94)),
        formula(f"-{height}*x**2 + 0.15*x**3", -1, 0.9),
    ][draw.integers(3)]
    g = [
        formula(f"{bend}*sin({turn}*x)", 0, some(2, 5)),
        formula(["2.5*cos(t)", "2.5*sin(t)"], 0, some(0.6, 5.5)),
        formula(f"{bend}*x**2", -1.5, 2),
    ][draw.integers(3)]
    rows, columns = 2 * int(draw.integers(1, 5)) + 1, int(draw.integers(3, 14))
    size = 2.0 / rows
    pattern = {
        "rows": rows,
        "columns": columns,
        "flap": ["auto", some(0.3, 4) * size][draw.integers(2)],
    }
    family = ["orthodiagonal", "parallel-repeating"][number % 2]
    if family == "orthodiagonal":
        pattern["depth"] = ["auto", some(0.4, 0.7) * size][draw.integers(2)]
    else:
        pattern["flap_side"] = ["start", "end"][draw.integers(2)]
    panel: Tables = {"thickness": round(size * some(0.03, 0.12), 4)}
    if number // 2 % 2:
        panel |= {"construction": "bevel", "gap": round(panel["thickness"] * some(0.02, 0.1), 5)}
    else:
        panel |= {"membrane": round(panel["thickness"] * some(0.02, 0.2), 5)}
    return {**tables(family, f, g, **pattern), **CLIPPED, "panel": panel}


@pytest.mark.parametrize("number", range(200) if THOROUGH else QUICK)
def test_boards_are_apart_or_refused_with_an_offer_that_works(number: int, tmp_path: Path) -> None:
    design = random_design(number)
    error = refused(design)
    if error is not None:
        assert error.remedies or error.limit
        for remedy in error.remedies:
            assert not overlaps(made(mended(design, remedy)), tmp_path), str(remedy)
        return
    assert not overlaps(made(design), tmp_path)


@thorough
def test_corners_are_cut_where_boards_of_flaps_would_meet_others(
    tmp_path: Path,
) -> None:
    # Figure 2 in solid panels of 0.02: at 9 vertices beside its flaps boards overlapped, by up to
    # 2 mm of 20.
    panel = {"construction": "bevel", "thickness": 0.02, "gap": 0.001}
    shell = made({**FIGURE_2, **CLIPPED, "panel": panel})
    assert not overlaps(shell, tmp_path)
    assert shell.lock.built is not None
    assert shell.lock.clipped_contact is None
    beside = (shell.lock.built.reliefs[1:-1, [0, -1]] > 0).sum()
    assert beside == 9


def test_flaps_that_cut_through_the_shell_are_refused() -> None:
    error = refused({**BEND, **CLIPPED})
    assert isinstance(error, ClashError)
    assert "when flaps are clipped on (opposite flaps), at the target" in str(error)
    assert error.remedies
    for remedy in error.remedies:
        shell = made(mended({**BEND, **CLIPPED}, remedy))
        assert shell.report.feasible
        flapped = shell.design.clipped
        assert flapped is not None
        positions = flapped.positions(flapped.target_drive)
        pairs = exact_contacts(positions, flapped.grid.faces_vertices())
        assert not not_designed(flapped.grid)(pairs).any()
