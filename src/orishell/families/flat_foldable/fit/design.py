"""The design of a sheet fitted to a surface: what was reached, and whether it is of use."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import partial

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import tidy_degrees
from orishell.conventions.memory import MEMORY, key_of
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.quantities import plain
from orishell.curves.memo import remembered
from orishell.curves.nearest import Closeness
from orishell.design import Design, PiecedSurface
from orishell.design.piece import Piece
from orishell.families.flat_foldable.fit.conditions import Conditions
from orishell.families.flat_foldable.fit.continuation import THOROUGH
from orishell.families.flat_foldable.fit.figures import measure
from orishell.families.flat_foldable.fit.initial_guesses import Fit, Start, Task, fit_sheet
from orishell.families.flat_foldable.fit.residuals import Problem
from orishell.families.flat_foldable.fit.unknowns import OFFSET, ROTATION, SHIFT
from orishell.families.flat_foldable.ground import Ground, grounded
from orishell.families.flat_foldable.lists import describe
from orishell.families.flat_foldable.mechanism import FlatFoldable
from orishell.families.flat_foldable.placement import posed
from orishell.families.shared.folding import turned
from orishell.motion import area_of
from orishell.numerics.arrays import Array


def recall_fit(
    task: Task, *, direction: int | None, folded: float | None, progress: Progress
) -> Fit | None:
    """What :func:`fit_sheet` finds; made of its unknowns again, to the last bit, once it was."""
    piece, conditions = task.piece, task.conditions
    key = key_of(
        "fit",
        task.rows,
        task.columns,
        conditions,
        task.straight,
        direction,
        folded,
        arrays=(piece.vertices, piece.normals, piece.triangles, *piece.sides),
    )
    fresh: list[Fit | None] = []

    def find() -> tuple[Start, Array] | None:
        fit = fit_sheet(task, direction=direction, folded=folded, progress=progress)
        fresh.append(fit)
        return None if fit is None else (fit.start, fit.fitted.unknowns)

    known = MEMORY.recall(key, find)
    if fresh or known is None:
        return fresh[0] if fresh else None
    start, unknowns = known
    seen, of = start.on(piece), task.begun(start)
    fitted = Problem(seen, of, THOROUGH.final, conditions).at(unknowns)
    assert fitted is not None
    return Fit(start, of, fitted, measure(seen, fitted, of.size, float(unknowns[OFFSET])))


LOOSE = 0.01
"""Vertices that leave the offset surfaces by a larger share of the diagonal draw a warning."""
USELESS = 0.05
"""From this share on the sheet is refused."""
COVERED = 0.25
"""So is one of less than this share of the surface's area: those of the examples have 1.2 to 2.1
times as much, as they are corrugated."""


@dataclass(frozen=True)
class Asked:
    """What a sheet is fitted to."""

    surface: PiecedSurface
    rows: int
    columns: int
    edge_ratio: float
    direction: int | None  # of the rows to those of the piece (a multiple of 90 degrees)
    fold: float | None  # at the start (radians)
    straight: bool = False  # whether the right border is straight in the flat sheet
    ground: Ground = "free"  # how the shell meets the ground


def design_fitted(
    asked: Asked, progress: Progress = no_progress, begin: object | None = None
) -> Design:
    """The design of the sheet that comes nearest to a surface.

    Parameters
    ----------
    begin
        What was fitted to another surface nearby, so that it is followed from there; None for a
        fit from a Miura-ori, and where there is no way from there.

    Raises
    ------
    DesignError
        If no sheet keeps the conditions, the nearest one is of no use, or does not meet the ground.
    """
    piece = asked.surface.piece
    free_rim, watched = replace(asked, ground="free"), _Watched(progress)
    fit = _moved(asked.surface, free_rim, begin) if isinstance(begin, Fit) else None
    fit = fit or _fitted(asked.surface, free_rim, watched)
    if fit is None:
        raise DesignError(
            "no Miura-ori over the plan of the surface, from which a fit begins, has panels "
            f"whose edges are within a factor of {asked.edge_ratio:g}",
            keys=("pattern.edge_ratio", "pattern.rows", "pattern.columns"),
            candidates=_remedies(asked),
        )
    if fit.reached.vertices > USELESS:
        raise _useless(asked, fit)
    free = mechanism_of(fit)
    mechanism = grounded(free, asked.ground)
    share = area_of(mechanism) / asked.surface.area()
    if share < COVERED:
        raise _too_small(asked, share)
    return Design(
        mechanism=mechanism,
        parameters={
            "sheet": "lists",
            "border": "straight" if asked.straight else "free",
            "flap": 0.0,
            "fold_deg": tidy_degrees(2 * float(np.arctan(_largest(fit)))),
            "direction_deg": fit.start.direction,
            "start_fold_deg": tidy_degrees(fit.start.folded),
            "offset": fit.reached.offset * piece.diagonal,
            "ground": asked.ground,
            **describe(mechanism.sheet),
        },
        targets={},
        closeness=_closeness(fit, piece, mechanism),
        fitted=fit,
        swept=asked.surface,
        may_stand=True,
        # Sheets that began with other fold angles were as large within 5 %, or lost; those with
        # half as many rows and columns 4 to 15 % smaller, and twice as far away.
        smaller_by="",
        grounded=None if asked.straight else partial(grounded, free),
        warnings=tuple(_warnings(fit)),
    )


@dataclass(frozen=True)
class _Watched:
    """Who is told of progress: makes no difference to a result."""

    progress: Progress = field(compare=False)


@remembered
def _fitted(surface: PiecedSurface, asked: Asked, watched: _Watched) -> Fit | None:
    task = _task(surface, asked)
    return recall_fit(task, direction=asked.direction, folded=asked.fold, progress=watched.progress)


@remembered
def _moved(surface: PiecedSurface, asked: Asked, begin: Fit) -> Fit | None:
    return _task(surface, asked).moved(begin)


def _task(surface: PiecedSurface, asked: Asked) -> Task:
    conditions = Conditions(asked.edge_ratio)
    return Task(surface.piece, asked.rows, asked.columns, conditions, asked.straight)


def mechanism_of(fit: Fit) -> FlatFoldable:
    """The sheet as it was placed."""
    of, unknowns = fit.of, fit.fitted.unknowns
    rotation = of.frame @ turned(np.eye(3)[..., None], unknowns[ROTATION, None])[..., 0]
    place = of.place + of.size * of.frame @ unknowns[SHIFT]
    return posed(fit.fitted.placed.sheet, rotation, place)


def _largest(fit: Fit) -> float:
    net = fit.fitted.placed.sheet.net
    return float(max(np.abs(net.x).max(), np.abs(net.y).max()))


def _closeness(fit: Fit, piece: Piece, mechanism: FlatFoldable) -> dict[str, Closeness]:
    """Of vertices from the offset surfaces."""
    size, sides = fit.of.size, fit.of.sides
    off = np.abs(fit.fitted.heights) * size
    if mechanism.sheet is not fit.fitted.placed.sheet:  # its border was moved to the ground
        places = mechanism.positions(mechanism.target_drive)
        heights = fit.start.on(piece).nearest(places.reshape(-1, 3))[0].reshape(off.shape)
        off = np.abs(heights - size * fit.fitted.unknowns[OFFSET] * sides)
    above = sides[:, 0] > 0
    return {
        name: Closeness(float(rows.max()), float(np.sqrt((rows**2).mean())))
        for name, rows in (("crests", off[above]), ("valleys", off[~above]))
    }


def _warnings(fit: Fit) -> Iterator[str]:
    reached = fit.reached
    row, column = reached.worst
    if reached.vertices > LOOSE:
        yield (
            "the sheet follows the surface loosely: its vertices leave the surfaces on which "
            f"crests and valleys should lie by up to {_percent(reached.vertices)} of the target's "
            f"diagonal, near vertex {row}, {column}"
        )


def _useless(asked: Asked, fit: Fit) -> DesignError:
    reached = fit.reached
    row, column = reached.worst
    return DesignError(
        "no sheet of this family was found that follows the surface",
        keys=("pattern.edge_ratio", "pattern.rows", "pattern.columns"),
        place=f"near vertex {row}, {column}",
        size=f"the nearest leaves it by {_percent(reached.vertices)} of its diagonal, "
        f"{_percent(reached.mesh)} with its corrugation; {_percent(USELESS)} is allowed",
        candidates=_remedies(asked),
        excess=reached.vertices / USELESS - 1,
    )


def _too_small(asked: Asked, share: float) -> DesignError:
    return DesignError(
        "no sheet of this family was found that covers the surface",
        keys=("pattern.edge_ratio", "pattern.rows", "pattern.columns"),
        size=f"the nearest has {_percent(share)} of its area; {_percent(COVERED)} is asked for",
        candidates=_remedies(asked),
        excess=COVERED / share - 1,
    )


def _remedies(asked: Asked) -> Iterator[Remedy]:
    yield Remedy({"pattern.edge_ratio": 2 * asked.edge_ratio})
    yield Remedy({"pattern.rows": 2 * asked.rows + 1, "pattern.columns": 2 * asked.columns + 1})


def _percent(share: float) -> str:
    return f"{plain(100 * share)} %"
