"""Flaps that a sheet can have: columns beside straight borders, slit ones beside any other."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.conventions.errors import DesignError
from orishell.design import Design
from orishell.families.flat_foldable.locks.columns import FlapColumns, with_flaps
from orishell.families.flat_foldable.locks.slit import SlitFlaps
from orishell.families.flat_foldable.mechanism import FlatFoldable
from orishell.families.pattern import Auto


def locked(design: Design, width: float | Auto, *, straight: bool) -> Design:
    """A design whose sheet has flaps of a width, "auto" for as wide as they can be.

    straight: Whether they are a column beside a straight border. Otherwise they are slit, and
        stand on the left and on the right.
    """
    assert isinstance(design.mechanism, FlatFoldable)
    bare, given = design.mechanism, None if width == "auto" else width
    sheet = with_flaps(bare, given) if straight else with_slit_flaps(bare, given)
    parameters = {**design.parameters, "flap": flap_width(sheet)}
    warnings = design.warnings if straight else (*design.warnings, warn_of_rows(bare))
    return replace(design, mechanism=sheet, parameters=parameters, warnings=warnings)


def with_any_flaps(bare: FlatFoldable, width: float | None) -> FlapColumns | SlitFlaps:
    """A sheet with columns of flaps beside its straight borders, or slit ones if it has none.

    width: None for the mean length of the border's edges, or less where flaps have no room for it.
    """
    try:
        return with_flaps(bare, width)
    except DesignError as error:
        if error.excess is not None:  # Its borders are straight, and flaps too wide.
            raise
        return with_slit_flaps(bare, width)


def with_slit_flaps(bare: FlatFoldable, width: float | None) -> SlitFlaps:
    """A sheet with slit flaps on its left and its right border.

    width: Of the widest at most; None for the mean length of the edges of both borders.

    Raises DesignError if flaps of a row cannot fold flat at the target.
    """
    if width is None:
        borders = bare.flat[:, :, [0, -1], 0]
        width = float(np.linalg.norm(np.diff(borders, axis=1), axis=0).mean())
    return SlitFlaps(bare, (width, width))


APART = np.deg2rad(0.15)
"""By so much the fold angles differ at which rows lock, if edges of 0.5 m are cut with errors of
0.3 mm (radians): measured, see docs/theory/flat-foldable.md."""


def warn_of_rows(bare: FlatFoldable) -> str:
    """Say how far the last flaps stay open if rows do not lock together.

    Short of the lock by a fold angle d of its row crease a flap is open by 2 sqrt(d/x), x the
    tangent of half that crease's fold angle at the lock.
    """
    open_by = float(np.rad2deg(2 * np.sqrt(APART / np.abs(bare.sheet.net.x).min())))
    return (
        "slit flaps lock every row by itself: if edges are cut with errors of 0.06 % (0.3 mm of "
        f"0.5 m), the last flaps stay up to {open_by:.2g} degrees open when the first are shut; "
        "clamp them shut"
    )


def flap_width(sheet: FlapColumns | SlitFlaps) -> float:
    """The width of the widest flaps."""
    return max(sheet.widths) if isinstance(sheet, FlapColumns) else sheet.widest
