"""Sleeves: two strips of rigid panels that close a row of a folding sheet to a box girder.

Panels A_j and B_j lie above and below the crease e_j from vertex x_j of a row to the next; u_j and
v_j are the edges of column j from x_j upwards and downwards. For any shares a_0 and b_0 let

    a_j+1 = a_j abs(u_j x e_j)/abs(u_j+1 x e_j),    b_j+1 = b_j abs(v_j x e_j)/abs(v_j+1 x e_j),
    q_j = x_j + a_j u_j,    r_j = x_j + b_j v_j,    w_j = x_j + a_j u_j + b_j v_j.

u_j, u_j+1 and e_j are fixed in A_j, so that q_j+1 - q_j = lambda_j e_j with a constant lambda_j,
and likewise r_j+1 - r_j = mu_j e_j. The quadrilateral q_j w_j w_j+1 q_j+1 has the sides b_j v_j,
b_j+1 v_j+1 and lambda_j e_j, all of them fixed in B_j: it is rigid, and stays parallel to B_j. So
is w_j r_j r_j+1 w_j+1, which stays parallel to A_j. Both are trapezoids whose common side is nu_j
e_j, nu_j = lambda_j + mu_j - 1. Nothing is asked of the sheet but that its panels are rigid.

So the two strips are a folding sheet of their own, with three rows q, w and r: flat where the sheet
is, with fold angles of the sheet, and accelerations that are constant multiples of its.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from orishell.conventions.record import record
from orishell.motion.grid import CreaseValues, Grid
from orishell.motion.mechanism import Mechanism, mechanism_in_one_line
from orishell.numerics.arrays import Array

Q, W, R = range(3)
"""Rows of a sleeve: hinged on panels above, its own crease, hinged on panels below."""


@record
class SleeveForms:
    """What shares and widths of a sleeve's strips are, by the share s that it has of the sheet.

    They are s ``above``, s ``below``, and 1 + s times ``widen``.
    """

    row: int  # of vertices of the sheet
    columns: slice  # of vertices of the sheet, at least 2
    above: Array  # (n,), largest 1
    below: Array  # (n,), largest 1
    widen: Array  # (3, n-1), for lambda, nu and mu: rows q, w and r

    @classmethod
    def of(cls, mechanism: Mechanism, row: int, columns: slice) -> SleeveForms:
        """Those of a sleeve over a row of vertices, between columns of vertices.

        Parameters
        ----------
        row
            An inner row.
        """
        points = mechanism.positions(0.0)[:, columns, :2]
        x = points[row]
        along = np.diff(x, axis=0)
        above, wider = _shares(points[row - 1] - x, along)
        below, wider_below = _shares(points[row + 1] - x, along)
        widen = np.stack([wider, wider + wider_below, wider_below])
        return cls(row, columns, above, below, widen)

    def largest(self, narrowest: float) -> float:
        """The largest share at which no side is narrower than a share of the crease below it."""
        least = float(self.widen.min(initial=0.0))
        return np.inf if least >= 0 else (1 - narrowest) / -least

    def widths(self, share: float) -> Array:
        """Lengths (3, n-1) of the sides along e, by those of e: lambda, nu and mu."""
        return np.asarray(1 + share * self.widen)


def _shares(edges: Array, along: Array) -> tuple[Array, Array]:
    """Shares (n,) of edges (n, 2) that end on parallels to creases (n-1, 2); and their widening.

    The largest share is 1, and the parallel is 1 + widening (n-1,) times as long as the crease.
    """
    before, after = (np.abs(_cross(each, along)) for each in (edges[:-1], edges[1:]))
    # Products of many ratios keep their digits as sums of logarithms.
    shares = np.exp(np.concatenate([[0.0], np.cumsum(np.log(before) - np.log(after))]))
    shares /= shares.max()
    ends = shares[:, None] * edges
    return shares, ((ends[1:] - ends[:-1]) * along).sum(axis=1) / (along**2).sum(axis=1)


def _cross(first: Array, second: Array) -> Array:
    return np.asarray(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])


@record
class Sleeve:
    """A sleeve over a row of a sheet: a folding sheet of three rows, q, w and r, as all are."""

    whole: Mechanism
    row: int  # of vertices of the sheet
    columns: slice  # of vertices of the sheet
    above: Array  # a_j (n,)
    below: Array  # b_j (n,)
    widths: Array  # (3, n-1), lambda, nu and mu: rows q, w and r

    @classmethod
    def over(cls, mechanism: Mechanism, forms: SleeveForms, share: float) -> Sleeve:
        """The sleeve whose hinges lie so far out on edges of columns, at the most."""
        return cls(
            mechanism,
            forms.row,
            forms.columns,
            share * forms.above,
            share * forms.below,
            forms.widths(share),
        )

    def __repr__(self) -> str:
        return mechanism_in_one_line(self)

    @property
    def grid(self) -> Grid:
        """The grid of its vertices."""
        return Grid(3, len(self.above))

    @property
    def inner_columns(self) -> slice:
        """All of them."""
        return slice(0, len(self.above))

    @property
    def flap_columns(self) -> tuple[int, ...]:
        """None."""
        return ()

    def without_flaps(self) -> Mechanism:
        """Itself."""
        return self

    def with_stop(self, stop: float) -> Mechanism:
        """Itself."""
        return self

    @property
    def least_turning(self) -> Mechanism:
        """The sleeve over the sheet that turns as little as possible."""
        return self.on(self.whole.least_turning)

    def on(self, whole: Mechanism) -> Sleeve:
        """The sleeve over a sheet of the same panels, which stands otherwise."""
        return Sleeve(whole, self.row, self.columns, self.above, self.below, self.widths)

    @property
    def target_drive(self) -> float:
        """That of the sheet."""
        return self.whole.target_drive

    @property
    def end_drive(self) -> float:
        """That of the sheet."""
        return self.whole.end_drive

    def positions(self, drive: ArrayLike) -> Array:
        """Positions (..., 3, n, 3) of its vertices."""
        return self.carried(self.whole.positions(drive))

    def carried(self, points: Array) -> Array:
        """Positions (..., 3, n, 3) of its vertices on vertices (..., rows, columns, 3)."""
        near = points[..., self.row - 1 : self.row + 2, self.columns, :]
        x = near[..., 1, :, :]
        up = self.above[:, None] * (near[..., 0, :, :] - x)
        down = self.below[:, None] * (near[..., 2, :, :] - x)
        return np.stack([x + up, x + up + down, x + down], axis=-3)

    def fold_angles(self, drive: ArrayLike) -> CreaseValues:
        """Fold angles of its creases: at w as about x, from the other side; else as its parallels.

        Strip q w is parallel to the panels below, strip w r to those above.
        """
        folds, row, columns = self.whole.fold_angles(drive), self.row, self.columns
        between = slice(columns.start, columns.stop - 2)
        return CreaseValues(
            -folds.row[..., row - 1 : row, columns.start : columns.stop - 1],
            folds.column[..., [row, row - 1], between],
        )

    def edge_accelerations(self, start: Array, stop: Array) -> tuple[Array, Array]:
        """Bounds of the accelerations of its edges: those of the sheet, times what they share."""
        along, down = self.whole.edge_accelerations(start, stop)
        widest = self.widths.max(axis=0)
        shares = [self.below.max(), self.above.max()]
        return (
            along[:, self.columns.start : self.columns.stop - 1] * widest,
            down[:, [self.row, self.row - 1]] * shares,
        )
