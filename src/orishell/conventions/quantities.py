"""Units, and numbers with their units as engineers read them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import ceil, floor, isfinite, log10
from typing import Final, Literal

Unit = Literal["mm", "cm", "m", "in", "ft"]

MILLIMETRES: Final[dict[str, float]] = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4, "ft": 304.8}
"""Length of each unit in millimetres."""
GRAVITY: Final = 9.81
"""Metres per second squared."""
PERSON_KG: Final = 23.0
"""What one person lifts, carries, or is taken to pull with its weight (kg): the load that NIOSH's
lifting equation (1991) allows under the best conditions."""


def conversion(source: str, target: str) -> float:
    """The factor that converts lengths from one unit to another: 1 for the same unit.

    Parameters
    ----------
    source, target
        The units: mm, cm, m, in, ft.
    """
    return 1.0 if source == target else MILLIMETRES[source] / MILLIMETRES[target]


DIGITS = 4
LARGE, SMALL = 1e7, 1e-4
"""Numbers beyond these are written with a power of ten."""
NARROW = "\u202f"
"""The space between thousands, which does not break."""
SPACE = "\N{NO-BREAK SPACE}"
"""The space before a unit, which does not break either."""
RAISED = str.maketrans("-0123456789", "\u207b⁰¹²³⁴⁵⁶⁷⁸⁹")


def plain(value: float, digits: int = DIGITS) -> str:
    """A number in so many significant digits as sentences and terminals have it: 1540, 2.7e8."""
    rounded = float(f"{value:.{digits}g}") + 0.0  # 0 has no sign
    if rounded and isfinite(rounded) and not SMALL <= abs(rounded) < LARGE:
        mantissa, _, power = f"{rounded:.{digits - 1}e}".partition("e")
        return f"{_trimmed(mantissa)}e{int(power)}"
    return _trimmed(f"{rounded:.{digits + 4}f}")


def figure(value: float, digits: int = DIGITS) -> str:
    """A number in so many significant digits as pages have it: thousands apart, 2.7·10⁸."""
    text, _, power = plain(value, digits).partition("e")
    whole, point, part = text.removeprefix("-").partition(".")
    grouped = f"{int(whole):,}".replace(",", NARROW) if len(whole) > 4 else whole
    raised = f"\u00b710{power.translate(RAISED)}" if power else ""
    return ("\u2212" if text.startswith("-") else "") + grouped + point + part + raised


_PAGE_SIGNS: Final = str.maketrans(
    {SPACE: " ", NARROW: "", "\u2212": "-", "\u2013": "-", "\u2019": "'", "\u03bd": "nu"}
    | {chr(raised): chr(digit) for digit, raised in RAISED.items()}
)


def as_typed(text: str) -> str:
    """A text of pages as one types it in a terminal: 2.7e8 and m2 for 2.7·10⁸ and m²."""
    return text.replace("\u00b710", "e").translate(_PAGE_SIGNS)


SMALLER: Final[dict[str, tuple[float, str]]] = {
    "m": (0.1, "mm"),
    "cm": (1.0, "mm"),
    "ft": (0.1, "in"),
}
"""Below so many of the unit a length is written in a smaller one."""
LEAST_MADE: Final[dict[str, float]] = {"mm": 1e-3, "in": 1e-4}
"""Lengths below these are none: nobody makes or measures them."""
ABOVE_MEANT: Final = 1e-12
"""A length that exceeds a round number by less, relative to it, is that number: the rest is error
of arithmetic, and is not rounded up to the next digit."""


def size(value: float, unit: str, *, bound: bool = False, digits: int = 3) -> str:
    """A length in so many significant digits with its unit, as sentences have it: 4.62 m, 0.12 mm.

    bound: Whether it is what nothing exceeds, which is rounded up.
    """
    below, smaller = SMALLER.get(unit, (0.0, unit))
    if value and abs(value) < below:
        value, unit = value * conversion(unit, smaller), smaller
    least = LEAST_MADE.get(unit, 0.0)
    if value and abs(value) < least / 2:
        return f"less than {least} {unit}"
    if bound and value > 0:
        last = 10.0 ** (floor(log10(value)) - digits + 1)
        value = ceil(value / last * (1 - ABOVE_MEANT)) * last
    return f"{plain(value, digits)} {unit}"


def box(sides: Iterable[float], unit: str) -> str:
    """Sides of a box in three significant digits, in the unit of the whole: 6 x 2.4 m."""
    return f"{' x '.join(plain(side, 3) for side in sides)} {unit}"


AREAS: Final = (("m", 1e4), ("cm", 100.0), ("mm", 0.0))
"""Areas from so many square millimetres are written in these units, where the design is metric."""


def area(value: float, unit: str) -> str:
    """An area in three significant digits: 43.5 m2, of a design in millimetres 0.139 m2."""
    if value and unit in dict(AREAS):
        square = value * MILLIMETRES[unit] ** 2
        unit = next(each for each, least in AREAS if square >= least)
        value = square / MILLIMETRES[unit] ** 2
    return f"{plain(value, 3)} {unit}2"


def _trimmed(number: str) -> str:
    """A number without the zeros that end its decimals."""
    return number.rstrip("0").rstrip(".") if "." in number else number


def quantity(value: float, unit: str, digits: int = DIGITS) -> str:
    """A number with its unit."""
    return f"{figure(value, digits)}{SPACE}{unit}"


@dataclass(frozen=True, slots=True)
class Quantities:
    """Quantities of a design in newtons and its unit of length, as texts."""

    unit: str

    def length(self, value: float) -> str:
        """A length in the design's unit."""
        return quantity(value, self.unit)

    def displacement(self, value: float) -> str:
        """A small length: in millimetres, where the design's unit is metric, below a metre."""
        millimetres = value * MILLIMETRES[self.unit]
        if self.unit in ("in", "ft") or abs(millimetres) >= 1000:
            return self.length(value)
        return quantity(millimetres, "mm")

    def pressure(self, value: float) -> str:
        """A load by area."""
        return quantity(value / self._metres**2 / 1e3, "kN/m\u00b2")

    def stress(self, value: float) -> str:
        """A stress, a strength or a modulus."""
        return quantity(value / MILLIMETRES[self.unit] ** 2, "MPa")

    def per_length(self, value: float) -> str:
        """A force by length, as stiffness against strain."""
        return quantity(value / self._metres / 1e3, "kN/m")

    def bending(self, value: float) -> str:
        """A moment by length and curvature."""
        return quantity(value * self._metres, "N m")

    def moment(self, value: float) -> str:
        """A moment by length."""
        return quantity(value, "N m/m")

    @property
    def _metres(self) -> float:
        return conversion(self.unit, "m")


def counted(number: int, one: str, many: str = "") -> str:
    """A number of things; ``many`` is their plural if it has more than an s."""
    return f"{number} {one if number == 1 else many or one + 's'}"
