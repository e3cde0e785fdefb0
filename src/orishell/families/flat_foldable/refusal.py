"""Which nets make no sheet, and what is wrong with them."""

from __future__ import annotations

import numpy as np

from orishell.conventions.formatting import in_degrees
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.families.flat_foldable.net import Net, Sheet
from orishell.motion.quads import grid_corners
from orishell.numerics.arrays import Array
from orishell.numerics.equals import first_smallest

ALIKE = 1e-6
"""A row and a column have no vertex if tangents of half their fold angles differ by less
(relative)."""
STILL = 1e-9
"""A row or a column stays flat if the tangent of half its fold angle is a smaller share of the
largest."""
SHARPEST = 1e-3
"""The least sine of a panel's corner."""


@record
class Fault:
    """Why there is no sheet."""

    condition: str
    place: str
    size: str = ""
    excess: float | None = None


def find_fault(net: Net) -> Fault | None:
    """What is wrong with a net of one sheet; None if it makes a sheet of convex panels."""
    x, y = np.abs(net.x), np.abs(net.y)[:, 0]
    sizes = np.concatenate([x.ravel(), y.ravel()])
    if sizes.min() < STILL * sizes.max():
        least = int(sizes.argmin())
        return Fault(
            "a row or a column stays flat while others fold",
            f"row {least + 1}" if least < x.size else f"column {least - x.size + 1}",
            f"it folds by {in_degrees(2 * np.arctan(sizes.min()))} degrees",
        )
    alike = np.abs(x / y - 1) < ALIKE
    if alike.any():
        row, column = np.argwhere(alike)[0]
        return Fault(
            "a row and a column that fold alike cannot cross",
            f"row {row + 1} and column {column + 1}",
            f"both fold by {in_degrees(2 * np.arctan(x[row, 0]))} degrees",
        )
    sheet = net.march()
    return _of_sectors(sheet) or _of_lengths(sheet) or _of_panels(sheet)


def _of_sectors(sheet: Sheet) -> Fault | None:
    missing = ~np.isfinite(sheet.a[..., 0] + sheet.b[..., 0])
    if not missing.any():
        return None
    # The sheet is marched from the middle outwards: the first vertex that fails is nearest to it.
    row, column = np.argwhere(missing)[_steps(sheet)[missing].argmin()]
    return Fault(
        "these fold angles and sector angles make no sheet",
        f"from row {row + 1}, column {column + 1} outwards",
        "the four angles of a panel there cannot sum to 360 degrees",
        float(missing.mean()),
    )


def _of_lengths(sheet: Sheet) -> Fault | None:
    for lengths, ends in ((sheet.rows, (0, 1)), (sheet.columns, (1, 0))):
        found = lengths[..., 0]
        if found.size and not found.min() > 0:
            row, column = np.unravel_index(first_smallest(found), found.shape)
            other = f"row {row + 1 + ends[0]}, column {column + 1 + ends[1]}"
            return Fault(
                "creases cross before they meet their next vertex",
                f"between row {row + 1}, column {column + 1} and {other}",
                f"the edge there would be {plain(float(found.min()))} long",
                float(-found.min() / np.abs(found).mean()),
            )
    return None


def _of_panels(sheet: Sheet) -> Fault | None:
    flat = np.moveaxis(sheet.flat()[..., 0], 0, -1)
    sines = corner_sines(flat)
    if sines.min() >= SHARPEST:
        return None
    row, column, _ = np.unravel_index(first_smallest(sines, size=1.0), sines.shape)
    return Fault(
        "a panel is not convex",
        f"panel {row + 1}, {column + 1}",
        f"the sine of one of its corners is {plain(float(sines.min()))}, and must be {SHARPEST} "
        "or more",
        float(SHARPEST - sines.min()),
    )


def corner_sines(flat: Array) -> Array:
    """Sines (R+1, C+1, 4) of the corners of all panels of a flat sheet (R+2, C+2, 2)."""
    corners = grid_corners(flat) @ np.array([1, 1j])
    ways = np.roll(corners, -1, axis=-1) - corners
    with np.errstate(invalid="ignore"):  # a side of no length has no way
        ways /= np.abs(ways)
    return np.asarray((np.roll(ways, 1, axis=-1).conj() * ways).imag)


def _steps(sheet: Sheet) -> Array:
    """How many steps (R, C) vertices are from the middle one."""
    i, j = sheet.net.middle
    rows, columns = (np.arange(count) for count in sheet.a.shape[:2])
    return np.add.outer(np.abs(rows - i), np.abs(columns - j)).astype(np.float64)
