"""Settings for the files that are written."""

from __future__ import annotations

from dataclasses import dataclass

from orishell.document import FLAT, SHELL
from orishell.workshop import DEFAULT, Workshop


@dataclass(frozen=True, slots=True)
class Settings:
    """The state that is shown and the workshop's settings, for all formats.

    Parameters
    ----------
    state
        The state that formats with one state show, by name or number.
    print_state
        The state in which solids are printed, by name or number.
    workshop
        How the flat sheet is drawn and cut.
    """

    state: int | str = SHELL
    print_state: int | str = FLAT
    workshop: Workshop = DEFAULT


DEFAULT_SETTINGS = Settings()
