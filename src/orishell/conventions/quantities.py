"""Units, and numbers with their units as engineers read them."""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite
from typing import Final, Literal

Unit = Literal["mm", "cm", "m", "in", "ft"]

MILLIMETRES: Final[dict[str, float]] = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4, "ft": 304.8}
"""Length of each unit in millimetres."""
GRAVITY: Final = 9.81
"""Metres per second squared."""


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
