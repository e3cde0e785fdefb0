"""T-hedra told from their vertices alone, however they lie in space (not in the paper).

Edges of rows are level, which says where up is. Then every column, from its middle, is one profile
times one vector of the plan: what is left of the best such product, and all else that a T-hedron
has to be, is what vertices miss the closed form by.

Limit: A state in which an edge of a column is level, or columns lie in one plane, is not known as
T-hedral, as its closed form begins or ends there; other frames of the same file are.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.design import FlapSide
from orishell.families.t_hedral.mechanism import THedral
from orishell.numerics.arrays import Array, Complex, Integers

STRAIGHT = 1e-6
"""Edges of rows that leave one direction by a smaller share say nothing of where up is."""


@record
class KnownTHedron:
    """A T-hedron whose target is the state that was looked at."""

    mechanism: THedral
    numbers: Integers  # numbers (rows, columns) of the vertices as they were given
    miss: float  # how far vertices are from its own, at most (length)

    @property
    def strips(self) -> int:
        """How many strips it is made in."""
        return int(self.numbers.shape[1]) - 1


def recognise_t_hedron(positions: Array, tolerance: float) -> KnownTHedron | None:
    """Find the T-hedron that a grid of vertices is, or None if it is none.

    Parameters
    ----------
    positions
        Vertices (rows, columns, 3) in any state but the ends of the motion. Columns of the T-hedron
        may be rows here.
    tolerance
        How far vertices may be from its own (length).
    """
    numbers = np.arange(positions[..., 0].size).reshape(positions.shape[:2])
    if min(numbers.shape) < 3:
        return None
    places = positions.reshape(-1, 3)
    for each in (numbers, numbers.T):
        found = _with_columns(places, each, tolerance)
        if found is not None and found.miss <= tolerance:
            return found
    return None


def _with_columns(places: Array, numbers: Integers, tolerance: float) -> KnownTHedron | None:
    """The T-hedron that is near to vertices (rows, columns), if one is."""
    local = _upright(places[numbers])
    if local is None or np.ptp(local[..., 2], axis=1).max() > 2 * tolerance:
        return None
    plan = local[..., 0] + 1j * local[..., 1]
    run, axes = _product(plan - plan.mean(axis=0))
    edges = np.diff(plan, axis=1)
    longest = np.take_along_axis(edges, np.abs(edges).argmax(axis=0)[None], axis=0)[0]
    # Segments of rows lie counter-clockwise of the axes, and column 1 goes along its own.
    if (longest * (axes[:-1] + axes[1:]).conj()).imag.sum() < 0:
        run, axes = -run, -axes
    if run[0] > run[-1]:
        numbers, local, run = numbers[::-1], local[::-1], run[::-1]
    middle = (len(run) - 1) // 2
    local = local - [0.0, 0.0, local[middle, :, 2].mean()]
    row = plan.mean(axis=0) + run[middle] * axes
    sheet = _sheet(row, axes, np.diff(run), np.diff(local[..., 2].mean(axis=1)), tolerance)
    if sheet is None:
        return None
    off = sheet.positions(sheet.target_drive) - local
    return KnownTHedron(sheet, numbers, float(np.linalg.norm(off, axis=-1).max()))


def _upright(points: Array) -> Array | None:
    """Vertices (rows, columns, 3) with edges of rows level; None if these say nothing of that."""
    along = np.diff(points, axis=1).reshape(-1, 3)
    _, sizes, axes = np.linalg.svd(along, full_matrices=False)
    if not sizes[1] > STRAIGHT * sizes[0]:
        return None
    axes[2] *= np.sign(np.linalg.det(axes))
    return np.asarray((points - points.mean(axis=(0, 1))) @ axes.T)


def _product(apart: Complex) -> tuple[Array, Complex]:
    """Numbers (R,) and vectors (C,) whose products come nearest to vectors (R, C) of the plan."""
    left, sizes, right = np.linalg.svd(
        np.concatenate([apart.real, apart.imag], axis=1), full_matrices=False
    )
    real, imaginary = np.split(sizes[0] * right[0], 2)
    return left[:, 0], real + 1j * imaginary


def _sheet(
    row: Complex, axes: Complex, runs: Array, rises: Array, tolerance: float
) -> THedral | None:
    """The T-hedron with this row of vertices, if the state is one inside its closed form.

    axes: Of columns (C,), as long as runs (R-1,) of their edges are to be multiplied with.
    """
    sizes, segments = np.abs(axes), np.diff(row)
    if min(runs.min() * sizes.min(), np.abs(rises).min(), np.abs(segments).min()) <= tolerance:
        return None
    units = axes / sizes
    across = np.stack([(segments * units[k : len(row) - 1 + k].conj()).imag for k in (0, 1)])
    # Flaps lie in the plane of the column beside them where they are folded flat.
    left, right = (bool(np.abs(across[:, end]).max() <= tolerance) for end in (0, -1))
    kept = slice(int(left), len(row) - int(right))
    inner = across[:, kept.start : kept.stop - 1]
    if kept.stop - kept.start < 2 or inner.min() <= tolerance:
        return None
    away = [(row[1] - row[0]) * -units[1].conj(), (row[-1] - row[-2]) * units[-2].conj()]
    sides: list[FlapSide] = ["end" if each.real > 0 else "start" for each in away]
    runs = runs * sizes[kept][0]
    return THedral(
        lengths=np.hypot(runs, rises),
        slopes=rises / runs,
        points=row[kept],
        axes=units[kept],
        flaps=(abs(away[0]) if left else 0.0, abs(away[1]) if right else 0.0),
        flap_sides=(sides[0], sides[1]),
    )
