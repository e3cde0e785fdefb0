"""A drawing as SVG path data, which :func:`parse_curve` reads: exact where SVG has its pieces."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from orishell.curves.joining import Chain
from orishell.curves.pieces import Arc, Bezier, Piece, bezier
from orishell.curves.piecewise import PieceArrays
from orishell.curves.svg.path_data import elliptical_arc
from orishell.numerics.arrays import Array

DIGITS = 13
"""Decimal places of coordinates relative to the size of the drawing: rounding, and no more."""
CLOSE = 1e-4
"""Error of pieces that SVG does not have, relative to the size of the drawing."""
MOST_HALVINGS = 8
SAMPLES = np.linspace(0, 1, 33)
ANGLE_PLACES = 12
HALF = 1e-9
"""An arc that turns by 180 degrees to within this turns by 180 (radians)."""
LARGEST_ARC = 0.99 * 2 * np.pi
"""Longer arcs are written as two: the ends of a full turn do not say where it goes."""


def curve_data(chain: Chain) -> tuple[str, float]:
    """Path data of a drawing, and how far they are from it: 0 if they are exact.

    Straight lines, Bezier curves of degree 2 and 3, elliptical arcs, and rational Bezier curves
    that are such arcs, stay what they are. All others become Bezier curves of degree 3.

    Parameters
    ----------
    chain
        The drawing, y upwards.
    """
    size = float(np.hypot(*np.ptp(chain.joints, axis=0)))
    size = max([size, *(0.1 * piece.reach for piece in chain.pieces)])
    places = DIGITS - int(np.floor(np.log10(size)))
    joints = chain.joints
    words = ["M" + _numbers(joints[0], places)]
    farthest = 0.0
    for piece, start, end in zip(chain.pieces, joints[:-1], joints[1:], strict=True):
        simple, off = _simplified(piece, CLOSE * size)
        farthest = max(farthest, off)
        ends = [start, *PieceArrays.of(simple).at(1.0)[:-1], end]
        for each, (here, there) in zip(simple, pairwise(ends), strict=True):
            words.append(_command(each, here, there, places))
    return " ".join(words), farthest


def _simplified(piece: Piece, tolerance: float) -> tuple[list[Piece], float]:
    """What a piece is in pieces that SVG has, and how far these are from it."""
    if isinstance(piece, Arc):
        if abs(piece.sweep) <= LARGEST_ARC:
            return [piece], 0.0
        half = 0.5 * piece.sweep
        begins = (piece.start, piece.start + half)
        return [Arc(piece.centre, piece.axes, begin, half) for begin in begins], 0.0
    degree, weight = len(piece.control) - 1, piece.control[:, 2]
    if degree <= 3 and np.ptp(weight) <= 1e-12 * weight.max():
        return [piece], 0.0
    arc = _arc_of(piece) if degree == 2 else None
    if arc is not None:
        return [arc], 0.0
    pieces = list(_cubics(piece, tolerance))
    return [cubic for cubic, _ in pieces], max(off for _, off in pieces)


def _arc_of(conic: Bezier) -> Arc | None:
    """The elliptical arc that a rational Bezier curve of degree 2 is; None if it is none."""
    (p, u), (q, v), (r, w) = ((each[:2] / each[2], each[2]) for each in conic.control)
    # With both ends of weight 1 the middle one is the cosine of half of what the arc turns by.
    cos = v / np.sqrt(u * w)
    if not 0 < cos < 1 - 1e-9:
        return None
    half = np.arccos(cos)
    middle = 0.5 * (p + r)
    across = 0.5 * (r - p) / np.sin(half)
    towards = q - middle
    # On the unit circle the chord lies at cos, and the tangents of its ends meet at 1 / cos.
    out = towards / (1 / cos - cos)
    return Arc(middle - cos * out, np.array([out, across]), -half, 2 * half)


def _cubics(piece: Bezier, tolerance: float) -> Iterator[tuple[Bezier, float]]:
    """Bezier curves of degree 3 with the piece's points and tangents where they meet."""
    arrays = PieceArrays.of([piece])

    def jet(s: Array) -> tuple[Array, Array]:
        position, first, _ = arrays.jet(np.zeros(len(s), np.intp), s)
        return position, first

    todo = [(0.0, 1.0, 0)]
    while todo:
        low, high, halvings = todo.pop()
        points, tangents = jet(np.array([low, high]))
        handles = tangents * (high - low) / 3
        cubic = bezier([points[0], points[0] + handles[0], points[1] - handles[1], points[1]])
        drawn = PieceArrays.of([cubic]).jet(np.zeros(len(SAMPLES), np.intp), SAMPLES)[0]
        # The same share of both: about the distance of the two curves, or more.
        off = float(np.hypot(*(jet(low + (high - low) * SAMPLES)[0] - drawn).T).max())
        if off <= tolerance or halvings == MOST_HALVINGS:
            yield cubic, off
        else:
            middle = 0.5 * (low + high)
            todo += [(middle, high, halvings + 1), (low, middle, halvings + 1)]


def _command(piece: Piece, start: Array, end: Array, places: int) -> str:
    if isinstance(piece, Arc):
        return _arc_command(piece, start, end, places)
    inner = piece.control[1:-1, :2] / piece.control[1:-1, 2:]
    letter = "LQC"[len(inner)]
    return letter + " ".join(_numbers(point, places) for point in (*inner, end))


def _arc_command(arc: Arc, start: Array, end: Array, places: int) -> str:
    _, radii, directions = np.linalg.svd(arc.axes)
    circle = radii[0] - radii[1] <= 1e-12 * radii[0]
    radii = np.full(2, radii.mean()) if circle else radii
    angle = 0.0 if circle else np.rad2deg(np.arctan2(directions[0, 1], directions[0, 0]))
    angle = round(float(angle), ANGLE_PLACES)
    half = abs(abs(arc.sweep) - np.pi) < HALF
    if half:
        # Radii that are rounded up would leave less of a half; too small ones are enlarged.
        ends = _rounded(start, places), _rounded(end, places)
        radii = _rounded(radii, places)
        while _turn(elliptical_arc(ends[0], (*radii,), angle, (False, True), ends[1])) < np.pi:
            radii = _rounded(radii - 10.0**-places, places)
    large = int(not half and abs(arc.sweep) > np.pi)
    onwards = int(arc.sweep * np.linalg.det(arc.axes) > 0)
    turned = _number(angle, ANGLE_PLACES)
    return f"A{_numbers(radii, places)} {turned} {large} {onwards} {_numbers(end, places)}"


def _turn(piece: Piece) -> float:
    return abs(piece.sweep) if isinstance(piece, Arc) else np.pi


def _rounded(values: Array, places: int) -> Array:
    return np.array([round(float(value), places) for value in values])


def _numbers(values: Array, places: int) -> str:
    return " ".join(_number(float(value), places) for value in values)


def _number(value: float, places: int) -> str:
    text = repr(round(value, places) + 0.0)
    return text.removesuffix(".0")
