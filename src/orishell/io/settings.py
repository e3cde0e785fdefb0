"""Settings for the files that are written."""

from __future__ import annotations

from dataclasses import dataclass

from orishell.workshop import DEFAULT, Workshop

LAST = -1
"""Number of the last state: the locked shell."""


@dataclass(frozen=True, slots=True)
class Settings:
    """The state that is shown and the workshop's settings, for all formats.

    Parameters
    ----------
    state
        Number of the state that formats with one state show: 0 flat, -1 the last.
    workshop
        How the flat sheet is drawn and cut.
    """

    state: int = LAST
    workshop: Workshop = DEFAULT


DEFAULT_SETTINGS = Settings()
