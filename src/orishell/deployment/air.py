"""Air in box girders, or in cells between two skins: how much on the way, and what it lifts.

A sleeve encloses a volume V(t), a sum of prismatoids with plane sides. Air of a pressure p does the
work p dV as the drive changes, and balances the shell's own weight, of the potential energy U,
where

    p dV/dt = dU/dt.

So it lifts the shell where V grows with U, and comes to rest where V is largest: there it has no
more lever. Ends are open, and have to be closed, as by cloth, for all that.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.conventions.record import Angle, record
from orishell.motion.complex import Complex
from orishell.numerics.arrays import Array

FAN = 500.0
"""What a small radial fan gives (Pa)."""


@record
class Air:
    """Air in what the sheet carries, on the way between where that is joined and the pack."""

    drives: tuple[Angle, ...]
    volumes: tuple[float, ...]  # what it holds there (cubic metres)
    # the pressure that balances own weight there (Pa), negative where the shell goes on by itself;
    # None where volume does not change, or the mass is not known
    pressures: tuple[float | None, ...]
    at_target: float  # what it holds at the target (cubic metres)
    rest: Angle  # where they hold most, and air comes to rest
    # as far as a fan lifts the shell from its pack, towards where air comes to rest; None if that
    # is not known, or the shell is folded up from flat
    fan_to: Angle | None


def find_air(
    whole: Complex,
    drives: Sequence[float],
    energy: Array,
    between: tuple[float, float],
    *,
    metres: float,
    weighed: bool,
    from_pack: bool,
) -> Air:
    """Air in cavities of what a sheet carries, one at least, on the way.

    Parameters
    ----------
    drives
        Drives from flat to the pack (D,), the target among them (radians).
    energy
        Potential energy at them (D,) (N times length).
    between
        Drives between which strips are on the sheet (radians).
    metres
        The unit of length (m).
    weighed
        Whether the energy is in newtons: else the mass is not known.
    from_pack
        Whether the shell is opened from its pack.
    """
    every = np.asarray(drives)
    there = (every >= between[0]) & (every <= between[1] * (1 + 1e-12))
    at, lift = every[there], energy[there] * metres
    points = whole.sheet.positions(at)
    cells = [cell for each in whole.strips for cell in each.cells]
    volume = sum(each.volumes(points).sum(axis=-1) for each in cells) * metres**3
    volume = np.asarray(volume)
    target = int(np.argmin(np.abs(at - whole.target_drive)))
    most = int(np.argmax(volume))
    needed = np.full(len(at), np.nan)
    if weighed and len(at) > 2:
        grows, climbs = np.gradient(volume, at), np.gradient(lift, at)
        known = np.abs(grows) > 1e-9 * volume.max()
        needed[known] = climbs[known] / grows[known]
    return Air(
        drives=tuple(at.tolist()),
        volumes=tuple(volume.tolist()),
        pressures=tuple(None if np.isnan(each) else each for each in needed.tolist()),
        at_target=float(volume[target]),
        rest=float(at[most]),
        fan_to=_lifted(at, needed, volume, target, most) if from_pack and weighed else None,
    )


def _lifted(at: Array, needed: Array, volume: Array, target: int, most: int) -> float:
    """As far as a fan lifts a shell from its pack, towards its target."""
    last = max(target, most)
    reached = len(at) - 1
    for k in range(len(at) - 1, last - 1, -1):
        grows = volume[max(k - 1, 0)] > volume[k] or k == last
        if not grows or not needed[k] <= FAN:
            break
        reached = k
    return float(at[reached])
