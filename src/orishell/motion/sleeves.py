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

So the sheet carries the two strips (:mod:`~orishell.motion.carried`), with three lines q, w and r.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.motion.carried import Carried, Hanging, Lines
from orishell.motion.mechanism import Mechanism
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
class Sleeve(Carried):
    """A sleeve over a row of a sheet: strips with three lines of vertices, q, w and r."""

    @classmethod
    def over(cls, mechanism: Mechanism, forms: SleeveForms, share: float) -> Sleeve:
        """The sleeve whose hinges lie so far out on edges of columns, at the most."""
        row, above, below = forms.row, share * forms.above, share * forms.below
        none = np.zeros_like(above)

        def lines(up: list[Array], down: list[Array]) -> Lines:
            places = np.full(len(up), row)
            edges = np.stack([places - 1, places])
            return Lines(forms.columns, places, edges, np.array([up, down]))

        return cls(
            sheet=mechanism,
            lines=lines([-above, -above, none], [none, below, below]),
            # Strip q w is parallel to the panels below, strip w r to those above.
            parallel=np.array([row, row - 1]),
            down=np.stack([below, above]),
            widths=forms.widths(share),
            between=np.array([[row - 1, row + 1]] * 2),
            hung=(
                Hanging(Q, 0, row - 1, row - 1, 1 - above),
                Hanging(R, 0, row, row, below),
            ),
            cells=(lines([none, -above, -above, none], [none, none, below, below]),),
        )

    @property
    def row(self) -> int:
        """The row of vertices of the sheet that it is over."""
        return int(self.lines.rows[Q])

    @property
    def above(self) -> Array:
        """Shares a_j (n,) of edges upwards."""
        return np.asarray(-self.lines.shares[0, Q])

    @property
    def share(self) -> float:
        """How far out it hangs on edges of columns, at the most."""
        return float(max(self.above.max(), self.below.max()))

    @property
    def below(self) -> Array:
        """Shares b_j (n,) of edges downwards."""
        return np.asarray(self.lines.shares[1, R])
