"""Documents as formats get them: the three figures' shells, smaller, and parts of them."""

from __future__ import annotations

import tomllib
from dataclasses import replace
from functools import cache
from pathlib import Path

from orishell.design import Construction, PanelBuild
from orishell.design_file import check_design, read_design_file, starter_file
from orishell.document import Document
from orishell.document.from_design import document_of_motion
from orishell.motion import FoldingMotion
from orishell.shell.make import make_shell
from orishell.solids import build_boards, largest_folds, largest_height

EXAMPLES = Path(__file__).parent.parent / "examples"
FAMILIES = {
    "parallel-repeating": "figure1",
    "orthodiagonal": "figure2",
    "longitudinal-linear-repeating": "figure3",
}


@cache
def demo_document(family: str = "parallel-repeating", frames: int = 7) -> Document:
    """The shell of a figure of the paper in metres, with its flat sheet, states and curves."""
    file = read_design_file(EXAMPLES / f"{FAMILIES[family]}.toml")
    design = file.pattern.design(file.f, file.g)
    return document_of_motion(
        FoldingMotion(design.mechanism, frames), "m", title=family, curves=design.targets
    )


@cache
def board_document(
    family: str = "parallel-repeating", construction: Construction = "sandwich", frames: int = 5
) -> Document:
    """The same with panels as thick as they may be, and its flaps clipped on."""
    file = read_design_file(EXAMPLES / f"{FAMILIES[family]}.toml")
    design = file.pattern.design(file.f, file.g).with_clipped_flaps()
    sheets = [each for each in (design.mechanism, design.clipped) if each is not None]
    folds = [largest_folds(each, design.mechanism.target_drive) for each in sheets]
    flats = [each.positions(0.0) for each in sheets]
    most = largest_height(flats[0], sheets[0].grid, folds[0])
    build = PanelBuild(
        thickness=0.5 * most,
        construction=construction,
        membrane=0.05 * most if construction == "sandwich" else 0.0,
        gap=0.02 * most,
    )
    boards, *flaps = (
        build_boards(flat, each.grid, build, fold)
        for flat, each, fold in zip(flats, sheets, folds, strict=True)
    )
    return document_of_motion(
        FoldingMotion(design.mechanism, frames),
        "m",
        title=family,
        curves=design.targets,
        clipped=design.clipped,
        panel=build,
        boards=boards,
        flaps=flaps[0] if flaps else None,
    )


def pack_document() -> Document:
    """A shell that is opened from its pack over its target, with its report."""
    tables = tomllib.loads(starter_file("orthodiagonal")) | {"deployment": {"from": "pack"}}
    file = check_design(tables, Path("pack.toml"), files=False)
    return make_shell(file, clash="unexamined", measured=False, nested=False).document


@cache
def boards_document(build: PanelBuild, family: str = "parallel-repeating") -> Document:
    """The shell of a figure without flaps, of panels with a thickness."""
    file = read_design_file(EXAMPLES / f"{FAMILIES[family]}.toml")
    design = file.pattern.design(file.f, file.g)
    mechanism = design.mechanism.without_flaps()
    folds = largest_folds(mechanism, mechanism.target_drive)
    boards = build_boards(mechanism.positions(0.0), mechanism.grid, build, folds)
    motion = FoldingMotion(mechanism, 7)
    return document_of_motion(
        motion, "m", title=family, curves=design.targets, panel=build, boards=boards
    )


def flat_only(document: Document) -> Document:
    """The crease pattern alone, as other programs write it."""
    return replace(document, states=(), curves={}, named={})


def folded_only(document: Document) -> Document:
    """States in space alone."""
    return replace(document, flat=None, curves={}, states=tuple(document.states)[1:], named={})
