"""What the verdict says of the distance between a shell and its target."""

from __future__ import annotations

from collections.abc import Iterator

from orishell.conventions.quantities import size
from orishell.conventions.row import Row
from orishell.deviation.report import DeviationReport


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
