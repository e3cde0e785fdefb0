"""A row of the verdict, as terminal, report and pages have it."""

from __future__ import annotations

from typing import Literal

from orishell.conventions.record import record

Sign = Literal["fails", "warns", "holds", "says"]
"""A finding speaks against the shell, wants attention, is proved or computed, or only informs."""


@record
class Row:
    """A finding."""

    sign: Sign  # what it means for the shell
    subject: str  # what it is about, in a word
    finding: str  # what was found, in a line
