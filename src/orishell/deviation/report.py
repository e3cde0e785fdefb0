"""How close the shell is to what was asked for, in the report."""

from __future__ import annotations

from orishell.conventions.record import record
from orishell.design import Design
from orishell.deviation import Deviation, Distances
from orishell.polylines import Closeness


@record
class SurfaceReport:
    """Distances between the shell and the surface asked for, both ways."""

    # the larger of both ways: the Hausdorff distance, the root mean square, the mean, and the
    # distance below which 95 % of the area lies
    max: float
    rms: float
    mean: float
    p95: float
    sample_spacing: float  # by how much the largest distance may be off
    # either way by itself
    shell_to_surface: Distances
    surface_to_shell: Distances


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

    # distances of the polylines that the shell locks on from the target curves
    f: Closeness
    g: Closeness
    # distances between the shell and the surface; None if they were not measured
    surface: SurfaceReport | None
    # how f or g lie in that surface otherwise than they are drawn; empty where they lie as drawn
    tilted: str
    approached: ApproachReport | None  # what the family approaches instead, if it does


def describe_deviation(
    design: Design, deviation: Deviation | None, approach: Deviation | None
) -> DeviationReport:
    """How close the polylines are to f and g, and the shell to the surface asked for."""
    approached = design.approached
    return DeviationReport(
        f=design.closeness["f"],
        g=design.closeness["g"],
        surface=None
        if deviation is None
        else SurfaceReport(
            max=deviation.max,
            rms=deviation.rms,
            mean=deviation.mean,
            p95=deviation.p95,
            sample_spacing=deviation.sample_spacing,
            shell_to_surface=deviation.shell_to_surface,
            surface_to_shell=deviation.surface_to_shell,
        ),
        tilted=design.tilted,
        approached=None
        if approached is None
        else ApproachReport(
            what=approached.what,
            max=None if approach is None else approach.max,
            rms=None if approach is None else approach.rms,
        ),
    )
