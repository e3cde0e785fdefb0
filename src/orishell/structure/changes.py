"""By how much figures still change with the mesh."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import fields
from typing import Literal

from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.conventions.row import Note

Stop = Literal["work", "memory", "cells"]
"""Why cells are no finer: an analysis with finer ones would take too long, or too much memory, or
they are as fine as they may be."""


@record
class Changes:
    """Shares by which the figures of all cases change from the next coarser mesh.

    Of every figure it is the case where it changes most; 1 where only one of both meshes has it, as
    for a case that only one of them finds to stand.
    """

    displacement: float = 0.0  # the largest displacement
    stress: float = 0.0  # the largest stress of panels
    buckling: float = 0.0  # the buckling factor

    @property
    def largest(self) -> float:
        """The largest of them."""
        return max(self.displacement, self.stress, self.buckling)

    def exceeding(self) -> Iterator[str]:
        """What changes by more than is settled, in words."""
        for each in fields(self):
            share = getattr(self, each.name)
            if share > SETTLED[each.name]:
                yield f"{NAMED[each.name]} by {plain(100 * share, 2)} %"


NAMED = {
    "displacement": "displacement",
    "stress": "stress",
    "buckling": "the buckling factor",
}
"""Figures in words."""
SETTLED = {"displacement": 0.1, "stress": 0.1, "buckling": 0.03}
"""Figures that change by at most these shares are settled."""


@record
class Figures:
    """What of a case is compared; all None if it does not stand."""

    displacement: float | None = None
    stress: float | None = None
    buckling: float | None = None  # None also if it does not buckle


def find_changes(coarse: Sequence[Figures], fine: Sequence[Figures]) -> Changes:
    """How the figures of all cases change from a coarse mesh to a fine one.

    coarse, fine: Those of every case.
    """
    return Changes(
        **{
            each.name: _largest(
                (getattr(before, each.name), getattr(after, each.name))
                for before, after in zip(coarse, fine, strict=True)
            )
            for each in fields(Changes)
        }
    )


def _largest(pairs: Iterable[tuple[float | None, float | None]]) -> float:
    return max((_share(*pair) for pair in pairs), default=0.0)


def _share(before: float | None, after: float | None) -> float:
    if before is None or after is None:
        return float((before is None) is not (after is None))
    if before == after:
        return 0.0
    return float(abs(after - before) / abs(after)) if after else 1.0


STOPPED: dict[Stop, str] = {
    "work": "finer cells would take too long",
    "memory": "finer cells would take too much memory",
    "cells": "cells are as fine as they may be",
}
"""Why cells are no finer, in words."""
ENOUGH = 6
"""From so many cells on, what is still missing is about as much as the change, 1.5 times at most
beside points that hold the shell; up to 3.2 times with 3 cells, 2.4 with 4 (the shells of Figures 1
and 2 and a bus shelter of solid panels under snow, against 12 and 16 cells)."""


def missing_in_words(cells: int) -> str:
    """What a change from the next coarser mesh says of what is missing; empty if about the same."""
    return "" if cells >= ENOUGH else f"with {cells} cells three times as much may be missing"


def refinement_warnings(change: Changes, stopped: Stop | None, cells: int) -> Iterator[str]:
    """What an engineer should read of figures that change with the mesh, of so many cells."""
    said = _listed(change.exceeding())
    missing = missing_in_words(cells)
    if stopped is not None:
        most = plain(100 * change.largest, 2)
        yield (
            f"refinement ended before figures settled: {STOPPED[stopped]}. From the next coarser "
            f"mesh they changed by {most} % at most"
            + (f": {said}" if said else "")
            + (f"; {missing}" if missing else "")
        )
    elif said:
        yield Note(
            f"figures change with the mesh, from the next coarser one {said}"
            + (f", and {missing}" if missing else "")
            + ". Use finer cells (cells, or refine, in [structure])",
            "cells",
        )


def _listed(parts: Iterable[str]) -> str:
    *others, last = [*parts] or [""]
    return f"{', '.join(others)} and {last}" if others else last
