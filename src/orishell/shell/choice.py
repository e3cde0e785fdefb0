"""Designs that were tried to meet a tolerance, and the one that was chosen."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from orishell.conventions.record import record


@dataclass(frozen=True, slots=True)
class Measured:
    """Distance of a design from its surface, and its shortest and longest edge (length).

    Parameters
    ----------
    error
        Largest distance from the surface (length).
    shortest, longest
        Shortest and longest edge of a panel in the flat sheet (length).
    """

    error: float
    shortest: float
    longest: float

    def at(self, rows: int, columns: int) -> Trial:
        """That it was measured of a sheet of so many inner vertices."""
        panels = (rows + 1) * (columns - 1)
        return Trial(rows, columns, panels, self.error, self.shortest, self.longest)


@dataclass(frozen=True, slots=True)
class Trial:
    """A design that was tried.

    Parameters
    ----------
    rows, columns
        Inner vertices.
    panels
        Number of panels, flaps left out.
    error
        Distance between shell and target surface, largest both ways (length).
    shortest, longest
        Edges of its panels (length).
    """

    rows: int
    columns: int
    panels: int
    error: float
    shortest: float
    longest: float


@record
class Choice:
    """The design with the fewest panels, and the others that were looked at.

    Parameters
    ----------
    trial
        Its sizes and its error, carefully measured.
    tradeoff
        Of all trials those that no other beats in both error and number of panels, by panels.
    tried
        Number of designs measured.
    """

    trial: Trial
    tradeoff: tuple[Trial, ...]
    tried: int


def unbeaten(trials: Iterable[Trial]) -> tuple[Trial, ...]:
    """Trials that no other beats in both error and number of panels, by panels."""
    kept: list[Trial] = []
    for trial in sorted(trials, key=lambda each: (each.panels, each.error)):
        if not kept or trial.error < kept[-1].error:
            kept.append(trial)
    return tuple(kept)
