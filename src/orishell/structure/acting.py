"""Which one-sided conditions act under a load.

With S^1/2 = W, H = 1 - W C W, gaps h = W g and forces l = W^-1 lambda,

    H h = W g_f - (1 - H) l,

and a condition that gives by c has l >= 0 and o = c S l - h >= 0, one of them with equality. Solved
for l by o, as if all of them acted: l = l_0 + T o, a complementarity problem. Friction keeps the
force l_t in the ground within a polygon about the circle of radius mu l_n,

    mu l_n - d_k l_t >= 0    and    slip along d_k >= 0,    one of them with equality,

d_k square on its sides. What that says of who acts, and of friction where feet slip, is then taken
exactly, and checked.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from orishell.conventions.formatting import in_one_line
from orishell.errors import DesignError, VerificationError
from orishell.numerics.arrays import Array, Booleans
from orishell.structure.complementarity import solve_complementarity
from orishell.structure.held import FREE, Held

DRIVEN = 1e-6
"""Loads drive a motion if more than this share of them works on it."""
TOLERANCE = 1e-7
"""Forces below this share of all loads are none, and gaps below it of the displacements."""
HUGE = 1e-8
"""Forces of conditions are not huge up to about the loads over this."""
BALANCED = 1e-6
"""Forces that miss this share of the loads at most are in balance."""
ROUGHER = 1e-3
"""By this share of it friction may be more than it is, once it balances the loads exactly."""
TRIES = (0.0, 1e-5), (0.0, 1e-7), (1e-8, 1e-7)
"""By so much of what springs do, conditions give that do not, for several may hold the same; and by
so much T is stiffer than it is, so that there is a solution where the shell moves. The first with
which the outcome passes its check are taken."""
SOFTER = 1e-9, 1e-7, 1e-11
"""The same of T where nothing rubs."""
NO_GIVE, EXCHANGES = 1e-12, 100
"""Flexibilities below this are none; so many exchanges by condition are tried."""
LOWERINGS, SETTLED = 200, 1e-6
"""So often are feet let down that slip, until slips change by less than this share of all gaps."""
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
    DesignError
        If it is not found how feet slip.
    VerificationError
        If no set of acting conditions is found: a fault of the program.
    """
    moves = _moving(held, loads)
    if moves is not None:
        still, nothing = np.full(len(loads), np.nan), np.full(len(held.rows), np.nan)
        return Response(moves, still, np.zeros(len(nothing), dtype=bool), nothing, moves[:, None])
    for guess in _guesses(held, loads):
        found = None if guess is None else _exact(held, loads, *guess)
        if found is not None:
            return found
    if len(held.sliding):
        raise DesignError(
            "no balance was found between the loads and the friction of feet on the ground",
            keys=("structure.supports",),
        )
    raise VerificationError(
        "no set of ties, flaps and feet that act was found: this is a fault of the program"
    )


def _guesses(held: Held, loads: Array) -> Iterator[tuple[Booleans, Array] | None]:
    """Which rows may act (M,), and friction (M,) in those that slip."""
    if not len(held.conditions):
        yield np.zeros(len(held.rows), dtype=bool), np.zeros(len(held.rows))
        return
    for softer in SOFTER:
        yield _who_presses(held, loads, softer)
    if len(held.sliding):
        for softer in SOFTER:
            yield _who_rubs(held, loads, softer)
    yield from (_who_acts(held, loads, give, stiffer) for give, stiffer in TRIES)


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
    # Rounding of the motions lets forces balance what they cannot, if they are huge.
    largest = np.linalg.norm(motions[held.free < 3 * held.nodes], axis=1).max()
    bound = HUGE * largest * np.eye(len(bearing))
    aim = np.concatenate([drive, np.zeros(len(bearing))])
    borne = nnls(np.concatenate([bearing.T, bound]), aim)[0] if len(bearing) else np.zeros(0)
    missing = drive - bearing.T @ borne
    if np.linalg.norm(missing) <= DRIVEN * np.linalg.norm(loads):
        return None
    return np.asarray(motions @ missing)


def _who_presses(held: Held, loads: Array, softer: float) -> tuple[Booleans, Array]:
    """Who acts (M,) where no foot slips, and no friction (M,): the forces l of least energy.

    Loads alone open the gaps W g_f, of which forces take the flexibility A off: l makes
    l^T A l/2 - l^T W g_f least. With the eigenvectors V and values a of W C W, of which springs are
    the rest h = 1 - a, both are those of the springs over h, which is kept from 0 by ``softer``:
    A = V a/h V^T, W g_f = V y/h for V y of the springs. So l is the least-squares solution of
    (a/h)^1/2 V^T l = y/(a h)^1/2: not negative in the conditions, of either sign in friction, which
    feet that lift have none of.
    """
    from scipy.optimize import nnls

    count, total, root = len(held.conditions), len(held.rows), np.sqrt(held.springs)
    a, v = np.linalg.eigh(root[:, None] * held.flexibility * root)
    a, v = a[a > NO_GIVE], v[:, a > NO_GIVE]
    h = np.maximum(1 - a, 0.0) + softer
    y = v.T @ (root * (held.rows @ held.spring_solve(loads)))
    give = np.diag(np.sqrt(held.conditions.compliance * held.springs[:count]))
    aim = np.concatenate([y / np.sqrt(a * h), np.zeros(count)])
    aim /= np.abs(aim).max() or 1.0
    acting = np.arange(total) < count + len(held.sliding)
    while True:
        rubs = np.flatnonzero(acting[count:]) + count
        by_row = np.sqrt(a / h)[:, None] * v.T
        columns = np.concatenate([by_row[:, :count], by_row[:, rubs], -by_row[:, rubs]], axis=1)
        below = np.concatenate([give, np.zeros((count, 2 * len(rubs)))], axis=1)
        force = nnls(np.concatenate([columns, below]), aim, maxiter=EXCHANGES * columns.shape[1])[0]
        acting[:count] = force[:count] > TOLERANCE * force.max()
        lifted = ~acting[held.sliding] & acting[count : count + len(held.sliding)]
        if not lifted.any():
            return acting, np.zeros(total)
        acting[count : count + len(held.sliding)] &= ~lifted


def _who_rubs(held: Held, loads: Array, softer: float) -> tuple[Booleans, Array] | None:
    """Which rows act (M,), and friction (M,) in those that slip; None if that is not found.

    Forces of a foot are sums of forces along the edges of its cone, n + mu t. Taken as they are,
    slip would lift a foot by mu times as much; so it is let down by that, again and again until
    slips stay as they are.
    """
    from scipy.optimize import nnls

    count, total, root = len(held.conditions), len(held.rows), np.sqrt(held.springs)
    feet, own = held.conditions.rough, count + len(held.sliding)
    a, v = np.linalg.eigh(root[:, None] * held.flexibility * root)
    a, v = a[a > NO_GIVE], v[:, a > NO_GIVE]
    h = np.maximum(1 - a, 0.0) + softer
    y = v.T @ (root * (held.rows @ held.spring_solve(loads)))
    smooth = np.setdiff1d(np.arange(count), feet)
    cones = np.zeros((total, len(feet), SIDES))
    cones[feet, np.arange(len(feet))] = 1.0
    # Springs of friction are those of the feet, so that forces compare.
    ways, mu = _polygon(), held.conditions.friction[feet]
    for axis in range(2):
        rows = count + 2 * np.arange(len(feet)) + axis
        cones[rows, np.arange(len(feet))] = mu[:, None] * ways[axis]
    edges = np.concatenate([np.eye(total)[:, smooth], cones.reshape(total, -1)], axis=1)
    give = np.zeros(total)
    give[:count] = held.conditions.compliance * held.springs[:count]
    matrix = np.concatenate(
        [np.sqrt(a / h)[:, None] * (v.T @ edges), np.sqrt(give)[:, None] * edges]
    )
    aim = y / np.sqrt(a * h)
    scale = float(np.abs(aim).max()) or 1.0
    lowered, slips = np.zeros(total), np.zeros((len(feet), 2))
    for _ in range(LOWERINGS):
        aimed = (aim - np.sqrt(h / a) * (v.T @ lowered)) / scale
        whole = np.concatenate([aimed, np.zeros(total)])
        force = scale * edges @ nnls(matrix, whole, maxiter=EXCHANGES * edges.shape[1])[0]
        opened = v @ ((y - a * (v.T @ force)) / h)
        before, slips = slips, opened[count:own].reshape(-1, 2)
        lowered[feet] = mu * np.linalg.norm(slips, axis=1)
        if np.abs(slips - before).max() <= SETTLED * np.abs(opened).max():
            break
    else:
        return None
    largest = np.abs(force).max()
    acting, friction = np.zeros(total, dtype=bool), np.zeros(total)
    acting[:count] = force[:count] > TOLERANCE * largest
    moving = np.linalg.norm(slips, axis=1) > SETTLED * np.abs(opened).max()
    stands = acting[feet]
    acting[count:own] = (stands & ~moving).repeat(2)
    friction[count:own] = np.where((stands & moving).repeat(2), (root * force)[count:own], 0.0)
    return acting, friction


def _polygon() -> Array:
    """Unit vectors (2, d) to the corners of friction's polygon."""
    turn = 2 * np.pi * (np.arange(SIDES) + 0.5) / SIDES
    return np.stack([np.cos(turn), np.sin(turn)])


def _who_acts(
    held: Held, loads: Array, least_give: float, stiffer: float
) -> tuple[Booleans, Array] | None:
    """Which rows act (M,), and friction (M,) in those that slip."""
    count, total, sliding = len(held.conditions), len(held.rows), held.sliding
    root = np.sqrt(held.springs)
    own = count + len(sliding)
    give = np.zeros(total)
    give[:count] = held.conditions.compliance * held.springs[:count]
    give[:own] = np.maximum(give[:own], least_give)
    # Unknown: l of the conditions and of friction, h of the rest.
    stiff = np.eye(total) - root[:, None] * held.flexibility * root
    system = np.eye(total) - stiff + stiff * give
    system[:, own:] = stiff[:, own:]
    known = root * (held.rows @ held.spring_solve(loads))
    solved = np.linalg.pinv(system, rcond=FREE) @ np.column_stack([known, stiff[:, :own]])
    first, by_opening = solved[:own, 0], solved[:own, 1:]
    by_opening[np.diag_indices(own)] += stiffer

    corners = _polygon()
    ways = 0.5 * (corners + np.roll(corners, 1, axis=1)) / np.cos(np.pi / SIDES)
    feet = held.conditions.rough
    slides = np.kron(np.eye(len(feet)), ways)  # (2 G, G d)
    # Rows: l_n, or mu l_n - d l_t; columns: o, or slips -o_t.
    rows = np.zeros((count + slides.shape[1], own))
    rows[:count, :count] = np.eye(count)
    limit = held.conditions.friction[feet] * np.cos(np.pi / SIDES)
    rows[count + np.arange(slides.shape[1]), np.repeat(feet, SIDES)] = np.repeat(limit, SIDES)
    rows[count:, count:] = -slides.T
    columns = np.zeros((own, len(rows)))
    columns[:count, :count] = np.eye(count)
    columns[count:, count:] = -slides
    vector = rows @ first
    scale = float(np.abs(vector).max(initial=0.0)) or 1.0
    found = solve_complementarity(rows @ by_opening @ columns, vector / scale)
    if found is None:
        return None
    force = first / scale + by_opening @ (columns @ found)
    least = TOLERANCE * np.abs(first).max(initial=0.0) / scale
    acting, friction = np.zeros(total, dtype=bool), np.zeros(total)
    acting[:count] = force[:count] > least
    slips = np.abs(slides @ found[count:]).reshape(-1, 2).max(axis=1) > 0
    stands = acting[sliding]
    acting[count:own] = stands & ~slips.repeat(2)
    friction[count:own] = np.where(
        stands & slips.repeat(2), (root[:own] * force * scale)[count:], 0
    )
    return acting, friction


def _exact(held: Held, loads: Array, acting: Booleans, friction: Array) -> Response | None:
    """The response while some rows act, and friction (M,) in others; None where it is not right."""
    count, slips = len(held.conditions), friction != 0
    motions = held.motions(acting)
    by_row = held.rows @ motions
    # Friction is given but for rounding, and must balance what nothing else does.
    missing = motions.T @ loads - by_row.T @ friction
    friction = friction.copy()
    friction[slips] += np.linalg.lstsq(by_row[slips].T, missing, rcond=FREE)[0]
    found, gaps, forces = held.respond(loads, acting, friction)
    found -= motions @ (motions.T @ found)
    unbalanced = np.linalg.norm(motions.T @ loads - by_row.T @ forces)
    total = float(np.abs(loads).sum())
    least, open_ = TOLERANCE * total, TOLERANCE * float(np.abs(held.rows @ found).max())
    one_sided, sliding = np.arange(len(held.rows)) < count, held.sliding
    rubs = np.linalg.norm(forces[count:][: len(sliding)].reshape(-1, 2), axis=1)
    presses = forces[held.conditions.rough] * held.conditions.friction[held.conditions.rough]
    wrong = one_sided & ((acting & (forces < -least)) | (~acting & (gaps > open_)))
    if unbalanced > BALANCED * total or wrong.any():
        return None
    if (rubs > (1 + ROUGHER) * presses + least).any():
        return None
    return Response(None, found, acting, forces, motions)
