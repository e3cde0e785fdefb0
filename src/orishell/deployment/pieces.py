"""Into pieces of how many rows whole boards are parted, so that they pack smallest."""

from __future__ import annotations

from typing import Literal

from orishell.conventions.errors import DesignError
from orishell.deployment.pack import find_packs
from orishell.design import PanelSpec
from orishell.motion import Mechanism
from orishell.numerics.equals import NEAR
from orishell.solids.boards import build_boards
from orishell.solids.hinged import find_hinges
from orishell.solids.hinged.joints import numbers_of_rows

Rows = int | Literal["whole"]
"""Rows of panels that a piece has at most."""


def choose_pieces(mechanism: Mechanism, build: PanelSpec, end: float) -> Rows:
    """Rows of panels that pieces have at most, for the smallest pack, or "whole".

    All that part the sheet otherwise are tried, and their boxes compared at the end of the motion
    (radians), whose path is not examined here. Of equals it is the one with the fewest pieces.

    Raises
    ------
    DesignError
        If arms are too long in all of them.
    """
    refused: DesignError | None = None
    best: tuple[float, Rows] | None = None
    tried: list[Rows] = ["whole", *reversed(numbers_of_rows(mechanism.grid.rows - 1))]
    for pieces in tried:
        try:
            volume = _packed_volume(mechanism, build.replace_unchecked(pieces=pieces), end)
        except DesignError as error:
            refused = error
            continue
        if best is None or volume < (1 - NEAR) * best[0]:
            best = volume, pieces
    if best is None:
        assert refused is not None
        raise refused
    return best[1]


def _packed_volume(mechanism: Mechanism, build: PanelSpec, end: float) -> float:
    hinges, folds = find_hinges(mechanism, build), mechanism.fold_angles(end)
    flat = mechanism.positions(0.0)
    boards = build_boards(flat, mechanism.grid, build, folds, hinges=hinges)
    return sum(each.box.volume for each in find_packs(mechanism, end, boards, 1))
