"""Warnings of supports that are points, where a finer mesh does not make buckling any surer."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from orishell.conventions.quantities import plain
from orishell.structure.case import CaseResult
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.model import Model

LOCAL = 0.65
"""A mode is local to points that hold the shell if so much of its strain energy is in panels there:
0.76 to 1 where it was, up to 0.54 where it was not (shelter, a strip of it, and Figure 2)."""
NEAR = 1.25
"""Local modes count below so many times the lowest factor: with finer cells they fall that much."""
FAR = 10.0
"""Above this factor nothing is said: a shell that far from buckling stays far from it."""


def warn_of_points(model: Model, cases: Sequence[CaseResult]) -> Iterator[str]:
    """What supports that are points, or next to points, do to buckling."""
    for patch in model.supports.lost:
        yield (
            f"a patch of {plain(patch, 3)} {model.site.unit} is smaller than the cells around it: "
            "only vertices are held (patch in supports, or cells, in [structure])"
        )
    names = dict.fromkeys(
        case.name
        for case in cases
        if case.equilibrium is not None and buckles_at_points(case.equilibrium)
    )
    if names:
        yield (
            f"load cases {', '.join(names)}: buckling is local to supports held at a point, and "
            "falls as cells become finer: hold edges or a patch there (edges = true, or patch, in "
            "supports in [structure])"
        )


def buckles_at_points(found: Equilibrium) -> bool:
    """Whether a shell buckles, or nearly so, locally where points hold it."""
    lowest = found.buckling
    if lowest is None or lowest > FAR:
        return False
    both = zip(found.buckling_factors, found.buckling_at_points, strict=True)
    return any(share > LOCAL and factor < NEAR * lowest for factor, share in both)
