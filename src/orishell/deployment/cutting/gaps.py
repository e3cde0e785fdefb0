r"""What hinges of rigid panels that are cut with errors are left with.

Panel p moves by a shift t_p and a turn w_p about its centre c_p. At an end x of a hinge its
corner is off by e_p as cut, so that the hinge between panels p and q is open there by

    g = (e_p + t_p + w_p x (x - c_p)) - (e_q + t_q + w_q x (x - c_q)),    g = g_0 + J d,

d being all shifts and turns. Panels go where the sum of squares of g is least:

    g = P g_0,   P = 1 - J A^-1 J^T = N N^T,   A = J^T J + G.

N is the left null space of J; M x N panels have 6 (M - 1)(N - 1) + 1 such directions. The springs
G hold what opens no hinge: the first panel, and the fold angle of one hinge, the drive. They do
not change g. With g_0 = E z, z independent errors of standard deviation s,

    mean of the sum of g^2 over all ends = s^2 tr(P E E^T) = s^2 (tr(E^T E) - tr(A^-1 J^T E E^T J)).

Derived in docs/theory/cutting.md.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from orishell.conventions.record import record
from orishell.deployment.cutting.sheet import CutSheet
from orishell.numerics.arrays import Array
from orishell.numerics.levels import Blocks, Levels

if TYPE_CHECKING:
    from scipy.sparse import csr_array

LOOSE = 1e-12
"""Of the mean diagonal, added to A: what nothing else holds stays where it is."""
TRIED, FREE = 5, 0.3
"""Random loads, and what nothing holds of them at least: a hundredth of what is usual."""
ALONG = 0.5
"""Weight of gaps along hinges that slide. With 0.1 they are 1.7 times as long on a shelter of 144
panels, and those across shorter by a seventh."""
TWIST = 0.1
"""Weight of twists of boards: gaps are then a hundredth of an error from the least."""
REACH = 3
"""Ends at one vertex are of panels at most so many levels apart."""


@record
class Fit:
    """Panels that go where gaps are least, factorised once."""

    sheet: CutSheet
    weighted: csr_array  # J, a row for each weighted gap, twist and spring (R, n)
    weights: csr_array  # from gaps (6 H) to its first rows (6 H, 6 H)
    jacobian: csr_array  # J without weights, of gaps (6 H, n)
    factors: Blocks
    loose: float  # what is added to the diagonal of A

    @classmethod
    def of(cls, sheet: CutSheet, *, sliding: bool = False, twisting: bool = False) -> Fit:
        """Of a sheet whose hinges may slide along their axes, or whose boards may twist."""
        from scipy.sparse import csr_array, eye_array, vstack

        left, right = (
            sheet.by_motions(panels, sheet.ends, 6 + twisting)
            for panels in sheet.panels[sheet.beside].T
        )
        jacobian = left - right
        weights = _sliding(sheet) if sliding else csr_array(eye_array(jacobian.shape[0]))
        springs = _springs(sheet, 6 + twisting)
        weighted = csr_array(vstack([weights @ jacobian, springs]))
        matrix = csr_array(weighted.T @ weighted)
        loose = LOOSE * float(matrix.diagonal().mean())
        held = matrix + loose * eye_array(matrix.shape[0])
        levels = Levels.of(sheet.beside[: len(sheet.hinges)], len(sheet.panels))
        factors = Blocks.of(csr_array(held), levels)
        return cls(sheet, weighted, weights, jacobian, factors, loose)

    def moved(self, opened: Array) -> tuple[Array, Array]:
        """Motions (n, S) of panels by which hinges that errors open (6 H, S) are open least.

        Returns
        -------
        tuple
            Motions, and what is left of the gaps (6 H, S).
        """
        count = self.jacobian.shape[0]
        whole = np.zeros((self.weighted.shape[0], opened.shape[1]))
        whole[:count] = self.weights @ opened
        motions = -self.factors.solve(self.weighted.T @ whole)
        return motions, opened + self.jacobian @ motions

    def mean_square(self, spread: csr_array) -> float:
        """The mean over all ends (2 H) of g^2, of errors E z of standard deviation 1: exact.

        Of sheets that move in one way only: rounding would spoil that of others.

        spread: E (6 H, Z).
        """
        count = self.jacobian.shape[0]
        errors = self.weights @ spread
        taken = self.weighted[:count].T @ errors
        kept = float((errors.multiply(errors)).sum()) - self.factors.trace(taken @ taken.T, REACH)
        return max(kept, 0.0) / (count // 3)

    @property
    def moves_one_way(self) -> bool:
        """Whether panels can move in one way only that opens no hinge to first order.

        In more where creases are unfolded, or a column of panels stands alone. What nothing holds
        is what of random loads the little that holds it is left with.
        """
        loads = np.random.default_rng(0).standard_normal((self.jacobian.shape[1], TRIED))
        return bool(np.linalg.norm(self.loose * self.factors.solve(loads)) < FREE)

    @property
    def folding(self) -> Array:
        """The motion (n,) that opens no hinge, by which the drive's hinge folds by 1 more."""
        drive = self.weighted[[-1]].toarray()[0]
        return np.asarray(self.factors.solve(drive[:, None])[:, 0])

    def twists(self, motions: Array) -> Array:
        """How far corners of every board (P, S) stand up or down, where boards twist (length)."""
        return motions[6::7]


def _sliding(sheet: CutSheet) -> csr_array:
    """What leaves little of gaps (6 H) along the hinges."""
    from scipy.sparse import bsr_array, csr_array

    count = len(sheet.ends)
    along = sheet.axes[:, :, None] * sheet.axes[:, None]
    blocks = np.eye(3) - (1 - ALONG) * along
    size = (3 * count, 3 * count)
    return csr_array(bsr_array((blocks, np.arange(count), np.arange(count + 1)), shape=size))


def _springs(sheet: CutSheet, each: int) -> csr_array:
    """Rows of the springs: of twists, of the first panel, and of the drive last."""
    from scipy.sparse import csr_array, eye_array, vstack

    size = each * len(sheet.panels)
    unit = csr_array(eye_array(size))
    twists = TWIST * unit[6::each] if each > 6 else unit[:0]
    hinge = int(np.searchsorted(sheet.hinges, sheet.drive_edge))
    left, right = each * sheet.beside[hinge] + 3
    row = np.zeros((1, size))
    row[0, left : left + 3], row[0, right : right + 3] = -sheet.axes[hinge], sheet.axes[hinge]
    return csr_array(vstack([twists, unit[:6], csr_array(row)]))
