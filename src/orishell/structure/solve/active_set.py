"""Which ties, flaps and feet act under loads, and what moves where nothing holds a shell.

With S^1/2 = W, H = 1 - W C W, gaps h = W g and forces l = W^-1 lambda,

    H h = W g_f - (1 - H) l,

and a condition that gives by c has l >= 0 and c S l - h >= 0, one of them with equality: the forces
of least energy that are not negative. Feet on rough ground stick while they press. What that says
of who acts is then taken exactly, and checked; how much friction feet use is for the caller to see.

Whether the shell moves as a whole is asked before, with friction as it is: forces within a polygon
whose corners are on the circle of radius mu l_n.
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.errors import VerificationError
from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Booleans
from orishell.structure.solve.factorised import GIVE, Factorised

DRIVEN = 1e-6
"""Loads drive a motion if more than this share of them works on it."""
TOLERANCE = 1e-7
"""Forces below this share of all loads are none, and gaps below it of the displacements."""
HUGE = 1e-8
"""Forces of conditions are not huge up to about the loads over this."""
BALANCED = 1e-6
"""Forces that miss this share of the loads at most are in balance."""
SOFTER = 1e-9, 1e-7, 1e-11
"""By so much H is stiffer than it is, so that there is a solution: by the first with which the
outcome passes its check."""
NO_GIVE, EXCHANGES = 1e-12, 100
"""Flexibilities below this are none; so many exchanges by condition are tried."""
SIDES = 12
"""Of friction's polygon, whose corners are on the circle."""


@record
class Response:
    """What loads do to a structure."""

    moves: Array | None  # the motion (n,) that they drive and nothing resists; None if it stands
    displacements: Array  # of free dofs (n,); not numbers where it moves
    active: (
        Booleans  # which rows of :class:`~orishell.structure.solve.factorised.Factorised` act (M,)
    )
    forces: Array  # their forces (M,)
    taken: Array  # what panels and hinges take (D,) of all dofs; not numbers where it moves
    motions: Array  # what nothing resists, and the loads do not drive (n, k)


def respond(structure: Factorised, loads: Array) -> Response:
    """What loads do to a structure.

    loads: Loads (n,) on its free dofs.
    Raises VerificationError: If no set of active conditions is found: a fault of the program.
    """
    moves = _moving(structure, loads)
    if moves is not None:
        count, dofs = structure.every_row.shape
        still, nothing, taken = (np.full(each, np.nan) for each in (len(loads), count, dofs))
        return Response(moves, still, np.zeros(count, dtype=bool), nothing, taken, moves[:, None])
    if not len(structure.conditions):
        return _exact(structure, loads, np.zeros(len(structure.rows), dtype=bool))[0]
    for softer in SOFTER:
        found, right = _exact(structure, loads, _who_presses(structure, loads, softer))
        if right:
            return found
    raise VerificationError(
        "no set of ties, flaps and feet that act was found: this is a fault of the program"
    )


def _moving(structure: Factorised, loads: Array) -> Array | None:
    """The motion (n,) that loads drive whatever the conditions bear; None if there is none.

    Of all that conditions can bear, what comes nearest to balance along the motions that panels and
    hinges allow; what is missing then is along a motion that overruns none of them.
    """
    from scipy.optimize import nnls

    motions = structure.motions(np.zeros(len(structure.rows), dtype=bool))
    if not motions.shape[1]:
        return None
    count, ways = len(structure.conditions), _polygon()
    rough, by_row = structure.conditions.rough, structure.rows @ motions
    smooth = np.setdiff1d(np.arange(count), rough)
    # A foot's forces: what presses, and friction to a corner of its polygon.
    slides = by_row[count : count + 2 * len(rough)].reshape(-1, 2, motions.shape[1])
    friction = structure.conditions.friction[rough][:, None, None]
    cones = by_row[rough][:, None] + friction * np.einsum("wk,gwm->gkm", ways, slides)
    bearing = np.concatenate([by_row[smooth], cones.reshape(-1, motions.shape[1])])
    drive = motions.T @ loads
    # Rounding of the motions lets forces balance what they cannot, if they are huge.
    largest = np.linalg.norm(motions[structure.free < 3 * structure.nodes], axis=1).max()
    bound = HUGE * largest * np.eye(len(bearing))
    aim = np.concatenate([drive, np.zeros(len(bearing))])
    borne = nnls(np.concatenate([bearing.T, bound]), aim)[0] if len(bearing) else np.zeros(0)
    missing = drive - bearing.T @ borne
    if np.linalg.norm(missing) <= DRIVEN * np.linalg.norm(loads):
        return None
    return np.asarray(motions @ missing)


def _who_presses(structure: Factorised, loads: Array, softer: float) -> Booleans:
    """Who acts (M,): by the forces l of least energy.

    Loads alone open the gaps W g_f, of which forces take the flexibility A off: l makes
    l^T A l/2 - l^T W g_f least. With the eigenvectors V and values a of W C W, of which springs are
    the rest h = 1 - a, both are those of the springs over h, which is kept from 0 by ``softer``:
    A = V a/h V^T, W g_f = V y/h for V y of the springs. So l is the least-squares solution of
    (a/h)^1/2 V^T l = y/(a h)^1/2: not negative in the conditions, of either sign in friction, which
    feet that lift have none of.
    """
    from scipy.optimize import nnls

    count, total, root = len(structure.conditions), len(structure.rows), np.sqrt(structure.springs)
    a, v = np.linalg.eigh(root[:, None] * structure.flexibility * root)
    a, v = a[a > NO_GIVE], v[:, a > NO_GIVE]
    h = np.maximum(1 - a, 0.0) + softer
    y = v.T @ (root * (structure.rows @ structure.spring_solve(loads)))
    give = np.full(total, GIVE)
    soft = np.flatnonzero(structure.conditions.compliance)
    give[soft] = structure.conditions.compliance[soft] * structure.springs[soft]
    matrix = np.concatenate([np.sqrt(a / h)[:, None] * v.T, np.diag(np.sqrt(give))])
    aim = np.concatenate([y / np.sqrt(a * h), np.zeros(total)])
    aim /= np.abs(aim).max() or 1.0
    active = np.arange(total) < count + len(structure.sliding)
    while True:
        rubs = np.flatnonzero(active[count:]) + count
        columns = np.concatenate([matrix[:, :count], matrix[:, rubs], -matrix[:, rubs]], axis=1)
        force = nnls(columns, aim, maxiter=EXCHANGES * columns.shape[1])[0]
        active[:count] = force[:count] > TOLERANCE * force.max()
        lifted = ~active[structure.sliding] & active[count : count + len(structure.sliding)]
        if not lifted.any():
            return active
        active[count : count + len(structure.sliding)] &= ~lifted


def _polygon() -> Array:
    """Unit vectors (2, d) to the corners of friction's polygon."""
    turn = 2 * np.pi * (np.arange(SIDES) + 0.5) / SIDES
    return np.stack([np.cos(turn), np.sin(turn)])


def _exact(structure: Factorised, loads: Array, active: Booleans) -> tuple[Response, bool]:
    """The response while some rows act (M,), and whether it is right."""
    count = len(structure.conditions)
    motions = structure.motions(active)
    found, gaps, forces, taken = structure.respond(loads, active)
    found -= motions @ (motions.T @ found)
    unbalanced = np.linalg.norm(motions.T @ loads - (structure.rows @ motions).T @ forces)
    total = float(np.abs(loads).sum())
    least, open_ = TOLERANCE * total, TOLERANCE * float(np.abs(structure.rows @ found).max())
    one_sided = np.arange(len(structure.rows)) < count
    wrong = one_sided & ((active & (forces < -least)) | (~active & (gaps > open_)))
    right = bool(unbalanced <= BALANCED * total and not wrong.any())
    return Response(None, found, active, forces, taken, motions), right


def stands(structure: Factorised, response: Response, size: float) -> bool:
    """Whether no motion is free, and no displacement beyond the shell's size (length)."""
    return response.moves is None and structure.furthest(response.displacements) <= size
