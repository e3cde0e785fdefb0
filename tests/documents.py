"""Documents as formats get them: the three figures' shells, smaller, and parts of them."""

from __future__ import annotations

import tomllib
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from mechanisms import TURNED, flat_foldable, random_net
from orishell.design import Construction, Design, PanelSpec
from orishell.design_file import check_design, read_design_file, starter_file
from orishell.document import Document
from orishell.document.from_design import document_of_design, document_of_motion
from orishell.document.loaded import LoadedCase, LoadedShell
from orishell.families.flat_foldable.locks.slit import SlitFlaps
from orishell.families.flat_foldable.pattern import FlatFoldablePattern, design_flat_foldable
from orishell.motion import FoldingMotion, Mechanism
from orishell.motion.boards import Boards
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES
from orishell.solids import build_boards, find_stop, largest_folds, thickness_between
from orishell.structure.mesh.sheet import mesh_sheet

EXAMPLES = Path(__file__).parent.parent / "examples"
FAMILIES = {
    "parallel-repeating": "figure1",
    "orthodiagonal": "figure2",
    "longitudinal-linear-repeating": "figure3",
}
SMALL = (5, 5)
"""Rows and columns of a sheet of a fifth of the panels."""


def design_of(family: str, size: tuple[int, int] | None = None) -> Design:
    """That of a figure of the paper, or the same with other numbers of rows and columns."""
    file = read_design_file(EXAMPLES / f"{FAMILIES[family]}.toml")
    pattern = file.pattern
    if size is not None:
        changed: dict[str, Any] = {"rows": size[0], "columns": size[1]}
        if family == "longitudinal-linear-repeating":
            changed["column_lengths"] = [1.0] * (size[0] + 1)
        pattern = pattern.model_copy(update=changed)
    return pattern.design(file.f, file.g)


@cache
def demo_document(
    family: str = "parallel-repeating", frames: int = 7, size: tuple[int, int] | None = None
) -> Document:
    """The shell of a figure of the paper in metres, with its flat sheet, states and curves."""
    design = design_of(family, size)
    return document_of_motion(
        FoldingMotion(design.mechanism, frames), "m", title=family, curves=design.targets
    )


@cache
def slit_document() -> Document:
    """42 panels in 7 rows and 6 columns, and 24 slit flaps."""
    flaps = SlitFlaps(flat_foldable(random_net(6, 5, 2), **TURNED), (0.2, 0.3), 0.0)
    return document_of_design(
        replace(design_flat_foldable(FlatFoldablePattern(rows=5, columns=5)), mechanism=flaps),
        "m",
        frames=3,
    )


@cache
def loaded_document(family: str = "parallel-repeating", cells: int = 1) -> Document:
    """The same as a structure, as if it had been analysed: two of its cases differ by creases."""
    document = demo_document(family)
    assert document.grid_shape is not None
    grid = Grid(*document.grid_shape)
    mesh = mesh_sheet(document.shell.positions.reshape(*document.grid_shape, 3), grid, cells)
    points, triangles = mesh.facets.points, mesh.facets.triangles
    down, up = (np.full(points.shape, [0.0, 0.0, z]) for z in (-1.0, 1.0))
    stress = np.linspace(1, 2, len(triangles))
    corners = grid.vertices()[[0, 0, -1, -1], [0, -1, 0, -1]]
    shell = LoadedShell(
        points=points,
        triangles=triangles,
        panels=mesh.panels,
        membrane=np.full(len(triangles), 1e7),
        bending=np.full(len(triangles), 1e3),
        poisson=0.25,
        areal_mass=np.full(len(triangles), 6.0),
        restrained=np.stack(np.broadcast_arrays(corners[:, None], np.arange(3)), -1).reshape(-1, 2),
        ties=corners[[[0, 1], [2, 3]]],
        tie_stiffness=np.inf,
        cases=(
            LoadedCase(
                "snow, free creases", "fails", False, down, up, np.full(len(triangles), np.nan)
            ),
            LoadedCase(
                "wind", "holds", True, up, 0.001 * up, stress, ((12.3456, up), (20.0, down))
            ),
            LoadedCase("snow, rigid creases", "warns", True, down, 0.002 * down, 2 * stress),
        ),
    )
    return replace(document, loaded=shell)


@cache
def thick_document(
    family: str = "parallel-repeating",
    construction: Construction = "sandwich",
    frames: int = 5,
    build: PanelSpec | None = None,
    *,
    size: tuple[int, int] | None = None,
) -> Document:
    """The same of panels half as thick as they may be, or as given.

    Its flaps, which stop where their boards meet, are clipped on.
    """
    design = design_of(family, size)
    if build is None:
        sheet = design.with_clipped_flaps().mechanism
        folds = largest_folds(sheet, sheet.target_drive)
        most = 0.5 * thickness_between(sheet.positions(0.0), sheet.grid, folds)
        membrane = 0.05 * most if construction == "sandwich" else 0.0
        build = PanelSpec(
            thickness=0.5 * most, construction=construction, membrane=membrane, gap=0.02 * most
        )
    stopped = design.with_stop(find_stop(design.mechanism, build))
    return boarded(stopped.with_clipped_flaps(), build, "m", frames=frames, title=family)


def boarded(
    design: Design,
    build: PanelSpec,
    unit: str,
    *,
    frames: int,
    title: str,
    reliefs: Array | None = None,
) -> Document:
    """The document of a design, with boards on its sheet and on flaps that are clipped on."""
    return document_of_motion(
        FoldingMotion(design.mechanism, frames),
        unit,
        title=title,
        curves=design.targets,
        clipped=design.clipped,
        panel=build,
        boards=boards_of(design.mechanism, build, reliefs),
        flaps=None if design.clipped is None else boards_of(design.clipped, build),
    )


def boards_of(sheet: Mechanism, build: PanelSpec, reliefs: Array | None = None) -> Boards:
    """Boards set back for all folds from the flat sheet to the target."""
    folds = largest_folds(sheet, sheet.target_drive)
    return build_boards(sheet.positions(0.0), sheet.grid, build, folds, reliefs)


def pack_document() -> Document:
    """A shell that is opened from its pack over its target, with its report."""
    tables = tomllib.loads(starter_file("orthodiagonal")) | {"deployment": {"from": "pack"}}
    file = check_design(tables, Path("pack.toml"), files=False)
    return make_shell(file, clash="unexamined", skip=(*MEASURES, "stock")).document


def flat_only(document: Document) -> Document:
    """The crease pattern alone, as other programs write it."""
    return replace(document, states=(), curves={}, named={})


def folded_only(document: Document) -> Document:
    """States in space alone."""
    return replace(document, flat=None, curves={}, states=tuple(document.states)[1:], named={})
