"""A shell cut with errors, in the report: what its hinges need, and where it then stands."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from orishell.conventions.quantities import plain, size
from orishell.conventions.record import Angle, record
from orishell.conventions.row import Row
from orishell.workshop.settings import Cutting


@record
class Scatter:
    """How large something is in sheets that are cut with errors."""

    rms: float  # root mean square over sheets and places (length)
    largest: float  # the largest in a sheet, which 95 % of sheets do not exceed (length)


@record
class FlapStop:
    """Where flaps stop a shell that is cut with errors; 95 % of sheets do not exceed these."""

    off: Angle  # by how much the fold angle of the hinge that moves most is off where they shut
    last: Angle  # what the last pair of flaps then still lacks
    shape: float  # how far that leaves vertices from their places, rms over the shell (length)


@record
class CuttingReport:
    """What follows if a shell is cut with errors: to first order, at its target."""

    cutting: Cutting  # whether boards are cut apart, or creases in one sheet
    error: float  # standard deviation of a corner along each axis (length)
    bias: float  # by how much boards are too small all around (length)
    play: Scatter  # how far the two sides of a hinge are apart at its ends
    # the same if hinges slide along their axes: across and along these
    across: Scatter
    along: Scatter
    # how far corners of boards stand off their plane if hinges have no play across, and boards
    # twist
    lift: Scatter
    # how far vertices are from their places; None if that is not small, or if it moves in more ways
    # than one at the target
    shape: Scatter | None
    ends: Scatter | None  # feet alone, or the first and the last row of a shell without
    on_feet: bool  # whether these are feet
    flaps: FlapStop | None  # where its flaps stop it; None if it has none

    def rows(self, unit: str) -> Iterator[Row]:
        """What is said of it, lengths in its unit."""
        what = "boards cut apart" if self.cutting == "boards" else "creases in one sheet"
        errors = f"corners {size(self.error, unit)} off (rms along each axis, {what})"
        if self.bias:
            way = "small" if self.bias > 0 else "large"
            errors += f", sides {size(abs(self.bias), unit)} too {way}"
        miss = "where it then stands is not known: too far off, or it moves in more ways than one"
        if self.ends is not None:
            which = "feet" if self.on_feet else "ends"
            miss = f"{which} miss their places by {size(self.ends.rms, unit)} (rms)"
        yield Row(
            "says",
            "cut",
            f"{errors}: hinges need {size(self.play.rms, unit)} of play (rms), at most "
            f"{size(self.play.largest, unit, bound=True)} in 95 % of sheets; {miss}",
        )
        if self.flaps is not None:
            off, last = (plain(np.rad2deg(each), 2) for each in (self.flaps.off, self.flaps.last))
            yield Row(
                "says",
                "flaps",
                f"cut so, the first pair shuts within {off} degrees of the target (95 % of "
                f"sheets), which leaves the shell {size(self.flaps.shape, unit)} off (rms); the "
                f"last one then lacks up to {last} degrees",
            )
