"""How close the shell is to what was asked for: in the report, and in the verdict."""

from __future__ import annotations

from collections.abc import Iterator

from orishell.conventions.quantities import size
from orishell.conventions.record import record
from orishell.conventions.row import Row
from orishell.curves.nearest import Closeness
from orishell.design import Design
from orishell.deviation.measure import Deviation, measure_approach, measure_deviation
from orishell.deviation.of_boards import boards_closeness


@record
class ApproachReport:
    """The surface that ever finer shells approach, where it is not f swept along g."""

    what: str  # what it is
    # distances of the shell from it; None if it has no simple form, or they were not measured
    max: float | None
    rms: float | None


@record
class DeviationReport:
    """How close the shell is to what was asked for."""

    # distances of the polylines that the shell locks on from the target curves, or of the edges of
    # whole boards that take their place; None without them
    f: Closeness | None
    g: Closeness | None
    surface: Deviation | None  # of the shell from the surface; None if it was not measured
    # how f or g lie in that surface otherwise than they are drawn; empty where they lie as drawn
    tilted: str
    approached: ApproachReport | None  # what the family approaches instead, if it does
    # distances of vertices, or of corners of whole boards, from the surfaces beside the one asked
    # for, on which crests and valleys should lie; None where f is swept along g
    crests: Closeness | None = None
    valleys: Closeness | None = None


def describe_deviation(design: Design, *, measured: bool = True) -> DeviationReport | None:
    """How close a shell is to its target; None if it has none.

    measured: Whether distances from surfaces are asked for, beside those from f and g.
    """
    if design.swept is None:
        return None
    closeness = design.closeness if design.meant is None else boards_closeness(design)
    approach = measure_approach(design) if measured else None
    approached = None
    if design.approached is not None:
        largest, rms = (None, None) if approach is None else (approach.max, approach.rms)
        approached = ApproachReport(design.approached.what, largest, rms)
    return DeviationReport(
        f=closeness.get("f"),
        g=closeness.get("g"),
        surface=measure_deviation(design) if measured else None,
        tilted=design.tilted,
        approached=approached,
        crests=closeness.get("crests"),
        valleys=closeness.get("valleys"),
    )


def surface_rows(deviation: DeviationReport | None, unit: str) -> Iterator[Row]:
    """How close the shell is to what was asked for."""
    if deviation is None:
        yield Row("says", "surface", "no target: nothing to compare the shell with")
        return
    curves = ", ".join(
        f"{name} within {size(near.max, unit, bound=True)}"
        for name in ("f", "g", "crests", "valleys")
        if (near := getattr(deviation, name)) is not None
    )
    if deviation.crests is not None:
        curves += " of where they should lie beside it"
    surface = deviation.surface
    if surface is not None:
        known = size(surface.sample_spacing, unit, bound=True)
        curves = (
            f"within {size(surface.max, unit, bound=True)} of the target (known to {known}), "
            f"rms {size(surface.rms, unit)}; {curves}"
        )
    yield Row("says", "surface", curves)
    if deviation.tilted:
        yield Row("says", "tilted", f"in the surface asked for {deviation.tilted}")
    approached = deviation.approached
    if approached is not None:
        most = approached.max
        found = "" if most is None else f"; at most {size(most, unit, bound=True)} from that"
        yield Row("says", "approach", f"{approached.what}{found}")
