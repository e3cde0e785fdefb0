"""The attribute ``d`` of a path: all commands of SVG are read, anything else is refused."""

from __future__ import annotations

import re
from typing import Final

import numpy as np

from orishell.conventions.errors import CurveError, InputError
from orishell.curves.joining import Chain, require_pieces
from orishell.curves.pieces import MAX_PIECES, SIMPLIFY, Arc, Piece, bezier
from orishell.curves.svg.tree import VALUE
from orishell.numerics.arrays import Array

_COMMAND = re.compile(r"\s*([MmZzLlHhVvCcSsQqTtAa])")
_FLAG = re.compile(r"\s*(?:,\s*)?([01])")

NUMBERS: Final = {
    "M": "x y",
    "L": "x y",
    "H": "x",
    "V": "y",
    "C": "x1 y1 x2 y2 x y",
    "S": "x2 y2 x y",
    "Q": "x1 y1 x y",
    "T": "x y",
    "A": "rx ry turn large sweep x y",
}
"""What each command takes."""
FLAGS: Final = ("large", "sweep")
_TOKEN = re.compile(r"\s*(?:,\s*)?([^\s,]{1,30})")
_DECIMAL_COMMA = re.compile(r"\d,\d")


def parse_path(data: str) -> list[Piece]:
    """The pieces of a path, in user units."""
    return _Pen(data).draw()


def parse_curve(data: str) -> Chain:
    """The one open curve that path data draw, from its first point to its last.

    Pieces of no length are dropped. With y upwards the flag sweep of an arc is 1 where it is run
    through counter-clockwise.

    Parameters
    ----------
    data
        The commands M L H V C S Q T A with their numbers.

    Raises
    ------
    InputError
        Where the text is no path, moves on or closes, with the place.
    CurveError
        If nothing is drawn, or a coordinate is too large.
    """
    pen = _Pen(data, "path", single=True)
    with np.errstate(over="ignore", invalid="ignore"):  # what overflows is refused as too large
        pieces = pen.draw()
    require_pieces(pieces)
    ends = np.array(pen.ends)
    kept = [
        k for k, piece in enumerate(pieces)
        if isinstance(piece, Arc) or np.ptp(piece.control[:, :2], axis=0).any()
    ]  # fmt: skip
    if not kept:
        raise CurveError("the path is a single point", got=repr(data[:40]))
    return Chain(tuple(pieces[k] for k in kept), ends[[0, *(k + 1 for k in kept)]])


def elliptical_arc(
    start: Array, radii: tuple[float, float], angle_deg: float, flags: tuple[bool, bool], end: Array
) -> Piece:
    """The arc of SVG's command A: radii, turn of their axes, and the flags large and sweep.

    Radii that are too small are enlarged as SVG says, and without a radius it is a line.
    """
    rx, ry = abs(radii[0]), abs(radii[1])
    if rx == 0 or ry == 0:
        return bezier([start, end])
    angle = np.deg2rad(angle_deg)
    cos, sin = np.cos(angle), np.sin(angle)
    axes = np.array([[rx * cos, rx * sin], [-ry * sin, ry * cos]])
    # Where the axes are unit vectors the arc is that of a circle with radius 1.
    x, y = 0.5 * (end - start)
    half = np.array([(x * cos + y * sin) / rx, (y * cos - x * sin) / ry])
    reach = float(np.hypot(*half))
    if reach == 0:
        return bezier([start, end])
    if reach > 1:
        axes, half = axes * reach, half / reach
        reach = 1.0
    large, sweep = flags
    rise = np.sqrt((1 - reach) * (1 + reach)) / reach * (1 if large != sweep else -1)
    left = np.array([-half[1], half[0]])
    u = -half - rise * left
    v = np.array([-u[1], u[0]])
    turn = 2 * np.arctan2(reach, np.sqrt((1 - reach) * (1 + reach)))
    turn = 2 * np.pi - turn if large else turn
    centre = 0.5 * (start + end) + rise * left @ axes
    return Arc(centre, np.array([u, v]) @ axes, 0.0, float(turn if sweep else -turn))


class _Pen:
    """Draws a path's commands one after the other."""

    def __init__(self, data: str, name: str = "d", *, single: bool = False) -> None:
        self.data = "" if data.strip() == "none" else data.rstrip()
        self.name = name
        self.single = single
        self.place = self.begun = 0  # where it reads, and where the command it draws begins
        self.pieces: list[Piece] = []
        self.ends: list[Array] = []  # where the pen stood first, and after each piece
        self.here = np.zeros(2)
        self.begin = np.zeros(2)
        # the last control point and the kind of curve that it belongs to, "C" or "Q"
        self.handle: tuple[str, Array] | None = None

    def draw(self) -> list[Piece]:
        first = True
        while self.place < len(self.data):
            found = _COMMAND.match(self.data, self.place)
            if found is None or (first and found[1] not in "Mm"):
                raise self.fault(f"a command, one of {' '.join(NUMBERS)}, the first one M")
            if self.single and found[1] in ("Zz" if first else "ZzMm"):
                self.place = found.end() - 1
                raise self.fault("one open curve, which begins with its only M and has no Z")
            self.begun = found.start(1)
            self.place = found.end()
            self.command(found[1])
            first = False
        return self.pieces

    def command(self, letter: str) -> None:
        kind = letter.upper()
        if kind == "Z":
            self.add(bezier([self.here, self.begin]), self.begin)
            return
        again = False
        while not again or VALUE.match(self.data, self.place):
            numbers = self.numbers(kind)
            if kind == "M":
                self.here = np.array(numbers) + (self.here if letter.islower() else 0.0)
                self.handle = None
                if not again:
                    self.begin = self.here
                self.ends = self.ends or [self.here]
                kind = "L"
                again = True
                continue
            self.line_or_curve(kind, numbers, letter.islower())
            again = True

    def line_or_curve(self, kind: str, numbers: list[float], relative: bool) -> None:
        here = self.here
        base = here if relative else np.zeros(2)
        if kind in "HV":
            end = here.copy()
            axis = "HV".index(kind)
            end[axis] = base[axis] + numbers[0]
            self.add(bezier([here, end]), end)
            return
        if kind == "A":
            end = base + numbers[5:]
            flags = (numbers[3] == 1, numbers[4] == 1)
            arc = elliptical_arc(here, (numbers[0], numbers[1]), numbers[2], flags, end)
            self.add(arc, end)
            return
        points = [base + pair for pair in np.reshape(numbers, (-1, 2))]
        if kind in "ST":
            family = "C" if kind == "S" else "Q"
            mirrored = (
                2 * here - self.handle[1] if self.handle and self.handle[0] == family else here
            )
            points.insert(0, mirrored)
        self.add(bezier([here, *points]), points[-1])
        if kind != "L":
            self.handle = ("C" if kind in "CS" else "Q", points[-2])

    def add(self, piece: Piece, end: Array) -> None:
        if len(self.pieces) >= MAX_PIECES:
            raise InputError(
                "the path has too many pieces", expected=f"at most {MAX_PIECES}", remedy=SIMPLIFY
            )
        self.pieces.append(piece)
        self.ends.append(end)
        self.here = end
        self.handle = None

    def numbers(self, kind: str) -> list[float]:
        values = []
        for name in NUMBERS[kind].split():
            flag = name in FLAGS
            found = (_FLAG if flag else VALUE).match(self.data, self.place)
            if found is None:
                raise self.wrong_number(kind, name, flag=flag)
            values.append(float(found[1]))
            self.place = found.end()
        return values

    def wrong_number(self, kind: str, name: str, *, flag: bool) -> InputError:
        letter = self.data[self.begun]
        token = _TOKEN.match(self.data, self.place)
        place = len(self.data) if token is None else token.start(1)
        comma = _DECIMAL_COMMA.search(self.data, self.begun)
        return InputError(
            f"{f'the flag {name}' if flag else name} of the command {letter} at character "
            f"{self.begun + 1} is {'neither 0 nor 1' if flag else 'no number'}",
            where=f"character {place + 1} of {self.name}",
            got=repr(token[1]) if token else "the end",
            expected=f'numbers as in "{letter} {NUMBERS[kind]}"'
            + (", where large and sweep are 0 or 1" if kind == "A" else ""),
            remedy="a comma separates numbers, so write decimals with a point" if comma else "",
        )

    def fault(self, expected: str) -> InputError:
        rest = self.data[self.place : self.place + 30]
        return InputError(
            "this is no path",
            where=f"character {self.place + 1} of {self.name}",
            got=repr(rest) if rest.strip() else "the end",
            expected=expected,
        )
