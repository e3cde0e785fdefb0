"""What is found on a path of folding: the first contact, and how it was looked for."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class ProofRecord:
    """How the path was examined.

    Parameters
    ----------
    states
        Number of states whose positions were computed.
    ranges
        Number of ranges of the drive between two of them.
    tests
        Number of pairs, of panels or of groups of panels, that were tested in a range.
    largest_step, smallest_step
        Widest and narrowest range (radians).
    tolerance
        Distance below which panels touch (length).
    """

    states: int
    ranges: int
    tests: int
    largest_step: float
    smallest_step: float
    tolerance: float


@dataclass(frozen=True, slots=True)
class PathContact:
    """The first contact on a path.

    Parameters
    ----------
    drive
        Where two panels touch (radians).
    clear_until
        Up to here no two panels touch, proved (radians).
    panels
        Numbers of the two panels.
    bodies
        Numbers of the two bodies on them, if these were looked at.
    """

    drive: float
    clear_until: float
    panels: tuple[int, int]
    bodies: tuple[int, int] | None = None


@dataclass(frozen=True, slots=True)
class PathResult:
    """What was found on a path: the first contact, or None, and how.

    Parameters
    ----------
    contact
        The first contact, or None.
    proof
        How the path was examined.
    """

    contact: PathContact | None
    proof: ProofRecord
