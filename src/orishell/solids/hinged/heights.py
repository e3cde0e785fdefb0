r"""Heights of all hinges of whole boards: as near to the boards as the conditions allow.

Valleys fold upwards, so their hinges lie at or above the upper faces of both boards, those of
mountains at or below both undersides; then the boards fold to 180 degrees. Where sin a = sin b at
all vertices, columns going straight on (rows likewise, turned), with s_i the sign of row i and t
the thickness, boards lying in the middle of the sheet,

    h_row(i) = s_i t/2,    h_column(i, j) = (-1)^i (h_j - t S_i),    S_i = sum_{k<i} (-1)^k s_k,

h_j = t/2 + t max S for columns that begin as valleys, -t/2 + t min S for the others. Row hinges lie
on the faces, column hinges stand off them by up to t (max S - min S): R t where rows alternate,
which is the least. Columns that do not fold need no hinge. Elsewhere a linear program finds the
shortest longest arm, and how high boards lie. All of it grows with the thickness alone.

Along joints between pieces nothing folds flat, so row "hinges" there may lie at any height: S goes
on from piece to piece as it likes, and stays within what the widest piece needs.
Axes of hinges with knuckles of radius r stand r off the faces or more if heights are those for
boards of thickness t + 2r, and the boards lie in the middle of these.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise

import numpy as np

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import rounded, rounded_down
from orishell.design import PanelSpec
from orishell.motion import Mechanism, find_assignment
from orishell.motion.grid import CreaseValues
from orishell.motion.hinges import Hinges
from orishell.numerics.arrays import Array, Booleans
from orishell.solids.hinged.conditions import Vertices
from orishell.solids.hinged.joints import (
    Rows,
    find_joints,
    hinges_of,
    joint_rows,
    numbers_of_rows,
)
from orishell.solids.hinged.program import least_arms

STRAIGHT = 1e-9
"""Sectors that differ by less than this make a straight column (radians)."""


def find_hinges(mechanism: Mechanism, build: PanelSpec) -> Hinges:
    """The hinges of whole boards of a sheet, and the joints of its pieces.

    Raises
    ------
    DesignError
        If the sheet does not fold flat, its rows do not part into such pieces, or arms would be
        longer than they may.
    """
    vertices = Vertices.of(mechanism.positions(0.0), find_assignment(mechanism))
    rows = joint_rows(mechanism.grid.rows - 1, build.pieces)
    unit = closed_form(vertices, rows) or least_arms(vertices, rows)
    hinges = _scaled(unit, build.thickness, build.hinge.knuckle, rows)
    if hinges.longest_arm > build.longest_arm:
        raise _too_long(hinges, build)
    return replace(hinges, joints=find_joints(mechanism, hinges, rows)) if rows else hinges


def closed_form(vertices: Vertices, joints: Rows = ()) -> Hinges | None:
    """The hinges of boards of thickness 1 where columns, or rows, are straight; or None.

    ``joints`` are the numbers of rows of creases along which pieces are joined.
    """
    a, b, mode, signs = vertices.a, vertices.b, vertices.row_mode, vertices.signs
    joined = np.isin(np.arange(len(a)), joints)
    if ((mode & (np.abs(a - b) <= STRAIGHT)) | vertices.still).all() and signs.row.all():
        sums = _sums(signs.row[:, 0], joints)
        row, column = _straight_columns(signs.column[0], sums, np.zeros(a.shape[1], np.bool_))
    elif ((~mode & (np.abs(a + b - np.pi) <= STRAIGHT)) | vertices.still).all() and (
        signs.column.all()
    ):
        turned = _straight_columns(signs.row[:, 0], _sums(signs.column[0]), joined)
        column, row = turned[0].T, turned[1].T
    else:
        return None
    levels = np.full((len(column), row.shape[1]), -0.5)
    return hinges_of(signs, CreaseValues(row, column), levels, joints)


def _sums(rows: Array, joints: Rows = ()) -> Array:
    """The sums S (R+1,) by signs of rows (R,), kept where the first piece's are beyond joints."""
    steps = np.concatenate([[0.0], (-1.0) ** np.arange(len(rows)) * rows])
    sums = np.cumsum(steps)
    if not joints:
        return np.asarray(sums)
    cuts = [0, *(row + 1 for row in joints), len(sums)]
    parts = [slice(*each) for each in pairwise(cuts)]
    low = float(sums[parts[0]].min())
    high = low + max(float(np.ptp(sums[part])) for part in parts)
    for part in parts[1:]:
        own = sums[part]
        sums[part.start :] += max(low - own.min(), 0.0) - max(own.max() - high, 0.0)
    return np.asarray(sums)


def _straight_columns(columns: Array, sums: Array, joined: Booleans) -> tuple[Array, Array]:
    """Heights of rows (R, C+1) and columns (R+1, C) by signs of columns (C,) and the sums (R+1,).

    Columns that are joints, not hinges, lie on the other side of the faces, or on them.
    """
    by_turns = (-1.0) ** np.arange(len(sums))
    low, high = sums.min(), sums.max()
    first = np.where(columns > 0, 0.5 + high, low - 0.5)
    first = np.where(joined, np.where(columns > 0, 0.5 + low, high - 0.5), first)
    folds = np.where(columns == 0, 0.0, 1.0)
    rows = 0.5 * by_turns[:-1] * np.diff(sums)
    of_rows = np.repeat(rows[:, None], len(columns) + 1, axis=1)
    return of_rows, by_turns[:, None] * (first - sums[:, None]) * folds


def _scaled(unit: Hinges, thickness: float, knuckle: float, joints: Rows) -> Hinges:
    """Those of boards of a thickness, by those of thickness 1; all axes a knuckle off the faces."""
    wide, signs = thickness + 2 * knuckle, unit.signs
    heights = CreaseValues(wide * unit.heights.row, wide * unit.heights.column)
    row, column = (
        wide * each + np.where(sign == 0, 0.0, knuckle)
        for each, sign in zip(unit.arms, (signs.row, signs.column), strict=True)
    )
    row[:, list(joints)] = 0.0
    levels = wide * unit.levels + knuckle
    return Hinges(signs, heights, levels, thickness, (row, column), knuckle)


THINNER = (0.999, 0.5, 0.1)
"""Shares of the thickness whose arms are as long as they may be that are offered."""


def _too_long(hinges: Hinges, build: PanelSpec) -> DesignError:
    """The refusal of arms that are longer than they may be."""
    needed, most, knuckle = hinges.longest_arm, build.longest_arm, build.hinge.knuckle
    # Arms are as many times the thickness of boards and two knuckles, and a knuckle.
    times = (needed - knuckle) / (build.thickness + 2 * knuckle)
    thinnest = (most - knuckle) / times - 2 * knuckle if times else 0.0
    shares = THINNER if thinnest > 0 else ()
    thinner = [Remedy({"panel.thickness": rounded_down(share * thinnest)}) for share in shares]
    rows = hinges.levels.shape[0]
    fewer = _shorter_pieces(rows, build) if most > 0 else ()
    return DesignError(
        "hinges would stand farther off their boards than arms may be long",
        keys=("panel.largest_arm",),
        size=f"arms of {needed:.4g} are needed, {needed / build.thickness:.4g} times the "
        f"thickness, and may be {most:.4g} long",
        candidates=[
            *fewer,
            Remedy({"panel.largest_arm": rounded(needed * 1.0005)}),
            *thinner,
        ],
        excess=needed / most - 1 if most > 0 else None,
    )


def _shorter_pieces(rows: int, build: PanelSpec) -> Iterator[Remedy]:
    """Pieces of fewer rows of panels, the longest first."""
    now = rows if isinstance(build.pieces, str) else build.pieces
    for most in reversed(numbers_of_rows(rows)):
        if most < now:
            yield Remedy({"panel.pieces": most})
