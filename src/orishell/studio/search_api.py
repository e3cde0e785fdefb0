"""What the studio's server sends about a search, field by field."""

from __future__ import annotations

from typing import Any, TypedDict


class SearchFigure(TypedDict):
    """A figure that a search can make small, or keep within limits.

    Parameters
    ----------
    words
        Its name in words.
    unit
        Its unit, "{unit}" standing for that of lengths; empty where it has none.
    of_structure
        Whether it is there only where the design has a table [structure].
    most
        Its limit where the table [search] sets none; null if it has none then.
    """

    name: str
    words: str
    unit: str
    of_structure: bool
    most: float | None


class SearchInfo(TypedDict):
    """What a search can be for.

    Parameters
    ----------
    install
        The command that installs what a search needs; empty where that is installed.
    """

    figures: list[SearchFigure]
    install: str


class SearchedDesign(TypedDict):
    """A design that was made.

    Parameters
    ----------
    values
        What keys of the design file have in it, the tables in front of them.
    figures
        Its figures, by name.
    """

    values: dict[str, Any]
    figures: dict[str, float]


class FrontMember(TypedDict):
    """A design that no other beats.

    Parameters
    ----------
    number
        Which it is of all designs that were sent, from 0.
    costs
        What a step to it from the knee gains and costs, in words; empty for the knee.
    """

    number: int
    costs: str


class Objective(TypedDict):
    """A figure that is to be small, and its name with its unit."""

    name: str
    label: str


class SearchState(TypedDict):
    """How far a search has come.

    Parameters
    ----------
    begun_with
        The design as it was opened; null if it cannot be made.
    designs
        Those that keep all limits and were not sent before.
    front
        Those that no other beats, by their first objective.
    knee
        Place of the knee in the front; -1 where nothing is in it.
    made, total
        Designs that were made, or cannot be, and of how many at most.
    refused
        Why designs cannot be made or break limits, the commonest reason first, and how many do.
    """

    objectives: list[Objective]
    begun_with: SearchedDesign | None
    designs: list[SearchedDesign]
    front: list[FrontMember]
    knee: int
    made: int
    total: int
    refused: list[tuple[str, int]]


class SearchFound(TypedDict):
    """A line of the answer: how far the search has come."""

    found: SearchState


class SearchResult(TypedDict):
    """The last line of the answer: the search has come to its end."""

    result: SearchState
