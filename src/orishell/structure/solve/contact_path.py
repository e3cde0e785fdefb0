"""Where forces of ties, flaps and rough ground are in balance: by Newton's method, along paths.

Newton's method takes the derivative of P where y is (semismooth: Qi and Sun 1993), and steps as
long as F falls. Without rough ground there is but one solution, as H^-1 A has no eigenvalue below 0
and all rows give a little: the steps are tried at once, and mostly end in a few. Else they begin
where all feet stick: that is the answer if friction does for it, as loads that grow from nothing
find it so. Else, from the convex problem (theta = 0), whose solution is found by less and less
smooth cones as interior points are, it mostly finds Coulomb's (theta = 1) at once. Where not,
Coulomb's is sought by less and less smooth cones itself; then from theta = 0 to 1 by steps; and
where that path of solutions turns back it is followed by its length (Allgower and Georg 1990), in
the sense that keeps the sign of the determinant, also across edges where a foot begins to slip. It
begins at one solution, so it does not end before theta = 1, unless it goes beyond all bounds.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.conventions.record import record
from orishell.numerics.arrays import Array
from orishell.structure.solve.factorised import Factorised
from orishell.structure.solve.friction import Contact, Point

BALANCED = 1e-11
"""Forces that miss less than this share of what loads open are in balance."""
AUGMENTS = 0.1, 0.01, 1.0, 1e-3
"""r: tried in turn, as Newton's steps go astray with one and not with another."""
STEPS, SHORTEST = 100, 1e-6
"""Newton's steps, and the least share of one."""
FEW, SHORT = 15, 1e-2
"""Newton's steps along a path, and the least share of one."""
SHARP = 1e-2, 1e-4
"""Steps below this may turn as the tangent beyond an edge does: tried in turn."""
BEYOND = 1e3
"""A path that goes beyond so many times its start has no end."""
EXACT, ROUNDED = 1e-3, 0.01
"""F is balanced up to what rounds so many times its y; and along a path."""


@record
class Found:
    """Rows in balance."""

    contact: Contact
    y: Array  # (M,)
    # whether there is no end to it: solutions for theta up to less than 1 go beyond all bounds, so
    # that feet slip away, and y is one on the way
    away: bool = False


def find_contact(structure: Factorised, direct: Array) -> Found | None:
    """Rows in balance by Coulomb's law; None if they were not found.

    direct: How loads would move free dofs (n,) on springs alone.
    """
    first = Contact.of(structure, direct)
    if not len(first.rough):
        only, right = solve(first, first.opened, 1.0)
        if right:
            return Found(first, only)
    every = [replace(first, augment=augment) for augment in AUGMENTS]
    found = _from_sticking(every)
    if found is not None:
        return found
    starts = []
    for contact in every:
        y = smoothly(contact, 0.0)
        if y is not None:
            starts.append((contact, y))
            y, right = solve(contact, y, 1.0, FEW)
            if right:
                return Found(contact, y)
    for contact in every:
        y = smoothly(contact, 1.0)
        if y is not None:
            return Found(contact, y)
    return _along_paths(starts)


def _from_sticking(every: list[Contact]) -> Found | None:
    """Rows in balance near the state in which feet are bonded to the ground; or None."""
    for contact in every:
        bonded = smoothly(replace(contact, bonded=True), 0.0)
        if bonded is not None:
            y, right = solve(contact, _sticking(contact, bonded), 1.0, FEW)
            if right:
                return Found(contact, y)
    return None


def _along_paths(starts: list[tuple[Contact, Array]]) -> Found | None:
    """Rows in balance at the end of a path from theta = 0; or where one has no end; or None."""
    for contact, y in starts:
        end = _by_steps(contact, y)
        if end is not None:
            return Found(contact, end)
    last = None
    for contact, y in starts:
        for sharp in SHARP:
            end, away = Path(contact, float(np.linalg.norm(y)) or 1.0).end(y, sharp)
            if end is not None and not away:
                return Found(contact, end)
            last = last or (None if end is None else Found(contact, end, away))
    return last


def _sticking(contact: Contact, bonded: Array) -> Array:
    """The y (M,) of the state that has the y (M,) in which feet are bonded to the ground."""
    rough, mu = contact.rough, contact.friction
    y = bonded.copy()
    y[rough] = np.where(bonded[rough] > 0, mu * bonded[rough], bonded[rough] / mu)
    return y


def smoothly(contact: Contact, theta: float) -> Array | None:
    """The solution (M,) for theta, by less and less smooth cones; None if it is not found."""
    scale = float(np.abs(contact.opened).max())
    y, smooth, less, last = contact.opened, scale, 0.1, None
    for _ in range(60):
        found, right = solve(contact, y, theta, STEPS if last is None else FEW, smooth)
        if right:
            if not smooth:
                return found
            exact, right = solve(contact, found, theta, 5)
            if right:
                return exact
            y, last, less = found, smooth, max(less**1.5, 0.03)
        elif last is None or less > 0.95:
            return None
        else:
            less = less**0.5
        smooth = last * less
        if smooth < 1e-12 * scale:
            smooth = 0.0
    return None


def solve(
    contact: Contact, y: Array, theta: float, steps: int = STEPS, smooth: float = 0.0
) -> tuple[Array, bool]:
    """Newton's steps from y (M,), each as long as it helps; and whether they found balance."""
    opened = float(np.linalg.norm(contact.opened))
    shortest = SHORTEST if steps == STEPS else SHORT
    point = contact.at(y, theta, smooth)
    misses = float(np.linalg.norm(point.missing))
    for _ in range(steps):
        if misses <= _enough(opened, y):
            return y, True
        step, share = _step(point.slope, point.missing), 1.0
        while True:
            tried = contact.at(y + share * step, theta, smooth)
            missed = float(np.linalg.norm(tried.missing))
            if missed < (1 - 1e-4 * share) * misses:
                break
            share /= 2
            if share < shortest:
                return y, False
        y, point, misses = y + share * step, tried, missed
    return y, misses <= _enough(opened, y)


def _enough(opened: float, y: Array, rounded: float = EXACT) -> float:
    """What F may miss, by a norm of what loads open: far out it is rounded as y (M,) is."""
    return BALANCED * max(opened, rounded * float(np.linalg.norm(y)))


def _step(slope: Array, missing: Array) -> Array:
    try:
        return np.asarray(np.linalg.solve(slope, -missing))
    except np.linalg.LinAlgError:
        return np.asarray(-np.linalg.pinv(slope) @ missing)


def _by_steps(contact: Contact, y: Array) -> Array | None:
    """The end of the path from y (M,) where theta is 0; None if it turns back."""
    theta, step = 0.0, 0.5
    for _ in range(60):
        further = min(1.0, theta + step)
        found, right = solve(contact, y, further, FEW)
        if right:
            y, theta, step = found, further, 2 * step
            if theta == 1:
                return y
        else:
            step /= 3
            if step < 1e-4:
                return None
    return None


@record
class Path:
    """Solutions for all theta, followed by the length of (y/scale, theta)."""

    contact: Contact
    scale: float

    def _matrix(self, point: Point) -> Array:
        return np.concatenate([self.scale * point.slope, point.by_dilation[:, None]], axis=1)

    def _at(self, x: Array) -> Point:
        return self.contact.at(self.scale * x[:-1], float(x[-1]))

    def _ahead(self, point: Point, sense: float) -> Array:
        """The unit tangent (M+1,) that has the determinant's sign."""
        matrix = self._matrix(point)
        along = np.linalg.svd(matrix)[2][-1]
        sign = np.linalg.slogdet(np.concatenate([matrix, along[None]]))[0]
        return np.asarray(along if sign * sense > 0 else -along)

    def end(self, y: Array, sharp: float) -> tuple[Array | None, bool]:
        """Where theta is 1 (M,), from where it is 0 (M,), or beyond all bounds, and which.

        sharp: Steps below this may turn as the tangent beyond an edge does.
        """
        x, step = np.append(y / self.scale, 0.0), 0.1
        ahead = self._ahead(self._at(x), 1.0)
        sense = 1.0 if ahead[-1] > 0 else -1.0
        ahead = sense * ahead
        for _ in range(400):
            far = float(np.linalg.norm(x[:-1]))
            if far > BEYOND:
                return self.scale * x[:-1], True
            if ahead[-1] > 0 and x[-1] + step * ahead[-1] >= 1:
                there = x + (1 - x[-1]) / ahead[-1] * ahead
                y, right = solve(self.contact, self.scale * there[:-1], 1.0)
                if right:
                    return y, False
            found = self._corrected(x, ahead, step)
            if found is None and step < sharp:
                beyond = self._at(x + step * ahead)
                found = self._corrected(x, self._ahead(beyond, sense), step)
            if found is None:
                step /= 3
                if step < 1e-9:
                    return None, False
                continue
            x = found
            ahead, step = self._ahead(self._at(x), sense), min(2 * step, 0.3 * max(1.0, far))
        return None, False

    def _corrected(self, x: Array, ahead: Array, step: float) -> Array | None:
        """The solution (M+1,) beside a step ahead; None if it is not near."""
        guess = found = x + step * ahead
        opened = float(np.linalg.norm(self.contact.opened))
        enough = _enough(opened, self.scale * found[:-1], ROUNDED)
        for _ in range(12):
            point = self._at(found)
            if np.linalg.norm(point.missing) <= enough:
                return found if np.linalg.norm(found - guess) < step else None
            matrix = np.concatenate([self._matrix(point), ahead[None]])
            found = found + _step(matrix, np.append(point.missing, ahead @ (found - guess)))
            if not np.linalg.norm(found - guess) < 10 * step:
                return None
        return None
