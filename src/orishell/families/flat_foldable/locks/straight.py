"""Sheets with straight borders, beside which a column of flaps folds flat."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.families.flat_foldable.march import Numbers
from orishell.families.flat_foldable.net import Net, Sheet


def straight_bordered(net: Net) -> Sheet:
    """The sheet whose right border is the last column of a net, made straight.

    Of a net of C+1 columns it has C. What is given down the middle column is taken down that last
    column: the lengths; its angles follow from x and y, all of which are larger than that column's
    y. So do the last of the angles along the middle row, and what the net has at its right border
    means nothing. All is analytic, as in :meth:`Net.march`.
    """
    whole = net.with_straight_column(-1).march(-1)
    a, b = whole.a[:, :-1], whole.b[:, :-1]
    rows, columns = whole.rows[:, :-1], whole.columns[:, :-1]
    right = whole.rows[:, -1]
    i, j = len(net.x) // 2, (len(net.y) - 1) // 2
    corners = np.stack(
        [
            net.corners[0],
            _corner(right[0], net.top[-2:], whole.a[0, -1], np.pi - a[0, -1]),
            net.corners[2],
            _corner(right[-1], net.bottom[-2:], np.pi - whole.b[-1, -1], b[-1, -1]),
        ]
    )
    cut = Net(
        x=net.x,
        y=net.y[:-1],
        row_angles=_logs(a[i]),
        column_angles=_logs(a[:, j]),
        row_lengths=rows[i],
        column_lengths=columns[:, j],
        top=net.top[:-1],
        bottom=net.bottom[:-1],
        left=net.left,
        right=right,
        corners=corners,
    )
    return Sheet(cut, a, b, rows, columns, whole.row_signs[:, :-1], whole.column_signs[:, :-1])


def with_parallel_borders(net: Net) -> Net:
    """The net with borders parallel to its first and last column, at the mean distances.

    If these columns are straight, so are the borders.
    """
    sheet = net.march()
    left, right = np.sin(sheet.a[:, 0]), np.sin(sheet.b[:, -1])
    return replace(
        net,
        left=(net.left * left).mean(axis=0) / left,
        right=(net.right * right).mean(axis=0) / right,
        corners=np.ones((4, 2, net.x.shape[1])),
    )


def _corner(along: Numbers, across: Numbers, outer: Numbers, inner: Numbers) -> Numbers:
    """Shares (2, B) of a corner on the border's line, from the nearest inner vertex.

    along: Length (B,) of the border's crease from there, which goes to the border.
    across: Lengths (2, B) from there to the border of the column, and on along the line.
    outer, inner: Angles (B,) of the line and of the column's crease from that crease.
    """
    up = across[1] * np.sin(outer) / (across[0] * np.sin(inner))
    level = 1 + (across[1] * np.cos(outer) - up * across[0] * np.cos(inner)) / along
    return np.stack([level, up])


def _logs(angles: Numbers) -> Numbers:
    return np.asarray(np.log(np.tan(0.5 * angles)))
