"""Which one-sided conditions act under a load.

With S^1/2 = W, H = 1 - W C W, gaps h = W g and forces l = W^-1 lambda,

    H h = W g_f - (1 - H) l,

and a condition that gives by c has l >= 0 and o = c S l - h >= 0, one of them with equality. Solved
for l by o, as if all of them acted: l = l_0 + T o, a complementarity problem. Friction keeps the
force l_t in the ground within a polygon about the circle of radius mu l_n,

    mu l_n - d_k l_t >= 0    and    slip along d_k >= 0,    one of them with equality,

d_k square on its sides. What that says of who acts is then taken exactly, circle and all, and
checked.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from orishell.conventions.formatting import in_one_line
from orishell.errors import VerificationError
from orishell.numerics.arrays import Array, Booleans
from orishell.structure.complementarity import solve_complementarity
from orishell.structure.held import FREE, Held

DRIVEN = 1e-6
"""Loads drive a motion if more than this share of them works on it."""
TOLERANCE = 1e-7
"""Forces below this share of all loads are none, and gaps below it of the displacements."""
HUGE = 1e-6
"""Forces of conditions are not huge up to about the loads over this."""
SOFTER = 1e-9, 1e-7, 1e-11
"""By so much T is made stiffer than it is, so that there is a solution where the shell moves: by
the first with which the outcome passes its check."""
NO_GIVE, TRIES = 1e-12, 100
"""Flexibilities below this are none; so many exchanges by condition are tried."""
SIDES = 12
"""Of friction's polygon, whose corners are on the circle."""


@dataclass(frozen=True, slots=True, eq=False)
class Response:
    """What loads do to a structure.

    Parameters
    ----------
    moves
        The motion (n,) that they drive and nothing resists; None if it stands.
    displacements
        Of free freedoms (n,); not numbers where it moves.
    acting
        Which rows of :class:`~orishell.structure.held.Held` act (M,).
    forces
        Their forces (M,).
    motions
        What nothing resists, and the loads do not drive (n, k).
    """

    moves: Array | None
    displacements: Array
    acting: Booleans
    forces: Array
    motions: Array

    __repr__ = in_one_line


def respond(held: Held, loads: Array) -> Response:
    """What loads do to a structure.

    Parameters
    ----------
    loads
        Loads (n,) on its free freedoms.

    Raises
    ------
    VerificationError
        If no set of acting conditions is found: a fault of the program.
    """
    moves = _moving(held, loads)
    if moves is not None:
        still, nothing = np.full(len(loads), np.nan), np.full(len(held.rows), np.nan)
        return Response(moves, still, np.zeros(len(nothing), dtype=bool), nothing, moves[:, None])
    if not len(held.conditions):
        everyone = np.zeros(len(held.rows), dtype=bool), np.zeros((len(held.rows), len(held.rows)))
        found = _exact(held, loads, *everyone)
        assert found is not None
        return found
    for softer in SOFTER:
        if len(held.sliding):
            guess = _who_acts(held, loads, softer)
        else:
            guess = _who_presses(held, loads, softer)
        found = None if guess is None else _exact(held, loads, *guess)
        if found is not None:
            return found
    raise VerificationError(
        "no set of ties, flaps and feet that act was found: this is a fault of the program"
    )


def _moving(held: Held, loads: Array) -> Array | None:
    """The motion (n,) that loads drive whatever the conditions bear; None if there is none.

    Of all that conditions can bear, what comes nearest to balance along the motions that panels and
    hinges allow; what is missing then is along a motion that overruns none of them.
    """
    from scipy.optimize import nnls

    motions = held.motions(np.zeros(len(held.rows), dtype=bool))
    if not motions.shape[1]:
        return None
    count, ways = len(held.conditions), _polygon()
    rough, by_row = held.conditions.rough, held.rows @ motions
    smooth = np.setdiff1d(np.arange(count), rough)
    # A foot's forces: what presses, and friction to a corner of its polygon.
    slides = by_row[count : count + 2 * len(rough)].reshape(-1, 2, motions.shape[1])
    friction = held.conditions.friction[rough][:, None, None]
    cones = by_row[rough][:, None] + friction * np.einsum("wk,gwm->gkm", ways, slides)
    bearing = np.concatenate([by_row[smooth], cones.reshape(-1, motions.shape[1])])
    drive = motions.T @ loads
    # Rounding of the motions lets forces balance what they cannot, if they are huge. Rows are of
    # unit vectors: where no motion moves two ends apart, all that is left of them is rounding.
    bound = HUGE * np.eye(len(bearing))
    aim = np.concatenate([drive, np.zeros(len(bearing))])
    borne = nnls(np.concatenate([bearing.T, bound]), aim)[0] if len(bearing) else np.zeros(0)
    missing = drive - bearing.T @ borne
    if np.linalg.norm(missing) <= DRIVEN * np.linalg.norm(loads):
        return None
    return np.asarray(motions @ missing)


def _who_presses(held: Held, loads: Array, softer: float) -> tuple[Booleans, Array]:
    """Who acts where none rubs: the forces l >= 0 of least energy, a convex problem.

    Loads alone open the gaps W g_f, of which forces take the flexibility A off: l makes
    l^T A l/2 - l^T W g_f least. With the eigenvectors V and values a of W C W, of which springs are
    the rest h = 1 - a, both are those of the springs over h, which is kept from 0 by ``softer``:
    A = V a/h V^T, W g_f = V y/h for V y of the springs. So l is the least-squares solution of
    (a/h)^1/2 V^T l = y/(a h)^1/2 that is not negative.
    """
    from scipy.optimize import nnls

    count, total, root = len(held.conditions), len(held.rows), np.sqrt(held.springs)
    a, v = np.linalg.eigh(root[:, None] * held.flexibility * root)
    a, v = a[a > NO_GIVE], v[:, a > NO_GIVE]
    h = np.maximum(1 - a, 0.0) + softer
    y = v.T @ (root * (held.rows @ held.spring_solve(loads)))
    give = np.diag(np.sqrt(held.conditions.compliance * held.springs[:count]))
    matrix = np.concatenate([np.sqrt(a / h)[:, None] * v[:count].T, give])
    aim = np.concatenate([y / np.sqrt(a * h), np.zeros(count)])
    force = nnls(matrix, aim / (np.abs(aim).max() or 1.0), maxiter=TRIES * count)[0]
    acting = np.zeros(total, dtype=bool)
    acting[:count] = force > TOLERANCE * force.max()
    return acting, np.zeros((total, total))


def _polygon() -> Array:
    """Unit vectors (2, d) to the corners of friction's polygon."""
    turn = 2 * np.pi * (np.arange(SIDES) + 0.5) / SIDES
    return np.stack([np.cos(turn), np.sin(turn)])


def _who_acts(held: Held, loads: Array, softer: float) -> tuple[Booleans, Array] | None:
    """Which rows act (M,), and by what share of what presses on them others slip (M, M)."""
    count, total, sliding = len(held.conditions), len(held.rows), held.sliding
    root = np.sqrt(held.springs)
    own = count + len(sliding)
    give = np.zeros(total)
    give[:count] = held.conditions.compliance * held.springs[:count]
    # Unknown: l of the conditions and of friction, h of the rest.
    stiff = np.eye(total) - root[:, None] * held.flexibility * root
    system = np.eye(total) - stiff + stiff * give
    system[:, own:] = stiff[:, own:]
    known = root * (held.rows @ held.spring_solve(loads))
    solved = np.linalg.pinv(system, rcond=FREE) @ np.column_stack([known, stiff[:, :own]])
    first, by_opening = solved[:own, 0], solved[:own, 1:]
    by_opening[np.diag_indices(own)] += softer * np.abs(by_opening).max()

    corners = _polygon()
    ways = 0.5 * (corners + np.roll(corners, 1, axis=1)) / np.cos(np.pi / SIDES)
    feet = held.conditions.rough
    slides = np.kron(np.eye(len(feet)), ways)  # (2 G, G d)
    # Rows: l_n, or mu l_n - d l_t; columns: o, or slips -o_t.
    rows = np.zeros((count + slides.shape[1], own))
    rows[:count, :count] = np.eye(count)
    friction = held.conditions.friction[feet] * np.cos(np.pi / SIDES)
    rows[count + np.arange(slides.shape[1]), np.repeat(feet, SIDES)] = np.repeat(friction, SIDES)
    rows[count:, count:] = -slides.T
    columns = np.zeros((own, len(rows)))
    columns[:count, :count] = np.eye(count)
    columns[count:, count:] = -slides
    vector = rows @ first
    scale = float(np.abs(vector).max()) or 1.0
    found = solve_complementarity(rows @ by_opening @ columns, vector / scale)
    if found is None:
        return None
    force = first / scale + by_opening @ (columns @ found)
    least = TOLERANCE * np.abs(force).max()
    acting, slip = np.zeros(total, dtype=bool), np.zeros((total, total))
    acting[:count] = force[:count] > least
    slips = np.abs(slides @ found[count:]).reshape(-1, 2).max(axis=1) > 0
    for number, foot in enumerate(feet):
        here = count + 2 * number + np.arange(2)
        if acting[foot] and slips[number]:
            slip[here, foot] = force[here] / force[foot]
        else:
            acting[here] = acting[foot]
    return acting, slip


def _exact(held: Held, loads: Array, acting: Booleans, slip: Array) -> Response | None:
    """The response while some rows act; None where that is not right."""
    count = len(held.conditions)
    one_sided = np.arange(len(held.rows)) < count
    motions = held.motions(acting)
    found, gaps, forces = held.respond(loads, acting, slip)
    found -= motions @ (motions.T @ found)
    least = TOLERANCE * float(np.abs(loads).sum())
    open_ = TOLERANCE * float(np.abs(held.rows @ found).max())
    wrong = one_sided & ((acting & (forces < -least)) | (~acting & (gaps > open_)))
    return None if wrong.any() else Response(None, found, acting, forces, motions)
