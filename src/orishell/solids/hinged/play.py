r"""What hinges that are screwed on beside their places ask of the others: play, in closed form.

Hinges are screwed on in the flat sheet, where boards fit. If the axis of a hinge lies beside its
place by a vector e square to it, then the shift from a panel to the next is wrong by

    abs(R e - e) = 2 abs(e) sin(phi/2)

where it folds by phi: its normals n and e turn by R, and abs(n_p - n_q) = 2 sin(phi/2), too. With
errors that are independent, of a mean square d^2, four hinges leave the loop about a vertex open by

    d sqrt(sum of (n_p - n_q)^2)

root mean square, fold angles being those of the sheet. If all hinges share what is open, shifts of
boards fitting errors best in the mean square, the hinges keep the part P w of errors w that no
shifts explain. P projects on the loops: with one row for each, of +1 and -1 at its four hinges,

    P = C^T (C C^T)^-1 C,

and C C^T is the second difference over R x C points with a fixed border, whose eigenvectors are
sines. Shifts of boards are L^+ B^T w with the second difference L over all boards, which has a free
border, and whose eigenvectors are cosines (G. Strang, SIAM Review 41 (1999) 135). So mean squares
are sums of (n_p - n_q)^2 by weights of every hinge that are products along rows and columns.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from orishell.conventions.record import record
from orishell.motion.grid import Positions
from orishell.motion.mechanism import panel_normals
from orishell.numerics.arrays import Array


@record
class Play:
    """How far boards are from fitting in a state, in errors of their hinges (root mean square)."""

    loop: float  # how far the loop about a vertex is open, where that is most
    hinge: float  # the play that each hinge has where all share in it, on the mean of hinges
    board: float  # how far boards then lie beside their places, on the mean of boards


def find_play(positions: Positions, pieces: Sequence[slice] | None = None) -> Play:
    """The play that errors of hinges of whole boards ask for in a state.

    Parameters
    ----------
    pieces
        Rows of panels of pieces that no hinge joins to others; None if the sheet is one.
    """
    normals = panel_normals(positions)
    found = [_of_piece(normals[rows]) for rows in pieces or [slice(None)]]
    loop, hinge, board, hinges = (np.array(each) for each in zip(*found, strict=True))
    panels = normals[..., 0].size
    return Play(
        loop=float(np.sqrt(loop.max())),
        hinge=float(np.sqrt(hinge.sum() / max(int(hinges.sum()), 1))),
        board=float(np.sqrt(board.sum() / panels)),
    )


def _of_piece(normals: Array) -> tuple[float, float, float, int]:
    """The largest mean square of a loop, the sums of those of hinges and boards, hinges' number.

    normals: Of panels (rows, columns, 3).
    """
    row, column = ((np.diff(normals, axis=axis) ** 2).sum(axis=-1) for axis in (0, 1))
    loops = row[:, :-1] + row[:, 1:] + column[:-1] + column[1:]
    shared, beside = (
        float((row * of_row).sum() + (column * of_column).sum())
        for of_row, of_column in (_loop_weights(*loops.shape), _weights(*loops.shape))
    )
    return float(loops.max(initial=0.0)), shared, beside, row.size + column.size


def _loop_weights(rows: int, columns: int) -> tuple[Array, Array]:
    """Squares of P along a hinge: of row hinges (R, C + 1) and column hinges (R + 1, C)."""
    down, across = _sines(rows), _sines(columns)
    share = 1.0 / (_eigenvalues(rows + 1)[1:, None] + _eigenvalues(columns + 1)[None, 1:])
    # A hinge is in the two loops beside it, the other way round; beyond the border there is none.
    steps_down, steps_across = (
        np.diff(np.pad(each, ((1, 1), (0, 0))), axis=0) for each in (down, across)
    )
    return (
        np.asarray(down**2 @ share @ (steps_across**2).T),
        np.asarray(steps_down**2 @ share @ (across**2).T),
    )


def _weights(rows: int, columns: int) -> tuple[Array, Array]:
    """Squares of the shifts of all boards by a unit error: of row hinges and column hinges."""
    down, across = _cosines(rows + 1), _cosines(columns + 1)
    both = _eigenvalues(rows + 1)[:, None] + _eigenvalues(columns + 1)
    both[0, 0] = np.inf
    return (
        np.asarray(np.diff(down, axis=0) ** 2 @ both**-2.0 @ (across**2).T),
        np.asarray(down**2 @ both**-2.0 @ (np.diff(across, axis=0) ** 2).T),
    )


def _eigenvalues(count: int) -> Array:
    """2 - 2 cos(pi k / count), k = 0 ... count - 1."""
    return 4 * np.sin(0.5 * np.pi * np.arange(count) / count) ** 2


def _sines(count: int) -> Array:
    """Eigenvectors (count, count), as columns, of the second difference with a fixed border."""
    k = np.arange(1, count + 1)
    return np.asarray(np.sqrt(2 / (count + 1)) * np.sin(np.pi * np.outer(k, k) / (count + 1)))


def _cosines(count: int) -> Array:
    """Eigenvectors (count, count), as columns, of the second difference with a free border."""
    waves = np.cos(np.pi * np.outer(np.arange(count) + 0.5, np.arange(count)) / count)
    waves *= np.sqrt(2 / count)
    waves[:, 0] = np.sqrt(1 / count)
    return np.asarray(waves)
