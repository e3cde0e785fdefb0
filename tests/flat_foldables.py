"""Random sheets that fold flat, of three families, for boards on hinges."""

from __future__ import annotations

from functools import cache

import numpy as np

from mechanisms import flat_foldable, parallel, random_net, upright
from orishell.conventions.errors import OrishellError
from orishell.design import Design, PanelSpec
from orishell.families.flat_foldable.named import graded_net
from orishell.families.flat_foldable.net import Net
from orishell.families.flat_foldable.refusal import find_fault
from orishell.motion import Mechanism
from orishell.motion.hinge_lines import IN_CREASES, HingeLines

LARGEST = 12


def boarded(mechanism: Mechanism, build: PanelSpec, hinges: HingeLines = IN_CREASES) -> Design:
    """A design of whole boards without a target, for the way from its pack."""
    return Design(
        mechanism=mechanism,
        parameters={},
        targets={},
        closeness={},
        swept=None,
        warnings=(),
        panel=build,
        hinges=hinges,
        opens_from_pack=True,
    )


@cache
def random_sheet(seed: int) -> Mechanism:
    """A sheet by its number: parallel repeating, orthodiagonal, or a flat-foldable net.

    Nets have straight columns through their middle row, or bend in waves; those that have no
    panels, or none of a positive size, are drawn again.
    """
    rng = np.random.default_rng(seed)
    make = (_parallel, _orthodiagonal, _graded, _bent)[seed % 4]
    while True:
        rows, columns = (int(n) for n in rng.integers(2, LARGEST + 1, 2))
        try:
            sheet = make(rng, rows, columns)
        except OrishellError:
            continue
        if sheet is not None:
            return sheet


def _parallel(rng: np.random.Generator, rows: int, columns: int) -> Mechanism:
    xi = np.deg2rad(rng.uniform(35, 110))
    return parallel(
        rows - 1 | 1, max(columns, 4), plane="bisector", xi_deg=np.rad2deg(xi), flap=0.0
    )


def _orthodiagonal(rng: np.random.Generator, rows: int, columns: int) -> Mechanism:
    rows, columns = max(rows - 1 | 1, 3), max(columns, 3)
    depth = rng.uniform(0.05, 0.2)
    return upright(rows, columns, row="zigzag", depth=depth, flap=0.0).straightened()


def _graded(rng: np.random.Generator, rows: int, columns: int) -> Mechanism | None:
    folds = np.deg2rad(rng.uniform(70, 100, rows)).tolist()
    sectors = np.deg2rad(rng.uniform(55, 70, columns)).tolist()
    lengths = rng.uniform(2, 3, columns + 1).tolist()
    return _of(graded_net(rows, columns, folds=folds, sectors=sectors, row_lengths=lengths))


def _bent(rng: np.random.Generator, rows: int, columns: int) -> Mechanism | None:
    # Arms grow with the size of sheets whose columns bend.
    return _of(random_net(min(rows, 8), min(columns, 8), int(rng.integers(1000))))


def _of(net: Net) -> Mechanism | None:
    return flat_foldable(net) if find_fault(net) is None else None
