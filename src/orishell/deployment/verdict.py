"""What the verdict says of a shell's feet and own weight, and of the ground that it needs."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from orishell.conventions.quantities import plain, size
from orishell.conventions.row import Row
from orishell.deployment.air import FAN
from orishell.deployment.feet import Feet
from orishell.deployment.report import DeploymentReport


def feet_rows(stands: Feet | None, unit: str, *, on_f: bool) -> Iterator[Row]:
    """On what a shell stands, and what reaches below; ``on_f``: whether it follows a curve f."""
    if stands is None and not on_f:
        text = "on no two rows: its first and last rows are not its lowest part; name its supports"
    elif stands is None:
        text = "nowhere: f's ends are not its lowest part, so g stays in the plane z = 0"
    else:
        first, last = stands.rows
        low = f"z = {plain(stands.z, 3)}"
        text = f"level on {low}, on rows {first} and {last}"
        if stands.points:
            at = "; ".join(f"{row}, {column}" for row, column in stands.points)
            text = f"level on {low}, on vertices {at}"
        if not stands.level:
            high = size(stands.uneven, unit, bound=True)
            text = f"on rows {first} and {last}, from {low} up to {high} above"
        if stands.below:
            text += f"; flaps reach {size(stands.below, unit, bound=True)} below"
    yield Row("says", "feet", text)


def weight_rows(deployment: DeploymentReport) -> Iterator[Row]:
    """What its own weight does."""
    weight = deployment.weight
    if weight is None:
        return
    does = "pushes its feet apart" if weight.at_feet > 0 else "pulls its feet together"
    newtons, force = weight.force_unit == "N", abs(weight.at_feet)
    thrust = f"{plain(force, 3)} N" if newtons else f"{plain(100 * force, 3)} % of itself"
    total = f"{plain(weight.total)} N, " if newtons else ""
    pack = deployment.start == "pack"
    raising = weight.raise_from_pack if pack else weight.raise_from_flat
    work = f"{plain(raising, 3)} J" if newtons else f"{plain(raising, 3)} m times the weight"
    raises = f"work to raise it: {work}" if raising > 0 else "it comes down to its place by itself"
    yield Row("says", "weight", f"{total}{does} with {thrust}; {raises}")


def air_rows(deployment: DeploymentReport) -> Iterator[Row]:
    """What box girders or cells of a second skin hold, where air rests, and what a fan lifts."""
    air = deployment.air
    if air is None:
        return
    rest = f"{np.rad2deg(air.rest):.4g} degrees"
    most = f"{plain(air.at_target, 3)} m3 at the target, most, {plain(max(air.volumes), 3)} m3, at"
    lifts = ""
    if air.fan_to is not None and air.fan_to < air.drives[-1]:
        lifts = f"; a fan of {plain(FAN)} Pa lifts it from the pack to "
        lifts += f"{np.rad2deg(air.fan_to):.4g} degrees"
    yield Row("says", "air", f"{most} {rest}, where air rests if ends are closed{lifts}")


def ground_rows(deployment: DeploymentReport, people: int | None, unit: str) -> Iterator[Row]:
    """The ground that it needs on its way, and the people."""
    plan = deployment.ground
    if plan is None or plan.swept is None:
        return
    swept = plan.swept
    wide, deep, high = (
        size(each, unit, bound=True) for each in (swept.width, swept.depth, swept.height)
    )
    crew = ""
    if people is not None:
        crew = "; one person carries it" if people == 1 else f"; {people} people carry it"
    yield Row("says", "ground", f"{wide} x {deep} on the way, and {high} of height{crew}")
