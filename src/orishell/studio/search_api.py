"""What the studio's server sends about a search, field by field."""

from __future__ import annotations

from typing import Any, TypedDict


class SearchFigure(TypedDict):
    """A figure that a search can make small, or keep within limits."""

    name: str
    words: str  # its name in words
    unit: str  # its unit, "{unit}" standing for that of lengths; empty where it has none
    of_structure: bool  # whether it is there only where the design has a table [structure]
    most: float | None  # its limit where the table [search] sets none; null if it has none then


class SearchInfo(TypedDict):
    """What a search can be for."""

    figures: list[SearchFigure]
    install: str  # the command that installs what a search needs; empty where that is installed


class SearchedDesign(TypedDict):
    """A design that was made."""

    values: dict[str, Any]  # what keys of the design file have in it, the tables in front of them
    figures: dict[str, float]  # its figures, by name


class FrontMember(TypedDict):
    """A design that no other beats."""

    number: int  # which it is of all designs that were sent, from 0
    costs: str  # what a step to it from the knee gains and costs, in words; empty for the knee


class Objective(TypedDict):
    """A figure that is to be small, and its name with its unit."""

    name: str
    label: str


class SearchState(TypedDict):
    """How far a search has come."""

    objectives: list[Objective]
    baseline: SearchedDesign | None  # the design as it was opened; null if it cannot be made
    designs: list[SearchedDesign]  # those that keep all limits and were not sent before
    front: list[FrontMember]  # those that no other beats, by their first objective
    knee: int  # place of the knee in the front; -1 where nothing is in it
    # designs that were made, or cannot be, and of how many at most
    made: int
    total: int
    # why designs cannot be made or break limits, the commonest reason first, and how many do
    refused: list[tuple[str, int]]


class SearchFound(TypedDict):
    """A line of the answer: how far the search has come."""

    found: SearchState


class SearchAnswer(TypedDict):
    """The last line of the answer: the search has come to its end."""

    result: SearchState
