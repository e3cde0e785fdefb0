"""Random shells with gussets, and what their panels and gussets have in common by manifold3d."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from design_tables import Tables, formula, tables
from orishell.conventions.errors import DesignError, InputError
from orishell.design import Design
from orishell.design.stiffeners import Stiffeners
from orishell.design_file import check_design
from orishell.document import Document
from orishell.motion import Mechanism
from orishell.motion.boards import Boards
from orishell.numerics.arrays import Array, Integers
from orishell.shell.designed import designed
from orishell.shell.make import Shell, make_shell
from orishell.shell.steps import MEASURES
from orishell.solids.gussets import Gussets
from overlaps import solids

FAMILIES = (
    "orthodiagonal", "parallel-repeating", "flat-foldable", "longitudinal-linear-repeating",
)  # fmt: skip
BUILDS = ("none", "bevel", "sandwich")
THIN, SHRUNK = 1e-8, 1e-3
"""Panels without a thickness are solids so thin, by their size, and so much smaller."""


def random_design(number: int, attempt: int) -> Tables:
    """One of four families and three builds, with gussets; panels from thin to too thick.

    In every second dozen gussets beside boards are a board of their own, thinner or thicker.
    """
    draw = np.random.default_rng([number, attempt])

    def some(low: float, high: float) -> float:
        return round(float(draw.uniform(low, high)), 3)

    family, build = FAMILIES[number % 4], BUILDS[number // 4 % 3]
    design, size = _sheet(draw, family, some)
    design["stiffeners"] = {
        "kind": "gussets",
        "rows": str(draw.choice(["valleys", "crests", "all"])),
        "columns": ["all", 2][draw.integers(2)],
        "share": some(0.3, 0.99),
    }
    most = 0.005 if family == "longitudinal-linear-repeating" else 0.2
    thickness = round(size * some(0.1 * most, most), 5)
    if build != "none":
        key = {"bevel": "gap", "sandwich": "membrane"}[build]
        design["panel"] = {
            **{"construction": build, "thickness": thickness},
            key: round(thickness * some(0.02, 0.2), 5),
        }
    if family != "longitudinal-linear-repeating" and design["pattern"].get("flap") != 0:
        design["deployment"] = {"flap_attachment": str(draw.choice(["folded", "clipped"]))}
    if build != "none" and number % 24 >= 12:
        design["stiffeners"]["thickness"] = round(thickness * some(0.1, 2.5), 5)
        if draw.integers(2):
            design["stiffeners"]["material"] = "steel"
    return design


def _sheet(draw: np.random.Generator, family: str, some: Any) -> tuple[Tables, float]:
    """The tables of a sheet, and about how long the edges of its columns are."""
    rows, columns = 2 * int(draw.integers(1, 4)) + 1, int(draw.integers(3, 9))
    if family == "flat-foldable":
        sheet = ["miura", "arch", "fan"][draw.integers(3)]
        pattern: Tables = {"rows": rows, "columns": columns, "sheet": sheet}
        pattern |= {"fold_deg": some(40, 150), "sector_deg": some(50, 80)}
        if sheet != "miura":
            pattern["turn_deg"] = some(30, 160)
        if sheet == "arch" and draw.integers(2):
            pattern["growth"] = some(0.8, 1.25)
        shell = {"family": family, "unit": "m"}
        return {"shell": shell, "pattern": pattern, "motion": {"frames": 2}}, 1.0
    height, bend, turn = some(0.5, 1.5), some(0.1, 0.3), some(1.0, 1.7)
    f = [
        formula(f"-{height}*x**2", -1, 1),
        formula(["cos(t)", f"{height}*sin(t)"], some(0.2, 0.5), some(2.64, 2.94)),
        formula(f"-{height}*x**2 + 0.15*x**3", -1, 0.9),
    ][draw.integers(3)]
    g = [
        formula(f"{bend}*sin({turn}*x)", 0, some(2, 5)),
        formula(["2.5*cos(t)", "2.5*sin(t)"], 0, some(0.6, 3.5)),
        formula(f"{bend}*x**2", -1.5, 2),
    ][draw.integers(3)]
    size = 2.0 / rows
    pattern = {"rows": rows, "columns": columns, "flap": ["auto", 0, 0][draw.integers(3)]}
    if family == "orthodiagonal":
        pattern["depth"] = ["auto", some(0.4, 0.7) * size][draw.integers(2)]
    elif family == "parallel-repeating":
        pattern["flap_side"] = str(draw.choice(["start", "end"]))
        if draw.integers(2):
            pattern["xi_deg"] = some(40, 100)
    else:
        f, g = formula(["cos(t)", "sin(t)"], 0.3, 2.8416), formula("0*x", 0, some(1.5, 4))
        sector = [some(80, 90), some(75, 88)]
        pattern = {"rows": rows, "columns": min(columns, 5), "solution": int(draw.integers(2))}
        pattern["sector_deg"] = [*sector, *(180 - each for each in sector)]
    return tables(family, f, g, **pattern), size


@dataclass(frozen=True)
class Drawn:
    """A random design with gussets, and what became of it."""

    tables: Tables
    shell: Shell  # without gussets, where they are refused
    refused: DesignError | None  # why there is no room for them


def drawn(number: int) -> Drawn:
    """The first of a number whose shell can be made, with gussets or without."""
    every = (_drawn(random_design(number, attempt)) for attempt in itertools.count())
    return next(each for each in every if each is not None)


def shell_of(design: Tables) -> Shell:
    """The shell of a design: nothing is measured, nor offered."""
    skip = (*MEASURES, "verification", "remedies")
    return make_shell(check_design(design, Path("shell.toml")), skip=skip)


def sheet_of(number: int) -> Mechanism:
    """The sheet of the first random design of a number that a family can make."""
    for attempt in itertools.count():
        design = random_design(number, attempt)
        del design["stiffeners"]
        design.pop("panel", None)
        if design["pattern"].get("flap") == "auto":
            design["pattern"]["flap"] = 0
        try:
            return designed(check_design(design, Path("shell.toml"))).mechanism
        except (InputError, DesignError):
            continue
    raise AssertionError


def _drawn(design: Tables) -> Drawn | None:
    try:
        return Drawn(design, shell_of(design), None)
    except InputError:
        return None
    except DesignError as error:
        if not any(key.startswith("stiffeners.") for key in error.keys):
            return None
        return Drawn(design, without(design), error)


def without(design: Tables) -> Shell:
    """The shell of a design, its gussets left out."""
    return shell_of({key: value for key, value in design.items() if key != "stiffeners"})


def gussets_of(tables: Tables, design: Design, at: Integers, share: float) -> Gussets:
    """Gussets at vertices (G, 2), made as the table says; nobody proved that they fit."""
    asked = Stiffeners.model_validate(tables["stiffeners"])
    build = None if design.panel is None else asked.made_of(design.panel, 0.0)
    return Gussets.of(design, at, share, build)


def bodies(document: Document, which: int | str = "target") -> tuple[list[str], list[Any]]:
    """Names of panels in a state, and a solid of each board, or of each panel without one."""
    names: list[str] = []
    found: list[Any] = []
    for part, state in document.parts_in(which):
        if part.boards is not None:
            names += [part.panel_name(panel) for panel in part.boards.panels.tolist()]
            found += solids(part.boards_in(state), part.boards)
        else:
            names += [part.panel_name(panel) for panel in range(len(part.mesh.faces))]
            found += thin_solids(state.positions, part.mesh.faces)
    return names, found


def thin_solids(points: Array, faces: Integers) -> list[Any]:
    """Panels without a thickness as solids that lie within them, but for a hair to either side."""
    corners = points[faces]
    middle = corners.mean(axis=1, keepdims=True)
    inside = middle + (1 - SHRUNK) * (corners - middle)
    size = float(np.linalg.norm(corners - middle, axis=-1).max())
    normals = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
    over = THIN * size * normals[:, None]
    outlines = np.stack([inside - over, inside + over], axis=1)
    every = np.arange(len(faces))
    return solids(outlines, Boards(every, np.zeros(len(faces), np.int64), outlines))


def common(
    names: list[str], found: list[Any], kind: str | tuple[str, ...] = "gusset"
) -> dict[tuple[str, str], float]:
    """Volume that parts of a kind have in common with what is no board of theirs, by both names."""
    boxes = np.array([each.bounding_box() for each in found])
    low, high = boxes[:, :3], boxes[:, 3:]
    near = ((low[:, None] < high) & (low < high[:, None])).all(axis=-1)
    result: dict[tuple[str, str], float] = {}
    for a, b in np.argwhere(np.triu(near, 1)).tolist():
        if names[a] != names[b] and any(names[each].startswith(kind) for each in (a, b)):
            volume = (found[a] ^ found[b]).volume()
            pair = names[a], names[b]
            result[pair] = max(volume, result.get(pair, 0.0))
    return result
