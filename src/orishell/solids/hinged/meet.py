"""Lengths with which whole boards, not the sheet that they lie beside, meet the target.

Shifts of boards depend on the normals of the panels alone. Edges may therefore have other lengths,
as long as no angle changes: heights of hinges, fold angles and shifts stay. Quadrilateral meshes
whose edges are parallel to each other form a linear space (they are Combescure transforms of each
other: H. Pottmann, Y. Liu, J. Wallner, A. Bobenko and W. Wang, ACM Transactions on Graphics 26
(2007) 65). So corners of boards are affine in the lengths of a row and of a column, and the nearest
to those of the sheet at the target follow from one system of linear equations.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.motion import Mechanism
from orishell.motion.hinges import FreeLengths, Hinges, Straightened
from orishell.motion.mechanism import panel_normals
from orishell.motion.quads import dots, grid_corners
from orishell.numerics.arrays import Array, Integers

ACROSS = 100.0
"""A distance square to a panel counts like one so many times as long in its plane: it shows in the
shape of the shell, the other along the edges of boards only. Boards of sweeps, whose planes can be
those of the panels, leave these by less than a thousandth of a millimetre then in the shelter."""
STEP = 2.0**-10
"""Share by which lengths are changed to see what moves: so little that no edge turns round."""
SAME = 1e-9
"""Heights of feet that follow from others of them to this share are not asked for again."""
SHRUNK = 0.5
"""No edge becomes shorter than this share of it: boards that ask for more are left as near as that
brings them."""


def meet_target(
    mechanism: Mechanism,
    hinges: Hinges,
    meant: Array | None = None,
    feet: Integers | None = None,
) -> tuple[Mechanism, Hinges]:
    """The sheet whose whole boards come nearest to panels at its target, with its hinges.

    These place the boards. It is the sheet itself where no lengths are free.

    Parameters
    ----------
    meant
        Vertices (rows, columns, 3) of the panels; those of the sheet itself if None.
    feet
        Rows and columns (K, 2) of vertices at which boards are to stand as high as the panels
        would, by their lowest corners.
    """
    if not isinstance(mechanism, FreeLengths):
        return mechanism, hinges
    free = mechanism.free_lengths()
    lengths = np.concatenate(list(free.values()))
    cuts = np.cumsum([len(each) for each in free.values()])[:-1]

    def with_lengths(lengths: Array) -> Mechanism:
        return mechanism.with_lengths(dict(zip(free, np.split(lengths, cuts), strict=True)))

    shell = mechanism.positions(mechanism.target_drive)
    moves = np.empty((len(lengths) + 3, *shell.shape))
    for k, length in enumerate(lengths):
        longer = lengths.copy()
        longer[k] += STEP * length
        other = with_lengths(longer)
        moves[k] = (other.positions(other.target_drive) - shell) / STEP
    moves[len(lengths) :] = np.eye(3)[:, None, None]
    meant = shell if meant is None else meant
    off = hinges.boards(shell) - grid_corners(meant)
    row, column = np.zeros((2, 0), np.int64) if feet is None else feet.T
    sunk = (hinges.lowest(shell) - meant[..., 2])[row, column]
    change = _least(*_squares(moves, off, panel_normals(shell)), moves[:, row, column, 2].T, -sunk)
    change *= _share(np.einsum("k,kijx->ijx", change, moves), shell)
    fitted = with_lengths(lengths * (1 + change[:-3]))
    if isinstance(fitted, Straightened):
        fitted = fitted.straightened()
    return fitted, replace(hinges, place=hinges.place + change[-3:])


def _squares(moves: Array, off: Array, normals: Array) -> tuple[Array, Array]:
    """Normal equations (K, K) and (K,) for corners of panels to come back from ``off``.

    By moves (K, rows, columns, 3), row of panels by row of panels; off (rows-1, columns-1, 4, 3).
    """
    count = len(moves)
    squares, products = np.zeros((count, count)), np.zeros(count)
    for row, (gap, normal) in enumerate(zip(off, normals[:, :, None], strict=True)):
        corners = grid_corners(moves[:, row : row + 2])[:, 0]
        matrix = _weighed(corners, normal).reshape(count, -1)
        squares += matrix @ matrix.T
        products += matrix @ _weighed(gap, normal).ravel()
    return squares, products


def _least(squares: Array, products: Array, kept: Array, values: Array) -> Array:
    """The least of squares (K,) with ``kept`` (F, K) of it equal to values (F,), or nearly."""
    _, sizes, ways = np.linalg.svd(kept, full_matrices=True)
    rank = int((sizes > SAME * sizes.max(initial=0.0)).sum())
    free = ways[rank:].T
    found = np.linalg.lstsq(kept, values, rcond=SAME)[0]
    rest = free.T @ (products + squares @ found)
    return np.asarray(found + free @ np.linalg.solve(free.T @ squares @ free, -rest))


def _weighed(vectors: Array, normals: Array) -> Array:
    """Vectors (..., 3), what of them is along normals (..., 3) made longer."""
    return np.asarray(vectors + (ACROSS - 1) * dots(vectors, normals)[..., None] * normals)


def _share(move: Array, shell: Array) -> float:
    """How much of a move (rows, columns, 3) of a shell's vertices leaves its edges long enough."""
    shrinks = [
        -dots(np.diff(move, axis=axis), edges) / dots(edges, edges)
        for axis, edges in enumerate((np.diff(shell, axis=0), np.diff(shell, axis=1)))
    ]
    worst = max(float(each.max()) for each in shrinks)
    return min(1.0, SHRUNK / worst) if worst > 0 else 1.0
