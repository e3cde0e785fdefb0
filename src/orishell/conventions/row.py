"""Rows of the verdict, and notes, as terminal, report and pages have them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import field
from typing import Any, Literal, Self

from orishell.conventions.record import record

Sign = Literal["fails", "warns", "holds", "says"]
"""A finding speaks against the shell, wants attention, is proved or computed, or only informs."""
ORDER: tuple[Sign, ...] = ("fails", "warns", "holds", "says")
"""From the worst to what only informs."""
MARKS = {"fails": "x", "warns": "!", "holds": "v", "says": " "}
"""Signs in a terminal."""


def worst(signs: Iterable[Sign]) -> Sign:
    """The worst of some signs; "holds" of none."""
    return min(signs, key=ORDER.index, default="holds")


About = Literal[
    "columns",
    "idle columns",
    "depth",
    "board",
    "roll",
    "unit",
    "stock",
    "reach",
    "sheet",
    "taut",
    "off",
    "no flaps",
    "closes",
    "uneven",
    "opens",
    "chamfers",
    "play",
    "open joints",
    "cut joints",
    "arms",
    "points",
    "patch",
    "pulled",
    "weight",
    "cells",
    "linear",
]
"""What a note is about that a change of the design may mend."""


class Note(str):
    """A sentence that a user should read, and what it is about.

    Parameters
    ----------
    text
        The sentence.
    about
        What a change of the design may mend; None if there is no such change.
    """

    about: About | None

    def __new__(cls, text: str, about: About | None = None) -> Self:
        """Make the sentence."""
        note = super().__new__(cls, text)
        note.about = about
        return note


@record
class Row:
    """A finding."""

    sign: Sign  # what it means for the shell
    subject: str  # what it is about, in a word
    finding: str  # what was found, in a line
    remedy: str = ""  # what mends it, which has been tried; empty if nothing was found that does
    # the same as values of keys of the design file; empty where it is none of these
    changes: Mapping[str, Any] = field(default_factory=dict)
    known: bool = True  # whether anybody looked; if not, the finding says that nobody did
